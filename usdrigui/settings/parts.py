"""Every setting, one frozen part per stage, its documentation, unit and bounds beside it; where the
paper's symbols are translated, once."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from usdrigui.settings.table import setting


@dataclass(frozen=True, slots=True)
class ControlSettings:
    """``[controls."name"]``: the rigger's corrections of one control."""

    exclude: bool = setting(
        False, "Leave the control out: no element; its motion still defines the face."
    )
    rename: str = setting("", "A name to use instead of its own.")
    label: str = setting("", "Text beside its element; empty takes the name.")
    minimum: float | None = setting(
        None,
        "Least value; none takes it from its twin by name, else from the asset.",
        unit="its own",
    )
    maximum: float | None = setting(
        None,
        "Largest value; none takes it from its twin by name, else from the asset.",
        unit="its own",
    )
    default: float | None = setting(
        None, "Value at rest; none takes it from the asset.", unit="its own"
    )
    twin: str = setting(
        "", "Name of the mirror control; ``none`` unpairs; ``self`` is symmetric about the plane."
    )
    orbit: tuple[str, ...] = setting(
        (), "Names of the controls of an n-fold symmetry, this one first.", level="expert"
    )
    place: Literal["", "face", "board", "proxy"] = setting(
        "",
        "Where to lay it out; empty leaves the choice to the optimiser. ``proxy`` is the nearest"
        " visible point.",
    )
    near: str = setting(
        "",
        "Prim path, ``joint:NAME`` or ``MESH.point[i]`` near which to stay (locality); ``mirror:``"
        " in front of it names its mirror image.",
    )
    within: float = setting(
        0.0,
        "Radius for `near` along the surface; 0 takes the default.",
        unit="face sizes",
        bounds=(0.0, 1000000.0),
        level="expert",
    )
    anchor: str = setting("", "``MESH_PATH#POINT``: fixed anchor of a partial layout.")
    follow_twin: bool = setting(
        True,
        "Whether it moves when its twin's anchor is corrected, and takes its twin's `near`,"
        " `minimum` and `maximum`, where nothing is decided about its own.",
    )
    inner_anchor: str = setting(
        "",
        "The same for the slider that the control has of its own when `levels.groups` makes its"
        " element coarse.",
        level="expert",
    )
    adapt: Literal["", "deform", "static"] = setting(
        "",
        "Whether its element deforms with the skin or only follows it; empty takes `output.adapt`.",
    )
    importance: float | None = setting(
        None,
        "How much its place matters beside other controls': a factor on its displacement. None is"
        " 1, or the use in the animations given with `--animation`.",
        bounds=(0.0, 100.0),
    )
    glyph: str = setting(
        "",
        "Curve or mesh to draw as its handle: ``/PRIM`` of the asset, or ``FILE</PRIM>`` with a"
        " file named from the asset's folder. The stage's up axis comes out of the face.",
    )
    glyph_size: float = setting(
        1.0,
        "Diameter of the glyph in handle widths; 0 makes it as long as the element's track.",
        unit="handle widths",
        bounds=(0.0, 1000.0),
    )


@dataclass(frozen=True, slots=True)
class PoseSettings:
    """``[poses."name"]``: a pose control from a frame, a clip or a set of weights."""

    frame: float | None = setting(None, "The frame that is the pose.", unit="time code")
    clip: tuple[float, ...] = setting((), "First and last time code of a clip.", unit="time codes")
    animation: str = setting(
        "", "Prim path of the SkelAnimation; empty takes the bound one.", level="expert"
    )
    weights: Mapping[str, float] = setting({}, "Blend shape weights of the pose.")


@dataclass(frozen=True, slots=True)
class JointSettings:
    """``[joints."PATH"]``: a joint's degrees of freedom as controls; its last name will do where it
    is unique."""

    axes: tuple[Literal["x", "y", "z"], ...] = setting(
        (), "Rotation axes in the joint's own frame; empty makes no control of it."
    )
    minimum: float = setting(-30.0, "Least rotation.", unit="degrees")
    maximum: float = setting(30.0, "Largest rotation.", unit="degrees")
    label: str = setting("", "Text beside its elements; empty takes the name.")


