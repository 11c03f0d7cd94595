"""Where a command shows its progress and its outcome."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, TypeAlias

from usdrigui.cli.lines import columns, tell
from usdrigui.cli.terminal.table import Table, Verbatim

if TYPE_CHECKING:
    from usdrigui.pipeline import Event

_LOG_WIDTH = 160
"""Columns where the output is not a terminal."""
_PAUSE = 5.0
"""Seconds between two lines about one long stage, where the output is not a terminal."""

ProgressCallback = Callable[["Event"], None]
Printed: TypeAlias = str | Table | Verbatim


class Screen:
    """Prints results on standard output, and progress for people on standard error."""

    def __init__(self, *, quiet: bool, machine: bool) -> None:
        self._quiet = quiet
        self._machine = machine
        self._silent = quiet or machine
        self._printed = time.monotonic()

    def show(self, document: Callable[[], str], lines: Iterable[Printed]) -> None:
        """The outcome of a command: its JSON document where one was asked for, else its lines, of
        which only the last, the closing line, where quiet."""
        if self._machine:
            sys.stdout.write(document())
            return
        for line in list(lines)[-1 if self._quiet else 0 :]:
            if isinstance(line, str):
                tell(line, sys.stdout)
            else:
                width = columns(sys.stdout) or _LOG_WIDTH
                sys.stdout.writelines(f"{each}\n" for each in line.lines(width))

    @contextmanager
    def progress(self) -> Iterator[ProgressCallback]:
        """A live line on a terminal, one plain line a stage elsewhere, nothing when quiet."""
        if self._silent:
            yield lambda _: None
        elif sys.stderr is not None and sys.stderr.isatty():
            from rich.console import Console  # as long to load as a layer takes to write
            from rich.text import Text

            console = Console(stderr=True, markup=False, highlight=False)
            with console.status("starting") as status:
                yield lambda event: status.update(
                    Text(f"{event.stage}: {event.detail}" if event.detail else event.stage)
                )
        else:
            yield self._plain

    def _plain(self, event: Event) -> None:
        """The seconds of a stage that has ended; the progress of a long one every few seconds."""
        if event.seconds is not None:
            tell(f"{event.stage:<14} {event.seconds:6.2f} s {event.detail}".rstrip(), sys.stderr)
        elif event.detail and time.monotonic() - self._printed > _PAUSE:
            self._printed = time.monotonic()
            tell(f"{event.stage:<14} {event.detail}", sys.stderr)

    def note(self, text: str) -> None:
        """A line of progress, unless quiet."""
        if not self._silent:
            tell(text, sys.stderr)
