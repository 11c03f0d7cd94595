"""Elements that are never visible together do not interact: in the objective, in the solver."""

from dataclasses import replace

import numpy as np
import pytest
from enumeration import best_of_all
from layout_problems import crowd, random_problem

from usdrigui.errors import RigUIError
from usdrigui.overlap import pair_costs, total_cost
from usdrigui.settings import SolveSettings
from usdrigui.solve import solve


def with_states(problem, seed):
    """The problem with every element visible in some of three states."""
    generator = np.random.default_rng(seed)
    choices = [frozenset({0}), frozenset({1}), frozenset({2}), frozenset({0, 1}), frozenset({0, 1, 2})]
    states = [choices[generator.integers(len(choices))] for _ in problem.variables]
    return replace(
        problem,
        variables=tuple(replace(v, states=s) for v, s in zip(problem.variables, states, strict=True)),
    )


def apart(problem):
    """Every element in a state of its own."""
    return replace(
        problem, variables=tuple(replace(v, states=frozenset({i})) for i, v in enumerate(problem.variables)), extra=()
    )


@pytest.mark.parametrize("seed", range(6))
def test_every_method_finds_the_optimum_of_problems_with_states(seed):
    problem = with_states(random_problem(seed), seed)
    truth = best_of_all(problem)
    if truth is None:
        with pytest.raises(RigUIError, match="SOLVE_INFEASIBLE"):
            solve(problem, SolveSettings(gap=1e-7))
        return
    found = solve(problem, SolveSettings(gap=1e-7))
    assert found.cost == pytest.approx(truth.cost, abs=1e-9)
    assert found.status == "optimal"
    assert found.cost == pytest.approx(total_cost(problem, found.labels), abs=1e-12)


def test_elements_that_never_meet_all_take_their_best_place():
    problem = apart(crowd(3))
    found = solve(problem, SolveSettings(gap=1e-7))
    assert found.labels.tolist() == [int(np.argmin(each.cost)) for each in problem.variables]
    # The same elements seen together cannot.
    together = solve(crowd(3), SolveSettings(work_limit=100_000))
    assert together.cost > found.cost + 0.1


def test_two_of_one_state_are_kept_apart_and_two_of_two_are_not():
    first, second = crowd(1, variables=2).variables
    same = crowd(1, variables=2)
    labels = np.zeros(1, dtype=np.int64)
    here = replace(second, handles=first.handles, samples=first.samples)
    assert np.isinf(pair_costs(replace(same, variables=(first, here)), 0, 1, labels, labels)[0])
    elsewhere = replace(here, states=frozenset({1}))
    assert pair_costs(replace(same, variables=(first, elsewhere)), 0, 1, labels, labels)[0] == 0.0
