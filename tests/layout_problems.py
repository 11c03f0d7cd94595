"""Random layout problems, small enough to be enumerated, for the tests of the solvers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from usdrigui.model import AnyOverlap, ExtraPairs, LayoutProblem, MeanOverlap, Overlap, Variable


def random_problem(seed: int, variables: int = 5, candidates: int = 7) -> LayoutProblem:
    """Elements thrown into a box a few handle widths wide: copies, ties, endless reach, explicit costs.

    Every third is spaced by the paper's mean distance, the others as seen, on a screen, where handles of every other
    one may be behind each other, and in the scene.
    """
    generator = np.random.default_rng(seed)
    size = generator.uniform(0.5, 4.0)
    count = int(generator.integers(1, variables + 1))
    axes = (3, 2, 3)[seed % 3]
    elements = tuple(_element(generator, at, size, candidates, axes) for at in range(count))
    overlap: AnyOverlap = MeanOverlap(5.0, 1.0, 4.0, float(generator.choice([3.0, np.inf])), 0.15)
    if seed % 3:
        overlap = Overlap(3, 1.0, *generator.uniform(0.1, [1, 2, 0.3, 3, 0.5, 0.7, 0.5, 0.5, 0.5, 0.5]))
    if seed % 6 == 1:
        elements = tuple(_in_depth(generator, each, size) for each in elements)
    separation = float(generator.choice([1e-6, 0.5, 1.0]))
    return LayoutProblem(elements, overlap, separation, _explicit(generator, elements))


def _element(generator: np.random.Generator, at: int, size: float, candidates: int, axes: int) -> Variable:
    count, copies = int(generator.integers(1, candidates + 1)), int(generator.integers(1, 3))
    handles = generator.uniform(0, size, (count, copies, axes))
    if generator.random() < 0.3:
        handles = np.round(handles)
    tracks = [np.linspace(0, 1, 3)[:, None] * generator.normal(0, 0.5, (count, copies, 1, axes))]
    tracks *= int(generator.integers(1, 3))
    samples = handles[:, :, None] + np.concatenate(tracks, axis=2)
    beside = float(generator.choice([np.inf, -0.2, 0.3]))
    cost = generator.uniform(-1, 0, count)
    return Variable(f"v{at}", np.arange(count), cost, samples, handles, beside, -cost)


def _in_depth(generator: np.random.Generator, flat: Variable, size: float) -> Variable:
    depth = generator.uniform(0, size, (*flat.handles.shape[:2], 1))
    return replace(flat, handles=np.concatenate([flat.handles, depth], axis=2))


def _explicit(generator: np.random.Generator, elements: tuple[Variable, ...]) -> tuple[ExtraPairs, ...]:
    found = []
    for a, one in enumerate(elements):
        for b in range(a + 1, len(elements)):
            if generator.random() < 0.3:
                pairs = len(one.cost) * len(elements[b].cost)
                chosen = generator.choice(pairs, int(generator.integers(1, pairs + 1)), replace=False)
                first, second = np.divmod(chosen, len(elements[b].cost))
                found.append(ExtraPairs(a, b, first, second, generator.uniform(0, 1, len(chosen))))
    return tuple(found)


def at_one_spot(problem: LayoutProblem) -> LayoutProblem:
    """The problem with all candidates at one spot, and none off the face."""
    forced = tuple(
        replace(each, off_face_cost=np.inf, handles=each.handles * 0, samples=each.samples * 0)
        for each in problem.variables
    )
    return replace(problem, variables=forced)


def crowd(seed: int, variables: int = 6, candidates: int = 40) -> LayoutProblem:
    """Elements that all want the same spot of a flat patch: the pairwise bound is not enough."""
    generator = np.random.default_rng(seed)
    elements = []
    for at in range(variables):
        handles = np.zeros((candidates, 1, 3))
        handles[:, 0, :2] = generator.uniform(-2.5, 2.5, (candidates, 2))
        samples = handles[:, :, None] + np.linspace(0, 1, 5)[:, None] * generator.normal(0, 0.3, 3)
        cost = -np.exp(-np.square(handles[:, 0]).sum(axis=-1) / 8) * generator.uniform(0.8, 1.2)
        elements.append(Variable(f"v{at}", np.arange(candidates), cost, samples, handles, 0.3, -cost))
    return LayoutProblem(tuple(elements), MeanOverlap(5.0, 1.0, 4.0, 3.0, 0.15), 1.0)


def renumbered(problem: LayoutProblem, seed: int) -> LayoutProblem:
    """The same problem with its variables and their candidates in another order."""
    generator = np.random.default_rng(seed)
    order = generator.permutation(len(problem.variables))
    labels = [generator.permutation(len(each.cost)) for each in problem.variables]
    variables = tuple(
        replace(
            problem.variables[at],
            points=problem.variables[at].points[labels[at]],
            cost=problem.variables[at].cost[labels[at]],
            samples=problem.variables[at].samples[labels[at]],
            handles=problem.variables[at].handles[labels[at]],
            displacement=problem.variables[at].displacement[labels[at]],
        )
        for at in order
    )
    place, new = np.argsort(order), [np.argsort(each) for each in labels]
    extra = []
    for each in problem.extra:
        ends = sorted(
            [
                (int(place[each.first]), new[each.first][each.first_labels]),
                (int(place[each.second]), new[each.second][each.second_labels]),
            ],
            key=lambda end: end[0],
        )
        extra.append(ExtraPairs(ends[0][0], ends[1][0], ends[0][1], ends[1][1], each.costs))
    return replace(problem, variables=variables, extra=tuple(extra))
