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

import numpy as np

from usdrigui.character import Flags, Floats, Record, Rig
from usdrigui.character.joint_tree import level, unit
from usdrigui.conventions import Action, Meaning, actions
from usdrigui.layout.motion.coverage import NOTABLE
from usdrigui.layout.shares import HARDLY_ANY, MOST, NOTHING
from usdrigui.layout.symmetry.front import moving_normals
from usdrigui.layout.symmetry.lobes import ASIDE
from usdrigui.layout.symmetry.sides_of_joints import ONE_WAY, legs_point
from usdrigui.layout.visibility import Views
from usdrigui.model import BaseSurface, MirrorPlane, Motion, Symmetry, Trajectories
from usdrigui.ties import first_largest, towards

LEAST = 4
"""Different places that it takes to lay the canonical face over a character, and controls to lay
one face over another."""
_ACROSS = 0.2
"""Distance from the middle, in the same units, from which a place determines the width."""
_NEAR = 0.7
"""Share of that radius within which a place is near."""


_OPENING = ("jawOpen", "mouthOpen")


def own_up(rig: Rig, plane: MirrorPlane, face: Trajectories | None) -> Floats:
    """(3,) unit up direction of a character in root space: that of the stage, but where its body or
    face lies on its back, its belly or a side, or is tilted.

    Legs go down; without any the skin of the `face` tells, if the character has one.  Characters
    are modelled along the axes: the axis near to what was found is meant.
    """
    legs = legs_point(rig.body, plane)
    if not legs.any():
        return rig.up if face is None else _up_of_face(rig.up, plane, face)
    return _leveled(rig.up, plane) if _stands(legs, rig.up) else _along_axis(-legs, plane)


def _up_of_face(up: Floats, plane: MirrorPlane, face: Trajectories) -> Floats:
    """The moving skin faces ahead, and up goes across that in the mirror plane.  What moves one
    side alone, as lids, brows and corners of the mouth do, lies above what moves both, as jaw and
    lips do.  Faces look down or up a little."""
    across = np.cross(moving_normals(face), plane.normal)
    upright = unit(across)
    if _stands(upright, up):
        return _leveled(up, plane)
    if np.linalg.norm(across) < HARDLY_ANY * len(face.motions):  # They face every way.
        return up
    upright = _along_axis(upright, plane)
    surface = face.surface
    seen = upright, np.ones(len(surface.points), dtype=bool)
    middles = np.array([_middle(surface, plane, seen, each) for each in face.motions])
    aside = middles[:, 0] != 0.0
    above = (aside - aside.mean()) @ middles[:, 1]
    return np.asarray(np.sign(above) * upright) if above else up


def _stands(upright: Floats, up: Floats) -> bool:
    return abs(float(upright @ up)) > ONE_WAY


def _leveled(up: Floats, plane: MirrorPlane) -> Floats:
    return level(up, plane.normal) if abs(plane.normal @ up) > NOTHING else up


def _along_axis(upright: Floats, plane: MirrorPlane) -> Floats:
    """(3,) the axis nearest to a direction, in the mirror plane."""
    axis = np.eye(3)[first_largest(np.abs(upright))]
    return towards(level(axis, plane.normal), upright)


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
    top: float = np.inf
    """Of the face, above the eyes, scene units: what is higher are ears."""

    def regions(self, points: Floats) -> tuple[Flags, Flags]:
        """(p,) which of points (p, 3) in root space lie near the place, and which in the region
        around it."""
        apart = self.distance(points)
        return apart <= _NEAR * self.radius, apart <= self.radius

    def acted_on(self, surface: BaseSurface, visible: Flags, motion: Motion) -> bool:
        """Whether what a motion moves most of the face, of the points that are `visible` (n,), is
        in the region: ears swing as far as they like."""
        points = surface.points[motion.points]
        seen = visible[motion.points] & ((points - self.origin) @ self.axes[1] <= self.top)
        top = first_largest(seen * motion.arc_length)
        return bool(self.regions(points[[top]])[1][0])

    def distance(self, points: Floats) -> Floats:
        """(p,) of points (p, 3) in root space from the expected place, in distances of the
        pupils."""
        flat = (points - self.origin) @ self.axes.T / self.scale
        if self.both_sides:
            flat[:, 0] = np.abs(flat[:, 0])
        return np.asarray(np.linalg.norm(flat - self.place, axis=1))


def kept_in(motion: Motion, seen: Flags, region: Flags, least: float) -> Flags:
    """(p,) those `seen` in a `region`, if the control keeps a share of its visible peak there; all
    `seen` otherwise."""
    arc, inside = motion.arc_length, seen & region
    return inside if arc[inside].max(initial=0.0) >= least * arc[seen].max() else seen


