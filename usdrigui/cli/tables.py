"""Lines and tables of text as wide as the terminal: what does not fit in a row of a table goes
below it, and nothing is lost."""

from __future__ import annotations

import os
import shutil
import textwrap
from collections.abc import Iterator, Sequence
from typing import TextIO

from rich.cells import cell_len

_GAP = 2
"""Characters between two columns."""
_INDENT = "    "
"""Before what stands below its row."""
_LONGEST = 40
"""Characters of the first cell after which the row goes on in the next line."""


def columns(stream: TextIO | None) -> int | None:
    """Characters in a line of a stream: of its terminal, or ``COLUMNS``; None in a log, whose lines
    stay whole."""
    if os.environ.get("COLUMNS", "").isdecimal() or (stream is not None and stream.isatty()):
        return max(shutil.get_terminal_size().columns, 1)
    return None


def wrapped(text: str, width: int | None, indent: str = "  ") -> list[str]:
    """Text in lines of at most `width` characters, broken between words alone; all but the first
    begin with `indent` more than the text itself."""
    if width is None:
        return [text]
    own = text[: len(text) - len(text.lstrip())]
    lines = textwrap.wrap(
        text.strip(),
        max(width, 20),
        initial_indent=own,
        subsequent_indent=own + indent,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return lines or [""]


class Table:
    """Rows under headers; `below` names columns that need no header and are long: they stand below
    their row unless all fits in one line."""

    def __init__(self, *headers: str, below: Sequence[str] = ()) -> None:
        self._headers = headers
        self._below = below
        self._rows: list[tuple[str, ...]] = []

    def add_row(self, *cells: str) -> None:
        """Cells in the order of the headers."""
        self._rows.append(cells)

    def lines(self, width: int) -> Iterator[str]:
        """The table in lines of at most `width` characters, as far as words are not longer than
        that."""
        widths = [
            max(map(cell_len, column)) for column in zip(self._headers, *self._rows, strict=True)
        ]
        widths[0] = min(widths[0], _LONGEST, max(width // 2, 1))
        shown = self._fitting(widths, width)
        yield _joined([self._headers[i] for i in shown], [widths[i] for i in shown])
        for row in self._rows:
            cells = [row[i] for i in shown]
            if cell_len(cells[0]) > widths[0]:
                yield cells[0]
                cells[0] = ""
            yield _joined(cells, [widths[i] for i in shown])
            hidden = [i for i in range(len(row)) if i not in shown and row[i]]
            lines = (
                row[i] if self._headers[i] in self._below else f"{self._headers[i]} {row[i]}"
                for i in hidden
            )
            if hidden:
                yield from wrapped(_INDENT + "; ".join(lines), width, "")

    def _fitting(self, widths: Sequence[int], width: int) -> list[int]:
        """The columns that stand beside each other: all that have a cell, or else from the left as
        many as fit."""
        used = [
            i for i, column in enumerate(zip(*self._rows, strict=True)) if i == 0 or any(column)
        ]
        if sum(widths[i] + _GAP for i in used) - _GAP <= width:
            return used
        shown, room = [0], width - widths[0]
        for i in used[1:]:
            if self._headers[i] not in self._below and widths[i] + _GAP <= room:
                shown.append(i)
                room -= widths[i] + _GAP
        return shown


def _joined(cells: Sequence[str], widths: Sequence[int]) -> str:
    padded = (
        cell + " " * (width - cell_len(cell) + _GAP)
        for cell, width in zip(cells, widths, strict=True)
    )
    return "".join(padded).rstrip()
