"""Trajectories of every point under every control, at the base pose (paper section 3.1)."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import (
    Body,
    Control,
    Flags,
    Floats,
    Indices,
    LeftOff,
    Rig,
    Singles,
)
from usdrigui.character.deform import Posed, Sweep, knots, posed, sweep_start
from usdrigui.character.rays import diagonal
from usdrigui.character.skinning import at_bind_pose
from usdrigui.character.surface import (
    faces_inward,
    mesh_triangles,
    point_areas,
    vertex_normals,
    weld,
)
from usdrigui.errors import Issue, issue
from usdrigui.layout.motion.coverage import NOTABLE, coverage_of_smaller
from usdrigui.layout.motion.owned_skin import BoundSkin, owned_skin
from usdrigui.layout.shares import NEARLY_ALL
from usdrigui.model import BaseSurface, MirrorPlane, Motion, Trajectories
from usdrigui.settings import CandidateSettings, TrajectorySettings

STAGE = "trajectories"

_WHOLE_FACE = CandidateSettings().global_coverage
"""A control that covers more of the smaller ones does not set the size of the face, whatever counts
as global."""
_EMPTY = 1e-7
"""A control that moves nothing further than this share of the character's size is empty."""
_BEYOND = 5.0
"""What is drift or noise reaches this many times the step between its quartile and its middle
beyond the quartile."""
_MOST_DRIFT = 0.15
"""Of the peak; a shape whose middle point moves further moves the head on purpose: one that widens
all of it moves the middle one by .15 to .25."""
_ABSURD = 8.0
"""A control whose peak exceeds the median peak this many times does not set the size of the
face."""


def trajectories(
    rig: Rig, settings: TrajectorySettings, base_values: Floats | None = None
) -> Trajectories:
    """Trajectories of all points under all controls of `rig`, each alone, others held at
    `base_values`.

    `base_values` (controls,) defaults to every control's default.  Polylines are exact for blend
    shapes (a fixed pose bends their straight pieces nowhere) and sampled to `settings.tolerance`
    where joints turn.  Only moving points are held.  Controls that move nothing are left off; tiny
    ones stay and are named in `issues`.
    """
    base = posed(rig, base_values)
    size = diagonal(base.points)
    skin = BoundSkin(replace(rig, body=at_bind_pose(rig.body)))
    motions, left_off = [], []
    for index, control in enumerate(rig.controls):
        start, value = sweep_start(rig, base, base_values, index)
        motion = _motion(rig, skin, start, index, value, settings)
        if motion.arc_length.max(initial=0.0) > _EMPTY * size:
            motions.append(motion)
        else:
            left_off.append(LeftOff(control.name, STAGE, "moves no point of any mesh"))
    excluded = _excluded(rig, skin, size, settings)
    moving = (
        _without_drift(rig.body, rig.controls, motions) if settings.noise > 0.0 else tuple(motions)
    )
    return _assembled(rig, base.points, moving, excluded, tuple(left_off), settings)


def _without_drift(
    body: Body, controls: tuple[Control, ...], motions: Sequence[Motion]
) -> tuple[Motion, ...]:
    """The motions; shapes that move nearly every point, as solvers and scans leave them that were
    not held to the head, without the points that move no more than the rest."""
    counts = np.diff(body.starts)
    return tuple(
        motion
        if len(controls[motion.control].drive.joints)
        else _beyond_drift(motion, int(counts @ _meshes_with(body, motion.points)))
        for motion in motions
    )


def _meshes_with(body: Body, points: Indices) -> Flags:
    """(meshes,) which have one of `points`."""
    found = np.zeros(len(body.meshes), dtype=bool)
    found[np.searchsorted(body.starts, points, side="right") - 1] = True
    return found


def _points(motions: Sequence[Motion]) -> Indices:
    """All points of the motions, one after the other."""
    return np.concatenate([np.zeros(0, int), *(motion.points for motion in motions)])


def _beyond_drift(motion: Motion, count: int) -> Motion:
    """The motion at the points that move further than most of the `count` points of its meshes do
    by drift or noise."""
    # A shape that moves nearly all points of its meshes carries a drift of the head or noise.
    still = count - len(motion.points)
    if still > (1.0 - NEARLY_ALL) * count:
        return motion
    every = np.concatenate([np.zeros(still), motion.arc_length])
    quartile, middle = np.quantile(every, (0.25, 0.5))
    peak = float(motion.arc_length.max())
    if middle > _MOST_DRIFT * peak:
        return motion
    far = motion.arc_length > min(float(quartile + _BEYOND * (middle - quartile)), NOTABLE * peak)
    return motion.of(far)


