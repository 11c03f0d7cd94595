"""Frozen records as bytes and back: how a reading process hands over what it found.

A stream is a preamble, a JSON header and the arrays, each aligned, in the order of the header's
table:

    magic (8) · header length (u64) · stream length (u64) · CRC-32 of the header (u32) · 4 zero
    bytes · header · arrays

Decoding goes by the annotations of the record that is *expected*: the stream names no classes, so
it can build nothing else, and nothing in it is ever executed (no pickle).  Arrays come back as
read-only views of the buffer, without a copy.
"""

from __future__ import annotations

import json
import math
import struct
import types
import typing
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any, Literal, TypeVar

import numpy as np

from usdrigui.character.record import ARRAY_TYPES

MAGIC = b"RIGUIREC"
_PREAMBLE = struct.Struct("<8sQQI4x")
_ALIGNMENT = 64

_T = TypeVar("_T")


class RecordStreamError(Exception):
    """A stream is not what it should be: cut off, damaged, or of another record."""


def encode(record: Any) -> Iterator[memoryview]:
    """The chunks of a stream that holds `record`, to be written one after the other; arrays are not
    copied.

    `record` is a dataclass of dataclasses, arrays, tuples, string-keyed mappings and plain values.
    """
    arrays: list[np.ndarray[Any, Any]] = []
    content = _outgoing(record, arrays)
    offset, table = 0, []
    for array in arrays:
        table.append([array.dtype.str, list(array.shape), offset])
        offset += _padded(array.nbytes)
    header = json.dumps({"arrays": table, "record": content}, separators=(",", ":")).encode()
    header += b" " * (_padded(_PREAMBLE.size + len(header)) - _PREAMBLE.size - len(header))
    total = _PREAMBLE.size + len(header) + offset
    yield memoryview(_PREAMBLE.pack(MAGIC, len(header), total, zlib.crc32(header)) + header)
    for array in arrays:
        if array.nbytes:
            yield memoryview(array.data).cast("B")
            yield memoryview(bytes(_padded(array.nbytes) - array.nbytes))


def decode(stream: Any, kind: type[_T]) -> _T:
    """The record of class `kind` in `stream`, any read-only buffer; its arrays are views of it.

    Raises RecordStreamError for everything that `encode` of such a record would not have written.
    """
    view = memoryview(stream)
    try:
        magic, length, total, checksum = _PREAMBLE.unpack_from(view)
        if magic != MAGIC or total != len(view) or length > total - _PREAMBLE.size:
            raise RecordStreamError("the stream is cut off or has another format")
        header = bytes(view[_PREAMBLE.size : _PREAMBLE.size + length])
        if zlib.crc32(header) != checksum:
            raise RecordStreamError("the header is damaged")
        content = json.loads(header)
        body = view[_PREAMBLE.size + length :]
        arrays = [
            np.frombuffer(body, *_span(entry, len(body))).reshape(entry[1])
            for entry in content["arrays"]
        ]
        return typing.cast(_T, _record(kind, content["record"], arrays))
    except (struct.error, ValueError, TypeError, KeyError, IndexError, RecursionError) as error:
        raise RecordStreamError(f"{type(error).__name__}: {error}") from error


def _padded(size: int) -> int:
    return -(-size // _ALIGNMENT) * _ALIGNMENT


def _outgoing(value: Any, arrays: list[np.ndarray[Any, Any]]) -> Any:
    """`value` as JSON, its arrays moved to the list and replaced by their index."""
    if isinstance(value, np.ndarray):
        array = np.ascontiguousarray(value).reshape(value.shape)
        arrays.append(array.astype(array.dtype.newbyteorder("<"), copy=False))
        return len(arrays) - 1
    if is_dataclass(value):
        return {each.name: _outgoing(getattr(value, each.name), arrays) for each in fields(value)}
    if isinstance(value, Mapping):
        return {key: _outgoing(item, arrays) for key, item in value.items()}
    if isinstance(value, (tuple, list)):
        return [_outgoing(item, arrays) for item in value]
    return value.item() if isinstance(value, np.generic) else value


def _span(entry: Any, available: int) -> tuple[np.dtype[Any], int, int]:
    """dtype, count and offset of an entry of the array table; `available` bytes follow the
    header."""
    code, shape, offset = entry
    dtype, count = np.dtype(code), math.prod(shape)  # numpy views no bytes as objects
    if not 0 <= offset <= offset + count * dtype.itemsize <= available:
        raise RecordStreamError("an array ends beyond the stream")
    return dtype, count, offset if count else 0


# --- by annotation --------------------------------------------------------------------------------


def _record(kind: Any, value: Any, arrays: list[Any]) -> Any:
    hints = _hints(kind)
    if not isinstance(value, dict) or value.keys() != hints.keys():
        raise RecordStreamError(f"the fields of {kind.__name__} differ")
    return kind(**{name: _incoming(hint, value[name], arrays) for name, hint in hints.items()})


@cache
def _hints(kind: Any) -> dict[str, Any]:
    hints = typing.get_type_hints(kind)
    return {each.name: hints[each.name] for each in fields(kind)}


def _incoming(hint: Any, value: Any, arrays: list[Any]) -> Any:
    """`value` as the annotation `hint` wants it."""
    if hint is Any:
        return value
    if is_dataclass(hint):
        return _record(hint, value, arrays)
    if hint in ARRAY_TYPES:
        return _array(hint, value, arrays)
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is None:
        return _plain(hint, value)
    if origin in (types.UnionType, typing.Union):
        return None if value is None else _incoming(arguments[0], value, arrays)
    if origin is Literal:
        return _checked(value in arguments, value)
    if origin is tuple:
        return _tuple(arguments, value, arrays)
    _checked(isinstance(value, dict), value)
    return types.MappingProxyType(
        {key: _incoming(arguments[1], item, arrays) for key, item in value.items()}
    )


def _plain(hint: Any, value: Any) -> Any:
    if hint is float and type(value) is int:
        return float(value)
    return _checked(type(value) is hint, value)


def _array(hint: Any, value: Any, arrays: list[Any]) -> Any:
    _checked(type(value) is int and 0 <= value < len(arrays), value)
    _checked(arrays[value].dtype == np.dtype(ARRAY_TYPES[hint]), arrays[value].dtype)
    return arrays[value]


def _tuple(arguments: tuple[Any, ...], value: Any, arrays: list[Any]) -> Any:
    _checked(isinstance(value, list), value)
    if len(arguments) == 2 and arguments[1] is Ellipsis:
        return tuple(_incoming(arguments[0], item, arrays) for item in value)
    return tuple(_incoming(each, item, arrays) for each, item in zip(arguments, value, strict=True))


def _checked(right: bool, value: Any) -> Any:
    if not right:
        raise RecordStreamError(f"{str(value)[:80]!r} does not have the type of the record's field")
    return value
