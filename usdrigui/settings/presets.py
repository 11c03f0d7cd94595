"""Settings under one name."""

from __future__ import annotations

import types
from collections.abc import Mapping
from typing import Any

PRESETS: Mapping[str, Mapping[str, Mapping[str, Any]]] = types.MappingProxyType(
    {
        "default": {},
        "paper": {
            "trajectories": {"noise": 0.0},
            "candidates": {
                "conventions": False,
                "space": "object",
                "peak_share": 0.0,
                "least_kept": 0.0,
                "occlusion_weight": 0.0,
                "board_hidden": False,
                "board_composite": False,
            },
            "symmetry": {"double_middle": "never"},
            "groups": {"opposed": False, "patches": True},
            "objective": {
                "scene_units": True,
                "overlap": "mean",
                "relative_displacement": 0.0,
                "distinctive_weight": 0.0,
                "overlap_sharpness": 2.0,
                "overlap_cutoff": 0.0,
                "max_neighbours": 0.0,
                "separation": False,
                "off_face_allowed": False,
            },
            "solve": {"method": "paper", "clusters": 2, "sample": 0.2},
        },
    }
)
