"""Every setting of a run.

Precedence, weakest first: defaults, preset, environment (``USDRIGUI_<PART>_<NAME>``), configuration
file, command line.  Parts are plain dataclasses; `load` builds them from TOML and refuses unknown
keys.
"""

from __future__ import annotations

from usdrigui.settings.bounds import view_angles
from usdrigui.settings.config_sections import with_sections
from usdrigui.settings.loading import UnsoundSettingsError, document, limited, load
from usdrigui.settings.parts import (
    AnimationSettings,
    CandidateSettings,
    CharacterSettings,
    ControlSettings,
    GroupSettings,
    JointSettings,
    LayoutSettings,
    LevelSettings,
    LikeSettings,
    ObjectiveSettings,
    OutputSettings,
    PartSettings,
    PoseSettings,
    ReadSettings,
    RigSettings,
    RunSettings,
    Settings,
    SolveSettings,
    SymmetrySettings,
    TrajectorySettings,
)
from usdrigui.settings.presets import PRESETS
from usdrigui.settings.sources import environment_settings, literal, read_toml

__all__ = [
    "PRESETS",
    "AnimationSettings",
    "CandidateSettings",
    "CharacterSettings",
    "ControlSettings",
    "GroupSettings",
    "JointSettings",
    "LayoutSettings",
    "LevelSettings",
    "LikeSettings",
    "ObjectiveSettings",
    "OutputSettings",
    "PartSettings",
    "PoseSettings",
    "ReadSettings",
    "RigSettings",
    "RunSettings",
    "Settings",
    "SolveSettings",
    "SymmetrySettings",
    "TrajectorySettings",
    "UnsoundSettingsError",
    "document",
    "environment_settings",
    "limited",
    "literal",
    "load",
    "read_toml",
    "view_angles",
    "with_sections",
]
