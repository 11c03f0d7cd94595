"""The records that the stages hand to each other; numpy only, read-only throughout.

    Usd.Stage → Rig → Trajectories → Candidates → Groups → LayoutProblem → Assignment → Layout → Sdf.Layer

Coordinates: unless a field says otherwise, positions are in the space of the SkelRoot ("root space"),
column ``(x, y, z)`` triples in scene units.  Matrices are 4x4 in USD's row-vector convention
(``p' = p @ M``).  *Point* means an index into the concatenation of all meshes' points, in the order
of `Rig.meshes`; *local* point means an index into one mesh.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cache, cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from usdrigui.errors import Issue

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

ControlKind = Literal["blendShape", "joint", "pose"]
ElementKind = Literal["slider", "patch", "fan"]
Side = Literal["left", "right", "middle", "none"]


class Record:
    """Base of the frozen records: makes every numpy array field read-only after construction."""

    __slots__ = ()

    def __post_init__(self) -> None:
        kind: Any = type(self)
        for name in _array_fields(kind):
            freeze(getattr(self, name))


@cache
def _array_fields(record: Any) -> tuple[str, ...]:
    """Names of the fields that may hold arrays: all but those annotated as a single plain value."""
    plain = {"str", "int", "float", "bool", "Drive", "ControlKind", "ElementKind", "Side"}
    return tuple(
        each.name for each in fields(record) if each.type not in plain and not str(each.type).startswith("Literal")
    )


def freeze(value: Any) -> Any:
    """Make `value` (an array, or a tuple of arrays) read-only in place and return it."""
    if isinstance(value, np.ndarray):
        value.setflags(write=False)
    elif type(value) is tuple:
        for item in value:
            if isinstance(item, np.ndarray):
                item.setflags(write=False)
    return value


# --- the rig -----------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Shape(Record):
    """What one blend-shape token does to one mesh.

    The offset of a point at weight w is piecewise linear in w through the origin and `weights`, and is
    extrapolated beyond the ends along the first and last pieces, as UsdSkelBlendShapeQuery does.
    """

    channel: int
    """Index of the weight that drives it, into `Rig.channels`; several shapes of a mesh may share it."""
    path: str
    """Prim path of the BlendShape."""
    weights: Floats
    """(k,) ascending in-between weights and 1; never 0."""
    points: Indices
    """(p,) local point indices that have an offset, ascending, unique."""
    offsets: Singles
    """(k, p, 3) offsets in the mesh's own space."""


