"""Whether a layout does what it shows: its controls, evaluated on the character, take the anchors
along the tracks, and what is drawn goes with them.

One law for `usdrigui check`, the validators and the tests.  The character and the meshes that draw
the layout are posed by what the layer itself says that its controls drive: each control by itself
along its track, then all of them half way together.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from functools import cached_property

import numpy as np
from pxr import Usd, UsdGeom

from usdrigui.character import Body, Flags, Floats, Indices, Record, Rig
from usdrigui.character.deform import Posed, posed, sweep, sweep_start
from usdrigui.character.skinning import with_descendants
from usdrigui.character.subset import subset
from usdrigui.character.surface import mesh_triangles, vertex_normals, weld
from usdrigui.errors import Issue, issue
from usdrigui.layer import author
from usdrigui.layer.properties import value_of
from usdrigui.layer.read_controls import invalid_at, read_controls
from usdrigui.layer.read_layout import base_controls, element_prims, points_by_role
from usdrigui.model import Element, Layout, Member
from usdrigui.overlap import segment_distances
from usdrigui.reading.character import read_animated
from usdrigui.settings import ReadSettings
from usdrigui.stages import schema

_FOLLOWS, _EXACT = 1e-5, 0.01
"""Of the size of the meshes with anchors, and of a handle's width: handles follow their anchors as
closely as both together."""
_NEAR = 0.03
"""Of a handle's width: the same for what is anywhere else than the anchor in a handle, and for
handles that are at their anchor in the base pose."""
_STILL = 0.5
"""Of a handle's width: tracks follow the skin so closely."""
_BESIDE, _LONG = 0.5, 0.2
"""Of a handle's width and of a track's length: a drawn track passes its points by less than both
together."""
_ALONG, _SHARE = 0.05, 0.08
"""Of a handle's width, and of the way that a control takes its anchor: tracks differ from the
anchor's way by less than both together."""
_SIZES = 4.0
"""Times as wide or narrow as the layout says may be what draws a handle."""
CLEAR = 0.5
"""Cosine beyond which two directions are one, or opposite."""
_HALF = 0.5
"""Of its range: so far every control is from the base pose where all are."""
_NONE: Indices = np.zeros(0, dtype=np.int64)


class _Drawn(Record):
    """An element with the points that count, as rows of `_Scene.rig`."""

    prim: Usd.Prim
    element: Element
    width: float
    """Of its handle."""
    anchor: int
    handle: Indices
    track: Indices
    """Of its tracks, and of the areas between them."""
    line: Indices
    """Of its tracks alone."""
    members: Indices
    """Its controls, as indices into `Rig.controls`."""

    @property
    def rows(self) -> Indices:
        """Of everything drawn."""
        return np.concatenate([self.handle, self.track])

    @property
    def slides(self) -> bool:
        """Whether its handle goes along the track by itself, rather than with the skin."""
        return self.element.anchor.on_board or self.element.adapt == "static"


class _Scene(Record):
    """The points of a character and of a layout that count, ready to be posed."""

    rig: Rig
    drawn: tuple[_Drawn, ...]
    base_values: Floats
    size: float
    """Diagonal of the box around the meshes that elements are anchored to."""

    @cached_property
    def grain(self) -> float:
        """How exactly the layer and UsdSkel tell places and ways: far from the origin, little."""
        return _FOLLOWS * self.size + author.TOLD * float(np.abs(self.base.points).max(initial=0.0))

    @cached_property
    def base(self) -> Posed:
        return posed(self.rig, self.base_values)

    def carrying(self, at: Posed, point: int) -> Floats:
        """(4, 3) map of a point from its mesh to the space of the SkelRoot."""
        mesh, local = self.rig.body.mesh_of(point)
        maps = at.maps[mesh]
        return np.asarray(maps[local if len(maps) > 1 else 0])

    def with_ignored(self, controls: Collection[int], anchors: Iterable[int]) -> list[int]:
        """Some controls, and all that what ignores these cannot follow: those that move joints
        which they carry, as it hangs on the joints above, or joints above some influences of the
        `anchors` and not above all; where they turn joints, those of shapes, as what these do turns
        along the track; and those that share a weight with them, such as poses, as a weight has one
        value (docs/decisions/051)."""
        drives = [control.drive for control in self.rig.controls]
        turned = [joint for control in controls for joint in drives[control].joints]
        weighed = {channel for control in controls for channel in drives[control].channels}
        carried = with_descendants(self.rig.body.joints, np.array(turned, dtype=np.int64))
        if turned:
            for point in anchors:
                above = self._above[:, self._influences(point)]
                carried |= above.any(axis=1) & ~above.all(axis=1)
        return [
            index
            for index, drive in enumerate(drives)
            if index in controls
            or carried[drive.joints].any()
            or not weighed.isdisjoint(drive.channels)
            or (turned and len(drive.channels))
        ]

    @cached_property
    def _above(self) -> Flags:
        """(joints, joints) which joints each moves: itself, and those below it."""
        joints = self.rig.body.joints
        return np.array([with_descendants(joints, np.array([i])) for i in range(len(joints))])

    def _influences(self, point: int) -> Indices:
        """The joints that move a point."""
        mesh, local = self.rig.body.mesh_of(point)
        skin = self.rig.body.meshes[mesh].skin
        return _NONE if skin is None else skin.joints[local][skin.weights[local] != 0.0]

    def halfway(self, towards: str, but: list[int]) -> Floats:
        """Values (controls,) of a pose: every control half way from the base pose to its
        ``minimum`` or ``maximum``, those of `but` at the base pose."""
        ends = np.array([getattr(each, towards) for each in self.rig.controls])
        values = self.base_values + _HALF * (ends - self.base_values)
        values[but] = self.base_values[but]
        return np.asarray(values)


