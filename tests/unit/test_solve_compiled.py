"""Compiled loops of the exact search and of sweeps against numpy, to the last bit."""

from __future__ import annotations

import itertools
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import fields, replace
from types import ModuleType

import numpy as np
import pytest

from usdrigui.settings import SolveSettings
from usdrigui.solve import compiled, search, sweeps
from usdrigui.solve.bounds import Dual
from usdrigui.solve.compiled import CompiledPart, Loops, compiled_loops, compiled_part
from usdrigui.solve.search import Found, Search
from usdrigui.solve.subproblem import Part
from usdrigui.solve.tables import Table
from usdrigui.solve.watch import Watch

AS_PYTHON = Loops(**{each.name: getattr(compiled, each.name) for each in fields(Loops)})
NEVER = 10**18


@pytest.fixture
def anew() -> Iterator[None]:
    """The loops are made anew in the test, and after it."""
    compiled_loops.cache_clear()
    yield
    compiled_loops.cache_clear()


def by_numba() -> Loops:
    """The loops as a search has them; skips without numba, but fails if it is there and does not compile them."""
    pytest.importorskip("numba", reason="usdrigui-core[fast] is not installed")
    loops = compiled_loops()
    assert loops is not None
    return loops


BOTH = pytest.mark.parametrize("made", [lambda: AS_PYTHON, by_numba], ids=["as Python", "by numba"])


def random_part(seed: int, variables: int = 7, entries: int = 9) -> Part:
    """A part with tables of all kinds: missing, nearly zero, constant, with ties, with prices as large as can be."""
    generator = np.random.default_rng(seed)
    count = int(generator.integers(1, variables + 1))
    sizes = generator.integers(1, entries + 1, count)
    owner = np.repeat(np.arange(count), sizes)
    start = np.concatenate([[0], np.cumsum(sizes)])
    matrix = np.zeros((len(owner), len(owner)))
    forbidden = generator.choice([3.0, 20.0, 1e9, 1e150])
    kinds = generator.choice(
        ["none", "tiny", "constant", "ties", "any", "bans"], (count, count), p=generator.dirichlet(np.ones(6))
    )
    for a, b in itertools.combinations(range(count), 2):
        costs = generator.normal(size=(sizes[a], sizes[b]))
        costs = {
            "none": 0.0 * costs,
            "tiny": 1e-12 * np.abs(costs),
            "constant": np.full_like(costs, costs[0, 0]),
            "ties": np.round(costs, 1),
            "any": costs,
            "bans": np.where(costs > 0.5, forbidden, np.maximum(costs, 0.0)),
        }[kinds[a, b]]
        matrix[start[a] : start[a + 1], start[b] : start[b + 1]] = costs
    names = np.sort(generator.permutation(3 * count)[:count])
    number = np.concatenate([np.sort(generator.permutation(50)[:size]) for size in sizes])
    costs = generator.normal(size=len(owner)) * generator.choice([1.0, 1e-6, 1e3])
    return Part(names, owner, number, costs, np.asarray(matrix, order=generator.choice(["C", "F"])))


def crowd(seed: int, variables: int = 6, entries: int = 7) -> Part:
    """Elements on a line that want to stand in one place and may not: many nodes."""
    generator = np.random.default_rng(seed)
    places = generator.uniform(0, 3, (variables, entries)).ravel()
    owner = np.repeat(np.arange(variables), entries)
    across = np.clip(1.2 - np.abs(places[:, None] - places), 0.0, None) + 20.0 * (
        np.abs(places[:, None] - places) < 0.2
    )
    matrix = np.where(owner[:, None] < owner, across, 0.0)
    costs = generator.uniform(-1, 0, len(owner))
    return Part(np.arange(variables), owner, np.tile(np.arange(entries), variables), costs, matrix)


def on_loops(loops: Loops, part: Part) -> CompiledPart:
    """A copy of a part on the loops."""
    costs, matrix = part.costs.copy(), np.array(part.matrix, order="C")
    return CompiledPart(loops, part.variables, part.owner, part.entries, costs, matrix)


def assert_same(mine: Part, theirs: Part) -> None:
    for name in ("variables", "owner", "entries", "costs", "matrix", "start", "sizes", "linked"):
        np.testing.assert_array_equal(getattr(mine, name), getattr(theirs, name), name)
    assert mine.constant == theirs.constant
    assert mine.taken == theirs.taken


