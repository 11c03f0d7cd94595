"""Every setting, one frozen part per stage; where the paper's symbols are translated, once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal


@dataclass(frozen=True, slots=True)
class ControlSettings:
    """``[controls."name"]``: what the rigger says about one control."""

    exclude: bool = False
    rename: str = ""
    label: str = ""
    minimum: float | None = None
    maximum: float | None = None
    default: float | None = None
    twin: str = ""
    """Name of the mirror control; ``none`` unpairs; ``self`` says symmetric about the plane."""
    orbit: tuple[str, ...] = ()
    """Names of the controls of an n-fold symmetry, this one first."""
    place: Literal["", "face", "beside", "proxy"] = ""
    """Where to lay it out; empty leaves the choice to the optimiser. ``proxy`` is the nearest visible point."""
    near: str = ""
    """Prim path, ``joint:NAME`` or ``MESH.point[i]`` near which to stay (locality)."""
    within: float = 0.0
    """Radius for `near`, as a share of the face size; 0 takes the default."""
    anchor: str = ""
    """``MESH_PATH#POINT``: fixed anchor of a partial layout."""
    inner_anchor: str = ""
    """The same for the slider that the control has of its own when `levels.groups` makes its element coarse."""
    adapt: Literal["", "deform", "static"] = ""
    importance: float | None = None
    """How much its place matters beside other controls': a factor on its displacement. None is 1, or what the
    animations given with `--animation` tell."""
    glyph: str = ""
    """Curve or mesh to draw as its handle: ``/PRIM`` of the asset, or ``FILE</PRIM>`` with a file named from the
    asset's folder. The stage's up axis comes out of the face."""
    glyph_size: float = 1.0
    """Diameter of the glyph in handle widths; 0 makes it as long as the element's track."""


@dataclass(frozen=True, slots=True)
class PoseSettings:
    """``[poses."name"]``: a pose control from a frame, a clip or a set of weights."""

    frame: float | None = None
    clip: tuple[float, ...] = ()
    """First and last time code of a clip."""
    animation: str = ""
    """Prim path of the SkelAnimation; empty takes the bound one."""
    weights: Mapping[str, float] = field(default_factory=dict)
    label: str = ""


@dataclass(frozen=True, slots=True)
class JointSettings:
    """``[joints."PATH"]``: a joint's degrees of freedom as controls; its last name will do where it is unique."""

    axes: tuple[Literal["x", "y", "z"], ...] = ()
    """Rotation axes in the joint's own frame; empty makes no control of it."""
    minimum: float = -30.0
    """Degrees."""
    maximum: float = 30.0
    label: str = ""


@dataclass(frozen=True, slots=True)
class ReadSettings:
    """What becomes a control, and which pose is the base pose."""

    skel_root: str = ""
    """Prim path; empty reads every SkelRoot that has controls."""
    joints: Literal["auto", "animated", "all", "none"] = "auto"
    """Which joints become controls: ``auto`` those that the animation rotates by more than `joint_min_degrees`,
    unless its frames are named poses; ``animated`` the same without exception."""
    joint_min_degrees: float = 0.5
    pose_names: str = "framemapping"
    """Key in the SkelRoot's customData or a layer's customLayerData that lists one pose name per frame (or a
    table of name to time code); the first is rest."""
    time: float | None = None
    """Time code whose pose is the base pose; none takes the first of the named frames or, where none are
    named, the rest transforms and zero weights."""
    pose: Mapping[str, float] = field(default_factory=dict)
    """Base pose as control values by name, on top of `time`; paper: P."""
    time_limit: float = 300.0
    """Seconds that the process which reads the asset may take."""
    memory_limit: int = 8192
    """MiB of private memory that it may take."""
    size_limit: int = 8192
    """MiB that the asset's file may have."""


@dataclass(frozen=True, slots=True)
class RunSettings:
    """What a whole run of a command may take; a host that calls the Python API sets its own limits."""

    time_limit: float = 3600.0
    """Seconds from its start; 0 for no limit. A search under way ends with the best layout so far, all else ends the
    run. `solve.time_limit` limits the search alone."""
    memory_limit: int = 16384
    """MiB of private memory beyond what the libraries take."""


