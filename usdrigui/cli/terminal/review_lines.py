"""What `inspect`, `check`, `diff` and `batch` print: for each the lines, the closing line last."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from usdrigui.cli.terminal.run_lines import (
    change_lines,
    clear_lines,
    issue_lines,
    matching_lines,
    percent,
)
from usdrigui.cli.terminal.table import Table, Verbatim
from usdrigui.clients.batch.run import OUTCOMES
from usdrigui.clients.study import FACES, INTERFACES, PAPER_PARTICIPANTS, Study
from usdrigui.errors import by_cause, counted, listed

if TYPE_CHECKING:
    from usdrigui.cli.terminal.screen import Printed
    from usdrigui.clients.batch.job import Row
    from usdrigui.clients.batch.run import Summary
    from usdrigui.layout.review.rating import ElementReview
    from usdrigui.pipeline import LayerDifference, LayerReview
    from usdrigui.report.inspection import (
        AnimationFacts,
        CharacterFacts,
        ControlFacts,
        Inspection,
    )


def of_inspection(found: Inspection) -> Iterator[Printed]:
    """One table a character."""
    for character in found.characters:
        yield from _facts(character)
    yield from issue_lines(found.issues)
    count = sum(len(character.controls) for character in found.characters)
    yield f"usdrigui: inspected {found.asset}: {counted(count, 'control')}"


def _facts(character: CharacterFacts) -> Iterator[Printed]:
    yield (
        f"{character.root}: {character.points} points, {character.meshes} meshes,"
        f" {character.joints} joints, {character.symmetric:.0%} of the points have a mirror"
        " partner"
    )
    parts = (f"{part.name} ({counted(part.controls, 'control')})" for part in character.parts)
    yield f"  parts: {', '.join(parts)}"
    yield facts_table(character.controls, several=len(character.parts) > 1)
    for line in character.groups:
        yield f"  {line}"
    for reason, names in character.without.items():
        yield f"  no controls: {listed(names)}: {reason}"
    if character.likeness is not None:
        yield from matching_lines("like", character.likeness.matching)
        yield "as a configuration:"
        yield Verbatim(character.likeness.configuration)
    if character.animation is not None:
        yield from _animation(character.animation)


def _animation(found: AnimationFacts) -> Iterator[Printed]:
    yield f"animation: {len(found.clips)} clips, {found.frames} frames"
    rows = [
        (each.control, f"{each.use:.3f}", percent(each.active), f"{each.importance:.2f}")
        for each in found.controls
    ]
    yield Table("control | use | active | importance", rows)
    yield "as a configuration:"
    yield Verbatim(found.configuration)


def facts_table(controls: Sequence[ControlFacts], *, several: bool = False) -> Table:
    """One row a control, with its part where the character has `several`."""
    rows = [
        (
            facts.control,
            facts.part if several else "",
            facts.kind,
            f"{facts.minimum:g}..{facts.maximum:g}",
            facts.range_source,
            str(facts.points),
            percent(facts.coverage),
            f"{facts.peak:.2f}",
            facts.twin,
            ", ".join(facts.flags),
        )
        for facts in controls
    ]
    headers = "control | part | kind | range | from | points | coverage | peak | twin | flags"
    return Table(headers, rows, below="flags")


def of_batch(summary: Summary, written: Sequence[str]) -> Iterator[Printed]:
    """One line an asset in the order given, and what was written besides."""
    yield _batch_table(summary.rows)
    yield from written
    numbers = ((summary.count(outcome), outcome) for outcome in OUTCOMES if outcome != "part")
    counts = ", ".join(f"{number} {outcome}" for number, outcome in numbers if number)
    sound = sum(row.sound for row in summary.rows)
    count = len(summary.rows) - summary.count("part")
    rate = 60.0 * count / max(summary.seconds, 1e-9)
    stopped = "stopped; " if any(row.code == "INTERRUPTED" for row in summary.rows) else ""
    yield (
        f"usdrigui: {stopped}{sound} of {count} assets have their layout: {counts};"
        f" {summary.seconds:.1f} s, {rate:.1f} a minute"
    )


def _batch_table(rows: Sequence[Row]) -> Table:
    headers = "asset | outcome | face | board | off | gap of the cost | warnings | seconds | why"
    table = []
    for row in rows:
        counts = [str(each) if row.sound else "" for each in (row.face, row.board, row.left_off)]
        gap = f"{row.gap:.1e}" if row.sound else ""
        warnings, seconds = str(row.warnings or ""), f"{row.seconds:.2f}"
        why = f"{row.code} {row.message}".strip()
        table.append((row.asset, row.outcome, *counts, gap, warnings, seconds, why))
    return Table(headers, table, below="why")


def of_review(found: LayerReview) -> Iterator[Printed]:
    """Every element by the objective, then the findings."""
    for root, review in found.characters:
        placed = counted(len(review.elements), "element")
        yield f"{root}: {placed} on the character, cost {review.cost:.4f}"
        yield from clear_lines(review.legibility)
        times = (
            f"{INTERFACES[name]} {usual:.0f} s ({least:.0f} to {most:.0f})"
            for name, (least, usual, most) in review.posing.items()
        )
        if review.posing:
            yield f"  a model predicts for the faces of the study: {', '.join(times)}"
        yield _review_table(review.elements)
        yield ("  displacement: at the handle, as a share of the control's peak; w: handle widths")
    yield from issue_lines(found.issues)
    causes = [each.severity for each in by_cause(found.issues)]
    counts = {severity: causes.count(severity) for severity in ("error", "warning")}
    codes = {each.code for each in found.issues}
    bare = "has its layouts switched off" if "LAYOUT_OFF" in codes else "has no layout"
    sound, unsound = "fits its rig", "does not fit its rig"
    if "LAYOUT_RESHAPED" in codes:
        sound = "is of an earlier shape of its rig"
    if found.of_asset:
        sound, unsound = f"{bare}; the asset is valid", f"{bare}; the asset has errors"
    state = unsound if counts["error"] else sound
    findings = ", ".join(counted(number, severity) for severity, number in counts.items())
    yield f"usdrigui: checked {found.layer}: {state}; {findings}"


def _review_table(elements: Sequence[ElementReview]) -> Table:
    headers = (
        "element | displacement | linear | overlap | handles apart | nearest | improvement | at"
    )
    rows = []
    for each in elements:
        costs = (f"{each.linear:.3f}", f"{each.overlap:.3f}")
        apart = f"{each.distance:.1f} w" if math.isfinite(each.distance) else ""
        improvement = f"{each.gain:.3f}" if each.better else ""
        better = (improvement, each.better)
        rows.append((each.element, percent(each.kept), *costs, apart, each.nearest, *better))
    return Table(headers, rows)


def of_study(found: Study) -> Iterator[Printed]:
    """One row a measure, beside the paper's means."""
    yield (
        "mean ± standard deviation between participants, in brackets the mean of"
        f" {PAPER_PARTICIPANTS} in Kim and Singh 2021, section 5.2, whose second interface is an"
        " artist's off the face"
    )
    told = {(each.measure, each.interface): str(each) for each in found.measures}
    rows = [
        (measure, *(told.get((measure, name), "") for name in INTERFACES))
        for measure in dict.fromkeys(each.measure for each in found.measures)
    ]
    yield Table(" | ".join(["measure", *INTERFACES.values()]), rows)
    for path in found.left_out:
        yield f"left out, as not all {FACES} faces were done: {path}"
    yield f"usdrigui: summed {counted(len(found.participants), 'participant')}"


def of_difference(found: LayerDifference) -> Iterator[Printed]:
    """Every control that changed."""
    for character in found.characters:
        yield from change_lines(character)
    for root in found.only_in_one:
        yield f"{root}: only one of the two layers has a layout of it"
    yield from issue_lines(found.issues)
    changed = sum(character.changed for character in found.characters)
    shared = sum(character.shared for character in found.characters)
    if shared:
        alone = len(found.only_in_one)
        more = f"; {alone} characters are in one of the two only" if alone else ""
        summary = f"{changed} of {shared} common controls changed{more}"
    else:
        what = "control" if found.characters else "character"
        summary = f"they have no {what} in common"
    yield f"usdrigui: compared {found.before} and {found.after}: {summary}"
