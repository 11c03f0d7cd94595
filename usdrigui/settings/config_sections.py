"""Sections of a configuration: ``[solve]`` is `Settings.layout.solve`."""

from __future__ import annotations

import types
import typing
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from usdrigui.settings.parts import Settings

_HOLDERS: Mapping[str, str] = types.MappingProxyType(
    {
        "run": "",
        "read": "rig",
        "trajectories": "character",
        "symmetry": "character",
        "candidates": "layout",
        "groups": "layout",
        "objective": "layout",
        "solve": "layout",
        "output": "",
        "controls": "rig",
        "poses": "rig",
        "joints": "rig",
        "like": "character",
        "levels": "layout",
        "animation": "character",
        "parts": "character",
    }
)
"""The field of `Settings` that holds each section, in the order in which they are documented; empty
where `Settings` itself does."""


def section_types() -> dict[str, Any]:
    """By the name of each section, its type."""
    own = typing.get_type_hints(Settings)
    inner = {group: typing.get_type_hints(own[group]) for group in {*_HOLDERS.values()} - {""}}
    return {name: (inner[group] if group else own)[name] for name, group in _HOLDERS.items()}


def sections(settings: Settings) -> dict[str, Any]:
    """By the name of each section, what it holds."""
    return {
        name: getattr(getattr(settings, group) if group else settings, name)
        for name, group in _HOLDERS.items()
    }


def with_sections(settings: Settings, **changed: Any) -> Settings:
    """The settings with other sections of these names."""
    fields: dict[str, Any] = {}
    for name, section in changed.items():
        if group := _HOLDERS[name]:
            held = fields.get(group, getattr(settings, group))
            fields[group] = replace(held, **{name: section})
        else:
            fields[name] = section
    return replace(settings, **fields)
