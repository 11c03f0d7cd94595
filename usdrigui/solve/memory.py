"""How much memory a residual's tables of pairs will take, before they are made."""

from __future__ import annotations

from usdrigui.model import Indices
from usdrigui.solve.cells import BYTES_PER_PAIR as BYTES_PER_LINK
from usdrigui.solve.cells import PAIRS
from usdrigui.solve.crowding import FEWEST, IN_PLAY
from usdrigui.solve.residual import Residual
from usdrigui.solve.search import HELD_BYTES

BYTES_PER_PAIR = 250
"""Of a near pair of blocks: itself, and in keys and tables while those of two rounds are held."""
BYTES_PER_TABLED = 105
"""Of one in near pairs and tables alone."""
BYTES_PER_PLAYING, BYTES_PER_SETTLED = 12, 8
"""Of a pair of entries in play, and of one with any entry, while prices are looked for."""
BYTES_PER_PRICED = 24
"""Of an entry of the tables of priced costs, while those of two rounds are held."""


def planned(residual: Residual, parts: Indices) -> float:
    """MiB needed when every block is replaced by so many parts: near pairs, their keys while sorted, the tables of
    two rounds, with what prices link in both, and the matrices of a search."""
    pairs = sum(int((parts[each.first] * parts[each.second]).sum()) for each in residual.near)
    return _linked(residual) / 2**20 + planned_for_pairs(pairs)


def planned_for_pairs(pairs: int) -> float:
    """MiB needed for so many near pairs of elements."""
    return max(BYTES_PER_PAIR * pairs, BYTES_PER_TABLED * pairs + HELD_BYTES) / 2**20


def planned_for_prices(residual: Residual) -> float:
    """MiB needed to price the residual's entries: its own tables, those of all pairs that prices may link, and what
    entries in play cost each other and everyone else, twice."""
    pairs, entries = sum(len(each.first) for each in residual.near), len(residual.pool.cost)
    links = min(PAIRS, entries**2 // 2)
    playing = min(entries, max(IN_PLAY, FEWEST * residual.pool.count))
    ascent = playing * (BYTES_PER_PLAYING * playing + BYTES_PER_SETTLED * entries)
    tables = BYTES_PER_TABLED * pairs + _linked(residual)
    return (tables + BYTES_PER_LINK * links + max(HELD_BYTES, ascent)) / 2**20


def _linked(residual: Residual) -> int:
    """Bytes of the tables of priced costs that there are."""
    return BYTES_PER_PRICED * residual.dual.size if residual.priced else 0