@dataclass(frozen=True, slots=True)
class TrajectorySettings:
    """How finely trajectories are sampled."""

    tolerance: float = 1e-3
    """Largest deviation of a sampled curve from the true one, as a share of its arc length."""
    max_samples: int = 33
    noise: float = 1e-3
    """A point moves when its arc length exceeds this share of the control's largest one: scanned shapes
    carry noise everywhere."""
    tiny: float = 0.01
    """A control whose largest arc length is below this share of the face size is called tiny."""


@dataclass(frozen=True, slots=True)
class SymmetrySettings:
    """Mirror plane, twins and what is held to the plane."""

    enabled: bool = True
    tolerance: float = 0.01
    """Largest distance of a mirror partner, as a share of the face size."""
    twin_similarity: float = 0.6
    """Least agreement of two controls' mirrored trajectories to be called twins."""
    fold: bool = True
    """Optimise one of each pair of twins only (paper section 3.3)."""
    plane_price: float = 0.1
    """Cost per handle width of distance from the plane for self-symmetric elements, counted from their
    candidate nearest to it."""
    double_middle: bool = False
    """Give a self-symmetric control two mirrored elements instead of one on the plane."""


@dataclass(frozen=True, slots=True)
class CandidateSettings:
    """Where a control may be anchored."""

    prune_at: float = 1.0
    """Drop points whose arc length is below this multiple of the mean over the points that move (paper
    section 4.2)."""
    peak_share: float = 0.5
    """Drop points whose arc length is below this share of the control's peak; 0 turns it off."""
    occlusion: bool = True
    """Drop points whose trajectory is largely inside or behind the model from every view."""
    occlusion_price: float = 0.15
    """Cost of a trajectory that runs straight into the surface (paper section 3.3, element-model occlusion)."""
    view: str = ""
    """``front``, ``side``, ``AZ,EL`` in degrees or a camera's prim path; empty means front and two
    three-quarter views."""
    space: Literal["object", "view"] = "object"
    """``view`` projects elements to the view plane before spacing them (paper fig. 7)."""
    global_coverage: float = 0.6
    """A control that moves more than this share of the visible face is global."""
    hidden_share: float = 0.02
    """A control is hidden when less than this share of its moving places is visible anywhere."""
    beside_global: bool = True
    beside_hidden: bool = True
    beside_composite: bool = True
    near_radius: float = 0.15
    """Default radius of locality, as a share of the face size."""


@dataclass(frozen=True, slots=True)
class GroupSettings:
    """Which controls share an element."""

    opposed: bool = True
    """Merge opposed controls into bipolar sliders and joysticks."""
    opposed_cosine: float = -0.75
    """Two controls are opposed when the cosine of their motions, as vectors over the whole surface, is below
    this: they act on the same region and go opposite ways."""
    patches: bool = False
    """Group controls by the Jaccard index of their candidates (paper section 4.2)."""
    fan_size: int = 2
    """Paper: k."""
    jaccard_min: float = 0.85
    """Paper: epsilon."""
    groups: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """``[groups.groups]``: element name to control names, in order."""


@dataclass(frozen=True, slots=True)
class ObjectiveSettings:
    """What a good layout is (paper eq. 1 and 2)."""

    displacement_weight: float = 0.85
    """Paper: lambda."""
    relative_displacement: float = 0.5
    """How far displacement is measured against the control's own peak (1) rather than against the typical
    peak of the rig (0): subtle controls are worth their best place too."""
    overlap_max: float = 5.0
    """Paper: a."""
    overlap_radius: float = 1.0
    """Paper: tau, in handle widths; the preset ``paper`` uses the mean edge length instead."""
    overlap_sharpness: float = 6.0
    """Paper: s, in units of one over the radius."""
    overlap_reach: float = 3.0
    """Elements further apart than this many radii do not interact; 0 for no cut."""
    samples: int = 5
    """Paper: u, points per track."""
    handle_size: float = 0.02
    """Width at which a handle is drawn and kept apart, as a share of the face size; less on a crowded face."""
    handle_least: float = 0.012
    """Width below which handles do not shrink, however crowded the face is; as a share of the face size."""
    handle_crowd: float = 8.0
    """Handles shrink until around the places that a control wants, within four handle widths, no more than this
    many controls want theirs, on average; 0 keeps `handle_size`."""
    separation: bool = True
    """No two handles nearer than a handle's width, as a hard constraint."""
    beside_price: float = 0.3
    """Cost of sending a control beside the face, per copy; 0 or less than 0 is allowed."""
    beside_allowed: bool = True
    keep_price: float = 0.2
    """With an earlier layout (`--previous`): cost of moving an element away from where it was, per copy, and of
    sending it beside the face or back. What gains less stays; 0 lays out afresh."""
    terms: tuple[str, ...] = ()
    """Names of further terms of the objective, from installed packages (entry points ``usdrigui.terms``)."""
    scene_units: bool = False
    """Use the paper's constants literally: tau is the mean edge length, s and displacement in scene units."""


