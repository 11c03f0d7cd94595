"""Contradictions in the layouts of a stage: with their own parts, or with the character's.

`read_layout` refuses what nobody could read.  These layouts can be read, and would do nothing, or
not what they show.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import zip_longest

import numpy as np
from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.character import Floats, Rig
from usdrigui.errors import Issue, RigUIError, of_character
from usdrigui.layer import author
from usdrigui.layer.agreement import CLEAR, disagreements, drawings
from usdrigui.layer.baking import apart, valued
from usdrigui.layer.properties import applied, has, invalid, value_of
from usdrigui.layer.read_controls import doubtful_at, invalid_at
from usdrigui.layer.read_layout import (
    element_prims,
    layout_at,
    layout_scopes,
    points_by_role,
)
from usdrigui.model import Element, Layout
from usdrigui.model.levels import inner_names
from usdrigui.settings import ReadSettings
from usdrigui.stages import schema

_FAMILY = "rigUI"
_MEMBERS = {"slider": (1, 1), "patch": (2, 2), "fan": (1, np.inf)}
"""How many axes each type of element has."""
_PLAIN = {
    "subdivisionScheme": "bilinear",
    "orientation": "rightHanded",
    "holeIndices": None,
    "normals": None,
    "primvars:normals": None,
    "xformOpOrder": None,
}
"""What every mesh that draws elements has of USD's own properties."""
_TARGETS = {
    "skeleton": "Skeleton",
    "animation": "SkelAnimation",
    "prim": "Mesh",
    "carrier": "Mesh",
    "elements": schema.ELEMENT,
    "members": schema.ELEMENT,
    "mirror": schema.ELEMENT,
}
"""Type of the targets of our relationships, or a schema of theirs."""
_WORDS = {"familyType": ("nonOverlapping", "partition", "unrestricted")}
"""Allowed in attributes that USD has no definition of."""
_ASIDE, _UPON = 1.0, 0.01
"""Of a handle's width: so far from the plane an element is not on its other side, and nearer it is
on no side at all."""


def contradictions(
    stage: Usd.Stage,
    settings: ReadSettings,
    layouts: Sequence[Layout] = (),
    rigs: Sequence[Rig] = (),
) -> tuple[Issue, ...]:
    """LAYOUT_INVALID, LAYOUT_TRACK, LAYOUT_DRAWN and LAYOUT_VALUE for each element of the layouts
    of today's format, up to a property or a character that cannot be read; `stage` has layouts that
    `read_layout` reads, or has read.  Controls are compared with those of the characters `rigs`,
    where these have been read."""
    issues: list[Issue] = []
    read = {rig.path: {each.name: each for each in rig.controls} for rig in rigs}
    for scope, known in zip_longest(layout_scopes(stage), layouts):
        found: list[Issue] = []
        try:
            layout = known or layout_at(scope)
            found.extend(_of_prims(scope))
            found.extend(_of_layout(scope, layout))
            found.extend(disagreements(scope, layout, settings, read.get(layout.root, {})))
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
    inner = inner_names(layout.elements)
    for mesh in drawings(scope):
        yield from _of_drawing(mesh, parts)
        levels = {
            name in inner for name, (prim, _) in by_name.items() if mesh.GetChild(prim.GetName())
        }
        hidden = UsdGeom.Imageable(mesh).GetVisibilityAttr().Get() == UsdGeom.Tokens.invisible
        if len(levels) > 1:
            yield invalid_at(mesh, "draws members of coarse elements, and elements that are none")
        elif levels == {not hidden}:
            yield doubtful_at(mesh, "visibility is not that of its level: members are invisible")
    for prim, element in by_name.values():
        if UsdGeom.Subset(prim):
            if not len(points_by_role(prim, "handle")):
                yield invalid_at(prim, f"no face has the role 'handle': see primvars:{schema.ROLE}")
            if prim.GetAttribute("familyName").Get() != _FAMILY:
                yield doubtful_at(prim, f"familyName is not {_FAMILY!r}")
        least, most = _MEMBERS[element.kind]
        axes = len(element.axes)
        if not least <= axes <= most:
            yield invalid_at(prim, f"rigUI:element:elementType does not fit its {axes} axes")
        copies = [element.anchor.position]
        if element.mirror in by_name:
            other_prim, other = by_name[element.mirror]
            copies.append(other.anchor.position)
            yield from _of_mirror(prim, element, other_prim, other, layout)
        yield from _of_side(prim, element, np.array(copies), layout)
    for one, other in layout.unpaired(author.TOLD):
        yield invalid_at(
            by_name[one.name][0], f"rigUI:element:mirror is missing: {other.name} is its image"
        )
    away = [
        layout.frame.plane.distance(each.anchor.position)
        for each in layout.elements
        if each.mirror and not each.anchor.on_board and layout.frame.mirrors(each.part)
    ]
    if away and min(away) * max(away) >= 0.0:
        yield invalid_at(scope, "rigUI:layout:planeOrigin: all pairs are on one side of the plane")


