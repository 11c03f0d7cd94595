"""What is drawn on the character, and what an animator grabs."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations
from typing import Literal, get_args

import numpy as np

from usdrigui.character.record import Floats, Indices, Record
from usdrigui.character.rig import Body, Glyph, LeftOff
from usdrigui.errors import Issue, counted, issue
from usdrigui.model.assignment import Status
from usdrigui.model.candidates import ElementKind, axes_of
from usdrigui.model.motion import MirrorPlane

SURE = 0.9
"""Confidence from which a match is acted upon; less sure matches are reported only."""
ONE_PLACE = 0.5
"""Handle widths within which two anchors are at one place."""
_MIRRORED = 0.1
"""Handle widths within which an anchor is at the mirror image of another: the two are a pair."""
Side = Literal["left", "right", "middle", "none"]
Decision = Literal["anchor", "place", "grouping"]
"""What a person may decide about an element: its point; on the character or on the board; which
controls share it."""


def in_order(decisions: Collection[str]) -> tuple[Decision, ...]:
    """Each of the decisions once."""
    return tuple(each for each in get_args(Decision) if each in decisions)


class Layout(Record):
    """All elements of one character (paper: L), what was left off, and the proof."""

    root: str
    """Prim path of the SkelRoot."""
    base_values: Floats
    """(controls,) the base pose, in the order of `Rig.controls`."""
    elements: tuple[Element, ...]
    left_off: tuple[LeftOff, ...]
    frame: LayoutFrame
    proof: Proof
    variant_path: str = ""
    """Path of the SkelRoot with the variants that hold the layout, ``/Char{LOD=low}``; empty
    without."""
    matches: tuple[Match, ...] = ()
    """Controls that had another name in the layout that this one succeeds, or may have had."""
    listed: tuple[str, ...] = field(default=(), compare=False)
    """Names of the controls of the base pose as its layer lists them, with and without an element;
    none where no layer does."""

    metres_per_unit: float = field(default=0.0, compare=False)
    """Of the stage that it was read from; 0 where it was not."""

    @property
    def path_in_variants(self) -> str:
        """Of the SkelRoot, with the variants that hold the layout, if any."""
        return self.variant_path or self.root

    @property
    def controls(self) -> frozenset[str]:
        """Names of all controls that have an element."""
        return frozenset().union(*(each.controls for each in self.elements))

    def follow(self, controls: set[str]) -> set[str]:
        """The controls that are pinned as the mirror image of these: a new place of one side is one
        of both."""
        found, by_name = set[str](), {element.name: element for element in self.elements}
        for element in self.elements:
            twin = by_name.get(element.mirror)
            if twin is None or controls.isdisjoint(element.controls):
                continue
            mine, other = (np.array(each.pinned_position) for each in (element, twin))
            apart = np.linalg.norm(self.frame.plane.reflected(mine) - other)
            if apart <= ONE_PLACE * self.frame.handle_width_of(twin.part):
                found |= twin.controls
        return found

    def unpaired(self, told: float = 0.0) -> Iterator[tuple[Element, Element]]:
        """Elements on the character that are each other's mirror image, with the ends of their
        tracks, and do not say so; `told` is how exactly their coordinates are told, in shares."""
        frame = self.frame
        alone = [
            (
                each,
                np.concatenate(
                    [each.anchor.position[None], *(m.track[[0, -1]] for m in each.members)]
                ),
            )
            for each in self.elements
            if not (each.mirror or each.anchor.on_board) and frame.mirrors(each.part)
        ]
        for (one, mine), (other, theirs) in combinations(alone, 2):
            if {one.side, other.side} == {"left", "right"} and mine.shape == theirs.shape:
                away = np.abs(frame.plane.reflected(mine) - theirs).max()
                # Far from the origin single precision does not tell such places apart.
                if away < _MIRRORED * frame.handle_width_of(one.part) - told * np.abs(mine).max():
                    yield one, other

    def with_pairs(self) -> Layout:
        """The layout with the elements that were placed each by itself, and are a pair, as one."""
        found = dict[str, str]()
        for one, other in self.unpaired():
            if found.keys().isdisjoint((one.name, other.name)):
                found |= {one.name: other.name, other.name: one.name}
        return replace(
            self,
            elements=tuple(replace(e, mirror=found.get(e.name, e.mirror)) for e in self.elements),
        )

    def mesh_gone(self, mesh: str, controls: int = 0) -> Issue:
        """LAYOUT_MESH_GONE of a mesh that is not there, with the number of its elements;
        `controls` of the layout are gone too."""
        elements = sum(element.anchor.mesh == mesh for element in self.elements)
        message = f"is gone, and {counted(elements, 'element')} of the layout with it"
        more = f"; {counted(controls, 'control')} of the layout went too"
        return issue("LAYOUT_MESH_GONE", mesh, f"{message}{more * bool(controls)}", self.root)


@dataclass(frozen=True, slots=True)
class Match:
    """Two names of one control."""

    before: str
    after: str
    confidence: float
    """In [0, 1], to three digits: the odds of the best assignment against the best one without this
    pair."""
    reason: str
    """What speaks for it: ``configuration``, ``name``, ``spelling``, ``meaning`` or ``motion``, the
    first that does."""

    @property
    def sure(self) -> str:
        """The confidence in words; rounded down, so that none below `SURE` reads as it."""
        return f"{math.floor(100.0 * self.confidence + 1e-6)}% sure"


class LayoutFrame(Record):
    """From where a layout is seen, what it mirrors about, and how large it is drawn."""

    space: Literal["object", "view"]
    view: Floats
    """(3,) unit direction from the face to the viewer for which the layout was made."""
    plane: MirrorPlane
    handle_width: float
    """Diameter at which handles are drawn and kept apart; scene units."""
    parts: tuple[LayoutPart, ...] = ()
    """Of a character in several parts; then `handle_width`, `view` and `plane` are those of its
    main part, and so are the weights of the proof; its costs are sums."""

    def mirrors(self, part: str) -> bool:
        """Whether `plane` is that of a part: the main one."""
        names = [each.name for each in self.parts] or [part]
        return bool(self.plane.normal.any()) and part in (main_part(names), "")

    def handle_width_of(self, part: str) -> float:
        """Diameter of the handles of a part: of the main one where it has none of its own."""
        widths = {each.name: each.handle_width for each in self.parts}
        return widths.get(part, self.handle_width)

    def view_of(self, part: str) -> Floats:
        """(3,) unit direction from a part to its viewer."""
        views = {each.name: each.view for each in self.parts}
        return views.get(part, self.view)


def main_part(parts: Sequence[str]) -> str:
    """The name of a character's main part: its face, else its body, else the first."""
    return next((name for name in ("face", "body") if name in parts), parts[0])


