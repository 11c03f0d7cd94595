"""How fast the reduction goes, and what its next round may spend."""

from __future__ import annotations

from dataclasses import dataclass

from usdrigui.solve.residual import Residual

NODES = 400
"""Of the first search of groups."""
NEAR = 0.02
"""Share of the way to the cut-off in which blocks are split while the bound rises well."""
SLOW = 0.1
"""Share of what the bound misses by which it rises slowly."""


@dataclass(frozen=True, slots=True)
class Pace:
    """How the rounds are going, and what the next one may spend."""

    nodes: int = NODES
    """Of the search of groups."""
    share: float = NEAR
    """Of the way from the bound to the cut-off in which blocks are split."""
    stuck: bool = False
    """Whether the last round raised the bound by little."""
    searched: bool = False
    """Whether a good layout was looked for longer than at first, because the bound rose slowly."""

    @property
    def slow(self) -> bool:
        """Whether splitting raises the bound by little."""
        return self.share > NEAR

    def after(self, before: Residual, examined: Residual, split: Residual, cut: float) -> Pace:
        """The pace after a round: before it, after its searches, and after the blocks were split."""
        slow = split.bound - examined.bound <= SLOW * (cut - examined.bound)
        return Pace(
            nodes=self.nodes * 2 if examined.exact else self.nodes * 5 // 4,
            share=min(1.0, 2.0 * self.share) if slow else NEAR,
            stuck=split.bound - before.bound < SLOW * (cut - before.bound),
            searched=self.searched or self.slow,
        )
