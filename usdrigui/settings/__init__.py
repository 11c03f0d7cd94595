"""Every setting of a run.

Precedence, weakest first: defaults, preset, environment (``USDRIGUI_<PART>_<NAME>``), configuration
file, command line.  Parts are plain dataclasses; `load` builds them from TOML and refuses unknown
keys.
"""

from usdrigui.settings.bounds import (
    view_angles as view_angles,
)
from usdrigui.settings.loading import (
    UnsoundSettingsError as UnsoundSettingsError,
    limited as limited,
    load as load,
)
from usdrigui.settings.parts import (
    AnimationSettings as AnimationSettings,
    CandidateSettings as CandidateSettings,
    ControlSettings as ControlSettings,
    GroupSettings as GroupSettings,
    JointSettings as JointSettings,
    LevelSettings as LevelSettings,
    LikeSettings as LikeSettings,
    ObjectiveSettings as ObjectiveSettings,
    OutputSettings as OutputSettings,
    PartSettings as PartSettings,
    PoseSettings as PoseSettings,
    ReadSettings as ReadSettings,
    RunSettings as RunSettings,
    Settings as Settings,
    SolveSettings as SolveSettings,
    SymmetrySettings as SymmetrySettings,
    TrajectorySettings as TrajectorySettings,
)
from usdrigui.settings.presets import (
    presets as presets,
)
from usdrigui.settings.sources import (
    environment_settings as environment_settings,
    literal as literal,
    read_toml as read_toml,
)
