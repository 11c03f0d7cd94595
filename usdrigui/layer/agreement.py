"""Whether a layout does what it shows: its controls, evaluated on the character, take the anchors
along the tracks, and what is drawn goes with them.

One law for `usdrigui check`, the validators and the tests.  The character and the meshes that draw
the layout are posed by what the layer itself says that its controls drive: each control by itself
along its track, then all of them half way together.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import islice, pairwise

import numpy as np
from pxr import Usd, UsdGeom

from usdrigui.character import Body, Control, Floats, Indices, Record, Rig
from usdrigui.character.deform import Posed, posed, sweep, sweep_start
from usdrigui.character.skinning import descendants
from usdrigui.character.subset import subset
from usdrigui.character.surface import mesh_triangles, vertex_normals, weld
from usdrigui.errors import Issue, issue
from usdrigui.following import controls_of
from usdrigui.layer import author
from usdrigui.layer.control_api import slides
from usdrigui.layer.properties import value_of
from usdrigui.layer.read_controls import doubtful_at, invalid_at, read_controls
from usdrigui.layer.read_layout import element_prims, faces_by_role, points_of
from usdrigui.layer.skin_binding import influences
from usdrigui.model import Element, Layout, Member
from usdrigui.overlap import segment_distances
from usdrigui.reading.character import read_animated
from usdrigui.reading.mesh import drawable
from usdrigui.reading.range import limits_of
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
_SIZES = 1.5
"""Times as large or small as the layout says may be what is measured of it: the way of a half turn
is so much longer than a track of two points."""
_AGREE = 1.02
"""The same of lengths that the layer says twice."""
_TURNED = 2e-3
"""Radians for a degree of a control: so far may the turn of the character's own differ."""
_LIFTED = 0.15
"""Of a handle's width: so far from its lift may the middle of a handle be."""
CLEAR = 0.5
"""Cosine beyond which two directions are one, or opposite."""
_PIECES = 4
"""Of each step of a straight track: joints take points along arcs, a whole turn at most."""
_HALF = 0.5
"""Of its range: so far every control is from the base pose where all are."""


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
    lines: tuple[Indices, ...]
    """Of each of its tracks, face by face."""
    members: Indices
    """Its controls, as indices into `Rig.controls`."""

    @property
    def drawn(self) -> Indices:
        """Of everything drawn."""
        return np.concatenate([self.handle, self.track])

    @property
    def rows(self) -> Indices:
        """Of everything that counts."""
        return np.append(self.drawn, self.anchor)

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
    """Diagonal of the largest box around one of the meshes that draw elements, or that elements are
    anchored to."""

    @cached_property
    def grain(self) -> float:
        """How exactly the layer and UsdSkel tell places and ways: far from the origin, little."""
        far = np.abs(self.base.points[self.uses > 0]).max(initial=0.0)
        return _FOLLOWS * self.size + 2.0 * author.TOLD * float(far)

    @cached_property
    def uses(self) -> Floats:
        """(points,) how many handles and tracks draw each; none those of the character."""
        drawn = np.concatenate([each.drawn for each in self.drawn])
        return np.bincount(drawn, minlength=len(self.base.points)).astype(np.float64)

    @cached_property
    def base(self) -> Posed:
        return posed(self.rig, self.base_values)

    def with_ignored(self, controls: Collection[int], anchors: Iterable[int]) -> list[int]:
        """Some controls, and all that what ignores these cannot follow: those that move joints
        which they carry, as it hangs on the joints above, or joints above some influences of the
        `anchors` and not above all; where they turn joints, those of shapes, as what these do turns
        along the track; and those that share a weight with them, such as poses, as a weight has one
        value (docs/decisions/051)."""
        drives = [control.drive for control in self.rig.controls]
        turned = [joint for control in controls for joint in drives[control].joints]
        weighed = {channel for control in controls for channel in drives[control].channels}
        moved_by = descendants(self.rig.body.joints)
        carried = np.asarray(moved_by[turned].any(axis=0))
        if turned:
            for point in anchors:
                mesh, local = self.rig.body.mesh_of(point)
                above = moved_by[:, influences(mesh.skin, local)[0]]
                carried |= above.any(axis=1) & ~above.all(axis=1)
        return [
            index
            for index, drive in enumerate(drives)
            if index in controls
            or carried[drive.joints].any()
            or not weighed.isdisjoint(drive.channels)
            or (turned and len(drive.channels))
        ]

    def halfway(self, towards: str, but: list[int]) -> Floats:
        """Values (controls,) of a pose: every control half way from the base pose to its
        ``minimum`` or ``maximum``, those of `but` at the base pose."""
        ends = np.array([getattr(each, towards) for each in self.rig.controls])
        values = self.base_values + _HALF * (ends - self.base_values)
        values[but] = self.base_values[but]
        return values


