"""Numbers that settings may have."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

from usdrigui.errors import Faults, meant, refuse
from usdrigui.settings.parts import Settings
from usdrigui.settings.table import settings_in

_VIEWS = ("", "front", "side")
"""Views with names; others are a camera's prim path, or two angles."""


def check_bounds(settings: Settings, faults: Faults) -> None:
    """Collects RigUIError CONFIG_VALUE, naming the key, for numbers outside their bounds and a view
    that is none."""
    view = settings.candidates.view
    if view not in _VIEWS and not view.startswith("/"):
        with faults.collected():
            view_angles(view)
    for part in fields(settings):
        found = getattr(settings, part.name)
        if isinstance(found, Mapping):
            for name, each in found.items():
                _check_part(f'{part.name}."{name}"', each, faults)
        else:
            _check_part(part.name, found, faults)


def _check_part(where: str, part: Any, faults: Faults) -> None:
    for each, about in settings_in(part):
        if about.bounds is not None:
            with faults.collected():
                _check(f"{where}.{each.name}", getattr(part, each.name), *about.bounds)


def _check(key: str, value: float | None, least: float, largest: float) -> None:
    if value is not None and not least <= value <= largest:
        raise refuse("CONFIG_VALUE", key, f"expected {least:g} to {largest:g}, got {value:g}")


def view_angles(view: str) -> tuple[float, float]:
    """Azimuth (to the character's left) and elevation of a view ``AZ,EL``, degrees; raises
    CONFIG_VALUE for none."""
    try:
        azimuth, elevation = map(float, view.split(","))
    except ValueError:
        azimuth = elevation = math.nan
    if not (math.isfinite(azimuth) and math.isfinite(elevation)):
        what = (
            f"{view!r} is neither front, side, AZ,EL nor a camera's prim path{meant(view, _VIEWS)}"
        )
        raise refuse("CONFIG_VALUE", "candidates.view", what)
    return azimuth, elevation
