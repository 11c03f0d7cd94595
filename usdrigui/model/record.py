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


class Record:
    """Base of the frozen records: makes every numpy array field read-only after construction."""

    __slots__ = ()

    def __post_init__(self) -> None:
        kind: Any = type(self)
        for name in _array_fields(kind):
            freeze(getattr(self, name))


@cache
def _array_fields(record: Any) -> tuple[str, ...]:
    """Names of the fields that may hold arrays: all but those annotated as a single plain value."""
    plain = {"str", "int", "float", "bool", "Drive", "ControlKind", "ElementKind", "Side"}
    return tuple(
        each.name
        for each in fields(record)
        if each.type not in plain and not str(each.type).startswith("Literal")
    )


def freeze(value: Any) -> Any:
    """Make `value` (an array, or a tuple of arrays) read-only in place and return it."""
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    elif type(value) is tuple:
        for item in value:
            if isinstance(item, np.ndarray):
                item.setflags(write=False)
    return value