class Proof(Record):
    """What the solver proved of a layout's cost; nothing of one that is made by hand."""

    method: str = ""
    status: Status = "stopped"
    cost: float = 0.0
    bound: float = -math.inf
    above_unary_bound: float = 0.0
    weights: tuple[tuple[str, float], ...] = ()
    """Numbers of the objective's settings, by their keys."""
    closed_by: str = ""
    """What proved the gap or kept it from that, as `Assignment.closed_by`."""
    figures: tuple[tuple[str, float], ...] = ()
    """How large the solver's program was and how far it came, as `Assignment.figures`."""


class LayoutPart(Record):
    """One part of a character with a scale, a front and a proof of its own."""

    name: str
    handle_width: float
    view: Floats
    """(3,) as `LayoutFrame.view`."""
    status: Status
    cost: float
    bound: float


class Element(Record):
    """What the animator sees and grabs (paper: E_j)."""

    name: str
    """Unique; a valid prim name is made from it by the layer."""
    kind: ElementKind
    members: tuple[Member, ...]
    """In order; a bipolar slider has two opposed members, a joystick is a patch of up to four."""
    anchor: Anchor
    label: str
    side: Side
    """Determines its colour."""
    opposed: tuple[tuple[int, int], ...] = ()
    """Pairs of member positions that are the two ends of one axis."""
    mirror: str = ""
    """Name of the element on the other side, or empty."""
    reversed: tuple[int, ...] = ()
    """Positions of members that mirror those of `mirror` with the opposite sign: both go both
    ways."""
    adapt: Literal["deform", "static"] = "deform"
    glyph: Glyph | None = None
    """Drawn as its handle; None for the usual shape."""
    inner: tuple[str, ...] = ()
    """Names of its members: the elements that are shown in its place when it is opened.  Empty
    unless it is coarse."""
    part: str = ""
    """The part of the character: ``face``, ``hands``, ``feet``, ``body`` or one of the
    configuration's; empty where a layer has none."""
    category: str = ""
    """On the board, its heading (``global``, ``hidden``, ``composite``,
    ``requested``, ``crowded``); else empty."""
    reason: str = ""
    """Why it is on the board or shares an element; else empty."""
    pinned: tuple[Decision, ...] = ()
    """Decisions of a person that hold whenever the layout is made again."""
    pinned_position: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """Of the anchor at rest, in root space, on the rig for which they were made; means nothing
    without ``anchor``."""

    @property
    def axes(self) -> tuple[tuple[int, ...], ...]:
        """Positions of the members of each axis: one control, or the negative and the positive end
        of a signed axis."""
        return axes_of(len(self.members), self.opposed)

    @property
    def controls(self) -> frozenset[str]:
        """Names of its controls."""
        return frozenset(member.control for member in self.members)


