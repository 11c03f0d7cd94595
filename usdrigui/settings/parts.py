"""Every setting, one frozen part per stage, its documentation, unit and bounds beside it; where the
paper's symbols are translated, once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True, slots=True)
class ControlSettings:
    """``[controls."name"]``: the rigger's corrections of one control."""

    exclude: bool = False
    rename: str = ""
    label: str = ""
    minimum: float | None = None
    maximum: float | None = None
    default: float | None = None
    twin: str = ""
    orbit: tuple[str, ...] = ()
    place: Literal["", "face", "board", "proxy"] = ""
    near: str = ""
    within: float = 0.15
    anchor: str = ""
    follow_twin: bool = True
    inner_anchor: str = ""
    adapt: Literal["", "deform", "static"] = ""
    importance: float | None = None
    glyph: str = ""
    glyph_size: float = 1.0


@dataclass(frozen=True, slots=True)
class PoseSettings:
    """``[poses."name"]``: a pose control from a frame, a clip or a set of weights."""

    frame: float | None = None
    clip: tuple[float, ...] = ()
    animation: str = ""
    weights: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class JointSettings:
    """``[joints."PATH"]``: a joint's degrees of freedom as controls; its last name will do where it
    is unique."""

    axes: tuple[Literal["x", "y", "z"], ...] = ()
    minimum: float = -30.0
    maximum: float = 30.0
    label: str = ""


@dataclass(frozen=True, slots=True)
class ReadSettings:
    """What becomes a control, and which pose is the base pose."""

    skel_root: str = ""
    variants: Mapping[str, str] = field(default_factory=dict)
    each_variant: tuple[str, ...] = ()
    joints: Literal["auto", "animated", "all", "none"] = "auto"
    joint_min_degrees: float = 0.5
    pose_names: str = "framemapping"
    time: float | None = None
    pose: Mapping[str, float] = field(default_factory=dict)
    time_limit: float = 300.0
    memory_limit: int = 8192
    size_limit: int = 8192


@dataclass(frozen=True, slots=True)
class RunSettings:
    """What a whole run of a command may take; a host that calls the Python API sets its own
    limits."""

    time_limit: float = 3600.0
    memory_limit: int = 16384


@dataclass(frozen=True, slots=True)
class TrajectorySettings:
    """How finely trajectories are sampled."""

    tolerance: float = 0.001
    max_samples: int = 33
    noise: float = 0.001
    tiny: float = 0.01


@dataclass(frozen=True, slots=True)
class SymmetrySettings:
    """Mirror plane, twins and what is held to the plane."""

    enabled: bool = True
    tolerance: float = 0.01
    twin_similarity: float = 0.6
    fold: bool = True
    plane_weight: float = 0.1
    double_middle: Literal["evidence", "always", "never"] = "evidence"


@dataclass(frozen=True, slots=True)
class CandidateSettings:
    """Where a control may be anchored."""

    prune_at: float = 1.0
    peak_share: float = 0.5
    least_kept: float = 1.0 / 3.0
    conventions: bool = True
    occlusion: bool = True
    occlusion_weight: float = 0.15
    view: str = ""
    space: Literal["part", "object", "view"] = "part"
    global_coverage: float = 0.6
    hidden_share: float = 0.02
    board_global: bool = True
    board_hidden: bool = True
    board_composite: bool = True


@dataclass(frozen=True, slots=True)
class GroupSettings:
    """Which controls share an element."""

    opposed: bool = True
    opposed_cosine: float = -0.75
    patches: bool = False
    fan_size: int = 2
    jaccard_min: float = 0.85
    groups: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class ObjectiveSettings:
    """What a good layout is (paper eq. 1 and 2)."""

    displacement_weight: float = 0.85
    relative_displacement: float = 0.5
    overlap: Literal["seen", "mean"] = "seen"
    near_weight: float = 1.0
    near_radius: float = 1.5
    room_weight: float = 0.1
    room_radius: float = 3.0
    track_weight: float = 0.5
    track_radius: float = 0.7
    crossing_weight: float = 0.3
    along_weight: float = 0.3
    along_radius: float = 0.5
    short_weight: float = 0.5
    overlap_max: float = 5.0
    overlap_radius: float = 1.0
    overlap_sharpness: float = 6.0
    overlap_cutoff: float = 3.0
    samples: int = 5
    handle_size: float = 0.02
    handle_size_min: float = 0.004
    max_neighbours: float = 8.0
    separation: bool = True
    distinctive_weight: float = 0.3
    off_face_penalty: float = 1.0
    off_face_allowed: bool = True
    keep_penalty: float = 2.0
    terms: tuple[str, ...] = ()
    scene_units: bool = False


@dataclass(frozen=True, slots=True)
class SolveSettings:
    """How the layout problem is solved, and for how long."""

    method: Literal["highs", "paper"] = "highs"
    gap: float = 0.0001
    work_limit: int = 60_000_000
    time_limit: float = 0.0
    memory_limit: int = 1024
    clusters: int = 1
    linkage: Literal["single", "sum"] = "single"
    sample: float = 1.0
    seed: int = 0


@dataclass(frozen=True, slots=True)
class OutputSettings:
    """How elements are drawn and written."""

    bare: bool = False
    adapt: Literal["deform", "static"] = "deform"
    min_track: float = 1.5


@dataclass(frozen=True, slots=True)
class LevelSettings:
    """Two levels: coarse elements first, and in place of one that is opened its members.

    Handles are kept apart among elements that are visible with one opened only."""

    members: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    poses: bool = False
    groups: bool = False
    crowds: bool = True


@dataclass(frozen=True, slots=True)
class LikeSettings:
    """Laying out a character like another one (`--like`)."""

    names: Mapping[str, str] = field(default_factory=dict)
    penalty: float = 2.0


@dataclass(frozen=True, slots=True)
class AnimationSettings:
    """What is made of animation given with `--animation`."""

    weight: float = 0.5


@dataclass(frozen=True, slots=True)
class PartSettings:
    """The parts of a character, each with a scale and a layout problem of its own."""

    divide: bool = True
    controls: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Settings:
    """All settings of a run, by section of a configuration: ``[solve]`` is `Settings.solve`.

    `usdrigui.settings.load` makes them; documents have them in this order.
    """

    run: RunSettings = RunSettings()
    output: OutputSettings = OutputSettings()
    read: ReadSettings = ReadSettings()
    controls: Mapping[str, ControlSettings] = field(default_factory=dict)
    poses: Mapping[str, PoseSettings] = field(default_factory=dict)
    joints: Mapping[str, JointSettings] = field(default_factory=dict)
    trajectories: TrajectorySettings = TrajectorySettings()
    symmetry: SymmetrySettings = SymmetrySettings()
    parts: PartSettings = PartSettings()
    like: LikeSettings = LikeSettings()
    animation: AnimationSettings = AnimationSettings()
    candidates: CandidateSettings = CandidateSettings()
    groups: GroupSettings = GroupSettings()
    levels: LevelSettings = LevelSettings()
    objective: ObjectiveSettings = ObjectiveSettings()
    solve: SolveSettings = SolveSettings()
