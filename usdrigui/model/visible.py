"""Which elements of two levels are visible together.

With nothing opened every element is visible that is not a member of a coarse one.  Opening a coarse
element shows its members in its place, and opens the element on the other side of the character
with it.  Python only: the Blender extension takes this file along as it is.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping


def is_visible(name: str, members: Mapping[str, Collection[str]], opened: Collection[str]) -> bool:
    """Whether an element is visible with some coarse ones `opened`; `members` are those of each
    coarse element by its name."""
    if name in opened:
        return False
    holders = {coarse for coarse, inner in members.items() if name in inner}
    return not holders or not holders.isdisjoint(opened)


def opened_with(name: str, mirror: str, members: Collection[str]) -> frozenset[str]:
    """What opens when a coarse element is opened."""
    return frozenset({name, mirror}.intersection(members))
