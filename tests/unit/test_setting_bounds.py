"""Every number of the settings has bounds, and what lies outside is refused by name before anything is read."""

from __future__ import annotations

import dataclasses
import math

import pytest

from usdrigui.errors import RigUIError
from usdrigui.settings import Settings, load
from usdrigui.settings.bounds import _BOUNDS


def _numbers():
    """Keys of all numbers that have a default, but for those in free tables."""
    parts = {each.name: getattr(Settings(), each.name) for each in dataclasses.fields(Settings)}
    return {
        f"{name}.{each.name}"
        for name, part in parts.items()
        if dataclasses.is_dataclass(part)
        for each in dataclasses.fields(part)
        if type(getattr(part, each.name)) in (int, float)
    }


def test_every_number_has_bounds():
    assert len(_numbers()) > 30
    assert _numbers() == set(_BOUNDS)


@pytest.mark.parametrize("key", sorted(_BOUNDS))
def test_numbers_beyond_their_bounds_are_refused(key):
    part, name = key.split(".")
    kind, (least, largest) = type(getattr(getattr(Settings(), part), name)), _BOUNDS[key]
    load({part: {name: kind(least)}})
    load({part: {name: kind(largest)}})
    for value in (kind(least - 1), kind(largest * 2 + 1)):
        with pytest.raises(RigUIError, match=f"CONFIG_VALUE {key}"):
            load({part: {name: value}})


@pytest.mark.parametrize("key", ["importance", "within", "glyph_size"])
def test_numbers_of_controls_have_bounds_too(key):
    with pytest.raises(RigUIError, match=f'CONFIG_VALUE controls."jaw".{key}'):
        load({"controls": {"jaw": {key: -1.0}}})


@pytest.mark.parametrize("value", [math.inf, -math.inf, math.nan, 10**400])
def test_numbers_without_measure_are_refused(value):
    for table, key in (
        ({"solve": {"gap": value}}, "solve.gap"),
        ({"read": {"time": value}}, "read.time"),
        ({"controls": {"jaw": {"maximum": value}}}, 'controls."jaw".maximum'),
        ({"read": {"pose": {"jaw": value}}}, 'read.pose."jaw"'),
    ):
        with pytest.raises(RigUIError, match=f"CONFIG_VALUE {key}: expected a number"):
            load(table)
