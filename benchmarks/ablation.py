"""What each part of the objective and each reduction is good for: one table and one picture grid
per rig.

    python benchmarks/ablation.py [ASSET ...] [--rows WORD...] [--seconds 60] [--folder DIR]

Up to three assets; without one the sample character.  Every row is printed as soon as it is there;
the folder gets ``ablation_NAME.csv`` and ``ablation_NAME.md`` (rewritten row by row, so that a run
cut short leaves what it has) and ``ablation_NAME.png``.  The rows follow the figures of Kim & Singh
2021: random, peak only, overlap only, centroid of influence and full (figure 6); lambda 1, 0.85,
0.4 (figure 9); 100, 20, 5, 0.5 % of the candidates (figure 10); 1, 2, 4, 6 clusters by single
linkage, and two by the printed sum (figure 11).  The last rows leave out, halve or double one cost
each of what is seen (decision 127).

All rows choose among the candidates of the full problem, and every cost is the default objective's,
except that handles nearer than a handle's width cost no more than their overlap: ``nearest``
(handle widths) tells of them.  ``bound`` is proven for the default objective, once, by the full
row, and ``above`` the cost's share over it.  ``visible`` is the share of (anchor, view) pairs in
which the view shows the anchor; ``clear`` that of elements in nobody's way; ``kept`` the mean of
every control's arc length at its anchor over its peak; ``beside`` the number of elements that left
the face.  Seconds are of choosing alone.
"""

from __future__ import annotations

import argparse
import csv
import io
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from usdrigui.character import Floats, Indices
from usdrigui.layout.place.problem import placement_problem
from usdrigui.layout.review.legibility import legibility_of
from usdrigui.model import Assignment, Layout, LayoutProblem, Variable
from usdrigui.overlap import total_cost
from usdrigui.pipeline.records import ProblemInputs
from usdrigui.pipeline.stages import build_problem, layout_of
from usdrigui.reader.reader_process import read_rigs_isolated
from usdrigui.settings import SolveSettings, load
from usdrigui.solve import solve
from usdrigui.solve.clusters import Linkage
from usdrigui.view.picture import Wanted, contact_sheet, render

SAMPLE = Path(__file__).resolve().parents[1] / "sample_assets" / "char.usda"
MOST = 3
CELL = (760, 640)

Rule = Callable[[ProblemInputs, SolveSettings], Indices]
"""Chooses one label per variable of the full problem."""


@dataclass(frozen=True)
class Row:
    """One layout and its figures."""

    figure: str
    name: str
    layout: Layout
    cost: float
    bound: float
    seconds: float
    nearest: float
    visible: float
    clear: float
    kept: float
    board: int


def main() -> None:
    arguments = _arguments()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for asset in arguments.assets:
        compare(asset, arguments.rows, arguments.seconds, arguments.folder)


def compare(asset: Path, words: list[str], seconds: float, folder: Path) -> None:
    """Print the rows of one asset as they come, and keep them in the folder as csv, markdown and
    picture."""
    settings = load({"solve": {"time_limit": seconds}})
    inputs = build_problem(read_rigs_isolated(asset, settings).rigs[0], settings)
    print(head(asset.stem), flush=True)
    rows: list[Row] = []
    for row in ablation(inputs, words):
        print(line(row), flush=True)
        rows = sorted([*rows, row], key=lambda each: ORDER.index((each.figure, each.name)))
        (folder / f"ablation_{asset.stem}.csv").write_text(as_csv(rows), encoding="utf-8")
        (folder / f"ablation_{asset.stem}.md").write_text(as_markdown(rows), encoding="utf-8")
    target = folder / f"ablation_{asset.stem}.png"
    picture(inputs, rows).save(target)
    print(target, flush=True)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("assets", nargs="*", type=Path, default=[SAMPLE], help=f"at most {MOST}")
    parser.add_argument(
        "--rows",
        nargs="*",
        default=[],
        help="only rows whose figure or name holds one of these words",
    )
    parser.add_argument("--seconds", type=float, default=60.0, help="limit of every solve")
    parser.add_argument("--folder", type=Path, default=Path(), help="where the pictures go")
    arguments = parser.parse_args()
    if len(arguments.assets) > MOST:
        parser.error(f"at most {MOST} assets, got {len(arguments.assets)}")
    return arguments


