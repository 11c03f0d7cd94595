"""Paths of points around any pose, and how far each control moves anything."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from usdrigui.deform import Posed, channel_state, knots, posed, sweep
from usdrigui.model import Control, Floats, Indices, Rig, Singles

_SAMPLES = 9
"""Values at which paths under joints are sampled."""


def longest_paths(rig: Rig, values: ArrayLike | None = None) -> Floats:
    """(controls,) longest path that each control gives any point, others at ``values``: for `direct.grab`.

    Looks at all points, which takes a fraction of a second on a large rig; once per session is enough.
    """
    at = np.array([control.default for control in rig.controls] if values is None else values, dtype=np.float64)
    base = posed(rig, at)
    found = np.zeros(len(rig.controls))
    for j in range(len(rig.controls)):
        _, offsets = paths_around(rig, base, at, j, values_along(rig, j))
        if offsets.shape[1]:
            found[j] = float(np.linalg.norm(np.diff(offsets, axis=0), axis=2).sum(axis=0).max())
    return found


def paths_around(rig: Rig, held: Posed, values: Floats, control: int, at: Floats) -> tuple[Indices, Singles]:
    """Points that one control moves (p,), and their offsets (k, p, 3) from a pose as it takes values ``at`` (k,).

    ``held`` is the rig at ``values`` (controls,).  Other than `deform.sweep`, from which it is made, this
    holds for poses in which the control itself is not at its default.
    """
    subject = rig.controls[control]
    if values[control] == subject.default:
        return sweep(rig, held, control, at)
    without = values.copy()
    without[control] = subject.default
    if len(subject.drive.joints):
        base = posed(rig, without)
    else:
        alone = np.array([each.default for each in rig.controls])
        alone[control] = values[control]
        base = replace(held, weights=held.weights - (channel_state(rig, alone)[0] - rig.base_weights))
    points, offsets = sweep(rig, base, control, np.append(at, values[control]))
    return points, offsets[:-1] - offsets[-1]


def values_along(rig: Rig, control: int) -> Floats:
    """Values at which a control's paths are sampled; exact where only shapes act."""
    at = knots(rig, control)
    if len(rig.controls[control].drive.joints):
        at = np.union1d(at, np.linspace(at[0], at[-1], _SAMPLES))
    return at if len(at) > 1 else ends(rig.controls[control])


def ends(control: Control) -> Floats:
    """(2,) minimum and maximum; a control without range gets one of 1."""
    low, high = control.minimum, control.maximum
    return np.array([low, high if high > low else low + 1.0])
