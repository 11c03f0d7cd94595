"""Where each control may be anchored (paper section 4.2)."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.character import Flags, Indices, LeftOff
from usdrigui.layout.canonical_face import Expectation, kept_in
from usdrigui.layout.face import HELD, Face
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.tracks import polylines
from usdrigui.layout.place.locality import kept_near, proxies
from usdrigui.layout.reuse.carrying import moved
from usdrigui.layout.reuse.partial_layout import fixed_anchor, moves
from usdrigui.layout.shares import HARDLY_ANY, KEPT, MOST, NOTHING
from usdrigui.layout.symmetry.lobes import in_the_middle
from usdrigui.layout.visibility import mostly_hidden
from usdrigui.model import Candidates, CandidateSet, Motion
from usdrigui.ties import first_largest

STAGE = "candidates"

_OWN_IN_THE_MIDDLE = 0.45
"""Share of the most that it owns anywhere that a joint owns in the middle, at least, if its handle
is to stand there."""
_BESIDE = 1.25
"""Distance from a joint's hidden skin, as a share of the least, within which its handle stands."""
_ENOUGH = 2.0 / 3.0
"""Share of its visible peak from which a control leaves that, far from all others, for a place
among them."""
_FAR = 1.0 / 3.0
"""Distance from the places of all other controls, in face sizes, from which a peak is far."""


def find_candidates(known: Measured) -> Candidates:
    """The candidates of every control that moves something; a control without any is left off.

    Points are pruned below the mean arc length of the control and below a share of its visible
    peak, where no view sees them and where the trajectory runs inside or behind the model.  Where
    pruning would leave nothing, its weaker reasons give way in the reverse order: a control that
    any view can see always has a candidate.
    """
    face = known.face
    sets: dict[int, CandidateSet] = {}
    left_off: list[LeftOff] = []
    for motion, found in zip(face.trajectories.motions, known.classification, strict=True):
        places = _places(known, motion, found.category)
        if len(places[0]):
            sets[motion.control] = CandidateSet(motion, *places)
        else:
            reason = "moves only points that coincide with points it leaves at rest"
            left_off.append(LeftOff(face.control_name(motion.control), STAGE, reason))
    return Candidates(sets, tuple(left_off))


def loosened(known: Measured, found: CandidateSet, least: float) -> CandidateSet:
    """The set with every visible place where a handle keeps at least a share of the control's peak:
    for elements whose copies would collide at all of their better places."""
    motion = found.motion
    seen = _allowed(known, motion, _seen(known, motion))
    if known.requests.overrides[motion.control].anchor or not seen.any():
        return found
    points = motion.points[seen & (motion.arc_length >= _kept(motion, seen, least))]
    return CandidateSet(motion, points, points)


def candidates_of_axis(known: Measured, found: CandidateSet) -> CandidateSet:
    """The set of a control on the face under requests that fix it elsewhere or not at all."""
    return CandidateSet(found.motion, *_places(known, found.motion, ""))


def _places(known: Measured, motion: Motion, category: str) -> tuple[Indices, Indices]:
    """Points at which the control may be anchored, ascending, and whose trajectories are drawn
    there."""
    face, override = known.face, known.requests.overrides[motion.control]
    name = face.control_name(motion.control)
    peak = motion.points[[first_largest(np.where(motion.stands_on(), motion.arc_length, 0.0))]]
    if override.anchor:
        fixed = fixed_anchor(face.rig, name, override.anchor)
        point = np.array([fixed], dtype=np.int64)
        return point, point if moves(motion.points, name, override, fixed) else peak
    if category:
        return peak, peak
    if override.place == "proxy":
        points = proxies(face, int(peak[0]))
        sources = np.repeat(peak, len(points))
    else:
        points = sources = _moving_places(known, motion)
    return _with_prior(known, motion, (points, sources))


def _with_prior(
    known: Measured, motion: Motion, places: tuple[Indices, Indices]
) -> tuple[Indices, Indices]:
    """The places, points and sources, with the one of the earlier layout: pruning must not drive an
    element away from it.  Where no point is there any more, with all within a handle's width of the
    nearest, as others may want that one."""
    face, place = known.face, known.requests.prior.places.get(motion.control)
    points, sources = places
    own = np.array_equal(points, sources)
    if place is None or place.on_board or not own or place.point not in motion.points:
        return places
    apart = np.linalg.norm(face.surface.points[motion.points] - place.position, axis=1)
    here = motion.points == place.point
    (off,) = apart[here]
    if off > NOTHING * face.handle_width:
        reach = off + face.handle_width
        here |= moved(motion) & (apart <= reach) & face.views.anywhere[motion.points]
    points = np.union1d(points, motion.points[here])
    return points, points


def _moving_places(known: Measured, motion: Motion) -> Indices:
    """Points that the control moves and where it may stand, ascending; near what the configuration
    names."""
    face, requests = known.face, known.requests
    some = _allowed(known, motion, np.ones(len(motion.points), dtype=bool))
    seen = _allowed(known, motion, _seen(known, motion))
    seen = _with_clear_handles(known, motion, seen)
    # A person's decision, an earlier place and the skin that a joint owns come before the meaning
    # of a name.
    is_asked = requests.overrides[motion.control].near or motion.control in requests.prior.places
    if not (is_asked or motion.of_joint) and seen.any():
        seen = _off_strands(face, motion, seen)
        seen = _where_expected(face, motion, seen, face.expected[motion.control])
    points = _pruned(known, motion, seen, some)
    # What no view sees but is to stand on the face all the same.
    return points if len(points) else _pruned(known, motion, some, some)


