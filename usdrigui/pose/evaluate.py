"""A layout at any pose: the deformed character, and every element where it then is.

`usdrigui.following` defines what carries an element and which controls its tracks ignore; its
handle lies on the deformed anchor, however its tracks are magnified, or slides along them.  The
written layer gives the same to UsdSkel, which deforms tracks and handles as gprims; better than a
gprim can, tracks here also follow other controls of the joints that their own control turns.  numpy
only.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from usdrigui.character import Body, Floats, Indices, Record, Rig, RigMesh
from usdrigui.character.deform import Posed, deform, posed
from usdrigui.character.subset import subset
from usdrigui.errors import meant, refuse
from usdrigui.following import Following, controls_of, following, shared
from usdrigui.model import Element, Layout
from usdrigui.pose.handle_track import carried, facing, slid


class PosedElement(Record):
    """One element at a pose; positions in root space."""

    name: str
    """Of the element."""
    tracks: tuple[Floats, ...]
    """Per member, (k, 3): the drawn track, at the values `Member.values`."""
    handle: Floats
    """(3,) centre of the handle."""
    rest: Floats
    """(3,) where the handle would be if the element's own controls were at the base pose."""
    normal: Floats
    """(3,) unit; the direction in which the element faces."""
    glyph: Floats
    """(q, 3) points of the handle's glyph; none for the usual shape."""


class PosedLayout(Record):
    """A character and its elements at a pose."""

    points: Floats
    """(n, 3) points of all meshes in root space."""
    elements: tuple[PosedElement, ...]
    """In the order of `Layout.elements`."""


class Poser(Record):
    """A rig and its layout, prepared by `prepare` for evaluation at many poses."""

    rig: Rig
    layout: Layout
    anchors: Rig
    """The rig cut down to the points that elements are anchored at."""
    rows: Indices
    """(elements,) each element's point in `anchors`."""
    owned: tuple[Indices, ...]
    """Per element, its controls as indices into `Rig.controls`, in member order."""
    followings: tuple[Following, ...]
    """Per element."""
    base: Posed
    """`anchors` at the base pose."""
    still: Rig
    """`anchors` all on one joint, for elements that it carries."""
    still_base: Posed


def prepare(rig: Rig, layout: Layout) -> Poser:
    """Match a layout with its rig.

    Raises RigUIError LAYOUT_STALE when the layout was made for another version of the character: a
    mesh or a control is missing, or the topology has changed.
    """
    points = np.array(
        [_anchor_point(rig.body, element) for element in layout.elements],
        dtype=np.int64,
    )
    anchors, rows = subset(rig, points)
    owned = tuple(_controls(rig, element) for element in layout.elements)
    if len(layout.base_values) != len(rig.controls):
        raise refuse(
            "LAYOUT_STALE",
            layout.root,
            "the base pose has another number of controls than the character",
        )
    base, still, still_base = posed(anchors, layout.base_values), anchors, None
    all_of = shared(rig, layout.elements)
    if all_of.carrier >= 0 and any(each.adapt == "static" for each in layout.elements):
        still, _ = subset(on_one_joint(rig, all_of.carrier), points)
        still_base = posed(still, layout.base_values)
    return Poser(
        rig,
        layout,
        anchors,
        rows,
        owned,
        tuple(following(rig, element, all_of) for element in layout.elements),
        base,
        still,
        still_base or base,
    )


def evaluate(poser: Poser, values: ArrayLike | None = None) -> PosedLayout:
    """Everything at control ``values`` (controls,), in the order of `Rig.controls`; None for the
    base pose.

    Raises RigUIError POSE_VALUE for values that are not finite or of another number.
    """
    at = checked_values(poser.rig, poser.layout.base_values if values is None else values)
    return PosedLayout(deform(poser.rig, at), elements_at(poser, at))


def elements_at(poser: Poser, values: Floats) -> tuple[PosedElement, ...]:
    """The elements of `evaluate` alone: no mesh is deformed but for the anchors."""
    known: dict[tuple[bool, bytes], Posed] = {}

    def anchors_at(rigid: bool, pose: Floats) -> Posed:
        """The anchors on their skin, or rigidly on one joint; all on the board ignore the same."""
        key = rigid, pose.tobytes()
        if key not in known:
            known[key] = posed(poser.still if rigid else poser.anchors, pose)
        return known[key]

    return tuple(_element(poser, i, anchors_at, values) for i in range(len(poser.rows)))


