"""Contradictions in the layouts of a stage: with their own parts, or with the character's.

`read_layout` refuses what nobody could read.  These layouts can be read, and would do nothing, or
not what they show.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product, zip_longest

import numpy as np
from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.character import Floats
from usdrigui.errors import Issue, RigUIError, of_character
from usdrigui.layer import author
from usdrigui.layer.agreement import CLEAR, disagreements, drawings, length
from usdrigui.layer.baking import apart, valued
from usdrigui.layer.properties import (
    applied,
    control_instances,
    has,
    invalid,
    targets,
    value_of,
)
from usdrigui.layer.read_controls import invalid_at
from usdrigui.layer.read_layout import (
    base_controls,
    element_prims,
    layout_at,
    layout_scopes,
    points_by_role,
)
from usdrigui.model import Element, Layout
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


def contradictions(
    stage: Usd.Stage, settings: ReadSettings, layouts: Sequence[Layout] = ()
) -> tuple[Issue, ...]:
    """LAYOUT_INVALID, LAYOUT_TRACK, LAYOUT_DRAWN and LAYOUT_VALUE for each element of the layouts
    of today's format, up to a property or a character that cannot be read; `stage` has layouts that
    `read_layout` reads, or has read."""
    issues: list[Issue] = []
    for scope, known in zip_longest(layout_scopes(stage), layouts):
        found: list[Issue] = []
        try:
            layout = known or layout_at(scope)
            found.extend(_of_prims(scope))
            found.extend(_of_layout(scope, layout))
            found.extend(disagreements(scope, layout, settings))
            found.extend(apart(valued(scope, settings)))
        except RigUIError as error:
            found.append(error.issue)
        issues += of_character(str(scope.GetPath().GetParentPath()), found)
    return tuple(issues)


def _of_layout(scope: Usd.Prim, layout: Layout) -> Iterator[Issue]:
    prims = element_prims(scope)
    by_name = {
        element.name: (prim, element) for prim, element in zip(prims, layout.elements, strict=True)
    }
    yield from _of_listing(scope, layout)
    parts = [each.name for each in layout.frame.parts]
    for mesh in drawings(scope):
        yield from _of_drawing(mesh, parts)
    for prim, element in by_name.values():
        if UsdGeom.Subset(prim):
            if not len(points_by_role(prim, "handle")):
                yield invalid_at(prim, f"no face has the role 'handle': see primvars:{schema.ROLE}")
            if prim.GetAttribute("familyName").Get() != _FAMILY:
                yield _doubtful_at(prim, f"familyName is not {_FAMILY!r}")
        yield from _of_manipulator(prim, element)
        yield from _of_side(prim, element, layout)
        mirror = element.mirror
        if mirror in by_name:
            yield from _of_mirror(prim, element, *by_name[mirror], layout)
        elif mirror:
            yield invalid_at(prim, f"rigUI:element:mirror is {mirror}, which is no element")
    yield from _unpaired(by_name, layout)


def _of_prims(scope: Usd.Prim) -> Iterator[Issue]:
    """What no prim of a layout has: another type than that of its schemas, words that USD does not
    know, what changes in time, and targets on another character."""
    parent = scope.GetParent()
    root, several = parent.GetPath(), sum(has(each, schema.LAYOUT) for each in parent.GetChildren())
    if several > 1 or not parent.IsA(UsdSkel.Root):
        raise invalid(scope, "is not the one layout of a SkelRoot")
    skeletons = {*targets(scope, schema.LAYOUT, "skeleton")}
    for prim in Usd.PrimRange(scope, Usd.TraverseInstanceProxies()):
        for api in filter(schema.APIS.__contains__, applied(prim)):
            kinds = author.prim_types(api)
            if prim.GetTypeName() not in kinds:
                yield invalid_at(prim, f"{api} is of a {kinds[0]}, not a {prim.GetTypeName()}")
        for attribute in prim.GetAuthoredAttributes():
            words, said = attribute.GetMetadata("allowedTokens"), attribute.Get()
            if words and said not in (None, *words):
                yield invalid_at(prim, f"{attribute.GetName()} is {said!r}, not one of {words}")
            still = attribute.GetBaseName() not in ("value", "visibility")
            if still and attribute.GetNumTimeSamples():
                yield invalid_at(
                    prim,
                    f"{attribute.GetName()} has time samples: only values and visibility change",
                )
        for relation in prim.GetAuthoredRelationships():
            name = relation.GetName()
            if name.endswith(":skeleton") and {*relation.GetTargets()} - skeletons:
                yield invalid_at(scope, f"rigUI:layout:skeleton lacks {name} of {prim.GetPath()}")
            free = not name.startswith("rigUI:") or name.endswith(":animation")
            if not (free or all(each.HasPrefix(root) for each in relation.GetTargets())):
                yield invalid_at(prim, f"{name} names what is not of {root}")


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
    if len({*names}) < len(names):
        yield invalid_at(scope, "rigUI:layout:baseControls lists a control twice")
    for name in sorted(layout.controls - {*names}) if names else ():
        yield invalid_at(scope, f"rigUI:layout:baseControls lacks {name!r}, which has an element")


def _of_drawing(mesh: Usd.Prim, parts: Sequence[str]) -> Iterator[Issue]:
    """Whether a mesh that draws elements moves with a Skeleton, and says of each face what it
    draws."""
    part = value_of(mesh, schema.DRAWING, "part")
    if part and parts and part not in parts:
        yield invalid_at(mesh, f"rigUI:drawing:part is {part!r}, which no {schema.PART} has")
    if not has(mesh, schema.DRAWING):
        yield invalid_at(mesh, f"{schema.DRAWING} is missing: it draws elements")
    if not UsdSkel.BindingAPI(mesh).GetInheritedSkeleton():
        yield invalid_at(mesh, "skel:skeleton is missing: nothing moves its handles")
    subsets = [
        UsdGeom.Subset(each)
        for each in mesh.GetAllChildren()
        if each.GetAttribute("familyName").Get() == _FAMILY or has(each, schema.ELEMENT)
    ]
    if mesh.GetAttribute("xformOpOrder").Get():
        yield invalid_at(mesh, "xformOpOrder moves it out of the space of its SkelRoot")
    drawn = UsdGeom.Mesh(mesh)
    faces, points = drawn.GetFaceCount(), drawn.GetPointsAttr().Get() or ()
    normals = mesh.GetAttribute("primvars:normals") or drawn.GetNormalsAttr()
    flat = drawn.GetSubdivisionSchemeAttr().Get() == "bilinear" and not normals.Get()
    right = drawn.GetOrientationAttr().Get() == "rightHanded"
    if not (flat and right) or drawn.GetHoleIndicesAttr().Get():
        what = "subdivisionScheme, orientation, normals or holeIndices is not the contract's"
        yield invalid_at(mesh, what)
    box = drawn.GetExtentAttr().Get()
    if box and not np.allclose(box, UsdGeom.PointBased.ComputeExtent(points)):
        yield invalid_at(mesh, "extent is not that of its points: viewers may leave it out")
    counts = {"constant": 1, "uniform": faces, "vertex": len(points)}
    for primvar in UsdGeom.PrimvarsAPI(mesh).GetPrimvarsWithAuthoredValues():
        kind = primvar.GetInterpolation()
        held = primvar.GetIndices() if primvar.IsIndexed() else primvar.Get()
        wanted = counts.get(kind, 0) * primvar.GetElementSize()
        if wanted and primvar.GetTypeName().isArray and len(held) != wanted:
            yield invalid_at(mesh, f"{primvar.GetName()} has {len(held)} values, and is {kind}")
    if min(drawn.GetDisplayOpacityAttr().Get() or (1.0,)) <= 0.0:
        yield _doubtful_at(mesh, "primvars:displayOpacity is 0: nobody sees what it draws")
    sound, why = UsdGeom.Subset.ValidateSubsets(subsets, faces, UsdGeom.Tokens.nonOverlapping)
    if not sound:
        yield invalid_at(mesh, why)


def _of_manipulator(prim: Usd.Prim, element: Element) -> Iterator[Issue]:
    """Whether its controls make an element of its type, on one end of an axis each."""
    least, most = _MEMBERS[element.kind]
    axes = len(element.axes)
    if not least <= axes <= most:
        yield invalid_at(prim, f"rigUI:element:elementType does not fit its {axes} axes")
    for name, member in zip(control_instances(prim), element.members, strict=True):
        drawn = length(member.track)
        meant = member.arc_length * member.magnification
        grain, peak = author.TOLD * np.abs(member.track).sum(), member.peak or member.arc_length
        own = 0.98 * peak if element.anchor.on_board else 0.0
        if not own <= member.arc_length <= 1.02 * peak:
            yield invalid_at(
                prim, f"rigUI:control:{name}:arcLength is not peak, or less on the skin"
            )
        if meant and abs(drawn - meant) > 0.02 * max(drawn, meant) + grain:
            what = f"trackPoints have length {drawn:.4g}, arcLength by magnification is {meant:.4g}"
            yield invalid_at(prim, f"rigUI:control:{name}:{what}")


def _of_side(prim: Usd.Prim, element: Element, layout: Layout) -> Iterator[Issue]:
    """Whether an element on the character is on the side that it names, and has nothing of those
    on the board, which face the viewer."""
    plane, side = layout.frame.plane, element.side
    on_board, part = element.anchor.on_board, element.part
    if on_board and element.anchor.normal @ layout.frame.view_of(part) < 0.0:
        yield invalid_at(prim, "rigUI:anchor:normal on the board looks away from the viewer")
    if not on_board and (targets(prim, schema.ANCHOR, "carrier") or element.category):
        yield invalid_at(prim, "has rigUI:anchor:prim, and a carrier or category of the board")
    if side != "none" and not plane.normal.any():
        yield invalid_at(prim, f"rigUI:element:side is {side}: rigUI:layout:planeNormal is missing")
    if on_board or not layout.frame.mirrors(part):
        return
    away = plane.distance(element.anchor.position)
    # Far from the origin the layer tells places less exactly than a handle is wide.
    told = 2.0 * author.TOLD * np.abs(element.anchor.position).max()
    width = _ASIDE * layout.frame.handle_width_of(part) + told
    where = "left" if away > 0.0 else "right"
    if side == "none" or (abs(away) > width and side == _OPPOSITE[where]):
        yield invalid_at(prim, f"rigUI:element:side is {side}, its anchor is on the {where}")


def _of_mirror(
    prim: Usd.Prim, element: Element, other_prim: Usd.Prim, other: Element, layout: Layout
) -> Iterator[Issue]:
    """Whether the element on the other side is one.  Where it lies is a warning: a person may
    call controls twins whose places on a lopsided character mirror nothing."""
    where = f"rigUI:element:mirror {other_prim.GetPath()}"
    if other.mirror != element.name:
        yield invalid_at(prim, f"{where} does not mirror it back")
        return
    if _OPPOSITE.get(element.side) != other.side:
        yield _doubtful_at(prim, f"{where} is on the side {other.side}")
    if len(other.members) != len(element.members):
        yield invalid_at(prim, f"{where} has another number of controls")
        return
    reflect = layout.frame.plane.reflected
    on_board = element.anchor.on_board or other.anchor.on_board
    if on_board or not layout.frame.mirrors(element.part):
        return
    width = layout.frame.handle_width_of(element.part)
    away = np.linalg.norm(reflect(element.anchor.position) - other.anchor.position)
    if away > 3.0 * width:
        yield _doubtful_at(prim, f"{where} is {away:.3g} from its mirror image")
        return
    if element.kind == "fan":
        return
    for index, (one, twin) in enumerate(zip(element.members, other.members, strict=True)):
        mine, theirs = (track[-1] - track[0] for track in (reflect(one.track), twin.track))
        clear = CLEAR * np.linalg.norm(mine) * np.linalg.norm(theirs)
        reversed_ = index in element.reversed
        if one.control != twin.control and mine @ (-theirs if reversed_ else theirs) < -clear:
            yield invalid_at(prim, f"rigUI:control:{one.control}:mirrorReversed is {reversed_}")


def _unpaired(by_name: Mapping[str, tuple[Usd.Prim, Element]], layout: Layout) -> Iterator[Issue]:
    """Elements that are each other's mirror image, with the ends of their tracks, and do not say
    so."""
    plane, frame = layout.frame.plane, layout.frame
    sides: dict[str, list[tuple[Usd.Prim, Floats, float]]] = {"left": [], "right": []}
    for prim, element in by_name.values():
        part, side = element.part, element.side
        if (
            not (element.mirror or element.anchor.on_board)
            and frame.mirrors(part)
            and side in sides
        ):
            ends = (
                end for member in element.members for end in (member.track[0], member.track[-1])
            )
            places = np.stack([element.anchor.position, *ends])
            # Far from the origin single precision does not tell such places apart.
            near = _MIRRORED * frame.handle_width_of(part) - author.TOLD * np.abs(places[0]).sum()
            sides[side].append((prim, places, near))
    for (prim, mine, near), (twin, theirs, _) in product(*sides.values()):
        images = plane.reflected(mine) if len(mine) == len(theirs) else theirs + np.inf
        if np.linalg.norm(images - theirs, axis=1).max() < near:
            yield invalid_at(
                prim, f"rigUI:element:mirror is missing: {twin.GetPath()} is its image"
            )


def _doubtful_at(prim: Usd.Prim, message: str) -> Issue:
    """The contradiction at a prim, as a warning."""
    return replace(invalid_at(prim, message), severity="warning")