def believed(
    trajectories: Trajectories, symmetry: Symmetry, views: Views, meanings: Sequence[Meaning | None]
) -> tuple[tuple[Meaning | None, ...], tuple[Expectation | None, ...]]:
    """(controls,) the meanings of names that the motions bear out, and where each control is
    expected; None where its name has no meaning or too few names have one.

    `meanings` (controls,) as read from the names of the rig's controls.  Names count only
    where most of those with a place act there: numbers may count something else than action units,
    as those of joints do, and words may be those of other controls.  What mostly moves what is seen
    is not inside the mouth, whatever it is called, and what moves both sides alike is not the
    control of one.
    What moves the most of a part of the face, both sides alike and down, opens the jaw where no
    name does.
    """
    surface, found, most, jaw = trajectories.surface, list(meanings), 0.0, -1
    for motion in trajectories.motions:
        control, areas = motion.control, surface.areas[motion.points]
        seen, weight = views.anywhere[motion.points], areas * motion.arc_length
        meaning, own_image = found[control], int(symmetry.twins[control]) == control
        amount = weight.sum()
        if meaning is not None and (
            (meaning.action.category == "interior" and weight[seen].sum() > 0.5 * amount)
            or (meaning.side and own_image)
            or (meaning.numbered and motion.of_joint)
        ):
            found[control] = None
        far = motion.arc_length >= NOTABLE * motion.arc_length.max()
        # Jaws and mouths move a third of the surface at most, what moves a head .87 and more.
        if amount > most and areas @ far < MOST * surface.areas.sum():
            # Some skin is drawn along: jaws of six heads go down by .58 to .94 of what they move,
            # what else is the largest motion of a part by .32 or less.
            falls = -(areas @ motion.span @ views.up) > MOST * amount
            most, jaw = amount, control if falls and own_image and meaning is None else -1
    named = {each.action.name for each in found if each}
    if jaw >= 0 and named and named.isdisjoint(_OPENING):
        found[jaw] = Meaning(actions()["jawOpen"], "")
    expected = expectations(trajectories, symmetry, views, found)
    right = [
        place is not None and place.acted_on(surface, views.anywhere, motion)
        for motion in trajectories.motions
        if (meaning := found[motion.control]) is not None
        and ((place := expected[motion.control]) is not None or meaning.numbered)
        and not motion.of_joint
    ]
    if right and 2 * sum(right) <= len(right):
        nothing = (None,) * len(found)
        return nothing, nothing
    return tuple(found), expected


def expectations(
    trajectories: Trajectories, symmetry: Symmetry, views: Views, meanings: Sequence[Meaning | None]
) -> tuple[Expectation | None, ...]:
    """(controls,) where each control is expected; None where its name has no meaning or too few
    names have one."""
    surface, plane = trajectories.surface, symmetry.plane
    seen = views.up, views.anywhere
    clues = _clues(trajectories, plane, seen, meanings)
    fit = _fit([clue for clue in clues if clue.tells]) if plane.normal.any() else None
    top = np.inf
    if fit is not None and fit.eyes is not None:
        # The controls of the eyes move no ears, and tell where those begin.
        unit, height = fit.eyes
        top = unit * max(clue.place[1] + clue.action.radius for clue in clues)
        seen = views.up, views.anywhere & (surface.points @ views.up <= height + top)
        clues = _clues(trajectories, plane, seen, meanings)
        fit = _fit([clue for clue in clues if clue.tells])
    if fit is None:
        return (None,) * len(meanings)
    axes = np.stack([plane.normal, views.up])
    found: dict[int, Expectation] = {}
    for clue in clues:
        across, place = clue.middle[0], clue.place
        scale, height = fit.around(place)
        side = np.sign(across) if abs(across) > ASIDE * surface.face_size else 0.0
        origin = plane.origin + (height - plane.origin @ views.up) * views.up
        target = np.array([place[0] * side if side else abs(place[0]), place[1]])
        both = bool(not side and place[0])
        found[clue.control] = Expectation(
            axes, origin, scale, target, both, clue.action.radius, top
        )
    return tuple(found.get(control) for control in range(len(meanings)))


class _Clue(Record):
    """A motion whose name has a place on the canonical face."""

    control: int
    action: Action
    place: tuple[float, float]
    """On the canonical face."""
    middle: Floats
    """(2,) see `_middle`."""
    tells: bool
    """Whether it locates its action."""


