"""What the solvers are asked."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from usdrigui.character.record import Flags, Floats, Indices, Record


class LayoutProblem(Record):
    """Choose one label per variable so that the total cost is least (paper eq. 2-5).

    cost = sum of linear costs + sum over unordered pairs of variables of their pair cost.  The pair
    cost of two candidates is the sum of their overlap over all pairs of copies, or
    +inf if any two handles are nearer than `separation`; a variable on the board has no pair costs,
    and neither have two variables that are never visible together.  `extra` adds explicit
    non-negative pair costs on top.  Nothing else is part of the problem.
    """

    variables: tuple[Variable, ...]
    overlap: AnyOverlap
    separation: float
    """Scene units; > 0. Tiny (coincidence) where only "one element per point" is asked (paper eq.
    4)."""
    extra: tuple[ExtraPairs, ...] = ()

    @cached_property
    def together(self) -> Flags:
        """(variables, variables) whether two elements are ever visible together."""
        states = [each.states for each in self.variables]
        found = np.array(
            [[bool(one & other) for other in states] for one in states], dtype=np.bool_
        )
        return found.reshape(len(states), len(states))


class Variable(Record):
    """One element to place: its candidates are the labels 0..R-1; label -1 is the board.

    An element stands for itself and for its images under the symmetry (paper section 3.3, symmetric
    elements): `samples` and `handles` hold one entry per copy, in d coordinates: 2 on the
    screen of a layout's view, 3 in the scene.
    """

    name: str
    points: Indices
    """(R,) anchor point of each candidate (of copy 0)."""
    cost: Floats
    """(R,) finite linear cost of each candidate, all copies and their mutual overlap included."""
    samples: Floats
    """(R, copies, u, d) points along the drawn element, for overlaps."""
    handles: Floats
    """(R, copies, d) where the handle rests; (R, copies, 3), the screen's coordinates first, where
    elements are measured on a screen and their handles kept apart in the scene."""
    off_face_cost: float
    """Linear cost of label -1; +inf when the element must stay on the face."""
    displacement: Floats
    """(R,) displacement of each candidate (paper: d), all copies, in the units of the objective:
    part of `cost` already; a weight for those who sample candidates."""
    states: frozenset[int] = frozenset({0})
    """States of the layout in which the element is visible; two elements without a common one do
    not interact."""


class Overlap(Record):
    """What two elements cost that are in each other's way as they are drawn (`usdrigui.overlap`).

    Each cost is in the units of the objective, each radius in scene units; from a radius on, what
    it belongs to costs nothing.
    """

    samples: int
    """Samples of each track."""
    handle_width: float
    near: float
    """Cost of two handles on one place."""
    near_radius: float
    room: float
    """Cost besides of two handles on one place; falls more slowly than `near`."""
    room_radius: float
    on_track: float
    """Cost of a handle on a track of another element."""
    track_radius: float
    crossing: float
    """Cost of two tracks that cross."""
    along: float
    """Cost of a track that lies on another one and runs the same way."""
    along_radius: float
    short: float
    """Linear cost of an element without a track; nothing from a handle's width on."""

    @property
    def most(self) -> float:
        """What two elements cost at most."""
        return self.near + self.room + 2.0 * self.on_track + self.crossing + 2.0 * self.along

    @property
    def reach(self) -> float:
        """Distance of drawn points from which two elements cannot interact; scene units."""
        room_radius = self.room_radius if self.room else 0.0
        return max(self.near_radius, room_radius, self.track_radius, self.along_radius)


class MeanOverlap(Record):
    """Constants of the paper's overlap cost (eq. 1, with the sign corrected).

    phi(z) = maximum / (1 + exp(sharpness (z - radius))), lowered by its value at
    `cutoff_distance` and cut to zero from there on: elements further apart do not interact.
    """

    maximum: float
    radius: float
    """Scene units."""
    sharpness: float
    """Per scene unit."""
    cutoff_distance: float
    """Scene units; inf for no cut."""
    weight: float
    """Factor on every overlap in the objective (paper: 1 - lambda)."""

    @property
    def most(self) -> float:
        """What two elements cost at most."""
        return self.weight * self.maximum

    @property
    def reach(self) -> float:
        """Distance of drawn points from which two elements cannot interact; scene units."""
        return self.cutoff_distance


AnyOverlap = Overlap | MeanOverlap


class ExtraPairs(Record):
    """Explicit pair costs between the candidates of two variables (a < b), added to the
    overlap's."""

    first: int
    second: int
    first_labels: Indices
    second_labels: Indices
    costs: Floats
    """(q,) >= 0; each (label, label) pair at most once."""


class Choice(Record):
    """What the labels of one variable mean: anchors and drawn points of every copy of the
    element."""

    group: int
    """Index into the groups."""
    controls: tuple[tuple[int, ...], ...]
    """(copies, members) indices into `Rig.controls`."""
    anchors: Indices
    """(R, copies) anchor points."""
    sources: Indices
    """(R, copies) points whose trajectories are drawn."""
