"""Dual bounds and the search on random pairwise tables, against the product of all entries."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest

from usdrigui.settings import SolveSettings
from usdrigui.solve import highs, search, sweeps
from usdrigui.solve.bounds import Dual
from usdrigui.solve.groups import decode, group_gains
from usdrigui.solve.polish import polished
from usdrigui.solve.search import Search
from usdrigui.solve.subproblem import Part, whole_part
from usdrigui.solve.tables import Table
from usdrigui.solve.watch import Watch

Problem = tuple[list[np.ndarray], list[Table]]


def random_tables(seed: int, variables: int = 5, entries: int = 5) -> Problem:
    """Costs and sparse tables, with zeros, ties and forbidden pairs."""
    generator = np.random.default_rng(seed)
    count = int(generator.integers(1, variables + 1))
    unary = [np.round(generator.uniform(-1, 0, int(generator.integers(1, entries + 1))), 1) for _ in range(count)]
    tables = []
    for a, b in itertools.combinations(range(count), 2):
        if generator.random() < 0.8:
            rows = np.flatnonzero(generator.random(len(unary[a])) < 0.8)
            columns = np.flatnonzero(generator.random(len(unary[b])) < 0.8)
            costs = np.maximum(np.round(generator.uniform(-0.5, 1, (len(rows), len(columns))), 1), 0.0)
            costs[generator.random(costs.shape) < 0.1] = np.inf
            if costs.size:
                tables.append(Table(a, b, rows, columns, costs))
    return unary, tables


def every_cost(problem: Problem, forbidden: float) -> np.ndarray:
    """Cost of every combination of entries, one axis per variable."""
    unary, tables = problem
    total = np.zeros([len(each) for each in unary])
    for at, each in enumerate(unary):
        total += each.reshape([-1 if k == at else 1 for k in range(len(unary))])
    for table in tables:
        dense = np.zeros((len(unary[table.first]), len(unary[table.second])))
        dense[np.ix_(table.rows, table.columns)] = np.minimum(table.costs, forbidden)
        shape = [each.size if k in (table.first, table.second) else 1 for k, each in enumerate(unary)]
        total += dense.reshape(shape)
    return total


def least_with(costs: np.ndarray, axis: int) -> np.ndarray:
    return costs.min(axis=tuple(k for k in range(costs.ndim) if k != axis))


def watch() -> Watch:
    return Watch(SolveSettings(work_limit=10**9))


@pytest.mark.parametrize("part", range(4))
def test_dual_never_exceeds_what_it_bounds(part: int) -> None:
    for seed in range(300 * part, 300 * part + 300):
        problem = random_tables(seed)
        costs = every_cost(problem, 20.0)
        dual = Dual(*problem, 20.0)
        last = -np.inf
        for _ in range(3):
            bound, excess = dual.parts()
            assert last - 1e-9 <= bound <= costs.min() + 1e-9
            for at, each in enumerate(excess):
                assert (bound + each <= least_with(costs, at) + 1e-9).all()
            last = bound
            dual.sweep()


def gathered_and_plain(problem: Problem, times: int) -> tuple[Dual, Dual]:
    """A dual swept as gathered tables, and one swept table by table."""
    gathered, plain = Dual(*problem, 20.0), Dual(*problem, 20.0)
    sweeps.swept(gathered, times)
    for _ in range(times):
        plain.sweep()
    return gathered, plain


def test_gathered_sweeps_are_sweeps() -> None:
    for seed in range(300):
        gathered, plain = gathered_and_plain(random_tables(seed), 6)
        assert gathered.bound() == pytest.approx(plain.bound(), abs=2e-4)  # ties broken by rounding part their ways
        for mine, theirs in zip(gathered.theta, plain.theta, strict=True):
            assert np.isfinite(mine).all()
            assert np.isfinite(theirs).all()


def test_gathered_sweeps_bound_what_they_bounded() -> None:
    for seed in range(300):
        problem = random_tables(seed)
        costs = every_cost(problem, 20.0)
        gathered, _ = gathered_and_plain(problem, 6)
        bound, excess = gathered.parts()
        assert bound <= costs.min() + 1e-9
        for at, each in enumerate(excess):
            assert (bound + each <= least_with(costs, at) + 1e-9).all()


def test_gathered_sweeps_that_forget_entries_outside_the_tables_are_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = sweeps.Sweeps._visit_of

    def forgetful(self: object, variable: int, ahead: list[object]) -> object:
        visit = honest(self, variable, ahead)
        return replace(visit, unused=np.zeros_like(visit.unused))

    monkeypatch.setattr(sweeps.Sweeps, "_visit_of", forgetful)
    with pytest.raises(AssertionError):
        test_gathered_sweeps_are_sweeps()


def test_gathered_sweeps_tell_their_bound() -> None:
    for seed in range(300):
        dual = Dual(*random_tables(seed), 20.0)
        gathered = sweeps.Sweeps(dual, 6)
        gathered.go(6)
        told = gathered.bound()
        gathered.hand_over()
        assert told == pytest.approx(dual.bound(), abs=1e-4)


def test_dual_is_exact_on_trees() -> None:
    for seed in range(200):
        unary, tables = random_tables(seed)
        chain = [each for each in tables if each.second == each.first + 1]
        dual = Dual(unary, chain, 20.0)
        for _ in range(4):
            dual.sweep()
        assert dual.bound() == pytest.approx(every_cost((unary, chain), 20.0).min())


@pytest.mark.parametrize("part", range(4))
def test_search_finds_the_least(part: int) -> None:
    for seed in range(400 * part, 400 * part + 400):
        problem = random_tables(seed)
        costs = every_cost(problem, 20.0)
        found = Search(watch(), 10**6).solve(whole_part(*problem, 20.0), np.inf)
        assert found.cost == pytest.approx(costs.min())
        assert found.bound == pytest.approx(costs.min())
        assert costs[tuple(found.chosen[at] for at in range(costs.ndim))] == pytest.approx(costs.min())


def test_search_below_a_cut_finds_nothing_above_it() -> None:
    for seed in range(300):
        problem = random_tables(seed)
        least = every_cost(problem, 20.0).min()
        found = Search(watch(), 10**6).solve(whole_part(*problem, 20.0), least - 0.05)
        assert found.cost == np.inf
        assert least + 1e-9 >= found.bound >= least - 0.05 - 1e-9


def test_limited_search_keeps_an_honest_bound() -> None:
    for seed in range(80):
        problem = random_tables(seed, variables=6)
        least = every_cost(problem, 20.0).min()
        for nodes in (1, 3, 6):
            found = Search(watch(), nodes).solve(whole_part(*problem, 20.0), least + 1.0)
            assert found.bound <= least + 1e-9
            deep = Search(watch(), nodes).deepen(whole_part(*problem, 20.0), least + 1.0, 0.3)
            assert deep.bound <= least + 1e-9
            assert deep.cost >= least - 1e-9


def test_a_search_without_memory_leaves_nodes_open(monkeypatch: pytest.MonkeyPatch) -> None:
    bounds = []
    for room in (0, 2000, 10**9):
        monkeypatch.setattr(search, "HELD_BYTES", room)
        found = [Search(watch(), 10**6).solve(whole_part(*random_tables(seed), 20.0), np.inf) for seed in range(80)]
        bounds.append([each.bound for each in found])
    least = [every_cost(random_tables(seed), 20.0).min() for seed in range(80)]
    assert all((np.array(each) <= np.array(least) + 1e-9).all() for each in bounds)
    assert bounds[2] == pytest.approx(least)
    assert sum(bounds[0]) < sum(bounds[1]) < sum(bounds[2])


def test_groups_never_exceed_the_least() -> None:
    raised = 0
    for seed in range(150):
        problem = random_tables(seed, variables=6)
        costs = every_cost(problem, 20.0)
        dual = Dual(*problem, 20.0)
        dual.sweep()
        bound = dual.bound()
        chosen, value = decode(dual, 0)
        assert value == pytest.approx(costs[tuple(chosen)])
        for most in (2, 3, 6):
            found = group_gains(dual, bound, chosen, value, watch(), 1000, most)
            total = bound + found.gain.sum()
            assert total <= costs.min() + 1e-7
            raised += total > bound + 1e-6
            _, excess = dual.parts(found.member)
            for at, each in enumerate(excess):
                own = found.gain[found.member[at]] if found.member[at] >= 0 else 0.0
                assert (total - own + each <= least_with(costs, at) + 1e-7).all()
    assert raised > 20


def test_parts_keep_their_costs() -> None:
    """Sweeping, settling, picking, folding: whatever is done to a part, solutions cost what they did."""
    for seed in range(200):
        problem = random_tables(seed)
        costs = every_cost(problem, 20.0)
        part = whole_part(*problem, 20.0)
        part.settle()
        part.sweep()
        generator = np.random.default_rng(seed)
        entries = np.array([generator.integers(size) for size in part.sizes])
        assert part.value(part.start[:-1] + entries) == pytest.approx(costs[tuple(entries)])
        at = int(generator.integers(len(part.sizes)))
        entry = int(part.start[at] + entries[at])
        rest = part.restricted((part.owner != at) | (np.arange(len(part.costs)) == entry))
        kept = [int(variable) for variable in rest.variables]
        assert at in rest.taken
        assert sorted([*kept, *rest.taken]) == list(range(costs.ndim))
        assert all(entries[variable] == taken for variable, taken in rest.taken.items())
        assert rest.value(rest.start[:-1] + entries[kept]) == pytest.approx(costs[tuple(entries)])


def test_polishing_finds_good_solutions() -> None:
    """Never below the least, mostly the least itself, and the same twice."""
    hits = 0
    for seed in range(60):
        problem = random_tables(seed, variables=6, entries=6)
        costs = every_cost(problem, 20.0)
        part = whole_part(*problem, 20.0)
        chosen, cost = polished(part, 0)
        assert cost == pytest.approx(costs[tuple(part.entries[chosen])])
        assert cost >= costs.min() - 1e-9
        assert (polished(part, 0)[0] == chosen).all()
        hits += cost < costs.min() + 1e-9
    assert hits >= 55


def test_program_agrees_with_the_search() -> None:
    for seed in range(60):
        problem = random_tables(seed)
        least = every_cost(problem, 20.0).min()
        found = highs.solve_part(whole_part(*problem, 20.0), least + 0.5, watch(), 1000)
        assert found is not None
        assert found.cost == pytest.approx(least)
        assert found.bound <= least + 1e-9
        below = highs.solve_part(whole_part(*problem, 20.0), least - 0.05, watch(), 1000)
        assert below is not None
        assert below.cost == np.inf
        assert below.bound <= least - 0.05 + 1e-9


def test_program_refuses_what_is_too_large() -> None:
    problem = random_tables(3, variables=5)
    assert highs.solve_part(whole_part(*problem, 20.0), 1.0, watch(), 10, pairs=1) is None


def test_part_of_nothing() -> None:
    empty = Part(np.arange(0), np.arange(0), np.arange(0), np.empty(0), np.empty((0, 0)))
    found = Search(watch(), 10).solve(empty, 1.0)
    assert (found.cost, found.bound, found.chosen) == (0.0, 0.0, {})
