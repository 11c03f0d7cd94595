"""How a run looks on a terminal, and in a log: progress, tables and the closing line.

Names come from files, so nothing here interprets markup in them, nor lets them steer the terminal.
"""

from __future__ import annotations

import math
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, TextIO

from usdrigui.cli.tables import Table, columns, wrapped
from usdrigui.errors import sentences, visible

if TYPE_CHECKING:
    from rich.status import Status

    from usdrigui.clients.batch.job import Row
    from usdrigui.clients.batch.run import Summary
    from usdrigui.errors import Issue
    from usdrigui.layout.reuse.identity import Matching
    from usdrigui.layout.review.difference import Change, Difference
    from usdrigui.layout.review.review import ElementReview
    from usdrigui.model import Assignment, Element
    from usdrigui.pipeline import Event, LayerReview
    from usdrigui.report.inspection import AnimationFacts, ControlFacts, Inspection, UseFacts
    from usdrigui.report.run_report import CharacterReport, ControlRow, Report

_LOG_WIDTH = 160
"""Columns where the output is not a terminal."""

_PAUSE = 5.0
"""Seconds between two lines about one long stage, where the output is not a terminal."""
_DISPLACEMENT = "displacement: at the handle, as a share of the control's peak"
"""What the column of this name holds."""

_WEAK, _WEAKEST = 0.9, 3
"""Displacement below which the weakest handles are named, and how many of them."""

ProgressCallback = Callable[["Event"], None]


