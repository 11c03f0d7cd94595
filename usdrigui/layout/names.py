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
    return (swapped != name.lower() and swapped == other.lower()) or _differ_by_initial(name, other)


def _differ_by_initial(name: str, other: str) -> bool:
    """``.Lsmile`` and ``.Rsmile``: a side glued to the front of a word."""
    apart = [i for i, (a, b) in enumerate(zip(name, other, strict=False)) if a != b]
    if len(name) != len(other) or len(apart) != 1 or {name[apart[0]].lower(), other[apart[0]].lower()} != {"l", "r"}:
        return False
    before = name[: apart[0]][-1:]
    return not before.isalpha() or (name[apart[0]].isupper() and before.islower())


def has_side(name: str) -> bool:
    """True when the name has a word for left or right."""
    return any(word in _SWAPPED for word in _words(name))


def side_of(name: str) -> str:
    """``left`` or ``right`` where the name has words for one of them only, else empty."""
    said = {"left" if word in ("left", "l", "lf") else "right" for word in _words(name) if word in _SWAPPED}
    return said.pop() if len(said) == 1 else ""


def is_step_of(name: str, other: str) -> bool:
    """True when `name` is `other` with a number behind it, as flattened in-betweens are called."""
    stem = re.fullmatch(r"(.*[A-Za-z].*?)[ _.:-]?\d+", name)
    return stem is not None and stem[1].lower() == other.lower()


def common_label(labels: list[str]) -> str:
    """One label for controls that share an element: what they have in common, and what tells them apart.

    ``eyeLookIn_L`` and ``eyeLookOut_L`` become ``eyeLook In/Out L``; labels with nothing in common are
    joined by slashes.
    """
    if len(labels) == 1:
        return labels[0]
    parts = [_WORDS.findall(label) for label in labels]
    least = min(len(words) for words in parts)
    head = next((i for i in range(least) if len({words[i] for words in parts}) > 1), least)
    tail = next((i for i in range(least - head) if len({words[-1 - i] for words in parts}) > 1), least - head)
    middles = ["".join(words[head : len(words) - tail]).strip("_-. ") for words in parts]
    if not (head or tail) or not all(middles):
        return " / ".join(labels)
    ends = "".join(parts[0][:head]), "".join(parts[0][len(parts[0]) - tail :] if tail else [])
    return " ".join(each for each in (ends[0].strip("_-. "), "/".join(middles), ends[1].strip("_-. ")) if each)


def _words(name: str) -> list[str]:
    return [word.lower() for word in _WORDS.findall(name)]
