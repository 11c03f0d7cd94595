"""The words of a name, whatever its spelling, and the side that they name."""

from __future__ import annotations

import re
import unicodedata
from collections import Counter
from functools import cache

from usdrigui.conventions.sides import SIDES, Side
from usdrigui.conventions.tables import Words, known_words, phrases, table, vocabulary

_WORD = re.compile(
    r"[A-Z]{2,}(?=[a-z][A-Z])|[A-Z]+(?![a-z])|[A-Z][a-z]*|[a-z]+|\d+|[左右]|[^\W\d_A-Za-z左右]+"
)
_GAZE = frozenset({"look", "gaze", "turn"})
"""Words behind which the first side is where the eyes turn: EyesLookRightL, Eye_L_Look_R."""
_SHARED = 0.8
"""Share of a rig's names that begin (or end) with a word from which the word has no meaning."""
_SEVERAL = 3
"""Names of actions with which a word must begin to be their maker's."""


def words(name: str) -> Words:
    """The words of a name, lower case: ``eye-left-slit``, ``Look_In_Right`` and ``AU12L`` come
    apart alike."""
    codes = table("codes")
    found: list[str] = []
    for word in _WORD.findall(_in_english(unicodedata.normalize("NFKC", name))):
        # A side is glued to the front of a word that is known: LbrowUp.
        glued = word[0] in "LR" and word[1:] in vocabulary() and word.lower() not in vocabulary()
        found += [word[0], word[1:]] if glued else _unglued(word.lower())
    return tuple(codes["abbreviations"].get(word.lower(), word.lower()) for word in found)


def _in_english(name: str) -> str:
    """A name with the Japanese words in it that are known translated."""
    japanese = table("codes")["japanese"]
    if name.isascii() or name in japanese:
        return str(japanese.get(name, name))
    return _WORD.sub(lambda word: f"{japanese[word[0]]} " if word[0] in japanese else word[0], name)


@cache
def _unglued(word: str) -> Words:
    """The known words of which a word without capitals consists, the longest first: ``jawopen``,
    ``eyeblinkleft``, ``visemee``; the word itself where it is known or they do not make it up."""
    found = None if word in known_words() else _said(word) or _pieces(word)
    return found or (word,)


def _said(word: str) -> Words | None:
    """`word` as a word for visemes and the phoneme behind it, which may be one letter."""
    visemes = table("codes")["visemes"]
    heads = (head for head in visemes["words"] if len(head) > 2 and word.startswith(head))
    return next(
        ((head, word[len(head) :]) for head in heads if word[len(head) :] in visemes["phonemes"]),
        None,
    )


def _pieces(word: str) -> Words | None:
    """`word` as known words of two letters or more; None where it is no such row."""
    if not word:
        return ()
    for end in range(len(word), 1, -1):
        if word[:end] in known_words() and (rest := _pieces(word[end:])) is not None:
            return (word[:end], *rest)
    return None


def without_side(each: Words) -> tuple[Side, Words]:
    """The side that the words name, the last such word counting, and the words without it."""
    for i in reversed(range(len(each))):
        if each[i] in SIDES and len(each) > 1:
            return SIDES[each[i]], each[:i] + each[i + 1 :]
    return "", each


def side_and_direction(each: Words) -> tuple[Side, Side, Words]:
    """The side on which a control acts by its name, the one to which it may go, and the words
    without the two: one word holds both unless there is another one behind which the eyes look."""
    looks = [i for i, word in enumerate(each) if word in _GAZE]
    behind = [i for i, word in enumerate(each) if word in SIDES and looks and i > looks[0]]
    side, rest = without_side(each)
    if not behind or sum(word in SIDES for word in each) < 2:
        return side, side, rest
    side, rest = without_side(each[: behind[0]] + each[behind[0] + 1 :])
    return side, SIDES[each[behind[0]]], rest


def without_shared(names: list[Words]) -> list[Words]:
    """The names without the words that nearly all of them begin or end with."""
    for end in (0, -1):
        while len(names) > 2:
            most = Counter(each[end] for each in names if len(each) > 1).most_common(1)
            if not most or most[0][1] < _SHARED * len(names) or most[0][0] in SIDES:
                break
            kept = slice(1, None) if end == 0 else slice(None, -1)
            names = [
                each[kept] if len(each) > 1 and each[end] == most[0][0] else each for each in names
            ]
    return names


def without_makers(names: list[Words]) -> list[Words]:
    """The names without the word of their owner: a word of no convention with which several
    names begin that mean actions without it.  VRoid's Fcl_MTH_A is beside ARKit's names in some
    rigs."""
    while True:
        heads = Counter(each[0] for each in names if len(each) > 1 and is_action(each[1:]))
        found = {
            word for word, count in heads.items() if count >= _SEVERAL and word not in known_words()
        }
        if not found:
            return names
        names = [each[1:] if len(each) > 1 and each[0] in found else each for each in names]


@cache
def is_action(each: Words) -> bool:
    """Whether the words of a name are one of the phrases."""
    _, toward, rest = side_and_direction(each)
    return any(phrase.fits(rest, toward) for phrase in phrases())