def disagreements(
    scope: Usd.Prim, layout: Layout, settings: ReadSettings, known: Mapping[str, Control]
) -> Iterator[Issue]:
    """LAYOUT_MESH_GONE, LAYOUT_TOPOLOGY and LAYOUT_INVALID of what cannot be evaluated,
    LAYOUT_TRACK of controls that take their anchor elsewhere than their track shows, and
    LAYOUT_DRAWN of what is drawn and does not go along.

    `known` are the controls that the character has today, by their names, where it was read.
    """
    found, root = list[Issue](), scope.GetParent()
    animated = read_animated(root, settings, [*drawable(root), *drawings(scope)])
    scene = _scene(scope, layout, animated.body, found)
    for armature in animated.armatures:
        limits_of(armature, found)
    yield from found
    if scene is None:
        return
    for each in scene.drawn:
        yield from _at_rest(scene, each)
        for member, control in zip(each.element.members, each.members, strict=True):
            yield from _alone(scene, each, member, int(control))
            own = scene.rig.controls[control]
            today = known.get(own.name, own)
            # On the board no track shows what a control does.
            if own.kind == "joint" and _worst(own.drive.turn - today.drive.turn) > _TURNED:
                what = f"{own.name!r} turns its joints otherwise than the character"
                yield doubtful_at(each.prim, what)
    yield from _facing(scene)
    yield from _together(_thinned(scene))


# --- one element ----------------------------------------------------------------------------------


def _at_rest(scene: _Scene, drawn: _Drawn) -> Iterator[Issue]:
    """What is wrong with an element in the base pose."""
    element, points, width = drawn.element, scene.base.points, drawn.width
    handle = points[drawn.handle]
    if (scene.uses[drawn.drawn] > 1).any():
        yield _astray(drawn.prim, "faces of its handle, of its tracks or of others share points")
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
        away = apart.min(axis=0).max()
        ends = np.stack([track[end] for end in (-1, 0) for track in tracks])
        exchanged = len(tracks) != len(drawn.lines)
        for i, (track, line) in enumerate(zip(tracks, drawn.lines, strict=False)):
            tip = np.linalg.norm(ends - _tip(points, line), axis=1)
            start = np.linalg.norm(points[line[:4]] - track[0], axis=1).min()
            # Lifted over an arch, a straight track is off its ends by as much again.
            away = max(away, 0.5 * tip[i], 0.5 * start)
            exchanged |= tip[i] >= tip.min() + 0.5 * beside
        if away > beside:
            yield _astray(drawn.prim, f"its tracks are drawn {away:.3g} from their trackPoints")
        if exchanged:
            yield _astray(drawn.prim, "a track that is drawn ends where another's trackPoints do")


def _tip(points: Floats, line: Indices) -> Floats:
    """(3,) where a drawn track ends: of its last triangle the corner that no other face has; if
    that is all of it, the one farthest from its middle."""
    last = points[line[-3:]]
    apart = np.linalg.norm(last - last.mean(axis=0), axis=1)
    tip: Floats = last[(apart * ~np.isin(line[-3:], line[:-3])).argmax()]
    return tip


def _as_wide(drawn: _Drawn, handle: Floats, grain: float) -> Iterator[Issue]:
    """Whether a handle (points, 3), its first point at the anchor, is as large as the layout says,
    and lifted as far."""
    if len(handle) < 2:
        return
    middle, width = handle[1:].mean(axis=0), drawn.width
    across, lifted = 2.0 * _worst(handle[1:] - middle), middle - handle[0]
    if not width / _SIZES - grain < across < width * _SIZES + grain:
        yield _astray(drawn.prim, f"its handle is {across:.3g} wide, the layout's {width:.3g}")
    lift = value_of(drawn.prim, schema.HANDLE, "lift")
    loose = _LIFTED * width + grain
    if abs(_worst(lifted) - lift) > loose or lifted @ drawn.element.anchor.normal < -loose:
        what = f"its handle is {_worst(lifted):.3g} from its anchor, along the normal"
        yield _astray(drawn.prim, f"{what} and rigUI:handle:lift is {lift:.3g}")


