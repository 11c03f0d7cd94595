"""Numbers that settings may have."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from usdrigui.errors import Faults, RigUIError, issue, meant, refuse
from usdrigui.settings.config_sections import sections, with_sections
from usdrigui.settings.parts import Settings
from usdrigui.settings.table import settings_in

_VIEWS = ("", "front", "side")
"""Views with names; others are a camera's prim path, or two angles."""


def bounded(settings: Settings, faults: Faults) -> Settings:
    """The settings with the default for each number outside its bounds, and for a view that is
    none.

    Collects RigUIError CONFIG_VALUE for them, naming the key.
    """
    sound = {
        name: _bounded_table(name, section, faults) for name, section in sections(settings).items()
    }
    candidates = sound["candidates"]
    sound["candidates"] = replace(candidates, view=_sound_view(candidates.view, faults))
    return with_sections(settings, **sound)


def _sound_view(view: str, faults: Faults) -> str:
    if view not in _VIEWS and not view.startswith("/"):
        try:
            view_angles(view)
        except RigUIError as error:
            faults.add(error.issues)
            return ""
    return view


def _bounded_table(where: str, found: Any, faults: Faults) -> Any:
    if not isinstance(found, Mapping):
        return _bounded_part(where, found, faults)
    return {name: _bounded_part(f'{where}."{name}"', each, faults) for name, each in found.items()}


def _bounded_part(where: str, part: Any, faults: Faults) -> Any:
    wrong: dict[str, Any] = {}
    for each, about in settings_in(part):
        value = getattr(part, each.name)
        if about.bounds is not None and value is not None:
            least, largest = about.bounds
            if not least <= value <= largest:
                wrong[each.name] = each.default
                what = f"expected {least:g} to {largest:g}, got {value:g}"
                faults.add([issue("CONFIG_VALUE", f"{where}.{each.name}", what)])
    return replace(part, **wrong) if wrong else part


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
