"""Authored animation, sampled."""

from __future__ import annotations

from dataclasses import dataclass

from usdrigui.model.record import Floats, Record


@dataclass(frozen=True, eq=False)
class Clip(Record):
    """What USD evaluates of the animation, one frame where nothing moves; empty arrays where
    nothing is authored."""

    times: Floats
    """(f,) time codes."""
    weights: Floats
    """(f, len(Body.channels)) absolute weights."""
    locals: Floats
    """(f, len(Body.joints), 4, 4) local joint transforms."""
    frames_per_second: float


@dataclass(frozen=True, eq=False)
class Performance(Record):
    """One SkelAnimation, sampled frame by frame, whatever character it is of."""

    source: str
    """Name of its file."""
    path: str
    """Prim path."""
    times: Floats
    """(f,) time codes, evenly spaced."""
    tokens: tuple[str, ...]
    weights: Floats
    """(f, len(tokens)) blend-shape weights."""
    joints: tuple[str, ...]
    """Joint tokens."""
    rotations: Floats
    """(f, len(joints), 3, 3) local rotations."""