@dataclass(frozen=True, slots=True)
class SolveSettings:
    """How the layout problem is solved, and for how long."""

    method: Literal["highs", "paper", "enumerate", "toulbar2"] = "highs"
    gap: float = 1e-4
    """Relative gap at which a solution is called optimal."""
    threads: int = 0
    """Accepted for scripts that set it; the solver runs one thread, and the result does not depend on it."""
    work_limit: int = 60_000_000
    """Search nodes and pair evaluations after which the solver stops with what it has; reproducible."""
    time_limit: float = 0.0
    """Seconds; 0 for none. The result may then depend on the machine."""
    memory_limit: int = 1024
    """MiB that the solver may plan to use."""
    clusters: int = 1
    """Paper: o. Only for the method ``paper``."""
    linkage: Literal["single", "sum"] = "single"
    """Distance of two clusters: ``single`` that of their nearest controls, ``sum`` the total over all pairs of
    candidates, as the paper's formula reads. Only for ``paper``."""
    sample: float = 1.0
    """Share of the candidates kept by weighted random sampling (paper section 4.2). Only for ``paper``."""
    seed: int = 0


@dataclass(frozen=True, slots=True)
class OutputSettings:
    """How elements are drawn and written."""

    bare: bool = False
    """Leave the source out of the written layer's sublayers."""
    adapt: Literal["deform", "static"] = "deform"
    min_track: float = 1.5
    """Least drawn length of a track, in handle widths; shorter ones are drawn enlarged, with the gain recorded."""


@dataclass(frozen=True, slots=True)
class LevelSettings:
    """Two levels: coarse elements first, and in place of one that is opened its members.

    Handles are kept apart among elements that are visible at the same time only."""

    members: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """``[levels.members]``: a coarse control, or the name of an element, to the controls whose elements are its
    members. What is said of one side of the character holds for the other."""
    poses: bool = False
    """Every pose is coarse; its members are the controls that it sets."""
    groups: bool = False
    """Every element of several axes (joystick, patch, fan) is coarse; each of its axes gets a slider of its own,
    its member."""


@dataclass(frozen=True, slots=True)
class LikeSettings:
    """Laying out a character like another one (`--like`)."""

    names: Mapping[str, str] = field(default_factory=dict)
    """Their control's name to ours, where the two differ; an empty name says that there is no counterpart."""
    price: float = 1.0
    """Cost, per copy, of an element far from the place that corresponds to theirs; nearer ones pay in
    proportion to the distance."""


@dataclass(frozen=True, slots=True)
class AnimationSettings:
    """What is made of animation given with `--animation`."""

    weight: float = 0.5
    """How much use counts: a control that is never used has the importance 1 - weight, one of the mean use 1, one
    used twice as much 1 + weight; three times is the most that counts."""
    together: float = 0.8
    """Least agreement (weighted Jaccard index of the activities) of controls that are said to move together."""


@dataclass(frozen=True, slots=True)
class Settings:
    """Everything that a run can be told."""

    run: RunSettings = field(default_factory=RunSettings)
    read: ReadSettings = field(default_factory=ReadSettings)
    trajectories: TrajectorySettings = field(default_factory=TrajectorySettings)
    symmetry: SymmetrySettings = field(default_factory=SymmetrySettings)
    candidates: CandidateSettings = field(default_factory=CandidateSettings)
    groups: GroupSettings = field(default_factory=GroupSettings)
    objective: ObjectiveSettings = field(default_factory=ObjectiveSettings)
    solve: SolveSettings = field(default_factory=SolveSettings)
    output: OutputSettings = field(default_factory=OutputSettings)
    controls: Mapping[str, ControlSettings] = field(default_factory=dict)
    poses: Mapping[str, PoseSettings] = field(default_factory=dict)
    joints: Mapping[str, JointSettings] = field(default_factory=dict)
    like: LikeSettings = field(default_factory=LikeSettings)
    levels: LevelSettings = field(default_factory=LevelSettings)
    animation: AnimationSettings = field(default_factory=AnimationSettings)
