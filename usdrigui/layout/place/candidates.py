"""Where each control may be anchored (paper section 4.2)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import Flags, Indices, LeftOff
from usdrigui.layout.canonical_face import Expectation
from usdrigui.layout.classify.classification import Classification
from usdrigui.layout.face import Face
from usdrigui.layout.motion.tracks import polylines
from usdrigui.layout.place.locality import kept_near, proxies
from usdrigui.layout.place.terms import LinearTerms, linear_cost
from usdrigui.layout.reuse.carrying import MOVES
from usdrigui.layout.reuse.partial_layout import fixed_anchor, moves
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.symmetry.lobes import in_the_middle
from usdrigui.layout.visibility import mostly_hidden
from usdrigui.model import Candidates, CandidateSet, Motion
from usdrigui.settings import CandidateSettings
from usdrigui.ties import first_largest

STAGE = "candidates"
SHARED_LEAST = 0.2
"""Share of the peak at which a control may stand where it shares an element that has no better
place."""

_OWN_IN_THE_MIDDLE = 0.45
"""Share of the most that it owns anywhere that a joint owns in the middle, at least, if its handle
is to stand there."""
_BESIDE = 1.25
"""Distance from a joint's hidden skin, as a share of the least, within which its handle stands."""
_THERE = 1e-3
"""Handle widths within which a point is an earlier place."""
_NOTABLE = 1.0 / 3.0
"""Share of its visible peak that a control must reach in the region where it is expected for that
to hold."""
_MOST = 0.85
"""The same for standing near the place itself."""


def find_candidates(
    face: Face,
    classification: Sequence[Classification],
    requests: Requests,
    settings: CandidateSettings,
    terms: LinearTerms,
    samples: int,
) -> Candidates:
    """The candidates of every control that moves something; a control without any is left off.

    Points are pruned below the mean arc length of the control and below a share of its visible
    peak, where no view sees them and where the trajectory runs inside or behind the model.  Where
    pruning would leave nothing, its weaker reasons give way in the reverse order: a control that
    any view can see always has a candidate.  `samples` are the points of a track that decide
    whether it runs there.
    """
    sets: list[CandidateSet] = []
    left_off: list[LeftOff] = []
    for index, (motion, found) in enumerate(
        zip(face.trajectories.motions, classification, strict=True)
    ):
        if requests.overrides[motion.control].exclude:
            left_off.append(
                LeftOff(face.control_name(motion.control), STAGE, "excluded by the configuration")
            )
            continue
        points, sources = _places(face, motion, found, requests, settings, samples)
        if not len(points):
            reason = "moves only points that coincide with points it leaves at rest"
            left_off.append(LeftOff(face.control_name(motion.control), STAGE, reason))
            continue
        sets.append(
            CandidateSet(
                motion=index,
                points=points,
                cost=linear_cost(face, motion, sources, terms),
                coverage=found.coverage,
                sources=sources,
                category=found.category,
                off_face_reason=found.off_face_reason,
            )
        )
    return Candidates(tuple(sets), tuple(left_off))


def loosened(
    face: Face,
    found: CandidateSet,
    requests: Requests,
    settings: CandidateSettings,
    terms: LinearTerms,
    least: float,
) -> CandidateSet:
    """The set with every visible place where a handle keeps at least a share of the control's peak:
    for elements whose copies would collide at all of their better places."""
    motion = face.trajectories.motions[found.motion]
    override = requests.overrides[motion.control]
    seen = _allowed(
        face, motion, requests, settings.least_kept, _seen(face, motion.points, settings.space)
    )
    if override.anchor or not seen.any():
        return found
    points = motion.points[seen & (motion.arc_length >= _kept(motion, seen, least))]
    return replace(
        found,
        points=points,
        sources=points,
        cost=linear_cost(face, motion, points, terms),
    )


def candidates_of_axis(
    face: Face,
    found: CandidateSet,
    requests: Requests,
    settings: CandidateSettings,
    terms: LinearTerms,
    samples: int,
) -> CandidateSet:
    """The set of a control on the face under `requests` that fix it elsewhere or not at all."""
    motion = face.trajectories.motions[found.motion]
    points, sources = _places(face, motion, Classification(), requests, settings, samples)
    return replace(
        found,
        points=points,
        sources=sources,
        cost=linear_cost(face, motion, sources, terms),
    )


