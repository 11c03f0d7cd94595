"""Prices on crowded spots: a solution never costs more with them, bounds hold, and faults are caught."""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from layout_problems import crowd

from usdrigui.model import LayoutProblem
from usdrigui.settings import SolveSettings
from usdrigui.solve import cells, crowding, pricing, residual_search, solve, splitting, spots
from usdrigui.solve.ascent import Ascent
from usdrigui.solve.assignment import forbidden_price
from usdrigui.solve.blocks import all_labels, block_pool, singles
from usdrigui.solve.bounds import Dual
from usdrigui.solve.cells import Cells, Costs, cells_of, flags, inherited, members, no_cells
from usdrigui.solve.crowding import tightened
from usdrigui.solve.groups import decode
from usdrigui.solve.spots import places
from usdrigui.solve.tables import near_blocks, pair_tables
from usdrigui.solve.watch import Watch


def costs_of(problem: LayoutProblem) -> Costs:
    labels = all_labels(problem)
    pool = block_pool(labels, singles(labels))
    near = near_blocks(problem, pool, Watch(SolveSettings()))
    return Costs(
        pool, pool.cost, tuple(pair_tables(problem, pool, near, labels.label)), forbidden_price(problem, labels)
    )


def every_cost(dual: Dual) -> np.ndarray:
    """Cost of every solution, in order of the product of the entries."""
    solutions = itertools.product(*(range(len(each)) for each in dual.unary))
    return np.array([dual.cost(np.array(each)) for each in solutions])


def random_cells(costs: Costs, generator: np.random.Generator) -> Cells:
    size = len(costs.pool.cost)
    sets = [np.flatnonzero(generator.random(size) < generator.uniform(0.1, 0.9)) for _ in range(4)]
    return cells_of(sets, generator.integers(1, 4, 4), generator.uniform(0, 0.5, 4))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(st.integers(0, 10**6), st.integers(0, 10**6))
def test_no_solution_costs_more_with_prices(seed: int, other: int) -> None:
    costs = costs_of(crowd(seed, variables=4, candidates=4))
    with_prices = costs.dual(random_cells(costs, np.random.default_rng(other)))
    assert (every_cost(with_prices) <= every_cost(costs.dual(no_cells())) + 1e-9).all()


@settings(max_examples=30, deadline=None, derandomize=True)
@given(st.integers(0, 10**6), st.integers(0, 10**6))
def test_bound_and_excess_hold_for_the_true_costs(seed: int, other: int) -> None:
    costs = costs_of(crowd(seed, variables=4, candidates=4))
    true = every_cost(costs.dual(no_cells())).reshape([len(each) for each in costs.dual(no_cells()).unary])
    dual = costs.dual(random_cells(costs, np.random.default_rng(other)))
    for _ in range(3):
        bound, excess = dual.parts()
        assert bound <= true.min() + 1e-9
        for at, each in enumerate(excess):
            least = true.min(axis=tuple(k for k in range(true.ndim) if k != at))
            assert (bound + each <= least + 1e-9).all()
        dual.sweep()


def overcharged() -> int:
    """Solutions that cost more with prices than without, over a few problems."""
    found = 0
    for seed in range(5):
        costs = costs_of(crowd(seed, variables=4, candidates=4))
        with_prices = costs.dual(random_cells(costs, np.random.default_rng(seed)))
        found += int((every_cost(with_prices) > every_cost(costs.dual(no_cells())) + 1e-9).sum())
    return found


def test_a_count_off_by_one_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    assert overcharged() == 0
    wrong = property(lambda self: -float((self.price * self.count * (self.count - 1) / 2).sum()))
    monkeypatch.setattr(Cells, "constant", wrong)
    assert overcharged() > 0


def test_a_forgotten_rebate_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cells, "_rebates", lambda *_: [])
    assert overcharged() > 0


@pytest.mark.parametrize("seed", range(4))
def test_prices_raise_the_bound_of_a_crowd(seed: int) -> None:
    problem = crowd(seed, variables=5, candidates=24)
    optimum = solve(problem, SolveSettings()).cost
    costs = costs_of(problem)
    dual = costs.dual(no_cells())
    for _ in range(30):
        dual.sweep()
    before = dual.bound()
    where = places(costs.pool, problem.overlap.radius)
    good = costs.pool.start[:-1] + decode(dual, 0)[0]
    better, prices = tightened(costs, where, dual, no_cells(), good, optimum, Watch(SolveSettings()))
    assert better.bound() <= optimum + 1e-9
    assert better.bound() > before + 0.3 * (optimum - before)
    assert len(prices.count) > 0
    again, _ = tightened(costs, where, dual, no_cells(), good, optimum, Watch(SolveSettings()))
    assert again.bound() == better.bound()


