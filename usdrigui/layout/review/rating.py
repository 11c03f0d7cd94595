"""Every element on the face by the objective that would place it, all others staying."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Floats, Indices, Record
from usdrigui.layout.face import Face
from usdrigui.layout.reuse.partial_layout import place_of
from usdrigui.model import (
    Choice,
    Element,
    LayoutProblem,
)
from usdrigui.overlap import pair_costs


@dataclass(frozen=True, slots=True)
class ElementReview:
    """One element on the face, by the objective."""

    element: str
    kept: float
    """Arc length at the anchor over the control's peak, of the worst member."""
    linear: float
    """Linear cost: displacement (negative), occlusion, plane and the like; all copies."""
    overlap: float
    """Cost of its overlap with all other elements."""
    nearest: str
    """The element whose handle is nearest."""
    distance: float
    """Between the two handles, in handle widths; inf when it is alone."""
    gain: float
    """What moving it to its best place would save, all others staying; a pair moves as one.  0 when
    it is there."""
    better: str
    """That place as ``MESH_PATH#POINT``, ready for a configuration; empty when it is there."""


def ratings(
    face: Face,
    elements: tuple[Element, ...],
    answered: tuple[LayoutProblem, tuple[Choice, ...], Indices],
) -> tuple[ElementReview, ...]:
    """The elements of a layout in the order of the variables of the problem that it answers, as
    `as_problem` gives it."""
    rated = _Rated(face, *answered)
    return tuple(rated.element(*each) for each in enumerate(rated.mates(elements)))


class _Rated(Record):
    """A layout as an answer to a problem."""

    face: Face
    problem: LayoutProblem
    choices: tuple[Choice, ...]
    labels: Indices

    def element(self, index: int, mate: int) -> ElementReview:
        """One element, which moves with its `mate` where it has one: not -1."""
        variable, choice = self.problem.variables[index], self.choices[index]
        label = self.labels[index]
        alone = self._given[index].sum(axis=0)
        whole = self._with_mate(index, mate) if mate >= 0 else alone
        best = np.argmin(whole)
        gain = whole[label] - whole[best] if np.isfinite(whole[label]) else np.inf
        nearest, distance = self._neighbour(index)
        return ElementReview(
            element=variable.name,
            kept=self._kept(choice, label),
            linear=float(variable.cost[label]),
            overlap=float(alone[label] - variable.cost[label]),
            nearest=nearest,
            distance=float(distance) / self.face.handle_width,
            gain=float(gain),
            better=place_of(self.face.rig.body, int(choice.anchors[best, 0])) if gain > 0.0 else "",
        )

    def mates(self, elements: tuple[Element, ...]) -> list[int]:
        """For every element the other one of its pair, where one is the mirror image of the other;
        else -1."""
        mirror = {element.name: element.mirror for element in elements}
        names = [variable.name for variable in self.problem.variables]
        index = {name: i for i, name in enumerate(names)}
        at = [c.anchors[label, 0] for c, label in zip(self.choices, self.labels, strict=True)]
        mates, images = [index.get(mirror[name], -1) for name in names], self._partner[at]
        return [
            j if j >= 0 and (images[i] == at[j] or images[j] == at[i]) else -1
            for i, j in enumerate(mates)
        ]

    @property
    def _partner(self) -> Indices:
        return self.face.symmetry.partner

    def _with_mate(self, index: int, mate: int) -> Floats:
        """(R,) cost of every candidate of an element with its mate on its mirror image, and of the
        two where they are; inf where no candidate is, or the mirror image of that is another place:
        then only one of the two could choose it."""
        mine, anchors = (self.choices[each].anchors[:, 0] for each in (index, mate))
        images = self._partner[mine]
        rows = np.minimum(np.searchsorted(anchors, images), len(anchors) - 1)
        mutual = (anchors[rows] == images) & (self._partner[images] == mine)
        here = self.labels[index]
        rows[here], mutual[here] = self.labels[mate], True
        cost = (
            np.delete(self._given[index], mate, axis=0).sum(axis=0)
            + np.delete(self._given[mate], index, axis=0).sum(axis=0)[rows]
            + pair_costs(self.problem, index, mate, np.arange(len(images)), rows)
        )
        return np.where(mutual, cost, np.inf)

    @cached_property
    def _given(self) -> list[Floats]:
        """For each variable (variables, R) cost of its candidates: with each of the others where it
        is, and in its own row by itself."""
        return [
            np.stack(
                [
                    variable.cost
                    if other == index
                    else pair_costs(
                        self.problem,
                        index,
                        other,
                        np.arange(len(variable.cost)),
                        np.full(len(variable.cost), label),
                    )
                    for other, label in enumerate(self.labels)
                ]
            )
            for index, variable in enumerate(self.problem.variables)
        ]

    def _neighbour(self, index: int) -> tuple[str, float]:
        """The element nearest to one, and how far it is."""
        variables = self.problem.variables
        handles = [each.handles[label] for each, label in zip(variables, self.labels, strict=True)]
        apart = {
            variables[other].name: cdist(handles[index], positions).min()
            for other, positions in enumerate(handles)
            if other != index and self.problem.together[index, other]
        }
        nearest = min(apart, key=apart.__getitem__, default="")
        return nearest, apart.get(nearest, np.inf)

    def _kept(self, choice: Choice, label: int) -> float:
        """Least arc length at the place of a label over the peak, of all controls."""
        reached = (
            (self.face.trajectories.motion_of(control), choice.sources[label, copy])
            for copy, controls in enumerate(choice.controls)
            for control in controls
        )
        return min(
            float(
                motion.arc_length[np.searchsorted(motion.points, point)] / motion.arc_length.max()
            )
            for motion, point in reached
        )
