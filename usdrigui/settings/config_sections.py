"""Sections of a configuration: ``[solve]`` is `Settings.layout.solve`."""

from __future__ import annotations

import types
import typing
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from usdrigui.settings.parts import Settings

_HOLDERS: Mapping[str, tuple[str, ...]] = types.MappingProxyType(
    {
        "": ("run", "output"),
        "rig": ("read", "controls", "poses", "joints"),
        "character": ("trajectories", "symmetry", "parts", "like", "animation"),
        "layout": ("candidates", "groups", "levels", "objective", "solve"),
    }
)
"""The sections of each field of `Settings`, in the order in which they are documented; those of
`Settings` itself under the empty name."""


def section_types() -> dict[str, Any]:
    """By the name of each section, its type."""
    whole = typing.get_type_hints(Settings)
    found: dict[str, Any] = {}
    for holder, names in _HOLDERS.items():
        hints = typing.get_type_hints(whole[holder]) if holder else whole
        found |= {name: hints[name] for name in names}
    return found


def sections(settings: Settings) -> dict[str, Any]:
    """By the name of each section, what it holds."""
    found: dict[str, Any] = {}
    for holder, names in _HOLDERS.items():
        held = getattr(settings, holder) if holder else settings
        found |= {name: getattr(held, name) for name in names}
    return found


def with_sections(settings: Settings, **changed: Any) -> Settings:
    """The settings with other sections of these names."""
    for holder, names in _HOLDERS.items():
        inner = {name: changed[name] for name in names if name in changed}
        if inner and holder:
            inner = {holder: replace(getattr(settings, holder), **inner)}
        settings = replace(settings, **inner)
    return settings