@dataclass(frozen=True, slots=True)
class ReadSettings:
    """What becomes a control, and which pose is the base pose."""

    skel_root: str = setting("", "Prim path; empty reads every SkelRoot that has controls.")
    variants: Mapping[str, str] = setting(
        {},
        "Variants to select, by the names of their sets, in place of the authored ones; a layout"
        " is then authored in them.",
    )
    each_variant: tuple[str, ...] = setting(
        (),
        "Variant sets: `process` lays out each of their variants in one layer, `check` and `diff`"
        " look at each.",
    )
    joints: Literal["auto", "animated", "all", "none"] = setting(
        "auto",
        "Which joints become controls: ``auto`` those that the animation rotates by more than"
        " `joint_min_degrees`, unless its frames are named poses, and where nothing else is a"
        " control those with skin, by the degrees of freedom that their place in the skeleton"
        " suggests; ``animated`` those of the animation alone, without exception; ``all`` three"
        " axes of every joint.",
    )
    joint_min_degrees: float = setting(
        0.5,
        "Rotation from which a joint is animated.",
        unit="degrees",
        bounds=(0.0, 360.0),
        level="expert",
    )
    pose_names: str = setting(
        "framemapping",
        "Key in the SkelRoot's customData or a layer's customLayerData that lists one pose name per"
        " frame (or a table of name to time code); the first is rest.",
        level="expert",
    )
    time: float | None = setting(
        None,
        "Time code whose pose is the base pose; none takes the first of the named frames or, where"
        " none are named, the rest transforms and zero weights.",
        unit="time code",
    )
    pose: Mapping[str, float] = setting(
        {}, "Base pose as control values by name, on top of `time`; paper: P."
    )
    time_limit: float = setting(
        300.0,
        "Time that the process which reads the asset may take.",
        unit="s",
        bounds=(0.0, 1000000000.0),
        level="expert",
    )
    memory_limit: int = setting(
        8192, "Private memory that it may take.", unit="MiB", bounds=(1, 2**40), level="expert"
    )
    size_limit: int = setting(
        8192, "Size that the asset's file may have.", unit="MiB", bounds=(0, 2**40), level="expert"
    )


@dataclass(frozen=True, slots=True)
class RunSettings:
    """What a whole run of a command may take; a host that calls the Python API sets its own
    limits."""

    time_limit: float = setting(
        3600.0,
        "From its start; 0 for no limit. A search under way ends with the best layout so far, all"
        " else ends the run. `solve.time_limit` limits the search alone.",
        unit="s",
        bounds=(0.0, 1000000000.0),
        level="expert",
    )
    memory_limit: int = setting(
        16384,
        "Private memory beyond that of the libraries.",
        unit="MiB",
        bounds=(1, 2**40),
        level="expert",
    )


@dataclass(frozen=True, slots=True)
class TrajectorySettings:
    """How finely trajectories are sampled."""

    tolerance: float = setting(
        0.001,
        "Largest deviation of a sampled curve from the true one, as a share of its arc length.",
        bounds=(1e-09, 1.0),
        level="expert",
    )
    max_samples: int = setting(
        33, "Knots that a sampled curve may have.", bounds=(2, 1025), level="expert"
    )
    noise: float = setting(
        0.001,
        "A point moves when its arc length exceeds this share of the control's largest one, and,"
        " where a shape moves nearly every point, what most of them move: scanned shapes carry"
        " noise and drift of the head everywhere. 0 takes every point.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    tiny: float = setting(
        0.01,
        "A control whose largest arc length is below this share of the face size is called tiny.",
        bounds=(0.0, 1.0),
        level="expert",
    )


@dataclass(frozen=True, slots=True)
class SymmetrySettings:
    """Mirror plane, twins and what is held to the plane."""

    enabled: bool = setting(True, "Look for a mirror plane at all.", level="expert")
    tolerance: float = setting(
        0.01,
        "Largest distance of a mirror partner; on coarse surfaces three quarters of the distance of"
        " their points, where that is more.",
        unit="face sizes",
        bounds=(0.0, 1.0),
        level="expert",
    )
    twin_similarity: float = setting(
        0.6,
        "Least agreement of two controls' mirrored trajectories to be called twins.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    fold: bool = setting(
        True, "Optimise one of each pair of twins only (paper section 3.3).", level="expert"
    )
    plane_weight: float = setting(
        0.1,
        "Cost of the distance from the plane of self-symmetric elements, counted from their"
        " candidate nearest to it.",
        unit="cost per handle width",
        bounds=(0.0, 1000000.0),
        level="expert",
    )
    double_middle: Literal["evidence", "always", "never"] = setting(
        "evidence",
        "Give a self-symmetric control two mirrored elements of one value instead of one on the"
        " plane: where its motion has two lobes (`evidence`), `always` or `never`.",
    )


