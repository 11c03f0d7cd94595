"""n-fold symmetry about an axis, as annotated by the user (paper section 3.3, symmetric elements)."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from usdrigui.errors import meant, refuse
from usdrigui.layout.remarks import control_index
from usdrigui.layout.terms import Context
from usdrigui.model import Floats, Indices, Motion


def configured_orbits(context: Context) -> tuple[tuple[int, ...], ...]:
    """Motions of every ``orbit`` of the configuration, in its order.

    Raises CONFIG_UNKNOWN_CONTROL or CONFIG_VALUE for members that do not exist or repeat."""
    controls = control_index(context.rig, context.settings)
    moving = {motion.control: i for i, motion in enumerate(context.trajectories.motions)}
    found: list[tuple[int, ...]] = []
    for control, said in zip(context.rig.controls, context.said, strict=True):
        if not said.orbit:
            continue
        where = f'controls."{control.name}".orbit'
        for member in said.orbit:
            if controls.get(member, -1) not in moving:
                known = (name for name, index in controls.items() if index in moving)
                what = f"no control that moves anything is called {member!r}{meant(member, known)}"
                raise refuse("CONFIG_UNKNOWN_CONTROL", where, what)
        motions = tuple(moving[controls[member]] for member in said.orbit)
        if len(set(motions)) < max(2, len(motions)) or {i for orbit in found for i in orbit} & set(motions):
            raise refuse("CONFIG_VALUE", where, "an orbit lists two or more controls, each once")
        found.append(motions)
    return tuple(found)


def orbit_points(context: Context, orbit: tuple[int, ...], points: Indices) -> Indices:
    """(p, n) images of `points` under the orbit's rotations, the points themselves first; -1 where no point
    lies within the symmetry's tolerance of the rotated position."""
    centre, axis = _axis(context, orbit)
    places = context.trajectories.places
    chosen = np.flatnonzero(places == np.arange(len(places)))
    tree = cKDTree(context.trajectories.base[chosen])
    tolerance = context.settings.symmetry.tolerance * context.trajectories.face_size
    images = [points]
    for step in range(1, len(orbit)):
        turned = _turned(context.trajectories.base[points], centre, axis, 2.0 * np.pi * step / len(orbit))
        apart, nearest = tree.query(turned)
        images.append(np.where(apart <= tolerance, chosen[nearest], -1))
    return np.stack(images, axis=1)


def _axis(context: Context, orbit: tuple[int, ...]) -> tuple[Floats, Floats]:
    """Centre and unit axis of the rotation that takes each member's region to the next one's."""
    middles = np.stack([_middle(context, context.trajectories.motions[i]) for i in orbit])
    centre = middles.mean(axis=0)
    if len(orbit) == 2:
        apart = middles[1] - middles[0]
        apart = apart / max(float(np.linalg.norm(apart)), 1e-300)
        axis = context.rig.up - (context.rig.up @ apart) * apart
        return centre, np.asarray(axis / max(float(np.linalg.norm(axis)), 1e-300))
    axis = np.linalg.svd(middles - centre)[2][2]
    turn = np.cross(middles[0] - centre, middles[1] - centre) @ axis
    # With three members 120 degrees apart either sense may be listed; the list decides.
    return centre, np.asarray(axis if turn >= 0.0 else -axis)


def _middle(context: Context, motion: Motion) -> Floats:
    weights = motion.arc_length * np.maximum(context.areas[motion.points], 1e-300)
    return np.asarray(np.average(context.trajectories.base[motion.points], axis=0, weights=weights))


def _turned(points: Floats, centre: Floats, axis: Floats, angle: float) -> Floats:
    """`points` rotated about the axis through the centre (Rodrigues)."""
    arm = points - centre
    along = (arm @ axis)[:, None] * axis
    turned = along + np.cos(angle) * (arm - along) + np.sin(angle) * np.cross(axis, arm)
    return np.asarray(centre + turned, dtype=np.float64)