def _allowed(known: Measured, motion: Motion, among: Flags) -> Flags:
    """Those `among` (p,) the moving points where the control may stand, before any pruning: one of
    each place, near what the configuration names, on the skin that its joint owns."""
    face = known.face
    first = among & face.surface.first[motion.points]
    near = kept_near(face, motion.control, known.requests, motion.points, first)
    near = _nearest_to_hidden(face, motion, near)
    return motion.stands_on(near) | _in_the_middle(known, motion, near)


def _nearest_to_hidden(face: Face, motion: Motion, near: Flags) -> Flags:
    """(p,) those `near`; where none is of the skin that its joint owns, as of a neck in a collar,
    the nearest to that."""
    owned = motion.owned
    if owned is None or not near.any() or owned[near].any() or not owned.any():
        return near
    points = face.surface.points[motion.points]
    apart = np.linalg.norm(points - owned @ points / owned.sum(), axis=1)
    return np.asarray(near & (apart <= _BESIDE * apart[near].min()))


def _in_the_middle(known: Measured, motion: Motion, near: Flags) -> Flags:
    """(p,) those `near` in the middle where the handle of a joint that is its own mirror image
    stands: on skin that the joint owns, with enough of the displacement."""
    face = known.face
    middle = near & in_the_middle(face.symmetry, motion, face.handle_width)
    if not middle.any():
        return middle
    enough = motion.arc_length >= _kept(motion, near, known.pruning.least_kept)
    return middle & motion.stands_on(near, _OWN_IN_THE_MIDDLE) & enough


def _with_clear_handles(known: Measured, motion: Motion, seen: Flags) -> Flags:
    """(p,) those `seen` at which the handle itself is seen, if one of them keeps enough of the
    displacement."""
    clear = _allowed(known, motion, seen & known.face.clear[motion.points])
    reached = motion.arc_length[clear].max(initial=0.0)
    return clear if reached >= _kept(motion, seen, known.pruning.least_kept) else seen


def _kept(motion: Motion, seen: Flags, least: float) -> float:
    """Arc length that a handle must have: a share of the true peak, and no more than any place
    `seen` (p,) has."""
    return min(least * motion.peak, float(motion.arc_length[seen].max(initial=0.0)))


def _off_strands(face: Face, motion: Motion, seen: Flags) -> Flags:
    """(p,) those `seen` but for whiskers and hair: pieces of surface with little of what the
    control moves; all of them where the rest moves too little."""
    pieces = face.pieces[motion.points]
    by_piece = np.bincount(pieces, face.surface.swept(motion) * seen)
    return kept_in(motion, seen, (by_piece >= HARDLY_ANY * by_piece.max())[pieces], HELD)


def _among_others(face: Face, motion: Motion, seen: Flags) -> Flags:
    """(p,) which points count where nothing is expected: those `seen`, or, where the largest motion
    is far from all that other controls are for, as on ears that go with the brows, those at most
    half as far from that, if it moves them enough."""
    surface, top = face.surface, first_largest(motion.arc_length * seen)
    others = [
        peak
        for other, peak in zip(face.trajectories.motions, face.peaks, strict=True)
        if other.arc_length[other.points == motion.points[top]].sum() < MOST * other.peak
    ]
    if not others:
        return seen
    apart, _ = cKDTree(surface.points[others]).query(surface.points[motion.points])
    if apart[top] <= _FAR * surface.face_size:
        return seen
    return kept_in(motion, seen, apart <= MOST * apart[top], _ENOUGH)


def _where_expected(face: Face, motion: Motion, seen: Flags, expected: Expectation | None) -> Flags:
    """(p,) which points count: those `seen` near the place where the control is expected, or in the
    region around it, if it moves them notably; `_among_others` where none is expected.

    A sneer that lifts the brow more than the nose stands by the nose all the same.  A control that
    hardly moves the place where its name expects it does something else.
    """
    if expected is None:
        return _among_others(face, motion, seen)
    near, around = expected.regions(face.surface.points[motion.points])
    close = kept_in(motion, seen, near, KEPT)
    return close if close is not seen else kept_in(motion, seen, around, HELD)


def _pruned(known: Measured, motion: Motion, seen: Flags, some: Flags) -> Indices:
    """Points at which the control may be anchored, ascending; empty when no view sees what it
    moves.

    `some` (p,) are the points where it may stand, `seen` (p,) those of them that a view sees.
    """
    if not seen.any():
        return np.zeros(0, dtype=np.int64)
    arc, settings = motion.arc_length, known.pruning
    peak = float(arc[seen].max())
    large = arc >= max(settings.peak_share * peak, _kept(motion, seen, settings.least_kept))
    middle = _in_the_middle(known, motion, seen)
    moving = (large & (arc >= min(settings.prune_at * float(arc[some].mean()), peak))) | middle
    large |= middle
    for kept in (seen & moving, seen & large):
        kept = _without_occluded(known, motion, kept)
        # A corner of the mouth that is drawn back runs into the cheek: its handle stands there
        # nevertheless.
        if arc[kept].max(initial=0.0) >= KEPT * peak:
            return motion.points[kept]
    return motion.points[seen & moving]


def _seen(known: Measured, motion: Motion) -> Flags:
    """(p,) which points can be seen from where the layout is judged: its own view alone, where that
    is asked for."""
    views = known.face.views
    return (views.visible[0] if known.pruning.space == "view" else views.anywhere)[motion.points]


def _without_occluded(known: Measured, motion: Motion, kept: Flags) -> Flags:
    """(p,) those `kept` whose trajectory does not run largely inside or behind the model."""
    face, points = known.face, motion.points[kept]
    surface, samples = face.surface, known.settings.objective.samples
    tracks = polylines(motion, surface.points, points, points, samples)
    hidden = mostly_hidden(face.views, tracks, surface.normals[points], 0.5 * face.handle_width)
    clear = kept.copy()
    clear[kept] = ~hidden
    return clear
