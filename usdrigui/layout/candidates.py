"""Where each control may be anchored, and which controls do not belong on the face (paper section 4.2)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.layout.composites import composites
from usdrigui.layout.reach import covering
from usdrigui.layout.terms import Context, linear_cost
from usdrigui.layout.tracks import polylines
from usdrigui.layout.vanishing import vanishing
from usdrigui.layout.visibility import mostly_hidden
from usdrigui.model import Candidates, CandidateSet, Flags, Floats, Indices, LeftOff, Motion
from usdrigui.settings import ControlSettings

STAGE = "candidates"

_UNMOVED_SHARE = 0.1
"""Paper section 4.2: a control is global when fewer points than this share move less than its mean."""


def candidates(context: Context) -> Candidates:
    """The candidates of every control that moves something.

    Points are pruned below the mean arc length of the control and below a share of its visible peak,
    where no view sees them and where the trajectory runs inside or behind the model.  Where pruning
    would leave nothing, its weaker reasons give way in the reverse order: a control that any view can
    see always has a candidate.
    """
    trajectories = context.trajectories
    coverage = _coverage(context)
    gone = vanishing(context)
    repeated = composites(context)
    sets: list[CandidateSet] = []
    left_off: list[LeftOff] = []
    for index, motion in enumerate(trajectories.motions):
        name = context.rig.controls[motion.control].name
        said = context.settings.controls.get(name, ControlSettings())
        if said.exclude:
            left_off.append(LeftOff(name, STAGE, "excluded by the configuration"))
            continue
        found = _candidate_set(context, index, motion, float(coverage[index]))
        if gone[index]:
            found = replace(found, globally=True, hidden=False, reason="makes parts of the character disappear")
        if not (found.globally or found.hidden) and index in repeated:
            found = replace(found, composite=True, reason=repeated[index])
        sets.append(found)
    return Candidates(tuple(sets), tuple(left_off))


def _candidate_set(context: Context, index: int, motion: Motion, coverage: float) -> CandidateSet:
    settings = context.settings.candidates
    points = _pruned(context, motion)
    hidden = not len(points) or _visible_share(context, motion) < settings.hidden_share
    globally = coverage > settings.global_coverage or _moves_everything(context, motion)
    reason = "moves the face as a whole" if globally else "moves only what no view shows" if hidden else ""
    if not len(points):
        points = motion.points[[int(np.argmax(motion.arc_length))]]
    return CandidateSet(
        motion=index,
        points=points,
        cost=linear_cost(context, motion, points),
        globally=globally,
        hidden=hidden,
        composite=False,
        coverage=coverage,
        sources=points,
        reason=reason,
    )


def _pruned(context: Context, motion: Motion) -> Indices:
    """Points at which the control may be anchored, ascending; empty when no view sees what it moves."""
    settings = context.settings.candidates
    first = context.trajectories.places[motion.points] == motion.points
    seen = context.views.anywhere[motion.points] & first
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


def _occluded(context: Context, motion: Motion, points: Indices) -> Flags:
    tracks = polylines(motion, context.trajectories.base, points, points, context.settings.objective.samples)
    depth = 0.5 * context.handle_width
    return mostly_hidden(context.views, tracks, context.trajectories.normals[points], depth)


def _visible_share(context: Context, motion: Motion) -> float:
    """Share of what the control moves, area times distance, that some view sees."""
    weight = context.areas[motion.points] * motion.arc_length
    total = float(weight.sum())
    seen = context.views.anywhere[motion.points]
    return float(weight[seen].sum()) / total if total > 0.0 else float(seen.mean())


def _coverage(context: Context) -> Floats:
    """(motions,) share of the visible face that each control moves notably."""
    seen = np.where(context.views.anywhere, context.areas, 0.0)
    return covering(context.trajectories.motions, seen)


def _moves_everything(context: Context, motion: Motion) -> bool:
    """The paper's own criterion for a global control."""
    count = len(context.trajectories.base)
    still = motion.arc_length < 0.999 * motion.arc_length.mean()
    return bool(count - len(motion.points) + still.sum() < _UNMOVED_SHARE * count)