def _clues(
    trajectories: Trajectories,
    plane: MirrorPlane,
    seen: tuple[Floats, Flags],
    meanings: Sequence[Meaning | None],
) -> list[_Clue]:
    """The motions whose names have a place.  None locates its action that is faint beside another
    one of its action and side: where each mesh has controls of its own, lashes follow the lips a
    little."""
    named = [(m, each) for m in trajectories.motions if (each := meanings[m.control]) is not None]
    largest: dict[tuple[str, str], float] = {}
    for motion, each in named:
        key = (each.action.name, each.side)
        largest[key] = max(largest.get(key, 0.0), motion.peak)
    return [
        _Clue(
            motion.control,
            each.action,
            each.action.place,
            _middle(trajectories.surface, plane, seen, motion),
            each.action.category != "atom"
            or each.action.vague
            or motion.peak >= MOST * largest[each.action.name, each.side],
        )
        for motion, each in named
        if each.action.place
    ]


class _Fit(Record):
    """The canonical face laid over a character."""

    scale: Floats
    """(2,) distance of the pupils across and upright."""
    height: float
    """Of the eyes."""
    eyes: tuple[float, float] | None
    """Distance of the pupils and height by the controls of the eyes alone."""

    def around(self, place: tuple[float, float]) -> tuple[Floats, float]:
        """Scale and height of the eyes for a place: above them those of the eyes, so that neither
        a long muzzle nor ears that move with the brows stretch the forehead."""
        if self.eyes is None or place[1] <= 0.0:
            return self.scale, self.height
        return np.full(2, self.eyes[0]), self.eyes[1]


def _fit(clues: Sequence[_Clue]) -> _Fit | None:
    """The fit of the canonical face to the middles of the clues, each place counted once; None
    where they fix too little."""
    middles = np.array([clue.middle for clue in clues]).reshape(-1, 2)
    places = np.array([clue.place for clue in clues]).reshape(-1, 2)
    each, which = np.unique(places, axis=0, return_inverse=True)
    # Controls of the mouth alone fix nothing of the brows: of a distance of the pupils their
    # heights must spread over most.
    if len(each) < LEAST or np.ptp(each[:, 1]) < MOST:
        return None
    typical = np.array(
        [
            (np.median(np.abs(middles[which == i, 0])), np.median(middles[which == i, 1]))
            for i in range(len(each))
        ]
    )
    upright, height = _line_through(each[:, 1], typical[:, 1])
    # Where names that lie high move what lies low, nothing is near its place.
    upright = upright if upright > 0.0 else np.nan
    of_eyes = np.array([c.action.region in ("eye", "gaze") for c in clues]) & (middles[:, 0] != 0.0)
    eyes = None
    if of_eyes.any():
        unit = float(np.median(np.abs(middles[of_eyes, 0] / places[of_eyes, 0])))
        eyes = unit, float(np.median(middles[of_eyes, 1] - unit * places[of_eyes, 1]))
    # The mouth of a muzzle is wider than its eyes tell.
    wide = (np.abs(each[:, 0]) > _ACROSS) & (typical[:, 0] > 0.0)
    widths = [
        np.median(typical[some, 0] / np.abs(each[some, 0]))
        for some in (wide, wide & (each[:, 1] < 0.0))
        if some.any()
    ]
    across = max(widths, default=upright)
    return _Fit(np.array([across, upright]), height, eyes)


def _line_through(x: Floats, y: Floats) -> tuple[float, float]:
    """Slope, the median over all pairs of points, and value at 0 of a line (P. K. Sen, 1968); what
    scipy.stats has for it takes a second to import."""
    later, earlier = np.nonzero(x[:, None] > x)
    slope = float(np.median((y[later] - y[earlier]) / (x[later] - x[earlier])))
    return slope, float(np.median(y) - slope * np.median(x))


def _middle(
    surface: BaseSurface, plane: MirrorPlane, seen: tuple[Floats, Flags], motion: Motion
) -> Floats:
    """(2,) middle of a motion, by area and squared length: distance from the mirror plane (of the
    two lobes of a symmetric motion that of one) and height, scene units; `seen` are the up
    direction and the visible points (n,)."""
    up, visible = seen
    shown = np.where(visible[motion.points], 1.0, 1e-6)
    weight = surface.areas[motion.points] * np.square(motion.arc_length) * shown
    weight /= max(weight.sum(), 1e-300)
    points = surface.points[motion.points]
    apart = plane.distance(points)
    middle, spread = weight @ apart, weight @ np.abs(apart)
    one_sided = abs(middle) > 0.5 * spread
    return np.array([middle if one_sided else 0.0, float(weight @ (points @ up))])
