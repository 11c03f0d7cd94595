"""Stronger bounds from groups of variables that no pairwise bound can reconcile.

Three or more elements that want one spot leave the pairwise bound below every layout.  The costs that the
dual ascent leaves, theta, make any partition of the variables a bound: the exact optimum of each group
under theta, and the least entries of the tables between groups.  Groups are found where a good solution
pays, solved by search, and merged where their solutions disagree (B. Savchynskyy et al., "Global MAP-
optimality by shrinking the combinatorial search area with convex relaxation", 2013).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from usdrigui.model import Flags, Floats, Indices
from usdrigui.solve.bounds import Dual
from usdrigui.solve.search import Found, Search
from usdrigui.solve.subproblem import Part
from usdrigui.solve.watch import Watch

TINY = 1e-9
TINY_CLASH = 1e-7
SWEEPS = 20
PROGRAM, PROGRAM_NODES = 150, 200
"""Entries of a group that HiGHS is tried on, and its nodes."""
LARGEST = 2500
"""Entries of a group that is searched: its matrix takes the square of that times 8 bytes."""


@dataclass(frozen=True, eq=False)
class Grouped:
    """What groups add to the bound of a dual."""

    gain: Floats
    """(groups,) how much each group's optimum lies above its pairwise bound."""
    member: Indices
    """(variables,) group of each variable, or -1."""
    chosen: Indices
    """(variables,) entries of a good solution."""


