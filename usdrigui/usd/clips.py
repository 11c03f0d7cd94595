"""Every SkelAnimation of a file, frame by frame, whatever character it is of."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from pxr import Usd, UsdSkel

from usdrigui.errors import refuse
from usdrigui.model import Floats, Performance
from usdrigui.rotation import quaternion_matrices
from usdrigui.usd.arrays import floats, quaternions, tokens
from usdrigui.usd.stage import open_stage

_MOST_FRAMES = 4096
"""Frames kept of one animation, evenly spread over its length."""


def read_performances(path: Path) -> tuple[Performance, ...]:
    """The animations of a file that have more than one time sample, in stage order.

    Raises ANIMATION_MISSING where there is none, ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE, and
    as `open_stage`.
    """
    stage = open_stage(path)
    prims = [
        prim
        for prim in Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies())
        if prim.IsA(UsdSkel.Animation)
    ]
    found = tuple(
        _performance(path, UsdSkel.Animation(prim)) for prim in prims if len(_times(prim)) > 1
    )
    if not found:
        what = f"{len(prims)} SkelAnimations, none with" if prims else "no SkelAnimation with"
        raise refuse("ANIMATION_MISSING", str(path), f"has {what} more than one time sample")
    return found


def _times(prim: Usd.Prim) -> list[float]:
    animation = UsdSkel.Animation(prim)
    attributes = (animation.GetBlendShapeWeightsAttr(), animation.GetRotationsAttr())
    return sorted({time for attribute in attributes for time in attribute.GetTimeSamples()})


def _performance(path: Path, animation: UsdSkel.Animation) -> Performance:
    times, where = _times(animation.GetPrim()), str(animation.GetPath())
    length = times[-1] - times[0]
    if not np.isfinite(length):
        raise refuse(
            "NOT_FINITE", where, f"its time samples reach from {times[0]:g} to {times[-1]:g}"
        )
    frames = np.linspace(times[0], times[-1], max(2, int(min(_MOST_FRAMES - 1, length)) + 1))
    names = tokens(animation.GetBlendShapesAttr().Get(), where, "blendShapes")
    joints = tokens(animation.GetJointsAttr().Get(), where, "joints")
    return Performance(
        source=path.name,
        path=where,
        times=frames,
        tokens=names,
        weights=_sampled(animation.GetBlendShapeWeightsAttr(), frames, len(names)),
        joints=joints,
        rotations=_matrices(_sampled(animation.GetRotationsAttr(), frames, len(joints), 4)),
    )


def _sampled(attribute: Usd.Attribute, frames: Floats, width: int, parts: int = 1) -> Floats:
    """(frames, width) values, or (frames, width, 4) quaternions, real part first; zero where
    nothing is authored."""
    table = np.zeros((len(frames), width, parts))
    where, read = str(attribute.GetPath()), floats if parts == 1 else quaternions
    for row, time in enumerate(frames.tolist()):
        values = attribute.Get(time)
        if values is None or not width:
            break
        numbers = read(values, str(attribute.GetPrimPath()), attribute.GetName())
        if len(numbers) != width:
            raise refuse(
                "ANIMATION_LENGTH",
                where,
                f"{len(numbers)} values for {width} names at time {time:g}",
            )
        table[row] = numbers.reshape(width, parts)
    if not np.isfinite(table).all():
        raise refuse("NOT_FINITE", where, "the animation holds NaN or infinity")
    return table[..., 0] if parts == 1 else table


def _matrices(quaternions: Floats) -> Floats:
    """(frames, joints, 3, 3) rotations; the identity for a quaternion of no length."""
    flat = quaternions.reshape(-1, 4)
    length = np.linalg.norm(flat, axis=1, keepdims=True)
    unit = np.where(length > 0.0, flat / np.maximum(length, 1e-30), [1.0, 0.0, 0.0, 0.0])
    return quaternion_matrices(unit).reshape(*quaternions.shape[:2], 3, 3)
