"""How a run looks on a terminal, and in a log: progress, tables and the closing verdict line.

Names come from files, so nothing here interprets markup in them, nor lets them steer the terminal.
"""

from __future__ import annotations

import math
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from rich.cells import cell_len
from rich.console import Console
from rich.table import Table
from rich.text import Text

from usdrigui.errors import sentences, visible

if TYPE_CHECKING:
    from rich.console import ConsoleOptions, RenderResult
    from rich.status import Status

    from usdrigui.clients.batch.jobs import Row
    from usdrigui.clients.batch.run import Summary
    from usdrigui.errors import Issue
    from usdrigui.inspection import AnimationFacts, ControlFacts, Inspection, UseFacts
    from usdrigui.layout.reuse.identity import Matching
    from usdrigui.layout.review.difference import Change, Difference
    from usdrigui.layout.review.review import ElementReview
    from usdrigui.model import Assignment
    from usdrigui.pipeline import Event, LayerReview
    from usdrigui.report import CharacterReport, ControlRow, Report

_LOG_WIDTH = 160
"""Columns where the output is not a terminal."""

_PAUSE = 5.0
"""Seconds between two lines about one long stage, where the output is not a terminal."""
_WRAPPED = ("why", "flags", "element", "twin", "nearest", "at", "before", "now")
"""Columns that give way when the line is too long."""

_LEAST = 16
"""Characters that such a column keeps; where that does not fit, the lines are longer than the terminal is wide."""

_LONGEST_NAME = 60
"""Characters of a name after which it goes on in the next line."""

_GAP = 2
"""Characters between two columns."""

_DISPLACEMENT = "displacement: at the handle, as a share of the control's peak"
"""What the column of this name holds."""

Watch = Callable[["Event"], None]


class _Console(Console):
    """Prints lines of text with nothing in them that steers the terminal."""

    def print(self, *objects: Any, **options: Any) -> None:
        super().print(*(visible(each) if isinstance(each, str) else each for each in objects), **options)


class _Whole:
    """A table that loses nothing on a narrow terminal: rather than cut, its lines are longer than that is wide."""

    def __init__(self, table: Table) -> None:
        self._table = table
        self._least = 0
        for column in table.columns:
            longest = max(cell_len(str(each)) for each in (column.header, *column.cells))
            column.min_width = min(longest, _LEAST if column.header in _WRAPPED else _LONGEST_NAME)
            column.no_wrap &= longest <= _LONGEST_NAME
            self._least += column.min_width + _GAP

    def __rich_console__(self, console: Console, options: ConsoleOptions) -> RenderResult:
        yield from console.render(self._table, options.update(width=max(options.max_width, self._least)))