def disagreements(scope: Usd.Prim, layout: Layout, settings: ReadSettings) -> Iterator[Issue]:
    """LAYOUT_MESH_GONE, LAYOUT_TOPOLOGY and LAYOUT_INVALID of what cannot be evaluated,
    LAYOUT_TRACK of controls that take their anchor elsewhere than their track shows, and
    LAYOUT_DRAWN of what is drawn and does not go along."""
    found: list[Issue] = []
    stage = scope.GetStage()
    anchored = dict.fromkeys(each.anchor.mesh for each in layout.elements if each.anchor.mesh)
    meshes = [each for each in map(stage.GetPrimAtPath, anchored) if each and each.IsActive()]
    body = read_animated(scope.GetParent(), settings, [*meshes, *drawings(scope)]).body
    scene = _scene(scope, layout, body, found)
    yield from found
    if scene is None:
        return
    for each in scene.drawn:
        yield from _at_rest(scene, each)
        for member, control in zip(each.element.members, each.members, strict=True):
            yield from _alone(scene, each, member, int(control))
    yield from _together(scene)


# --- one element ----------------------------------------------------------------------------------


def _at_rest(scene: _Scene, drawn: _Drawn) -> Iterator[Issue]:
    """What is wrong with an element in the base pose."""
    element, points, width = drawn.element, scene.base.points, drawn.width
    handle = points[drawn.handle]
    if element.glyph is None:
        yield from _as_wide(drawn, handle, scene.grain)
        away = _worst(handle[:1] - element.anchor.position)
        if away > scene.grain + _NEAR * width:
            yield _astray(drawn.prim, f"its handle is {away:.3g} from rigUI:anchor:position")
    tracks = [member.track for member in element.members]
    beside = scene.grain + _BESIDE * width + _LONG * max(map(length, tracks))
    ways = points[drawn.track]
    if len(ways):
        pieces = ((track[:-1, :, None], track[1:, :, None]) for track in tracks)
        apart = np.concatenate([segment_distances(ways.T[None], *each) for each in pieces])
        ends = np.concatenate([track[[0, -1]] for track in tracks])
        short = np.linalg.norm(ends[:, None] - points[drawn.line], axis=2)
        # Lifted over an arch, a straight track is off its ends by as much again.
        away = max(apart.min(axis=0).max(), 0.5 * short.min(axis=1, initial=np.inf).max())
        if away > beside:
            yield _astray(drawn.prim, f"its tracks are drawn {away:.3g} from their trackPoints")


def _as_wide(drawn: _Drawn, handle: Floats, grain: float) -> Iterator[Issue]:
    """Whether a handle (points, 3), its first point at the anchor, is as large as the layout says,
    and lifted as far."""
    if len(handle) < 2:
        return
    shell, width = handle[1:], drawn.width
    across = _worst(np.ptp(shell, axis=0))
    if not width / _SIZES - grain < across < width * _SIZES + grain:
        yield _astray(drawn.prim, f"its handle is {across:.3g} wide, the layout's {width:.3g}")
    middle = _worst(shell.mean(axis=0) - handle[0])
    if abs(middle - value_of(drawn.prim, schema.HANDLE, "lift")) > width + grain:
        yield _astray(
            drawn.prim, f"its handle is {middle:.3g} from its anchor, not rigUI:handle:lift"
        )


