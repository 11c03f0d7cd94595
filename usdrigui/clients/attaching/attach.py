"""The one place that edits an asset, and only when asked to: the layout among the asset's own
sublayers, or referenced in a variant of its own.

`attach` puts a bare layout layer first among the sublayers of the asset's root layer, or makes it a
reference (`usdrigui.clients.attaching.layout_reference`); `detach` takes it out again. Both write
through `usdrigui.replacing.exchange`, after the edited file has been read back in a process of its
own. A text layer is edited at its
list of sublayers, so that comments and layout of the text stay; the layer is exported instead where
the edited text does not mean exactly what the edited layer means, and for a reference.
"""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

from pxr import Sdf

from usdrigui.character import Rig
from usdrigui.clients.attaching import layer_text, layout_reference
from usdrigui.errors import Issue, RigUIError, issue, listed, refuse
from usdrigui.isolation.foreign_file import SourceFile, check_source
from usdrigui.layer.write_layout import layer_bytes, relative_asset_path
from usdrigui.model import Layout
from usdrigui.pipeline.variants import selecting
from usdrigui.reader.reader_process import (
    read_layer_isolated,
    read_layouts_isolated,
    read_rigs_isolated,
)
from usdrigui.replacing.exchange import Original, editing, replace_source
from usdrigui.replacing.transaction import commit, same_file
from usdrigui.settings import ReadSettings, Settings
from usdrigui.stages import schema
from usdrigui.stages.opening import open_layer
from usdrigui.stages.variant_paths import asset_selections

Outcome = Literal["written", "unchanged"]


def attach(
    asset: Path,
    layer: Path,
    settings: Settings,
    tell: Callable[[Issue], None] | None = None,
    *,
    in_variant: bool = False,
) -> Outcome:
    """Make the bare layout `layer` the strongest sublayer of the root layer of `asset`; or,
    `in_variant`, a reference that is opened where the variant ``rigUI = ui`` of the SkelRoot is
    selected, which the asset itself does not.

    `tell` is called with ATTACH_CONTROLS_GONE for a character that lacks controls of its layout.

    Raises RigUIError: ATTACH_PACKAGE (a usdz), ATTACH_LINK (a symbolic link), ATTACH_NOT_BARE,
    ATTACH_CYCLE, ATTACH_MISMATCH (of another character), ATTACH_OUTSIDE (a reference cannot bring
    it), LAYOUT_MISSING, SOURCE_HAS_LAYOUT, and all that reading and
    `usdrigui.replacing.exchange` can raise.  Then nothing has been written.  A layout in a
    variant is attached whichever the asset selects.
    """
    _check_editable(asset, settings.read.size_limit)
    with editing(asset, settings.read.time_limit):
        return _attached(asset, layer, settings, tell or (lambda _: None), in_variant)


def detach(asset: Path, layer: Path, settings: Settings) -> Outcome:
    """Take `layer`, which need not exist any more, out of the sublayers and references of the root
    layer of `asset`.

    The other sublayers and their offsets stay as they are.  Raises ATTACH_PACKAGE, ATTACH_LINK and
    what reading and `usdrigui.replacing.exchange` can raise.
    """
    _check_editable(asset, settings.read.size_limit)
    with editing(asset, settings.read.time_limit):
        return _detached(asset, layer, settings)


def write_bare(layer: Path, target: Path) -> Outcome:
    """Write a copy of a layout layer that has no sublayers, as `usdrigui process --bare` would have
    written it.

    Raises FILE_TARGET for the layer itself, which keeps its sublayers, FILE_NOT_USD, and the FILE_
    codes of writing.
    """
    if same_file(layer, target):
        raise refuse("FILE_TARGET", target, "is the layer itself, of which a copy was wanted")
    copy = open_layer(layer)
    copy.pseudoRoot.ClearInfo("subLayers")
    copy.pseudoRoot.ClearInfo("subLayerOffsets")
    return commit(layer_bytes(copy, target.suffix, str(target)), target, read=[layer])


def _attached(
    asset: Path, layer: Path, settings: Settings, tell: Callable[[Issue], None], in_variant: bool
) -> Outcome:
    before = check_source(asset, settings.read.size_limit)
    layouts = read_layouts_isolated(layer, settings.read).layouts
    # The variants that hold the layout: the asset may select others.
    chosen = {**asset_selections(layouts[0].variant_path), **settings.read.variants}
    settings = selecting(settings, chosen)
    read = read_rigs_isolated(asset, settings)
    _check_of(asset, layouts, read.rigs)
    opening = settings.read
    _check_bare(asset, layer, opening)
    for found in _controls_gone(layouts, read.rigs):
        tell(found)
    source = open_layer(asset)
    if any(_entries(asset, source, layer)):
        return "unchanged"
    roots = [layout.root for layout in layouts]
    for root in roots:
        inside = read.layout_inside(root)
        if inside:
            raise refuse("SOURCE_HAS_LAYOUT", root, f"{asset} {inside}")
    entry = relative_asset_path(layer, asset)
    of_text: Callable[[str], str] | None = None
    if in_variant:
        opened = open_layer(layer)
        for layout in layouts:
            layout_reference.check_reachable(layer, opened, layout.variant_path, layout.root)
        wanted = [layout_reference.ReferenceOf(root, entry) for root in dict.fromkeys(roots)]
        layout_reference.add(source, wanted)
        opening = replace(opening, variants={**opening.variants, schema.VARIANTS: schema.WITH})
    else:
        _edit(source, entry, ())
        of_text = functools.partial(layer_text.with_sublayer, path=entry)
    verify = functools.partial(_holds_layouts, roots, opening)
    return _replaced(asset, source, before, verify, of_text)