@dataclass(frozen=True, slots=True)
class CandidateSettings:
    """Where a control may be anchored."""

    prune_at: float = setting(
        1.0,
        "Drop points whose arc length is below this multiple of the mean over the points that move"
        " (paper section 4.2).",
        bounds=(0.0, 1000000.0),
        level="expert",
    )
    peak_share: float = setting(
        0.5,
        "Drop points whose arc length is below this share of the control's peak; 0 turns it off.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    least_kept: float = setting(
        1.0 / 3.0,
        "Least share of its true peak that a control keeps at its handle; one that keeps less at"
        " every visible place goes to the board, unless its name and its visible motion call for a"
        " place on the face.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    conventions: bool = setting(
        True,
        "Read what the names of controls mean by the conventions of the field: where each is"
        " expected, which belong together, which repeat others. Motions overrule them; without,"
        " motions alone decide.",
    )
    occlusion: bool = setting(
        True,
        "Drop points whose trajectory is largely inside or behind the model from every view.",
        level="expert",
    )
    occlusion_weight: float = setting(
        0.15,
        "Cost of a trajectory that runs straight into the surface (paper section 3.3, element-model"
        " occlusion).",
        unit="cost",
        bounds=(0.0, 1000000.0),
        level="expert",
    )
    view: str = setting(
        "",
        "``front``, ``side``, ``AZ,EL`` in degrees or a camera's prim path; empty means front and"
        " two three-quarter views.",
    )
    space: Literal["object", "view"] = setting(
        "object",
        "``view`` projects elements to the view plane before spacing them (paper fig. 7).",
        level="expert",
    )
    global_coverage: float = setting(
        0.6,
        "A control that moves more than this share of the visible face is global.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    hidden_share: float = setting(
        0.02,
        "A control is hidden when less than this share of its moving places is visible anywhere.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    board_global: bool = setting(
        True,
        "Send controls that move the face as a whole to the board.",
        level="expert",
    )
    board_hidden: bool = setting(
        True,
        "Send controls that only affect geometry hidden in all views to the board.",
        level="expert",
    )
    board_composite: bool = setting(
        True,
        "Send controls that repeat the motion of others to the board.",
        level="expert",
    )
    near_radius: float = setting(
        0.15, "Default for `within`.", unit="face sizes", bounds=(1e-06, 1000000.0), level="expert"
    )


@dataclass(frozen=True, slots=True)
class GroupSettings:
    """Which controls share an element."""

    opposed: bool = setting(True, "Merge opposed controls into bipolar sliders and joysticks.")
    opposed_cosine: float = setting(
        -0.75,
        "Two controls are opposed when the cosine of their motions, as vectors over the whole"
        " surface, is below this: they act on the same region and go opposite ways.",
        bounds=(-2.0, 1.0),
        level="expert",
    )
    patches: bool = setting(
        False,
        "Group controls by the Jaccard index of their candidates (paper section 4.2).",
        level="paper",
    )
    fan_size: int = setting(
        2, "Controls that a group has at most; paper: k.", bounds=(1, 16), level="paper"
    )
    jaccard_min: float = setting(
        0.85,
        "Jaccard index from which controls share an element; paper: epsilon.",
        bounds=(0.0, 1.0),
        level="paper",
    )
    groups: Mapping[str, tuple[str, ...]] = setting(
        {}, "``[groups.groups]``: element name to control names, in order."
    )