class Screen:
    """Prints for people: results on standard output, progress on standard error."""

    def __init__(self, *, quiet: bool = False, machine: bool = False) -> None:
        self._quiet = quiet
        self._silent = machine
        self._told = time.monotonic()
        self._out = _Console(markup=False, highlight=False, width=None if sys.stdout.isatty() else _LOG_WIDTH)
        self._side = _Console(stderr=True, markup=False, highlight=False)

    @contextmanager
    def progress(self) -> Iterator[Watch]:
        """A live line on a terminal, one plain line a stage elsewhere, nothing when quiet."""
        if self._quiet or self._silent:
            yield _ignore
        elif self._side.is_terminal:
            with self._side.status("starting") as status:
                yield lambda event: self._live(status, event)
        else:
            yield self._plain

    def report(self, report: Report, written: Sequence[str]) -> None:
        """What became of every control, and the verdict."""
        if not self._quiet:
            for character in report.characters:
                self._character(character)
            self._issues(report.issues)
            self._seconds(report.seconds)
            for line in written:
                self._out.print(line)
        self._out.print(_verdict(report))

    def inspection(self, found: Inspection) -> None:
        """One table a character."""
        for character in found.characters if not self._quiet else ():
            self._out.print(
                f"{character.root}: {character.points} points, {character.meshes} meshes, {character.joints} joints, "
                f"{character.symmetric:.0%} of the points have a mirror partner"
            )
            told = ", ".join(f"{part.name} ({part.controls} controls)" for part in character.parts)
            self._out.print(f"  parts: {told}", soft_wrap=True)
            self._table(_facts_table(character.controls, several=len(character.parts) > 1))
            for line in character.groups:
                self._out.print(f"  {line}")
            if character.likeness is not None:
                self._matching("like", character.likeness.matching)
                self._out.print("as a configuration:")
                for line in character.likeness.configuration.splitlines():
                    self._out.print(line, soft_wrap=True)
            if character.animation is not None:
                self._animation(character.animation)
        if not self._quiet:
            self._issues(found.issues)
        count = sum(len(character.controls) for character in found.characters)
        self._out.print(f"usdrigui: inspected {found.asset}: {count} controls; nothing was written")

    def _animation(self, found: AnimationFacts) -> None:
        self._out.print(f"animation: {len(found.clips)} clips, {found.frames} frames")
        self._table(_use_table(found.controls))
        for each in found.together:
            self._out.print(f"  together ({each.agreement:.2f}): {', '.join(each.controls)}", soft_wrap=True)
        self._out.print("as a configuration:")
        for line in found.configuration.splitlines():
            self._out.print(line, soft_wrap=True)

    @contextmanager
    def batch_progress(self, count: int) -> Iterator[Callable[[Row], None]]:
        """One line an asset, as they are done; nothing when quiet."""
        done = 0

        def tell(row: Row) -> None:
            nonlocal done
            done += 1
            if not (self._quiet or self._silent):
                text = (
                    f"[{done:>{len(str(count))}}/{count}] {row.outcome:<9} {row.seconds:7.2f} s {row.asset} {row.code}"
                )
                self._side.print(text.rstrip(), soft_wrap=True)

        yield tell

    def batch(self, summary: Summary, written: Sequence[str]) -> None:
        """One line an asset in the order given, what was written besides, and the verdict."""
        if not self._quiet:
            self._table(_batch_table(summary.rows))
            for line in written:
                self._out.print(line)
        outcomes = ("written", "unchanged", "skipped", "refused", "failed")
        told = ", ".join(f"{summary.count(each)} {each}" for each in outcomes if summary.count(each))
        sound = sum(row.sound for row in summary.rows)
        count = len(summary.rows) - summary.count("part")
        rate = 60.0 * count / max(summary.seconds, 1e-9)
        stopped = "stopped; " if any(row.code == "INTERRUPTED" for row in summary.rows) else ""
        verdict = f"usdrigui: {stopped}{sound} of {count} assets have their layout: {told}"
        self._out.print(f"{verdict}; {summary.seconds:.1f} s, {rate:.1f} a minute", soft_wrap=True)

    def review(self, found: LayerReview) -> None:
        """Faults first, then every element by the objective, then the verdict."""
        if not self._quiet:
            for root, review in found.characters:
                self._out.print(f"{root}: {len(review.elements)} elements on the face, cost {review.cost:.4f}")
                self._table(_review_table(review.elements))
                self._out.print(f"  {_DISPLACEMENT}; w: handle widths")
            self._issues(found.issues)
        counts = {
            severity: sum(each.severity == severity for each in found.issues) for severity in ("error", "warning")
        }
        fits = ("fits its rig", "does not fit its rig") if found.characters else ("is sound", "has faults")
        state = fits[bool(counts["error"])]
        told = ", ".join(f"{number} {severity}{'s' * (number != 1)}" for severity, number in counts.items())
        self._out.print(f"usdrigui: checked {found.layer}: {state}; {told}")

    def difference(self, before: str, after: str, found: Sequence[Difference], only_in_one: Sequence[str]) -> None:
        """Every control that changed, and the verdict."""
        if not self._quiet:
            for character in found:
                self._changes(character)
            for root in only_in_one:
                self._out.print(f"{root}: only one of the two layers has a layout of it")
        changed = sum(len(character.displaced) for character in found)
        shared = sum(character.shared for character in found)
        told = f"{changed} of {shared} common controls changed" if shared else "they have no character in common"
        if found and not shared:
            told = "they have no control in common"
        elif only_in_one and shared:
            told += f"; {len(only_in_one)} characters are in one of the two only"
        self._out.print(f"usdrigui: compared {before} and {after}: {told}")

    def _changes(self, found: Difference) -> None:
        count = f"{len(found.displaced)} of {found.shared} common controls changed"
        went = sum(change.kind in ("added", "removed") for change in found.changes)
        renamed = f", {len(found.renamed)} were renamed" if found.renamed else ""
        self._out.print(f"{found.root}: {count}, {went} came or went{renamed}")
        if found.changes:
            self._table(_changes_table(found.changes))

    def _table(self, table: Table) -> None:
        self._out.print(_Whole(table), crop=False)

    def _live(self, status: Status, event: Event) -> None:
        status.update(Text(f"{event.stage}: {event.detail}" if event.detail else event.stage))

    def _now_and_then(self, event: Event) -> None:
        """In a log, a long search says how far it is every few seconds."""
        if event.detail and time.monotonic() - self._told > _PAUSE:
            self._told = time.monotonic()
            self._side.print(f"{event.stage:<14} {event.detail}", soft_wrap=True)

    def _plain(self, event: Event) -> None:
        if event.seconds is None:
            self._now_and_then(event)
        else:
            detail = f" {event.detail}" if event.detail else ""
            self._side.print(f"{event.stage:<14} {event.seconds:6.2f} s{detail}", soft_wrap=True)

    def _character(self, character: CharacterReport) -> None:
        elements = character.layout.elements
        existing = len(elements) - len(character.added)
        summary = f"{len(elements)} elements" + (f", {existing} of which are in another layer" if existing else "")
        self._out.print(f"{character.layout.variant_path or character.root}: {summary}")
        placed = [row for row in character.rows if not existing or row.element in character.added]
        if placed:
            self._table(_rows_table(placed))
        for note in character.notes:
            self._out.print(f"  note: {note.control}: {note.reason}")
        solution = character.assignment
        self._out.print(
            f"  on the {_where([character])} {character.count('face')}, on the board {character.count('board')}, "
            f"left off {character.count('left off')}; "
            f"handles on the {_where([character])} have {_percent(character.kept)} of the peak displacement"
            f"{f' ({_DISPLACEMENT})' if placed else ''}",
            soft_wrap=True,
        )
        self._out.print(
            f"  cost {solution.cost:.4f}, proven bound {solution.bound:.4f}, gap {solution.gap_in_play:.2e} of what "
            f"the choice can change ({solution.gap:.2e} of the cost), {_ending(solution)}"
        )
        if len(character.parts) > 1:
            for part in character.parts:
                proof = part.assignment
                self._out.print(
                    f"  {part.name}: {part.on_it} of {len(part.controls)} controls on it, cost {proof.cost:.4f}, "
                    f"gap {proof.gap:.2e}, {_ending(proof)}"
                )
        for which, found in character.matchings.items():
            self._matching(which, found)
        if character.difference is not None:
            self._out.print("since the previous layout:")
            self._changes(character.difference)

    def _matching(self, which: str, found: Matching) -> None:
        """What was matched with an existing layout, what is unsure and what is left."""
        sure = [each for each in found.matches if each not in found.unsure]
        count = len(found.matches) + len(found.left_before)
        reasons = Counter(each.reason for each in sure)
        told = ", ".join(f"{number} by {reason}" for reason, number in reasons.items())
        which = which if which.startswith("/") else f"--{which}"
        self._out.print(
            f"  {which}: {len(sure)} of {count} controls matched{f': {told}' if told else ''}", soft_wrap=True
        )
        if found.unsure:
            pairs = (f"{each.before} may be {each.after} ({each.confidence:.0%} sure)" for each in found.unsure)
            self._out.print(f"    unsure: {', '.join(pairs)}", soft_wrap=True)
        if found.left_before:
            self._out.print(f"    without a counterpart: {', '.join(found.left_before)}", soft_wrap=True)

    def _issues(self, issues: Sequence[Issue]) -> None:
        for found in issues:
            where = f" {found.path}:" if found.path else ""
            self._out.print(f"{found.severity}: {found.code}{where} {sentences(found)}", soft_wrap=True)

    def _seconds(self, seconds: Sequence[tuple[str, float]]) -> None:
        parts = ", ".join(f"{stage} {value:.2f}" for stage, value in seconds)
        self._out.print(f"  seconds: {parts}; stages took {sum(value for _, value in seconds):.2f}")