class Screen:
    """Prints for people: results on standard output, progress on standard error."""

    def __init__(
        self, *, quiet: bool = False, machine: bool = False, verbose: bool = False
    ) -> None:
        self._quiet = quiet
        self._verbose = verbose
        self._silent = machine
        self._printed = time.monotonic()

    @contextmanager
    def progress(self) -> Iterator[ProgressCallback]:
        """A live line on a terminal, one plain line a stage elsewhere, nothing when quiet."""
        if self._quiet or self._silent:
            yield _ignore
        elif sys.stderr is not None and sys.stderr.isatty():
            from rich.console import Console  # as long to load as a layer takes to write

            console = Console(stderr=True, markup=False, highlight=False)
            with console.status("starting") as status:
                yield lambda event: self._live(status, event)
        else:
            yield self._plain

    def report(self, report: Report, written: Sequence[str]) -> None:
        """What is not on the character and why, what is to be looked at, and the closing line;
        the place of every control, with `--verbose`."""
        if not self._quiet:
            for character in report.characters:
                self._character(character)
            self._issues(report.issues)
            if self._verbose:
                self._seconds(report.seconds)
            else:
                self._say(
                    "  the place of every control and the reason: --verbose, or --report JSON"
                )
            for line in written:
                self._say(line)
        self._say(_closing_line(report))

    def inspection(self, found: Inspection) -> None:
        """One table a character."""
        for character in found.characters if not self._quiet else ():
            self._say(
                f"{character.root}: {character.points} points, {character.meshes} meshes,"
                f" {character.joints} joints, {character.symmetric:.0%} of the points have a mirror"
                " partner"
            )
            parts = ", ".join(f"{part.name} ({part.controls} controls)" for part in character.parts)
            self._say(f"  parts: {parts}")
            self._table(_facts_table(character.controls, several=len(character.parts) > 1))
            for line in character.groups:
                self._say(f"  {line}")
            if character.likeness is not None:
                self._matching("like", character.likeness.matching)
                self._say("as a configuration:")
                self._copyable(character.likeness.configuration)
            if character.animation is not None:
                self._animation(character.animation)
        if not self._quiet:
            self._issues(found.issues)
        count = sum(len(character.controls) for character in found.characters)
        self._say(f"usdrigui: inspected {found.asset}: {count} controls")

    def _animation(self, found: AnimationFacts) -> None:
        self._say(f"animation: {len(found.clips)} clips, {found.frames} frames")
        self._table(_use_table(found.controls))
        for each in found.together:
            self._say(f"  together ({each.agreement:.2f}): {', '.join(each.controls)}")
        self._say("as a configuration:")
        self._copyable(found.configuration)

    @contextmanager
    def batch_progress(self, count: int) -> Iterator[Callable[[Row], None]]:
        """One line an asset, as they are done; nothing when quiet."""
        done = 0

        def tell(row: Row) -> None:
            nonlocal done
            done += 1
            if not (self._quiet or self._silent):
                text = (
                    f"[{done:>{len(str(count))}}/{count}] {row.outcome:<9} {row.seconds:7.2f} s"
                    f" {row.asset} {row.code}"
                )
                self._tell(text.rstrip())

        yield tell

    def batch(self, summary: Summary, written: Sequence[str]) -> None:
        """One line an asset in the order given, what was written besides, and the closing line."""
        if not self._quiet:
            self._table(_batch_table(summary.rows))
            for line in written:
                self._say(line)
        outcomes = ("written", "unchanged", "skipped", "refused", "failed")
        counts = ", ".join(
            f"{summary.count(each)} {each}" for each in outcomes if summary.count(each)
        )
        sound = sum(row.sound for row in summary.rows)
        count = len(summary.rows) - summary.count("part")
        rate = 60.0 * count / max(summary.seconds, 1e-9)
        stopped = "stopped; " if any(row.code == "INTERRUPTED" for row in summary.rows) else ""
        closing = f"usdrigui: {stopped}{sound} of {count} assets have their layout: {counts}"
        self._say(f"{closing}; {summary.seconds:.1f} s, {rate:.1f} a minute")

    def review(self, found: LayerReview) -> None:
        """Faults first, then every element by the objective, then the closing line."""
        if not self._quiet:
            for root, review in found.characters:
                self._say(
                    f"{root}: {len(review.elements)} elements on the character, cost"
                    f" {review.cost:.4f}"
                )
                self._table(_review_table(review.elements))
                self._say(f"  {_DISPLACEMENT}; w: handle widths")
            self._issues(found.issues)
        counts = {
            severity: sum(each.severity == severity for each in found.issues)
            for severity in ("error", "warning")
        }
        off = any(each.code == "LAYOUT_OFF" for each in found.issues)
        bare = "has its layouts switched off" if off else "has no layout"
        fits = (
            (f"{bare}; the asset is valid", f"{bare}; the asset has errors")
            if found.of_asset
            else ("fits its rig", "does not fit its rig")
        )
        state = fits[bool(counts["error"])]
        findings = ", ".join(
            f"{number} {severity}{'s' * (number != 1)}" for severity, number in counts.items()
        )
        self._say(f"usdrigui: checked {found.layer}: {state}; {findings}")

    def difference(
        self, before: str, after: str, found: Sequence[Difference], only_in_one: Sequence[str]
    ) -> None:
        """Every control that changed, and the closing line."""
        if not self._quiet:
            for character in found:
                self._changes(character)
            for root in only_in_one:
                self._say(f"{root}: only one of the two layers has a layout of it")
        changed = sum(character.changed for character in found)
        shared = sum(character.shared for character in found)
        summary = (
            f"{changed} of {shared} common controls changed"
            if shared
            else "they have no character in common"
        )
        if found and not shared:
            summary = "they have no control in common"
        elif only_in_one and shared:
            summary += f"; {len(only_in_one)} characters are in one of the two only"
        self._say(f"usdrigui: compared {before} and {after}: {summary}")

    def _changes(self, found: Difference) -> None:
        count = f"{found.changed} of {found.shared} common controls changed"
        went = sum(change.kind in ("added", "removed") for change in found.changes)
        renamed = (
            f", {len({each.was for each in found.renamed})} were renamed" if found.renamed else ""
        )
        self._say(f"{found.root}: {count}, {went} came or went{renamed}")
        if found.changes:
            self._table(_changes_table(found.changes))

    def _table(self, table: Table) -> None:
        _put(sys.stdout, table.lines(columns(sys.stdout) or _LOG_WIDTH))

    def _say(self, text: str) -> None:
        """Print a sentence, in as many lines as it needs."""
        _put(sys.stdout, wrapped(visible(text), columns(sys.stdout)))

    def _tell(self, text: str) -> None:
        """The same on standard error."""
        _put(sys.stderr, wrapped(visible(text), columns(sys.stderr)))

    def _copyable(self, text: str) -> None:
        """Print lines of a configuration as they are to be written."""
        _put(sys.stdout, map(visible, text.splitlines()))

    def _live(self, status: Status, event: Event) -> None:
        from rich.text import Text

        status.update(Text(f"{event.stage}: {event.detail}" if event.detail else event.stage))

    def _now_and_then(self, event: Event) -> None:
        """In a log, a long search prints its progress every few seconds."""
        if event.detail and time.monotonic() - self._printed > _PAUSE:
            self._printed = time.monotonic()
            self._tell(f"{event.stage:<14} {event.detail}")

    def _plain(self, event: Event) -> None:
        if event.seconds is None:
            self._now_and_then(event)
        else:
            detail = f" {event.detail}" if event.detail else ""
            self._tell(f"{event.stage:<14} {event.seconds:6.2f} s{detail}")

    def _character(self, character: CharacterReport) -> None:
        elements = character.layout.elements
        existing = len(elements) - len(character.added)
        summary = f"{len(elements)} elements" + (
            f", {existing} of which are in another layer" if existing else ""
        )
        self._say(f"{character.layout.character.path_in_variants}: {summary}")
        placed = [row for row in character.rows if not existing or row.element in character.added]
        if placed and (self._verbose or existing):
            self._table(_rows_table(placed, _places(elements)))
        elif placed:
            self._away(placed)
        for note in character.notes:
            self._say(f"  note: {note.control}: {note.reason}")
        solution = character.assignment
        self._say(
            f"  on the {_where([character])} {character.count('face')}, on the board"
            f" {character.count('board')}, left off {character.count('left off')}; handles on the"
            f" {_where([character])} have {_percent(character.kept)} of their controls' peak"
            f" displacement{_weakest(placed)}"
        )
        several = len(character.parts) > 1
        self._say(
            f"  cost {solution.cost:.4f}, proven bound {solution.bound:.4f}, {_gap([solution])},"
            f" {_ending(solution)}{'' if several else _program(solution)}"
        )
        if several:
            for part in character.parts:
                proof = part.assignment
                self._say(
                    f"  {part.name}: {part.on_it} of {len(part.controls)} controls on it, cost"
                    f" {proof.cost:.4f}, {_gap([proof])}, {_ending(proof)}{_program(proof)}"
                )
        for step in solution.steps if self._verbose else ():
            self._say(f"  {step.name}: {_figures(step.figures)}")
        for which, found in character.matchings.items():
            self._matching(which, found)
        if character.difference is not None:
            self._say("since the previous layout:")
            self._changes(character.difference)

    def _away(self, rows: Sequence[ControlRow]) -> None:
        """The controls that are not on the character, by place and reason."""
        reasons: dict[tuple[str, str], list[str]] = {}
        for row in rows:
            if row.place != "face":
                reasons.setdefault((row.place, row.reason), []).append(row.control)
        for (place, reason), controls in sorted(reasons.items(), key=lambda each: each[0][0]):
            self._say(f"  {place}: {', '.join(controls)}{f': {reason}' if reason else ''}")

    def _matching(self, which: str, found: Matching) -> None:
        """What was matched with an existing layout, what is unsure and what is left."""
        sure = [each for each in found.matches if each not in found.unsure]
        count = len(found.matches) + len(found.left_before)
        reasons = Counter(each.reason for each in sure)
        by_reason = ", ".join(f"{number} by {reason}" for reason, number in reasons.items())
        which = which if which.startswith("/") else f"--{which}"
        matched = f"{len(sure)} of {count} controls matched"
        self._say(f"  {which}: {matched}{f': {by_reason}' if by_reason else ''}")
        if found.unsure:
            pairs = (f"{each.before} may be {each.after} ({each.sure})" for each in found.unsure)
            self._say(f"    unsure: {', '.join(pairs)}")
        if found.left_before:
            self._say(f"    without a counterpart: {', '.join(found.left_before)}")

    def _issues(self, issues: Sequence[Issue]) -> None:
        for found in issues:
            where = f" {found.where}:" if found.where else ""
            self._say(f"{found.severity}: {found.code}{where} {sentences(found)}")

    def _seconds(self, seconds: Sequence[tuple[str, float]]) -> None:
        parts = ", ".join(f"{stage} {value:.2f}" for stage, value in seconds)
        self._say(f"  seconds: {parts}; stages took {sum(value for _, value in seconds):.2f}")