def priced_ascent(seed: int) -> Ascent:
    """Entries of a crowd in play, at prices of random cells of which some came later and some were dropped."""
    costs, generator = costs_of(crowd(seed, variables=5, candidates=12)), np.random.default_rng(seed)
    first, later = random_cells(costs, generator), random_cells(costs, generator)
    ascent = Ascent(costs, costs.dual(no_cells()), first, np.inf)
    ascent.play(np.flatnonzero(generator.random(len(costs.pool.cost)) < 0.7))
    ascent.extend(flags(later, np.arange(len(costs.pool.cost)), len(costs.pool.cost)), later.count)
    ascent._change(generator.uniform(0, 0.5, len(ascent.price)) * (generator.random(len(ascent.price)) < 0.7))
    ascent.drop(0.0)
    ascent.sweep(0.05)
    return ascent


def test_pairs_in_cells_cost_less_by_their_prices() -> None:
    for seed in range(20):
        ascent = priced_ascent(seed)
        member = ascent.member[:, ascent.chosen].astype(np.float64)
        rebate = np.einsum("ci,cj,c->ij", member, member, ascent.price)
        apart = ascent.variable[:, None] != ascent.variable
        costs = ascent.across[:, ascent.chosen] - rebate
        assert np.allclose(ascent.pairs[apart], costs[apart], atol=1e-5)


def test_shares_of_pairs_in_cells_are_those_of_all_pairs() -> None:
    for seed in range(20):
        ascent = priced_ascent(seed)
        share, pairs = ascent.shares(0.05)
        soft, alone = ascent._entry_shares(0.05)
        member = ascent.member[:, ascent.chosen].astype(np.float64)
        both = ascent._held.cells @ ascent._held_shares(soft, 0.05)
        assert np.array_equal(share, alone)
        assert both.sum() > 0
        assert np.allclose(both, np.einsum("ci,cj,ij->c", member, member, pairs), atol=1e-4)


def test_shares_too_thin_to_crowd_anything_get_no_prices(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(spots, "SUPPORT", 1.5)
    problem = crowd(1, variables=5, candidates=24)
    costs = costs_of(problem)
    dual, good = costs.dual(no_cells()), costs.pool.start[:-1]
    _, prices = tightened(costs, places(costs.pool, 3.0), dual, no_cells(), good, 0.0, Watch(SolveSettings()))
    assert len(prices.count) == 0


def test_cells_are_inherited_by_the_parts_of_their_entries() -> None:
    old = cells_of([np.array([0, 2]), np.array([1]), np.array([2, 3])], [1, 2, 1], [0.5, 0.25, 0.0])
    new = inherited(old, np.array([0, 0, 2, 3, 3]))
    assert [each.tolist() for each in members(new)] == [[0, 1, 2]]
    assert (new.count.tolist(), new.price.tolist()) == ([1.0], [0.5])


@pytest.mark.parametrize("blocks", [True, False])
def test_stopped_ascent_keeps_an_honest_bound(blocks: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    problem = crowd(2, variables=5, candidates=50)
    optimum = solve(problem, SolveSettings()).cost
    if blocks:
        monkeypatch.setattr(splitting, "ONE_BY_ONE", 0)
    for limit in (30_000, 100_000, 300_000):
        found = solve(problem, replace(SolveSettings(), work_limit=limit))
        assert found.bound <= optimum + 1e-9


def test_every_variable_is_in_play_however_many_there_are(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crowding, "IN_PLAY", 8)
    monkeypatch.setattr(splitting, "FEW_LABELS", 0)
    monkeypatch.setattr(residual_search, "LARGEST", 20)
    problem = crowd(3, variables=6, candidates=25)
    looked: list[int] = []
    plain = crowding.tightened
    monkeypatch.setattr(pricing, "tightened", lambda *given: (looked.append(1), plain(*given))[1])
    found = solve(problem, SolveSettings(gap=1e-6))
    assert looked
    monkeypatch.undo()
    assert found.cost == pytest.approx(solve(problem, SolveSettings(gap=1e-6)).cost, rel=2e-6)
