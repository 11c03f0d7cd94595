"""Names of controls as labels, and of the elements that several share."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

BETWEEN = ("_", "+", "__", "++")
"""Joins the names of the controls of an element."""
_WORDS = re.compile(r"[A-Z]+(?![a-z])|[A-Z][a-z]*|[a-z]+|\d+|[^A-Za-z\d]+")


def element_name(controls: Sequence[str], known: Collection[str]) -> str:
    """Name of the element of some controls: theirs, joined so that no other of the controls `known`
    have that name.

    Of ``smile`` and ``50`` it is ``smile_50``, and ``smile+50`` where there is a control
    ``smile_50``.
    """
    joined = {between: between.join(controls) for between in BETWEEN}
    clear = (
        name
        for between, name in joined.items()
        if len(controls) == 1 or _readings(name, between, known) < 2
    )
    return next(clear, joined[BETWEEN[-1]])


def _readings(name: str, between: str, known: Collection[str]) -> int:
    """In how many ways a name can be read as one of those known, or as several of them joined."""
    parts = name.split(between)
    readings = [1]  # of what comes before each part
    for end in range(1, len(parts) + 1):
        firsts = (start for start in range(end) if between.join(parts[start:end]) in known)
        readings.append(sum(readings[start] for start in firsts))
    return readings[-1]


def common_label(labels: list[str]) -> str:
    """One label for controls that share an element: their common words, then those in which they
    differ.

    ``eyeLookIn_L`` and ``eyeLookOut_L`` become ``eyeLook In/Out L``; labels with nothing in common
    are joined by slashes.
    """
    parts = [_WORDS.findall(label) for label in labels]
    least = min(map(len, parts))
    head = next((i for i in range(least) if len({words[i] for words in parts}) > 1), least)
    tail = next(
        (i for i in range(least - head) if len({words[-1 - i] for words in parts}) > 1),
        least - head,
    )
    middles = ["".join(words[head : len(words) - tail]).strip("_-. ") for words in parts]
    if not (head or tail) or not all(middles):
        return " / ".join(labels)
    words, *_ = parts
    begin, end = (
        "".join(each).strip("_-. ") for each in (words[:head], words[len(words) - tail :])
    )
    return " ".join(each for each in (begin, "/".join(middles), end) if each)