@dataclass(frozen=True, eq=False)
class Skin(Record):
    """Joint influences of one mesh."""

    joints: Indices
    """(n, k) joint indices into `Rig.joints`."""
    weights: Floats
    """(n, k) weights as authored; like UsdSkel, nothing normalises them."""
    method: Literal["classicLinear", "dualQuaternion"]
    geom_bind: Floats
    """(4, 4) geomBindTransform."""
    rigid: bool
    """True when the influences are constant over the mesh (n is still the number of points)."""

    @cached_property
    def by_joint(self) -> tuple[Indices, Floats, Indices, Indices]:
        """The same influences, without zeros, sorted by joint: local points (m,), weights (m,), the joints that
        have any (j,), and where each begins (j + 1,).  A point appears once per joint."""
        count = max(1, len(self.joints))
        points, slots = np.nonzero(self.weights)
        keys, place = np.unique(self.joints[points, slots] * count + points, return_inverse=True)
        weights = np.bincount(place, self.weights[points, slots], len(keys)).astype(np.float64)
        joints, starts = np.unique(keys // count, return_index=True)
        return keys % count, weights, joints.astype(np.int64), np.append(starts, len(keys)).astype(np.int64)


@dataclass(frozen=True, eq=False)
class Subset(Record):
    """A GeomSubset: a named part of a mesh."""

    path: str
    points: Indices
    """Local points, ascending: those of its faces, for a subset of faces."""


@dataclass(frozen=True, eq=False)
class RigMesh(Record):
    """One mesh under the SkelRoot, as authored."""

    path: str
    points: Floats
    """(n, 3) `points` in the mesh's own space."""
    face_counts: Indices
    face_indices: Indices
    """Local point indices."""
    left_handed: bool
    visible: bool
    """False when the visibility or the purpose hides it from a default render."""
    subdivision: str
    """subdivisionScheme token."""
    to_root: Floats
    """(4, 4) mesh space to root space; used where there is no skin."""
    skin: Skin | None
    shapes: tuple[Shape, ...]
    topology_hash: str
    """Hex digest of point count, face counts and face indices: changes when point indices mean others."""
    subsets: tuple[Subset, ...] = ()
    """GeomSubsets, for locality."""


@dataclass(frozen=True, eq=False)
class Joint(Record):
    """One joint of one skeleton; parents come before children in `Rig.joints`."""

    path: str
    """Joint token as in `Skeleton.joints`, for example ``Head/Jaw``."""
    skeleton: int
    """Index into `Rig.skeletons`."""
    parent: int
    """Index into `Rig.joints`, or -1."""
    bind: Floats
    """(4, 4) bindTransforms entry (world at bind time)."""
    rest: Floats
    """(4, 4) local restTransforms entry."""
    base: Floats
    """(4, 4) local transform in the base pose (the rest transform unless a time or pose was chosen)."""


@dataclass(frozen=True, eq=False)
class Skeleton(Record):
    """One Skeleton bound under the SkelRoot."""

    path: str
    animation: str
    """Prim path of the SkelAnimation that drives it, or empty."""
    to_root: Floats
    """(4, 4) skeleton space to root space."""


@dataclass(frozen=True, eq=False)
class Channel(Record):
    """One blend-shape weight of one SkelAnimation."""

    token: str
    animation: str
    """Prim path of the SkelAnimation, or empty if none lists the token."""
    index: int
    """Position in `SkelAnimation.blendShapes`, or -1."""


@dataclass(frozen=True, eq=False)
class Drive(Record):
    """What a control sets, as a piecewise linear function of its value.

    At value v the control adds to the base pose: blend-shape weights, joint rotations (as rotation
    vectors about the joint's own axes), translations and logarithms of scales.  A base transform with
    linear part S R (stretch, rotation) and translation t becomes ``exp(scales) S exp(rotations) R`` and
    ``t + translations``, which is what a SkelAnimation holds.  Between keys all are interpolated linearly
    (rotation vectors too: with two keys that is slerp), beyond the ends they are extrapolated.  All rows
    are zero where the value is the default.
    """

    values: Floats
    """(k,) ascending control values of the keys, k >= 2."""
    channels: Indices
    """(t,) indices into `Rig.channels`."""
    weights: Floats
    """(k, t) added weights."""
    joints: Indices
    """(j,) indices into `Rig.joints`."""
    rotations: Floats
    """(k, j, 3) rotation vectors, radians."""
    translations: Floats
    """(k, j, 3) added to the joint's local translation."""
    scales: Floats
    """(k, j, 3) logarithms of scale factors along the joint's local axes."""


@dataclass(frozen=True, eq=False)
class Control(Record):
    """One rig parameter (paper: c_j)."""

    name: str
    """Unique in the rig: the token, ``joint:rx`` or the pose's name, after renaming by the config."""
    label: str
    """For people; the name unless the config gives another."""
    kind: ControlKind
    source: str
    """Blend-shape token, joint path or pose name as authored."""
    minimum: float
    default: float
    maximum: float
    range_source: Literal["config", "limits", "animation", "inbetweens", "metadata", "default"]
    drive: Drive


@dataclass(frozen=True, eq=False)
class Clip(Record):
    """Authored animation, for playback and for ranges; empty arrays where nothing is authored."""

    times: Floats
    """(f,) time codes."""
    weights: Floats
    """(f, len(Rig.channels)) absolute weights."""
    locals: Floats
    """(f, len(Rig.joints), 4, 4) local joint transforms."""
    frames_per_second: float


@dataclass(frozen=True, eq=False)
class Glyph(Record):
    """A curve or mesh that is drawn as an element's handle instead of the usual shape."""

    name: str
    """As the configuration names it."""
    form: Literal["curve", "mesh"]
    points: Floats
    """(q, 3).  In `Rig.glyphs`: x to the viewer's right, y up, z out of the face, in a sphere of radius 1 about
    the origin.  In `Element.glyph`: offsets from the handle's centre in the base pose; root space, scene units."""
    counts: Indices
    """(f,) points of each polyline or polygon."""
    indices: Indices
    """(sum of counts,) into `points`; polygons counter-clockwise from outside, polylines one after the other."""


@dataclass(frozen=True, eq=False)
class Performance(Record):
    """One SkelAnimation, sampled frame by frame, whatever character it is of."""

    source: str
    """Name of its file."""
    path: str
    """Prim path."""
    times: Floats
    """(f,) time codes, evenly spaced."""
    tokens: tuple[str, ...]
    weights: Floats
    """(f, len(tokens)) blend-shape weights."""
    joints: tuple[str, ...]
    """Joint tokens."""
    rotations: Floats
    """(f, len(joints), 3, 3) local rotations."""


@dataclass(frozen=True, eq=False)
class Rig(Record):
    """A character under one SkelRoot: everything the layout needs, and no USD object."""

    root: str
    """Prim path of the SkelRoot."""
    meshes: tuple[RigMesh, ...]
    skeletons: tuple[Skeleton, ...]
    joints: tuple[Joint, ...]
    channels: tuple[Channel, ...]
    base_weights: Floats
    """(len(channels),) weights in the base pose (0 unless a time or pose was chosen)."""
    controls: tuple[Control, ...]
    clip: Clip | None
    up: Floats
    """(3,) unit up direction in root space."""
    metres_per_unit: float
    left_off: tuple[LeftOff, ...]
    """Controls that the source has but the rig does not, and why."""
    issues: tuple[Issue, ...]
    glyphs: Mapping[str, Glyph] = field(default_factory=dict)
    """Shapes that the configuration wants drawn as handles, by the name that it gives them."""
    excluded: tuple[Control, ...] = ()
    """Controls that the configuration leaves out; what they move still tells how large the face is."""

    @cached_property
    def shapes_by_channel(self) -> Mapping[int, tuple[tuple[int, Shape], ...]]:
        """(mesh index, shape) of every shape that a channel drives; channels without shapes are absent."""
        found: dict[int, tuple[tuple[int, Shape], ...]] = {}
        for index, mesh in enumerate(self.meshes):
            for shape in mesh.shapes:
                found[shape.channel] = (*found.get(shape.channel, ()), (index, shape))
        return found

    @property
    def starts(self) -> Indices:
        """(len(meshes) + 1,) first point of each mesh; the last entry is the number of points."""
        return np.cumsum([0, *(len(mesh.points) for mesh in self.meshes)], dtype=np.int64)

    def mesh_of(self, point: int) -> tuple[int, int]:
        """Mesh index and local point of a point."""
        starts = self.starts
        mesh = int(np.searchsorted(starts, point, side="right")) - 1
        return mesh, int(point - starts[mesh])


@dataclass(frozen=True, slots=True)
class LeftOff:
    """A control, element or candidate that a stage dropped."""

    control: str
    stage: str
    """``read``, ``trajectories``, ``candidates``, ``groups``, ``solve`` or ``config``."""
    reason: str
    """For people: one clause, without a full stop."""


# --- motion ------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Motion(Record):
    """The trajectories of all points that one control moves (paper: d_j)."""

    control: int
    """Index into `Rig.controls`."""
    values: Floats
    """(k,) ascending control values of the knots; includes minimum, default and maximum."""
    points: Indices
    """(p,) points that move, ascending."""
    offsets: Singles
    """(k, p, 3) position minus base position, in root space; zero at the default."""
    arc_length: Floats
    """(p,) length of each polyline from minimum to maximum."""


@dataclass(frozen=True, eq=False)
class Trajectories(Record):
    """Trajectories of every point under every control, at the base pose."""

    base: Floats
    """(n, 3) points of the base pose."""
    normals: Floats
    """(n, 3) unit outward normals at the base pose; zero where undefined."""
    places: Indices
    """(n,) index of the first point at the same position: points split at seams share one place."""
    motions: tuple[Motion, ...]
    """One per control that moves something; others stand in `left_off`."""
    face_size: float
    """Height along `Rig.up` of the region moved by the local controls: the unit of handle sizes."""
    typical_length: float
    """Median over local controls of the largest arc length (design: l0), the unit of displacement."""
    left_off: tuple[LeftOff, ...]
    issues: tuple[Issue, ...] = ()
    """Tiny and duplicate controls: kept, but worth knowing."""
    excluded: tuple[Motion, ...] = ()
    """Motions of `Rig.excluded`, which their `control` counts: part of the yardstick for whole-face controls."""

    def motion_of(self, control: int) -> Motion:
        """The motion of a control, which must move something."""
        return next(each for each in self.motions if each.control == control)


@dataclass(frozen=True, eq=False)
class Symmetry(Record):
    """The mirror plane of the character and what it maps to what."""

    origin: Floats
    normal: Floats
    """(3,) points to the character's left; zero when there is no symmetry."""
    partner: Indices
    """(n,) nearest point to the mirror image, or -1 where none lies within the tolerance."""
    distance: Floats
    """(n,) distance of the partner from the exact mirror image (inf where none)."""
    twins: Indices
    """(controls,) index of the twin control; its own index if self-symmetric; -1 if neither."""
    sources: tuple[str, ...]
    """(controls,) how each twin was decided: ``config``, ``geometry``, ``name`` or empty."""
    reversed: Flags
    """(controls,) True where the mirror image is the twin going the other way: one rises as the other falls."""


# --- choice ------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class CandidateSet(Record):
    """Where one control may be anchored."""

    motion: int
    """Index into `Trajectories.motions`."""
    points: Indices
    """(p,) points, ascending."""
    cost: Floats
    """(p,) linear cost besides displacement and overlap (occlusion, plane, locality...), >= 0, in the
    units of the objective."""
    globally: bool
    """True when the control moves the face as a whole: laid out beside it."""
    hidden: bool
    """True when the control moves only what no view shows: laid out beside the face."""
    composite: bool
    """True when it repeats what atomic controls do together: laid out beside the face."""
    coverage: float
    """Share of the visible places of the face that it moves."""
    sources: Indices
    """(p,) point whose trajectory is drawn at each of `points`: the same point, unless the control is shown
    at a visible proxy of a hidden region."""
    reason: str = ""
    """Why it is laid out beside the face; else empty."""
    requested: bool = False
    """True when the configuration alone sends it beside the face."""


@dataclass(frozen=True, eq=False)
class Candidates(Record):
    """The candidates of every control that has any (paper section 4.2, pruning)."""

    sets: tuple[CandidateSet, ...]
    left_off: tuple[LeftOff, ...]


@dataclass(frozen=True, slots=True)
class Group:
    """Controls that share one element (paper: g)."""

    name: str
    kind: ElementKind
    controls: tuple[int, ...]
    """Indices into `Rig.controls`, in the element's order; opposed controls stand next to each other."""
    opposed: tuple[tuple[int, int], ...]
    """Pairs of `controls` that are the two ends of one axis (negative, positive)."""
    mirror: tuple[int, ...]
    """The twins of `controls` in the same order, if the element is one of a symmetric pair; else empty."""
    reason: str
    """Why they are grouped; empty for a single control."""
    beside: bool = False
    """True when it goes beside the face whatever the costs."""
    family: str = ""
    """Heading under which it then stands: ``global``, ``hidden``, ``composite`` or ``requested``."""
    images: tuple[tuple[int, ...], ...] = ()
    """The controls of every further copy under the symmetry, in the same order: `mirror` for a pair, n - 1
    tuples for an n-fold orbit."""
    image_names: tuple[str, ...] = ()
    """Names that the configuration gives to those copies; empty strings where it gives none."""
    inner: tuple[str, ...] = ()
    """Names of the groups that are shown in place of this one when it is opened; none unless it is coarse."""
    part: bool = False
    """True for a slider of its own of controls that another, coarse, group holds too."""
    states: frozenset[int] = frozenset({0})
    """States of the layout in which it is visible: 0 with nothing opened, k with the k-th coarse group opened."""


@dataclass(frozen=True, eq=False)
class Overlap(Record):
    """Constants of the overlap cost (paper eq. 1, with the sign corrected).

    phi(z) = maximum / (1 + exp(sharpness (z - radius))), lowered by its value at `reach` and cut to
    zero from there on, so that elements further apart than `reach` do not interact at all.
    """

    maximum: float
    radius: float
    """Scene units."""
    sharpness: float
    """Per scene unit."""
    reach: float
    """Scene units; inf for no cut."""
    weight: float
    """Factor on every overlap in the objective (paper: 1 - lambda)."""


@dataclass(frozen=True, eq=False)
class Variable(Record):
    """One element to place: its candidates are the labels 0..R-1; label -1 is *beside the face*.

    An element stands for itself and for its images under the symmetry (paper section 3.3, symmetric
    elements): `samples` and `handles` hold one entry per copy.
    """

    name: str
    points: Indices
    """(R,) anchor point of each candidate (of copy 0)."""
    cost: Floats
    """(R,) finite linear cost of each candidate, all copies and their mutual overlap included."""
    samples: Floats
    """(R, copies, u, 3) points along the drawn element, for overlaps."""
    handles: Floats
    """(R, copies, 3) where the handle rests."""
    beside: float
    """Linear cost of label -1; +inf when the element must stay on the face."""
    displacement: Floats
    """(R,) displacement of each candidate (paper: d), all copies, in the units of the objective: part of `cost`
    already; a weight for those who sample candidates."""
    states: frozenset[int] = frozenset({0})
    """States of the layout in which the element is visible; two elements without a common one do not interact."""


@dataclass(frozen=True, eq=False)
class LayoutProblem(Record):
    """Choose one label per variable so that the total cost is least (paper eq. 2-5).

    cost = sum of linear costs + sum over unordered pairs of variables of their pair cost.  The pair cost
    of two candidates is ``overlap.weight`` times the sum of phi over all pairs of copies, or +inf if any
    two handles are nearer than `separation`; a variable beside the face has no pair costs, and neither have
    two variables that are never visible together.  `extra`
    adds explicit non-negative pair costs on top.  Nothing else is part of the problem.
    """

    variables: tuple[Variable, ...]
    overlap: Overlap
    separation: float
    """Scene units; > 0. Tiny (coincidence) where only "one element per point" is asked (paper eq. 4)."""
    unit_cost: float
    """Cost of one unit of displacement (lambda); informs displays, not part of the problem."""
    extra: tuple[ExtraPairs, ...] = ()

    @cached_property
    def together(self) -> Flags:
        """(variables, variables) whether two elements are ever visible together."""
        states = [each.states for each in self.variables]
        found = np.array([[bool(one & other) for other in states] for one in states], dtype=np.bool_)
        return found.reshape(len(states), len(states))


@dataclass(frozen=True, eq=False)
class ExtraPairs(Record):
    """Explicit pair costs between the candidates of two variables (a < b), added to the overlap's."""

    first: int
    second: int
    first_labels: Indices
    second_labels: Indices
    costs: Floats
    """(q,) >= 0; each (label, label) pair at most once."""


Status = Literal["optimal", "stopped"]

GAP_FLOOR = 1e-3
"""Cost below which gaps are no longer relative: a thousandth of what one element's place is worth. Without it the
gap of a problem whose best cost is zero could never close."""


@dataclass(frozen=True, eq=False)
class Assignment(Record):
    """A solution of a `LayoutProblem` with its proof."""

    labels: Indices
    """(variables,) chosen candidate of each variable; -1 is beside the face."""
    cost: float
    bound: float
    """Lower bound on the cost of every solution of the problem as given; -inf if none is known."""
    status: Status
    """``optimal`` when the relative gap is within the setting; ``stopped`` at a limit."""
    in_play: float
    """cost minus the sum over variables of their least linear cost: what the choice can change (>= 0)."""
    method: str
    steps: tuple[Step, ...] = ()

    @property
    def gap(self) -> float:
        """(cost - bound) / |cost|; costs nearer to zero than `GAP_FLOOR` count as that."""
        return max(0.0, self.cost - self.bound) / max(abs(self.cost), GAP_FLOOR)

    @property
    def gap_in_play(self) -> float:
        """(cost - bound) over the part of the cost that the choice can change; 0 when proven."""
        excess = max(0.0, self.cost - self.bound)
        rounding = 1e-9 * abs(self.cost)
        return excess / max(self.in_play, 1e-12) if excess > rounding else 0.0


@dataclass(frozen=True, slots=True)
class Step:
    """Statistics of one step of a solver, for the report."""

    name: str
    figures: tuple[tuple[str, float], ...]
    """Ordered (what, number) pairs; never times."""
    seconds: float
    """For people; never part of an output that must be reproducible."""


# --- layout ------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Anchor(Record):
    """Where an element holds on to the character."""

    mesh: str
    """Prim path of the mesh."""
    point: int
    """Local point index."""
    point_count: int
    topology_hash: str
    position: Floats
    """(3,) at the base pose.  Beside the face: the place of the element itself."""
    normal: Floats
    """(3,) unit; the direction in which the element faces."""
    beside: bool
    """True when the element stands beside the face and takes from the point its joint influences only."""


@dataclass(frozen=True, eq=False)
class Member(Record):
    """One control of an element, with its drawn track."""

    control: str
    """`Control.name`."""
    values: Floats
    """(k,) control values along the track."""
    track: Floats
    """(k, 3) drawn positions at the base pose, gain applied."""
    arc_length: float
    """Of the anchor's true trajectory."""
    gain: float
    """Drawn length over true length: 1 unless the trajectory is too small to be used."""


@dataclass(frozen=True, eq=False)
class Element(Record):
    """What the animator sees and grabs (paper: E_j)."""

    name: str
    """Unique; a valid prim name is made from it by the layer."""
    label: str
    kind: ElementKind
    members: tuple[Member, ...]
    """In order; a bipolar slider has two opposed members, a joystick is a patch of up to four."""
    opposed: tuple[tuple[int, int], ...]
    """Pairs of member positions that are the two ends of one axis."""
    anchor: Anchor
    side: Side
    mirror: str
    """Name of the element on the other side, or empty."""
    family: str
    """For elements beside the face: the heading under which it stands (``global``, ``hidden``,
    ``composite``, ``requested``, ``crowded``); else empty."""
    reason: str
    """Why it stands beside the face or shares an element; else empty."""
    adapt: Literal["deform", "static"] = "deform"
    glyph: Glyph | None = None
    """Drawn as its handle; None for the usual shape."""
    reversed: tuple[int, ...] = ()
    """Positions of members that mirror those of `mirror` with the opposite sign: both go both ways."""
    inner: tuple[str, ...] = ()
    """Names of its members: the elements that are shown in its place when it is opened.  None unless it is coarse."""


@dataclass(frozen=True, eq=False)
class Layout(Record):
    """All elements of one character (paper: L), what was left off, and the proof."""

    root: str
    """Prim path of the SkelRoot."""
    elements: tuple[Element, ...]
    left_off: tuple[LeftOff, ...]
    handle_width: float
    """Diameter at which handles are drawn and kept apart; scene units."""
    space: Literal["object", "view"]
    view: Floats
    """(3,) unit direction from the face to the viewer for which the layout was made."""
    plane_origin: Floats
    plane_normal: Floats
    """(3,) symmetry plane; normal zero when there is none."""
    base_values: Floats
    """(controls,) base pose: value of every control, in the order of `Rig.controls`."""
    method: str
    status: Status
    cost: float
    bound: float
    in_play: float
    weights: tuple[tuple[str, float], ...] = field(default=())
    """Settings of the objective that the cost depends on, by name."""
