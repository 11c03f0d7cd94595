"""Rows that four variables at a time add to the linear program of what bounds leave.

Four elements that want three spots cost something, whichever way they stand; pairs that each stand
half here and half there do not.  What four variables cost together is at least the sum of one
amount for each, as long as no four labels have amounts above what they cost.  The amounts that
exceed most what the program pays are the duals of a transport between the four whose masses are the
shares of their labels (D. Sontag and T. Jaakkola, "New outer bounds on the marginal polytope",
2007).  Those of labels without a share are then made as large as they can be, by variable.
"""

from __future__ import annotations

import itertools
import math

import highspy
import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.solve.budget import Budget
from usdrigui.solve.reduced_problem import EPSILON, PlainProblem, Row, least_sums
from usdrigui.solve.triplets import CHEAPEST


class QuietHighs(highspy.Highs):
    """On one thread, and without the banner that subscribing to callbacks prints."""

    def enableCallbacks(self) -> None:  # noqa: N802, D102
        self.setOptionValue("output_flag", False)
        self.setOptionValue("threads", 1)
        super().enableCallbacks()  # type: ignore[no-untyped-call]


def quadruplet_rows(
    problem: PlainProblem,
    together: Indices,
    values: Floats,
    alive: Flags,
    spare: float,
    generator: np.random.Generator,
    budget: Budget,
) -> list[Row]:
    """Rows that the `values` of a program violate, and no layout does that costs less than `spare`
    above its cheapest labels, all of which are `alive` (n,).

    `together` (variables, variables) are the columns of what two variables cost, -1 for nothing.
    """
    pairs, shares = np.minimum(problem.pairs, spare), values[: len(alive)]
    mixed = pairs * shares[:, None] * shares
    for axis in (0, 1):
        mixed = np.add.reduceat(mixed, problem.start[:-1], axis=axis)
    paid = np.where(together < 0, 0.0, values[together])
    transport, found = QuietHighs(), []  # type: ignore[no-untyped-call]
    transport.setOptionValue("presolve", "off")
    for four in _drawn(mixed > paid + EPSILON, generator):
        every = [
            each.start + np.flatnonzero(alive[each])
            for each in map(problem.slices.__getitem__, four)
        ]
        work = math.prod(map(len, every)) // 256
        if work > budget.work_left // 1000:
            continue
        ranked = [each[np.argsort(-shares[each], kind="stable")[:CHEAPEST]] for each in every]
        used = [each[shares[each] > EPSILON] for each in ranked]
        least, amounts = _transported(transport, pairs, used, shares)
        columns = together[tuple(np.array([*itertools.combinations(four, 2)]).T)]
        columns = columns[columns >= 0]
        budget.spend(work + 7 * math.prod(map(len, used)))
        if least > values[columns].sum() + 1e-6:
            found.append(_row(every, _lifted(pairs, every, used, amounts), columns))
    return found


def _drawn(apart: Flags, generator: np.random.Generator) -> list[tuple[int, ...]]:
    """Quadruplets of a variable and three that it is `apart` from, as many as there are such pairs:
    mixed at random, two that are apart would cost more than the program pays."""
    found = set()
    first = np.repeat(np.arange(len(apart)), apart.sum(axis=1) // 2 * (apart.sum(axis=1) >= 3))
    for one in first.tolist():
        others = generator.choice(np.flatnonzero(apart[one]), 3, replace=False)
        found.add(tuple(sorted((one, *others.tolist()))))
    return sorted(found)


def _transported(
    highs: highspy.Highs, pairs: Floats, labels: list[Indices], shares: Floats
) -> tuple[float, list[Floats]]:
    """Least cost of layouts of four variables, mixed in the shares of their labels, and what each
    label adds to it."""
    sizes = [*map(len, labels)]
    costs = np.zeros(sizes)
    for (a, one), (b, other) in itertools.combinations(enumerate(labels), 2):
        costs += np.expand_dims(pairs[np.ix_(one, other)], tuple({0, 1, 2, 3} - {a, b}))
    first = np.cumsum([0, *sizes])
    model = highspy.HighsLp()
    model.num_col_, model.num_row_ = costs.size, int(first[-1])
    model.col_cost_, model.col_lower_ = costs.ravel(), np.zeros(costs.size)
    model.col_upper_ = np.full(costs.size, np.inf)
    model.row_lower_ = model.row_upper_ = np.concatenate(
        [shares[each] / shares[each].sum() for each in labels]
    )
    rows = np.indices(sizes).reshape(4, -1).T + first[:-1]
    model.a_matrix_.format_ = highspy.MatrixFormat.kColwise
    model.a_matrix_.start_ = np.arange(0, rows.size + 1, 4, dtype=np.int32)
    model.a_matrix_.index_ = rows.ravel().astype(np.int32)
    model.a_matrix_.value_ = np.ones(rows.size)
    highs.passModel(model)
    highs.run()
    duals = np.array(highs.getSolution().row_dual)
    return highs.getInfo().objective_function_value, np.split(duals, first[1:-1])


def _lifted(
    pairs: Floats, every: list[Indices], used: list[Indices], amounts: list[Floats]
) -> list[Floats]:
    """Amounts of all labels of four variables, from those of the labels used: of one variable after
    another the largest that no four labels exceed."""
    labels, amounts = [*used], [*amounts]
    for at in np.argsort([*map(len, every)], kind="stable").tolist():
        labels[at] = every[at]
        b, c, d = sorted({0, 1, 2, 3} - {at}, key=lambda each: len(labels[each]))
        ab, ac, ad, bc, bd, cd = (
            pairs[np.ix_(labels[one], labels[other])]
            for one, other in itertools.combinations((at, b, c, d), 2)
        )
        with_d = (bd[:, None] + cd).reshape(-1, len(labels[d]))
        least = least_sums(ad - amounts[d], with_d).reshape(len(ad), *bc.shape)
        least += ab[:, :, None] + ac[:, None] + (bc - amounts[b][:, None] - amounts[c])
        amounts[at] = least.min(axis=(1, 2))
    return amounts


def _row(labels: list[Indices], amounts: list[Floats], columns: Indices) -> Row:
    """What the columns cost is at least the sum of the amounts, each told from the middle one of
    its variable, which most labels have."""
    middle = [float(np.median(each)) for each in amounts]
    less = np.concatenate([m - each for m, each in zip(middle, amounts, strict=True)])
    less[np.abs(less) <= EPSILON] = 0.0
    every = np.concatenate([*labels, columns])
    values = np.concatenate([less, np.ones(len(columns))])
    used = np.flatnonzero(values)
    return Row(every[used], values[used], sum(middle), np.inf)
