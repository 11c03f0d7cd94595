"""The whole unreduced problem handed to toulbar2, an exact solver of cost function networks (optional)."""

from __future__ import annotations

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import Assignment, LayoutProblem
from usdrigui.solve.assignment import assignment, forbidden_price
from usdrigui.solve.blocks import all_labels, block_pool, singles
from usdrigui.solve.local_search import Incumbent
from usdrigui.solve.tables import near_blocks, pair_tables
from usdrigui.solve.watch import Watch

DIGITS = 9
"""Decimals of a cost that toulbar2 keeps, at most."""
WHOLE = 15
"""Digits in all: its costs are whole numbers of 64 bits, and wrap around beyond."""
SLACK = 1e-6
"""Costs are rounded: so much is taken off its bound, more where fewer decimals are kept."""


def solve_by_toulbar2(problem: LayoutProblem, watch: Watch) -> Assignment:
    """Best layout by toulbar2.  Raises SOLVE_EXTRA without the package, SOLVE_MEMORY for too large a problem."""
    labels = all_labels(problem)
    blocks = singles(labels)
    pool = block_pool(labels, blocks)
    entries = np.diff(pool.start).astype(np.float64)
    need = 8 * (entries.sum() ** 2 - np.square(entries).sum()) * 3 / 2**20
    if need > watch.settings.memory_limit:
        raise refuse("SOLVE_MEMORY", "solve.memory_limit", f"the tables would need about {need:.0f} MiB")
    try:
        import pytoulbar2
    except ImportError as error:
        raise refuse("SOLVE_EXTRA", "solve.method", "pytoulbar2 is not installed") from error
    forbidden = forbidden_price(problem, labels)
    incumbent = Incumbent(problem, labels, forbidden, watch)
    incumbent.construct()
    tables = pair_tables(problem, pool, near_blocks(problem, pool, watch), labels.label)
    top = _top(incumbent.cost)
    spare = top - float(labels.best.sum())
    """What a layout of less than `top` can cost above the least linear costs: dearer labels and pairs count as much."""
    largest = max(abs(top), spare, float(np.abs(labels.best).sum()))
    digits = int(np.clip(WHOLE - np.ceil(np.log10(largest)), 0, DIGITS))
    network = pytoulbar2.CFN(top, digits)
    for at in range(pool.count):
        low, high = pool.start[at], pool.start[at + 1]
        network.AddVariable(f"x{at}", range(int(high - low)))
        network.AddFunction([f"x{at}"], np.minimum(pool.cost[low:high], labels.best[at] + spare).tolist())
    for table in tables:
        costs = np.zeros((int(entries[table.first]), int(entries[table.second])))
        costs[np.ix_(table.rows, table.columns)] = np.minimum(table.costs, min(forbidden, spare))
        network.AddFunction([f"x{table.first}", f"x{table.second}"], costs.ravel().tolist())
    network.Option.verbose = -1
    network.Option.showSolutions = 0
    limit = watch.seconds_left
    found = network.Solve(timeLimit=int(max(1.0, limit)) if np.isfinite(limit) else 0)
    chosen = incumbent.chosen
    if found:
        new = pool.start[:-1] + np.array(found[0][: pool.count], dtype=np.int64)
        chosen = new if found[1] < incumbent.cost else chosen
    watch.found("toulbar2", cost=incumbent.cost if not found else min(found[1], incumbent.cost))
    rounding = (pool.count + len(tables)) * 10.0**-digits
    watch.found("toulbar2", bound=float(network.GetDDualBound()) - max(SLACK, rounding))
    watch.note("toulbar2", labels=len(labels.label), tables=len(tables))
    return assignment(problem, labels, labels.label[chosen], watch, "toulbar2")


def _top(cost: float) -> float:
    """Cost from which toulbar2 need not look."""
    return cost + 1.0 if np.isfinite(cost) else 1e9