def _ignore(event: Event) -> None:
    del event


def _rows_table(rows: Sequence[ControlRow]) -> Table:
    table = _table("control", "kind", "place", "element", "twin", "displacement", "why")
    for row in rows:
        share = _percent(row.kept) if math.isfinite(row.kept) else ""
        place = "board" if row.place == "board" else row.place
        element = row.element if row.element != row.control else ""
        table.add_row(*map(_cell, (row.control, row.kind, place, element, row.twin, share, row.reason)))
    return table


def _review_table(elements: Sequence[ElementReview]) -> Table:
    table = _table("element", "displacement", "linear", "overlap", "nearest", "handles apart", "improvement", "at")
    for each in elements:
        apart = f"{each.distance:.1f} w" if math.isfinite(each.distance) else ""
        gain = f"{each.gain:.3f}" if each.better else ""
        numbers = (_percent(each.kept), f"{each.linear:.3f}", f"{each.overlap:.3f}")
        table.add_row(*map(_cell, (each.element, *numbers, each.nearest, apart, gain, each.better)))
    return table


def _changes_table(changes: Sequence[Change]) -> Table:
    table = _table("control", "change", "element", "by", "before", "now", "why")
    for change in changes:
        by = f"{change.distance:.1f} w" if math.isfinite(change.distance) else ""
        element = change.element if change.element != change.control else ""
        why = ((f"was {change.was}",) if change.was else ()) + change.why
        cells = (change.control, change.kind, element, by, change.before, change.after, "; ".join(why))
        table.add_row(*map(_cell, cells))
    return table


