"""Colours as files and screens have them, sRGB (IEC 61966-2-1), and as linear light."""

from __future__ import annotations

import numpy as np

from usdrigui.character.record import Floats


def encoded(linear: Floats) -> Floats:
    """sRGB of linear light, both from 0 to 1."""
    clipped = np.clip(linear, 0.0, 1.0)
    return np.where(clipped <= 0.0031308, 12.92 * clipped, 1.055 * clipped ** (1.0 / 2.4) - 0.055)


def decoded(srgb: Floats) -> Floats:
    """Linear light of sRGB, both from 0 to 1."""
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
