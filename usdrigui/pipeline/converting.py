"""convert(): a layout layer of an earlier format as process would write it today, with the
decisions that it holds."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from usdrigui.errors import refuse
from usdrigui.model import Layout, Rig
from usdrigui.pipeline.targets import check_replaceable, check_target, make_folder
from usdrigui.pipeline.variants import selecting
from usdrigui.settings import OutputSettings, Settings
from usdrigui.usd.reader_process import (
    read_layer_isolated,
    read_layouts_isolated,
    read_rigs_isolated,
)
from usdrigui.usd.reader_records import LayoutsResult, Opening, ReadResult
from usdrigui.usd.safe_write import State, Transaction


def convert(layer: Path, target: Path, settings: Settings) -> State:
    """Write the layouts of a layer, whatever its format, to `target`, which may be the layer
    itself.

    Raises RigUIError: SOURCE_MISSING, LAYOUT_STALE (the source is another character now),
    CONVERT_COMPOSED (another layer brings the layout in, or a part of it), FILE_TARGET and all that
    reading and writing can raise.
    """
    opening = Opening.of(settings.rig.read)
    own = read_layer_isolated(layer, opening)
    chosen = [selecting(settings, each) for each in own.variants] or [settings]
    layouts = [read_layouts_isolated(layer, Opening.of(each.rig.read)) for each in chosen]
    origins = [path for each in layouts for path in each.composed_from.values()]
    if origins or not own.ours:
        raise refuse(
            "CONVERT_COMPOSED",
            str(layer),
            f"has its layout from {next(iter(origins), 'another layer')}",
        )
    if not layouts[0].source:
        raise refuse("SOURCE_MISSING", str(layer), "does not sublayer any asset")
    source = Path(layouts[0].source)
    reads = [read_rigs_isolated(source, each) for each in chosen]
    laid = {pair[1].character.path_in_variants: pair for pair in _pairs(layouts, reads, source)}
    check_target(source, target)
    check_replaceable(target, opening)
    from usdrigui.usd.layer import write_layout

    make_folder(target)
    with Transaction([file.path for each in reads for file in each.sources]) as files:
        output = OutputSettings(bare=not own.sublayers)
        state = write_layout(
            list(laid.values()), source, target, output, reads[0].metadata, write=files.stage
        )
        files.commit()
    return state


def _pairs(
    layouts: Sequence[LayoutsResult], reads: Sequence[ReadResult], source: Path
) -> Iterator[tuple[Rig, Layout]]:
    """Every layout with its character, in each of the variants."""
    for found, read in zip(layouts, reads, strict=True):
        rigs = {rig.skel_root.path: rig for rig in read.rigs}
        yield from ((_rig_of(rigs, layout, source), layout) for layout in found.layouts)


def _rig_of(rigs: dict[str, Rig], layout: Layout, source: Path) -> Rig:
    """The character of a layout, if it still has the controls that the layout knows; raises
    LAYOUT_STALE."""
    root = layout.character.root
    rig = rigs.get(root)
    if rig is None:
        raise refuse("LAYOUT_STALE", root, f"{source} no longer has this character")
    unknown = sorted(layout.controls - {control.name for control in rig.controls})
    if unknown or len(layout.character.base_values) != len(rig.controls):
        what = (
            f"it has no control {unknown[0]!r}"
            if unknown
            else f"it has {len(rig.controls)} controls"
        )
        raise refuse("LAYOUT_STALE", root, f"{what}, as {source} and its configuration are")
    return rig