def of_controls(
    rig: Rig,
    found: Trajectories,
    chosen: Collection[int],
    settings: TrajectorySettings,
) -> Trajectories:
    """The trajectories of some controls alone, which then define how large the face is and what a
    typical control does.

    `chosen` are indices into `Rig.controls`, and behind these into `Rig.excluded`.
    """
    motions = tuple(motion for motion in found.motions if motion.control in chosen)
    left_out = tuple(motion for motion in found.excluded if motion.control in chosen)
    surface = found.surface
    face_size, typical_length = _scale(rig, surface.points, surface.areas, motions, left_out)
    return replace(
        found,
        surface=replace(found.surface, face_size=face_size),
        motions=motions,
        excluded=left_out,
        typical_length=typical_length,
        issues=(
            *(each for each in found.issues if each.code == "NORMALS_INWARD"),
            *_doubtful(rig.controls, motions, face_size, settings.tiny),
        ),
    )


def total_motion(motions: Sequence[Motion], count: int) -> Singles:
    """(count, 3) sum over all controls of the vector from minimum to maximum: distinguishes points
    that touch at rest."""
    total = np.zeros((count, 3), dtype=np.float32)
    for motion in motions:
        total[motion.points] += motion.span
    return total


def _excluded(
    rig: Rig, skin: BoundSkin, size: float, settings: TrajectorySettings
) -> tuple[Motion, ...]:
    """Motions of the controls that the configuration leaves out, from the default pose."""
    alone = replace(rig, controls=rig.excluded)
    start = posed(alone, None)
    found = (
        _motion(alone, skin, start, i, control.default, settings)
        for i, control in enumerate(rig.excluded)
    )
    return tuple(
        replace(motion, control=len(rig.controls) + motion.control)
        for motion in found
        if motion.arc_length.max(initial=0.0) > _EMPTY * size
    )


def _motion(
    rig: Rig,
    skin: BoundSkin,
    start: Posed,
    index: int,
    value: float,
    settings: TrajectorySettings,
) -> Motion:
    values = knots(rig, index)
    if value not in values:
        values = np.union1d(values, [value])
    swept = Sweep(rig, start, index)
    points, offsets = swept.points, swept.offsets(values)
    if len(rig.controls[index].drive.joints):
        values, offsets = _refined(swept, values, offsets, settings)
    # Offsets count from where the point is at the base pose, not at the default.
    start_offsets = offsets[np.searchsorted(values, value)]
    if start_offsets.any():
        offsets = offsets - start_offsets
    arc = _arc_lengths(offsets)
    moving = arc > settings.noise * arc.max(initial=0.0)
    owned = owned_skin(skin, rig.controls[index])
    own = None if owned is None else owned[points]
    motion = Motion(index, points, values, offsets, arc, own)
    return motion if moving.all() else motion.of(moving)


def _refined(
    swept: Sweep, values: Floats, offsets: Singles, settings: TrajectorySettings
) -> tuple[Floats, Singles]:
    """Halve the steps of a curved path until no chord misses the curve's middle by more than the
    tolerance."""
    pending = np.ones(len(values) - 1, dtype=bool)
    while pending.any() and len(values) < settings.max_samples:
        where = np.flatnonzero(pending)[: settings.max_samples - len(values)]
        middles = 0.5 * (values[where] + values[where + 1])
        found = swept.offsets(middles)
        chord = 0.5 * (offsets[where] + offsets[where + 1])
        missed = np.linalg.norm(found - chord, axis=2).max(axis=1, initial=0.0)
        allowed = settings.tolerance * float(_arc_lengths(offsets).max(initial=0.0))
        # The middle is kept, and a chord of half the length misses a smooth curve by a quarter;
        # both halves of a piece stay pending where that is too much.
        pending[where] = missed > 4.0 * allowed
        pending = np.insert(pending, where + 1, pending[where])
        values = np.insert(values, where + 1, middles)
        offsets = np.insert(offsets, where + 1, found, axis=0)
    return values, offsets


def _arc_lengths(offsets: Singles) -> Floats:
    """(p,) lengths of polylines (k, p, 3)."""
    steps = offsets[1:] - offsets[:-1]
    lengths = np.sqrt(np.einsum("kpi,kpi->kp", steps, steps))
    return np.asarray(lengths.sum(axis=0, dtype=np.float64))


