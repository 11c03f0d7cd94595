"""What the names of controls hint about sides; never more than a hint.

Names come from many hands: ``browDown_L``, ``eye-left-slit``, ``l-brow``, ``Look_In_Right``, ``.Lsmile``;
and in ``mouthLeft`` the word is a direction.  Either way the mirror image swaps the words.
"""

from __future__ import annotations

import re

_WORDS = re.compile(r"[A-Z]+(?![a-z])|[A-Z][a-z]*|[a-z]+|\d+|[^A-Za-z\d]+")
_SWAPPED = {"left": "right", "right": "left", "l": "r", "r": "l", "lf": "rt", "rt": "lf"}


def mirrored(name: str) -> str:
    """`name` with the words for left and right swapped, lower case; equal to it when it has none."""
    return "".join(_SWAPPED.get(word, word) for word in _words(name))


def hints_at_twin(name: str, other: str) -> bool:
    """True when one name is the other with its sides swapped, and has a side at all."""
    swapped = mirrored(name)
    return swapped != name.lower() and swapped == other.lower()


def has_side(name: str) -> bool:
    """True when the name has a word for left or right."""
    return any(word in _SWAPPED for word in _words(name))


def _words(name: str) -> list[str]:
    return [word.lower() for word in _WORDS.findall(name)]
