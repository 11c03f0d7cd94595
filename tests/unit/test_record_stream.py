"""Records survive the way through bytes unchanged, and bytes that are not theirs never become records."""

from __future__ import annotations

import json
import zlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any, Literal

import makers
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from usdrigui.character import Floats, Indices, Record, Rig
from usdrigui.errors import Issue
from usdrigui.isolation.record_stream import _PREAMBLE, RecordStreamError, decode, encode
from usdrigui.settings import Settings, load


class Leaf(Record):
    name: str
    numbers: Floats
    which: Literal["a", "b"]


class Tree(Record):
    leaves: tuple[Leaf, ...]
    pair: tuple[int, float]
    perhaps: Leaf | None
    flag: bool
    order: Indices
    table: Mapping[str, float]
    anything: Any


def same(one, other):
    """Deep equality, to the bit and the type."""
    if isinstance(one, np.ndarray):
        return one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    if is_dataclass(one):
        return type(one) is type(other) and all(
            same(getattr(one, each.name), getattr(other, each.name)) for each in fields(one)
        )
    if isinstance(one, Mapping):
        return list(one) == list(other) and all(same(one[key], other[key]) for key in one)
    if isinstance(one, tuple):
        return len(one) == len(other) and all(map(same, one, other))
    return type(one) is type(other) and (one == other or one != one)


def sent(record):
    return b"".join(encode(record))


floats = st.floats(allow_nan=True, allow_infinity=True)
shapes = st.lists(st.integers(0, 3), min_size=0, max_size=3)
arrays = shapes.flatmap(
    lambda shape: st.lists(floats, min_size=int(np.prod(shape)), max_size=int(np.prod(shape))).map(
        lambda values: np.array(values, dtype=np.float64).reshape(shape)
    )
)
leaves = st.builds(Leaf, st.text(st.characters(codec=None), max_size=5), arrays, st.sampled_from("ab"))
trees = st.builds(
    Tree,
    st.lists(leaves, max_size=3).map(tuple),
    st.tuples(st.integers(-(2**60), 2**60), floats),
    st.none() | leaves,
    st.booleans(),
    st.lists(st.integers(-(2**62), 2**62), max_size=4).map(lambda values: np.array(values, dtype=np.int64)),
    st.dictionaries(st.text(max_size=3), floats, max_size=3),
    st.recursive(st.none() | st.booleans() | st.text(max_size=3), lambda inner: st.lists(inner, max_size=2)),
)


@given(trees)
@settings(max_examples=150, deadline=None)
def test_any_record_comes_back_as_it_was(tree):
    assert same(tree, replace(decode(sent(tree), Tree), anything=tree.anything))


@given(trees, st.data())
@settings(max_examples=300, deadline=None)
def test_damaged_bytes_are_an_error_or_differ_in_numbers_only(tree, data):
    stream = bytearray(sent(tree))
    place = data.draw(st.integers(0, len(stream) - 1))
    stream[place] ^= data.draw(st.integers(1, 255))
    try:
        found = decode(bytes(stream), Tree)
    except RecordStreamError:
        return
    assert [leaf.name for leaf in found.leaves] == [leaf.name for leaf in tree.leaves]
    assert found.order.shape == tree.order.shape


@given(st.binary(max_size=300))
def test_arbitrary_bytes_are_an_error(stream):
    with pytest.raises(RecordStreamError):
        decode(stream, Tree)


@pytest.mark.parametrize("share", [0.0, 0.1, 0.5, 0.9, 0.999])
def test_a_cut_off_stream_is_an_error(share):
    stream = sent(makers.face())
    with pytest.raises(RecordStreamError):
        decode(stream[: int(share * len(stream))], Rig)


def test_a_record_of_another_kind_is_an_error():
    with pytest.raises(RecordStreamError):
        decode(sent(Issue("BUG", "error", "", "", "")), Rig)


LEAF = Leaf("n", np.zeros(2), "a")
TREE = Tree((LEAF,), (1, 2.0), None, True, np.arange(3), {}, None)


@pytest.mark.parametrize(
    ("change", "value"),
    [
        ("perhaps", replace(LEAF, which="c")),
        ("perhaps", replace(LEAF, name=3)),
        ("perhaps", replace(LEAF, numbers=-2)),
        ("perhaps", Leaf("n", np.zeros(2, dtype=np.float32), "a")),
        ("perhaps", Leaf("n", "text", "a")),
        ("perhaps", 3),
        ("leaves", 3),
        ("pair", (1, 2.0, 3)),
        ("table", [1.0]),
    ],
)
def test_a_field_of_another_type_is_an_error(change, value):
    with pytest.raises(RecordStreamError):
        decode(sent(replace(TREE, **{change: value})), Tree)


def test_numbers_are_those_of_the_annotations():
    assert same(decode(sent(replace(TREE, pair=(np.int64(1), 2))), Tree), TREE)


@pytest.mark.parametrize("forged", [["|O8", [3], 0], ["<i8", [-1], 0]])
def test_arrays_that_are_never_written_are_never_made(forged):
    stream = bytearray(sent(TREE))
    magic, length, total, _ = _PREAMBLE.unpack_from(stream)
    header = json.loads(stream[_PREAMBLE.size :][:length]) | {"arrays": [forged]}
    told = json.dumps(header, separators=(",", ":")).encode().ljust(length)
    stream[: _PREAMBLE.size + length] = _PREAMBLE.pack(magic, length, total, zlib.crc32(told)) + told
    with pytest.raises(RecordStreamError):
        decode(bytes(stream), Tree)


def test_arrays_are_views_that_nobody_can_write():
    rig = decode(sent(makers.face()), Rig)
    points = rig.body.meshes[0].points
    assert points.base is not None
    with pytest.raises(ValueError, match="read-only"):
        points[0] = 0.0


def test_settings_travel_with_their_tables():
    told = load({"controls": {"jaw": {"maximum": 2.0, "orbit": ["a", "b"]}}, "read": {"pose": {"jaw": 0.5}}})
    assert same(told, decode(sent(told), Settings))
