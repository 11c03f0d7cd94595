"""Where the conventions of the field expect a control: a canonical face fitted to this one (beyond
the paper).

The names of controls name their actions (`usdrigui.conventions`), and each action has a place on a
canonical face.  The canonical face is laid over the character by what its controls move: the line
that fits the heights of all motions that have a name best, robustly, and the scale that fits how
far they lie from the mirror plane.  The motion of a single control does not decide where it is
expected, and a name on the wrong side is overruled by the motion.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from usdrigui.character import Flags, Floats, Record
from usdrigui.conventions import Meaning
from usdrigui.layout.visibility import Views
from usdrigui.model import BaseSurface, MirrorPlane, Motion, Symmetry, Trajectories

_LEAST = 4
"""Different places that it takes to lay the canonical face over a character."""
_SPAN = 0.5
"""Least spread of their heights, in distances of the pupils: controls of the mouth alone fix
nothing of the brows."""
_ACROSS = 0.2
"""Distance from the middle, in the same units, from which a place determines the width."""
_PAIRS = 4
"""Actions on both sides that it takes to find the middle of a face without a mirror plane."""
_ALIGNED = 0.8
"""Length of the mean of the directions from their right to their left, at least."""
_NEAR = 0.7
"""Share of that radius within which a place is near."""
_SIDED = 0.1
"""A motion whose middle is nearer to the plane, in face sizes, acts on both sides."""


_FAINT = 0.5
"""Share of the largest peak of an action below which another control of it does not fix its
place."""
Named = tuple[Motion, Meaning | None]
"""A motion and how the name of its control is read."""


@dataclass(frozen=True, eq=False)
class Expectation(Record):
    """Where one control is expected, in the plane of the face's front."""

    axes: Floats
    """(2, 3) unit vectors to the character's left and up."""
    origin: Floats
    """(3,) between the eyes."""
    scale: Floats
    """(2,) distance of the pupils across and upright, scene units."""
    place: Floats
    """(2,) across and up, in units of `scale`."""
    both_sides: bool
    """True where the mirrored place is as good."""
    radius: float
    """Of the region around it, in distances of the pupils."""

    def regions(self, points: Floats) -> tuple[Flags, Flags]:
        """(p,) which of points (p, 3) in root space lie near the place, and which in the region
        around it."""
        apart = self.distance(points)
        return np.asarray(apart <= _NEAR * self.radius), np.asarray(apart <= self.radius)

    def distance(self, points: Floats) -> Floats:
        """(p,) of points (p, 3) in root space from the expected place, in distances of the
        pupils."""
        flat = (points - self.origin) @ self.axes.T / self.scale
        if self.both_sides:
            flat[:, 0] = np.abs(flat[:, 0])
        return np.asarray(np.linalg.norm(flat - self.place, axis=1))


def expectations(
    trajectories: Trajectories, symmetry: Symmetry, views: Views, meanings: Sequence[Meaning | None]
) -> tuple[Expectation | None, ...]:
    """(controls,) where each control is expected; None where its name has no meaning or too few
    names have one.

    `meanings` (controls,) as read from the names of the rig's controls.
    """
    placed = [(m, meanings[m.control]) for m in trajectories.motions]
    informative = _informative(placed)
    known = [
        (m, each.action, each.action.place, tells)
        for (m, each), tells in zip(placed, informative, strict=True)
        if each is not None and each.action.place
    ]
    if not symmetry.plane.normal.any():
        clear = [each for each, tells in zip(placed, informative, strict=True) if tells]
        symmetry = _middle_of_names(trajectories.surface, symmetry, views.anywhere, clear)
    middles = np.array(
        [_middle(trajectories.surface, symmetry.plane, views, motion) for motion, *_ in known]
    ).reshape(-1, 2)
    places = np.array([place for _, _, place, _ in known]).reshape(-1, 2)
    kept = np.array([tells for *_, tells in known], dtype=np.bool_)
    fit = _fit(middles[kept], places[kept]) if symmetry.plane.normal.any() else None
    if fit is None:
        return (None,) * len(meanings)
    scale, height = fit
    axes = np.stack([symmetry.plane.normal, views.up])
    origin = symmetry.plane.origin + (height - symmetry.plane.origin @ views.up) * views.up
    found: dict[int, Expectation] = {}
    for (motion, action, place, _), middle in zip(known, middles, strict=True):
        side = (
            np.sign(middle[0]) if abs(middle[0]) > _SIDED * trajectories.surface.face_size else 0.0
        )
        both = side == 0.0 and place[0] != 0.0
        target = np.array([place[0] * side if side else abs(place[0]), place[1]])
        found[motion.control] = Expectation(axes, origin, scale, target, bool(both), action.radius)
    return tuple(found.get(control) for control in range(len(meanings)))