def group_gains(
    dual: Dual, bound: float, chosen: Indices, cut: float, watch: Watch, nodes: int, most: int, small: float = 0.0
) -> Grouped:
    """Solve and merge groups until they agree, reach the cut-off or have spent `nodes`.

    Groups have `most` members at first, more when all of those are solved and nodes remain.  Clashes below
    the share `small` of what is missing are not worth a merge.
    """
    chosen = chosen.copy()
    label = _joined(np.arange(len(chosen)), _disagreements(dual, chosen, 0.02 * max(cut - bound, 0.0)), most)
    solved: dict[tuple[int, ...], tuple[Found, float]] = {}
    best: Grouped | None = None
    while True:
        spent = 0
        for group in _groups(label):
            if group not in solved:
                least = _least(dual, group)
                others = sum(solved[each][0].bound - solved[each][1] for each in _groups(label) if each in solved)
                found, used = _solve(dual, group, least, cut - bound - others, chosen, watch, (nodes - spent + 1) // 2)
                solved[group] = (found, least)
                spent += used
            found = solved[group][0]
            for variable, entry in found.chosen.items():
                chosen[variable] = entry
        current = _groups(label)
        gains = np.array([max(0.0, solved[each][0].bound - solved[each][1]) for each in current])
        member = np.full(len(chosen), -1)
        for number, group in enumerate(current):
            member[list(group)] = number
        least_clash = max(TINY_CLASH, small * (cut - bound - gains.sum()))
        clashes = [each for each in _disagreements(dual, chosen, least_clash) if _apart(member, each)]
        finished = all(np.isfinite(solved[each][0].cost) for each in current)
        nodes -= spent
        # A large group whose search was cut short can prove less than its parts did.
        if best is None or gains.sum() > best.gain.sum():
            best = Grouped(gains, member, chosen.copy())
        if not clashes or not finished or nodes <= 0 or bound + best.gain.sum() >= cut or watch.stopped():
            return best
        merged = label
        while (merged == label).all():
            merged = _joined(label, clashes[: max(1, len(clashes) // 2)], most)
            most += 1
        label = merged


def decode(dual: Dual, seed: int) -> tuple[Indices, float]:
    """A good solution of the problem behind a dual, by greedy insertion and coordinate descent, and its cost."""
    generator = np.random.default_rng(seed)
    best, chosen = np.inf, np.zeros(len(dual.theta), dtype=np.int64)
    for _ in range(4):
        order = generator.permutation(len(dual.theta))
        new = np.full(len(dual.theta), -1)
        for _pass in range(8):
            before = new.copy()
            for variable in order:
                new[variable] = _conditional(dual, variable, new).argmin()
            if (new == before).all():
                break
        cost = dual.cost(new)
        if cost < best:
            best, chosen = cost, new
    return chosen, best


def _conditional(dual: Dual, variable: int, chosen: Indices) -> Floats:
    """Original costs of a variable's entries against the others as chosen (-1: not yet)."""
    costs = dual.unary[variable].copy()
    for edge, side in dual.near[variable]:
        other = chosen[edge.ends[1 - side]]
        if other >= 0:
            edge.add_against(side, int(other), costs)
    return costs


def _disagreements(dual: Dual, chosen: Indices, tolerance: float) -> list[tuple[float, int, int]]:
    """Tables in which the chosen entries cost more than the least, worst first."""
    found = []
    for edge in dual.edges:
        a, b = edge.ends
        price = edge.at(int(chosen[a]), int(chosen[b])) - edge.least()
        if price > tolerance:
            found.append((float(price), a, b))
    return sorted(found, reverse=True)


def _joined(label: Indices, clashes: list[tuple[float, int, int]], most: int) -> Indices:
    """Merge the groups of clashing variables, worst clash first, while they have `most` members at most."""
    label = label.copy()
    for _, a, b in clashes:
        both = (label == label[a]) | (label == label[b])
        if both.sum() <= most:
            label[both] = label[a]
    return label


def _groups(label: Indices) -> list[tuple[int, ...]]:
    """Groups of two variables or more."""
    found = [tuple(np.flatnonzero(label == each).tolist()) for each in np.flatnonzero(np.bincount(label))]
    return [each for each in found if len(each) > 1]


def _apart(member: Indices, clash: tuple[float, int, int]) -> bool:
    return bool(member[clash[1]] < 0 or member[clash[1]] != member[clash[2]])


def _least(dual: Dual, group: tuple[int, ...]) -> float:
    """Pairwise bound of a group under the dual's costs."""
    inside = set(group)
    total = sum(float(dual.theta[each].min()) for each in group)
    return total + sum(edge.least() for edge in dual.edges if inside.issuperset(edge.ends))


def _solve(
    dual: Dual,
    group: tuple[int, ...],
    least: float,
    slack: float,
    chosen: Indices,
    watch: Watch,
    nodes: int,
) -> tuple[Found, int]:
    """Search a group below its pairwise bound plus the slack."""
    inside = set(group)
    known = sum(float(dual.theta[each][chosen[each]]) for each in group) + sum(
        edge.at(int(chosen[edge.ends[0]]), int(chosen[edge.ends[1]]))
        for edge in dual.edges
        if inside.issuperset(edge.ends)
    )
    gap = min(slack, known - least) + TINY
    if known - least <= TINY:
        return Found(least, known, {each: int(chosen[each]) for each in group}), 0
    # Only what the group alone proves may rule out its entries: groups must not count a cost twice.
    alive = [each <= gap for each in dual.inner_excess(group)]
    if sum(int(each.sum()) for each in alive) > LARGEST or not all(each.any() for each in alive):
        return Found(least, np.inf, {}), 0
    search = Search(watch, nodes)
    part = group_part(dual, group, alive)
    found = search.deepen(part, least + gap, gap)
    if found.bound < least + gap - TINY and not np.isfinite(found.cost) and not watch.stopped():
        found = _by_program(group_part(dual, group, alive), found, least + gap, watch)
    return Found(min(found.bound, least + gap), found.cost, found.chosen), search.nodes


def _by_program(part: Part, found: Found, cut: float, watch: Watch) -> Found:
    """What HiGHS makes of a small group that the search gave up, if it is any better."""
    if len(part.costs) > PROGRAM:
        return found
    from usdrigui.solve import highs

    part.settle()
    for _ in range(SWEEPS):
        part.sweep()
    other = highs.solve_part(part, cut, watch, PROGRAM_NODES)
    return found if other is None or other.bound <= found.bound else other


def group_part(dual: Dual, group: tuple[int, ...], alive: list[Flags]) -> Part:
    """The problem of a group under the dual's costs, over the entries alive."""
    place = {variable: at for at, variable in enumerate(group)}
    kept = [np.flatnonzero(each) for each in alive]
    start = np.concatenate([[0], np.cumsum([len(each) for each in kept])])
    matrix = np.zeros((start[-1], start[-1]))
    for edge in dual.edges:
        if edge.ends[0] in place and edge.ends[1] in place:
            a, b = place[edge.ends[0]], place[edge.ends[1]]
            matrix[start[a] : start[a + 1], start[b] : start[b + 1]] = edge.block(kept[a], kept[b])
    costs = np.concatenate([dual.theta[variable][each] for variable, each in zip(group, kept, strict=True)])
    owner = np.repeat(np.arange(len(group)), [len(each) for each in kept])
    return Part(np.array(group), owner, np.concatenate(kept), costs, matrix)