def _of_prims(scope: Usd.Prim) -> Iterator[Issue]:
    """What no prim of a layout has: another type than that of its schemas, words that USD does not
    know, what changes in time, and targets on another character."""
    parent = scope.GetParent()
    root, several = parent.GetPath(), sum(has(each, schema.LAYOUT) for each in parent.GetChildren())
    if several > 1 or not parent.IsA(UsdSkel.Root):
        raise invalid(scope, "is not the one layout of a SkelRoot")
    skeletons = {*value_of(scope, schema.LAYOUT, "skeleton")}
    for prim in Usd.PrimRange(scope, Usd.TraverseInstanceProxies()):
        for api in filter(schema.APIS.__contains__, applied(prim)):
            kinds = author.prim_types(api)
            if prim.GetTypeName() not in kinds:
                yield invalid_at(prim, f"{api} is of a {kinds[0]}, not a {prim.GetTypeName()}")
        for attribute in prim.GetAuthoredAttributes():
            words, said = attribute.GetMetadata("allowedTokens"), attribute.Get()
            words = words or _WORDS.get(attribute.GetBaseName())
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
            if name.endswith(":skeleton") and {*map(str, relation.GetTargets())} - skeletons:
                yield invalid_at(scope, f"rigUI:layout:skeleton lacks {name} of {prim.GetPath()}")
            kind = _TARGETS.get(relation.GetBaseName(), "")
            for path in relation.GetTargets() if kind and name.startswith("rigUI:") else ():
                there = scope.GetStage().GetPrimAtPath(path)
                # A mesh or a mirror that is not active is gone from a flattened stage.
                gone = not there and (kind == "Mesh" or name.endswith(":mirror"))
                if not (gone or (there and kind in (there.GetTypeName(), *applied(there)))):
                    yield invalid_at(prim, f"{name} names {path}, which is no {kind}")
                if kind != "SkelAnimation" and not path.HasPrefix(root):
                    yield invalid_at(prim, f"{name} names {path}, which is not of {root}")


def _of_listing(scope: Usd.Prim, layout: Layout) -> Iterator[Issue]:
    """Whether a layout is a guide, its width and view are those of its parts, and its lists name
    what it has, each once."""
    for prim in (scope, *scope.GetAllChildren()):
        if UsdGeom.Imageable(prim).ComputePurpose() != UsdGeom.Tokens.guide:
            yield invalid_at(prim, "purpose is not guide: final pictures show the controls")
            break
    frame, width = layout.frame, value_of(scope, schema.LAYOUT, "handleWidth")
    least = min((each.handle_width for each in frame.parts), default=width)
    if not np.isclose(width, least):
        yield invalid_at(scope, f"rigUI:layout:handleWidth is not {least}, the least of its parts")
    if max((each.view @ frame.view for each in frame.parts), default=1.0) < CLEAR:
        yield doubtful_at(scope, "rigUI:layout:viewDirection is that of none of its parts")
    names = layout.listed
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
    # Of an element that is not active, flattening leaves the faces alone.
    subsets = [
        UsdGeom.Subset(each)
        for each in mesh.GetAllChildren()
        if each.GetAttribute("familyName").Get() == _FAMILY or has(each, schema.ELEMENT)
        if each.GetAttribute("indices").Get()  # USD crashes where no subset has any
    ]
    for name, wanted in _PLAIN.items():
        said = mesh.GetAttribute(name)
        if ((said and said.Get()) or None) != wanted:
            what = f"{name} is not {wanted or 'empty'}, as of every mesh that draws elements"
            yield invalid_at(mesh, what)
    drawn = UsdGeom.Mesh(mesh)
    faces, points = drawn.GetFaceCount(), drawn.GetPointsAttr().Get() or ()
    box = drawn.GetExtentAttr().Get()
    if box and not np.allclose(box, UsdGeom.PointBased.ComputeExtent(points)):
        yield invalid_at(mesh, "extent is not that of its points: viewers may leave it out")
    counts = {"constant": 1, "uniform": faces, "vertex": len(points)}
    for primvar in UsdGeom.PrimvarsAPI(mesh).GetPrimvarsWithAuthoredValues():
        kind, values, places = primvar.GetInterpolation(), primvar.Get(), primvar.GetIndices()
        held = places if primvar.IsIndexed() else values
        wanted = counts.get(kind, 0) * primvar.GetElementSize()
        odd = wanted and primvar.GetTypeName().isArray and len(held) != wanted
        if odd or (places and {*places} - {*range(len(values))}):
            what = f"is {kind}, which {len(held)} values do not fit, or has an index beyond them"
            yield invalid_at(mesh, f"{primvar.GetName()} {what}")
    if min(drawn.GetDisplayOpacityAttr().Get() or (1.0,)) <= 0.0:
        yield doubtful_at(mesh, "primvars:displayOpacity is 0: nobody sees what it draws")
    sound, why = UsdGeom.Subset.ValidateSubsets(subsets, faces, UsdGeom.Tokens.nonOverlapping)
    if not sound:
        yield invalid_at(mesh, why)