@dataclass(frozen=True, slots=True)
class ObjectiveSettings:
    """What a good layout is (paper eq. 1 and 2)."""

    displacement_weight: float = setting(
        0.85,
        "Weight of displacement against overlap; paper: lambda.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    relative_displacement: float = setting(
        0.5,
        "How far displacement is measured against the control's own peak (1) rather than against"
        " the typical peak of the rig (0): subtle controls are worth their best place too.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    overlap_max: float = setting(
        5.0,
        "Cost of two elements on one place; paper: a.",
        unit="cost",
        bounds=(0.0, 1000000.0),
        level="expert",
    )
    overlap_radius: float = setting(
        1.0,
        "Distance at which an overlap costs half; paper: tau, in mean edge lengths with the preset"
        " ``paper``.",
        unit="handle widths",
        bounds=(1e-06, 1000000.0),
        level="expert",
    )
    overlap_sharpness: float = setting(
        6.0,
        "How fast the cost of an overlap falls; paper: s.",
        unit="1 / radius",
        bounds=(1e-06, 1000000.0),
        level="expert",
    )
    overlap_cutoff: float = setting(
        3.0,
        "Distance from which elements do not interact; 0 for no cutoff.",
        unit="radii",
        bounds=(0.0, 1000000.0),
        level="expert",
    )
    samples: int = setting(
        5,
        "Points per track from which overlaps are measured; paper: u.",
        bounds=(2, 64),
        level="expert",
    )
    handle_size: float = setting(
        0.02,
        "Width at which a handle is drawn and kept apart; less on a crowded face.",
        unit="face sizes",
        bounds=(0.0001, 1.0),
    )
    handle_size_min: float = setting(
        0.004,
        "Width below which handles do not shrink, however crowded the face is.",
        unit="face sizes",
        bounds=(0.0001, 1.0),
        level="expert",
    )
    max_neighbours: float = setting(
        8.0,
        "Handles shrink until around the places that a control wants, within four handle widths, no"
        " more than this many controls want theirs, on average; 0 keeps `handle_size`,"
        " and a search for wide handles may take minutes then.",
        unit="controls",
        bounds=(0.0, 1000000.0),
        level="expert",
    )
    separation: bool = setting(
        True, "No two handles nearer than a handle's width, as a hard constraint.", level="expert"
    )
    distinctive_weight: float = setting(
        0.3,
        "Cost of displacement that other controls make as well: a control goes where its motion"
        " is large and its own. At `displacement_weight` it has no value any more.",
        unit="cost",
        bounds=(0.0, 1.0),
        level="expert",
    )
    off_face_penalty: float = setting(
        1.0,
        "Cost of sending a control to the board, per copy; 0 or less than 0 is allowed.",
        unit="cost",
        bounds=(-1000000.0, 1000000.0),
    )
    off_face_allowed: bool = setting(
        True,
        "Whether elements may leave the face for lack of room.",
        level="expert",
    )
    keep_penalty: float = setting(
        0.2,
        "With an earlier layout (`--previous`): cost of moving an element away from where it was,"
        " per copy, and of sending it to the board or back. What saves less stays; 0 lays out"
        " afresh.",
        unit="cost",
        bounds=(0.0, 1000000.0),
    )
    terms: tuple[str, ...] = setting(
        (),
        "Names of further terms of the objective, from installed packages (entry points"
        " ``usdrigui.terms``).",
        level="expert",
    )
    scene_units: bool = setting(
        False,
        "Use the paper's constants literally: tau is the mean edge length, s and displacement in"
        " scene units.",
        level="paper",
    )


@dataclass(frozen=True, slots=True)
class SolveSettings:
    """How the layout problem is solved, and for how long."""

    method: Literal["highs", "paper", "toulbar2"] = setting(
        "highs",
        "Solver of the rest that dual bounds and tests leave: ``highs``, in turn with branch and"
        " bound where the problem stays open, or ``toulbar2``; ``paper`` is the paper's pipeline.",
        level="expert",
    )
    gap: float = setting(
        0.0001,
        "Gap of the cost, (cost - bound) / abs(cost), at which a solution is called optimal.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    work_limit: int = setting(
        60_000_000,
        "Pair evaluations and the like after which the solver stops with its best layout;"
        " reproducible.",
        bounds=(0, 2**62),
        level="expert",
    )
    time_limit: float = setting(
        0.0,
        "Time after which the best layout so far is taken; 0 for none. The result may then depend"
        " on the machine.",
        unit="s",
        bounds=(0.0, 1000000000.0),
    )
    memory_limit: int = setting(
        1024,
        "Memory that the solver may plan to use.",
        unit="MiB",
        bounds=(1, 2**40),
        level="expert",
    )
    clusters: int = setting(
        1, "Clusters that are solved one after another; paper: o.", bounds=(1, 4096), level="paper"
    )
    linkage: Literal["single", "sum"] = setting(
        "single",
        "Distance of two clusters: ``single`` that of their nearest controls, ``sum`` the total"
        " over all pairs of candidates, as the paper's formula reads. Only for ``paper``.",
        level="paper",
    )
    sample: float = setting(
        1.0,
        "Share of the candidates kept by weighted random sampling (paper section 4.2).",
        bounds=(1e-06, 1.0),
        level="paper",
    )
    seed: int = setting(
        0, "Seed of the sampling, of local search and of HiGHS.", bounds=(0, 2**62), level="paper"
    )


