"""Colours of the character's sides, for the layer, pictures and pages alike.

Near to those that studios use; the character's own left and right.  Chosen by measure: apart from
skin and from each other for every kind of colour vision (docs/decisions/114).
A page's scene holds them, and the Blender extension takes this file along as it is.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Colour = tuple[int, int, int]

SIDES: dict[str, Colour] = {
    "left": (77, 163, 255),
    "right": (242, 20, 32),
    "middle": (188, 240, 0),
    "none": (122, 92, 255),
}
"""In sRGB, 0 to 255."""


def linear(side: str) -> tuple[float, float, float]:
    """The colour of a side in linear light, 0 to 1, to four digits: what `primvars:displayColor`
    holds."""
    red, green, blue = decoded(np.array(SIDES[side]) / 255.0).round(4).tolist()
    return red, green, blue


def decoded(encoded: NDArray[np.float64]) -> NDArray[np.float64]:
    """Linear light of channels of sRGB (IEC 61966-2-1), 0 to 1."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