def assert_same_bounds(mine: Part, theirs: Part) -> None:
    (bound, excess), (their_bound, their_excess) = mine.bounds(), theirs.bounds()
    assert bound == their_bound
    np.testing.assert_array_equal(excess, their_excess)


def some_alive(part: Part, generator: np.random.Generator) -> np.ndarray:
    """At least one entry of every variable, of some only one."""
    alive = generator.random(len(part.costs)) < generator.choice([0.2, 0.6, 0.9])
    alive[part.start[:-1] + generator.integers(part.sizes)] = True
    return np.asarray(alive)


def assert_all_steps_same(loops: Loops, *seeds: int, variables: int = 7, entries: int = 9) -> None:
    for seed in seeds:
        assert_steps_same(loops, random_part(seed, variables, entries), np.random.default_rng(seed))


def assert_steps_same(loops: Loops, plain: Part, generator: np.random.Generator) -> None:
    """A walk down a tree by numpy and by the loops, compared at every step."""
    quick: Part = on_loops(loops, plain)
    for _ in range(4):
        assert_same_bounds(quick, plain)
        quick.settle()
        plain.settle()
        assert_same(quick, plain)
        for _ in range(2):
            quick.sweep()
            plain.sweep()
            assert_same(quick, plain)
        assert_same_bounds(quick, plain)
        group = plain.components()[0]
        assert_same(quick.picked(group), plain.picked(group))
        alive = some_alive(plain, generator)
        quick, plain = quick.restricted(alive), plain.restricted(alive)
        assert_same(quick, plain)
        assert isinstance(quick, CompiledPart)
        if not len(plain.variables):
            return


@BOTH
def test_every_step_is_the_same(made: Callable[[], Loops]) -> None:
    assert_all_steps_same(made(), *range(400))


def test_every_step_of_large_parts_is_the_same() -> None:
    """Long runs of entries are worked on several at a time."""
    assert_all_steps_same(by_numba(), *range(40), variables=20, entries=50)


@BOTH
def test_parts_of_one_variable_are_the_same(made: Callable[[], Loops]) -> None:
    loops = made()
    seeds = [seed for seed in range(200) if len(random_part(seed, 2).variables) == 1]
    assert len(seeds) > 50
    for seed in seeds:
        plain = random_part(seed, 2)
        quick = on_loops(loops, plain)
        for each in (quick, plain):
            each.settle()
            each.sweep()
        assert_same(quick, plain)
        assert_same_bounds(quick, plain)
        assert_same(quick.restricted(quick.bounds()[1] <= 0), plain.restricted(plain.bounds()[1] <= 0))


def test_many_variables_taken_at_once_are_added_up_as_numpy_does() -> None:
    """Of eight numbers or more numpy adds up pairwise."""
    for seed in range(40):
        generator = np.random.default_rng(seed)
        plain = crowd(seed, variables=40, entries=4)
        plain.matrix[:] = np.triu(generator.normal(size=plain.matrix.shape), 1) * (plain.owner[:, None] < plain.owner)
        quick = on_loops(AS_PYTHON, plain)
        alive = np.ones(len(plain.costs), dtype=bool)
        taken = generator.permutation(40)[: int(generator.integers(5, 39))]
        alive[np.isin(plain.owner, taken)] = False
        alive[plain.start[taken] + 1] = True
        assert_same(quick.restricted(alive), plain.restricted(alive))


@pytest.mark.parametrize("name", ["settle", "sweep", "add_stars", "gather", "pay"])
def test_a_loop_wrong_by_a_hair_is_seen(name: str) -> None:
    """The smallest change of one number that any loop returns does not pass for the same."""
    returned = {"settle": 0, "sweep": 1, "add_stars": 4, "gather": 2, "pay": 3}[name]

    def wrong(*arguments: np.ndarray) -> None:
        getattr(compiled, name)(*arguments)
        found = arguments[returned]
        if found.size:
            at = np.unravel_index(np.abs(found).argmax(), found.shape)
            found[at] = np.nextafter(found[at], np.inf)

    loops = replace(AS_PYTHON, **{name: wrong})
    with pytest.raises(AssertionError):
        assert_all_steps_same(loops, *range(100))