def _informative(placed: Sequence[Named]) -> list[bool]:
    """Which motions locate their action: none that is faint beside another one of its action
    and side.  Where each mesh has controls of its own, lashes follow the lips a little."""
    keys = [
        (each.action.name, each.side)
        if each and each.action.category == "atom" and not each.action.vague
        else None
        for _, each in placed
    ]
    largest: dict[tuple[str, str] | None, float] = {None: 0.0}
    for (motion, _), key in zip(placed, keys, strict=True):
        if key is not None:
            largest[key] = max(largest.get(key, 0.0), motion.peak)
    return [
        motion.peak >= _FAINT * largest[key] for (motion, _), key in zip(placed, keys, strict=True)
    ]


def _fit(middles: Floats, places: Floats) -> tuple[Floats, float] | None:
    """(2,) scale across and upright, and height of the eyes, that lay the canonical `places` (c, 2)
    on the `middles` (c, 2) of the motions; each place counts once.  None where they fix too
    little."""
    each, which = np.unique(places, axis=0, return_inverse=True)
    typical = np.array(
        [np.median(np.abs(middles[which == i]), axis=0) for i in range(len(each))]
    ).reshape(-1, 2)
    heights = np.array([np.median(middles[which == i, 1]) for i in range(len(each))])
    if len(each) < _LEAST or np.ptp(each[:, 1]) < _SPAN:
        return None
    upright, height = _line_through(each[:, 1], heights)
    wide = (np.abs(each[:, 0]) > _ACROSS) & (typical[:, 0] > 0.0)
    across = (
        float(np.median(typical[wide, 0] / np.abs(each[wide, 0]))) if wide.any() else float(upright)
    )
    return (np.array([across, upright]), float(height)) if upright > 0.0 else None


def _line_through(x: Floats, y: Floats) -> tuple[float, float]:
    """Slope, the median over all pairs of points, and value at 0 of a line (P. K. Sen, 1968); what
    scipy.stats has for it takes a second to import."""
    later, earlier = np.nonzero(x[:, None] > x)
    slope = float(np.median((y[later] - y[earlier]) / (x[later] - x[earlier])))
    return slope, float(np.median(y) - slope * np.median(x))


def _middle_of_names(
    surface: BaseSurface,
    symmetry: Symmetry,
    visible: Flags,
    placed: Sequence[Named],
) -> Symmetry:
    """The symmetry with a plane halfway between the sides by names, for a face that is not
    its own mirror image (a scan); unchanged where there are too few names."""
    sides: dict[tuple[str, str], Floats] = {}
    for motion, each in placed:
        if each is not None and each.side:
            weight = _weights(surface.areas, visible, motion)
            sides[each.action.name, each.side] = weight @ surface.points[motion.points]
    pairs = [
        (left, sides[action, "right"])
        for (action, side), left in sorted(sides.items())
        if side == "left" and (action, "right") in sides
    ]
    if len(pairs) < _PAIRS:
        return symmetry
    apart = np.array([left - right for left, right in pairs])
    across = apart / np.maximum(np.linalg.norm(apart, axis=1, keepdims=True), 1e-300)
    mean = np.asarray(across.mean(axis=0))
    if np.linalg.norm(mean) < _ALIGNED:
        return symmetry
    origin = np.median([0.5 * (left + right) for left, right in pairs], axis=0)
    return replace(symmetry, plane=MirrorPlane(origin, mean / np.linalg.norm(mean)))


def _middle(surface: BaseSurface, plane: MirrorPlane, views: Views, motion: Motion) -> Floats:
    """(2,) middle of a motion, by area and squared length: distance from the mirror plane (of the
    two lobes of a symmetric motion that of one) and height, scene units."""
    weight = _weights(surface.areas, views.anywhere, motion)
    points = surface.points[motion.points]
    apart = plane.distance(points)
    middle, spread = float(weight @ apart), float(weight @ np.abs(apart))
    one_sided = abs(middle) > 0.5 * spread
    return np.array([middle if one_sided else 0.0, float(weight @ (points @ views.up))])


def _weights(areas: Floats, visible: Flags, motion: Motion) -> Floats:
    """(p,) of the points of a motion for its middle; their sum is 1."""
    seen = visible[motion.points]
    weight = areas[motion.points] * np.square(motion.arc_length) * np.where(seen, 1.0, 1e-6)
    return np.asarray(weight / max(float(weight.sum()), 1e-300))
