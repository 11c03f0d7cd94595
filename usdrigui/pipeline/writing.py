"""write_layer(): the layer of laid out characters, over their asset or over a layout that stands."""

from __future__ import annotations

import functools
import os
from pathlib import Path

from usdrigui.errors import refuse
from usdrigui.examples import Examples
from usdrigui.layout import additions as additions_stage
from usdrigui.pipeline.targets import make_folder
from usdrigui.report import CharacterReport, Outcome
from usdrigui.settings import Settings
from usdrigui.usd.reader_process import LayoutsResult, ReadResult
from usdrigui.usd.source import check_unchanged


def write_layer(
    asset: Path, target: Path, settings: Settings, source: ReadResult, laid: list[CharacterReport], examples: Examples
) -> Outcome:
    """Write the layer, unless a file that it was made from has changed meanwhile.

    Raises RigUIError; then nothing has been written.
    """
    from usdrigui.usd import layer

    make_folder(target)
    if examples.base is not None:
        return _written_over(examples.base, asset, target, settings, source, laid)
    pairs = [(character.rig, character.layout) for character in laid]
    unchanged = functools.partial(check_unchanged, source.sources)
    return layer.write_layout(pairs, asset, target, settings.output, source.metadata, guard=unchanged)


def _written_over(
    base: LayoutsResult, shot: Path, target: Path, settings: Settings, source: ReadResult, laid: list[CharacterReport]
) -> Outcome:
    """Write what a shot adds to a layout that stands."""
    from usdrigui.usd.additions import Addition, write_additions

    layer = Path(base.sources[0].path)
    if os.path.realpath(target) == base.sources[0].path:
        raise refuse("FILE_TARGET", str(target), "is the layout that is to stay as it is")
    composed = any(each.path == base.sources[0].path for each in source.sources)
    additions = []
    for character in laid:
        root = additions_stage.root_in_base(base.layouts, character.rig)
        if root != character.root and not composed and base.source and not settings.output.bare:
            raise refuse("BASE_APART", character.root, f"stands at {root} in {layer.name}")
        prims = tuple(prim for prim in base.prims if prim.root == root)
        additions.append(Addition(character.rig, character.layout, character.added, root, prims))
    return write_additions(
        additions,
        shot,
        layer,
        target,
        source.metadata,
        composed=composed,
        bare=settings.output.bare,
        guard=functools.partial(check_unchanged, (*source.sources, *base.sources)),
    )
