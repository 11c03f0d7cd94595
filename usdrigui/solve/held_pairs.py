"""Pairs of the entries in play that cells hold: a tenth or so of all pairs, and all that a change of prices touches."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.model import Flags, Indices


class HeldPairs:
    """The pairs of entries in play, of different variables, that some cell holds or held."""

    def __init__(self, variable_of: Indices, variables: int) -> None:
        from scipy.sparse import csr_array  # a tenth of a second, for those who price spots

        size = len(variable_of)
        self._variable_of, self._variables = variable_of, variables
        self._number = np.full(size**2, -1, dtype=np.int32)
        """(m * m,) number of each pair, first entry before the second; -1 of those in no cell."""
        none = np.empty(0, dtype=np.int64)
        self.above, self.below = none, none
        """(pairs,) where the pair stands in a matrix of all, flat: above the diagonal and below."""
        self.variable = none
        """(pairs,) of the first entry."""
        self.multipliers = (none, none)
        """(pairs,) each: where in (m, variables) flat the multipliers of the two entries stand, each with the other's
        variable."""
        self.cells = csr_array((0, 0), dtype=np.float32)
        """(cells, pairs) one for each pair inside each cell."""

    def enter(self, inside: Sequence[Indices]) -> None:
        """Take cells that hold these entries."""
        from scipy.sparse import csr_array

        held = [self._pairs(each) for each in inside]
        at = np.concatenate([np.empty(0, dtype=np.int64), *held])
        new = at[self._number[at] < 0]
        self._number[new] = np.arange(len(new))
        new = new[self._number[new] == np.arange(len(new))]  # each once
        self._number[new] = len(self.above) + np.arange(len(new))
        self._append(new)
        start = self.cells.indptr[-1] + np.cumsum([len(each) for each in held])
        columns = np.concatenate([self.cells.indices, self._number[at]])
        rows = np.concatenate([self.cells.indptr, start]).astype(np.int32)
        ones = np.ones(len(columns), dtype=np.float32)
        self.cells = csr_array((ones, columns, rows), (len(rows) - 1, len(self.above)))

    def drop(self, kept: Flags) -> None:
        """Forget the other cells; their pairs stay, with what was taken off them."""
        self.cells = self.cells[kept]

    def _pairs(self, inside: Indices) -> Indices:
        variable = self._variable_of[inside]
        return np.asarray((inside[:, None] * len(self._variable_of) + inside)[variable[:, None] < variable])

    def _append(self, new: Indices) -> None:
        first, second = np.divmod(new, len(self._variable_of))
        self.above = np.concatenate([self.above, new])
        self.below = np.concatenate([self.below, second * len(self._variable_of) + first])
        self.variable = np.concatenate([self.variable, self._variable_of[first]])
        found = (
            first * self._variables + self._variable_of[second],
            second * self._variables + self._variable_of[first],
        )
        self.multipliers = (
            np.concatenate([self.multipliers[0], found[0]]),
            np.concatenate([self.multipliers[1], found[1]]),
        )
