"""Contradictions in the layouts of a stage: with their own parts, or with the character's.

`read_layout` refuses what nobody could read.  These layouts can be read, and would do nothing, or
not what they show.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.errors import Issue, RigUIError
from usdrigui.layer import author
from usdrigui.layer.agreement import disagreements, length
from usdrigui.layer.baking import apart, valued
from usdrigui.layer.properties import (
    applied,
    control_instances,
    has,
    integers_of,
    targets,
)
from usdrigui.layer.read_controls import invalid_at
from usdrigui.layer.read_layout import (
    base_controls,
    element_prims,
    layout_at,
    layout_scopes,
    points_by_role,
)
from usdrigui.model import Element, Layout, MirrorPlane
from usdrigui.settings import ReadSettings
from usdrigui.stages import schema

_FAMILY = "rigUI"
_OPPOSITE = {"left": "right", "right": "left"}
_MEMBERS = {"slider": (1, 1), "patch": (2, 2), "fan": (1, np.inf)}
"""How many axes each type of element has."""
_MIRRORED = 0.1
"""Of a handle's width: anchors so near to each other's mirror image are those of a pair."""
_ASIDE = 1.0
"""Of a handle's width: so far from the plane an element is not on its other side."""
_CLEAR = 0.5
"""Cosine beyond which two directions are one, or opposite."""


def contradictions(stage: Usd.Stage, settings: ReadSettings) -> tuple[Issue, ...]:
    """LAYOUT_INVALID, LAYOUT_TRACK, LAYOUT_DRAWN and LAYOUT_VALUE for each element of the layouts
    of today's format, up to a property or a character that cannot be read; `stage` has layouts that
    `read_layout` reads."""
    issues: list[Issue] = []
    for scope in layout_scopes(stage):
        found: list[Issue] = []
        try:
            if has(scope, schema.LAYOUT):
                layout = layout_at(scope)
                found.extend(_of_layout(scope, layout))
                found.extend(disagreements(scope, layout, settings))
                found.extend(apart(valued(scope, settings)))
        except RigUIError as error:
            found.append(error.issue)
        issues += (replace(each, character=str(scope.GetPath().GetParentPath())) for each in found)
    return tuple(issues)


def _of_layout(scope: Usd.Prim, layout: Layout) -> Iterator[Issue]:
    prims = element_prims(scope)
    by_name = {
        element.name: (prim, element) for prim, element in zip(prims, layout.elements, strict=True)
    }
    yield from _of_listing(scope, layout)
    for mesh in scope.GetAllChildren():
        if mesh.IsA(UsdGeom.Mesh):
            yield from _of_drawing(mesh)
    for prim, element in by_name.values():
        if UsdGeom.Subset(prim):
            yield from _of_subset(prim)
        yield from _of_manipulator(prim, element)
        yield from _of_side(prim, element, layout)
        mirror = element.manipulator.mirror
        if mirror in by_name:
            yield from _of_mirror(prim, element, *by_name[mirror], layout)
        elif mirror:
            yield invalid_at(prim, f"rigUI:element:mirror is {mirror}, which is no element")
    yield from _unpaired(by_name, layout)


def _of_listing(scope: Usd.Prim, layout: Layout) -> Iterator[Issue]:
    """Whether the lists of a layout name what it has, each once."""
    for prim in (scope, *scope.GetAllChildren()):
        if UsdGeom.Imageable(prim).ComputePurpose() != UsdGeom.Tokens.guide:
            yield invalid_at(prim, "purpose is not guide: final pictures show the controls")
            break
    for name, kind in (("elements", None), ("skeleton", UsdSkel.Skeleton)):
        for path in targets(scope, schema.LAYOUT, name):
            prim = scope.GetStage().GetPrimAtPath(path)
            known = prim and (prim.IsA(kind) if kind else has(prim, schema.ELEMENT))
            if not known:
                yield invalid_at(scope, f"rigUI:layout:{name} names {path}, which is none")
    names = base_controls(scope)
    for name, count in Counter(names).items():
        if count > 1:
            yield invalid_at(scope, f"rigUI:layout:baseControls lists {name!r} {count} times")
    if names:
        for name in sorted(layout.controls - {*names}):
            yield invalid_at(
                scope, f"rigUI:layout:baseControls lacks {name!r}, which has an element"
            )


def _of_drawing(mesh: Usd.Prim) -> Iterator[Issue]:
    """Whether a mesh that draws elements moves with a Skeleton, and says of each face what it
    draws."""
    if schema.DRAWING not in applied(mesh):
        yield invalid_at(mesh, f"{schema.DRAWING} is missing: it draws elements")
    if not UsdSkel.BindingAPI(mesh).GetInheritedSkeleton():
        yield invalid_at(mesh, "skel:skeleton is missing: nothing moves its handles")
    subsets = [
        UsdGeom.Subset(each)
        for each in mesh.GetAllChildren()
        if each.GetAttribute("familyName").Get() == _FAMILY or has(each, schema.ELEMENT)
    ]
    faces = len(integers_of(UsdGeom.Mesh(mesh).GetFaceVertexCountsAttr()))
    drawn = [integers_of(each.GetIndicesAttr()) for each in subsets]
    count = np.bincount(np.concatenate([*drawn, np.zeros(0, dtype=np.int64)]), minlength=faces)
    if (count > 1).any():
        first = int(np.flatnonzero(count > 1)[0])
        yield invalid_at(mesh, f"its face {first} belongs to {count[first]} elements")


