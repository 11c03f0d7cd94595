"""One command, one table: our solver beside the paper's pipeline, raw McCormick, toulbar2 and
CPLEX.

    python benchmarks/solve.py [--cases WORD...] [--methods WORD...] [--seconds 120] [--assets DIR]
    [--json FILE]

``--methods ours`` alone prints the solver's own figures: gap, processor seconds, memory, and the
processor seconds after which a layout within a thousandth of the final cost was there (``.1 %
at``).

Cases: the sample and the real rigs, folded (symmetric pairs once), unfolded and with other
settings; a head of 100 K points made from ict_face57 by subdivision; face-like problems at the
sizes of the paper's Table 1, crowded ones, such of 300 and 500 controls, and heads that have
visemes alone. Methods: ``ours``; the paper's pipeline at 20, 5 and 1 % of the candidates; HiGHS on
the program of the whole problem; toulbar2 on what our reduction leaves; CPLEX's integer quadratic
program, as far as its free size goes. The paper's pipeline solves its clusters by our solver or, as
``paper 5% cplex`` and as the paper did, by CPLEX's integer quadratic program.

Every run is a process of its own: wall and processor seconds of the solve alone, peak memory of the
process.  Every method first solves a small problem, so that loading its packages does not count.
Gaps of methods that prove no bound of the whole problem are against our bound.  ``cost +`` is how
much a cost lies above ours, ``time x`` the processor time over ours, ``ours ... s`` the processor
time after which we had a layout at least as good.
"""

from __future__ import annotations

import argparse
import json
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from instances import CROWDED, TABLE_1, face_like, subdivided, viseme_like
from problem_file import load_problem, save_problem

from usdrigui.character import Floats
from usdrigui.errors import RigUIError
from usdrigui.model import Assignment, Element, LayoutProblem
from usdrigui.overlap import total_cost
from usdrigui.settings import Settings, SolveSettings, load
from usdrigui.solve import solve
from usdrigui.solve.assignment import assignment
from usdrigui.solve.budget import Budget
from usdrigui.solve.exact import infeasible_penalty
from usdrigui.solve.label_geometry import LabelSet, all_labels
from usdrigui.solve.milp import solve_milp
from usdrigui.solve.pair_costs import pair_costs
from usdrigui.solve.paper import solve_by_clusters
from usdrigui.solve.reduced_problem import PlainProblem

ASSETS = Path(__file__).resolve().parents[2] / "shared" / "assets"
SAMPLE = Path(__file__).resolve().parents[1] / "sample_assets" / "char.usda"
WAYS: dict[str, dict[str, Any]] = {
    "folded": {"symmetry": {"fold": True}},
    "unfolded": {"symmetry": {"fold": False}},
    "ungrouped": {"groups": {"opposed": False}},
    "ungrouped unfolded": {"groups": {"opposed": False}, "symmetry": {"fold": False}},
    "wide": {"objective": {"handle_size": 0.03}},
    "soft": {"objective": {"overlap_sharpness": 3.0, "separation": False}},
    "flat": {"objective": {"displacement_weight": 0.7}},
}
"""Settings that real rigs are solved with: the default, and some that leave more to the solver."""
MANY = (300, 500)
"""Controls of made problems on 20 000 points."""
VISEMES = ((5_000, 6), (5_000, 10), (5_000, 14), (20_000, 14))
"""Points and controls of heads that have visemes alone."""
METHODS = (
    "ours",
    "paper 20%",
    "paper 5%",
    "paper 5% cplex",
    "paper 1%",
    "mccormick",
    "toulbar2",
    "cplex",
)
FREE_CPLEX = 1000
"""Variables and constraints of CPLEX's free size."""
FEW = 5000
"""Candidates of which all pairs are written down."""
SAME = 1e-6
"""Costs that differ by no more are of equally good layouts."""
SMALL = (500, 12)
"""Points and controls of the problem that is solved before the clock starts."""
UNLIMITED = 10**15
"""Work allowed where time is what limits a run."""


class CannotRunError(Exception):
    """A method is not installed, or does not hold a problem."""