def searched(part: Part, deep: bool, nodes: int) -> tuple[Found, int, int]:
    watch = Watch(SolveSettings(work_limit=10**9))
    run = Search(watch, nodes)
    found = run.deepen(part, np.inf, 0.3) if deep else run.solve(part, np.inf)
    return found, run.nodes, watch.work


def outcomes(plain: int, monkeypatch: pytest.MonkeyPatch) -> list[tuple[float, float, dict[int, int], int, int]]:
    monkeypatch.setattr(search, "PLAIN", plain)
    found = []
    for seed in range(6):
        for make, deep, nodes in (
            (crowd, False, 10**6),
            (crowd, True, 10**6),
            (crowd, True, 40),
            (random_part, False, 10**6),
        ):
            best, used, work = searched(make(seed), deep, nodes)
            found.append((best.bound, best.cost, best.chosen, used, work))
    return found


@pytest.mark.parametrize("after", [0, 30_000])
def test_whole_searches_are_the_same(after: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """From the first node on, and changed over midway."""
    by_numba()
    plain = outcomes(NEVER, monkeypatch)
    assert outcomes(after, monkeypatch) == plain
    assert sum(nodes for *_, nodes, _ in plain) > 2000
    assert all(np.isfinite(cost) for _, cost, *_ in plain[::4])


def kinds_of_parts(plain: int, monkeypatch: pytest.MonkeyPatch) -> list[type[Part]]:
    """What the nodes of a search that branch work on, in their order."""
    kinds: list[type[Part]] = []
    branch = Search._branch

    def noted(self: Search, part: Part, *rest: object) -> Found:
        kinds.append(type(part))
        return branch(self, part, *rest)

    monkeypatch.setattr(Search, "_branch", noted)
    monkeypatch.setattr(search, "PLAIN", plain)
    searched(crowd(3), False, 10**6)
    assert len(kinds) > 20
    return kinds


def test_a_long_search_goes_on_by_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    loops = by_numba()
    assert all(getattr(loops, each.name).nopython_signatures for each in fields(loops))
    assert set(kinds_of_parts(0, monkeypatch)) == {CompiledPart}
    kinds = kinds_of_parts(30_000, monkeypatch)
    assert kinds[0] is Part
    assert kinds[-1] is CompiledPart


def test_a_short_search_does_without(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compiled, "compiled_part", None)  # would raise
    assert set(kinds_of_parts(search.PLAIN, monkeypatch)) == {Part}


def test_numba_is_imported_only_when_it_is_needed() -> None:
    script = "import sys, usdrigui.solve.search, usdrigui.solve.compiled; sys.exit('numba' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", script], check=False).returncode == 0


def broken() -> ModuleType:
    """A numba that can be imported and no more."""
    return ModuleType("numba")


@pytest.mark.usefixtures("anew")
@pytest.mark.parametrize("numba", [None, broken()], ids=["absent", "broken"])
def test_without_numba_a_search_is_as_it_was(numba: ModuleType | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "numba", numba)  # None: ImportError
    part = crowd(0)
    assert compiled_part(part) is part
    assert set(kinds_of_parts(0, monkeypatch)) == {Part}
    assert outcomes(0, monkeypatch) == outcomes(NEVER, monkeypatch)


@pytest.mark.usefixtures("anew")
def test_numba_that_does_not_compile_is_not_used(monkeypatch: pytest.MonkeyPatch) -> None:
    numba = pytest.importorskip("numba", reason="usdrigui-core[fast] is not installed")
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    assert compiled_loops() is None


@pytest.mark.usefixtures("anew")
def test_loops_are_compiled_where_they_cannot_be_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    numba = pytest.importorskip("numba", reason="usdrigui-core[fast] is not installed")
    monkeypatch.setattr(numba.core.caching.CacheImpl, "_locator_classes", [])
    with pytest.raises(RuntimeError):
        numba.njit(numba.void(), cache=True)(broken)
    assert_all_steps_same(by_numba(), 0)


@pytest.mark.parametrize("cost", [np.inf, -np.inf, np.nan, 1e250])
def test_costs_that_could_overflow_are_left_to_numpy(cost: float) -> None:
    by_numba()
    for spoilt in ("costs", "matrix"):
        part = crowd(0)
        assert isinstance(compiled_part(crowd(0)), CompiledPart)
        getattr(part, spoilt)[..., -1] = cost
        assert compiled_part(part) is part