def _alone(scene: _Scene, drawn: _Drawn, member: Member, control: int) -> Iterator[Issue]:
    """What is wrong with an element while one of its controls goes along its track."""
    subject = scene.rig.controls[control]
    start, now = sweep_start(scene.rig, scene.base, scene.base_values, control)
    pieces = _PIECES if drawn.element.anchor.on_board and len(subject.drive.joints) else 1
    steps = np.arange(pieces * (len(member.values) - 1) + 1)
    values = np.interp(steps, steps[::pieces], member.values)
    moved, offsets = sweep(scene.rig, start, control, [subject.default, now, *values])
    if _worst(offsets[0]) > scene.grain + _EXACT * drawn.width:
        what = f"rigUI:control:*:keys of {member.control!r} move the character at its default"
        yield invalid_at(drawn.prim, what)
    ways = np.linalg.norm(np.diff(offsets[2:], axis=0), axis=2).sum(axis=0)
    far = (ways * (scene.uses[moved] == 0)).max(initial=0.0)
    yield from _lengths(scene, drawn, member, subject.maximum - subject.minimum, far)
    motion = np.zeros((len(member.values), len(scene.base.points), 3))
    motion[:, moved] = offsets[2::pieces] - offsets[1]
    yield from _along(scene, drawn, member, motion, slides(scene.rig.body, subject.drive))


def _lengths(
    scene: _Scene, drawn: _Drawn, member: Member, span: float, far: float
) -> Iterator[Issue]:
    """Which lengths of a control are not those of its character, or of each other: `span` is that
    of its range, `far` that of the way of the point that it takes farthest."""
    peak, arc = member.peak, member.arc_length
    # On the skin an anchor may go less far than the farthest point.
    longest = arc if drawn.element.anchor.on_board else max(arc, peak)
    told = author.TOLD * np.abs(member.track).sum()
    blurred = told + scene.grain + _EXACT * drawn.width
    for name, said, found, times, slack in (
        ("peak", peak, far, _SIZES, blurred),
        ("trackValues", np.ptp(member.values), span, _SIZES, 0.0),
        ("arcLength", longest, peak or longest, _AGREE, 0.0),
        ("magnification", arc * member.magnification, length(member.track), _AGREE, told),
    ):
        if said and not found / times - slack <= said <= found * times + slack:
            what = f"rigUI:control:*:{name} of {member.control!r} would be {found / said:.3g} times"
            yield invalid_at(drawn.prim, f"{what} as much by its character, range, peak or track")


def _along(
    scene: _Scene, drawn: _Drawn, member: Member, motion: Floats, sliding: bool
) -> Iterator[Issue]:
    """What does not go as the track of a control, which passes the anchor: `motion` (k, points, 3)
    is that from the base pose to its places.  A handle that does not deform goes along if
    `sliding`, else stays."""
    along = member.track - drawn.element.anchor.position
    anchor, steps = motion[:, drawn.anchor], f"as {member.control!r} goes along its track"
    handle, width = motion[:, drawn.handle], drawn.width
    tolerance = scene.grain + _EXACT * width
    if drawn.slides:
        if _worst(handle - sliding * along[:, None]) > _NEAR * width + tolerance:
            yield _astray(drawn.prim, f"its handle does not go along it, {steps}")
        return
    off = _worst(along / member.magnification - anchor)
    if off > scene.grain + _ALONG * width + _SHARE * _worst(anchor):
        what = f"its anchor is up to {off:.3g} from rigUI:control:*:trackPoints, {steps}"
        yield issue("LAYOUT_TRACK", drawn.prim.GetPath(), what)
    away = _worst(handle[:, :1] - anchor[:, None])
    if drawn.element.glyph is None and away > tolerance:
        yield _astray(drawn.prim, f"its handle leaves its anchor by {away:.3g}, {steps}")
    if _worst(motion[:, drawn.track]) > scene.grain + _STILL * width:
        yield _astray(drawn.prim, f"its tracks move, {steps}")


def _together(scene: _Scene) -> Iterator[Issue]:
    """What does not follow the character while many controls are away from the base pose."""
    on_board = [each for each in scene.drawn if each.element.anchor.on_board]
    board = {control for each in on_board for control in each.members.tolist()}
    ignored = scene.with_ignored(board, [each.anchor for each in on_board])
    poses = {
        towards: [posed(scene.rig, scene.halfway(towards, but)) for but in ([], ignored)]
        for towards in ("maximum", "minimum")
    }
    for each in scene.drawn:
        astray = (
            f"its {what} leaves the character by {off:.3g} as all controls go half way to their"
            f" {towards}"
            for towards, pose in poses.items()
            for what, off, slack in _departures(scene, each, towards, *pose)
            if off > scene.grain + slack
        )
        for first in islice(astray, 1):
            yield _astray(each.prim, first)


