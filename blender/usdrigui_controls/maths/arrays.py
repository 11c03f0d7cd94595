"""The few names that the copied modules take from usdrigui's records."""

from __future__ import annotations

import numpy as np

Floats = np.ndarray
Indices = np.ndarray


class Record:
    """Base of frozen records; Blender's copy leaves arrays writable."""
