"""Frozen records as bytes and back: how a reading process hands over what it found.

A stream is a preamble, a JSON header and the arrays, each aligned, in the order of the header's
table:

    magic (8) · header length (u64) · stream length (u64) · CRC-32 of the header (u32) · 4 zero
    bytes · header · arrays

Decoding goes by the annotations of the record that is *expected* (msgspec): the stream names no
classes, so it can build nothing else, and nothing in it is ever executed (no pickle).  Arrays come
back as read-only views of the buffer, without a copy.
"""

from __future__ import annotations

import json
import math
import struct
import zlib
from collections.abc import Iterator, Mapping
from typing import Any, TypeVar, get_args

import msgspec
import numpy as np

MAGIC = b"RIGUIREC"
_PREAMBLE = struct.Struct("<8sQQI4x")
_ALIGNMENT = 64

_UNSOUND = (
    struct.error,
    msgspec.ValidationError,  # no ValueError before msgspec 0.21
    ValueError,
    TypeError,
    KeyError,
    IndexError,
    RecursionError,
)

_T = TypeVar("_T")


class RecordStreamError(Exception):
    """A stream is not what it should be: cut off, damaged, or of another record."""


def encode(record: Any) -> Iterator[memoryview]:
    """The chunks of a stream that holds `record`, to be written one after the other; arrays are not
    copied.

    `record` is a dataclass of dataclasses, arrays, tuples, string-keyed mappings and plain values.
    """
    arrays: list[np.ndarray[Any, Any]] = []
    content = msgspec.to_builtins(record, enc_hook=lambda value: _outgoing(value, arrays))
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
        return msgspec.convert(
            content["record"], kind, dec_hook=lambda hint, value: _incoming(hint, value, arrays)
        )
    except _UNSOUND as error:
        raise RecordStreamError(f"{type(error).__name__}: {error}") from error


def _padded(size: int) -> int:
    return -(-size // _ALIGNMENT) * _ALIGNMENT


def _outgoing(value: Any, arrays: list[np.ndarray[Any, Any]]) -> Any:
    """What JSON does not know as JSON: arrays are moved to the list and replaced by their index."""
    if isinstance(value, Mapping):
        return dict(value)
    if isinstance(value, np.generic):
        return value.item()
    array = np.ascontiguousarray(value).reshape(value.shape)
    arrays.append(array.astype(array.dtype.newbyteorder("<"), copy=False))
    return len(arrays) - 1


def _span(entry: Any, available: int) -> tuple[np.dtype[Any], int, int]:
    """dtype, count and offset of an entry of the array table; `available` bytes follow the
    header."""
    code, shape, offset = entry
    dtype, count = np.dtype(code), math.prod(shape)  # numpy views no bytes as objects
    if not 0 <= offset <= offset + count * dtype.itemsize <= available:
        raise RecordStreamError("an array ends beyond the stream")
    return dtype, count, offset if count else 0


def _incoming(hint: Any, value: Any, arrays: list[np.ndarray[Any, Any]]) -> Any:
    """The array of index `value`, as the annotation `hint` wants it: a numpy.ndarray[shape,
    numpy.dtype[kind]], whatever NDArray is in this release of numpy."""
    (wanted,) = get_args(get_args(hint)[1])
    if type(value) is not int or not 0 <= value < len(arrays):
        raise RecordStreamError(f"there is no array {str(value)[:80]!r}")
    if arrays[value].dtype != np.dtype(wanted):
        raise RecordStreamError(f"an array is of {arrays[value].dtype}, not of {wanted.__name__}")
    return arrays[value]