def _batch_table(rows: Sequence[Row]) -> Table:
    table = _table("asset", "outcome", "face", "board", "off", "gap", "warnings", "seconds", "why")
    for row in rows:
        counts = [str(each) if row.sound else "" for each in (row.face, row.board, row.left_off)]
        gap = f"{row.gap:.1e}" if row.sound else ""
        why = f"{row.code} {row.message}".strip()
        cells = (row.asset, row.outcome, *counts, gap, str(row.warnings or ""), f"{row.seconds:.2f}", why)
        table.add_row(*map(_cell, cells))
    return table


def _facts_table(controls: Sequence[ControlFacts], *, several: bool = False) -> Table:
    """One row a control, with its part where the character has `several`."""
    part = ("part",) if several else ()
    table = _table("control", *part, "kind", "range", "from", "points", "coverage", "peak", "twin", "flags")
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
        table.add_row(*map(_cell, cells))
    return table


def _use_table(controls: Sequence[UseFacts]) -> Table:
    table = _table("control", "use", "active", "importance")
    for each in controls:
        table.add_row(*map(_cell, (each.control, f"{each.use:.3f}", _percent(each.active), f"{each.importance:.2f}")))
    return table


def _cell(text: str) -> Text:
    return Text(visible(text))


def _table(*columns: str) -> Table:
    table = Table(box=None, pad_edge=False, padding=(0, _GAP, 0, 0))
    for column in columns:
        table.add_column(column, overflow="fold", no_wrap=column not in _WRAPPED)
    return table


def _verdict(report: Report) -> str:
    face = sum(character.count("face") for character in report.characters)
    total = sum(len(character.rows) for character in report.characters)
    target = f" {report.output}" if report.output else ""
    gap = max((character.assignment.gap for character in report.characters), default=0.0)
    where = _where(report.characters)
    return f"usdrigui: {report.outcome}{target}: {face} of {total} controls on the {where}, gap {gap:.1e}"


def _where(characters: Sequence[CharacterReport]) -> str:
    """What controls stand on: the one part that there is, or the character."""
    parts = {part.name for character in characters for part in character.parts}
    return next(iter(parts)) if len(parts) == 1 else "character" if parts else "face"


def _ending(solution: Assignment) -> str:
    """What closed the problem, the limit that came first, or that neither did."""
    if solution.status == "optimal":
        return f"proved by {solution.closed_by}"
    if not solution.closed_by:
        return "not proved"
    return f"stopped by the {solution.closed_by}" if "limit" in solution.closed_by else "interrupted"


def _percent(share: float) -> str:
    if 0.0 < share < 0.005:
        return "<1 %"
    return f"{100 * share:.0f} %" if math.isfinite(share) else "-"