def main() -> None:
    arguments = _arguments()
    if arguments.one:
        print(json.dumps(run_one(Path(arguments.one[0]), arguments.one[1], arguments.seconds)))
        return
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name, path in cases(Path(folder), arguments.assets, arguments.cases):
            ours: dict[str, Any] = {}
            for method in arguments.methods:
                row = {"case": name, "method": method} | _in_a_process(
                    path, method, arguments.seconds
                )
                ours = row if method == "ours" and "cost" in row else ours
                rows.append(_compared(row, ours))
                print(_line(rows[-1]), flush=True)
    if arguments.json:
        Path(arguments.json).write_text(json.dumps(rows, indent=1))


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--cases", nargs="*", default=[], help="only cases whose names hold one of these words"
    )
    parser.add_argument("--methods", nargs="*", default=list(METHODS), choices=METHODS)
    parser.add_argument(
        "--seconds", type=float, default=120.0, help="wall-clock limit of every run"
    )
    parser.add_argument("--assets", type=Path, default=ASSETS)
    parser.add_argument("--json", help="write the rows to this file as well")
    parser.add_argument("--one", nargs=2, metavar=("PROBLEM", "METHOD"), help=argparse.SUPPRESS)
    return parser.parse_args()


# --- cases ----------------------------------------------------------------------------------------


def cases(folder: Path, assets: Path, words: list[str]) -> Any:
    """Names of the cases wanted and the files of their problems, made one at a time; a rig has a
    problem for each of its parts."""
    for rig in (SAMPLE, *sorted(assets.glob("*.usd?"))):
        for way, settings in WAYS.items():
            name = f"{rig.stem} {way}"
            if _wanted(name, words):
                for part, problem in _part_problems(rig, load(settings)):
                    yield f"{name} {part}", _saved(folder, problem)
    name, head = "ict_face57 100K", assets / "ict_face57.usdc"
    if _wanted(name, words) and head.exists():
        yield name, _saved(folder, _finer_problem(head))
    for model, (points, controls) in TABLE_1.items():
        name = f"{model} {points}/{controls}"
        if _wanted(name, words):
            yield name, _saved(folder, face_like(points, controls))
    for points, controls in TABLE_1.values():
        name = f"crowded {points}/{controls}"
        if _wanted(name, words):
            yield name, _saved(folder, face_like(points, controls, scatter=CROWDED))
    for controls in MANY:
        name = f"made 20000/{controls}"
        if _wanted(name, words):
            yield name, _saved(folder, face_like(20_000, controls))
    for points, controls in VISEMES:
        name = f"visemes {points}/{controls}"
        if _wanted(name, words):
            yield name, _saved(folder, viseme_like(points, controls))


def _wanted(name: str, words: list[str]) -> bool:
    return not words or any(word in name for word in words)


def _part_problems(asset: Path, settings: Settings) -> Iterator[tuple[str, LayoutProblem]]:
    """Names and problems of a rig's parts as a layout of the rig has them: each among the elements
    of those before."""
    from usdrigui.pipeline.stages import character_of, layout_of, part_problem
    from usdrigui.reader.reader_process import read_rigs_isolated

    character = character_of(read_rigs_isolated(asset, settings).rigs[0], settings)
    elements: tuple[Element, ...] = ()
    for part in character.parts:
        inputs = part_problem(character, part, elements)
        yield part.name, inputs.placement.problem
        if part is not character.parts[-1]:
            found = solve(inputs.placement.problem, settings.solve)
            elements += tuple(layout_of(inputs, found).elements)


def _finer_problem(asset: Path) -> LayoutProblem:
    from usdrigui.pipeline import build_problem
    from usdrigui.reader.reader_process import read_rigs_isolated

    settings = load({"symmetry": {"fold": True}})
    rig = subdivided(read_rigs_isolated(asset, settings).rigs[0])
    return build_problem(rig, settings).placement.problem


def _saved(folder: Path, problem: LayoutProblem) -> Path:
    path = folder / "problem.npz"
    save_problem(path, problem)
    return path


# --- runs -----------------------------------------------------------------------------------------


def _in_a_process(path: Path, method: str, seconds: float) -> dict[str, Any]:
    command = [sys.executable, __file__, "--one", str(path), method, "--seconds", str(seconds)]
    try:
        run = subprocess.run(
            command, capture_output=True, text=True, check=False, timeout=3 * seconds + 60
        )
    except subprocess.TimeoutExpired:
        return {"note": "did not stop in time"}
    if run.returncode:
        return {"note": (run.stderr.strip().splitlines() or ["died"])[-1][:100]}
    found: dict[str, Any] = json.loads(run.stdout.strip().splitlines()[-1])
    return found