def _alone(scene: _Scene, drawn: _Drawn, member: Member, control: int) -> Iterator[Issue]:
    """What is wrong with an element while one of its controls goes along its track."""
    values = np.append(scene.base_values[control], member.values)
    start, _ = sweep_start(scene.rig, scene.base, scene.base_values, control)
    moved, offsets = sweep(scene.rig, start, control, values)
    motion = np.zeros((len(values) - 1, len(scene.base.points), 3))
    motion[:, moved] = offsets[1:] - offsets[0]
    track = np.stack([np.interp(values, member.values, axis) for axis in member.track.T], axis=1)
    along = track[1:] - track[0]
    drive = scene.rig.controls[control].drive
    anchor, steps = motion[:, drawn.anchor], f"as {member.control!r} goes along its track"
    handle = motion[:, drawn.handle]
    tolerance = scene.grain + _EXACT * drawn.width
    if drawn.slides:
        single = len(drive.channels) == 1 and not len(drive.joints)
        expected, slack = along if single else np.zeros_like(along), _NEAR * drawn.width + tolerance
        if _worst(handle - expected[:, None]) > slack:
            yield _astray(drawn.prim, f"its handle does not go along it, {steps}")
        return
    off = _worst(along / member.magnification - anchor)
    if off > scene.grain + _ALONG * drawn.width + _SHARE * _worst(anchor):
        clause = f"{off:.3g} from rigUI:control:*:trackPoints, {steps}"
        yield issue("LAYOUT_TRACK", drawn.prim.GetPath(), f"its anchor is up to {clause}")
    away = _worst(handle[:, :1] - anchor[:, None])
    if drawn.element.glyph is None and away > tolerance:
        yield _astray(drawn.prim, f"its handle leaves its anchor by {away:.3g}, {steps}")
    if _worst(motion[:, drawn.track]) > scene.grain + _STILL * drawn.width:
        yield _astray(drawn.prim, f"its tracks move, {steps}")


def _together(scene: _Scene) -> Iterator[Issue]:
    """What does not follow the character while many controls are away from the base pose."""
    told: set[int] = set()
    on_board = [each for each in scene.drawn if each.element.anchor.on_board]
    board = {control for each in on_board for control in each.members.tolist()}
    anchors = [each.anchor for each in on_board]
    for towards in ("maximum", "minimum"):
        whole = posed(scene.rig, scene.halfway(towards, []))
        still = posed(scene.rig, scene.halfway(towards, scene.with_ignored(board, anchors)))
        for index, each in enumerate(scene.drawn):
            if index in told:
                continue
            for what, off, slack in _departures(scene, each, towards, whole, still):
                if off > scene.grain + slack:
                    clause = f"its {what} leaves the character by {off:.3g}"
                    yield _astray(
                        each.prim, f"{clause} as all controls go half way to their {towards}"
                    )
                    told.add(index)
                    break


def _departures(
    scene: _Scene, drawn: _Drawn, towards: str, whole: Posed, still: Posed
) -> Iterator[tuple[str, float, float]]:
    """What is drawn, how far it leaves the character, and how far it may, where all controls are
    half way (`whole`), or all but those of the board (`still`)."""
    loose = _STILL * drawn.width
    if drawn.element.anchor.on_board:
        yield "drawing", _off(scene, drawn, still, drawn.rows), loose
        return
    if drawn.slides:
        # No shape moves it; joints may.
        turning = [i for i, each in enumerate(scene.rig.controls) if len(each.drive.joints)]
        shaped = posed(scene.rig, scene.halfway(towards, [*drawn.members, *turning]))
        yield "drawing", _worst((shaped.points - scene.base.points)[drawn.rows]), loose
        return
    yield "handle", _off(scene, drawn, whole, drawn.handle[:1]), _EXACT * drawn.width
    yield "handle", _off(scene, drawn, whole, drawn.handle), loose
    ignored = scene.with_ignored(drawn.members, [drawn.anchor])
    others = posed(scene.rig, scene.halfway(towards, ignored))
    yield "track", _off(scene, drawn, others, drawn.track), loose


def _off(scene: _Scene, drawn: _Drawn, at: Posed, rows: Indices) -> float:
    """How far points are from where the skin at the anchor takes them; on the board, its joints
    alone."""
    before, now = (scene.carrying(each, drawn.anchor) for each in (scene.base, at))
    carry, points = np.linalg.pinv(before[:3]) @ now[:3], scene.base.points
    start, end = points[drawn.anchor], at.points[drawn.anchor]
    if drawn.element.anchor.on_board:
        start, end = before[3], now[3]
    return _worst(at.points[rows] - end - (points[rows] - start) @ carry)


