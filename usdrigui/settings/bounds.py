"""Numbers that settings may have."""

from __future__ import annotations

import math
import types
from collections.abc import Mapping

from usdrigui.errors import meant, refuse
from usdrigui.settings.parts import Settings

_BOUNDS: Mapping[str, tuple[float, float]] = types.MappingProxyType(
    {
        "run.time_limit": (0.0, 1e9),
        "run.memory_limit": (1, 2**40),
        "read.joint_min_degrees": (0.0, 360.0),
        "read.time_limit": (0.0, 1e9),
        "read.memory_limit": (1, 2**40),
        "read.size_limit": (0, 2**40),
        "trajectories.noise": (0.0, 1.0),
        "trajectories.tolerance": (1e-9, 1.0),
        "trajectories.max_samples": (2, 1025),
        "trajectories.tiny": (0.0, 1.0),
        "symmetry.tolerance": (0.0, 1.0),
        "symmetry.twin_similarity": (0.0, 1.0),
        "symmetry.plane_price": (0.0, 1e6),
        "candidates.prune_at": (0.0, 1e6),
        "candidates.peak_share": (0.0, 1.0),
        "candidates.occlusion_price": (0.0, 1e6),
        "candidates.global_coverage": (0.0, 1.0),
        "candidates.hidden_share": (0.0, 1.0),
        "candidates.near_radius": (1e-6, 1e6),
        "groups.opposed_cosine": (-2.0, 1.0),
        "groups.fan_size": (1, 16),
        "groups.jaccard_min": (0.0, 1.0),
        "objective.displacement_weight": (0.0, 1.0),
        "objective.relative_displacement": (0.0, 1.0),
        "objective.overlap_max": (0.0, 1e6),
        "objective.overlap_radius": (1e-6, 1e6),
        "objective.overlap_sharpness": (1e-6, 1e6),
        "objective.overlap_reach": (0.0, 1e6),
        "objective.samples": (2, 64),
        "objective.handle_size": (1e-4, 1.0),
        "objective.handle_least": (1e-4, 1.0),
        "objective.handle_crowd": (0.0, 1e6),
        "objective.beside_price": (-1e6, 1e6),
        "objective.keep_price": (0.0, 1e6),
        "solve.gap": (0.0, 1.0),
        "solve.threads": (0, 1024),
        "solve.work_limit": (0, 2**62),
        "solve.time_limit": (0.0, 1e9),
        "solve.memory_limit": (1, 2**40),
        "solve.clusters": (1, 4096),
        "solve.sample": (1e-6, 1.0),
        "solve.seed": (0, 2**62),
        "output.min_track": (0.0, 1e6),
        "like.price": (0.0, 1e6),
        "animation.weight": (0.0, 1.0),
        "animation.together": (0.0, 1.0),
    }
)
"""Least and largest value of each number; what lies outside has no meaning and would only fail later."""
_OF_CONTROLS: Mapping[str, tuple[float, float]] = types.MappingProxyType(
    {"importance": (0.0, 100.0), "within": (0.0, 1e6), "glyph_size": (0.0, 1e6)}
)
"""The same for the numbers of a control's table."""
_VIEWS = ("", "front", "side")
"""Views with names; others are a camera's prim path, or two angles."""


def check_bounds(settings: Settings) -> None:
    """Raises RigUIError CONFIG_VALUE, naming the key, for a number outside its bounds and a view that is none."""
    view = settings.candidates.view
    if view not in _VIEWS and not view.startswith("/"):
        view_angles(view)
    for key, (least, largest) in _BOUNDS.items():
        part, _, name = key.partition(".")
        _check(key, getattr(getattr(settings, part), name), least, largest)
    for name, said in settings.controls.items():
        for key, (least, largest) in _OF_CONTROLS.items():
            _check(f'controls."{name}".{key}', getattr(said, key), least, largest)


def _check(key: str, value: float | None, least: float, largest: float) -> None:
    if value is not None and not least <= value <= largest:
        raise refuse("CONFIG_VALUE", key, f"expected {least:g} to {largest:g}, got {value:g}")


def view_angles(view: str) -> tuple[float, float]:
    """Azimuth (to the character's left) and elevation of a view ``AZ,EL``, degrees; raises CONFIG_VALUE for none."""
    try:
        azimuth, elevation = map(float, view.split(","))
    except ValueError:
        azimuth = elevation = math.nan
    if not (math.isfinite(azimuth) and math.isfinite(elevation)):
        what = f"{view!r} is neither front, side, AZ,EL nor a camera's prim path{meant(view, _VIEWS)}"
        raise refuse("CONFIG_VALUE", "candidates.view", what)
    return azimuth, elevation
