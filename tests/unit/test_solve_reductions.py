"""The paper's reductions: clusters by single linkage or by sums, elements fixed in sequence, weighted samples."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from layout_problems import crowd
from scipy.cluster.hierarchy import fcluster, linkage

from usdrigui.errors import RigUIError
from usdrigui.model import LayoutProblem, MeanOverlap, Variable
from usdrigui.settings import Settings, SolveSettings, load
from usdrigui.solve import solve
from usdrigui.solve.budget import Budget
from usdrigui.solve.clusters import clusters
from usdrigui.solve.paper import sample

SEPARATION = 0.1


def element(name, spots, gains, off_face=np.inf):
    """An element with candidates at `spots` (x) that gain so much each; drawn as a point."""
    handles = np.zeros((len(spots), 1, 3))
    handles[:, 0, 0] = spots
    gains = np.asarray(gains, dtype=np.float64)
    samples = np.repeat(handles[:, :, None], 2, axis=2)
    return Variable(name, np.arange(len(spots)), -gains, samples, handles, off_face, gains)


def problem_of(*elements, radius=1.0):
    return LayoutProblem(tuple(elements), MeanOverlap(5.0, radius, 4.0 / radius, 3.0 * radius, 0.15), SEPARATION)


def row(*places):
    """One element with a single candidate at each place."""
    return problem_of(*(element(f"v{at}", [place], [1.0]) for at, place in enumerate(places)))


def moved(problem, at, shift):
    """The problem with some of its elements moved along x."""
    offset = np.array([shift, 0.0, 0.0])
    return replace(
        problem,
        variables=tuple(
            replace(each, handles=each.handles + offset, samples=each.samples + offset) if index in at else each
            for index, each in enumerate(problem.variables)
        ),
    )


# --- clusters ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("linkage", ["single", "sum"])
def test_clusters_part_what_lies_apart(linkage) -> None:
    problem = moved(crowd(0, variables=6, candidates=10), {1, 3, 5}, 100.0)
    assert clusters(problem, 2, linkage) == [[0, 2, 4], [1, 3, 5]]
    assert clusters(problem, 1, linkage) == [[0, 1, 2, 3, 4, 5]]
    assert sorted(clusters(problem, 9, linkage)) == [[at] for at in range(6)]


def test_single_linkage_follows_chains_and_sums_do_not() -> None:
    """Eight neighbours at a distance of one and a pair at 2.5 from the last: the widest gap parts them, but the
    sum over all pairs grows with the chain, so that its second half joins the pair."""
    problem = row(0, 1, 2, 3, 4, 5, 6, 7, 9.5, 10.5)
    assert clusters(problem, 2, "single") == [[0, 1, 2, 3, 4, 5, 6, 7], [8, 9]]
    assert clusters(problem, 2, "sum") == [[4, 5, 6, 7, 8, 9], [0, 1, 2, 3]]


def test_single_linkage_does_not_count_candidates_and_sums_do() -> None:
    many, near = element("a", np.linspace(0, 0.5, 30), np.ones(30)), element("b", np.linspace(1, 1.5, 30), np.ones(30))
    lone = element("c", [6.0], [1.0])
    assert clusters(problem_of(many, near, lone), 2, "single") == [[0, 1], [2]]
    assert clusters(problem_of(many, near, lone), 2, "sum") == [[1, 2], [0]]


@pytest.mark.parametrize("linkage", ["single", "sum"])
def test_an_element_without_a_place_on_the_face_goes_with_the_first_cluster(linkage) -> None:
    few = (element("a", [0.0], [1.0]), element("b", [], []), element("c", [1.0], [1.0]), element("d", [9.0], [1.0]))
    assert clusters(problem_of(*few), 2, linkage) == [[0, 1, 2], [3]]


@pytest.mark.parametrize("seed", range(5))
def test_single_linkage_is_that_of_scipy(seed) -> None:
    places = np.random.default_rng(seed).uniform(0, 30, (12, 3))
    problem = row(*np.zeros(12))
    problem = replace(
        problem,
        variables=tuple(
            replace(each, handles=each.handles + place, samples=each.samples + place)
            for each, place in zip(problem.variables, places, strict=True)
        ),
    )
    found, joined = clusters(problem, 4), fcluster(linkage(places, "single"), 4, "maxclust")
    assert sorted(found) == sorted(np.flatnonzero(joined == each).tolist() for each in set(joined))
    assert [*map(len, found)] == sorted(map(len, found), reverse=True)


def test_the_nearest_copies_count() -> None:
    """A pair stands on both sides: its images belong to what is near either of them."""
    left = element("left", [10.0, 10.2], [1.0, 1.0])
    mirrored = np.array([-1.0, 1.0, 1.0])
    pair = replace(
        left,
        samples=np.concatenate([left.samples, left.samples * mirrored], axis=1),
        handles=np.concatenate([left.handles, left.handles * mirrored], axis=1),
    )
    right, middle = element("right", [-10.1], [1.0]), element("middle", [4.0], [1.0])
    assert clusters(problem_of(pair, right, middle), 2) == [[0, 1], [2]]


def test_elements_that_stand_off_the_face_anyway_join_the_first_cluster() -> None:
    homeless = element("none", [], [], off_face=0.1)
    assert clusters(problem_of(homeless, element("a", [0], [1]), element("b", [9], [1])), 2) == [[0, 1], [2]]
    assert clusters(problem_of(homeless), 2) == [[0]]
    assert clusters(problem_of(), 2) == []


# --- one cluster after the other ---------------------------------------------------------------------


def test_earlier_elements_act_as_fixed_costs() -> None:
    """Three elements on the left are placed first; the two on the right then shun where those stand."""
    first = [element(f"a{at}", [at, 0.3 + at], [1.0, 0.5]) for at in range(3)]
    wants = element("b", [2.0, 8.0, 9.0, 9.1, 9.2], [1.0, 0.9, 0.4, 0.4, 0.4])
    far = element("c", [11.0], [1.0])
    problem = problem_of(*first, wants, far, radius=0.5)
    assert clusters(problem, 2) == [[0, 1, 2], [3, 4]]
    alone = solve(replace(problem, variables=(wants, far)), SolveSettings())
    assert list(alone.labels) == [0, 0], "left to itself it takes the place of a2"
    found = solve(problem, SolveSettings(method="paper", clusters=2))
    assert list(found.labels) == [0, 0, 0, 1, 0], "the first cluster does not yield; the second does"


def test_soft_costs_of_earlier_elements_count_too() -> None:
    """Nothing is forbidden here: the overlap with what stands already makes the poorer place the better one."""
    first = [element("a0", [0.0], [1.0]), element("a1", [0.6], [1.0])]
    later = element("b", [1.0, 3.0], [1.0, 0.9])
    problem = replace(problem_of(*first, later), separation=1e-9)
    found = solve(problem, SolveSettings(method="paper", clusters=2))
    assert clusters(problem, 2) == [[0, 1], [2]]
    assert list(found.labels) == [0, 0, 1]


def test_what_earlier_elements_forbid_is_not_sampled() -> None:
    first = [element("a0", [0.0], [1.0]), element("a1", [0.5], [1.0])]
    later = element("b", [0.5, *np.linspace(20, 30, 9)], [1e6, *np.full(9, 0.1)])
    problem = problem_of(*first, later)
    assert clusters(problem, 2) == [[0, 1], [2]]
    assert solve(problem, SolveSettings(method="paper", clusters=2, sample=0.1)).labels[2] > 0
    with pytest.raises(RigUIError, match="SOLVE_INFEASIBLE"):
        solve(problem_of(*first, element("b", [0.5], [1.0])), SolveSettings(method="paper", clusters=2))


def test_more_clusters_never_beat_the_whole() -> None:
    for seed in range(3):
        problem = crowd(seed, variables=5, candidates=10)
        whole = solve(problem, SolveSettings())
        for count in (2, 3, 5):
            found = solve(problem, SolveSettings(method="paper", clusters=count))
            assert found.cost >= whole.bound - 1e-9
            assert np.array_equal(found.labels, solve(problem, SolveSettings(method="paper", clusters=count)).labels)


# --- one allowance of work and time ------------------------------------------------------------------


def test_parts_share_what_is_left_of_the_limits() -> None:
    budget = Budget(SolveSettings(work_limit=900))
    part = budget.part(1 / 3)
    assert part.settings.work_limit == 300
    assert part.settings.time_limit == 0
    budget.spend(100)
    assert budget.part(1 / 2).settings.work_limit == 400
    budget.spend(900)
    assert budget.part(1.0).settings.work_limit == 0
    assert budget.part(1.0).stopped()


def test_parts_share_the_time_and_the_request_to_stop() -> None:
    assert 200.0 < Budget(SolveSettings(time_limit=1000.0)).part(0.25).settings.time_limit <= 250.0
    assert Budget(SolveSettings(time_limit=1e-9)).part(1.0).stopped()
    asked = []
    budget = Budget(SolveSettings(), stop=lambda: bool(asked))
    part = budget.part(0.5)
    assert not part.stopped()
    asked.append(True)
    assert part.stopped()


def test_clusters_do_not_get_a_limit_each() -> None:
    problem = crowd(1, variables=12, candidates=60)
    for at in range(1, 4):
        problem = moved(problem, set(range(at, 12, 4)), 100.0 * at)
    assert [*map(len, clusters(problem, 4))] == [3, 3, 3, 3]
    free = solve(problem, SolveSettings(method="paper", clusters=4, gap=0.0))
    spent = [dict(step.figures)["work"] for step in free.steps if step.name == "cluster"]
    limit = int(min(spent)) // 2
    tight = solve(problem, SolveSettings(method="paper", clusters=4, gap=0.0, work_limit=4 * limit))
    used = [dict(step.figures)["work"] for step in tight.steps if step.name == "cluster"]
    assert len(used) == 4
    assert sum(used) < 0.9 * sum(spent)
    assert all(mine < other for mine, other in zip(used, spent, strict=True))


# --- samples -----------------------------------------------------------------------------------------


def test_a_sample_prefers_large_displacements_whatever_the_cost() -> None:
    generator = np.random.default_rng(0)
    displacement = generator.uniform(0.0, 1.0, 2000)
    kept = sample([displacement], 0.1, generator, [np.ones(2000, dtype=bool)])[0]
    assert len(kept) == 200
    assert (np.diff(kept) > 0).all()
    # The mean of a sample weighted by a uniform variable is that of its square over its mean: 2/3.
    assert displacement[kept].mean() == pytest.approx(2 / 3, abs=0.05)


def test_the_chance_of_a_candidate_is_its_displacement() -> None:
    pair, allowed = [np.array([3.0, 1.0])], [np.ones(2, dtype=bool)]
    drawn = [int(sample(pair, 0.5, np.random.default_rng(seed), allowed)[0][0]) for seed in range(2000)]
    assert np.mean(drawn) == pytest.approx(0.25, abs=0.03)


def test_a_problem_is_sampled_by_displacement_not_by_cost() -> None:
    """Occlusion and other costs are no part of the weight."""
    gains = np.r_[np.full(50, 1.0), np.full(50, 1e-6)]
    wide = element("a", np.arange(100.0), gains)
    dearer = replace(wide, cost=wide.cost + np.r_[np.full(50, 5.0), np.zeros(50)])
    assert solve(problem_of(dearer), SolveSettings(method="paper", sample=0.2)).labels[0] < 50


@pytest.mark.parametrize(("share", "count"), [(0.6, 2), (0.7, 3)])
def test_a_share_of_three_candidates_is_rounded_up(share: float, count: int) -> None:
    (kept,) = sample([np.ones(3)], share, np.random.default_rng(0), [np.ones(3, dtype=bool)])
    assert len(kept) == count


def test_of_an_element_that_the_sample_passed_over_the_candidate_that_moves_is_kept() -> None:
    still_and_moving, allowed = [np.array([0.0, 1.0])] * 5, [np.ones(2, dtype=bool)] * 5
    assert np.concatenate(sample(still_and_moving, 1e-6, np.random.default_rng(0), allowed)).tolist() == [1] * 5


def test_a_sample_keeps_one_of_each_and_follows_the_seed() -> None:
    weights = [np.full(400, 1e-3), np.full(400, 1.0)]
    allowed = [np.ones(400, dtype=bool)] * 2
    assert [*map(len, sample(weights, 1e-6, np.random.default_rng(0), allowed))] == [1, 1]
    one, again, other = (sample(weights, 0.1, np.random.default_rng(seed), allowed) for seed in (1, 1, 2))
    assert all(map(np.array_equal, one, again))
    assert not all(map(np.array_equal, one, other))
    problem = crowd(0, variables=5, candidates=40)
    seeded = [solve(problem, SolveSettings(method="paper", sample=0.2, seed=seed)).cost for seed in (3, 3, 4)]
    assert seeded[0] == seeded[1] != seeded[2]


# --- settings ----------------------------------------------------------------------------------------


def test_reductions_are_off_by_default_and_on_in_the_paper_preset() -> None:
    plain, paper = Settings().solve, load(preset="paper").solve
    assert (plain.method, plain.clusters, plain.sample) == ("highs", 1, 1.0)
    assert (paper.method, paper.clusters, paper.sample, paper.linkage) == ("paper", 2, 0.2, "single")


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("clusters", 0),
        ("clusters", -1),
        ("clusters", 1.5),
        ("sample", 0.0),
        ("sample", 1.01),
        ("sample", -0.2),
        ("seed", -1),
        ("linkage", "complete"),
    ],
)
def test_settings_without_meaning_are_refused(name, value) -> None:
    with pytest.raises(RigUIError, match=f"CONFIG_VALUE solve.{name}"):
        load({"solve": {name: value}})
