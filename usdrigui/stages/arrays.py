"""Arrays of attributes, checked: of the right type, finite and in range, or refused by code and
prim."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Usd, Vt

from usdrigui.character import Floats, Indices
from usdrigui.errors import refuse

_INT = np.iinfo(np.int32)
"""All integers of USD's own schemas are of 32 bits."""


def value_at(attribute: Any, time: Usd.TimeCode) -> Any:
    """The value at a time; the earliest sample where there is no default."""
    value = attribute.Get(time)
    return attribute.Get(Usd.TimeCode.EarliestTime()) if value is None else value


def tokens(values: Any, path: object, name: str) -> tuple[str, ...]:
    """The names that an array of tokens holds, none for None; raises ARRAY_TYPE."""
    if values is None:
        return ()
    # A single token could be iterated as well, letter by letter.
    if not isinstance(values, Vt.TokenArray):
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold tokens")
    return tuple(map(str, values))


def integers(values: Any, path: object, name: str) -> Indices:
    """(n,) the integers of an array, none for None; raises ARRAY_TYPE."""
    numbers = _numbers(values, (), path, name)
    if values is None:
        return numbers.astype(np.int64)
    if numbers.dtype.kind not in "iu":
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold integers")
    # Sums of larger ones would wrap around.
    if (
        numbers.dtype.itemsize > 4
        and len(numbers)
        and not _INT.min <= numbers.min() <= numbers.max() <= _INT.max
    ):
        raise refuse("ARRAY_TYPE", path, f"{name} holds integers of more than 32 bits")
    return numbers.astype(np.int64)


def floats(values: Any, path: object, name: str, *, item: tuple[int, ...] = ()) -> NDArray[Any]:
    """(n, *item) the numbers of an array in the precision they have, none for None; raises
    ARRAY_TYPE."""
    numbers = _numbers(values, item, path, name)
    return numbers if numbers.dtype.kind == "f" else numbers.astype(np.float64)


def vectors(values: Any, path: object, name: str) -> NDArray[Any]:
    """(p, 3) finite numbers, without a copy where they are in single precision already; raises
    ARRAY_TYPE."""
    found = floats(values, path, name, item=(3,))
    check_finite(found, path, name)
    return found


def vector_count(values: Any, path: object, name: str) -> int:
    """How many 3-vectors an array holds, finite or not; raises ARRAY_TYPE."""
    return len(_numbers(values, (3,), path, name))


def quaternions(values: Any, path: object, name: str) -> Floats:
    """(n, 4) numbers, real part first, none for None; raises ARRAY_TYPE."""
    if values is None:
        return np.zeros((0, 4))
    if not isinstance(values, (Vt.QuatfArray, Vt.QuathArray, Vt.QuatdArray)):
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold quaternions")
    # In memory the real part comes last.
    return np.asarray(np.roll(np.asarray(values), 1, axis=1), dtype=np.float64)


def _numbers(values: Any, item: tuple[int, ...], path: object, name: str) -> NDArray[Any]:
    """(n, *item) numbers; arrays of USD are viewed, not copied."""
    numbers = np.zeros((0, *item)) if values is None else np.asarray(values)
    if numbers.dtype.kind not in "fiu":
        raise refuse("ARRAY_TYPE", path, f"{name} does not hold numbers")
    if numbers.ndim != 1 + len(item) or numbers.shape[1:] != item:
        raise refuse(
            "ARRAY_TYPE",
            path,
            f"{name} does not hold {f'{item[0]}-vectors' if item else 'single numbers'}",
        )
    return numbers


def check_finite(values: NDArray[np.floating], path: object, name: str) -> None:
    """Raise NOT_FINITE, naming the first place."""
    bad = np.argwhere(~np.isfinite(values))
    if len(bad):
        raise refuse("NOT_FINITE", path, f"{name}[{bad[0, 0]}] is not a finite number")


def check_range(indices: Indices, count: int, path: object, name: str) -> None:
    """Raise INDEX_RANGE unless all lie in 0 to count - 1."""
    if len(indices) and (indices.min() < 0 or indices.max() >= count):
        wrong = indices[(indices < 0) | (indices >= count)][0]
        raise refuse("INDEX_RANGE", path, f"{name} holds {wrong}; only 0 to {count - 1} exist")
