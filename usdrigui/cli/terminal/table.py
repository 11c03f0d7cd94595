"""Tables of text as wide as the terminal: what does not fit beside goes below its row, and nothing
is lost."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rich.cells import cell_len

from usdrigui.cli.lines import wrapped
from usdrigui.errors import visible

_GAP = 2
"""Characters between two columns."""
_INDENT = "    "
"""Before what stands below its row."""
_LONGEST = 40
"""Characters of the first cell after which the row goes on in the next line."""


class Table:
    """Rows under headers between bars: ``"control | change | why"``.  `below` names a column that
    needs no header and is long: it stands below its row unless all fits in one line."""

    def __init__(self, headers: str, rows: Iterable[Sequence[str]], below: str = "") -> None:
        self._headers = headers.split(" | ")
        self._below = below
        self._rows = [[visible(cell) for cell in row] for row in rows]

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
                row[i] if self._headers[i] == self._below else f"{self._headers[i]} {row[i]}"
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
            if self._headers[i] != self._below and widths[i] + _GAP <= room:
                shown.append(i)
                room -= widths[i] + _GAP
        return shown


class Verbatim:
    """Lines that are printed as they are, to be copied."""

    def __init__(self, text: str) -> None:
        self._text = text

    def lines(self, _: int) -> Iterator[str]:
        """The lines of the text."""
        return map(visible, self._text.splitlines())


def _joined(cells: Sequence[str], widths: Sequence[int]) -> str:
    padded = (
        cell + " " * (width - cell_len(cell) + _GAP)
        for cell, width in zip(cells, widths, strict=True)
    )
    return "".join(padded).rstrip()
