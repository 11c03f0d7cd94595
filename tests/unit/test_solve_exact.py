"""The whole method against enumeration, its bound, its stopping, and that its checks can fail.

More problems are compared with enumeration by ``USDRIGUI_BRUTE_FORCE=2000 python -m pytest
tests/unit/test_solve_exact.py -k enumeration``.
"""

from __future__ import annotations

import itertools
import os
from collections.abc import Callable
from dataclasses import replace

import highspy
import numpy as np
import pytest
from enumeration import best_of_all
from layout_problems import at_one_spot, crowd, random_problem
from programs import ran

from usdrigui.character import Indices
from usdrigui.errors import RigUIError
from usdrigui.model import (
    GAP_FLOOR,
    Assignment,
    ExtraPairs,
    LayoutProblem,
    MeanOverlap,
    Variable,
)
from usdrigui.overlap import total_cost
from usdrigui.settings import SolveSettings
from usdrigui.solve import Progress, cheap_labels, exact, milp, reduce, reduced_problem, solve
from usdrigui.solve.assignment import assignment
from usdrigui.solve.budget import LOWERED_AIM, Budget
from usdrigui.solve.exact import infeasible_penalty, solve_whole
from usdrigui.solve.joint_labels import Joint
from usdrigui.solve.label_geometry import all_labels
from usdrigui.solve.local_search import LocalSearch
from usdrigui.solve.milp import program, solve_milp
from usdrigui.solve.pair_costs import pair_costs
from usdrigui.solve.reduced_problem import DEAREST, PlainProblem, ReducedProblem, least_sums, undominated
from usdrigui.solve.triplets import raise_bound

Way = Callable[[pytest.MonkeyPatch], None]
HIGHS = SolveSettings()
SOME = replace(HIGHS, work_limit=3_000_000)
PART = int(os.environ.get("USDRIGUI_BRUTE_FORCE", "96")) // 6
"""Random problems compared with enumeration, for each of the ways."""
ALL_FIT = cheap_labels.BYTES_PER_PAIR
"""Of pairs of labels, unless a test leaves room for few."""


def faults(problem: LayoutProblem, found: Assignment, best: Assignment) -> list[str]:
    """What is wrong with a solution, given the enumerated one."""
    wrong = []
    if abs(found.cost - total_cost(problem, found.labels)) > 1e-12:
        wrong.append("cost is not the objective's")
    if found.bound > best.cost + 1e-9:
        wrong.append("bound above the optimum")
    if found.cost < best.cost - 1e-9:
        wrong.append("cost below the optimum")
    if found.status == "optimal" and found.cost > best.cost + 1e-4 * max(abs(best.cost), GAP_FLOOR) + 1e-9:
        wrong.append("called optimal, and is not")
    if found.status != "optimal" and (found.closed_by != "memory limit" or cheap_labels.BYTES_PER_PAIR == ALL_FIT):
        wrong.append("not solved")
    return wrong


def solved(problem: LayoutProblem, settings: SolveSettings) -> Assignment | None:
    try:
        return solve(problem, settings)
    except RigUIError as error:
        if error.issue.code != "SOLVE_INFEASIBLE":
            raise
        return None


def failures(seeds: range) -> list[str]:
    """Faults over many problems; both methods must agree on which are infeasible."""
    found = []
    for seed in seeds:
        problem = random_problem(seed)
        best, mine = best_of_all(problem), solved(problem, HIGHS)
        if (best is None) != (mine is None):
            found.append(f"{seed}: feasible to one only")
        elif best is not None and mine is not None:
            found += [f"{seed}: {each}" for each in faults(problem, mine, best)]
    return found


def as_it_is(_: pytest.MonkeyPatch) -> None:
    """What one round of dual ascent leaves of small problems goes to HiGHS."""


def by_bounds(monkeypatch: pytest.MonkeyPatch) -> None:
    """HiGHS gets nothing that bounds, dominance and joining can close, as of large problems."""
    monkeypatch.setattr(reduce, "SMALL", -1)