def _assembled(
    rig: Rig,
    base: Floats,
    motions: tuple[Motion, ...],
    excluded: tuple[Motion, ...],
    left_off: tuple[LeftOff, ...],
    settings: TrajectorySettings,
) -> Trajectories:
    corners = mesh_triangles(rig.body.meshes)
    motion = total_motion(motions, len(base)).astype(np.float64)
    shown = rig.body.drawn * (np.abs(motion).max(initial=0.0) or 1.0)
    # Points at one position are apart if they move unlike, or lie on a mesh that is not shown.
    places = weld(base, np.column_stack([motion, shown]))
    areas = point_areas(base, corners, places)
    normals = vertex_normals(base, corners, weld(base))
    # A floor or backdrop beside the character may enclose more than it does, and upside down.
    moved = np.repeat(_meshes_with(rig.body, _points(motions)), np.diff(rig.body.starts))
    inward = faces_inward(base, corners[moved[corners[:, 0]]])
    found = "the faces enclose a negative volume; normals are taken the other way round"
    issues = [issue("NORMALS_INWARD", rig.path, found)] if inward else []
    face_size, typical_length = _scale(rig, base, areas, motions, excluded)
    return Trajectories(
        BaseSurface(base, -normals if inward else normals, places, areas, face_size),
        motions,
        excluded,
        typical_length,
        left_off,
        (*issues, *_doubtful(rig.controls, motions, face_size, settings.tiny)),
    )


def _scale(
    rig: Rig,
    base: Floats,
    areas: Floats,
    motions: tuple[Motion, ...],
    excluded: tuple[Motion, ...],
) -> tuple[float, float]:
    """The units of handle sizes and of displacement, of what the motions move: the size of the face
    and the typical length."""
    local = _local(motions, excluded, areas)
    peaks = np.array([motion.peak for motion in motions])
    shown = [motions[i] for i in np.flatnonzero(local)]
    # A joint may own a single point, and all points may rest in one place.
    size = (
        # The height of all that the motions move by at least half of their peak.
        float(np.ptp(base[_moved_most(shown)] @ rig.up) if shown else 0.0)
        or diagonal(base[_points(shown)])
        or diagonal(base)
        or float(peaks.max(initial=0.0))
        or 1.0
    )
    return size, float(np.median(peaks[local])) if local.any() else size


def _local(motions: tuple[Motion, ...], excluded: tuple[Motion, ...], areas: Floats) -> Flags:
    """(motions,) which of them move a part of the face and by no absurd amount; all if none would
    be left.

    Whether one is local does not depend on which others the configuration excludes.
    """
    peaks = np.array([motion.peak for motion in motions])
    if not len(motions):
        return np.zeros(0, dtype=bool)
    covered = coverage_of_smaller((*motions, *excluded), areas)[: len(motions)]
    flags: Flags = (covered < _WHOLE_FACE) & (peaks <= _ABSURD * np.median(peaks))
    return flags if flags.any() else np.ones(len(motions), dtype=bool)


def at_scale_of_a_side(found: Trajectories, plane: MirrorPlane) -> Trajectories:
    """The same at the scale of one hand or foot: of the side that `plane` has on the left, how long
    what moves is along its fingers, wherever they point."""
    points = found.surface.points[_moved_most(found.motions)]
    left = plane.distance(points) >= 0.0
    one = points[left if left.any() else ~left]
    along = one @ np.linalg.svd(one - one.mean(axis=0), full_matrices=False)[2][0]
    size = float(np.ptp(along)) or found.surface.face_size
    return replace(found, surface=replace(found.surface, face_size=size))


def _moved_most(motions: Sequence[Motion]) -> Indices:
    """The points that some motion moves by at least half of its peak, where it stands on them."""
    return np.concatenate(
        [
            motion.points[motion.stands_on() & (motion.arc_length >= 0.5 * motion.peak)]
            for motion in motions
        ]
    )


def _doubtful(
    controls: tuple[Control, ...], motions: tuple[Motion, ...], face_size: float, tiny: float
) -> list[Issue]:
    """Controls that move less than the share `tiny` of the face."""
    shares = {controls[each.control].name: each.arc_length.max() / face_size for each in motions}
    what = "moves no point further than {:.2%} of the face's height"
    return [
        issue("CONTROL_TINY", name, what.format(share))
        for name, share in shares.items()
        if share < tiny
    ]
