"""The labels of one variable: where an element and its images may stand, what that costs and how it
looks there.

Displacement is measured in typical peak displacements, so that the same character in metres and in
centimetres gets the same layout; ``objective.scene_units`` takes the paper's constants literally
instead.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.layout.face import Face
from usdrigui.layout.measured import Measured
from usdrigui.layout.motion.tracks import (
    arc_lengths,
    lengths,
    magnification,
    paths,
    resampled,
    rows_of,
)
from usdrigui.layout.place.terms import displacement_unit, linear_cost, off_plane
from usdrigui.layout.reuse.prior_layout import PriorLayout
from usdrigui.layout.symmetry.orbits import orbit_points
from usdrigui.model import CandidateSet, Choice, Group, Motion
from usdrigui.ties import first_smallest


def labels_of(
    known: Measured,
    sets: Mapping[int, CandidateSet],
    groups: tuple[Group, ...],
    index: int,
) -> tuple[Choice, Floats, Floats]:
    """Candidates that all members and all copies of group `index` share, their costs (R,) without
    the overlap, and displacements (R,).

    Displacement and linear costs are those of the worst member (paper section 3.3), summed over
    copies. `sets` are the candidates by control.
    """
    group, face, requests = groups[index], known.face, known.requests
    mirror, objective = known.settings.symmetry, known.settings.objective
    if group.doubled:
        sets = {control: _on_both_sides(known, sets[control]) for control in group.controls}
    choice = _with_copies(face, group, index, sets[group.controls[0]], mirror.tolerance)
    if group.mirror and not group.doubled and requests.prior.stood_on_face(group.controls):
        choice = _with_earlier_pairs(face, sets, choice, requests.prior)
    cost, displacement = np.zeros(len(choice.anchors)), np.zeros(len(choice.anchors))
    for copy, controls in enumerate(choice.controls):
        worst, least = np.full(len(cost), -np.inf), np.full(len(cost), np.inf)
        importances = (requests.overrides[control].importance for control in controls)
        worth = objective.displacement_weight * max(
            1.0 if each is None else each for each in importances
        )
        for control in controls:
            found, motion = sets[control], sets[control].motion
            unit = displacement_unit(face, motion, objective)
            sources = choice.sources[:, copy]
            moved = (
                drawn_lengths(face, motion, sources)
                if known.pruning.space == "view"
                else arc_lengths(motion, sources)
            ) / unit
            costs = linear_cost(face, motion, found.sources, known.settings)
            rows, shared = rows_of(choice.anchors[:, copy], found.points)
            linear = np.where(shared, costs[rows], np.inf)
            worst = np.maximum(worst, np.where(moved > 0.0, linear - worth * moved, np.inf))
            least = np.minimum(least, moved)
        cost += worst
        displacement += least
    if own_mirror_image(face, group):
        of_joint = all(face.trajectories.motion_of(c).of_joint for c in group.controls)
        cost += off_plane(face, choice.anchors[:, 0], mirror.plane_weight, of_joint=of_joint)
    return choice, cost, displacement


def own_mirror_image(face: Face, group: Group) -> bool:
    """Whether the element is its own mirror image: one in the middle, not doubled."""
    if not face.symmetry.plane.normal.any() or group.mirror or group.images:
        return False
    return {int(face.symmetry.twins[control]) for control in group.controls} == set(group.controls)


def drawn_points(
    face: Face, choice: Choice, samples_each: int, min_track: float
) -> tuple[Floats, Floats]:
    """`samples_each` (u) samples (R, copies, u, d) along the drawn tracks, and handles (R, copies,
    d or 3), along the face's axes for them.

    No track is drawn shorter than `min_track` handle widths.
    """
    least = min_track * face.handle_width
    samples = []
    for copy, controls in enumerate(choice.controls):
        anchors, sources = choice.anchors[:, copy], choice.sources[:, copy]
        tracks = [
            _drawn_track(face, control, anchors, sources, samples_each, least)
            for control in controls
        ]
        samples.append(face.seen(face.drawing_axes, np.hstack(tracks), face.aside[anchors]))
    at = choice.anchors
    handles = face.seen(face.handle_axes, face.surface.points[at], face.aside[at])
    return np.stack(samples, axis=1), handles


def _drawn_track(
    face: Face, control: int, anchors: Indices, sources: Indices, samples: int, least: float
) -> Floats:
    """(R, u, 3) the drawn track of a control at each anchor: its trajectory, enlarged where it is
    too short."""
    motion = face.trajectories.motion_of(control)
    offsets = resampled(paths(motion, sources), samples)
    factor = drawn_magnification(face, motion, sources, least)
    return face.surface.points[anchors][:, None] + factor[:, None, None] * offsets


def drawn_magnification(face: Face, motion: Motion, sources: Indices, least: float) -> Floats:
    """(R,) how much larger than the motion of `sources` a track is drawn, for it to be as long as
    `least` as it is measured: on the screen of a flat layout."""
    return magnification(drawn_lengths(face, motion, sources), least)


def drawn_lengths(face: Face, motion: Motion, sources: Indices) -> Floats:
    """(R,) lengths of the trajectories as they are measured: on the screen of a flat layout
    foreshortened ones are short (paper section 3.3 and fig. 7)."""
    return lengths(face.seen(face.drawing_axes, paths(motion, sources), face.aside[sources]))


def _on_both_sides(known: Measured, found: CandidateSet) -> CandidateSet:
    """The candidates of a doubled control and those of their mirror images that are seen, which it
    moves alike: one side may be all that pruning leaves, or all that is fixed, whose image is taken
    as it is."""
    partner, seen = known.face.symmetry.partner, known.face.views.anywhere
    is_fixed = bool(known.requests.overrides[found.motion.control].anchor)
    places = np.column_stack([found.points, found.sources])
    images = partner[places]
    like = np.isin(images[:, 1], found.motion.points) & (images[:, 0] >= 0)
    like &= is_fixed | seen[images[:, 0]]
    places = np.unique(np.concatenate([places, images[like]]), axis=0)
    _, first = np.unique(places[:, 0], return_index=True)
    return CandidateSet(found.motion, *places[first].T)


def _with_copies(
    face: Face, group: Group, index: int, candidate_set: CandidateSet, tolerance: float
) -> Choice:
    """Anchors and sources of all copies, of those candidates whose images lie on the character."""
    anchors = _images(face, group, candidate_set.points, tolerance)
    sources = _images(face, group, candidate_set.sources, tolerance)
    kept = (anchors >= 0).all(axis=1) & (sources >= 0).all(axis=1)
    if group.doubled:
        # The mirror image of a label of a doubled element is the same layout.
        apart = face.symmetry.apart[anchors]
        kept &= apart[:, 0] >= apart[:, 1]
    return Choice(index, group.copies, anchors[kept], sources[kept])


def _with_earlier_pairs(
    face: Face, sets: Mapping[int, CandidateSet], choice: Choice, prior: PriorLayout
) -> Choice:
    """The choice of a pair with its earlier places, and with places within a handle's width of them
    that have no mirror image: another topology may leave none there."""
    places = [prior.places.get(controls[0]) for controls in choice.controls]
    first, *others = (place for place in places if place is not None)
    if len(places) != 1 + len(others) or min(place.point for place in (first, *others)) < 0:
        return choice
    base = face.surface.points
    mine, theirs = (sets[controls[0]].points for controls in choice.controls)
    lone = np.setdiff1d(mine, choice.anchors[:, 0])
    apart = np.linalg.norm(base[[first.point, *lone]] - first.position, axis=1)
    lone = lone[apart[1:] <= apart[0] + face.handle_width]
    images = face.symmetry.plane.reflected(base[lone])
    nearest = [first_smallest(np.linalg.norm(base[theirs] - image, axis=1)) for image in images]
    rows = [(first.point, others[0].point), *zip(lone, theirs[nearest], strict=True)]
    added = np.array([row for row in rows if row not in set(map(tuple, choice.anchors.tolist()))])
    if not len(added):
        return choice
    anchors, sources = (np.vstack([each, added]) for each in (choice.anchors, choice.sources))
    return replace(choice, anchors=anchors, sources=sources)


def _images(face: Face, group: Group, points: Indices, tolerance: float) -> Indices:
    """(R, copies) images of `points` under the symmetry of the group."""
    if not group.images:
        return points[:, None]
    if group.mirror:
        return np.stack([points, face.symmetry.partner[points]], axis=1)
    orbit = [face.trajectories.motion_of(controls[0]) for controls in group.copies]
    return orbit_points(
        face.surface,
        orbit,
        face.rig.up,
        tolerance * face.surface.face_size,
        points,
    )