def _check_of(asset: Path, layouts: Sequence[Layout], rigs: Sequence[Rig]) -> None:
    """Refuse the layout of another character: one at a path that the asset does not have, or
    without any control that it has."""
    by_root = {rig.path: rig for rig in rigs}
    for layout in layouts:
        root = layout.root
        if root not in by_root:
            raise refuse("ATTACH_MISMATCH", root, f"{asset} has no character at this path")
        if layout.controls and layout.controls.isdisjoint(by_root[root].control_names):
            raise refuse(
                "ATTACH_MISMATCH", root, f"shares no control with the character of {asset}"
            )


def _controls_gone(layouts: Sequence[Layout], rigs: Sequence[Rig]) -> Iterator[Issue]:
    known = {rig.path: rig.control_names for rig in rigs}
    for layout in layouts:
        root = layout.root
        unknown = sorted(layout.controls.difference(known[root]))
        if unknown:
            yield issue("ATTACH_CONTROLS_GONE", root, f"has no control {listed(unknown)}")


def _detached(asset: Path, layer: Path, settings: Settings) -> Outcome:
    before = check_source(asset, settings.read.size_limit)
    # What survives that may be opened here.
    read_layer_isolated(asset, settings.read)
    source = open_layer(asset)
    sublayers, inside = _entries(asset, source, layer)
    if not (sublayers or inside):
        return "unchanged"

    _edit(source, "", sublayers)
    layout_reference.remove(source, inside)
    of_text = functools.partial(layer_text.without_sublayers, paths=sublayers)
    verify = functools.partial(_readable, settings)
    return _replaced(asset, source, before, verify, None if inside else of_text)


def _entries(
    asset: Path, source: Sdf.Layer, layer: Path
) -> tuple[Sequence[str], Sequence[layout_reference.ReferenceOf]]:
    """The sublayers and the references of a root layer that are `layer`."""

    def leads(entry: str) -> bool:
        return same_file(asset.parent / entry, layer)

    return [each for each in source.subLayerPaths if leads(each)], layout_reference.references_of(
        source, leads
    )


# --- what may be edited ---------------------------------------------------------------------------


def _check_editable(asset: Path, size_limit: int) -> None:
    if asset.suffix.lower() == ".usdz":
        raise refuse("ATTACH_PACKAGE", asset, "is a package, whose layers cannot be edited")
    if asset.is_symlink():
        raise refuse("ATTACH_LINK", asset, f"is a link to {os.path.realpath(asset)}")
    check_source(asset, size_limit)


def _check_bare(asset: Path, layer: Path, opening: ReadSettings) -> None:
    """Refuse layers that bring sublayers of their own, or lead back to the asset."""
    if same_file(asset, layer):
        raise refuse("ATTACH_CYCLE", layer, "is the asset itself")
    opened = read_layer_isolated(layer, opening)
    if any(same_file(asset, Path(found)) for found in opened.needed):
        raise refuse("ATTACH_CYCLE", layer, f"sublayers {asset} already")
    if opened.sublayers:
        raise refuse("ATTACH_NOT_BARE", layer, f"has the sublayer {opened.sublayers[0]}")


# --- the edit -------------------------------------------------------------------------------------


def _replaced(
    asset: Path,
    source: Sdf.Layer,
    before: SourceFile,
    verify: Callable[[Path], bool],
    of_text: Callable[[str], str] | None,
) -> Outcome:
    """Write the edited root layer of the asset in the format that it has; `of_text` makes the same
    edit of its text, with all other bytes as they are, where the layer need not be exported."""
    original = Original.of(before)
    if original.content.startswith(b"#usda") and of_text is not None:
        edited = of_text(original.content.decode(errors="surrogateescape"))
        kept = layer_text.means(edited, source)
        content = edited.encode(errors="surrogateescape") if kept else layer_bytes(source, ".usda")
    else:
        content = layer_bytes(source, ".usda" if original.content.startswith(b"#usda") else ".usdc")
    replace_source(asset, original, content, verify)
    return "written"


def _edit(layer: Sdf.Layer, added: str, removed: Sequence[str]) -> None:
    """Change the list of sublayers; those that stay keep their offsets."""
    pairs = [
        (path, offset)
        for path, offset in zip(layer.subLayerPaths, layer.subLayerOffsets, strict=True)
        if path not in removed
    ]
    if added:
        pairs.insert(0, (added, Sdf.LayerOffset()))
    if not pairs:
        layer.pseudoRoot.ClearInfo("subLayers")
        layer.pseudoRoot.ClearInfo("subLayerOffsets")
        return
    layer.subLayerPaths = [path for path, _ in pairs]
    for index, (_, offset) in enumerate(pairs):
        layer.subLayerOffsets[index] = offset


def _holds_layouts(roots: Sequence[str], opening: ReadSettings, path: Path) -> bool:
    """Whether the file composes to a character with the layouts."""
    return set(roots) <= {each.root for each in read_layouts_isolated(path, opening).layouts}


def _readable(settings: Settings, path: Path) -> bool:
    """Whether the file is still an asset."""
    try:
        return bool(read_rigs_isolated(path, settings).rigs)
    except RigUIError:
        return False
