"""Mixed-integer programs of small pairwise problems: the only place that imports highspy.

HiGHS takes no integer quadratic problems, so products are linearised (G. P. McCormick, 1976): a variable
y >= x_r + x_s - 1, y >= 0 for each pair with a cost.  After the costs were reparametrised by the dual this
is as tight as the local polytope.  Pairs that cost more than the cut-off leaves are excluded by rows
x_r + (sum of the excluded s of one variable) <= 1 instead.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from scipy.sparse import coo_matrix

from usdrigui.model import Floats
from usdrigui.solve.search import Found
from usdrigui.solve.subproblem import Part
from usdrigui.solve.watch import Watch

if TYPE_CHECKING:
    import highspy

LIMIT = 4000
"""Linearised pairs beyond which no program is made."""


def solve_part(part: Part, cut: float, watch: Watch, nodes: int, pairs: int = LIMIT) -> Found | None:
    """Best solution of the part that costs less than `cut`, or None when it has more than `pairs` products.

    The dual bound of a limited run is kept.  `cut` only excludes single pairs; HiGHS is not told of it,
    because with an objective bound its own dual bound would no longer be one of the problem.
    """
    part.settle()
    owner = part.owner
    base = part.constant + float(np.minimum.reduceat(part.costs, part.start[:-1]).sum())
    upper = np.triu(part.matrix) * (owner[:, None] < owner)
    dear = upper > cut - base
    rows, columns = np.nonzero((upper > 0) & ~dear)
    if len(rows) > pairs:
        return None
    import highspy

    program = _program(part, upper[rows, columns], _rows(part, rows, columns, dear))
    solver = highspy.Highs()  # type: ignore[no-untyped-call]
    options: dict[str, bool | int | float | str] = {
        "output_flag": False,
        "threads": 1,
        "parallel": "off",
        "random_seed": watch.settings.seed % 2**31,
        "mip_rel_gap": 0.0,
        "mip_abs_gap": 1e-9,
        "mip_max_nodes": int(nodes),
        "mip_feasibility_tolerance": 1e-9,
    }
    if np.isfinite(watch.seconds_left):
        options["time_limit"] = max(0.01, watch.seconds_left)
    for name, value in options.items():
        solver.setOptionValue(name, value)
    solver.passModel(program)
    solver.run()
    return _outcome(part, solver, cut)


def _rows(part: Part, rows: np.ndarray, columns: np.ndarray, dear: np.ndarray) -> tuple[coo_matrix, Floats, Floats]:
    """Constraint matrix and row limits: one entry per variable, McCormick rows, exclusions."""
    entries, products = len(part.costs), len(rows)
    count = len(part.variables)
    at = np.arange(products)
    excluded = [
        (i, np.flatnonzero(dear[i] & (part.owner == b))) for i in range(entries) for b in np.unique(part.owner[dear[i]])
    ]
    i = [part.owner, *(count + at for _ in range(3))]
    j = [np.arange(entries), rows, columns, entries + at]
    v = [np.ones(entries), np.ones(products), np.ones(products), -np.ones(products)]
    for number, (first, others) in enumerate(excluded):
        i.append(np.full(1 + len(others), count + products + number))
        j.append(np.append(others, first))
        v.append(np.ones(1 + len(others)))
    height = count + products + len(excluded)
    matrix = coo_matrix((np.concatenate(v), (np.concatenate(i), np.concatenate(j))), shape=(height, entries + products))
    low = np.concatenate([np.ones(count), np.full(height - count, -np.inf)])
    return matrix, low, np.ones(height)


def _program(part: Part, products: Floats, rows: tuple[coo_matrix, Floats, Floats]) -> highspy.HighsLp:
    import highspy

    matrix, low, high = rows
    sparse = matrix.tocsc()
    entries, width = len(part.costs), sparse.shape[1]
    program = highspy.HighsLp()
    program.num_col_, program.num_row_ = width, sparse.shape[0]
    program.col_cost_ = np.concatenate([part.costs, products])
    program.offset_ = part.constant
    program.col_lower_, program.col_upper_ = np.zeros(width), np.ones(width)
    program.row_lower_, program.row_upper_ = low, high
    program.a_matrix_.format_ = highspy.MatrixFormat.kColwise
    program.a_matrix_.start_ = sparse.indptr
    program.a_matrix_.index_ = sparse.indices
    program.a_matrix_.value_ = sparse.data
    program.integrality_ = [highspy.HighsVarType.kInteger] * entries + [highspy.HighsVarType.kContinuous] * (
        width - entries
    )
    return program


def _outcome(part: Part, solver: highspy.Highs, cut: float) -> Found:
    import highspy

    info, status = solver.getInfo(), solver.getModelStatus()
    if status == highspy.HighsModelStatus.kInfeasible:
        return Found(cut, np.inf, {})
    bound = float(info.mip_dual_bound)
    bound = bound - 1e-9 * (1.0 + abs(bound)) if np.isfinite(bound) else part.bounds()[0]
    values = np.array(solver.getSolution().col_value[: len(part.costs)])
    if len(values) < len(part.costs) or info.primal_solution_status != highspy.kSolutionStatusFeasible:
        return Found(min(bound, cut), np.inf, {})
    chosen = np.array(
        [low + values[low:high].argmax() for low, high in zip(part.start[:-1], part.start[1:], strict=True)]
    )
    cost = part.value(chosen)
    names = part.variables[part.owner[chosen]].tolist()
    found = dict(zip(names, part.entries[chosen].tolist(), strict=True))
    return Found(min(bound, cost, cut), cost if cost < cut else np.inf, found if cost < cut else {})
