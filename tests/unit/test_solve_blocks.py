"""Distances of elements, blocks of candidates, and what is left out before any search."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from enumeration import total_costs
from layout_problems import crowd, random_problem

from usdrigui.model import ExtraPairs, LayoutProblem, MeanOverlap
from usdrigui.overlap import Drawn, pair_costs
from usdrigui.settings import SolveSettings
from usdrigui.solve.budget import Budget
from usdrigui.solve.label_geometry import LabelGeometry, LabelSet, all_labels, pair_bounds
from usdrigui.solve.pair_costs import near_blocks, pair_costs as costs_of_pairs, refined
from usdrigui.solve.partition import Blocks, bisect, block_set, blocks_of_variables, cheapest, thinned


def usable(problem: LayoutProblem) -> bool:
    return bool(np.diff(all_labels(problem).start).all())


@cache
def problems() -> tuple[LayoutProblem, ...]:
    drawn = [random_problem(seed) for seed in range(60)] + [crowd(seed, 4, 12) for seed in range(5)]
    drawn += [replace(each, overlap=MeanOverlap(5.0, 0.2, 20.0, 0.6, 0.15), separation=0.1) for each in drawn[-5:]]
    return tuple(each for each in drawn if usable(each))


def budget() -> Budget:
    return Budget(SolveSettings())


def parts(labels: LabelSet, times: int) -> Blocks:
    """Blocks of whole variables, halved so often."""
    found = blocks_of_variables(labels)
    for _ in range(times):
        found, _parent = bisect(labels, found, np.ones(len(found.variable), dtype=bool))
    return found


def test_an_explicit_cost_of_the_very_first_label_counts() -> None:
    problem = replace(
        crowd(0, variables=2, candidates=3), extra=(ExtraPairs(0, 1, *np.array([[0], [2]]), np.array([7.0])),)
    )
    labels = all_labels(problem)
    (other,) = np.flatnonzero((labels.variable == 1) & (labels.candidate == 2))
    assert costs_of_pairs(problem, labels)[0, other] == 7.0


def pairs_wrong(problem: LayoutProblem, times: int) -> int:
    """How many pairs of members cost less than their blocks do, or anything at all where blocks were passed over."""
    labels = all_labels(problem)
    found = parts(labels, times)
    label_set = block_set(labels, found)
    costs = np.zeros((len(found.variable), len(found.variable)))
    known = np.zeros(costs.shape, dtype=bool)
    for pairs in near_blocks(problem, label_set, budget()):
        np.add.at(costs, (pairs.first, pairs.second), pairs.costs)
        known[pairs.first, pairs.second] = True
    every, wrong = costs_of_labels(problem), 0
    for a, b in itertools.combinations(range(len(found.variable)), 2):
        one, other = (found.members[found.start[at] : found.start[at + 1]] for at in (a, b))
        if found.variable[a] == found.variable[b]:
            continue
        true = every[np.ix_(one, other)]
        wrong += int((true < costs[a, b] - 1e-9).sum()) if known[a, b] else int((true > 0).sum())
    return wrong


@cache
def costs_of_labels(problem: LayoutProblem) -> np.ndarray:
    """(labels, labels) what two labels of different variables cost together."""
    labels = all_labels(problem)
    every = np.zeros((len(labels.cost), len(labels.cost)))
    for a, b in itertools.combinations(range(len(problem.variables)), 2):
        one, other = (np.arange(labels.start[at], labels.start[at + 1]) for at in (a, b))
        i, j = (each.ravel() for each in np.meshgrid(one, other))
        every[i, j] = pair_costs(problem, a, b, labels.candidate[i], labels.candidate[j])
    return every + every.T


@pytest.mark.parametrize("times", [0, 1, 2, 9])
def test_blocks_cost_no_more_than_members_and_none_that_meet_are_passed_over(times: int) -> None:
    assert sum(pairs_wrong(each, times) for each in problems()) == 0


def test_too_small_an_extent_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = LabelGeometry.extent.func
    monkeypatch.setattr(LabelGeometry, "extent", property(lambda geometry: 0.2 * honest(geometry)))
    assert any(pairs_wrong(each, times) for each in problems() for times in (0, 1))


@pytest.mark.parametrize("field", ["apart", "handle_apart"])
def test_too_little_slack_is_caught(field: str, monkeypatch: pytest.MonkeyPatch) -> None:
    honest = LabelGeometry.drawn

    def tight(geometry: LabelGeometry, at: np.ndarray) -> Drawn:
        drawn = honest(geometry, at)
        return replace(drawn, **{field: 0.5 * getattr(drawn, field)})

    monkeypatch.setattr(LabelGeometry, "drawn", tight)
    assert any(pairs_wrong(each, times) for each in problems() for times in (0, 1))


@cache
def layouts(problem: LayoutProblem) -> tuple[np.ndarray, np.ndarray]:
    """(n, count) choices of labels (label_set indices) of a small problem, up to 100, and (n,) what each costs."""
    labels = all_labels(problem)
    ends = itertools.pairwise(labels.start)
    every = np.array(list(itertools.product(*(range(low, high) for low, high in ends))))
    every = every[:: max(1, len(every) // 50)]
    return every, total_costs(problem, labels.candidate[every])


def left_out_wrongly(problem: LayoutProblem, taken_off: float = 0.0) -> int:
    labels = all_labels(problem)
    every, costs = layouts(problem)
    limit = float(np.median(costs[np.isfinite(costs)])) if np.isfinite(costs).any() else 0.0
    kept = np.flatnonzero(labels.active_below(limit - taken_off))
    return int((costs[~np.isin(every, kept).all(axis=1)] < limit).sum())


def test_what_is_not_in_play_is_in_no_better_layout() -> None:
    assert sum(map(left_out_wrongly, problems())) == 0


def test_too_little_in_play_is_caught() -> None:
    assert any(left_out_wrongly(each, 0.3) for each in problems())


def test_selected_labels_are_a_problem_of_their_own() -> None:
    for problem in problems():
        labels = all_labels(problem)
        few = cheapest(labels, parts(labels, 2))
        assert len(few) == len(parts(labels, 2).variable)
        few = np.sort(few)
        some = labels.of(few)
        assert some.candidate.tolist() == labels.candidate[few].tolist()
        assert some.best.tolist() == labels.best.tolist()
        for geometry, old in zip(some.geometries, labels.geometries, strict=True):
            at = np.searchsorted(old.owner, few[geometry.owner])
            assert (geometry.samples == old.samples[:, :, at]).all()
            assert (geometry.handle == old.handle[:, at]).all()


def thinned_wrongly(problem: LayoutProblem, taken_off: float = 0.0) -> int:
    """How many layouts below a cut-off use labels that were thinned out, by the blocks' true bounds."""
    labels = all_labels(problem)
    found = parts(labels, 1)
    every, costs = layouts(problem)
    block_of = np.empty(len(labels.cost), dtype=np.int64)
    block_of[found.members] = np.repeat(np.arange(len(found.variable)), found.sizes)
    least = np.minimum.reduceat(labels.cost[found.members], found.start[:-1])
    more = labels.cost - least[block_of]
    room = np.full(len(found.variable), np.inf)
    for column in every.T:
        np.minimum.at(room, block_of[column], costs - more[every].sum(axis=1))
    cut = float(np.median(costs[np.isfinite(costs)])) if np.isfinite(costs).any() else 0.0
    kept = thinned(labels, found, cut - taken_off - room)
    assert (kept.sizes > 0).all()
    return int((costs[~np.isin(every, kept.members).all(axis=1)] < cut - 1e-9).sum())


