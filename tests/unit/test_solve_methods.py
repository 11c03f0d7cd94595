"""The other methods, and the laws that all solutions obey."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from enumeration import best_of_all
from hypothesis import given, settings, strategies as st
from layout_problems import crowd, random_problem, renumbered

from usdrigui.errors import RigUIError
from usdrigui.model import LayoutProblem
from usdrigui.overlap import total_cost
from usdrigui.settings import SolveSettings
from usdrigui.solve import cheap_labels, solve
from usdrigui.solve.budget import Budget
from usdrigui.solve.exact import infeasible_penalty
from usdrigui.solve.label_geometry import all_labels
from usdrigui.solve.pair_costs import pair_costs

FEW = 3_000_000
"""Work that is enough for a crowd of five."""
FEW_FIT = SolveSettings().memory_limit * 2**21 / 8**2
"""Bytes for a pair of labels that leave room for eight."""


def best_or_none(problem: LayoutProblem, method: str) -> float | None:
    try:
        return solve(problem, SolveSettings(method=method)).cost  # type: ignore[arg-type]
    except RigUIError as error:
        if error.issue.code != "SOLVE_INFEASIBLE":
            raise
        return None


@settings(max_examples=25, deadline=None, derandomize=True)
@given(st.integers(1000, 10**6), st.integers(0, 10**6))
def test_renumbering_changes_nothing_but_names(seed: int, order: int) -> None:
    problem = random_problem(seed)
    one, other = best_or_none(problem, "highs"), best_or_none(renumbered(problem, order), "highs")
    assert (one is None) == (other is None)
    if one is not None:
        assert other == pytest.approx(one, rel=1.1e-4)


@settings(max_examples=25, deadline=None, derandomize=True)
@given(st.integers(1000, 10**6))
def test_bound_optimum_cost_in_this_order(seed: int) -> None:
    problem = random_problem(seed)
    best = best_of_all(problem)
    if best is not None:
        for method, room in (("highs", cheap_labels.BYTES_PER_PAIR), ("highs", FEW_FIT), ("paper", FEW_FIT)):
            with pytest.MonkeyPatch.context() as patch:
                patch.setattr(cheap_labels, "BYTES_PER_PAIR", room)
                try:
                    found = solve(problem, SolveSettings(method=method, work_limit=3_000))
                except RigUIError as error:
                    # Without a board the few that fit may have no layout.
                    if room != FEW_FIT or "no layout before the work limit" not in str(error):
                        raise
                    continue
            assert found.bound <= best.cost + 1e-9 <= found.cost + 2e-9


def test_total_renumbered() -> None:
    """The test's own renumbering keeps the objective."""
    problem = random_problem(12)
    labels = solve(problem, SolveSettings()).labels
    assert total_cost(problem, labels) == pytest.approx(solve(renumbered(problem, 5), SolveSettings()).cost)


# --- the paper's pipeline ----------------------------------------------------------------------------


def test_paper_with_one_cluster_and_all_candidates_is_the_optimum() -> None:
    problem = crowd(4, variables=4, candidates=20)
    whole = best_of_all(problem)
    assert solve(problem, SolveSettings(method="paper")).cost == pytest.approx(whole.cost, rel=1e-4)


def test_paper_never_beats_the_optimum_and_is_seeded() -> None:
    for seed in range(3):
        problem = crowd(seed, variables=5, candidates=30)
        optimum = solve(problem, SolveSettings(work_limit=FEW)).cost
        one = SolveSettings(method="paper", clusters=2, sample=0.2, seed=seed)
        first, second = solve(problem, one), solve(problem, one)
        assert first.cost >= optimum - 1e-4 * abs(optimum)
        assert (first.labels == second.labels).all()
        assert first.bound <= optimum


def test_paper_counts_explicit_costs_across_clusters() -> None:
    for seed in range(80):
        problem = random_problem(seed)
        try:
            found = solve(problem, SolveSettings(method="paper", clusters=2, sample=0.6))
        except RigUIError:
            continue
        assert found.cost == pytest.approx(total_cost(problem, found.labels))


# --- costs --------------------------------------------------------------------------------------------


def test_a_forbidden_pair_costs_local_search_more_than_any_layout_without_one() -> None:
    seen = 0
    for seed in range(30):
        problem = random_problem(seed, 3, 4)
        labels = all_labels(problem)
        if not np.diff(labels.start).all():
            continue
        pairs = pair_costs(problem, labels, Budget(SolveSettings())).toarray()
        penalty = infeasible_penalty(problem, labels)
        layouts = list(itertools.product(*(range(*ends) for ends in itertools.pairwise(labels.start))))
        tables = [pairs[np.ix_(each, each)] for each in layouts]
        values = np.array([labels.cost[list(each)].sum() for each in layouts])
        values += [np.minimum(each, penalty).sum() for each in tables]
        forbidden = np.array([np.isinf(each).any() for each in tables])
        seen += forbidden.any()
        assert values[forbidden].min(initial=np.inf) > values[~forbidden].max(initial=-np.inf)
    assert seen > 5