def _astray(prim: Usd.Prim, message: str) -> Issue:
    return issue("LAYOUT_DRAWN", prim.GetPath(), message)


def _worst(vectors: Floats) -> float:
    return float(np.linalg.norm(vectors, axis=-1).max(initial=0.0))


def length(line: Floats) -> float:
    """Of a polyline (k, 3)."""
    return float(np.linalg.norm(np.diff(line, axis=0), axis=1).sum())


# --- the scene ------------------------------------------------------------------------------------


def drawings(scope: Usd.Prim) -> list[Usd.Prim]:
    """The meshes that draw a layout."""
    return [mesh for mesh in scope.GetAllChildren() if mesh.IsA(UsdGeom.Mesh)]


def _scene(scope: Usd.Prim, layout: Layout, body: Body, found: list[Issue]) -> _Scene | None:
    """None where nothing can be evaluated; `found` takes what is not as the character has it."""
    prims = element_prims(scope)
    drawing = {mesh: body.point_of(str(mesh.GetPath()), 0) for mesh in drawings(scope)}
    topologies = {mesh.path: (mesh.topology.hash, len(mesh.points)) for mesh in body.meshes}
    found += [
        invalid_at(mesh, "its arrays contradict each other: it draws nothing")
        for mesh, start in drawing.items()
        if start < 0
    ]
    rig, drawn = read_controls(scope, prims, body, found), []
    for prim, element in zip(prims, layout.elements, strict=True):
        members = [member.control for member in element.members]
        anchor = element.anchor
        known, count = topologies.get(anchor.mesh, ("gone", 0))
        point = body.point_of(anchor.mesh, anchor.point)
        if not count:
            found.append(layout.mesh_gone(anchor.mesh))
        elif change := anchor.mesh_change(known, count):
            found.append(issue("LAYOUT_TOPOLOGY", element.name, change))
        elif anchor.point_count not in (0, count):
            found.append(invalid_at(prim, f"rigUI:anchor:pointCount is not {count}"))
        elif point >= 0 and rig.control_names >= {*members}:
            drawn.append(
                _Drawn(
                    prim,
                    element,
                    layout.frame.handle_width_of(element.part),
                    point,
                    _rows(drawing, prim, "handle"),
                    _rows(drawing, prim, "track", "area"),
                    _rows(drawing, prim, "track"),
                    np.array([rig.control_indices[name] for name in members]),
                )
            )
    if not drawn:
        return None
    base = dict(zip(base_controls(scope), layout.base_values.tolist(), strict=True))
    values = np.array([base.get(control.name, control.default) for control in rig.controls])
    found += _facing(rig, posed(rig, values), drawn)
    rows = np.unique(np.concatenate([[each.anchor, *each.rows] for each in drawn]).astype(np.int64))
    drawn = [
        replace(
            each,
            anchor=int(np.searchsorted(rows, each.anchor)),
            handle=np.searchsorted(rows, each.handle),
            track=np.searchsorted(rows, each.track),
            line=np.searchsorted(rows, each.line),
        )
        for each in drawn
    ]
    size = max(_worst(np.ptp(mesh.points, axis=0)) for mesh in body.meshes)
    return _Scene(subset(rig, rows)[0], tuple(drawn), values, size)


def _facing(rig: Rig, base: Posed, drawn: list[_Drawn]) -> Iterator[Issue]:
    """Whether elements on the skin face as it does, inwards or outwards: where surfaces coincide,
    what is seen may be either side."""
    apart = np.ones((len(base.points), 1))
    apart[np.concatenate([each.rows for each in drawn])] = 0.0
    # The first point of a handle is where the skin's is.
    places = weld(base.points, apart)
    normals = vertex_normals(base.points, mesh_triangles(rig.body.meshes), places)
    for each in drawn:
        normal, there = each.element.anchor.normal, normals[each.anchor]
        along = abs(there @ normal) >= CLEAR * (there.any() and normal.any())
        if not (each.element.anchor.on_board or along):
            yield invalid_at(each.prim, "rigUI:anchor:normal is not that of its mesh")


def _rows(drawing: dict[Usd.Prim, int], prim: Usd.Prim, *roles: str) -> Indices:
    """Points of the body that draw an element in some roles, in all meshes."""
    found = [_NONE]
    for mesh, start in drawing.items():
        part = mesh.GetChild(prim.GetName())
        if start >= 0 and part and part.IsA(UsdGeom.Subset):
            found.append(start + points_by_role(part, *roles))
    return np.concatenate(found)