def _departures(
    scene: _Scene, drawn: _Drawn, towards: str, whole: Posed, still: Posed
) -> Iterator[tuple[str, float, float]]:
    """What is drawn, how far it leaves the character, and how far it may, where all controls are
    half way (`whole`), or all but those of the board (`still`)."""
    loose = _STILL * drawn.width
    if drawn.element.anchor.on_board:
        yield "drawing", _off(scene, drawn, still, drawn.drawn), loose
        return
    if drawn.slides:
        # No shape moves it; joints may.
        turning = [i for i, each in enumerate(scene.rig.controls) if len(each.drive.joints)]
        shaped = posed(scene.rig, scene.halfway(towards, [*drawn.members, *turning]))
        yield "drawing", _worst((shaped.points - scene.base.points)[drawn.drawn]), loose
        return
    yield "handle", _off(scene, drawn, whole, drawn.handle[:1]), _EXACT * drawn.width
    yield "handle", _off(scene, drawn, whole, drawn.handle), loose
    ignored = scene.with_ignored(drawn.members, [drawn.anchor])
    others = posed(scene.rig, scene.halfway(towards, ignored))
    yield "track", _off(scene, drawn, others, drawn.track), loose


def _off(scene: _Scene, drawn: _Drawn, at: Posed, rows: Indices) -> float:
    """How far points are from where the skin at the anchor takes them; on the board, its joints
    alone."""
    before, now = (each.map_of(scene.rig.body, drawn.anchor) for each in (scene.base, at))
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
    for mesh, start in drawing.items():
        if start < 0:
            found.append(invalid_at(mesh, "its arrays contradict each other: it draws nothing"))
    rig, drawn = read_controls(scope, prims, body, found), []
    for prim, element in zip(prims, layout.elements, strict=True):
        anchor, held = element.anchor, body.by_path.get(element.anchor.mesh)
        point = anchor.on(body)
        if held is None:
            found.append(layout.mesh_gone(anchor.mesh))
        elif change := anchor.mesh_change(held.topology.hash, len(held.points)):
            found.append(issue("LAYOUT_TOPOLOGY", element.name, change))
        elif anchor.point_count not in (0, len(held.points)):
            found.append(invalid_at(prim, f"rigUI:anchor:pointCount is not {len(held.points)}"))
        elif point >= 0 and element.controls.issubset(rig.control_names):
            drawn.append(
                _Drawn(
                    prim,
                    element,
                    layout.frame.handle_width_of(element.part),
                    point,
                    points_of(_faces(drawing, prim, "handle")),
                    points_of(_faces(drawing, prim, "track", "area")),
                    _lines(drawing, prim),
                    controls_of(rig, element),
                )
            )
    if not drawn:
        return None
    base = dict(zip(layout.listed, layout.base_values.tolist(), strict=True))
    values = np.array([base.get(control.name, control.default) for control in rig.controls])
    near = {each.element.anchor.mesh for each in drawn} | {str(each.GetPath()) for each in drawing}
    size = max(_worst(np.ptp(mesh.points, axis=0)) for mesh in body.meshes if mesh.path in near)
    return _Scene(rig, tuple(drawn), values, size)


def _thinned(scene: _Scene) -> _Scene:
    """The scene with those points alone that count for an element."""

    rows = np.unique(np.concatenate([each.rows for each in scene.drawn]))
    drawn = (
        replace(
            each,
            anchor=int(np.searchsorted(rows, each.anchor)),
            handle=np.searchsorted(rows, each.handle),
            track=np.searchsorted(rows, each.track),
        )
        for each in scene.drawn
    )
    return replace(scene, rig=subset(scene.rig, rows)[0], drawn=tuple(drawn))


def _facing(scene: _Scene) -> Iterator[Issue]:
    """Whether elements on the skin face as it does, inwards or outwards: where surfaces coincide,
    what is seen may be either side."""
    # The first point of a handle is where the skin's is.
    places = weld(scene.base.points, scene.uses[:, None])
    normals = vertex_normals(scene.base.points, mesh_triangles(scene.rig.body.meshes), places)
    for each in scene.drawn:
        normal, there = each.element.anchor.normal, normals[each.anchor]
        along = abs(there @ normal) >= CLEAR * (there.any() and normal.any())
        if not (each.element.anchor.on_board or along):
            yield invalid_at(each.prim, "rigUI:anchor:normal is not that of its mesh")


def _lines(drawing: dict[Usd.Prim, int], prim: Usd.Prim) -> tuple[Indices, ...]:
    """Points of the body that draw each track of an element, face by face; a triangle ends it."""
    faces = [*_faces(drawing, prim, "track")]
    ends = [i for i, face in enumerate(faces, 1) if len(face) == 3]
    return tuple(np.concatenate(faces[first:last]) for first, last in pairwise([0, *ends]))


def _faces(drawing: dict[Usd.Prim, int], prim: Usd.Prim, *roles: str) -> Iterator[Indices]:
    """The points of the body of each face that draws an element in some roles, in all meshes."""
    for mesh, start in drawing.items():
        part = mesh.GetChild(prim.GetName())
        if start >= 0 and part and part.IsA(UsdGeom.Subset):
            yield from (start + face for face in faces_by_role(part, *roles))
