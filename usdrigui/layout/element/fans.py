"""The order of a fan's members around their anchor (paper section 3.2, multi-parameter fan)."""

from __future__ import annotations

import numpy as np

from usdrigui.character import Floats
from usdrigui.character.joint_tree import unit
from usdrigui.ties import axis_across, first_largest


def fan_order(tangents: Floats, normal: Floats) -> tuple[int, ...]:
    """Order of members by the angle of their tangents in the tangent plane, counter-clockwise about
    `normal`.

    `tangents` (k, 3), `normal` (3,).  It starts after the widest gap, so that members which span
    less than a full turn follow each other without a break.
    """
    angles = _angles(tangents, normal)
    order = np.argsort(angles, kind="stable")
    gaps = np.diff(np.append(angles[order], angles[order[0]] + 2.0 * np.pi))
    return tuple(np.roll(order, -(first_largest(gaps) + 1)).tolist())


def _angles(tangents: Floats, normal: Floats) -> Floats:
    """(k,) angles of the tangents' projections in the tangent plane, from an arbitrary
    direction."""
    across = unit(np.cross(normal, axis_across(normal)))
    return np.arctan2(tangents @ np.cross(normal, across), tangents @ across)