def test_what_is_thinned_out_is_in_no_better_layout() -> None:
    assert sum(map(thinned_wrongly, problems())) == 0


def test_too_much_thinned_out_is_caught() -> None:
    assert any(thinned_wrongly(each, 0.3) for each in problems())


def test_a_block_with_any_slack_keeps_its_cheapest_label() -> None:
    for problem in problems():
        labels = all_labels(problem)
        found = parts(labels, 1)
        for slack in (0.0, 1e-300, 5e-17):
            assert thinned(labels, found, np.full(len(found.variable), slack)).variable.tolist() == (
                found.variable.tolist()
            )


def test_a_label_left_alone_of_a_block_gets_its_own_costs() -> None:
    for problem in problems():
        labels = all_labels(problem)
        found = parts(labels, 1)
        older = near_blocks(problem, block_set(labels, found), budget())
        first = Blocks(found.members[found.start[:-1]], np.arange(len(found.variable) + 1), found.variable)
        label_set = block_set(labels, first)
        mine = refined(problem, label_set, older, np.arange(len(found.variable)), found.sizes == 1, budget())
        wanted = near_blocks(problem, label_set, budget())
        for one, other in zip(mine, wanted, strict=True):
            key = {(a, b): cost for a, b, cost in zip(other.first, other.second, other.costs, strict=True)}
            got = {(a, b): cost for a, b, cost in zip(one.first, one.second, one.costs, strict=True)}
            assert {each: got[each] for each in got if got[each] > 0} == pytest.approx(
                {each: key[each] for each in key if key[each] > 0}
            )


def test_of_equal_candidates_the_first_is_a_label() -> None:
    problem = crowd(0)
    arrays = ("points", "cost", "samples", "handles", "displacement")
    doubled = tuple(
        replace(each, **{name: np.concatenate([getattr(each, name)] * 2) for name in arrays})
        for each in problem.variables
    )
    assert np.array_equal(all_labels(replace(problem, variables=doubled)).candidate, all_labels(problem).candidate)


@pytest.mark.parametrize(
    ("between", "slack", "excluded", "near"),
    [
        (1.0, 0.0, False, False),
        (0.9, 0.0, True, True),
        (1.6, 0.25, False, False),
        (1.5, 0.25, False, True),
        (0.5, 0.25, False, True),
        (0.4, 0.25, True, True),
    ],
)
def test_members_handles_may_be_nearer_than_their_centres_by_what_both_are_off(
    between: float, slack: float, excluded: bool, near: bool
) -> None:
    """At a separation of 1, which itself is allowed; samples are out of reach.  Rounding is given to the bound."""

    def geometry(x: float) -> LabelGeometry:
        far, still = np.full((1, 3, 1), 100.0 * (x + 1.0)), np.zeros((1, 1))
        return LabelGeometry(np.array([0]), far, still, np.array([[x], [0.0], [0.0]]), np.array([slack]))

    problem = LayoutProblem((), MeanOverlap(5.0, 0.1, 20.0, 0.6, 0.15), 1.0)
    at = np.array([0])
    (cost,), (meets,) = pair_bounds(geometry(0.0), at, geometry(between), at, problem)
    assert (np.isinf(cost), meets) == (excluded, near)
