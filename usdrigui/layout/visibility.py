"""From where a layout is judged, and what can be seen from there (paper section 3.3, occlusion)."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Flags, Floats, Indices, Record, Rig
from usdrigui.character.joint_tree import unit
from usdrigui.character.rays import AROUND, Caster, blocked, hidden_share, make_caster, visible_from
from usdrigui.character.surface import mesh_triangles
from usdrigui.layout.shares import HARDLY_ANY, NOTHING
from usdrigui.layout.symmetry.front import front, seen_from, three_quarter
from usdrigui.model import BaseSurface, MirrorPlane, Trajectories
from usdrigui.settings import CandidateSettings, view_angles
from usdrigui.ties import first_largest

_EDGE_ON = 0.17
"""Cosine of the normal with the direction to the viewer below which a handle is seen edge-on."""
_RIM_SEEN = 3
_BACK = 0.2
"""Share of the most that is shown that it is worth to see the backs of hands, which curl away."""


class FaceFrame(Record):
    """The face's own frame: what is cast in it does not depend on where and how large the character
    is.

    Rays that graze an edge are decided by rounding; cast in scene coordinates, a turned or scaled
    character would get other candidates.
    """

    origin: Floats
    axes: Floats
    """(3, 3) rows: to the character's left, up, ahead."""
    unit: float

    def points(self, positions: Floats) -> Floats:
        """(..., 3) positions in the frame."""
        return (positions - self.origin) @ self.axes.T / self.unit

    def directions(self, vectors: Floats) -> Floats:
        """(..., 3) unit vectors in the frame."""
        return vectors @ self.axes.T


class Views(Record):
    """The directions from which a layout is judged, and the points seen from each at the base
    pose."""

    ahead: Floats
    """(3,) unit direction in which the face looks."""
    up: Floats
    directions: Floats
    """(v, 3) unit directions to the viewer; the first is the layout's own."""
    visible: Flags
    """(v, n)."""
    caster: Caster | None
    """Casts rays at the visible meshes, in the face's own frame; None when occlusion is switched
    off."""
    frame: FaceFrame

    @property
    def anywhere(self) -> Flags:
        """(n,) points that at least one view sees."""
        return np.asarray(self.visible.any(axis=0))

    @property
    def axes(self) -> Floats:
        """(3, 3) unit vectors to the right, up and to the viewer of the layout's own view."""
        return seen_from(self.directions[0], self.up, self.ahead)

    @property
    def screen(self) -> Floats:
        """(2, 3) unit vectors to the right and up as seen by the viewer of the layout's own
        view."""
        return self.axes[:2]

    def drawing_axes(self, flat: bool) -> Floats:
        """(d, 3) the axes along which drawn elements are measured: those of the screen where the
        layout is `flat`, else all three."""
        return self.screen if flat else self.axes

    def one_sided(self, normal: Floats) -> bool:
        """Whether the only view looks across the plane of symmetry, of which it may see one side
        only."""
        return len(self.directions) == 1 and abs(self.directions[0] @ normal) > NOTHING


def find_views(
    rig: Rig,
    trajectories: Trajectories,
    plane: MirrorPlane,
    settings: CandidateSettings,
    *,
    of_sides: bool = False,
) -> Views:
    """The views that `settings` name, and what they see.  Points of hidden meshes are seen from
    nowhere.  Raises CONFIG_VALUE for a view that cannot be understood.

    Without a name for it, a part `of_sides`, as hands are, is looked at from where the skin of its
    joints faces, each side by itself; and more views show what the usual ones hide of a joint.
    """
    up, surface = rig.up, trajectories.surface
    ahead = front(up, trajectories, plane.normal)
    directions = _directions(rig, settings.view, ahead)
    drawn = rig.body.drawn
    frame = _frame(surface, plane, ahead, up)
    if not settings.occlusion:
        return Views(ahead, up, directions, np.tile(drawn, (len(directions), 1)), None, frame)
    points = frame.points(surface.points)
    caster = make_caster(points[mesh_triangles(rig.body.meshes, visible_only=True)])
    around = _Around.of(trajectories, caster, frame, drawn)
    sides = [drawn] * len(directions)
    if not settings.view and of_sides and around.skins:
        left = plane.distance(surface.points) >= 0.0
        directions, sides = _mirrored(around.best(left), frame, plane), [left, ~left]
    seen = [around.seen(way) & side for way, side in zip(directions, sides, strict=False)]
    hidden = around.hidden(np.any(seen, axis=0))
    if not settings.view and hidden.any():
        more = _mirrored(around.best(hidden), frame, plane)
        directions = np.vstack([directions, more])
        seen += [around.seen(way) & hidden for way in more]
    return Views(ahead, up, directions, np.stack(seen), caster, frame)


def _mirrored(way: Floats, frame: FaceFrame, plane: MirrorPlane) -> Floats:
    """(v, 3) a direction in the face's own frame and, where there is a plane, its mirror image, in
    root space."""
    return np.stack([way, way * [-1.0, 1.0, 1.0]])[: 1 + bool(plane.normal.any())] @ frame.axes