def _places(
    face: Face,
    motion: Motion,
    found: Classification,
    requests: Requests,
    settings: CandidateSettings,
    samples: int,
) -> tuple[Indices, Indices]:
    """Points at which the control may be anchored, ascending, and whose trajectories are drawn
    there."""
    override, name = requests.overrides[motion.control], face.control_name(motion.control)
    peak = motion.points[[first_largest(np.where(motion.stands_on(), motion.arc_length, 0.0))]]
    fixed = fixed_anchor(face.rig, name, override.anchor)
    if fixed is not None:
        point = np.array([fixed], dtype=np.int64)
        return point, point if moves(motion.points, name, override, fixed) else peak
    if found.category:
        return peak, peak
    if override.place == "proxy":
        points = proxies(face, int(peak[0]))
        sources = np.repeat(peak, len(points))
    else:
        points = sources = _moving_places(face, motion, requests, settings, samples)
    return _with_prior(face, motion, requests, (points, sources))


def _with_prior(
    face: Face, motion: Motion, requests: Requests, places: tuple[Indices, Indices]
) -> tuple[Indices, Indices]:
    """The places, points and sources, with the one of the earlier layout: pruning must not drive an
    element away from it.  Where no point is there any more, with all within a handle's width of the
    nearest, as others may want that one."""
    place, (points, sources) = requests.prior.places.get(motion.control), places
    own = np.array_equal(points, sources)
    if place is None or place.on_board or not own or place.point not in motion.points:
        return places
    apart = np.linalg.norm(face.trajectories.surface.points[motion.points] - place.position, axis=1)
    here = motion.points == place.point
    if float(apart[here][0]) > _THERE * face.handle_width:
        reach = float(apart[here][0]) + face.handle_width
        far = motion.arc_length >= MOVES * motion.peak
        here |= far & (apart <= reach) & face.views.anywhere[motion.points]
    points = np.union1d(points, motion.points[here])
    return points, points


def _moving_places(
    face: Face, motion: Motion, requests: Requests, settings: CandidateSettings, samples: int
) -> Indices:
    """Points that the control moves and where it may stand, ascending; near what the configuration
    names."""
    everywhere = np.ones(len(motion.points), dtype=bool)
    some = _allowed(face, motion, requests, settings.least_kept, everywhere)
    seen = _allowed(
        face, motion, requests, settings.least_kept, _seen(face, motion.points, settings.space)
    )
    seen = _with_clear_handles(face, motion, requests, settings.least_kept, seen)
    # A person's decision, an earlier place and the skin that a joint owns come before the meaning
    # of a name.
    is_asked = requests.overrides[motion.control].near or motion.control in requests.prior.places
    if not is_asked and motion.shares.owned is None:
        seen = _where_expected(face, motion, seen, face.expected[motion.control])
    points = _pruned(face, motion, seen, some, settings, samples)
    # What no view sees but is to stand on the face all the same.
    return points if len(points) else _pruned(face, motion, some, some, settings, samples)


def _allowed(
    face: Face, motion: Motion, requests: Requests, least_kept: float, among: Flags
) -> Flags:
    """Those `among` (p,) the moving points where the control may stand, before any pruning: one of
    each place, near what the configuration names, on the skin that its joint owns."""
    first = among & (face.trajectories.surface.places[motion.points] == motion.points)
    near = kept_near(face, motion.control, requests, motion.points, first)
    near = _nearest_to_hidden(face, motion, near)
    return motion.stands_on(near) | _in_the_middle(face, motion, near, least_kept)


def _nearest_to_hidden(face: Face, motion: Motion, near: Flags) -> Flags:
    """(p,) those `near`; where none is of the skin that its joint owns, as of a neck in a collar,
    the nearest to that."""
    owned = motion.shares.owned
    if owned is None or not near.any() or owned[near].any() or not owned.any():
        return near
    points = face.trajectories.surface.points[motion.points]
    apart = np.linalg.norm(points - owned @ points / owned.sum(), axis=1)
    return np.asarray(near & (apart <= _BESIDE * apart[near].min()))


