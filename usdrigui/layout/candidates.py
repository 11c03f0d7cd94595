"""Where each control may be anchored (paper section 4.2)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.layout.locality import fixed_anchor, kept_near, proxies
from usdrigui.layout.partial import moves
from usdrigui.layout.terms import Context, linear_cost
from usdrigui.layout.tracks import polylines
from usdrigui.layout.verdicts import Verdict
from usdrigui.layout.visibility import mostly_hidden
from usdrigui.model import Candidates, CandidateSet, Flags, Indices, LeftOff, Motion
from usdrigui.settings import ControlSettings

STAGE = "candidates"

_LOOSE = 0.2
"""Share of the visible peak at which a control may stand when it has no better place."""


def candidates(context: Context) -> Candidates:
    """The candidates of every control that moves something.

    Points are pruned below the mean arc length of the control and below a share of its visible peak,
    where no view sees them and where the trajectory runs inside or behind the model.  Where pruning
    would leave nothing, its weaker reasons give way in the reverse order: a control that any view can
    see always has a candidate.
    """
    sets: list[CandidateSet] = []
    left_off: list[LeftOff] = []
    for index, motion in enumerate(context.trajectories.motions):
        said, name = context.said[motion.control], context.rig.controls[motion.control].name
        if said.exclude:
            left_off.append(LeftOff(name, STAGE, "excluded by the configuration"))
            continue
        verdict = context.verdicts[index]
        points, sources = _with_earlier(context, motion, verdict, *_places(context, motion, verdict, said))
        sets.append(
            CandidateSet(
                motion=index,
                points=points,
                cost=linear_cost(context, motion, sources),
                globally=verdict.family == "global",
                hidden=verdict.family == "hidden",
                composite=verdict.family == "composite",
                coverage=verdict.share,
                sources=sources,
                reason=verdict.reason,
                requested=verdict.family == "requested",
            )
        )
    return Candidates(tuple(sets), tuple(left_off))


def loosened(context: Context, found: CandidateSet) -> CandidateSet:
    """The set with every visible place that the control moves by a fifth of its visible peak: for elements
    whose copies would collide at all of their better places."""
    motion = context.trajectories.motions[found.motion]
    first = context.trajectories.places[motion.points] == motion.points
    seen = _seen(context, motion.points) & first
    if context.said[motion.control].anchor or not seen.any():
        return found
    points = motion.points[seen & (motion.arc_length >= _LOOSE * float(motion.arc_length[seen].max()))]
    points = kept_near(context, context.rig.controls[motion.control].name, context.said[motion.control], points)
    return replace(found, points=points, sources=points, cost=linear_cost(context, motion, points))


def anew(context: Context, found: CandidateSet) -> CandidateSet:
    """The set of a control that stays on the face, as it is in a context that fixes it elsewhere or not at all."""
    motion, verdict = context.trajectories.motions[found.motion], Verdict()
    places = _places(context, motion, verdict, context.said[motion.control])
    points, sources = _with_earlier(context, motion, verdict, *places)
    return replace(found, points=points, sources=sources, cost=linear_cost(context, motion, sources))


def _places(context: Context, motion: Motion, verdict: Verdict, said: ControlSettings) -> tuple[Indices, Indices]:
    """Points at which the control may be anchored, ascending, and whose trajectories are drawn there."""
    name = context.rig.controls[motion.control].name
    peak = motion.points[[int(np.argmax(motion.arc_length))]]
    fixed = fixed_anchor(context.rig, name, said)
    if fixed is not None:
        point = np.array([fixed], dtype=np.int64)
        return point, point if moves(motion, name, said, fixed) else peak
    if verdict.family:
        return peak, peak
    if said.place == "proxy":
        points = proxies(context, int(peak[0]))
        return points, np.repeat(peak, len(points))
    points = _pruned(context, motion)
    if not len(points):
        points = _unseen(context, motion)
    points = kept_near(context, name, said, points)
    return points, points


def _with_earlier(
    context: Context, motion: Motion, verdict: Verdict, points: Indices, sources: Indices
) -> tuple[Indices, Indices]:
    """The places with the one where the control stood before: pruning must not drive away what is there."""
    place = context.precedent.places.get(motion.control)
    own = np.array_equal(points, sources) and not verdict.family and not context.said[motion.control].anchor
    if place is None or place.beside or not own or place.point not in motion.points or place.point in points:
        return points, sources
    points = np.sort(np.append(points, place.point))
    return points, points


def _pruned(context: Context, motion: Motion) -> Indices:
    """Points at which the control may be anchored, ascending; empty when no view sees what it moves."""
    settings = context.settings.candidates
    first = context.trajectories.places[motion.points] == motion.points
    seen = _seen(context, motion.points) & first
    if not seen.any():
        return np.zeros(0, dtype=np.int64)
    arc = motion.arc_length
    peak = float(arc[seen].max())
    large = arc >= settings.peak_share * peak
    moving = large & (arc >= min(settings.prune_at * float(arc[first].mean()), peak))
    for kept in (seen & moving, seen & large):
        points = motion.points[kept]
        if settings.occlusion:
            points = points[~_occluded(context, motion, points)]
        if len(points):
            return np.asarray(points)
    return np.asarray(motion.points[seen & moving])


def _unseen(context: Context, motion: Motion) -> Indices:
    """Candidates of a control that no view sees but that is to stand on the face all the same."""
    settings = context.settings.candidates
    first = context.trajectories.places[motion.points] == motion.points
    least = max(
        settings.prune_at * float(motion.arc_length[first].mean()), settings.peak_share * motion.arc_length.max()
    )
    return np.asarray(motion.points[first & (motion.arc_length >= min(least, float(motion.arc_length.max())))])


def _seen(context: Context, points: Indices) -> Flags:
    """Which points can be seen from where the layout is judged: a flat layout has one view only."""
    views = context.views
    flat = context.settings.candidates.space == "view"
    return np.asarray(views.visible[0, points] if flat else views.anywhere[points])


def _occluded(context: Context, motion: Motion, points: Indices) -> Flags:
    tracks = polylines(motion, context.trajectories.base, points, points, context.settings.objective.samples)
    depth = 0.5 * context.handle_width
    return mostly_hidden(context.views, tracks, context.trajectories.normals[points], depth)