def values_of(rig: Rig, pose: Mapping[str, float], base: ArrayLike | None = None) -> Floats:
    """(controls,) values of a pose given by control names; the rest from `base`, or at their
    defaults.

    Raises RigUIError POSE_CONTROL for a name that the rig lacks, POSE_VALUE for what is not a
    number.
    """
    values = np.array(rig.defaults if base is None else base, dtype=np.float64)
    names = rig.control_indices
    for name, value in pose.items():
        if name not in names:
            what = f"the character has no control of this name{meant(str(name), names)}"
            raise refuse("POSE_CONTROL", name, what)
        values[names[name]] = _number(name, value)
    return checked_values(rig, values)


def _number(name: str, value: float) -> float:
    try:
        return float(value)
    except (TypeError, ValueError):
        raise refuse("POSE_VALUE", name, f"{value!r} is not a number") from None


def checked_values(rig: Rig, values: ArrayLike) -> Floats:
    """``values`` as (controls,) floats; raises RigUIError POSE_VALUE for a wrong number or NaN."""
    at = np.array(values, dtype=np.float64)
    if at.shape != (len(rig.controls),):
        raise refuse(
            "POSE_VALUE",
            rig.path,
            f"a pose has {len(rig.controls)} values, not {at.shape}",
        )
    if not np.isfinite(at).all():
        name = rig.control_names[int(np.flatnonzero(~np.isfinite(at))[0])]
        raise refuse("POSE_VALUE", name, "the value is not finite")
    return at


def _element(
    poser: Poser, index: int, anchors_at: Callable[[bool, Floats], Posed], values: Floats
) -> PosedElement:
    element, row = poser.layout.elements[index], int(poser.rows[index])
    follows, base_values = poser.followings[index], poser.layout.base_values
    rigid = follows.joint >= 0
    skin, before = (poser.still, poser.still_base) if rigid else (poser.anchors, poser.base)
    without = values.copy()
    without[follows.held] = base_values[follows.held]
    whole, others = anchors_at(rigid, values), anchors_at(rigid, without)
    base = before.points[row]
    anchor, carry = _carried(before.map_of(skin.body, row), others.map_of(skin.body, row), base)
    if follows.deforms:
        anchor = others.points[row]
    tracks = tuple(carried(member.track, base, anchor, carry) for member in element.members)
    owned = poser.owned[index]
    rest, handle = slid(
        [member.values for member in element.members],
        tracks,
        base_values[owned].tolist(),
        values[owned].tolist(),
    )
    if follows.deforms:
        handle = whole.points[row]
    glyph = np.zeros((0, 3))
    if element.glyph is not None:
        held = (
            _carried(before.map_of(skin.body, row), whole.map_of(skin.body, row), base)[1]
            if follows.deforms
            else carry
        )
        glyph = handle + element.glyph.points @ held
    normal = facing(element.anchor.normal, carry)
    return PosedElement(element.name, tracks, handle, rest, normal, glyph)


def _carried(before: Floats, now: Floats, position: Floats) -> tuple[Floats, Floats]:
    """Where a position goes with its map (4, 3) alone, and the (3, 3) map of offsets from it (row
    vectors)."""
    carry = np.linalg.pinv(before[:3]) @ now[:3]
    return (position - before[3]) @ carry + now[3], carry


# --- matching -------------------------------------------------------------------------------------


def _anchor_point(body: Body, element: Element) -> int:
    """The point that an element is anchored at."""
    anchor = element.anchor
    point = anchor.on(body)
    if point >= 0 and anchor.fits(body.by_path[anchor.mesh].topology.hash):
        return point
    what = f"its topology is not that which {element.name} is anchored to"
    if anchor.mesh not in body.by_path:
        what = f"the mesh that {element.name} is anchored to does not exist"
    raise refuse("LAYOUT_STALE", anchor.mesh, what)


def _controls(rig: Rig, element: Element) -> Indices:
    for member in element.members:
        if member.control not in rig.control_indices:
            raise refuse(
                "LAYOUT_STALE", member.control, f"the control of {element.name} does not exist"
            )
    return controls_of(rig, element)


# --- elements that do not deform ------------------------------------------------------------------


def on_one_joint(rig: Rig, joint: int) -> Rig:
    """The rig with all skinned meshes rigidly on one joint, as in the written layer."""
    return replace(
        rig, body=replace(rig.body, meshes=tuple(_rigid(mesh, joint) for mesh in rig.body.meshes))
    )


def _rigid(mesh: RigMesh, joint: int) -> RigMesh:
    if mesh.skin is None:
        return mesh
    count = len(mesh.points)
    skin = replace(
        mesh.skin,
        joints=np.full((count, 1), joint),
        weights=np.ones((count, 1)),
        rigid=True,
    )
    return replace(mesh, skin=skin)