def _of_side(prim: Usd.Prim, element: Element, copies: Floats, layout: Layout) -> Iterator[Issue]:
    """Whether an element on the character, with its mirror at `copies` (c, 3), is on the side that
    it names, and has nothing of those on the board, which face the viewer."""
    plane, side = layout.frame.plane, element.side
    on_board, part, normal = element.anchor.on_board, element.part, element.anchor.normal
    if on_board and normal @ layout.frame.view_of(part) < CLEAR * normal.any():
        yield invalid_at(prim, "rigUI:anchor:normal on the board does not look to the viewer")
    if not on_board and (value_of(prim, schema.ANCHOR, "carrier") or element.category):
        yield invalid_at(prim, "has rigUI:anchor:prim, and a carrier or category of the board")
    if side != "none" and not plane.normal.any():
        yield invalid_at(prim, f"rigUI:element:side is {side}: rigUI:layout:planeNormal is missing")
    if not layout.frame.mirrors(part):
        return
    away = plane.aside(copies)[0]
    # Far from the origin the layer tells places less exactly than a handle is wide.
    told = 2.0 * author.TOLD * np.abs(element.anchor.position).max()
    width = layout.frame.handle_width_of(part)
    towards = {"left": away, "right": -away}.get(side, np.inf)
    astray = towards < -_ASIDE * width - told or abs(towards) < _UPON * width - told
    if side == "none" or (astray and not on_board):
        where = f"{abs(away):.3g} on the {'left' if away > 0.0 else 'right'}"
        yield invalid_at(
            prim,
            f"rigUI:element:side is {side}, and its anchor is {where} of the middle, that of its"
            " pair where it has one",
        )


def _of_mirror(
    prim: Usd.Prim, element: Element, other_prim: Usd.Prim, other: Element, layout: Layout
) -> Iterator[Issue]:
    """Whether the element on the other side is one."""
    where = f"rigUI:element:mirror {other_prim.GetPath()}"
    if other.mirror != element.name or len(other.members) != len(element.members):
        yield invalid_at(prim, f"{where} does not mirror it back, with as many controls")
        return
    if {element.side, other.side} != {"left", "right"}:
        yield doubtful_at(prim, f"{where} is on the side {other.side}")
    reflect = layout.frame.plane.reflected
    free = element.anchor.on_board or other.anchor.on_board or element.kind == "fan"
    away = np.linalg.norm(reflect(element.anchor.position) - other.anchor.position)
    # In a pose the ends of a pair go any way.
    if free or away > 3.0 * layout.frame.handle_width_of(element.part):
        return
    for index, (one, twin) in enumerate(zip(element.members, other.members, strict=True)):
        mine, theirs = (track[-1] - track[0] for track in (reflect(one.track), twin.track))
        clear = CLEAR * np.linalg.norm(mine) * np.linalg.norm(theirs)
        reversed_ = index in element.reversed
        if one.control != twin.control and mine @ (-theirs if reversed_ else theirs) < -clear:
            yield invalid_at(prim, f"rigUI:control:{one.control}:mirrorReversed is {reversed_}")
