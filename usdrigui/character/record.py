"""What all records share: arrays that nobody can change."""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from functools import cache
from typing import Any, dataclass_transform

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]
Texels = NDArray[np.uint8]


@dataclass_transform(eq_default=False, frozen_default=True, field_specifiers=(field,))
class Record:
    """Base of the records: makes each class below it a frozen dataclass, compared by identity, and
    every numpy array in its fields read-only after construction."""

    __slots__ = ()

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        dataclass(frozen=True, eq=False)(cls)

    def __post_init__(self) -> None:
        kind: Any = type(self)
        for name in _names(kind):
            freeze(getattr(self, name))


@cache
def _names(record: Any) -> tuple[str, ...]:
    return tuple(each.name for each in fields(record))


def freeze(value: Any) -> Any:
    """Make `value` (an array, or a tuple of arrays) read-only in place and return it."""
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    elif type(value) is tuple:
        for item in value:
            if isinstance(item, np.ndarray):
                item.setflags(write=False)
    return value