@dataclass(frozen=True, slots=True)
class Legibility:
    """Which elements can be read and grabbed at a glance, seen from the layout's own view."""

    elements: int
    """Elements of the first level on the part."""
    unclear: tuple[tuple[str, str], ...]
    """The others, and what is in the way of each."""

    @property
    def clear(self) -> int:
        """How many are in nobody's way."""
        return self.elements - len(self.unclear)

    def __add__(self, other: Legibility) -> Legibility:
        """That of two parts together."""
        return Legibility(self.elements + other.elements, self.unclear + other.unclear)


class Member(Record):
    """One control of an element, with its drawn track."""

    control: str
    """`Control.name`."""
    values: Floats
    """(k,) control values along the track."""
    track: Floats
    """(k, 3) drawn positions at the base pose, magnified."""
    arc_length: float
    """Of the anchor's true trajectory."""
    magnification: float
    """Drawn length over true length: 1 unless the trajectory is too small to be used."""
    peak: float = 0.0
    """`arc_length` of the point that the control moves farthest; 0 where no layer says it."""
    attribute: str = field(default="", compare=False)
    """Path of the property that holds the control's value; empty where no layer has it yet."""


class Anchor(Record):
    """Where an element holds on to the character."""

    mesh: str
    """Prim path of the mesh."""
    point: int
    """Local point index."""
    point_count: int
    topology_hash: str
    position: Floats
    """(3,) at the base pose.  On the board: the place of the element itself."""
    normal: Floats
    """(3,) unit; the direction in which the element faces."""
    on_board: bool
    """True when the element is on the board and takes from the point its joint influences
    only."""

    @property
    def place(self) -> str:
        """``MESH#POINT``, as a configuration takes it, or ``board``."""
        return "board" if self.on_board else f"{self.mesh}#{self.point}"

    def on(self, body: Body) -> int:
        """The point of a character that it names; -1 where the character has none such."""
        return body.point_of(self.mesh, self.point)

    def fits(self, topology_hash: str) -> bool:
        """Whether a mesh of this hash has the points and faces on which the anchor was made; so it
        has where one of the two hashes is not known (empty)."""
        return "" in (self.topology_hash, topology_hash) or self.topology_hash == topology_hash

    def mesh_change(self, topology_hash: str, points: int) -> str:
        """A clause on its mesh, which has this hash and so many points (0: not known) now; empty
        where it fits."""
        if self.fits(topology_hash):
            return ""
        counts = f": {self.point_count} points then, {points} now"
        known = self.point_count and points
        return f"{self.mesh} has other points or faces{counts if known else ''}"


class ExistingSpan(Record):
    """Points that draw one element of a layout that exists."""

    element: str
    """Its name."""
    role: Literal["handle", "track"]
    """An area is one of the tracks."""
    points: Indices
    """(n,) ascending, into the points of the prim."""


class ExistingPrim(Record):
    """One drawn prim of a layout that exists."""

    root: str
    """Of the character: its SkelRoot."""
    path: str
    in_variant: bool
    """Whether a variant brings it in, so that layers over it must speak in it too, or be weaker."""
    names: tuple[str, ...]
    """Of prims about it, which new ones must not have."""
    spans: tuple[ExistingSpan, ...]
    shapes: tuple[str, ...]
    """``skel:blendShapes``."""
    targets: tuple[str, ...]
    """``skel:blendShapeTargets``."""