# --- sweeps ------------------------------------------------------------------------------------------


def random_visit(seed: int) -> tuple[np.ndarray, ...]:
    """Costs, rows, heights, widths and multipliers of a few tables of one variable."""
    generator = np.random.default_rng(seed)
    tables, size = int(generator.integers(1, 6)), int(generator.integers(1, 30))
    rows = [np.sort(generator.permutation(size)[: generator.integers(1, size + 1)]) for _ in range(tables)]
    widths = generator.integers(1, 40, tables)
    costs = [
        generator.choice([0.0, 0.3, 20.0, 1e9], (len(mine), width)) for mine, width in zip(rows, widths, strict=True)
    ]
    multipliers = generator.normal(size=(tables, size)) * generator.choice([1.0, 1e-6, 1e6])
    return (
        np.concatenate([each.ravel() for each in costs]).astype(np.float32),
        np.concatenate(rows),
        np.concatenate([[0], np.cumsum([len(each) for each in rows])]),
        np.concatenate([[0], np.cumsum(widths)]),
        multipliers.astype(np.float32),
    )


def assert_least_the_same(loops: Loops, seeds: range) -> None:
    for seed in seeds:
        visit = random_visit(seed)
        plain, quick = np.empty((2, visit[3][-1]), dtype=np.float32)
        for (costs, rows, at), own in zip(sweeps._tables(*visit[:4]), visit[4], strict=True):
            plain[at] = (costs - own[rows, None]).min(axis=0)
        loops.least(*visit, quick)
        np.testing.assert_array_equal(quick, plain)


@BOTH
def test_least_costs_of_a_visit_are_the_same(made: Callable[[], Loops]) -> None:
    assert_least_the_same(made(), range(300))


def test_least_costs_wrong_by_a_hair_are_seen() -> None:
    def wrong(*arguments: np.ndarray) -> None:
        compiled.least(*arguments)
        arguments[-1][-1] = np.nextafter(arguments[-1][-1], np.float32(np.inf))

    with pytest.raises(AssertionError):
        assert_least_the_same(replace(AS_PYTHON, least=wrong), range(1))


def random_dual(seed: int, most: float = 3.0) -> Dual:
    generator = np.random.default_rng(seed)
    sizes = generator.integers(2, 40, 6)
    tables = []
    for first, second in itertools.combinations(range(6), 2):
        rows, columns = (
            np.sort(generator.permutation(sizes[at])[: generator.integers(1, sizes[at] + 1)]) for at in (first, second)
        )
        tables.append(Table(first, second, rows, columns, generator.uniform(0, most, (len(rows), len(columns)))))
    return Dual([generator.normal(size=size) for size in sizes], tables, 2 * most)


def multipliers(seed: int, long: int, monkeypatch: pytest.MonkeyPatch) -> list[np.ndarray]:
    monkeypatch.setattr(sweeps, "LONG", long)
    dual = random_dual(seed)
    sweeps.swept(dual, 9)
    return [*dual.theta, *(each for edge in dual.edges for each in edge.given)]


def test_sweeps_are_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    by_numba()
    for seed in range(30):
        for quick, plain in zip(multipliers(seed, 0, monkeypatch), multipliers(seed, NEVER, monkeypatch), strict=True):
            np.testing.assert_array_equal(quick, plain)


def test_long_sweeps_of_moderate_costs_go_by_numba(monkeypatch: pytest.MonkeyPatch) -> None:
    loops = by_numba()
    monkeypatch.setattr(sweeps, "LONG", 1)
    assert sweeps._quickest(random_dual(0), 9).args == (loops,)
    assert sweeps._quickest(random_dual(0, most=1e31), 9) is sweeps.least
    monkeypatch.setattr(sweeps, "LONG", NEVER)
    assert sweeps._quickest(random_dual(0), 9) is sweeps.least


@pytest.mark.usefixtures("anew")
def test_without_numba_sweeps_are_as_they_were(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "numba", None)  # ImportError
    monkeypatch.setattr(sweeps, "LONG", 0)
    assert sweeps._quickest(random_dual(0), 9) is sweeps.least
