"""Every number of the settings has bounds, and what lies outside is refused by name before anything is read."""

import dataclasses
import json
import math
import typing
from importlib.resources import files

import pytest

from usdrigui.errors import RigUIError
from usdrigui.settings import Settings, load
from usdrigui.settings.about import settings_table


def _settings(kinds=object):
    """By key, every setting but those in free tables, and what is known of it."""
    return {
        f"{section}.{name}": about
        for section in settings_table()
        if dataclasses.is_dataclass(part := getattr(Settings(), section))
        for name, about in settings_table()[section].items()
        if isinstance(getattr(part, name), kinds) and not isinstance(getattr(part, name), bool)
    }


BOUNDS = {key: about.bounds for key, about in _settings((int, float)).items()}


def test_every_number_has_bounds():
    assert len(BOUNDS) > 30
    assert () not in BOUNDS.values()


def test_every_field_is_documented_and_few_settings_are_for_everybody():
    kinds = {name: (typing.get_args(kind) or [kind])[-1] for name, kind in typing.get_type_hints(Settings).items()}
    named = {name: [field.name for field in dataclasses.fields(kind)] for name, kind in kinds.items()}
    assert named == {name: list(known) for name, known in settings_table().items()}
    assert sum(about.level == "user" for known in settings_table().values() for about in known.values()) <= 60


@pytest.mark.parametrize("key", sorted(BOUNDS))
def test_numbers_beyond_their_bounds_are_refused(key):
    part, name = key.split(".")
    kind, (least, largest) = type(getattr(getattr(Settings(), part), name)), BOUNDS[key]
    load({part: {name: kind(least)}})
    load({part: {name: kind(largest)}})
    for value in (kind(least - 1), kind(largest * 2 + 1)):
        with pytest.raises(RigUIError, match=f"CONFIG_VALUE {key}"):
            load({part: {name: value}})


def test_the_schema_for_editors_holds_every_setting_with_its_bounds():
    schema = json.loads((files("usdrigui.settings") / "editor_schema.json").read_text())
    for key, about in _settings().items():
        part, name = key.split(".")
        found = schema["properties"][part]["properties"][name]
        assert found["description"].startswith(about.doc)
        assert not about.bounds or [found["minimum"], found["maximum"]] == about.bounds
    controls = schema["properties"]["controls"]["additionalProperties"]["properties"]
    assert controls["place"]["enum"] == ["", "face", "board", "proxy"]


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