def _ignore(event: Event) -> None:
    del event


def _weakest(rows: Sequence[ControlRow]) -> str:
    """A clause with the controls that keep the least of their peak, if that is much less."""
    weak = sorted((row.kept, row.control) for row in rows if row.kept < _WEAK)[:_WEAKEST]
    weakest = ", ".join(f"{control} {_percent(kept)}" for kept, control in weak)
    return f"; the least: {weakest}" if weakest else ""


def _places(elements: Sequence[Element]) -> dict[str, str]:
    """Places of elements, by name, as ``anchor`` takes them; nothing for those on the board."""
    return {each.name: each.anchor.place for each in elements if not each.anchor.on_board}


def _rows_table(rows: Sequence[ControlRow], places: Mapping[str, str]) -> Table:
    """One row a control; the place of its element (`places`), and why each element once."""
    headers = ("control", "place", "displacement", "at", "element", "kind", "twin", "why")
    table = Table(*headers, below=("why",))
    printed: set[tuple[str, str]] = set()
    for row in rows:
        share = _percent(row.kept) if math.isfinite(row.kept) else ""
        element = row.element if row.element != row.control else ""
        why = "" if element and (element, row.reason) in printed else row.reason
        printed.add((element, row.reason))
        at = places.get(row.element, "")
        cells = (row.control, row.stands, share, at, element, row.kind, row.twin, why)
        table.add_row(*map(visible, cells))
    return table


