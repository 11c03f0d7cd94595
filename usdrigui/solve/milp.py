"""The mixed-integer program of what bounds leave, solved by HiGHS.

HiGHS takes no integer quadratic problems, so pair costs are linearised.  The problem's own costs
are used, which few pairs of labels have: bounds spread them over many.  One binary x_r stands for
each label, one row for each variable, one for each clique of labels that exclude each other.  What
variables a and b cost together is one column, with a row for each label r of a that costs anything,

    w_ab >= sum_s c_rs x_s - sum_q d_rq x_q,  d_rq = max_s (c_rs - c_qs)+,

q over the labels of a, s over those of b that q does not exclude: what any q costs less than r.
These are the rows c_rs (x_r + x_s - 1) <= y_rs (G. P. McCormick, 1976) of all s, added up and
lifted: labels r and q that cost much the same cost it where each is chosen by half.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import highspy
import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import EPSILON, PlainProblem, Row, Solution

ENTRIES_PER_WORK = 16
"""Of the program, that are a unit of work each time HiGHS asks whether to go on."""
TOLERANCE = 1e-9
"""Share of a dual bound by which HiGHS's rounding may be off."""


def solve_milp(problem: PlainProblem, cutoff: float, budget: Budget) -> Solution:
    """Best layout that costs less than the cutoff, or the proof that there is none.

    Complete unless `budget` stops it; the bound of a run that is stopped holds.
    """
    base = float(problem.least.sum())
    highs = _loaded(problem, program(problem), budget.settings.seed)
    # With it nothing is searched that costs more, and no dual bound above it is one.
    highs.setOptionValue("objective_bound", cutoff - base)

    def stopped(event: highspy.HighsCallbackEvent) -> None:
        # HiGHS asks as often on every machine, and tells no iterations.
        budget.spend(highs.getNumNz() // ENTRIES_PER_WORK)
        if budget.stopped():
            event.interrupt()

    highs.cbSimplexInterrupt.subscribe(stopped)
    highs.cbMipInterrupt.subscribe(stopped)
    highs.run()
    info = highs.getInfo()
    figures = {
        "rows": highs.getNumRow(),
        "columns": highs.getNumCol(),
        "nodes": max(0, info.mip_node_count),
    }
    if highs.getModelStatus().name in {"kInfeasible", "kObjectiveBound"}:
        return Solution(cutoff, None, figures)
    chosen = None
    if info.primal_solution_status == highspy.kSolutionStatusFeasible:
        values = np.array(highs.getSolution().col_value)
        chosen = np.array([mine.start + int(values[mine].argmax()) for mine in problem.slices])
    cost = np.inf if chosen is None else problem.value(chosen)
    bound = min(base + _lowered(info.mip_dual_bound), cutoff, cost)
    return Solution(bound, chosen if cost < cutoff else None, figures)


def _lowered(value: float) -> float:
    """A dual bound less what rounding may have added."""
    return value - TOLERANCE * (1.0 + abs(value)) if np.isfinite(value) else -np.inf


def program(problem: PlainProblem) -> list[Row]:
    """The rows of the program.

    Its columns are the labels, which cost what they cost above the least of their variable, and
    then one of cost 1 for each row that names it.
    """
    names = [np.arange(mine.start, mine.stop) for mine in problem.slices]
    rows = [Row(labels, np.ones(len(labels)), 1.0, 1.0) for labels in names]
    rows += [Row(labels, np.ones(len(labels)), -np.inf, 1.0) for labels in _cliques(problem)]
    column = len(problem.linear)
    for one, other in itertools.combinations(problem.slices, 2):
        found = list(_lifted(problem, one, other, column))
        column += bool(found)
        rows += found
    return rows


def _lifted(problem: PlainProblem, one: slice, other: slice, column: int) -> Iterator[Row]:
    """The rows of what two variables cost together, which is the column: for the labels of the one
    that has fewer that cost anything."""
    costs = problem.pairs[one, other]
    costly = np.isfinite(costs) & (costs > EPSILON)
    if costly.any(axis=0).sum() < costly.any(axis=1).sum():
        one, other, costs, costly = other, one, costs.T, costly.T
    for label in np.flatnonzero(costly.any(axis=1)):
        of_label = np.where(costly[label], costs[label], 0.0)
        less = np.where(np.isfinite(costs), of_label - costs, 0.0).max(axis=1)
        less[less <= EPSILON] = 0.0
        values = np.concatenate([less, -of_label, [1.0]])
        used = np.flatnonzero(values)
        yield Row(np.r_[one, other, column][used], values[used], 0.0, np.inf)


def _loaded(problem: PlainProblem, rows: list[Row], seed: int) -> highspy.Highs:
    # Another user of this process may have run HiGHS with more threads; it refuses one then.
    highspy.Highs.resetGlobalScheduler(True)
    highs = QuietHighs()  # type: ignore[no-untyped-call]
    for name, value in _OPTIONS.items():
        highs.setOptionValue(name, value)
    highs.setOptionValue("random_seed", seed % 2**31)
    labels = len(problem.linear)
    count = 1 + max(int(row.columns[-1]) for row in rows)
    costs = np.append(problem.excess, np.ones(count - labels))
    highs.addVars(count, np.zeros(count), np.where(np.arange(count) < labels, 1.0, np.inf))
    highs.changeColsCost(count, np.arange(count, dtype=np.int32), costs)
    names, whole = np.arange(labels, dtype=np.int32), highspy.HighsVarType.kInteger
    highs.changeColsIntegrality(labels, names, np.full(labels, whole))
    for row in rows:
        columns = row.columns.astype(np.int32)
        highs.addRow(row.low, row.high, len(columns), columns, row.values)
    return highs


class QuietHighs(highspy.Highs):
    """On one thread, and without the banner that subscribing to callbacks prints."""

    def enableCallbacks(self) -> None:  # noqa: N802, D102
        self.setOptionValue("output_flag", False)
        self.setOptionValue("threads", 1)
        super().enableCallbacks()  # type: ignore[no-untyped-call]


# --- cliques --------------------------------------------------------------------------------------


def _cliques(problem: PlainProblem) -> list[Indices]:
    """Sets of labels of which a layout uses one at most, that hold all excluded pairs; grown
    greedily over several variables, cheap labels first."""
    open_ = np.isinf(problem.pairs)
    apart = open_ | (problem.owner[:, None] == problem.owner)
    np.fill_diagonal(apart, False)
    excess = problem.excess
    scale = 1.0 + float(excess.max(initial=0.0))
    found = []
    for label in np.argsort(excess, kind="stable"):
        while open_[label].any():
            found.append(_clique(int(label), apart, open_, excess / scale))
            open_[np.ix_(found[-1], found[-1])] = False
    return found


def _clique(label: int, apart: Flags, open_: Flags, excess: Floats) -> Indices:
    """A clique from a label on: next the one that excludes most members in pairs not stated."""
    members, candidates = [label], apart[label].copy()
    stated = open_[label].astype(np.float64) - excess
    while candidates.any():
        at = np.flatnonzero(candidates)
        best = int(at[stated[at].argmax()])
        members.append(best)
        candidates &= apart[best]
        stated += open_[best]
    return np.sort(np.array(members))


_OPTIONS: dict[str, bool | int | float | str] = {
    "parallel": "off",
    "mip_rel_gap": 0.0,
    "mip_abs_gap": 1e-9,
    # Without HiGHS's own heuristics it is two to three times as quick.
    "mip_heuristic_effort": 0.0,
    "mip_heuristic_run_feasibility_jump": False,
    "mip_heuristic_run_rins": False,
    "mip_heuristic_run_rens": False,
    "mip_heuristic_run_root_reduced_cost": False,
    "mip_pscost_minreliable": 1,
    "mip_allow_restart": False,
    "mip_detect_symmetry": False,
}