def by_few(monkeypatch: pytest.MonkeyPatch, most: int = 8) -> None:
    """Of small problems few labels are taken first, as of large ones; what these leave open may stay so."""
    by_bounds(monkeypatch)
    monkeypatch.setattr(cheap_labels, "BYTES_PER_PAIR", HIGHS.memory_limit * 2**21 / most**2)


def by_triplets(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few labels are taken first, and then all that these leave open; triplets are looked for before labels are
    joined."""
    by_bounds(monkeypatch)
    monkeypatch.setattr(exact, "FEW", 1)
    honest = reduce.Reduction._thinned
    monkeypatch.setattr(reduce.Reduction, "_thinned", lambda left: left.tightened() and honest(left))


def by_program(monkeypatch: pytest.MonkeyPatch) -> None:
    """All that dual ascent leaves goes to HiGHS."""
    monkeypatch.setattr(reduce.Reduction, "_thinned", lambda *_: True)
    monkeypatch.setattr(reduce, "SMALL", 10**9)


def by_joining(monkeypatch: pytest.MonkeyPatch) -> None:
    """Variables are joined for as long as there are two that interact."""
    by_bounds(monkeypatch)
    monkeypatch.setattr(reduce.Reduction, "_thinned", reduce.Reduction._excluded)


WAYS = [as_it_is, by_bounds, by_few, by_triplets, by_program, by_joining]


@pytest.mark.parametrize("way", WAYS)
def test_agrees_with_enumeration_on_random_problems(way: Way, monkeypatch: pytest.MonkeyPatch) -> None:
    way(monkeypatch)
    first = PART * WAYS.index(way)
    assert failures(range(first, first + PART)) == []


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("seed", range(4))
def test_proves_crowds_optimal(seed: int, way: Way, monkeypatch: pytest.MonkeyPatch) -> None:
    way(monkeypatch)
    problem = crowd(seed, variables=4, candidates=14 if way is by_program else 30)
    assert faults(problem, solve(problem, HIGHS), best_of_all(problem)) == []


@pytest.mark.parametrize("seed", [0, 3, 5])
def test_the_labels_that_others_stood_for_are_opened(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    by_few(monkeypatch, 30)
    problem = crowd(seed, variables=3, candidates=40)
    found = solve(problem, HIGHS)
    assert faults(problem, found, best_of_all(problem)) == []
    assert found.status == "optimal"
    assert [step.name for step in found.steps].count("reduce") > 1


def test_the_solver_named_is_the_one_that_closed_the_problem(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = crowd(1, variables=4, candidates=12)
    by_program(monkeypatch)
    found = solve(problem, HIGHS)
    assert (found.method, found.closed_by) == ("highs", "highs")
    figures = dict(next(each.figures for each in found.steps if each.name == "highs"))
    assert figures["columns"] > figures["labels"] > 0 < figures["rows"]
    by_joining(monkeypatch)
    found = solve(problem, HIGHS)
    assert (found.method, found.closed_by) == ("joining", "joining")


def test_highs_finds_the_best_layout_among_joint_labels(monkeypatch: pytest.MonkeyPatch) -> None:
    by_joining(monkeypatch)
    monkeypatch.setattr(reduce, "couples", lambda left: [(0, 1)] * (left.count == 4))
    for step in ("_thinned", "tightened"):
        monkeypatch.setattr(reduce.Reduction, step, lambda _: True)
    problem = crowd(0, variables=4, candidates=14)
    found = solve(problem, HIGHS)
    assert found.method == "highs"
    assert faults(problem, found, best_of_all(problem)) == []


def test_a_joint_label_that_is_dearer_than_its_members_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = Joint.together
    monkeypatch.setattr(Joint, "together", lambda joint, pairs: honest(joint, pairs) + 0.3)
    by_joining(monkeypatch)
    assert overstated(random_problems(), monkeypatch, HIGHS.work_limit) > 0


@pytest.mark.parametrize("seed", range(4))
def test_the_program_has_the_costs_of_the_problem(seed: int) -> None:
    """Of every layout, whatever excludes some: rows are kept, columns as small as these allow."""
    problem = crowd(seed, variables=3, candidates=7)
    plain = plain_problem(problem)
    labels, rows = len(plain.linear), program(plain)
    layouts, allowed = itertools.product(*(range(mine.start, mine.stop) for mine in plain.slices)), 0
    for layout in layouts:
        chosen = np.array(layout)
        least: dict[int, float] = {}
        kept = True
        for row in rows:
            is_label = row.columns < labels
            value = row.values[is_label] @ np.isin(row.columns[is_label], chosen)
            if is_label.all():
                kept &= bool(row.low <= value <= row.high)
            else:
                column = int(row.columns[-1])
                least[column] = max(least.get(column, 0.0), row.low - value)
        cost = plain.linear[chosen].sum() + sum(least.values())
        assert kept == np.isfinite(plain.value(chosen))
        if kept:
            assert cost == pytest.approx(plain.value(chosen), abs=1e-12)
            assert cost == pytest.approx(total_cost(problem, all_labels(problem).candidate[chosen]), abs=1e-12)
            allowed += 1
    assert 0 < allowed < 8**3


def test_a_program_that_forgets_a_cost_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = milp._lifted
    monkeypatch.setattr(milp, "_lifted", lambda *of_two: list(honest(*of_two))[1:])
    with pytest.raises(AssertionError):
        test_the_program_has_the_costs_of_the_problem(0)


def plain_problem(problem: LayoutProblem) -> PlainProblem:
    labels = all_labels(problem)
    pairs = pair_costs(problem, labels, Budget(HIGHS)).toarray()
    return PlainProblem(labels.start, labels.cost, pairs + pairs.T)


def test_rounding_is_taken_off_a_bound_not_added() -> None:
    problem = crowd(0, variables=2, candidates=3)
    labels, budget = all_labels(problem), Budget(HIGHS)
    chosen = np.array([0, -1])
    budget.found("test", bound=total_cost(problem, chosen) - 0.5)
    assert assignment(problem, labels, chosen, budget, "test").bound < budget.bound


@pytest.mark.parametrize("seed", range(4))
def test_a_cutoff_just_above_the_best_cost_finds_that_layout_again(seed: int) -> None:
    problem, budget = crowd(seed, variables=4, candidates=8), Budget(HIGHS)
    best, plain = solve(problem, replace(HIGHS, gap=1e-9)), plain_problem(problem)
    found = solve_milp(plain, best.cost + 1e-5, budget)
    assert found.chosen is not None
    assert plain.value(found.chosen) == pytest.approx(best.cost)
    assert all_labels(problem).candidate[found.chosen].tolist() == best.labels.tolist()
    none = solve_milp(plain, best.cost - 1e-5, budget)
    assert (none.chosen, none.bound) == (None, best.cost - 1e-5)


def test_highs_run_with_more_threads_elsewhere_in_the_process_is_not_in_the_way() -> None:
    highspy.Highs.resetGlobalScheduler(True)
    other = milp.QuietHighs()
    other.setOptionValue("threads", 2)
    other.run()
    test_a_cutoff_just_above_the_best_cost_finds_that_layout_again(0)


def _nothing(*_: object, **__: object) -> None:
    """Stands in for a step of the local search."""


def overstated(problems: list[LayoutProblem], monkeypatch: pytest.MonkeyPatch, work: int = 20_000) -> int:
    """How many bounds lie above the optimum when the local search is kept from finding it.

    A good layout would hide a wrong bound: no more is claimed than the cost at hand.
    """
    honest = LocalSearch.improve_from

    def begin(search: LocalSearch, chosen: Indices) -> None:
        if not np.isfinite(search.cost):
            honest(search, chosen)

    monkeypatch.setattr(LocalSearch, "search", _nothing)
    monkeypatch.setattr(LocalSearch, "improve_from", begin)
    monkeypatch.setattr(LocalSearch, "_moves", _nothing)
    count = 0
    for problem in problems:
        best = best_of_all(problem)
        mine = solved(problem, replace(HIGHS, work_limit=work))
        if best is not None and mine is not None:
            count += mine.bound > best.cost + 1e-9
    return count


def random_problems() -> list[LayoutProblem]:
    return [random_problem(seed) for seed in range(12)] + [crowd(seed, 4, 20) for seed in range(3)]


@pytest.mark.parametrize("way", WAYS)
def test_bounds_hold_whatever_the_local_search_finds(way: Way, monkeypatch: pytest.MonkeyPatch) -> None:
    way(monkeypatch)
    assert overstated(random_problems(), monkeypatch) == 0


@pytest.mark.parametrize(
    ("owner", "name", "amount"),
    [
        (ReducedProblem, "bound", 1e-4),
        (ReducedProblem, "label_lower_bounds", 0.05),
        (ReducedProblem, "_pair_lower_bounds", 0.2),
    ],
)
def test_a_bound_raised_is_caught(owner: type, name: str, amount: float, monkeypatch: pytest.MonkeyPatch) -> None:
    honest = getattr(owner, name)
    by_few(monkeypatch)
    monkeypatch.setattr(owner, name, lambda *arguments: honest(*arguments) + amount)
    assert overstated(random_problems(), monkeypatch) > 0


def bounds_of_stopped_runs(seed: int) -> tuple[float, list[float]]:
    """The optimum, and what HiGHS claims of it that is stopped ever later."""
    plain, budget = plain_problem(crowd(seed, variables=4, candidates=15)), Budget(HIGHS)
    best = solve_milp(plain, 100.0, budget)
    assert best.chosen is not None
    limits = [replace(HIGHS, work_limit=budget.work * share // 6) for share in range(1, 6)]
    return plain.value(best.chosen), [solve_milp(plain, 100.0, Budget(each)).bound for each in limits]


@pytest.mark.parametrize("seed", range(3))
def test_the_bound_of_a_run_of_highs_that_is_stopped_holds(seed: int) -> None:
    optimum, bounds = bounds_of_stopped_runs(seed)
    assert max(bounds) <= optimum + 1e-9
    assert np.isfinite(max(bounds))


def test_a_bound_of_highs_that_is_raised_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = milp._lowered
    monkeypatch.setattr(milp, "_lowered", lambda value: honest(value) + 0.5)
    optimum, bounds = bounds_of_stopped_runs(0)
    assert max(bounds) > optimum


def test_least_sums_are_never_above_those_of_all_labels() -> None:
    costs = np.random.default_rng(0).exponential(20.0, (16, 7))
    costs[costs > 60.0] = np.inf
    one, other = costs[:5], costs[5:]
    every = (np.minimum(one, DEAREST)[:, None] + np.minimum(other, DEAREST)).min(axis=2)
    found = least_sums(one, other)
    assert (found <= every).all()
    assert (every - found < 3e-13).all()


def test_dominance_that_forgets_what_pairs_cost_is_caught(monkeypatch: pytest.MonkeyPatch) -> None:
    by_bounds(monkeypatch)
    honest = undominated
    monkeypatch.setattr(reduce, "undominated", lambda start, linear, _, gone: honest(start, linear, 0 * gone, gone))
    assert overstated(random_problems(), monkeypatch, HIGHS.work_limit) > 0


@pytest.mark.parametrize("seed", range(4))
def test_what_can_replace_a_label_costs_no_more_in_the_mean(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    plain = plain_problem(crowd(seed, variables=4, candidates=20))
    given = plain.start, 9 * plain.linear, plain.pairs, np.isinf(plain.pairs)
    alive = undominated(*given)
    monkeypatch.setattr(reduced_problem, "_cheaper_in_mean", lambda own, *_: ~np.eye(len(own), dtype=bool))
    assert alive.tolist() == undominated(*given).tolist()
    assert not alive.all()


def test_of_labels_that_can_replace_each_other_one_is_kept() -> None:
    no_pairs, linear = np.zeros((4, 4)), np.array([1.0, 1.0, 1.5, 0.0])
    alive = undominated(np.array([0, 3, 4]), linear, no_pairs, no_pairs.astype(bool))
    assert alive[:2].sum() == 1
    assert alive[2:].tolist() == [False, True]


@pytest.mark.parametrize(
    ("settings", "named"),
    [
        (HIGHS, r"SOLVE_INFEASIBLE.*v0, v1, v2"),
        (replace(HIGHS, work_limit=0), r"no layout before the work limit: no place apart .* v0, v1, v2 yet"),
    ],
)
def test_variables_without_a_place_are_named(settings: SolveSettings, named: str) -> None:
    with pytest.raises(RigUIError, match=named):
        solve(at_one_spot(crowd(3, variables=3, candidates=1)), settings)


def test_infeasible_problems_are_reported_at_once_however_their_bound_is_rounded() -> None:
    problem = random_problem(5000453, 6, 8)  # its bound ended one unit of rounding below what is never allowed
    assert best_of_all(problem) is None
    spent = Budget(replace(HIGHS, work_limit=10**6))
    with pytest.raises(RigUIError, match="SOLVE_INFEASIBLE"):
        solve_whole(problem, spent)
    assert spent.work < 10**4


def test_no_candidate_and_no_place_off_the_face_is_refused() -> None:
    problem = crowd(3, variables=2, candidates=3)
    empty = replace(
        problem.variables[0],
        points=np.empty(0, dtype=np.int64),
        cost=np.empty(0),
        samples=np.empty((0, 1, 5, 3)),
        handles=np.empty((0, 1, 3)),
        off_face_cost=np.inf,
    )
    with pytest.raises(RigUIError, match="v0"):
        solve(replace(problem, variables=(empty, problem.variables[1])), HIGHS)


def test_no_variables() -> None:
    found = solve(replace(crowd(0), variables=()), HIGHS)
    assert (found.cost, found.status, len(found.labels)) == (0.0, "optimal", 0)


def test_a_best_cost_of_nothing_is_proved() -> None:
    problem = crowd(1, variables=4, candidates=12)
    cost = solve(problem, HIGHS).cost
    first = problem.variables[0]
    shifted = replace(first, cost=first.cost - cost, off_face_cost=first.off_face_cost - cost)
    found = solve(replace(problem, variables=(shifted, *problem.variables[1:])), HIGHS)
    assert found.status == "optimal"
    assert abs(found.cost) < 1e-3
    assert found.gap <= 1e-4


@pytest.mark.parametrize("seed", range(6))
def test_a_gap_of_nothing_is_proved(seed: int) -> None:
    found = solve(crowd(seed, variables=4, candidates=12), replace(HIGHS, gap=0.0))
    assert (found.status, found.gap < 1e-9) == ("optimal", True)


@pytest.mark.parametrize(
    ("seed", "given"), [(7, 7), (2**31 - 1, 2**31 - 1), (2**31 + 7, 7), (2**62, 0), (2**40 + 9, 9)]
)
def test_every_seed_is_one_that_highs_takes(seed: int, given: int) -> None:
    """It takes 31 bits, and no more."""
    plain = plain_problem(crowd(6, variables=3, candidates=10))
    assert milp._loaded(plain, program(plain), seed).getOptionValue("random_seed")[1] == given


def test_highs_prints_nothing(capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    by_program(monkeypatch)
    assert solve(crowd(1, variables=4, candidates=12), HIGHS).method == "highs"
    assert capfd.readouterr() == ("", "")


def test_a_local_search_ends_when_it_is_asked_to(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[bool] = []

    def stop() -> bool:
        asked.append(True)
        return len(asked) > 100

    tries: list[bool] = []
    honest = LocalSearch._rivals
    monkeypatch.setattr(LocalSearch, "_rivals", lambda search: (tries.append(True), honest(search))[1])
    found = solve(crowd(2, variables=6, candidates=40), HIGHS, stop=stop)
    assert (found.status, found.closed_by) == ("stopped", "interrupt")
    assert 0 < len(tries) <= 100


def test_highs_ends_when_it_is_asked_to(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[bool] = []
    honest = milp.program
    monkeypatch.setattr(milp, "program", lambda plain: (asked.append(True), honest(plain))[1])

    def stop() -> bool:
        asked.extend(asked[:1])
        return len(asked) > 3

    by_program(monkeypatch)
    found = solve(crowd(2, variables=6, candidates=40), HIGHS, stop=stop)
    assert (found.status, found.closed_by) == ("stopped", "interrupt")
    assert found.bound <= found.cost
    assert 3 < len(asked) < 9


def test_a_method_without_a_proof_names_no_limit() -> None:
    found = solve(crowd(5, variables=5, candidates=10), SolveSettings(method="paper", clusters=2))
    assert (found.status, found.closed_by) == ("stopped", "")


def test_a_method_without_a_proof_names_the_limit_that_a_cluster_came_to() -> None:
    few = SolveSettings(method="paper", clusters=2, work_limit=3_000)
    assert solve(crowd(5, variables=5, candidates=30), few).closed_by == "work limit"


def test_stopping_at_once_returns_an_honest_layout() -> None:
    problem = crowd(5, variables=5, candidates=30)
    told: list[Progress] = []
    found = solve(problem, HIGHS, told.append, stop=lambda: bool(told))
    assert found.status == "stopped"
    assert np.isfinite(found.cost)
    assert found.bound <= solve(problem, SOME).cost


def test_progress_only_gets_better() -> None:
    told: list[Progress] = []
    found = solve(crowd(2, variables=5, candidates=30), SOME, told.append)
    costs, lower = [each.cost for each in told], [each.bound for each in told]
    assert costs == sorted(costs, reverse=True)
    assert lower == sorted(lower)
    assert told[-1].cost == pytest.approx(found.cost)
    assert {each.step for each in told} >= {"local search", "bounds"}


def test_half_of_the_work_lowers_the_aim() -> None:
    budget = Budget(replace(HIGHS, gap=0.0, work_limit=100))
    budget.found("", cost=-10.0, bound=-20.0)
    budget.spend(49)
    budget.lower_aim()
    assert budget.cutoff == -10.0
    budget.spend(1)
    budget.lower_aim()
    assert budget.cutoff == pytest.approx(-17.5)
    budget.found("", bound=-17.0)
    budget.lower_aim()
    assert (budget.limit, budget.cutoff) == (LOWERED_AIM, pytest.approx(-17.5))


def test_a_crowd_gets_a_long_search(monkeypatch: pytest.MonkeyPatch) -> None:
    problem = crowd(2, variables=24, candidates=60)
    long = solve(problem, SOME)
    monkeypatch.setattr(reduce, "LONG", 0)
    assert long.cost < solve(problem, SOME).cost - 0.05


@pytest.mark.parametrize("share", [0.2, 0.5, 0.9])
def test_a_lower_aim_is_a_bound(share: float) -> None:
    problem = crowd(3, variables=5, candidates=12)
    best, budget = solve(problem, HIGHS), Budget(HIGHS)
    assert best.status == "optimal"
    least = sum(min(each.cost.min(), each.off_face_cost) for each in problem.variables)
    budget.aim = best.cost - share * (best.cost - least)
    found = solve_whole(problem, budget)
    assert (found.status, found.closed_by) == ("stopped", LOWERED_AIM)
    assert budget.aim - 1e-9 <= found.bound <= best.cost


def test_work_limit_is_reproducible() -> None:
    problem, settings = crowd(7, variables=10, candidates=60), SolveSettings(work_limit=40_000)
    first, second = solve(problem, settings), solve(problem, settings)
    assert (first.labels == second.labels).all()
    assert (first.cost, first.bound) == (second.cost, second.bound)
    assert [each.figures for each in first.steps] == [each.figures for each in second.steps]


def with_copies(problem: LayoutProblem, copies: int) -> LayoutProblem:
    """Elements that are drawn more than once, as pairs are."""
    return replace(
        problem,
        variables=tuple(
            replace(each, samples=each.samples.repeat(copies, axis=1), handles=each.handles.repeat(copies, axis=1))
            for each in problem.variables
        ),
    )


def test_work_ends_near_its_limit() -> None:
    for copies, limit in ((1, 300_000), (2, 1_000_000)):
        found = solve(with_copies(crowd(7, variables=12, candidates=150), copies), replace(HIGHS, work_limit=limit))
        assert found.status == "stopped"
        assert dict(found.steps[-1].figures)["work"] < 1.5 * limit


def test_memory_is_planned_before_it_is_spent() -> None:
    problem = crowd(7, variables=6, candidates=300)
    found = solve(problem, SolveSettings(memory_limit=1))
    assert (found.status, found.closed_by) == ("stopped", "memory limit")
    assert found.bound <= found.cost
    assert solve(problem, SolveSettings(work_limit=400_000)).closed_by != "memory limit"


def crowds_apart(count: int) -> LayoutProblem:
    """Crowds far from each other."""
    crowds = [crowd(seed, variables=3, candidates=40) for seed in range(count)]
    apart = tuple(
        replace(each, handles=each.handles + 100.0 * at, samples=each.samples + 100.0 * at)
        for at, part in enumerate(crowds)
        for each in part.variables
    )
    return replace(crowds[0], variables=apart)


def test_only_variables_that_interact_take_memory() -> None:
    """Pairs within a crowd fit, those of all crowds would not."""
    assert solve(crowds_apart(10), replace(HIGHS, memory_limit=8)).status == "optimal"


def test_tables_of_variables_that_interact_give_the_bounds_of_one_matrix() -> None:
    problem, budget = crowds_apart(2), Budget(HIGHS)
    labels = all_labels(problem)
    pairs = pair_costs(problem, labels, budget)
    sparse, full = (
        ReducedProblem(labels.variable, np.arange(len(labels.cost)), labels.cost.copy(), each)
        for each in (pairs, pairs.toarray())
    )
    for each in (sparse, full):
        each.normalize()
        each.sweep()
        raise_bound(each, budget)
    assert sparse.entries < full.entries
    assert sparse.bound() == pytest.approx(full.bound())
    assert sparse.label_lower_bounds() == pytest.approx(full.label_lower_bounds())


def test_importing_the_package_loads_no_solver() -> None:
    code = "import sys, usdrigui.solve; sys.exit(any(m in sys.modules for m in ('highspy', 'pytoulbar2')))"
    assert ran("-c", code).returncode == 0


def on_a_line(count: int, apart: int, step: float, first: int, off_face: float) -> LayoutProblem:
    """Two rows of handles on a grid, of which the outermost two alone are as far apart as the separation."""
    elements = []
    for start, outer in ((first, 0), (first + apart - count + 1, count - 1)):
        handles = np.zeros((count, 1, 3))
        handles[:, 0, 0] = (start + np.arange(count)) * step
        cost = -np.ones(count)
        cost[outer] = -0.9
        elements.append(Variable(f"v{start}", np.arange(count), cost, handles[:, :, None], handles, off_face, -cost))
    return LayoutProblem(tuple(elements), MeanOverlap(5.0, 1.0, 4.0, 3.0, 0.15), step * apart)


@pytest.mark.parametrize("grid", [(32, 37, 0.1, -2, 0.3), (16, 20, 0.3, -11, 0.3), (16, 26, 0.013, 16, np.inf)])
def test_handles_at_the_separation_exactly_are_allowed(
    grid: tuple[int, int, float, int, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    by_bounds(monkeypatch)
    problem = on_a_line(*grid)
    assert faults(problem, solve(problem, HIGHS), best_of_all(problem)) == []


def test_handles_too_near_by_rounding_alone_are_not() -> None:
    elements = []
    for ends, away in (((-0.15000000000000002, -0.15000000000000002), 5.0), ((-0.2, -0.35000000000000003), 9.0)):
        samples = np.zeros((2, 1, 2, 3))
        samples[:, 0, :, 1] = ends
        samples[1, :, :, 0] = away
        cost = np.array([-1.0, -0.5])
        elements.append(Variable(f"v{away}", np.arange(2), cost, samples, samples[:, :, 0].copy(), np.inf, -cost))
    problem = LayoutProblem(tuple(elements), MeanOverlap(5.0, 1.0, 4.0, 0.05, 0.15), 0.05)
    assert faults(problem, solve(problem, HIGHS), best_of_all(problem)) == []


def dear_pairs(seed: int, factor: float) -> LayoutProblem:
    """Costs with ties, and explicit costs of which half are so much larger."""
    problem, generator = random_problem(seed), np.random.default_rng(seed)
    return replace(
        problem,
        variables=tuple(replace(each, cost=np.round(each.cost * 2) / 2) for each in problem.variables),
        extra=tuple(
            replace(each, costs=np.where(generator.random(len(each.costs)) < 0.5, each.costs * factor, each.costs))
            for each in problem.extra
        ),
    )


@pytest.mark.parametrize("factor", [1e11, np.inf])
@pytest.mark.parametrize("seed", [7, 12, 32, 44, 49])
def test_pairs_dearer_than_all_else_leave_no_rounding_behind(seed: int, factor: float) -> None:
    problem = dear_pairs(seed, factor)
    mine, best = solve(problem, replace(HIGHS, work_limit=100_000)), best_of_all(problem)
    assert faults(problem, mine, best) == []


def test_explicit_costs_of_tables_do_not_add_up_to_a_multiplier() -> None:
    problem = crowd(0, variables=2, candidates=20)
    pairs = np.indices((20, 20)).reshape(2, -1)
    extra = ExtraPairs(0, 1, pairs[0], pairs[1], np.full(400, 0.5))
    labels = all_labels(problem)
    more = infeasible_penalty(replace(problem, extra=(extra,)), labels) - infeasible_penalty(problem, labels)
    assert more == pytest.approx(0.5)  # a layout uses one entry of the table


def test_what_is_forbidden_costs_more_than_the_dearest_allowed_layout() -> None:
    """One more than the spread of linear costs, the overlaps of copies of different elements, and explicit costs."""

    def element(name: str, costs: list[float], copies: int) -> Variable:
        places = np.zeros((len(costs), copies, 3))
        return Variable(
            name, np.arange(len(costs)), np.array(costs), places[:, :, None], places, np.inf, np.array(costs)
        )

    elements = element("a", [0.0, 0.5], 1), element("b", [-1.0, 0.25, -2.0], 2)
    extra = (ExtraPairs(0, 1, np.array([0, 1]), np.array([0, 2]), np.array([0.75, np.inf])),)
    problem = LayoutProblem(elements, MeanOverlap(5.0, 1.0, 4.0, 3.0, 0.125), 1e-6, extra)
    labels = all_labels(problem)
    assert infeasible_penalty(problem, labels) == pytest.approx(1.0 + 0.5 + 2.25 + 0.125 * 5.0 * 2 + 0.75)


@pytest.mark.parametrize(("cost", "allowed"), [(-50.0, 5.0), (0.0, 0.1 * GAP_FLOOR), (3.0, 0.3)])
def test_a_gap_is_a_share_of_the_cost_or_of_its_floor(cost: float, allowed: float) -> None:
    assert Budget(SolveSettings(gap=0.1)).allowed(cost) == pytest.approx(allowed)
