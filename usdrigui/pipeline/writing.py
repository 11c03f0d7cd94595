"""stage_layer(): the layer of laid out characters, over their asset or over an existing layout."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from usdrigui.character import Rig
from usdrigui.errors import refuse
from usdrigui.isolation.foreign_file import SourceFile
from usdrigui.layout.reuse.existing_layout import root_in_base
from usdrigui.reader.reader_records import LayoutsResult, ReadResult
from usdrigui.replacing.transaction import Transaction, same_file
from usdrigui.report.run_report import CharacterReport, Outcome


def stage_layer(
    files: Transaction,
    asset: Path,
    target: Path,
    source: ReadResult,
    laid: Sequence[tuple[LayoutsResult | None, CharacterReport]],
    *,
    bare: bool,
) -> Outcome:
    """Stage the layer among the files of the run; each character comes with the layout that it adds
    to, if any.

    Raises RigUIError.
    """
    from usdrigui.layer import write_layout as layer

    over = [(base, character) for base, character in laid if base is not None]
    if over:
        return _staged_over(files, over, asset, target, source, bare=bare)
    pairs = [(character.rig, character.layout) for _, character in laid]
    return layer.write_layout(pairs, asset, target, source.metadata, bare=bare, write=files.stage)


def _staged_over(
    files: Transaction,
    laid: Sequence[tuple[LayoutsResult, CharacterReport]],
    shot: Path,
    target: Path,
    source: ReadResult,
    *,
    bare: bool,
) -> Outcome:
    """Stage what a shot adds to an existing layout."""
    from usdrigui.layer.shot_layout import ShotLayout, write_shot_layouts

    layer = Path(laid[0][0].sources[0].path)
    composed = _composes(source.sources, layer)
    shots = []
    for base, character in laid:
        root = root_in_base(base.layouts, character.rig)
        prims = tuple(prim for prim in base.prims if prim.root == root)
        shots.append(ShotLayout(character.rig, character.layout, character.added, root, prims))
    return write_shot_layouts(
        shots,
        shot,
        layer,
        target,
        source.metadata,
        composed=composed,
        bare=bare,
        write=files.stage,
    )


def check_base(
    base: LayoutsResult, source: ReadResult, rigs: Sequence[Rig], target: Path, *, bare: bool
) -> None:
    """Refuse a base that the layer could not be laid over, before the characters are laid out.

    `rigs` are those that have a layout in it.  Raises FILE_TARGET for the base itself and
    BASE_APART.
    """
    layer = Path(base.sources[0].path)
    if same_file(target, layer):
        raise refuse("FILE_TARGET", target, "is the layout given as --base, which is never written")
    composed = _composes(source.sources, layer)
    for rig in rigs:
        own, root = rig.path, root_in_base(base.layouts, rig)
        if root != own and not composed and base.source and not bare:
            raise refuse("BASE_APART", own, f"is {root} in {layer.name}")
        if composed and own not in source.composed_from:
            message = f"does not compose the layout of {layer.name} with the variants selected"
            raise refuse("BASE_APART", own, message)


def _composes(sources: Sequence[SourceFile], layer: Path) -> bool:
    """Whether the shot brings the layer in."""
    return any(Path(each.path) == layer for each in sources)
