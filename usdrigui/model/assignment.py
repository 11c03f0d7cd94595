"""What the solvers answer."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from usdrigui.character.record import Indices, Record

Status = Literal["optimal", "stopped"]

GAP_FLOOR = 1e-3
"""Cost below which gaps are no longer relative: a thousandth of what one element's place is worth.
Without it the gap of a problem whose best cost is zero could never close."""

_LEAST_GAP = 1e-4
"""Percent: a nearer proof is told as this near."""

PROGRAM = ("labels", "pairs", "columns", "rows", "nodes", "cutoff")
"""Figures of a solver's steps that tell of its program."""


class Assignment(Record):
    """A solution of a `LayoutProblem` with its proof."""

    labels: Indices
    """(variables,) chosen candidate of each variable; -1 is on the board."""
    cost: float
    """Of the layout by its places alone, whatever it was made from."""
    bound: float
    """Lower bound on the cost of every solution of the problem as given; -inf if none is known.
    Where the problem adds to the layout's cost what leaving earlier places costs, or counts it from
    elsewhere: of every solution to which it adds no more than to this one."""
    status: Status
    """``optimal`` when the relative gap is within the setting, up to rounding; else ``stopped``."""
    above_unary_bound: float
    """cost minus the sum over variables of their least linear cost: what the choice can change (>=
    0)."""
    method: str
    """What ran last: a solver's name, or ``bounds`` where nothing was left for one, or a limit came
    first."""
    closed_by: str
    """The method that proved the gap, or the limit that kept it from that: ``time limit``, ``work
    limit``, ``memory limit`` or ``interrupt``.  Empty where the method ended without a proof, as
    the paper's does."""
    steps: tuple[Step, ...] = ()
    penalty: float = 0.0
    """What the places of an earlier layout that were left cost; no part of `cost`."""

    @property
    def figures(self) -> tuple[tuple[str, float], ...]:
        """How large the program was and how far it came, by the last step that tells: labels,
        pairs that cost anything, columns, rows, nodes and cutoff; of several parts with the part's
        name, ``face: rows``."""
        found: dict[str, float] = {}
        for step in self.steps:
            part = "".join(step.name.rpartition(": ")[:2])
            found |= {part + name: value for name, value in step.figures if name in PROGRAM}
        return tuple(found.items())

    @property
    def gap(self) -> float:
        """(cost - bound) / |cost|; costs nearer to zero than `GAP_FLOOR` count as that."""
        return gap_of(self.cost, self.bound)


def gap_of(cost: float, bound: float) -> float:
    """How far a cost may be above the least, as `Assignment.gap`."""
    return max(0.0, cost - bound) / max(abs(cost), GAP_FLOOR)


def proven(gap: float) -> str:
    """How a gap is told to people: ``proven within 0.009 %``."""
    return f"proven within {max(100.0 * gap, _LEAST_GAP):.2g} %" if gap < np.inf else "not proven"


@dataclass(frozen=True, slots=True)
class Step:
    """Statistics of one step of a solver, for the report."""

    name: str
    figures: tuple[tuple[str, float], ...]
    """Ordered (what, number) pairs; never times."""
    seconds: float
    """For people; never part of an output that must be reproducible."""