def ablation(inputs: ProblemInputs, words: list[str] | None = None) -> Iterator[Row]:
    """The rows of one character as they are made; the full row comes first and always, for its
    bound."""
    limits = inputs.settings.solve
    start = time.perf_counter()
    full = solve(inputs.placement.problem, limits)
    yield _row(inputs, *FULL, full.labels, full.bound, time.perf_counter() - start)
    for figure, name, rule in RULES:
        if words and not any(word in f"figure {figure}: {name}" for word in words):
            continue
        start = time.perf_counter()
        labels = rule(inputs, limits)
        yield _row(inputs, figure, name, labels, full.bound, time.perf_counter() - start)


# --- the rules ------------------------------------------------------------------------------------


def at_random(inputs: ProblemInputs, limits: SolveSettings) -> Indices:
    """Any candidate of each element (figure 6a)."""
    rng = np.random.default_rng(limits.seed)
    return np.array(
        [
            rng.integers(len(each.cost)) if len(each.cost) else -1
            for each in inputs.placement.problem.variables
        ]
    )


def at_centroid(inputs: ProblemInputs, _: SolveSettings) -> Indices:
    """The candidate nearest to the middle of what the element's controls move, arc length times
    area as weight."""
    face = inputs.face
    motions = {each.control: each for each in face.trajectories.motions}
    labels = []
    for choice in inputs.placement.choices:
        moving = [motions[control] for control in choice.controls[0]]
        points = np.concatenate([each.points for each in moving])
        weight = np.concatenate(
            [each.arc_length * face.surface.areas[each.points] for each in moving]
        )
        middle = np.average(face.surface.points[points], axis=0, weights=weight + 1e-30)
        apart = np.linalg.norm(face.surface.points[choice.anchors[:, 0]] - middle, axis=1)
        labels.append(int(apart.argmin()) if len(apart) else -1)
    return np.array(labels)


def by_displacement(inputs: ProblemInputs, _: SolveSettings) -> Indices:
    """The peak of each element, whatever stands there (figure 6b)."""
    return np.array([_least(cost) for cost in displacement_costs(inputs)])


def by_overlap(inputs: ProblemInputs, limits: SolveSettings) -> Indices:
    """As far apart as the candidates allow: no displacement, no occlusion, no cost of the plane
    (figure 6c)."""
    return solve(_on_face(bare_problem(inputs, 0.0)), limits).labels


def by_weight(weight: float) -> Rule:
    """The default objective with another lambda (figure 9)."""

    def rule(inputs: ProblemInputs, limits: SolveSettings) -> Indices:
        return solve(_with_settings(inputs, displacement_weight=weight), limits).labels

    return rule


def scaled(cost: str, factor: float) -> Rule:
    """The default objective with one cost of what is seen left out, halved or doubled."""

    def rule(inputs: ProblemInputs, limits: SolveSettings) -> Indices:
        name = f"{cost}_weight"
        weight = factor * getattr(inputs.settings.objective, name)
        return solve(_with_settings(inputs, **{name: weight}), limits).labels

    return rule


def by_paper(share: float, clusters: int, linkage: Linkage = "single") -> Rule:
    """The paper's reductions: a share of the candidates, clusters in sequence (figures 10 and
    11)."""

    def rule(inputs: ProblemInputs, limits: SolveSettings) -> Indices:
        reduced = replace(limits, method="paper", sample=share, clusters=clusters, linkage=linkage)
        return solve(inputs.placement.problem, reduced).labels

    return rule


