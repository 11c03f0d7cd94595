"""Arrays of attributes, checked: of the right type, finite and in range, or refused by code and prim."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Usd

from usdrigui.errors import refuse
from usdrigui.model import Indices


def value_at(attribute: Any, time: Usd.TimeCode) -> Any:
    """The value at a time; the earliest sample where there is no default."""
    value = attribute.Get(time)
    return attribute.Get(Usd.TimeCode.EarliestTime()) if value is None else value


def integers(values: Any, path: str, name: str) -> Indices:
    """The integers of an array, none for None; raises ARRAY_TYPE."""
    if values is None:
        return np.zeros(0, dtype=np.int64)
    numbers = _numbers(values, path, name)
    if numbers.dtype.kind not in "iu":
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold integers")
    return numbers.astype(np.int64)


def floats(values: Any, path: str, name: str) -> NDArray[Any]:
    """The numbers of an array in the precision they have, none for None; raises ARRAY_TYPE."""
    numbers = _numbers(values, path, name)
    return numbers if numbers.dtype.kind == "f" else numbers.astype(np.float64)


def vectors(values: Any, path: str, name: str) -> NDArray[Any]:
    """(p, 3) finite numbers, without a copy where they are in single precision already."""
    vectors = floats(values, path, name)
    if vectors.size % 3:
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold 3-vectors")
    vectors = vectors.reshape(-1, 3)
    check_finite(vectors, path, name)
    return vectors


def _numbers(values: Any, path: str, name: str) -> NDArray[Any]:
    """A numeric array; arrays of USD are viewed, not copied."""
    numbers = np.asarray(() if values is None else values)
    if numbers.dtype.kind not in "fiu":
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold numbers")
    return numbers


def check_finite(values: NDArray[np.floating], path: str, name: str) -> None:
    """Raise NOT_FINITE, naming the first place."""
    # One pass without a temporary; only a sum that is not finite calls for a closer look.
    flat = values.reshape(-1)
    if not np.isfinite(flat @ flat) and not np.isfinite(flat).all():
        where = int(np.flatnonzero(~np.isfinite(values).reshape(len(values), -1).all(axis=1))[0])
        raise refuse("NOT_FINITE", path, f"{name}[{where}] is not a finite number")


def check_range(indices: Indices, count: int, path: str, name: str) -> None:
    """Raise INDEX_RANGE unless all lie in 0 to count - 1."""
    if len(indices) and (indices.min() < 0 or indices.max() >= count):
        wrong = indices[(indices < 0) | (indices >= count)][0]
        raise refuse("INDEX_RANGE", path, f"{name} holds {wrong}; only 0 to {count - 1} exist")
