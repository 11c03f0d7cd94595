"""Values that settings may have, beyond what their types say."""

from __future__ import annotations

import math
from typing import Any

from usdrigui.errors import meant, refuse
from usdrigui.settings.about import settings_table

_VIEWS = ("", "front", "side")
"""Views with names; others are a camera's prim path, or two angles."""


def check_value(path: str, value: Any) -> None:
    """Raise CONFIG_VALUE where the setting at `path` (``solve.gap``) may not have a value."""
    section, name = path.partition(".")[0], path.rpartition(".")[2]
    about = settings_table().get(section, {}).get(name)
    if about is not None and about.bounds:
        least, largest = about.bounds
        if not least <= value <= largest:
            expected = f"expected {least:g} to {largest:g}, got {value:g}"
            raise refuse("CONFIG_VALUE", path, expected)
    if path == "candidates.view" and value not in _VIEWS and not value.startswith("/"):
        view_angles(value)


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