RULES: tuple[tuple[str, str, Rule], ...] = (
    ("6", "random", at_random),
    ("6", "peak only", by_displacement),
    ("6", "overlap only", by_overlap),
    ("6", "centroid of influence", at_centroid),
    *(("9", f"lambda {weight:g}", by_weight(weight)) for weight in (1.0, 0.85, 0.4)),
    *(
        ("10", f"{100 * share:g} % of the candidates", by_paper(share, 1))
        for share in (1.0, 0.2, 0.05, 0.005)
    ),
    *(
        ("11", f"{clusters} clusters" if clusters > 1 else "1 cluster", by_paper(1.0, clusters))
        for clusters in (1, 2, 4, 6)
    ),
    ("11", "2 clusters by sums", by_paper(1.0, 2, "sum")),
    *(
        ("127", f"{word} {cost}", scaled(cost, factor))
        for word, factor in (("without", 0.0), ("half", 0.5), ("double", 2.0))
        for cost in ("near", "room", "track", "crossing", "along", "short")
    ),
)
FULL = ("6", "full")
ORDER = (
    [(figure, name) for figure, name, _ in RULES[:4]]
    + [FULL]
    + [(figure, name) for figure, name, _ in RULES[4:]]
)
"""Figure and name of all rows as tables list them."""


def displacement_costs(inputs: ProblemInputs) -> list[Floats]:
    """(R,) per variable: minus the displacement of each candidate of the full problem, all
    copies."""
    return [each.cost for each in bare_problem(inputs, 1.0).variables]


def bare_problem(inputs: ProblemInputs, weight: float) -> LayoutProblem:
    """The full problem's candidates under displacement and overlap alone, weighed by lambda."""
    bare = {"displacement_weight": weight, "distinctive_weight": 0.0, "terms": ()}
    return _with_settings(inputs, 0.0, **bare)


def _with_settings(inputs: ProblemInputs, share: float = 1.0, **objective: Any) -> LayoutProblem:
    """The problem under other settings, its labels those of the full one; `share` is that of the
    weights of the plane and of occlusion."""
    settings = inputs.settings
    symmetry, pruning = settings.symmetry, settings.candidates
    changed = replace(
        settings,
        candidates=replace(pruning, occlusion_weight=share * pruning.occlusion_weight),
        objective=replace(settings.objective, **objective),
        symmetry=replace(symmetry, plane_weight=share * symmetry.plane_weight),
    )
    known = replace(inputs.measured, settings=changed)
    other = placement_problem(known, inputs.candidates, inputs.placement.groups).problem
    same = tuple(map(_same_labels, inputs.placement.problem.variables, other.variables))
    return replace(other, variables=same, extra=inputs.placement.problem.extra)


def _same_labels(full: Variable, other: Variable) -> Variable:
    """The costs of `other` at the candidates of `full`: which are kept depends on handles, not on
    weights."""
    if not np.array_equal(full.points, other.points):
        raise ValueError(f"{full.name} has other candidates under other weights")
    return replace(full, cost=other.cost, off_face_cost=other.off_face_cost)


def _on_face(problem: LayoutProblem) -> LayoutProblem:
    """The board at the cost of any overlap: without displacement to lose everything would
    leave."""
    penalty = problem.overlap.most * len(problem.variables)
    return replace(
        problem, variables=tuple(replace(each, off_face_cost=penalty) for each in problem.variables)
    )


def _least(cost: Floats) -> int:
    return int(cost.argmin()) if len(cost) else -1


# --- the figures ----------------------------------------------------------------------------------


def _row(
    inputs: ProblemInputs, figure: str, name: str, labels: Indices, bound: float, seconds: float
) -> Row:
    soft = replace(inputs.placement.problem, separation=0.0)
    cost = total_cost(soft, labels)
    chosen = Assignment(labels, cost, min(bound, cost), "stopped", 0.0, name, name)
    made = layout_of(inputs, chosen)
    legible = legibility_of(inputs.face, made.elements)
    points = anchors_of(inputs, labels)
    return Row(
        figure=figure,
        name=name,
        layout=made,
        cost=cost,
        bound=bound,
        seconds=seconds,
        nearest=nearest_handles(inputs.face.surface.points[points]) / inputs.face.handle_width,
        visible=float(inputs.face.views.visible[:, points].mean()) if len(points) else 1.0,
        clear=legible.clear / max(legible.elements, 1),
        kept=displacement_kept(inputs, labels),
        board=int((labels < 0).sum()),
    )


