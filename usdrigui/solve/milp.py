"""The mixed-integer program of a reduced problem, solved by HiGHS: the only place that imports
highspy.

HiGHS takes no integer quadratic problems, so pair costs are linearised: one column w_ab >= 0 for
each two variables that interact, instead of one for each product.  For any label r of a the row

    w_ab >= sum_s c_rs x_s - sum_r' d_rr' x_r',    d_rr' = max_s (c_rs - c_r's)+,

holds whichever label of a is chosen and is tight for r: the rows x_r + x_s - 1 <= y_rs (G. P.
McCormick, 1976) added up and lifted.  Triplets have the same for their third-order costs.  Of these
rows only those that a solution violates are added; what is excluded is stated by cliques of labels.
Every program relaxes the problem, so its dual bound is one of the problem, and a solution that
violates no row is optimal.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import EPSILON, ReducedProblem, Solution

if TYPE_CHECKING:
    import highspy

VIOLATED = 1e-6
"""Least violation of a row that is added."""
CALL = 8
"""Entries of the program that are a unit of work for each of HiGHS's calls."""

Row = tuple[Indices, Floats]


def solve_milp(problem: ReducedProblem, cutoff: float, budget: Budget, most: int) -> Solution:
    """Best layout of a reduced problem that costs less than the cutoff, or the proof that there is
    none.

    Complete unless `budget` stops it, or `most` work is done in all; the bound of a run that is
    stopped holds.
    """
    return _Program(problem, cutoff, budget, most).solved()


