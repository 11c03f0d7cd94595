"""What the names of controls hint about sides; never more than a hint.

Names come from many hands: ``browDown_L``, ``eye-left-slit``, ``l-brow``, ``Look_In_Right``,
``.Lsmile``; and in ``mouthLeft`` the word is a direction.  Either way the mirror image swaps the
words.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Literal

Side = Literal["left", "right", ""]
_WORDS = re.compile(
    r"[a-z]{3,}?(?=(?:left|right)(?![a-z]))|[A-Z]+(?![a-z])|[A-Z][a-z]*|[a-z]+|\d+"
    r"|[左右]|[^A-Za-z\d左右]+"
)
_NAMES: tuple[Side, Side] = ("left", "right")
_PAIRS = (("left", "right"), ("l", "r"), ("lf", "rt"), ("lt", "rt"), ("lb", "rb"), ("左", "右"))
"""Words for the sides; ``lt`` and ``lb`` are quarters of a mouth: left top, left bottom."""
SIDES: Mapping[str, Side] = {
    word: side for pair in _PAIRS for word, side in zip(pair, _NAMES, strict=True)
}
"""The side that a word names."""
_SWAPPED = dict(_PAIRS) | {right: left for left, right in reversed(_PAIRS)}


@cache
def mirrored(name: str) -> str:
    """`name` with the words for left and right swapped, lower case; equal to it when it has
    none."""
    return "".join(_SWAPPED.get(word, word) for word in _words(name))


def hints_at_twin(name: str, other: str) -> bool:
    """True when one name is the other with its sides swapped, and has a side at all."""
    one, two = name.lower(), other.lower()
    swapped = one != two and (mirrored(name) == two or mirrored(other) == one)
    return swapped or _differ_by_initial(name, other)


def _differ_by_initial(name: str, other: str) -> bool:
    """``.Lsmile`` and ``.Rsmile``: a side glued to the front of a word."""
    apart = [i for i, (a, b) in enumerate(zip(name, other, strict=False)) if a != b]
    if (
        len(name) != len(other)
        or len(apart) != 1
        or {name[apart[0]].lower(), other[apart[0]].lower()} != {"l", "r"}
    ):
        return False
    before = name[: apart[0]][-1:]
    return not before.isalpha() or (name[apart[0]].isupper() and before.islower())


def has_side(name: str) -> bool:
    """True when the name has a word for left or right."""
    return any(word in SIDES for word in _words(name))


def side_of(name: str) -> Side:
    """``left`` or ``right`` where the name has words for one of them only, else empty."""
    sides = {SIDES[word] for word in _words(name) if word in SIDES}
    return sides.pop() if len(sides) == 1 else ""


def twins_by_name(names: Iterable[str]) -> Mapping[str, str]:
    """Each name that has another one with its sides swapped, to that."""
    every = sorted(names)
    return {a: b for a in every for b in every if a != b and hints_at_twin(a, b)}


def _words(name: str) -> list[str]:
    return [word.lower() for word in _WORDS.findall(name)]
