"""How much memory a residual's tables of pairs will take, before they are made."""

from __future__ import annotations

from usdrigui.model import Indices
from usdrigui.solve.cells import BYTES_PER_PAIR as BYTES_PER_LINK
from usdrigui.solve.cells import PAIRS
from usdrigui.solve.residual import Residual
from usdrigui.solve.search import HELD_BYTES

BYTES_PER_PAIR = 250
"""Of a near pair of blocks: itself, and in keys and tables while those of two rounds are held."""
BYTES_PER_TABLED = 105
"""Of one in near pairs and tables alone."""
BYTES_PER_PRICED = 24
"""Of an entry of the tables of priced costs, while those of two rounds are held."""


def planned(residual: Residual, parts: Indices) -> float:
    """MiB needed when every block is replaced by so many parts: near pairs, their keys while sorted, the tables of
    two rounds, with what prices link in both, and the matrices of a search."""
    pairs = sum(int((parts[each.first] * parts[each.second]).sum()) for each in residual.near)
    linked = BYTES_PER_PRICED * residual.dual.size if residual.priced else 0
    return (linked + _of_pairs(pairs)) / 2**20


def planned_at_worst(entries: int) -> float:
    """MiB needed for so many entries if every two of them are near."""
    return _of_pairs(entries**2 // 2) / 2**20


def planned_for_prices(residual: Residual) -> float:
    """MiB needed to price the residual's entries: its own tables, and those of all pairs that prices may link."""
    pairs = sum(len(each.first) for each in residual.near)
    links = min(PAIRS, len(residual.pool.cost) ** 2 // 2)
    return (BYTES_PER_TABLED * pairs + BYTES_PER_LINK * links + HELD_BYTES) / 2**20


def _of_pairs(pairs: int) -> int:
    return max(BYTES_PER_PAIR * pairs, BYTES_PER_TABLED * pairs + HELD_BYTES)
