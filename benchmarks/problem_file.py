"""A `LayoutProblem` as one npz file, so that a case can be handed to another process or solver.

Plain arrays, no pickled objects; ``numpy.load(path)`` reads them without usdrigui:

    version              () 4
    names                (variables,) text
    overlap              the fields of `usdrigui.model.Overlap` (12,) or `MeanOverlap` (5,)
    separation, off_face_cost
                         (), (variables,)
    points_K, cost_K     (R,) of variable K: anchor points and linear costs
    displacement_K       (R,) displacement, contained in the linear costs
    samples_K            (R, copies, u, d): d is 2 for `Overlap`, on the screen, and 3 in the scene
    handles_K            (R, copies, d)
    states_K             (s,) states of the layout in which variable K is visible
    extra                (pairs, 2) variables of each set of explicit pair costs
    extra_labels_K       (q, 2) labels of set K
    extra_costs_K        (q,)

The cost of a layout is defined at `usdrigui.model.LayoutProblem`; lengths are in scene units.
"""

from __future__ import annotations

from dataclasses import astuple, fields
from pathlib import Path

import numpy as np

from usdrigui.model import ExtraPairs, LayoutProblem, MeanOverlap, Overlap, Variable

VERSION = 4
PER_VARIABLE = ("points", "cost", "samples", "handles", "displacement")


def save_problem(path: Path, problem: LayoutProblem) -> None:
    """Write a problem; the same problem gives the same bytes."""
    ends = [(each.first, each.second) for each in problem.extra]
    arrays: dict[str, np.ndarray] = {
        "version": np.array(VERSION),
        "names": np.array([each.name for each in problem.variables], dtype=np.str_),
        "overlap": np.array(astuple(problem.overlap)),
        "separation": np.array(problem.separation),
        "off_face_cost": np.array([float(each.off_face_cost) for each in problem.variables]),
        "extra": np.array(ends, dtype=np.int64).reshape(-1, 2),
    }
    for at, variable in enumerate(problem.variables):
        for name in PER_VARIABLE:
            arrays[f"{name}_{at}"] = getattr(variable, name)
        arrays[f"states_{at}"] = np.array(sorted(variable.states), dtype=np.int64)
    for at, extra in enumerate(problem.extra):
        arrays[f"extra_labels_{at}"] = np.column_stack([extra.first_labels, extra.second_labels])
        arrays[f"extra_costs_{at}"] = extra.costs
    with path.open("wb") as stream:
        np.savez_compressed(stream, allow_pickle=False, **arrays)


def load_problem(path: Path) -> LayoutProblem:
    """Read a problem written by `save_problem`.  Raises ValueError for another version's."""
    with np.load(path, allow_pickle=False) as arrays:
        if int(arrays["version"]) != VERSION:
            raise ValueError(f"{path} is of version {int(arrays['version'])}, not {VERSION}")
        return _problem(arrays)


def _problem(arrays: np.lib.npyio.NpzFile) -> LayoutProblem:
    variables = tuple(
        Variable(
            name=str(name),
            off_face_cost=float(cost),
            states=frozenset(arrays[f"states_{at}"].tolist()),
            **{key: arrays[f"{key}_{at}"] for key in PER_VARIABLE},
        )
        for at, (name, cost) in enumerate(
            zip(arrays["names"], arrays["off_face_cost"], strict=True)
        )
    )
    extra = tuple(
        ExtraPairs(int(a), int(b), *arrays[f"extra_labels_{at}"].T, arrays[f"extra_costs_{at}"])
        for at, (a, b) in enumerate(arrays["extra"])
    )
    numbers = arrays["overlap"].tolist()
    is_mean = len(numbers) == len(fields(MeanOverlap))
    overlap = MeanOverlap(*numbers) if is_mean else Overlap(int(numbers[0]), *numbers[1:])
    return LayoutProblem(variables, overlap, float(arrays["separation"]), extra)