def _review_table(elements: Sequence[ElementReview]) -> Table:
    table = Table(
        "element",
        "displacement",
        "linear",
        "overlap",
        "handles apart",
        "nearest",
        "improvement",
        "at",
    )
    for each in elements:
        apart = f"{each.distance:.1f} w" if math.isfinite(each.distance) else ""
        improvement = f"{each.improvement:.3f}" if each.better else ""
        numbers = (_percent(each.kept), f"{each.linear:.3f}", f"{each.overlap:.3f}")
        table.add_row(
            *map(visible, (each.element, *numbers, apart, each.nearest, improvement, each.better))
        )
    return table


def _changes_table(changes: Sequence[Change]) -> Table:
    table = Table("control", "change", "by", "element", "before", "now", "why", below=("why",))
    for change in changes:
        by = f"{change.distance:.1f} w" if math.isfinite(change.distance) else ""
        element = change.element if change.element != change.control else ""
        why = ((f"was {change.was}",) if change.was else ()) + change.why
        cells = (
            change.control,
            change.kind,
            by,
            element,
            change.before,
            change.after,
            "; ".join(why),
        )
        table.add_row(*map(visible, cells))
    return table


def _batch_table(rows: Sequence[Row]) -> Table:
    table = Table(
        "asset",
        "outcome",
        "face",
        "board",
        "off",
        "gap of the cost",
        "warnings",
        "seconds",
        "why",
        below=("why",),
    )
    for row in rows:
        counts = [str(each) if row.sound else "" for each in (row.face, row.board, row.left_off)]
        gap = f"{row.gap:.1e}" if row.sound else ""
        why = f"{row.code} {row.message}".strip()
        cells = (
            row.asset,
            row.outcome,
            *counts,
            gap,
            str(row.warnings or ""),
            f"{row.seconds:.2f}",
            why,
        )
        table.add_row(*map(visible, cells))
    return table


def _facts_table(controls: Sequence[ControlFacts], *, several: bool = False) -> Table:
    """One row a control, with its part where the character has `several`."""
    part = ("part",) if several else ()
    table = Table(
        "control",
        *part,
        "kind",
        "range",
        "from",
        "points",
        "coverage",
        "peak",
        "twin",
        "flags",
        below=("flags",),
    )
    for facts in controls:
        cells = (
            facts.control,
            *((facts.part,) if several else ()),
            facts.kind,
            f"{facts.minimum:g}..{facts.maximum:g}",
            facts.range_source,
            str(facts.points),
            _percent(facts.coverage),
            f"{facts.peak:.2f}",
            facts.twin,
            ", ".join(facts.flags),
        )
        table.add_row(*map(visible, cells))
    return table


def _use_table(controls: Sequence[UseFacts]) -> Table:
    table = Table("control", "use", "active", "importance")
    for each in controls:
        table.add_row(
            *map(
                visible,
                (each.control, f"{each.use:.3f}", _percent(each.active), f"{each.importance:.2f}"),
            )
        )
    return table


def _put(stream: TextIO, lines: Iterable[str]) -> None:
    stream.write("".join(f"{line}\n" for line in lines))


def _closing_line(report: Report) -> str:
    face = sum(character.count("face") for character in report.characters)
    total = sum(len(character.rows) for character in report.characters)
    target = f" {report.output}" if report.output else ""
    gap = _gap([character.assignment for character in report.characters])
    where = _where(report.characters)
    return f"usdrigui: {report.outcome}{target}: {face} of {total} controls on the {where}, {gap}"


def _gap(solutions: Sequence[Assignment]) -> str:
    """The largest gap of some solutions, relative to what the choice can change and to the cost."""
    of_choice = max((each.gap_of_choice for each in solutions), default=0.0)
    of_cost = max((each.gap for each in solutions), default=0.0)
    return f"gap {of_choice:.1e} of the choice ({of_cost:.1e} of the cost)"


def _figures(figures: Iterable[tuple[str, float]]) -> str:
    """What a step of the solver counted and found: ``rows 130, lp bound -19.9112``."""
    return ", ".join(f"{name.replace('_', ' ')} {value:.10g}" for name, value in figures)


def _where(characters: Sequence[CharacterReport]) -> str:
    """What controls are on: the only part, or the character."""
    parts = {part.name for character in characters for part in character.parts}
    return next(iter(parts)) if len(parts) == 1 else "character" if parts else "face"


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


def _percent(share: float) -> str:
    if 0.0 < share < 0.005:
        return "<1 %"
    return f"{100 * share:.0f} %" if math.isfinite(share) else "-"
