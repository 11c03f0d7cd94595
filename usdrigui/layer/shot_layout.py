"""The layer of a shot: what it adds to a layout in another layer, and nothing of that
one.

The new elements are children of the same Scope.  Where a shape of the shot moves the anchor of an
existing element, its drawn prims get that shape's offsets too, so that they follow the face in
every application. Without this layer the existing layout is what it was.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Sdf

from usdrigui.character import Indices, Rig
from usdrigui.layer import author
from usdrigui.layer.control_api import author_limits
from usdrigui.layer.drawing import author_shapes
from usdrigui.layer.drawn import Drawn, drawn_parts
from usdrigui.layer.skin_binding import PointShape, SkinBinding
from usdrigui.layer.write_layout import (
    account,
    author_elements,
    author_metadata,
    author_variant,
    holds_layouts,
    layer_bytes,
    record,
    relative_asset_path,
)
from usdrigui.model import Element, ExistingPrim, ExistingSpan, Layout
from usdrigui.replacing.transaction import State
from usdrigui.stages import schema


@dataclass(frozen=True)
class ShotLayout:
    """What a shot adds for one character."""

    rig: Rig
    layout: Layout
    """Existing and new elements, as a client sees them that composes both layers."""
    added: frozenset[str]
    """Names of the new elements."""
    base_root: str
    """The SkelRoot's path in the layer of the existing layout."""
    prims: tuple[ExistingPrim, ...]
    """Of the existing layout, with the paths of that layer."""


def write_shot_layouts(
    shots: Sequence[ShotLayout],
    shot: Path,
    base: Path,
    target: Path,
    metadata: Mapping[str, Any],
    *,
    composed: bool,
    bare: bool,
    write: Callable[..., State],
) -> State:
    """Write the layer atomically over `shot` and, unless that is `composed` with it already, over
    `base`.

    A `base` that has the character at the shot's path becomes a sublayer, weaker than the shot;
    otherwise a reference.  `bare` leaves all of them to whoever composes.  Raises as
    `layer.write_layout`.
    """
    layer = Sdf.Layer.CreateAnonymous(".usda")
    below = "" if composed or bare else relative_asset_path(base, target)
    with Sdf.ChangeBlock():
        author_metadata(layer, metadata, [(each.rig, each.layout) for each in shots])
        if not bare:
            layer.subLayerPaths.append(relative_asset_path(shot, target))
        for each in shots:
            if below and each.base_root != each.rig.path:
                root = Sdf.CreatePrimInLayer(layer, each.rig.path)
                root.referenceList.prependedItems = [Sdf.Reference(below, each.base_root)]
            elif below and below not in layer.subLayerPaths:
                layer.subLayerPaths.append(below)
            if each.added:
                _author(layer, each)
    content = layer_bytes(layer, target.suffix, str(target))
    roots = [each.rig.path_in_variants for each in shots if each.added]
    return write(content, target, verify=functools.partial(holds_layouts, roots))


def _author(layer: Sdf.Layer, shot: ShotLayout) -> None:
    rig, layout = shot.rig, shot.layout
    as_variant = all(prim.in_variant for prim in shot.prims)
    root = (
        author_variant(layer, rig.path_in_variants)
        if as_variant
        else Sdf.CreatePrimInLayer(layer, rig.path)
    )
    author_limits(root, rig)
    scope = Sdf.PrimSpec(root, schema.SCOPE, Sdf.SpecifierOver)
    author.apply(scope, [schema.LAYOUT])
    author.declare(scope, schema.LAYOUT, account(rig, layout), fallbacks=True)
    author.note(scope, record(layout))
    taken = {name for prim in shot.prims for name in (*prim.names, prim.path.rpartition("/")[2])}
    added = [element for element in layout.elements if element.name in shot.added]
    author_elements(scope, rig, layout, added, taken)
    existing = [element for element in layout.elements if element.name not in shot.added]
    _author_new_shapes(scope, shot, existing)


def _author_new_shapes(scope: Sdf.PrimSpec, shot: ShotLayout, elements: Sequence[Element]) -> None:
    """Let what is drawn of existing elements follow the shapes that their layer does not know."""
    skin, frame = SkinBinding(shot.rig, shot.layout), shot.layout.frame
    channels = shot.rig.body.channels
    parts = {
        each.name: drawn_parts(skin, each, frame) for each in elements if not each.anchor.on_board
    }
    prefixes = Sdf.Path(shot.base_root), Sdf.Path(shot.rig.path)
    for prim in shot.prims:
        spans = [
            span
            for each in prim.spans
            if each.element in parts
            for span in _moved(parts[each.element], each)
        ]
        tokens = {channels[shape.channel].token for _, shapes in spans for shape in shapes}
        if not tokens <= {*prim.shapes}:
            path = (
                Sdf.Path(prim.path)
                .ReplacePrefix(*prefixes)
                .ReplacePrefix(shot.rig.path, scope.path.GetParentPath())
            )
            targets = [Sdf.Path(each).ReplacePrefix(*prefixes) for each in prim.targets]
            existing = list(zip(prim.shapes, targets, strict=True))
            spec = Sdf.CreatePrimInLayer(scope.layer, path)
            taken = {target.name for target in targets} | set(prim.names)
            author_shapes(spec, channels, spans, taken, existing)


def _moved(
    parts: Sequence[Drawn], span: ExistingSpan
) -> Iterator[tuple[Indices, Sequence[PointShape]]]:
    """The points of a span with the shapes that move them, alike for all: whoever drew it may draw
    otherwise than we do."""
    part, count = parts[0] if span.role == "handle" else parts[1], len(span.points)
    if count:
        yield (
            span.points,
            [
                PointShape(
                    shape.channel, shape.weights, np.repeat(shape.offsets[:, :1], count, axis=1)
                )
                for shape in part.shapes
            ],
        )
