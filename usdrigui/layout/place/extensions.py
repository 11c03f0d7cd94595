"""Terms of other packages: entry points of the group ``usdrigui.terms``.

An entry point loads an object with one or both of two methods (docs/internals/terms.md has a worked
example):

* ``linear(face, motion, points) -> (p,)`` costs >= 0 of anchoring the motion's control at `points`;
* ``pairs(face, problem, choices) -> iterable of ExtraPairs`` with costs >= 0.

`face` is a `usdrigui.layout.face.Face`: the rig, its trajectories, symmetry, views and handle
width.

Installed terms act only when ``objective.terms`` names them, so that a layout never depends on what
else happens to be installed.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.errors import Faults, refuse
from usdrigui.layout.face import Face
from usdrigui.model import Choice, ExtraPairs, LayoutProblem, Motion

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

GROUP = "usdrigui.terms"


def user_linear_cost(face: Face, motion: Motion, points: Indices, names: tuple[str, ...]) -> Floats:
    """(p,) sum of the linear costs of the terms called `names`; raises TERM_INVALID for a wrong
    answer."""
    cost = np.zeros(len(points))
    for name in names:
        term = _loaded(name)
        if hasattr(term, "linear"):
            cost += _checked(name, term.linear(face, motion, points), len(points))
    return cost


def user_pairs(
    face: Face, problem: LayoutProblem, choices: tuple[Choice, ...], names: tuple[str, ...]
) -> tuple[ExtraPairs, ...]:
    """Explicit pair costs of the terms called `names`; raises TERM_INVALID for a wrong answer."""
    found: list[ExtraPairs] = []
    for name in names:
        term = _loaded(name)
        if hasattr(term, "pairs"):
            found.extend(_checked_pairs(name, term.pairs(face, problem, choices), problem))
    return tuple(found)


def check_terms(names: Iterable[str]) -> None:
    """Raise CONFIG_VALUE for all names that no installed package has a term of."""
    faults = Faults()
    for name in names:
        with faults.collected():
            _entry(name)
    faults.raise_all()


def _loaded(name: str) -> Any:
    return _entry(name).load()


def _entry(name: str) -> EntryPoint:
    from importlib.metadata import entry_points

    for entry in entry_points(group=GROUP):
        if entry.name == name:
            return entry
    installed = sorted(entry.name for entry in entry_points(group=GROUP))
    raise refuse(
        "CONFIG_VALUE",
        "objective.terms",
        f"no installed package has a term {name!r}; there are {installed}",
    )


def _checked(name: str, answer: Any, count: int) -> Floats:
    cost = np.asarray(answer, dtype=np.float64)
    if cost.shape != (count,) or not np.isfinite(cost).all() or (cost < 0.0).any():
        raise refuse(
            "TERM_INVALID",
            name,
            f"a linear term must give {count} finite costs >= 0, not {cost.shape}",
        )
    return cost


def _checked_pairs(
    name: str, answer: Iterable[ExtraPairs], problem: LayoutProblem
) -> list[ExtraPairs]:
    pairs = list(answer)
    sizes = [len(variable.points) for variable in problem.variables]
    for each in pairs:
        if not (
            0 <= each.first < each.second < len(sizes)
            and _within(each.first_labels, sizes[each.first])
            and _within(each.second_labels, sizes[each.second])
        ):
            what = "pair terms need first < second and labels that exist"
            raise refuse("TERM_INVALID", name, what)
        _checked(name, each.costs, len(each.first_labels))
    return pairs


def _within(labels: Indices, size: int) -> bool:
    return bool(((labels >= 0) & (labels < size)).all())