def _in_the_middle(face: Face, motion: Motion, near: Flags, least_kept: float) -> Flags:
    """(p,) those `near` in the middle where the handle of a joint that is its own mirror image
    stands: on skin that the joint owns, with enough of the displacement."""
    middle = near & in_the_middle(
        face.trajectories.surface, face.symmetry, motion, face.handle_width
    )
    if not middle.any():
        return middle
    enough = motion.arc_length >= _kept(motion, near, least_kept)
    return middle & motion.stands_on(near, _OWN_IN_THE_MIDDLE) & enough


def _with_clear_handles(
    face: Face, motion: Motion, requests: Requests, least_kept: float, seen: Flags
) -> Flags:
    """(p,) those `seen` at which the handle itself is seen, if one of them keeps enough of the
    displacement."""
    clear = _allowed(face, motion, requests, least_kept, seen & face.clear[motion.points])
    reached = motion.arc_length[clear].max(initial=0.0)
    return clear if reached >= _kept(motion, seen, least_kept) else seen


def _kept(motion: Motion, seen: Flags, least: float) -> float:
    """Arc length that a handle must have: a share of the true peak, and no more than any place
    `seen` (p,) has."""
    return min(least * motion.peak, float(motion.arc_length[seen].max(initial=0.0)))


def _where_expected(face: Face, motion: Motion, seen: Flags, expected: Expectation | None) -> Flags:
    """(p,) which points count: those `seen` near the place where the control is expected, or in the
    region around it, if it moves them notably.

    A sneer that lifts the brow more than the nose stands by the nose all the same.  A control that
    hardly moves the place where its name expects it does something else.
    """
    if expected is None or not seen.any():
        return seen
    arc = motion.arc_length
    near, around = expected.regions(face.trajectories.surface.points[motion.points])
    for region, least in ((seen & near, _MOST), (seen & around, _NOTABLE)):
        if arc[region].max(initial=0.0) >= least * arc[seen].max():
            return region
    return seen


def _pruned(
    face: Face,
    motion: Motion,
    seen: Flags,
    some: Flags,
    settings: CandidateSettings,
    samples: int,
) -> Indices:
    """Points at which the control may be anchored, ascending; empty when no view sees what it
    moves.

    `some` (p,) are the points where it may stand, `seen` (p,) those of them that a view sees.
    """
    if not seen.any():
        return np.zeros(0, dtype=np.int64)
    arc = motion.arc_length
    peak = float(arc[seen].max())
    large = arc >= max(settings.peak_share * peak, _kept(motion, seen, settings.least_kept))
    middle = _in_the_middle(face, motion, seen, settings.least_kept)
    moving = (large & (arc >= min(settings.prune_at * float(arc[some].mean()), peak))) | middle
    large |= middle
    for kept in (seen & moving, seen & large):
        if settings.occlusion:
            kept = _without_occluded(face, motion, kept, samples)
        # A corner of the mouth that is drawn back runs into the cheek: its handle stands there
        # nevertheless.
        if arc[kept].max(initial=0.0) >= _MOST * peak:
            return motion.points[kept]
    return motion.points[seen & moving]


def _seen(face: Face, points: Indices, space: str) -> Flags:
    """Which points can be seen from where the layout is judged: its own view alone, where that is
    asked for."""
    return face.views.visible[0, points] if space == "view" else face.views.anywhere[points]


def _without_occluded(face: Face, motion: Motion, kept: Flags, samples: int) -> Flags:
    """(p,) those `kept` whose trajectory does not run largely inside or behind the model."""
    points = motion.points[kept]
    tracks = polylines(motion, face.trajectories.surface.points, points, points, samples)
    hidden = mostly_hidden(
        face.views, tracks, face.trajectories.surface.normals[points], 0.5 * face.handle_width
    )
    clear = kept.copy()
    clear[kept] = ~hidden
    return clear
