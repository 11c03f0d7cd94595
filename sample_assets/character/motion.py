"""A two-second clip: a look aside, a blink, a word, a smile and a wink."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .form import Floats

FIRST_FRAME, LAST_FRAME = 1, 48
FRAMES_PER_SECOND = 24.0

Keys = Sequence[tuple[float, float]]
"""(frame, value), ascending; smooth between keys, held outside."""

_BLINK: Keys = ((6, 0), (9, 1), (10, 1), (14, 0))
_SMILE: Keys = ((24, 0), (33, 0.85), (42, 0.85), (48, 0))
_WEIGHTS: dict[str, Keys] = {
    "eyeBlinkLeft": (*_BLINK, (35, 0), (38, 1), (41, 1), (45, 0)),
    "eyeBlinkRight": _BLINK,
    "browInnerUp": ((12, 0), (17, 0.7), (24, 0)),
    "browOuterUpLeft": ((12, 0), (18, 0.6), (26, 0)),
    "browOuterUpRight": ((26, 0), (36, 0.7), (45, 0)),
    "jawOpen": ((14, 0), (18, 0.55), (21, 0.25), (24, 0.6), (29, 0)),
    "jawLeft": ((16, 0), (20, 0.35), (25, 0)),
    "mouthFunnel": ((18, 0), (21, 0.6), (24, 0)),
    "mouthSmileLeft": _SMILE,
    "mouthSmileRight": _SMILE,
    "cheekSquintLeft": ((30, 0), (38, 0.8), (46, 0)),
    "mouthUpperUpLeft": ((28, 0), (34, 0.25), (42, 0.25), (47, 0)),
    "mouthUpperUpRight": ((28, 0), (34, 0.25), (42, 0.25), (47, 0)),
}
_LOOK: dict[str, Keys] = {
    "x": ((3, 0), (8, 7), (22, -9), (34, 0)),
    "y": ((2, 0), (7, 20), (16, 18), (22, -20), (32, -12), (44, 0)),
}
_TURNS: dict[str, dict[str, Keys]] = {
    "Neck/Head/EyeRight": _LOOK,
    "Neck/Head/EyeLeft": _LOOK,
    "Neck/Head/Jaw": {"x": ((25, 0), (29, 6), (33, 2), (38, 8), (46, 0))},
    "Neck/Head": {
        "x": ((4, 0), (12, 5), (24, -6), (36, 4), (48, 0)),
        "y": ((4, 0), (14, 14), (28, -14), (40, -6), (48, 0)),
        "z": ((4, 0), (14, 5), (26, 0), (37, -5), (48, 0)),
    },
}
"""Rotation vectors in degrees, along the joint's own axes: without torsion, as eyes turn (Listing's law)."""


def weight_curves() -> dict[str, Floats]:
    """(frames,) weight per control that moves."""
    return {name: np.round(_curve(keys), 4) for name, keys in _WEIGHTS.items()}


def joint_turns() -> dict[str, Floats]:
    """(frames, 4) unit quaternions (real part first) per joint that moves, in the order of the animation."""
    return {joint: _quaternions(axes) for joint, axes in _TURNS.items()}


def _quaternions(axes: dict[str, Keys]) -> Floats:
    still = np.zeros(LAST_FRAME - FIRST_FRAME + 1)
    vectors = np.radians(np.column_stack([_curve(axes[axis]) if axis in axes else still for axis in "xyz"]))
    half = np.linalg.norm(vectors, axis=1, keepdims=True) / 2
    return np.asarray(np.round(np.hstack([np.cos(half), vectors * np.sinc(half / np.pi) / 2]), 7) + 0.0)


def _curve(keys: Keys) -> Floats:
    frames, values = np.array(keys, dtype=float).T
    now = np.arange(FIRST_FRAME, LAST_FRAME + 1, dtype=float)
    k = np.clip(np.searchsorted(frames, now, side="right") - 1, 0, len(frames) - 2)
    t = np.clip((now - frames[k]) / (frames[k + 1] - frames[k]), 0.0, 1.0)
    return np.asarray(values[k] + (values[k + 1] - values[k]) * t * t * (3 - 2 * t))
