"""The layer of a shot: what it adds to a layout that stands in another layer, and nothing of that one.

The new elements are children of the same Scope.  Where a shape of the shot moves the anchor of a standing
element, its drawn prims get that shape's offsets too, so that they follow the face in every application.
Without this layer the standing layout is what it was.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Sdf

from usdrigui.model import Element, Layout, Rig
from usdrigui.usd import author, schema
from usdrigui.usd.carry import Carriage, PointShape
from usdrigui.usd.control_api import author_limits
from usdrigui.usd.drawn import Drawn, drawn_parts
from usdrigui.usd.element_prims import author_shape
from usdrigui.usd.layer import (
    account,
    author_element,
    author_metadata,
    holds_layouts,
    instances_of,
    layer_bytes,
    relative_asset_path,
    solution,
)
from usdrigui.usd.reader_records import StandingPrim
from usdrigui.usd.safe_write import State


@dataclass(frozen=True)
class Addition:
    """What a shot adds for one character."""

    rig: Rig
    layout: Layout
    """Standing and new elements, as a client sees them that composes both layers."""
    added: frozenset[str]
    """Names of the new elements."""
    base_root: str
    """The SkelRoot's path in the layer of the standing layout."""
    prims: tuple[StandingPrim, ...]
    """Of the standing layout, with the paths of that layer."""


def write_additions(
    additions: Sequence[Addition],
    shot: Path,
    base: Path,
    target: Path,
    metadata: Mapping[str, Any],
    *,
    composed: bool,
    bare: bool,
    write: Callable[..., State],
) -> State:
    """Write the layer atomically over `shot` and, unless that is `composed` with it already, over `base`.

    A `base` that has the character at the shot's path becomes a sublayer, weaker than the shot; otherwise a
    reference.  `bare` leaves all of them to whoever composes.  Raises as `layer.write_layout`.
    """
    layer = Sdf.Layer.CreateAnonymous(".usda")
    below = "" if composed or bare else relative_asset_path(base, target)
    with Sdf.ChangeBlock():
        author_metadata(layer, metadata, [(each.rig, each.layout) for each in additions])
        if not bare:
            layer.subLayerPaths.append(relative_asset_path(shot, target))
        for each in additions:
            if below and each.base_root != each.rig.root:
                root = Sdf.CreatePrimInLayer(layer, each.rig.root)
                root.referenceList.prependedItems = [Sdf.Reference(below, each.base_root)]
            elif below and below not in layer.subLayerPaths:
                layer.subLayerPaths.append(below)
            if each.added:
                _author(Sdf.CreatePrimInLayer(layer, each.rig.root), each)
                author_limits(layer, each.rig)
    content = layer_bytes(layer, target.suffix, str(target))
    roots = [each.rig.root for each in additions if each.added]
    return write(content, target, verify=functools.partial(holds_layouts, roots))


def _author(root: Sdf.PrimSpec, addition: Addition) -> None:
    rig, layout = addition.rig, addition.layout
    scope = Sdf.PrimSpec(root, schema.SCOPE, Sdf.SpecifierOver)
    schemas = Sdf.TokenListOp()
    schemas.prependedItems = [schema.LAYOUT, schema.SOLUTION]
    scope.SetInfo("apiSchemas", schemas)
    author.declare(scope, schema.LAYOUT, account(rig, layout), fallbacks=True)
    author.declare(scope, schema.SOLUTION, solution(layout), fallbacks=True)
    carriage = Carriage(rig, layout)
    taken = {prim.path.split("/")[-2] for prim in addition.prims}
    names = {e.name: author.identifier(e.name, taken) for e in layout.elements if e.name in addition.added}
    for element in layout.elements:
        if element.name in addition.added:
            author_element(scope, rig, layout, carriage, element, names)
        else:
            _author_new_shapes(root.layer, addition, carriage, element)


def _author_new_shapes(layer: Sdf.Layer, addition: Addition, carriage: Carriage, element: Element) -> None:
    """Let what is drawn of a standing element follow the shapes that its layer does not know."""
    prims = [prim for prim in addition.prims if prim.element == element.name]
    known = {token for prim in prims if prim.role == "handle" for token in prim.shapes}
    if element.anchor.on_board or not any(
        addition.rig.channels[shape.channel].token not in known for shape in carriage.grip(element).shapes
    ):
        return
    for prim, part in _matched(
        prims, drawn_parts(carriage, element, addition.layout.handle_width_of(element)), element
    ):
        new = [shape for shape in part.shapes if addition.rig.channels[shape.channel].token not in prim.shapes]
        if new:
            _extend(layer, addition, prim, new)


def _matched(
    prims: Sequence[StandingPrim], parts: Sequence[Drawn], element: Element
) -> Iterator[tuple[StandingPrim, Drawn]]:
    """Every prim with the part that it draws."""
    instances = instances_of(element)
    for part in parts:
        shown = tuple(instances[name] for name in part.controls)
        for prim in prims:
            if prim.role == part.role and (part.role != "track" or prim.controls in ((), shown)):
                yield prim, part
                break


def _extend(layer: Sdf.Layer, addition: Addition, prim: StandingPrim, new: Sequence[PointShape]) -> None:
    prefixes = Sdf.Path(addition.base_root), Sdf.Path(addition.rig.root)
    path = Sdf.Path(prim.path).ReplacePrefix(*prefixes)
    targets = [Sdf.Path(each).ReplacePrefix(*prefixes) for each in prim.targets]
    tokens = [addition.rig.channels[shape.channel].token for shape in new]
    spec = Sdf.CreatePrimInLayer(layer, path)
    taken = {target.name for target in targets}
    for shape, token in zip(new, tokens, strict=True):
        child = Sdf.PrimSpec(spec, author.identifier(token, taken), Sdf.SpecifierDef, "BlendShape")
        author_shape(child, _fitted(shape, prim.points))
        targets.append(child.path)
    author.put(spec, "skel:blendShapes", "token[]", [*prim.shapes, *tokens], uniform=True)
    author.link(spec, "skel:blendShapeTargets", targets)


def _fitted(shape: PointShape, count: int) -> PointShape:
    """The shape for as many points as the prim really has: whoever drew it may draw otherwise than we do."""
    if shape.offsets.shape[1] == count:
        return shape
    return PointShape(shape.channel, shape.weights, np.repeat(shape.offsets[:, :1], count, axis=1))
