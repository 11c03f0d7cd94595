"""Topology of one half of the head: a grid with blocks cut out and filled by concentric loops.

The left half (x >= 0) is a grid of rows (crown to neck) and columns (front to back), closed by a quad cap
on the crown.  Where a feature sits, a block of cells is removed and replaced by loops with as many vertices
as the block's outline, so that loops ring the eye, the mouth, the ear and the nostril and all faces stay quads.
"""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

ROWS = 36
COLUMNS = 28
CAP_WIDTH = 7
CAP_LENGTH = COLUMNS - 2 * CAP_WIDTH


@dataclass(frozen=True)
class Block:
    """Grid cells removed for a feature."""

    row: int
    column: int
    rows: int
    columns: int

    def outline(self) -> list[tuple[int, int]]:
        """Clockwise seen from outside, from the middle of the front side; an open path where it meets the plane."""
        top, bottom = self.row, self.row + self.rows
        front, back = self.column, self.column + self.columns
        middle = self.row + self.rows // 2
        upper = [(top, column) for column in range(front, back)]
        lower = [(bottom, column) for column in range(back, front - 1, -1)]
        rear = [(row, back) for row in range(top, bottom)]
        if front == 0:
            return [*upper, *rear, *lower]
        rising = [(row, front) for row in range(middle, top, -1)]
        return [*rising, *upper, *rear, *lower[:-1], *[(row, front) for row in range(bottom, middle, -1)]]

    def covers(self, row: int, column: int) -> bool:
        """Whether the cell lies in the block."""
        return self.row <= row < self.row + self.rows and self.column <= column < self.column + self.columns

    def swallows(self, row: int, column: int) -> bool:
        """Whether the vertex lies strictly inside the block (inside or on the mid-plane where the block meets it)."""
        first = self.column if self.column > 0 else -1
        return self.row < row < self.row + self.rows and first < column < self.column + self.columns


BLOCKS = {
    "eye": Block(row=6, column=3, rows=4, columns=8),
    "mouth": Block(row=19, column=0, rows=4, columns=6),
    "nostril": Block(row=15, column=1, rows=2, columns=2),
    "ear": Block(row=10, column=16, rows=6, columns=4),
}
RINGS = {"eye": 8, "mouth": 10, "nostril": 3, "ear": 8}
"""Loops per feature; the first is the block's outline."""
FILLED = ("nostril", "ear")
"""Features whose last loop is closed with the grid that was cut out."""


@dataclass
class Cage:
    """Vertices by key and quads (a few triangles) by vertex number."""

    number: dict[Hashable, int] = field(default_factory=dict)
    faces: list[tuple[int, ...]] = field(default_factory=list)
    loops: dict[str, list[list[int]]] = field(default_factory=dict)
    """Per feature, per loop, the vertices in the outline's order."""
    fills: dict[str, list[int]] = field(default_factory=dict)
    """Per filled feature, the vertices inside the last loop."""

    def vertex(self, key: Hashable) -> int:
        """Number of the vertex with this key, made on first use."""
        return self.number.setdefault(key, len(self.number))

    def grid(self, row: int, column: int) -> int:
        """Number of a grid vertex."""
        return self.vertex(("grid", row, column))


def half_cage() -> Cage:
    """Build the left half of the head."""
    cage = Cage()
    _add_grid(cage)
    _add_cap(cage)
    for name, block in BLOCKS.items():
        _add_loops(cage, name, block)
    _close_mouth(cage)
    return cage


def cap_key(step: int, along: int) -> tuple[str, int, int]:
    """Key of a crown vertex: `step` columns from the mid-plane, `along` rows from the front."""
    if along == 0:
        return ("grid", 0, step)
    if step == CAP_WIDTH:
        return ("grid", 0, CAP_WIDTH + along)
    if along == CAP_LENGTH:
        return ("grid", 0, COLUMNS - step)
    return ("cap", step, along)


def _add_grid(cage: Cage) -> None:
    for row in range(ROWS):
        for column in range(COLUMNS + 1):
            if not any(block.swallows(row, column) for block in BLOCKS.values()):
                cage.grid(row, column)
    for row in range(ROWS - 1):
        for column in range(COLUMNS):
            if not any(block.covers(row, column) for block in BLOCKS.values()):
                corners = ((row, column), (row + 1, column), (row + 1, column + 1), (row, column + 1))
                cage.faces.append(tuple(cage.grid(*corner) for corner in corners))


def _add_cap(cage: Cage) -> None:
    for along in range(CAP_LENGTH):
        for step in range(CAP_WIDTH):
            corners = ((step, along), (step + 1, along), (step + 1, along + 1), (step, along + 1))
            cage.faces.append(tuple(cage.vertex(cap_key(*corner)) for corner in corners))


def _add_loops(cage: Cage, name: str, block: Block) -> None:
    outline = block.outline()
    rings = [[cage.grid(*corner) for corner in outline]]
    rings += [[cage.vertex((name, ring, place)) for place in range(len(outline))] for ring in range(1, RINGS[name])]
    for outer, inner in pairwise(rings):
        cage.faces.extend(_strip(outer, inner, closed=block.column > 0))
    cage.loops[name] = rings
    if name in FILLED:
        _fill(cage, name, block, dict(zip(outline, rings[-1], strict=True)))


def _strip(outer: Sequence[int], inner: Sequence[int], closed: bool) -> list[tuple[int, ...]]:
    count = len(outer)
    following = [(place, (place + 1) % count) for place in range(count if closed else count - 1)]
    return [(outer[a], inner[a], inner[b], outer[b]) for a, b in following]


def _fill(cage: Cage, name: str, block: Block, rim: dict[tuple[int, int], int]) -> None:
    def corner(row: int, column: int) -> int:
        return rim[row, column] if (row, column) in rim else cage.vertex((name, "fill", row, column))

    rows = range(block.row, block.row + block.rows)
    columns = range(block.column, block.column + block.columns)
    for row in rows:
        for column in columns:
            corners = ((row, column), (row + 1, column), (row + 1, column + 1), (row, column + 1))
            cage.faces.append(tuple(corner(*place) for place in corners))
    cage.fills[name] = [corner(row, column) for row in rows[1:] for column in columns[1:]]


def _close_mouth(cage: Cage) -> None:
    """Zip the last loop of the mouth bag shut: upper against lower vertices, a triangle at the corner."""
    last = cage.loops["mouth"][-1]
    corner = len(last) // 2
    for place in range(corner - 1):
        low = len(last) - 1 - place
        cage.faces.append((last[place], last[low], last[low - 1], last[place + 1]))
    cage.faces.append((last[corner - 1], last[corner + 1], last[corner]))