@dataclass(frozen=True, slots=True)
class OutputSettings:
    """How elements are drawn and written."""

    bare: bool = setting(False, "Leave the source out of the written layer's sublayers.")
    adapt: Literal["deform", "static"] = setting(
        "deform", "Whether elements deform with the skin or only follow it."
    )
    min_track: float = setting(
        1.5,
        "Least drawn length of a track; shorter ones are drawn enlarged, with the magnification"
        " recorded.",
        unit="handle widths",
        bounds=(0.0, 1000000.0),
        level="expert",
    )


@dataclass(frozen=True, slots=True)
class LevelSettings:
    """Two levels: coarse elements first, and in place of one that is opened its members.

    Handles are kept apart among elements that are visible at the same time only."""

    members: Mapping[str, tuple[str, ...]] = setting(
        {},
        "``[levels.members]``: a coarse control, or the name of an element, to the controls whose "
        "elements are its members. An entry for one side of the character holds for the other.",
    )
    poses: bool = setting(False, "Every pose is coarse; its members are the controls that it sets.")
    groups: bool = setting(
        False,
        "Every element of several axes (joystick, patch, fan) is coarse; each of its axes gets a"
        " slider of its own, its member.",
    )


@dataclass(frozen=True, slots=True)
class LikeSettings:
    """Laying out a character like another one (`--like`)."""

    names: Mapping[str, str] = setting(
        {},
        "Their control's name to ours, where the two differ; an empty name: there is no"
        " counterpart.",
    )
    penalty: float = setting(
        1.0,
        "Cost, per copy, of an element far from the place that corresponds to theirs; nearer ones"
        " pay in proportion to the distance.",
        unit="cost",
        bounds=(0.0, 1000000.0),
        level="expert",
    )


@dataclass(frozen=True, slots=True)
class AnimationSettings:
    """What is made of animation given with `--animation`."""

    weight: float = setting(
        0.5,
        "Weight of use: a control that is never used has the importance 1 - weight, one of the"
        " mean use 1, one used twice as much 1 + weight, one used three times as much or more"
        " 1 + 2 * weight.",
        bounds=(0.0, 1.0),
        level="expert",
    )
    together: float = setting(
        0.8,
        "Least agreement (weighted Jaccard index of the activities) of controls that are reported"
        " to move together.",
        bounds=(0.0, 1.0),
        level="expert",
    )


@dataclass(frozen=True, slots=True)
class PartSettings:
    """The parts of a character, each with a scale and a layout problem of its own."""

    divide: bool = setting(
        True,
        "Lay out face, inside of the mouth, eyes, hands, feet, props and body each by itself; else"
        " all controls as one part.",
    )
    controls: Mapping[str, str] = setting(
        {},
        "``[parts.controls]``: control name to the name of its part, which may be a part of your"
        " own.",
    )


@dataclass(frozen=True, slots=True)
class RigSettings:
    """How a character is read, and the rigger's corrections of its controls."""

    read: ReadSettings = field(default_factory=ReadSettings)
    controls: Mapping[str, ControlSettings] = field(default_factory=dict)
    poses: Mapping[str, PoseSettings] = field(default_factory=dict)
    joints: Mapping[str, JointSettings] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class CharacterSettings:
    """What is found out about a character as a whole."""

    trajectories: TrajectorySettings = field(default_factory=TrajectorySettings)
    symmetry: SymmetrySettings = field(default_factory=SymmetrySettings)
    parts: PartSettings = field(default_factory=PartSettings)
    like: LikeSettings = field(default_factory=LikeSettings)
    animation: AnimationSettings = field(default_factory=AnimationSettings)


@dataclass(frozen=True, slots=True)
class LayoutSettings:
    """The layout problem of each part of a character, and its solution."""

    candidates: CandidateSettings = field(default_factory=CandidateSettings)
    groups: GroupSettings = field(default_factory=GroupSettings)
    levels: LevelSettings = field(default_factory=LevelSettings)
    objective: ObjectiveSettings = field(default_factory=ObjectiveSettings)
    solve: SolveSettings = field(default_factory=SolveSettings)


@dataclass(frozen=True, slots=True)
class Settings:
    """All settings of a run; `usdrigui.settings.load` makes them from the sections of a
    configuration."""

    run: RunSettings = field(default_factory=RunSettings)
    rig: RigSettings = field(default_factory=RigSettings)
    character: CharacterSettings = field(default_factory=CharacterSettings)
    layout: LayoutSettings = field(default_factory=LayoutSettings)
    output: OutputSettings = field(default_factory=OutputSettings)
