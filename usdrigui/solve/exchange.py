"""A `LayoutProblem` as one npz file, so that a case can be handed to another solver.

Plain arrays, no pickled objects; ``numpy.load(path)`` reads them without this package:

    version              () 3
    names                (variables,) text
    overlap              (5,) maximum, radius, sharpness, reach, weight
    separation, unit_cost, off_face_cost
                         (), (), (variables,)
    points_K, cost_K     (R,) of variable K: anchor points and linear costs
    displacement_K       (R,) displacement, contained in the linear costs
    samples_K            (R, copies, u, 3)
    handles_K            (R, copies, 3)
    states_K             (s,) states of the layout in which variable K is visible
    extra                (pairs, 2) variables of each set of explicit pair costs
    extra_labels_K       (q, 2) labels of set K
    extra_costs_K        (q,)

The cost of a layout is defined at `usdrigui.model.LayoutProblem`; lengths are in scene units.
"""

from __future__ import annotations

import zipfile
from dataclasses import astuple
from pathlib import Path

import numpy as np

from usdrigui.errors import refuse
from usdrigui.model import ExtraPairs, LayoutProblem, Overlap, Variable

VERSION = 3


def save_problem(path: Path, problem: LayoutProblem) -> None:
    """Write a problem; the same problem gives the same bytes."""
    ends = [(each.first, each.second) for each in problem.extra]
    arrays: dict[str, np.ndarray] = {
        "version": np.array(VERSION),
        "names": np.array([each.name for each in problem.variables], dtype=np.str_),
        "overlap": np.array(astuple(problem.overlap)),
        "separation": np.array(problem.separation),
        "unit_cost": np.array(problem.unit_cost),
        "off_face_cost": np.array([float(each.off_face_cost) for each in problem.variables]),
        "extra": np.array(ends, dtype=np.int64).reshape(-1, 2),
    }
    for at, variable in enumerate(problem.variables):
        for name in _PER_VARIABLE:
            arrays[f"{name}_{at}"] = getattr(variable, name)
        arrays[f"states_{at}"] = np.array(sorted(variable.states), dtype=np.int64)
    for at, extra in enumerate(problem.extra):
        arrays[f"extra_labels_{at}"] = np.column_stack([extra.first_labels, extra.second_labels])
        arrays[f"extra_costs_{at}"] = extra.costs
    with path.open("wb") as stream:
        np.savez_compressed(stream, allow_pickle=False, **arrays)


def load_problem(path: Path) -> LayoutProblem:
    """Read a problem written by `save_problem`.  Raises FILE_NOT_FOUND or PROBLEM_FILE."""
    try:
        with np.load(path, allow_pickle=False) as arrays:
            if int(arrays["version"]) != VERSION:
                message = f"is of version {int(arrays['version'])}, not {VERSION}"
                raise refuse("PROBLEM_FILE", str(path), message)
            return _problem(arrays)
    except OSError as error:
        message = f"cannot be read: {error.strerror or error}"
        raise refuse("FILE_NOT_FOUND", str(path), message) from error
    except (KeyError, ValueError, TypeError, EOFError, zipfile.BadZipFile) as error:
        raise refuse("PROBLEM_FILE", str(path), f"is no layout problem: {error}") from error


_PER_VARIABLE = ("points", "cost", "samples", "handles", "displacement")


def _problem(arrays: np.lib.npyio.NpzFile) -> LayoutProblem:
    variables = tuple(
        Variable(
            name=str(name),
            off_face_cost=float(cost),
            states=frozenset(arrays[f"states_{at}"].tolist()),
            **{key: arrays[f"{key}_{at}"] for key in _PER_VARIABLE},
        )
        for at, (name, cost) in enumerate(
            zip(arrays["names"], arrays["off_face_cost"], strict=True)
        )
    )
    extra = tuple(
        ExtraPairs(
            first=int(a),
            second=int(b),
            first_labels=arrays[f"extra_labels_{at}"][:, 0].copy(),
            second_labels=arrays[f"extra_labels_{at}"][:, 1].copy(),
            costs=arrays[f"extra_costs_{at}"],
        )
        for at, (a, b) in enumerate(arrays["extra"])
    )
    _check_extra(variables, extra)
    overlap = Overlap(*arrays["overlap"].tolist())
    return LayoutProblem(
        variables, overlap, float(arrays["separation"]), float(arrays["unit_cost"]), extra
    )


def _check_extra(variables: tuple[Variable, ...], extra: tuple[ExtraPairs, ...]) -> None:
    """Raises ValueError when explicit costs speak of no two variables, of no candidates (the board
    has no pair costs), are negative, or speak of the same pair twice."""
    for each in extra:
        if not 0 <= each.first < each.second < len(variables):
            raise ValueError(f"explicit costs between variables {each.first} and {each.second}")
        sizes = [len(variables[at].cost) for at in (each.first, each.second)]
        labels = np.column_stack([each.first_labels, each.second_labels])
        if ((labels < 0) | (labels >= sizes)).any():
            raise ValueError("explicit costs of labels that a variable does not have")
        if not (each.costs >= 0).all():
            raise ValueError("explicit costs below zero")
        if len(np.unique(labels, axis=0)) < len(labels):
            raise ValueError("two explicit costs of one pair of labels")
