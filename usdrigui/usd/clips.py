"""Every SkelAnimation of a file, frame by frame, whatever character it is of."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from pxr import Gf, Usd, UsdSkel

from usdrigui.errors import refuse
from usdrigui.model import Floats, Performance
from usdrigui.rotation import quaternion_matrices
from usdrigui.usd.stage import open_stage

_MOST_FRAMES = 4096
"""Frames kept of one animation, evenly spread over its length."""


def read_performances(path: Path) -> tuple[Performance, ...]:
    """The animations of a file that have more than one time sample, in stage order.

    Raises ANIMATION_MISSING where there is none, ANIMATION_LENGTH and NOT_FINITE, and as `open_stage`.
    """
    stage = open_stage(path)
    prims = [prim for prim in Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies()) if prim.IsA(UsdSkel.Animation)]
    found = tuple(_performance(path, UsdSkel.Animation(prim)) for prim in prims if len(_times(prim)) > 1)
    if not found:
        what = f"{len(prims)} SkelAnimations, none with" if prims else "no SkelAnimation with"
        raise refuse("ANIMATION_MISSING", str(path), f"has {what} more than one time sample")
    return found


def _times(prim: Usd.Prim) -> list[float]:
    animation = UsdSkel.Animation(prim)
    attributes = (animation.GetBlendShapeWeightsAttr(), animation.GetRotationsAttr())
    return sorted({time for attribute in attributes for time in attribute.GetTimeSamples()})


def _performance(path: Path, animation: UsdSkel.Animation) -> Performance:
    times = _times(animation.GetPrim())
    count = min(_MOST_FRAMES, max(2, int(np.floor(times[-1] - times[0])) + 1))
    frames = np.linspace(times[0], times[-1], count)
    tokens = tuple(str(token) for token in animation.GetBlendShapesAttr().Get() or ())
    joints = tuple(str(joint) for joint in animation.GetJointsAttr().Get() or ())
    return Performance(
        source=path.name,
        path=str(animation.GetPath()),
        times=frames,
        tokens=tokens,
        weights=_sampled(animation.GetBlendShapeWeightsAttr(), frames, len(tokens)),
        joints=joints,
        rotations=_matrices(_sampled(animation.GetRotationsAttr(), frames, len(joints), 4)),
    )


def _sampled(attribute: Usd.Attribute, frames: Floats, width: int, parts: int = 1) -> Floats:
    """(frames, width) values, or (frames, width, 4) quaternions, real part first; zero where nothing is authored."""
    table = np.zeros((len(frames), width, parts))
    where = str(attribute.GetPath())
    for row, time in enumerate(frames.tolist()):
        values = attribute.Get(time)
        if values is None or not width:
            break
        if len(values) != width:
            raise refuse("ANIMATION_LENGTH", where, f"{len(values)} values for {width} names at time {time:g}")
        table[row] = np.array([_components(value) for value in values]).reshape(width, parts)
    if not np.isfinite(table).all():
        raise refuse("NOT_FINITE", where, "the animation holds NaN or infinity")
    return table[..., 0] if parts == 1 else table


def _components(value: float | Gf.Quatf) -> list[float]:
    return [value] if isinstance(value, float) else [value.real, *value.imaginary]


def _matrices(quaternions: Floats) -> Floats:
    """(frames, joints, 3, 3) rotations; the identity for a quaternion of no length."""
    flat = quaternions.reshape(-1, 4)
    length = np.linalg.norm(flat, axis=1, keepdims=True)
    unit = np.where(length > 0.0, flat / np.maximum(length, 1e-30), [1.0, 0.0, 0.0, 0.0])
    return quaternion_matrices(unit).reshape(*quaternions.shape[:2], 3, 3)