def run_one(path: Path, method: str, seconds: float) -> dict[str, Any]:
    """Solve a saved problem by one method; figures for the table."""
    problem = load_problem(path)
    size = {
        "variables": len(problem.variables),
        "candidates": sum(len(each.cost) for each in problem.variables),
    }
    _solved(face_like(*SMALL), method, seconds)
    wall, processor = time.monotonic(), time.process_time()
    found = _solved(problem, method, seconds)
    measured = {
        "seconds": time.monotonic() - wall,
        "processor": time.process_time() - processor,
        "memory": _peak(),
    }
    return size | found | measured


def _solved(problem: LayoutProblem, method: str, seconds: float) -> dict[str, Any]:
    try:
        return _SOLVERS[method.split()[0]](problem, method, seconds)
    except RigUIError as error:
        return {"note": f"{error.issue.code}: {error.issue.message}"}
    except CannotRunError as error:
        return {"note": str(error)}


def _peak() -> float:
    """Peak MiB of this process.  What getrusage tells includes, on Linux, the process that started
    it."""
    status = Path("/proc/self/status")
    if status.exists():
        return float(status.read_text().split("VmHWM:")[1].split()[0]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def _ours(problem: LayoutProblem, method: str, seconds: float) -> dict[str, Any]:
    del method
    return _by_us(problem, SolveSettings(time_limit=seconds))


def _paper(problem: LayoutProblem, method: str, seconds: float) -> dict[str, Any]:
    """Two clusters, a sample of their candidates; each solved by us or, as the paper did, by
    CPLEX."""
    share = float(method.split()[1].rstrip("%")) / 100
    settings = SolveSettings(
        method="paper", clusters=2, sample=share, time_limit=seconds, work_limit=UNLIMITED
    )
    if not method.endswith("cplex"):
        return _by_us(problem, settings) | {"bound": None}
    found = solve_by_clusters(problem, Budget(settings), _integer_quadratic)
    return {"cost": found.cost, "bound": None, "note": found.status}


def _toulbar2(problem: LayoutProblem, method: str, seconds: float) -> dict[str, Any]:
    from toulbar2 import in_the_turn_of_highs

    del method
    with in_the_turn_of_highs():
        found = _by_us(problem, SolveSettings(time_limit=seconds, memory_limit=4096))
    return found | {"note": found["note"].replace("highs", "toulbar2")}


def _by_us(problem: LayoutProblem, settings: SolveSettings) -> dict[str, Any]:
    layouts: list[tuple[float, float]] = []
    began = time.process_time()
    found = solve(
        problem, settings, lambda each: layouts.append((time.process_time() - began, each.cost))
    )
    enough = found.cost + 1e-3 * abs(found.cost)
    return {
        "cost": found.cost,
        "bound": found.bound,
        "note": f"{found.status}, {found.closed_by}",
        "layouts": layouts,
        "first": next((at for at, cost in layouts if cost <= enough), None),
    }


def _mccormick(problem: LayoutProblem, method: str, seconds: float) -> dict[str, Any]:
    """HiGHS on the program of the whole problem: no reduction."""
    del method
    budget = Budget(SolveSettings(time_limit=seconds, work_limit=UNLIMITED))
    labels = all_labels(problem)
    if len(labels.cost) > FEW:
        return {"note": f"{len(labels.cost)} candidates: too large to write down"}
    pairs, penalty = _written_down(problem, labels, budget)
    whole = PlainProblem(labels.start, labels.cost, pairs + pairs.T)
    found = solve_milp(whole, float(labels.best.sum()) + penalty - 1e-6, budget)
    cost = None if found.chosen is None else total_cost(problem, labels.candidate[found.chosen])
    return {"cost": cost, "bound": found.bound}


def _cplex(problem: LayoutProblem, method: str, seconds: float) -> dict[str, Any]:
    """CPLEX's integer quadratic program over all candidates, hard pairs at a cost."""
    del method
    found = _integer_quadratic(problem, Budget(SolveSettings(time_limit=seconds)))
    return {"cost": found.cost, "bound": found.bound}


def _integer_quadratic(problem: LayoutProblem, budget: Budget) -> Assignment:
    """A problem's best layout by CPLEX, within the budget's time; raises CannotRunError."""
    try:
        import cplex
    except ImportError as error:
        raise CannotRunError("cplex is not installed") from error

    labels = all_labels(problem)
    if len(labels.cost) + len(problem.variables) > FREE_CPLEX:
        raise CannotRunError(f"{len(labels.cost)} candidates: beyond the free size")
    pairs, penalty = _written_down(problem, labels, budget)
    program = cplex.Cplex()
    program.set_results_stream(None)
    program.set_log_stream(None)
    program.set_warning_stream(None)
    program.parameters.threads.set(1)
    program.parameters.timelimit.set(budget.seconds_left)
    program.parameters.mip.tolerances.mipgap.set(1e-4)
    program.variables.add(obj=labels.cost.tolist(), types="B" * len(labels.cost))
    for a, b in zip(labels.start[:-1].tolist(), labels.start[1:].tolist(), strict=True):
        program.linear_constraints.add(
            [[list(range(a, b)), [1.0] * (b - a)]], senses="E", rhs=[1.0]
        )
    rows, columns = np.nonzero(pairs)
    costs = np.minimum(pairs[rows, columns], penalty)
    terms = list(zip(rows.tolist(), columns.tolist(), costs.tolist(), strict=True))
    program.objective.set_quadratic_coefficients(terms)
    program.solve()
    values = np.array(program.solution.get_values())
    chosen = np.array(
        [a + values[a:b].argmax() for a, b in zip(labels.start[:-1], labels.start[1:], strict=True)]
    )
    budget.found("cplex", bound=program.solution.MIP.get_best_objective())
    return assignment(problem, labels, labels.candidate[chosen], budget, "cplex")


def _written_down(problem: LayoutProblem, labels: LabelSet, budget: Budget) -> tuple[Floats, float]:
    """The costs of all pairs of labels, and what stands for a pair that is forbidden."""
    pairs = pair_costs(problem, labels, budget)
    assert pairs is not None
    return pairs.toarray(), infeasible_penalty(problem, labels)


_SOLVERS = {
    "ours": _ours,
    "paper": _paper,
    "mccormick": _mccormick,
    "toulbar2": _toulbar2,
    "cplex": _cplex,
}


# --- table ----------------------------------------------------------------------------------------


def _compared(row: dict[str, Any], ours: dict[str, Any]) -> dict[str, Any]:
    """The row with its gap and its ratios to ours."""
    if row.get("cost") is None:
        return row
    bound = row["bound"] if row.get("bound") is not None else ours.get("bound")
    if bound is not None:
        row["gap"] = max(0.0, row["cost"] - bound) / max(abs(row["cost"]), 1e-12)
    if ours and row is not ours:
        row["cost above ours"] = (row["cost"] - ours["cost"]) / abs(ours["cost"])
        row["time over ours"] = row["processor"] / max(ours["processor"], 1e-3)
        row["as good after"] = next(
            (at for at, cost in ours["layouts"] if cost <= row["cost"] + SAME), None
        )
    return row


def _line(row: dict[str, Any]) -> str:
    def show(key: str, form: str) -> str:
        return form.format(row[key]) if row.get(key) is not None else "-"

    cells = (
        row["case"].ljust(28),
        row["method"].ljust(14),
        show("variables", "{:d}").rjust(4),
        show("candidates", "{:d}").rjust(7),
        show("cost", "{:.5f}").rjust(11),
        show("bound", "{:.5f}").rjust(11),
        show("gap", "{:.1e}").rjust(8),
        show("seconds", "{:.1f} s").rjust(8),
        show("processor", "{:.1f} s").rjust(8),
        show("memory", "{:.0f} MB").rjust(8),
        show("first", ".1 % at {:.2f} s").rjust(15),
        show("cost above ours", "cost {:+.2%}").rjust(12),
        show("time over ours", "time x{:.2f}").rjust(11),
        show("as good after", "ours {:.2f} s").rjust(12),
        str(row.get("note", "")),
    )
    return " ".join(cells)


if __name__ == "__main__":
    main()
