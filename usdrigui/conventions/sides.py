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
    # Viseme_L and Viseme_R are the sounds; in Viseme_AA_L the letter is the side.
    r"(?i:(?:viseme|phoneme)s?[^A-Za-z]*[lr])(?=[^A-Za-z]*$)"
    r"|[a-z]{3,}?(?=(?:left|right)(?![a-z]))|[A-Z]+(?![a-z])|[A-Z][a-z]*|[a-z]+|\d+"
    r"|[左右]|[^A-Za-z\d左右]+"
)
_INITIAL = re.compile(r"(?:(?<![^\W\d_])[LRlr]|(?<=[a-z])[LR])(?=[^\W\d_])")
"""The first letter of a word that goes on: a letter alone is a word."""
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
    """True when one name is the other with its sides swapped, and has a side at all; also one glued
    to the front of a word, as in ``.Lsmile`` and ``.Rsmile``."""
    one, two = name.lower(), other.lower()
    swapped = mirrored(name) == two or mirrored(other) == one
    glued = _INITIAL.sub("*", name) == _INITIAL.sub("*", other)
    return one != two and (swapped or glued)


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
