"""The whole problem with a proof: local search, sound reduction by bounds, search on what no bound decides."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import Assignment, Indices, LayoutProblem
from usdrigui.solve.assignment import allowed_below, assignment, forbidden_price
from usdrigui.solve.blocks import Labels, all_labels, cheapest, halve, in_play, selected, whole
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.reduce import reduce
from usdrigui.solve.splitting import affordable_at_once
from usdrigui.solve.watch import Watch

HALVINGS = 6
"""The first layout is sought among the cheapest labels of 2 ** HALVINGS places of every variable."""
ROUGH_TRIES = 3
"""Attempts of large-neighbourhood search per variable among those."""
TRIES = 2
"""Attempts per variable among all labels that may be in a better layout."""


def solve_whole(problem: LayoutProblem, watch: Watch) -> Assignment:
    """Best layout over every candidate of every variable, with a lower bound (paper eq. 2-5, unreduced).

    Raises SOLVE_INFEASIBLE when no layout is allowed.
    """
    labels = all_labels(problem)
    empty = [each.name for each, best in zip(problem.variables, labels.best, strict=True) if not np.isfinite(best)]
    if empty:
        raise refuse("SOLVE_INFEASIBLE", "solve", f"no candidate and no place beside the face for {', '.join(empty)}")
    if not problem.variables:
        watch.found("local search", cost=0.0, bound=0.0)
        return assignment(problem, labels, labels.label, watch, "highs")
    forbidden = forbidden_price(problem, labels)
    watch.ceiling = allowed_below(float(labels.best.sum()), forbidden)
    watch.found("linear costs", bound=float(labels.best.sum()))
    count = len(labels.label)
    labels, incumbent = _first_layout(problem, labels, forbidden, watch)
    watch.note("local search", cost=incumbent.cost, labels=count, work=watch.work)
    residual = reduce(problem, labels, forbidden, watch, incumbent)
    watch.note(
        "blocks",
        cost=incumbent.cost,
        bound=watch.bound,
        blocks=len(residual.blocks.variable),
        labels=int(residual.blocks.sizes.sum()),
        work=watch.work,
    )
    return assignment(problem, labels, labels.label[incumbent.chosen], watch, "highs")


def _first_layout(problem: LayoutProblem, labels: Labels, forbidden: float, watch: Watch) -> tuple[Labels, Incumbent]:
    """A good layout, and the labels that a better one may use."""
    if affordable_at_once(labels, watch):
        incumbent = Incumbent(problem, labels, forbidden, watch)
        incumbent.construct()
    else:
        labels, chosen = _roughly(problem, labels, forbidden, watch)
        incumbent = Incumbent(problem, labels, forbidden, watch)
        incumbent.start_from(chosen)
    incumbent.search(TRIES * len(problem.variables))
    return labels, incumbent


def _roughly(problem: LayoutProblem, labels: Labels, forbidden: float, watch: Watch) -> tuple[Labels, Indices]:
    """The labels that a layout better than a rough one may use, and those among them that the rough one chooses.

    What a label costs against all others is dear to work out where there are many, so a layout of few labels, far
    apart, comes first: it rules out most of the others by their linear costs alone.
    """
    rough = _cheapest_places(labels)
    incumbent = Incumbent(problem, selected(labels, rough), forbidden, watch)
    incumbent.construct()
    incumbent.search(ROUGH_TRIES * len(problem.variables))
    chosen = rough[incumbent.chosen]
    wanted = np.zeros(len(labels.label), dtype=bool)
    wanted[in_play(labels, incumbent.cost)] = True
    wanted[chosen] = True
    kept = np.flatnonzero(wanted)
    return selected(labels, kept), np.searchsorted(kept, chosen)


def _cheapest_places(labels: Labels) -> Indices:
    """The cheapest labels of some places of every variable, ascending."""
    blocks = whole(labels)
    for _ in range(HALVINGS):
        blocks, _parent = halve(labels, blocks, np.ones(len(blocks.variable), dtype=bool))
    return np.sort(cheapest(labels, blocks))
