"""What pairs of labels cost, which labels are taken, and what stands for the others."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from enumeration import total_costs
from layout_problems import crowd, random_problem

from usdrigui.model import ExtraPairs, LayoutProblem, MeanOverlap, Overlap
from usdrigui.overlap import Drawn, drawn_costs, pair_costs
from usdrigui.settings import SolveSettings
from usdrigui.solve.budget import Budget
from usdrigui.solve.cheap_labels import CheapLabels, cheap_labels
from usdrigui.solve.label_geometry import LabelGeometry, all_labels
from usdrigui.solve.pair_costs import pair_costs as costs_of_pairs


def usable(problem: LayoutProblem) -> bool:
    return bool(np.diff(all_labels(problem).start).all())


@cache
def problems() -> tuple[LayoutProblem, ...]:
    drawn = [random_problem(seed) for seed in range(60)] + [crowd(seed, 4, 12) for seed in range(5)]
    drawn += [replace(each, overlap=MeanOverlap(5.0, 0.2, 20.0, 0.6, 0.15), separation=0.1) for each in drawn[-5:]]
    return tuple(each for each in drawn if usable(each))


def budget() -> Budget:
    return Budget(SolveSettings())


def test_an_explicit_cost_of_the_very_first_label_counts() -> None:
    problem = replace(
        crowd(0, variables=2, candidates=3), extra=(ExtraPairs(0, 1, *np.array([[0], [2]]), np.array([7.0])),)
    )
    labels = all_labels(problem)
    (other,) = np.flatnonzero((labels.variable == 1) & (labels.candidate == 2))
    of_places = costs_of_pairs(replace(problem, extra=()), labels, budget())[0, other]
    assert costs_of_pairs(problem, labels, budget())[0, other] == of_places + 7.0


def pairs_wrong(problem: LayoutProblem) -> int:
    """How many pairs do not cost what the objective says."""
    labels = all_labels(problem)
    every = costs_of_pairs(replace(problem, extra=()), labels, budget()).toarray()
    return int((~np.isclose(every + every.T, costs_of_labels(problem))).sum())


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


def test_pairs_cost_what_they_should_and_none_that_meet_are_passed_over() -> None:
    assert sum(map(pairs_wrong, problems())) == 0


def test_too_small_an_extent_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = LabelGeometry.extent.func
    monkeypatch.setattr(LabelGeometry, "extent", property(lambda geometry: 0.2 * honest(geometry)))
    assert any(map(pairs_wrong, problems()))


# --- the labels that are taken ------------------------------------------------------------------------


def taken(problem: LayoutProblem, most: int) -> CheapLabels:
    """Of all labels so many, and one for the others of each variable."""
    labels = all_labels(problem)
    return cheap_labels(problem, labels, np.ones(len(labels.cost), dtype=bool), np.array([0]), most, budget())


@cache
def layouts(problem: LayoutProblem) -> tuple[np.ndarray, np.ndarray]:
    """(n, count) labels of up to 100 layouts of a small problem, and (n,) what each costs."""
    labels = all_labels(problem)
    ends = itertools.pairwise(labels.start)
    every = np.array(list(itertools.product(*(range(low, high) for low, high in ends))))
    every = every[:: max(1, len(every) // 50)]
    return every, total_costs(problem, labels.candidate[every])


def stand_ins(problem: LayoutProblem, few: CheapLabels) -> np.ndarray:
    """(labels,) the place among those taken of each label, or of the one that stands for it."""
    labels, found = all_labels(problem), np.full(len(all_labels(problem).cost), -1)
    for at in np.flatnonzero(few.stands):
        found[labels.variable == few.labels.variable[at]] = at
    found[few.place] = np.arange(len(few.place))
    return found


def dearer_than_what_they_stand_for(problem: LayoutProblem, more: float = 0.0) -> int:
    """How many layouts cost less than those of what stands for their labels."""
    few, (every, costs) = taken(problem, 6), layouts(problem)
    mine = stand_ins(problem, few)[every]
    assert (mine >= 0).all()
    pairs = few.least_pairs.toarray() + more
    least = few.labels.cost[mine].sum(axis=1)
    least += [pairs[np.ix_(each, each)].sum() for each in mine]
    return int((costs < least - 1e-9).sum())


def test_no_layout_costs_less_than_what_stands_for_it() -> None:
    assert sum(map(dearer_than_what_they_stand_for, problems())) == 0


def test_what_stands_for_others_and_costs_too_much_is_caught() -> None:
    assert any(dearer_than_what_they_stand_for(each, 0.3) for each in problems())


def test_what_fits_is_the_cheapest_and_what_is_wanted() -> None:
    for problem in problems():
        labels, few = all_labels(problem), taken(problem, 6)
        above = labels.cost - labels.best[labels.variable]
        alone = few.place[~few.stands]
        wanted = np.union1d(np.argsort(above, kind="stable")[:6], np.flatnonzero(labels.candidate < 0))
        assert alone.tolist() == np.union1d(wanted, [0]).tolist()
        left_out = np.setdiff1d(np.arange(len(above)), alone)
        for at in few.place[few.stands]:
            others = left_out[labels.variable[left_out] == labels.variable[at]]
            assert labels.cost[at] == labels.cost[others].min()
        assert few.labels.best.tolist() == labels.best.tolist()
        assert few.labels.candidate.tolist() == labels.candidate[few.place].tolist()


def test_all_labels_are_taken_where_they_fit_and_none_stands_for_others() -> None:
    for problem in problems():
        few = taken(problem, 10**4)
        assert few.place.tolist() == list(range(len(all_labels(problem).cost)))
        assert not few.stands.any()
        assert (few.least_pairs != few.pairs).nnz == 0


def closed_wrongly(problem: LayoutProblem, taken_off: float = 0.0) -> int:
    """How many layouts below a cutoff use labels that are not opened, by true bounds of those that are taken."""
    labels, few, (every, costs) = all_labels(problem), taken(problem, 6), layouts(problem)
    cut = float(np.median(costs[np.isfinite(costs)])) if np.isfinite(costs).any() else 0.0
    place, bounds = stand_ins(problem, few), np.full(len(few.place), np.inf)
    for row, cost in zip(every, costs, strict=True):
        mine = place[row]
        # What stands for a label is as cheap as the cheapest: so much less the layout costs with it.
        less = (labels.cost[row] - few.labels.cost[mine]).sum()
        np.minimum.at(bounds, mine, cost - less)
    left = np.flatnonzero(bounds < cut)
    opened = few.opened(labels, left, cut - taken_off - bounds[left])
    return int((costs[~opened[every].all(axis=1)] < cut - 1e-9).sum())


def test_what_is_not_opened_is_in_no_better_layout() -> None:
    assert sum(map(closed_wrongly, problems())) == 0


def test_too_little_opened_is_caught() -> None:
    assert any(closed_wrongly(each, 0.3) for each in problems())


def test_of_equal_candidates_the_first_is_a_label() -> None:
    problem = crowd(0)
    arrays = ("points", "cost", "samples", "handles", "displacement")
    doubled = tuple(
        replace(each, **{name: np.concatenate([getattr(each, name)] * 2) for name in arrays})
        for each in problem.variables
    )
    assert np.array_equal(all_labels(replace(problem, variables=doubled)).candidate, all_labels(problem).candidate)


@pytest.mark.parametrize(
    ("between", "behind", "cost"), [(1.0, 0.0, 0.5), (0.9, 0.0, np.inf), (0.5, 2.0, 0.75), (0.5, 0.5, np.inf)]
)
def test_nearer_handles_than_the_separation_are_forbidden_and_one_behind_another_is_near_it_on_the_screen(
    between: float, behind: float, cost: float
) -> None:
    def drawn(x: float, depth: float) -> Drawn:
        return Drawn(np.array([[[x], [9.0 * (1.0 + x)]]] * 2), np.array([[x], [0.0], [depth]]))

    seen = Overlap(2, 1.0, 1.0, 2.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0, 1.0, 0.0)
    mean, two = MeanOverlap(5.0, 0.1, 20.0, 0.6, 0.15), (drawn(0.0, 0.0), drawn(between, behind))
    assert drawn_costs(*two, seen, 1.0).tolist() == [cost]
    assert np.isinf(drawn_costs(*two, mean, 1.0)) == np.isinf(cost)
