"""What all records share: arrays that nobody can change."""

from __future__ import annotations

from dataclasses import fields
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]
ARRAY_TYPES: dict[Any, type[np.generic]] = {
    Floats: np.float64,
    Singles: np.float32,
    Indices: np.int64,
    Flags: np.bool_,
}
"""What the arrays of a field hold, by its annotation: what NDArray is differs between releases of
numpy."""


class Record:
    """Base of the frozen records: makes every numpy array field read-only after construction."""

    __slots__ = ()

    def __post_init__(self) -> None:
        kind: Any = type(self)
        for name in _names(kind):
            freeze(getattr(self, name))


@cache
def _names(record: Any) -> tuple[str, ...]:
    return tuple(field.name for field in fields(record))


def freeze(value: Any) -> Any:
    """Make `value` (an array, or a tuple of arrays) read-only in place and return it."""
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    elif type(value) is tuple:
        for item in value:
            if isinstance(item, np.ndarray):
                item.setflags(write=False)
    return value