class _Program:
    """A program that grows by the rows that its solutions violate."""

    def __init__(self, problem: ReducedProblem, cutoff: float, budget: Budget, most: int) -> None:
        import highspy

        self._most = most
        self._problem, self._cutoff, self._budget = problem, cutoff, budget
        self._base = problem.bound()
        self._tables = _together(problem)
        """What two or three variables cost together; each has a column."""
        self._highs = highspy.Highs()  # type: ignore[no-untyped-call]
        self._highs.cbSimplexInterrupt.subscribe(self._interrupt_simplex)
        self._highs.cbMipInterrupt.subscribe(self._interrupt)
        self._rows = 0
        self._stated: set[bytes] = set()
        """Rows added since the first: HiGHS's tolerances let a solution violate them a little."""
        self._nodes = 0
        self._bound = self._base
        self._best: tuple[float, Indices | None] = (np.inf, None)
        self._state()

    def _state(self) -> None:
        """Columns, one label per variable, cliques of excluded pairs."""
        problem, count = self._problem, len(self._problem.costs)
        self._budget.spend(count**2 // 16)
        for name, value in _OPTIONS.items():
            self._highs.setOptionValue(name, value)
        self._highs.setOptionValue("random_seed", self._budget.settings.seed % 2**31)
        costs = np.concatenate([problem.excess(), np.ones(len(self._tables))])
        most = np.where(np.arange(len(costs)) < count, 1.0, np.inf)
        self._highs.addVars(len(costs), np.zeros(len(costs)), most)
        self._highs.changeColsCost(len(costs), np.arange(len(costs), dtype=np.int32), costs)
        groups = [np.arange(each.start, each.stop) for each in problem.slices]
        self._add([(each, np.ones(len(each))) for each in groups], 1.0, 1.0)
        self._add([(each, np.ones(len(each))) for each in _cliques(problem)], -np.inf, 1.0)

    def solved(self) -> Solution:
        """Linear programs, then such with whole labels, until nothing is violated or a limit is
        reached."""
        import highspy

        more, labels = self._refined(whole=False), len(self._problem.costs)
        lp_bound = self._bound
        if more:
            kinds = np.full(labels, highspy.HighsVarType.kInteger)
            self._highs.changeColsIntegrality(labels, np.arange(labels, dtype=np.int32), kinds)
            self._refined(whole=True)
        figures: dict[str, float] = {
            "columns": labels + len(self._tables),
            "rows": self._rows,
            "lp_bound": lp_bound,
            "nodes": self._nodes,
        }
        return Solution(min(self._bound, self._limit), self._best[1], figures)

    def _refined(self, *, whole: bool) -> bool:
        """Solve the program with the rows that its solution violates, again and again; whether one
        violates none.  Of whole labels that one is optimal."""
        while self._run(whole):
            if not self._grown():
                return True
        return False

    def _run(self, whole: bool) -> bool:
        """Solve the program and raise the bound; whether its solution leaves anything open."""
        import highspy

        self._highs.setOptionValue("objective_bound", self._limit - self._base)
        self._highs.run()
        info, status = self._highs.getInfo(), self._highs.getModelStatus().name
        self._nodes += max(0, int(info.mip_node_count))
        if not whole:
            self._budget.spend(1000 + max(0, int(info.simplex_iteration_count)) * self._rows // 4)
        if status in {"kInfeasible", "kObjectiveBound"}:
            self._raise(self._limit)
            return False
        if not whole and status != "kOptimal":
            return False  # The value of a linear program that is not solved bounds nothing.
        self._raise(self._lowered(info.mip_dual_bound if whole else info.objective_function_value))
        if info.primal_solution_status != highspy.kSolutionStatusFeasible:
            return False
        self._improve()
        return self._bound < self._limit and not self._stopped()

    def _interrupt_simplex(self, event: highspy.HighsCallbackEvent) -> None:
        """End a linear program at a limit of the run; its iterations count when it is done."""
        if self._budget.stopped():
            event.interrupt()

    def _interrupt(self, event: highspy.HighsCallbackEvent) -> None:
        """End a run at a limit.  HiGHS asks as often on every machine and tells no iterations, so
        each call counts as some.  The dual bound that it tells may be above the optimum."""
        self._budget.spend(self._highs.getNumNz() // CALL)
        if self._stopped():
            event.interrupt()

    def _stopped(self) -> bool:
        """Whether this program's share of the work is done, or the run ends."""
        return self._budget.work >= self._most or self._budget.stopped()

    @property
    def _limit(self) -> float:
        """Layouts that cost at least this are of no interest."""
        return min(self._cutoff, self._best[0])

    def _lowered(self, value: float) -> float:
        """A bound of the program as one of the problem, less what rounding may have added."""
        return self._base + value - 1e-9 * (1.0 + abs(value)) if np.isfinite(value) else -np.inf

    def _raise(self, bound: float) -> None:
        self._bound = max(self._bound, min(bound, self._limit))
        self._budget.found("highs", bound=self._bound)

    def _improve(self) -> None:
        """Remember the layout of a solution if its true cost is the least so far."""
        values, slices = self._values(), self._problem.slices
        chosen = np.array([each.start + int(values[each].argmax()) for each in slices])
        cost = self._problem.value(chosen)
        if cost < self._limit:
            self._best = (cost, chosen)

    def _values(self) -> Floats:
        return np.array(self._highs.getSolution().col_value)

    # --- rows -------------------------------------------------------------------------------------

    def _grown(self) -> bool:
        """Add the rows for the likeliest labels of all variables of a table but one, in every way,
        that the solution violates and that are not stated yet; whether any."""
        values, new = self._values(), {}
        for column, (ends, costs) in enumerate(self._tables, len(self._problem.costs)):
            for at, last in enumerate(ends):
                order = (*ends[:at], *ends[at + 1 :], last)
                labels = [self._problem.slices[each] for each in order]
                columns, row = _row(column, labels, np.moveaxis(costs, at, -1), values)
                key = columns.tobytes() + row.tobytes()
                if row @ values[columns] < -VIOLATED and key not in self._stated:
                    new[key] = columns, row
        self._add(list(new.values()), 0.0, np.inf)
        self._stated |= new.keys()
        return bool(new)

    def _add(self, rows: Sequence[Row], low: float, high: float) -> None:
        for columns, values in rows:
            self._highs.addRow(low, high, len(columns), columns.astype(np.int32), values)
        self._rows += len(rows)


def _row(column: int, labels: list[slice], costs: Floats, values: Floats) -> Row:
    """The row for one label of each variable but the last, lifted to all of their labels one
    variable after the other.  A pair that is excluded may have any cost, and needs no lift."""
    likely = tuple(int(values[each].argmax()) for each in labels[:-1])
    own = np.where(np.isfinite(costs[likely]), costs[likely], 0.0)
    parts, most = [(labels[-1], -own)], own
    for depth in reversed(range(len(likely))):
        over = most - costs[likely[:depth]]
        lift = np.maximum(over.reshape(len(over), -1).max(axis=1), 0.0)
        parts.append((labels[depth], lift))
        most = most - lift.reshape(-1, *(1,) * most.ndim)
    columns = np.concatenate([np.arange(each.start, each.stop) for each, _ in parts])
    coefficients = np.concatenate([each for _, each in parts])
    used = np.abs(coefficients) > EPSILON
    return np.append(columns[used], column), np.append(coefficients[used], 1.0)


def _together(problem: ReducedProblem) -> list[tuple[tuple[int, ...], Floats]]:
    """The pairs of variables with a finite cost above 0, the triplets, and their costs."""
    pairs = [
        (ends, problem.table(*ends)) for ends in itertools.combinations(range(problem.count), 2)
    ]
    used = [((costs > EPSILON) & (costs < np.inf)).any() for _, costs in pairs]
    triplets = [(each, problem.triplet_costs(each)) for each in problem.messages]
    return [*itertools.compress(pairs, used), *triplets]


def _cliques(problem: ReducedProblem) -> list[Indices]:
    """Sets of labels of which a layout uses one at most, that hold all excluded pairs; grown
    greedily over several variables, cheap labels first."""
    open_ = np.isinf(problem.both_ways())
    apart = open_ | (problem.owner[:, None] == problem.owner)
    np.fill_diagonal(apart, False)
    excess = problem.excess()
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
    "output_flag": False,
    "threads": 1,
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