def _of_subset(prim: Usd.Prim) -> Iterator[Issue]:
    if not len(points_by_role(prim, "handle")):
        what = f"no face has the role 'handle': see primvars:{schema.ROLE} of its mesh"
        yield invalid_at(prim, what)
    if UsdGeom.Subset(prim).GetFamilyNameAttr().Get() != _FAMILY:
        yield _doubtful_at(prim, f"familyName is not {_FAMILY!r}")


def _of_manipulator(prim: Usd.Prim, element: Element) -> Iterator[Issue]:
    """Whether its controls make an element of its type, on one end of an axis each."""
    least, most = _MEMBERS[element.manipulator.kind]
    axes = len(element.manipulator.axes)
    if not least <= axes <= most:
        what = f"is a {element.manipulator.kind}, with {axes} axes"
        yield invalid_at(prim, f"rigUI:element:elementType {what}")
    for index, name in enumerate(control_instances(prim)):
        member = element.manipulator.members[index]
        drawn = length(member.track)
        meant = member.arc_length * member.magnification
        grain = author.TOLD * float(np.abs(member.track).sum())
        if meant and abs(drawn - meant) > 0.02 * max(drawn, meant) + grain:
            what = f"trackPoints have length {drawn:.4g}, arcLength by magnification is {meant:.4g}"
            yield invalid_at(prim, f"rigUI:control:{name}:{what}")


def _of_side(prim: Usd.Prim, element: Element, layout: Layout) -> Iterator[Issue]:
    """Whether an element on the character is on the side that it names."""
    plane, side = layout.frame.plane, element.look.side
    if element.anchor.on_board or not layout.frame.mirrors(element.placement.part):
        return
    away = float(plane.distance(element.anchor.position))
    # Far from the origin the layer tells places less exactly than a handle is wide.
    told = 2.0 * author.TOLD * float(np.abs(element.anchor.position).max())
    width = _ASIDE * layout.frame.handle_width_of(element.placement.part) + told
    if side == "none" or (away < -width and side == "left") or (away > width and side == "right"):
        where = "left" if away > 0.0 else "right"
        yield invalid_at(prim, f"rigUI:element:side is {side}, its anchor is on the {where}")


def _of_mirror(
    prim: Usd.Prim, element: Element, other_prim: Usd.Prim, other: Element, layout: Layout
) -> Iterator[Issue]:
    """Whether the element on the other side is one.  Where it lies is a warning: a person may
    call controls twins whose places on a lopsided character mirror nothing."""
    where = f"rigUI:element:mirror {other_prim.GetPath()}"
    if other.manipulator.mirror != element.name:
        yield invalid_at(prim, f"{where} does not mirror it back")
        return
    if _OPPOSITE.get(element.look.side) != other.look.side:
        yield _doubtful_at(prim, f"{where} is on the side {other.look.side}")
    if len(other.manipulator.members) != len(element.manipulator.members):
        yield invalid_at(prim, f"{where} has another number of controls")
        return
    reflect = layout.frame.plane.reflected
    on_board = element.anchor.on_board or other.anchor.on_board
    if on_board or not layout.frame.mirrors(element.placement.part):
        return
    width = layout.frame.handle_width_of(element.placement.part)
    away = np.linalg.norm(reflect(element.anchor.position) - other.anchor.position)
    if away > 3.0 * width:
        yield _doubtful_at(prim, f"{where} is {away:.3g} from its mirror image")
        return
    if element.manipulator.kind == "fan":
        return
    for index, (one, twin) in enumerate(
        zip(element.manipulator.members, other.manipulator.members, strict=True)
    ):
        mine = reflect(one.track[-1]) - reflect(one.track[0])
        theirs = twin.track[-1] - twin.track[0]
        lengths = float(np.linalg.norm(mine) * np.linalg.norm(theirs))
        alike = float(mine @ theirs) / lengths if lengths else 0.0
        if one.control == twin.control:
            continue
        reversed_ = index in element.manipulator.reversed
        if (alike > _CLEAR and reversed_) or (alike < -_CLEAR and not reversed_):
            yield invalid_at(prim, f"rigUI:control:{one.control}:mirrorReversed is {reversed_}")


def _unpaired(by_name: Mapping[str, tuple[Usd.Prim, Element]], layout: Layout) -> Iterator[Issue]:
    """Elements that are each other's mirror image, and do not say so."""
    alone = [
        (prim, element)
        for prim, element in by_name.values()
        if not (element.manipulator.mirror or element.anchor.on_board)
        and layout.frame.mirrors(element.placement.part)
    ]
    for prim, element in alone:
        width = layout.frame.handle_width_of(element.placement.part)
        # Far from the origin single precision does not tell such places apart.
        near = _MIRRORED * width - author.TOLD * np.abs(element.anchor.position).sum()
        for twin_prim, twin in alone:
            pair = (element.look.side, twin.look.side) == ("left", "right")
            alike = len(element.manipulator.members) == len(twin.manipulator.members)
            if pair and alike and _apart(layout.frame.plane, element, twin) < near:
                yield invalid_at(
                    prim, f"rigUI:element:mirror is missing: {twin_prim.GetPath()} is its image"
                )


def _apart(plane: MirrorPlane, element: Element, twin: Element) -> float:
    """How far the anchor and the tracks of an element are from those of another in the mirror."""
    pairs = [(element.anchor.position, twin.anchor.position)]
    for one, other in zip(element.manipulator.members, twin.manipulator.members, strict=True):
        pairs += [(one.track[0], other.track[0]), (one.track[-1], other.track[-1])]
    return max(float(np.linalg.norm(plane.reflected(here) - there)) for here, there in pairs)


def _doubtful_at(prim: Usd.Prim, message: str) -> Issue:
    """The contradiction at a prim, as a warning."""
    return replace(invalid_at(prim, message), severity="warning")
