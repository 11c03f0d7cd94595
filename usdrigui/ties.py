"""Choices that do not hang on the last bits of numbers: sums are formed in another order on each
processor.

Numbers that ought to be equal (a symmetric face is full of them) are compared after rounding, and
the first of equals is taken.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_DIGITS = 9
"""Of the largest number; the noise is some six digits below."""


def rounded(values: Floats) -> Floats:
    """The values as shares of the largest magnitude among them, to nine digits: for comparisons,
    not for sums."""
    largest = float(np.abs(values).max(initial=0.0))
    return np.round(values / largest, _DIGITS) if 0.0 < largest < np.inf else values


def steady(values: Floats) -> Floats:
    """The values to six decimals: agreements and shares, whose noise in single precision must
    decide nothing."""
    return np.asarray(np.round(values, 6), dtype=np.float64)


def first_largest(values: Floats) -> int:
    """Index of the largest value, the first of equals."""
    return int(np.argmax(rounded(values)))


def first_smallest(values: Floats) -> int:
    """Index of the smallest value, the first of equals."""
    return int(np.argmin(rounded(values)))


def axis_across(direction: Floats) -> Floats:
    """(3,) the coordinate axis that a direction is most across, the first of equals."""
    return np.asarray(np.eye(3)[first_smallest(np.abs(direction))])


def towards(direction: Floats, reference: Floats) -> Floats:
    """(3,) `direction` or its reverse, whichever goes along `reference`; across it, the one whose
    largest component is positive."""
    along = float(direction @ reference)
    if abs(along) <= 10.0**-_DIGITS * float(np.linalg.norm(reference)):
        along = float(direction[first_largest(np.abs(direction))])
    return direction if along >= 0.0 else np.asarray(-direction)
