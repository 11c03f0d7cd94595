"""What `process` prints: what is not on the character and why, what is to be looked at, how good
the layout is and how well that is proven."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from operator import attrgetter
from typing import TYPE_CHECKING

from usdrigui.cli.terminal.table import Table
from usdrigui.errors import by_cause, counted, listed, sentences
from usdrigui.model.levels import inner_names

if TYPE_CHECKING:
    from usdrigui.cli.terminal.screen import Printed
    from usdrigui.errors import Issue
    from usdrigui.layout.reuse.identity import Matching
    from usdrigui.layout.review.difference import Difference
    from usdrigui.model import Assignment, Legibility
    from usdrigui.report.run_report import CharacterReport, ControlRow, Report

_WEAK, _WEAKEST = 0.9, 3
"""Displacement below which the weakest handles are named, and how many of them."""


def report_lines(report: Report, written: Sequence[str], *, verbose: bool) -> Iterator[Printed]:
    """Of every character what is on it and what is not, and the findings; with `verbose` the place
    of every control too.  `written`: a line for each further file.  The outcome comes last, in one
    line."""
    for character in report.characters:
        yield from _character(character, verbose)
    yield from issue_lines(report.issues)
    if verbose:
        parts = ", ".join(f"{stage} {value:.2f}" for stage, value in report.seconds)
        yield f"  seconds: {parts}; stages took {sum(value for _, value in report.seconds):.2f}"
    else:
        yield "  the place of every control and the reason: --verbose, or --report JSON"
    yield from written
    face = sum(character.count("face") for character in report.characters)
    total = sum(len(character.rows) for character in report.characters)
    target = f" {report.output}" if report.output else ""
    gap = _gap([character.assignment for character in report.characters])
    where = on_what(report.characters)
    yield f"usdrigui: {report.outcome}{target}: {face} of {total} controls on the {where}, {gap}"


def issue_lines(issues: Iterable[Issue]) -> Iterator[str]:
    """One line of two sentences for each cause; of several with one repair that comes once, after
    them."""
    for repair, group in groupby(by_cause(issues), key=attrgetter("repair")):
        same = list(group)
        for found in same:
            where = f" {found.where}:" if found.where else ""
            what = sentences(found) if len(same) == 1 else found.message
            yield f"{found.severity}: {found.code}{where} {what}"
        if len(same) > 1:
            yield f"  repair: {repair}"


def matching_lines(which: str, found: Matching) -> Iterator[str]:
    """What was matched with an existing layout, what is unsure and what is left."""
    sure = [each for each in found.matches if each not in found.unsure]
    count = len(found.matches) + len(found.left_before)
    reasons = Counter(each.reason for each in sure)
    by_reason = ", ".join(f"{number} by {reason}" for reason, number in reasons.items())
    which = which if which.startswith("/") else f"--{which}"
    yield f"  {which}: {len(sure)} of {count} controls matched{by_reason and f': {by_reason}'}"
    if found.unsure:
        pairs = (f"{each.before} may be {each.after} ({each.sure})" for each in found.unsure)
        yield f"    unsure: {', '.join(pairs)}"
    if found.left_before:
        yield f"    without a counterpart: {', '.join(found.left_before)}"


def change_lines(found: Difference) -> Iterator[Printed]:
    """How many controls of a character changed, and each that did."""
    went = sum(change.kind in ("added", "removed") for change in found.changes)
    more = f", {found.renamed} were renamed" if found.renamed else ""
    yield (
        f"{found.root}: {found.changed} of {found.shared} common controls changed, {went} came or"
        f" went{more}"
    )
    rows = []
    for change in found.changes:
        by = f"{change.distance:.1f} w" if math.isfinite(change.distance) else ""
        element = change.element if change.element != change.control else ""
        why = "; ".join(((f"was {change.was}",) if change.was else ()) + change.why)
        rows.append((change.control, change.kind, by, element, change.before, change.after, why))
    if rows:
        yield Table("control | change | by | element | before | now | why", rows, below="why")


def percent(share: float) -> str:
    """A share in whole percents; a small one is not nothing."""
    if 0.0 < share < 0.005:
        return "<1 %"
    return f"{100 * share:.0f} %" if math.isfinite(share) else "-"


def on_what(characters: Sequence[CharacterReport]) -> str:
    """What controls are on: the only part, or the character."""
    parts = {part.name for character in characters for part in character.parts}
    return next(iter(parts)) if len(parts) == 1 else "character"


def _character(character: CharacterReport, verbose: bool) -> Iterator[Printed]:
    elements = character.layout.elements
    existing = len(elements) - len(character.added)
    more = f", {existing} of which are in another layer" if existing else ""
    yield f"{character.layout.path_in_variants}: {counted(len(elements), 'element')}{more}"
    placed = [row for row in character.rows if not existing or row.element in character.added]
    if placed and (verbose or existing):
        places = {each.name: each.anchor.place for each in elements if not each.anchor.on_board}
        yield _rows_table(placed, places)
    else:
        yield from _away(placed)
    if inner := inner_names(elements):
        yield f"  behind the elements that open them: {listed(sorted(inner))}"
    yield from _proof_lines(character, placed)
    for step in character.assignment.steps if verbose else ():
        yield f"  {step.name}: {_figures(step.figures)}"
    for which, found in character.matchings.items():
        yield from matching_lines(which, found)
    if character.difference is not None:
        yield "since the previous layout:"
        yield from change_lines(character.difference)


def _proof_lines(character: CharacterReport, placed: Sequence[ControlRow]) -> Iterator[str]:
    """How good the layout is, and how well proven, by part where there are several."""
    solution, where = character.assignment, on_what([character])
    several = len(character.parts) > 1
    yield (
        f"  on the {where} {character.count('face')}, on the board {character.count('board')}, left"
        f" off {character.count('left off')}; handles on the {where} have"
        f" {percent(character.kept)} of their controls' peak displacement{_weakest(placed)}"
    )
    yield from clear_lines(character.legibility)
    program = "" if several else _program(solution)
    left = f" and {solution.penalty:.4f} for places left" if solution.penalty > 0.0 else ""
    yield (
        f"  cost {solution.cost:.4f}{left}, proven bound {solution.bound:.4f}, {_gap([solution])},"
        f" {_ending(solution)}{program}"
    )
    for part in character.parts if several else ():
        proof = part.assignment
        yield (
            f"  {part.name}: {part.on_it} of {len(part.controls)} controls on it, cost"
            f" {proof.cost:.4f}, {_gap([proof])}, {_ending(proof)}{_program(proof)}"
        )


def clear_lines(found: Legibility) -> Iterator[str]:
    """How many elements can be read and grabbed at a glance."""
    if found.elements:
        yield f"  {found.clear} of {found.elements} elements clear at 640 px"


def _away(rows: Sequence[ControlRow]) -> Iterator[str]:
    """The controls that are not on the character, by place and reason."""
    reasons: dict[tuple[str, str], list[str]] = {}
    for row in rows:
        if row.place != "face":
            reasons.setdefault((row.place, row.reason), []).append(row.control)
    for (place, reason), controls in sorted(reasons.items(), key=lambda each: each[0][0]):
        yield f"  {place}: {', '.join(controls)}{reason and f': {reason}'}"


def _rows_table(rows: Sequence[ControlRow], places: Mapping[str, str]) -> Table:
    """One row a control; the place of its element (`places`), and why each element once."""
    printed: set[tuple[str, str]] = set()
    table = []
    for row in rows:
        share = percent(row.displacement_kept) if math.isfinite(row.displacement_kept) else ""
        element = row.element if row.element != row.control else ""
        why = "" if element and (element, row.reason) in printed else row.reason
        printed.add((element, row.reason))
        place = places.get(row.element, "")
        table.append((row.control, row.stands, share, place, element, row.kind, row.twin, why))
    headers = "control | place | displacement | at | element | kind | twin | why"
    return Table(headers, table, below="why")


def _weakest(rows: Sequence[ControlRow]) -> str:
    """A clause with the controls that keep the least of their peak, if that is much less."""
    weak = sorted(
        (row.displacement_kept, row.control) for row in rows if row.displacement_kept < _WEAK
    )[:_WEAKEST]
    weakest = ", ".join(f"{control} {percent(kept)}" for kept, control in weak)
    return f"; the least: {weakest}" if weakest else ""


def _gap(solutions: Sequence[Assignment]) -> str:
    """How far the cost of some solutions may be from the least, at most."""
    from usdrigui.model import proven

    return proven(max((solution.gap for solution in solutions), default=0.0))


def _figures(figures: Iterable[tuple[str, float]]) -> str:
    """What a step of the solver counted and found: ``rows 130, bound -19.9112``."""
    return ", ".join(f"{name.replace('_', ' ')} {value:.10g}" for name, value in figures)


def _ending(solution: Assignment) -> str:
    """What closed the problem, the limit that came first, or that neither did."""
    if solution.status == "optimal":
        return f"proved by {solution.closed_by}"
    if not solution.closed_by:
        return "not proved"
    if solution.closed_by == "interrupt":
        return "the search was interrupted; its best layout is kept"
    return f"stopped by the {solution.closed_by}"


def _program(solution: Assignment) -> str:
    """The size of the program that a solver had, in brackets."""
    if solution.method == "bounds" or not solution.figures:
        return ""
    return f" ({_figures(solution.figures)})"
