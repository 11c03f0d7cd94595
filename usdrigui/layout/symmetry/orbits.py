"""n-fold symmetry about an axis, as annotated by the user (paper section 3.3, symmetric
elements)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from usdrigui.character import Control, Floats, Indices
from usdrigui.character.joint_tree import level, unit
from usdrigui.errors import Faults, check_known, refuse
from usdrigui.model import BaseSurface, Motion, Trajectories
from usdrigui.settings import ControlSettings


def configured_orbits(
    controls: tuple[Control, ...],
    trajectories: Trajectories,
    overrides: Sequence[ControlSettings],
    index: Mapping[str, int],
) -> tuple[tuple[int, ...], ...]:
    """Motions of every ``orbit`` of the configuration, in its order.

    `overrides` (controls,) is the configuration of each control, `index` finds controls by name,
    old names included. Raises CONFIG_UNKNOWN_CONTROL or CONFIG_VALUE for members that do not exist
    or repeat.
    """
    check_orbits(controls, overrides, index)
    moving = {motion.control: i for i, motion in enumerate(trajectories.motions)}
    found: list[tuple[int, ...]] = []
    for control, override in zip(controls, overrides, strict=True):
        if not override.orbit:
            continue
        where = f'controls."{control.name}".orbit'
        for member in override.orbit:
            if index[member] not in moving:
                raise refuse("CONFIG_VALUE", where, f"{member} moves nothing")
        motions = tuple(moving[index[member]] for member in override.orbit)
        if len(set(motions)) < max(2, len(motions)) or set().union(*found) & set(motions):
            raise refuse("CONFIG_VALUE", where, "an orbit lists two or more controls, each once")
        found.append(motions)
    return tuple(found)


def check_orbits(
    controls: tuple[Control, ...], overrides: Sequence[ControlSettings], index: Mapping[str, int]
) -> None:
    """Raise CONFIG_UNKNOWN_CONTROL for all members of orbits that do not exist; parameters as of
    `configured_orbits`."""
    faults = Faults()
    for control, override in zip(controls, overrides, strict=True):
        for member in override.orbit:
            with faults.collected():
                check_known(member, index, f'controls."{control.name}".orbit')
    faults.raise_all()


def orbit_points(
    surface: BaseSurface,
    orbit: Sequence[Motion],
    up: Floats,
    tolerance: float,
    points: Indices,
) -> Indices:
    """(p, n) images of `points` under the orbit's rotations, the points themselves first; -1 where
    no point lies within the `tolerance`, a length, of the rotated position.  `orbit` are the
    motions of its n members.
    """
    centre, axis = _axis(surface, orbit, up)
    chosen = np.flatnonzero(surface.first)
    tree = cKDTree(surface.points[chosen])
    images = [points]
    for step in range(1, len(orbit)):
        turn = Rotation.from_rotvec(2.0 * np.pi * step / len(orbit) * axis)
        apart, nearest = tree.query(centre + turn.apply(surface.points[points] - centre))
        images.append(np.where(apart <= tolerance, chosen[nearest], -1))
    return np.stack(images, axis=1)


def _axis(surface: BaseSurface, orbit: Sequence[Motion], up: Floats) -> tuple[Floats, Floats]:
    """Centre and unit axis of the rotation that takes each member's region to the next one's."""
    middles = np.stack([_middle(surface, motion) for motion in orbit])
    centre = middles.mean(axis=0)
    if len(orbit) == 2:
        return centre, level(up, unit(middles[1] - middles[0]))
    axis = np.linalg.svd(middles - centre)[2][2]
    turn = np.cross(middles[0] - centre, middles[1] - centre) @ axis
    # With three members 120 degrees apart either sense may be listed; the list decides.
    return centre, (axis if turn >= 0.0 else -axis)


def _middle(surface: BaseSurface, motion: Motion) -> Floats:
    weights = motion.arc_length * np.maximum(surface.areas[motion.points], 1e-300)
    return np.average(surface.points[motion.points], axis=0, weights=weights)