class _Around(Record):
    """What is seen of the skin of joints from anywhere."""

    caster: Caster
    frame: FaceFrame
    points: Floats
    normals: Floats
    """(n, 3) in the face's own frame, as the others."""
    drawn: Flags
    skins: tuple[tuple[Indices, Floats], ...]
    """Of every control of a joint, the points that the joint owns and how much of the skin each
    is."""
    moved: Floats
    """(n, 3) how much further all controls go one way than the other, as fingers do that curl."""

    @classmethod
    def of(cls, found: Trajectories, caster: Caster, frame: FaceFrame, drawn: Flags) -> _Around:
        """Of the controls of joints among those `found`."""
        surface = found.surface
        moved, skins = np.zeros_like(surface.points), []
        for each in found.motions:
            own = each.on_own_skin()
            weight = surface.swept(own)
            if each.of_joint and weight.any():
                skins.append((own.points, weight / weight.sum()))
                moved[own.points] += own.offsets[[0, -1]].sum(axis=0)
        points, normals = frame.points(surface.points), frame.directions(surface.normals)
        return cls(caster, frame, points, normals, drawn, tuple(skins), frame.directions(moved))

    def seen(self, toward: Floats) -> Flags:
        """(n,) what is seen from a direction in root space."""
        way = self.frame.directions(toward)
        return visible_from(self.caster, self.points, self.normals, way) & self.drawn

    def best(self, among: Flags) -> Floats:
        """The direction that shows most of the skins `among` (n,) the points: a little of every
        finger rather than much of one, and its back."""
        worth = np.zeros(len(AROUND))
        for i, way in enumerate(AROUND):
            faced = self.seen(way @ self.frame.axes) * np.maximum(self.normals @ way, 0.0) * among
            worth[i] = sum(np.sqrt(weight @ faced[points]) for points, weight in self.skins)
        back = np.stack(AROUND) @ unit(self.moved[among].sum(axis=0))
        return np.asarray(AROUND[first_largest(worth - _BACK * worth.max() * back)])

    def hidden(self, seen: Flags) -> Flags:
        """(n,) the points of the skins of which next to nothing is `seen` (n,)."""
        found = np.zeros(len(seen), dtype=bool)
        for points, weight in self.skins:
            found[points] |= weight @ seen[points] < HARDLY_ANY
        return found


def _frame(surface: BaseSurface, plane: MirrorPlane, ahead: Floats, up: Floats) -> FaceFrame:
    """The face's frame at the middle of the character."""
    middle = surface.points.mean(axis=0)
    axes = np.stack([np.cross(up, ahead), up, ahead])
    return FaceFrame(plane.projected(middle), axes, surface.face_size)


def mostly_hidden(views: Views, tracks: Floats, normals: Floats, depth: float) -> Flags:
    """(p,) tracks (p, k, 3) of which more than half lies inside or behind the model from every
    view.

    A track sinks by `depth` before it counts as hidden: lids slide under their fold and are grabbed
    all the same.  `normals` (p, 3) are those of the anchors.  False throughout without occlusion.
    """
    hidden = np.full(len(tracks), views.caster is not None)
    if views.caster is not None:
        for direction in views.directions:
            ask = np.flatnonzero(hidden)
            lifted = views.frame.points(tracks[ask] + depth * direction)
            outward = views.frame.directions(normals[ask])
            hidden[ask] = (
                hidden_share(views.caster, lifted, outward, views.frame.directions(direction)) > 0.5
            )
    return hidden


def clear_handles(views: Views, base: Floats, normals: Floats, width: float) -> Flags:
    """(n,) points `base` (n, 3) at which a handle of this width can be seen: some view that sees
    the point sees it not edge-on, and at least three of four places on the handle's rim.

    A point in the fold of a lid is seen through the gap; the handle on it is not.  All points seen
    without occlusion.
    """
    if views.caster is None:
        return views.anywhere
    found = np.zeros(len(base), dtype=bool)
    for direction, visible in zip(views.directions, views.visible, strict=True):
        ask = np.flatnonzero(visible & ~found & (normals @ direction >= _EDGE_ON))
        rim = 0.5 * width * seen_from(direction, views.up, views.ahead)[:2]
        lifted = base[ask] + 0.5 * width * normals[ask]
        toward = views.frame.directions(direction)
        seen = [
            ~blocked(views.caster, views.frame.points(lifted + each), toward)
            for each in (*rim, *-rim)
        ]
        found[ask] = np.sum(seen, axis=0) >= _RIM_SEEN
    return found


def _directions(rig: Rig, view: str, ahead: Floats) -> Floats:
    up = rig.up
    if not view:
        return np.stack([ahead, *three_quarter(ahead, up)])
    if view == "front":
        return ahead[None]
    left = np.cross(up, ahead)
    if view == "side":
        return left[None]
    if view.startswith("/"):
        assert rig.camera is not None
        return rig.camera[None]
    azimuth, elevation = np.radians(view_angles(view))
    level = np.cos(azimuth) * ahead + np.sin(azimuth) * left
    return np.asarray(np.cos(elevation) * level + np.sin(elevation) * up)[None]