def anchors_of(inputs: ProblemInputs, labels: Indices) -> Indices:
    """(elements on the face,) anchor points, all copies."""
    chosen = [
        c.anchors[label]
        for c, label in zip(inputs.placement.choices, labels, strict=True)
        if label >= 0
    ]
    return np.concatenate([np.zeros(0, dtype=np.int64), *chosen])


def nearest_handles(positions: Floats) -> float:
    """Least distance between any two of (n, 3) positions; inf for fewer than two."""
    apart = np.linalg.norm(positions[:, None] - positions[None], axis=2)
    return float(apart[np.triu_indices(len(positions), 1)].min(initial=np.inf))


def displacement_kept(inputs: ProblemInputs, labels: Indices) -> float:
    """Mean over the controls on the face of the arc length at the anchor over the control's
    peak."""
    motions = {each.control: each for each in inputs.face.trajectories.motions}
    shares = [
        motions[control].arc_length[
            np.searchsorted(motions[control].points, choice.sources[label, copy])
        ]
        / motions[control].arc_length.max()
        for choice, label in zip(inputs.placement.choices, labels, strict=True)
        if label >= 0
        for copy, controls in enumerate(choice.controls)
        for control in controls
    ]
    return float(np.mean(shares)) if shares else 0.0


# --- output ---------------------------------------------------------------------------------------


COLUMNS = ("cost", "bound", "above", "seconds", "nearest", "visible", "clear", "kept", "board")


def cells(row: Row) -> tuple[str, ...]:
    """The figures of a row, in the order of `COLUMNS`."""
    above = (row.cost - row.bound) / max(abs(row.bound), 1e-12)
    return (
        f"{row.cost:.4f}",
        f"{row.bound:.4f}",
        f"{above:.2%}",
        f"{row.seconds:.2f}",
        f"{row.nearest:.2f}",
        f"{row.visible:.1%}",
        f"{row.clear:.1%}",
        f"{row.kept:.1%}",
        f"{row.board}",
    )


def head(name: str) -> str:
    """First line of the printed table."""
    return f"{name:34}" + "".join(f" {each:>9}" for each in COLUMNS)


def line(row: Row) -> str:
    """One printed row."""
    return f"fig {row.figure:>2} {row.name:27}" + "".join(f" {each:>9}" for each in cells(row))


def as_csv(rows: list[Row]) -> str:
    """The rows as comma-separated values."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(("figure", "row", *COLUMNS))
    writer.writerows((row.figure, row.name, *cells(row)) for row in rows)
    return text.getvalue()


def as_markdown(rows: list[Row]) -> str:
    """The rows as a Markdown table."""
    ruler = "|".join(["---:", "---", *["---:"] * len(COLUMNS)])
    lines = [f"| figure | row | {' | '.join(COLUMNS)} |", f"|{ruler}|"]
    lines += [f"| {row.figure} | {row.name} | {' | '.join(cells(row))} |" for row in rows]
    return "\n".join(lines) + "\n"


def picture(inputs: ProblemInputs, rows: list[Row]) -> Image.Image:
    """One strip of fronts per figure, below each other."""
    strips = []
    for figure in dict.fromkeys(row.figure for row in rows):
        mine = [row for row in rows if row.figure == figure]
        fronts = [
            render(inputs.face.rig, row.layout, wanted=Wanted(0.0, CELL, title=row.name))
            for row in mine
        ]
        titles = [
            f"figure {figure}: {row.name}, cost {row.cost:.2f}, {row.seconds:.1f} s" for row in mine
        ]
        strips.append(contact_sheet(fronts, titles, columns=len(mine)))
    page = Image.new("RGB", (strips[0].width, sum(strip.height for strip in strips)))
    top = 0
    for strip in strips:
        page.paste(strip, (0, top))
        top += strip.height
    return page


if __name__ == "__main__":
    main()
