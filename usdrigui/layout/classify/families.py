"""Families: controls that belong together by the meaning of their names, in one group (beyond the
paper).

Visemes, emotions and moods of one part of the face are used as a set: half of them
on the lips and half on the board is worth less than either.  A family leaves the face as a whole
where the other controls make most of its motion, and is on the face as a whole where they do
not (a cartoon's five vowels are its only mouth controls). Moods of the whole face are made by those
of its parts, where a rig has both. Shapes of other people's heads, tongues and teeth are never on
the skin.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from usdrigui.character import Flags, Floats
from usdrigui.conventions import Meaning, distinctive_words, without_last_side
from usdrigui.layout.classify.basis import best_sum
from usdrigui.layout.shares import MOST

FamilyKind = Literal["viseme", "emotion", "identity", "interior", "combination"]

_WHOLE_FACE = "emotion"
"""Action of moods of the whole face."""
_WORDS = {
    "viseme": "visemes are grouped on the board",
    "emotion": "emotions are grouped on the board",
    "identity": "changes the identity of the character, not its expression",
    "interior": "moves the inside of the mouth",
    "combination": "corrects a combination of other controls",
}


@dataclass(frozen=True, slots=True)
class Family:
    """Controls that stay together."""

    kind: FamilyKind
    members: tuple[int, ...]
    """Motions."""
    reason: str = ""
    """Why it is off the face; empty if it is not."""


def find_families(
    names: Sequence[str],
    meanings: Sequence[Meaning | None],
    cosine: Floats,
    lost: Sequence[str],
) -> tuple[Family, ...]:
    """The families of a rig; a motion is in one at most.

    `names` and `meanings` (m,) of the controls of the motions, `cosine` (m, m) of the motions as
    vectors over the surface; `lost` are names of controls that were left off: what corrects a
    combination with one of them is none of its own.
    """
    found: dict[tuple[FamilyKind, str], list[int]] = {}
    products = _combinations([*names, *lost])
    for index, meaning in enumerate(meanings):
        kind = meaning.action.category if meaning is not None else "atom"
        if meaning is not None and kind in ("viseme", "emotion", "identity", "interior"):
            found.setdefault((kind, meaning.action.name), []).append(index)
        elif index in products:
            found.setdefault(("combination", ""), []).append(index)
    alone, with_parts = np.ones((2, len(names)), dtype=bool)
    for (which, key), members in found.items():
        alone[members] = False
        with_parts[members] = which in ("viseme", "emotion") and key != _WHOLE_FACE
    return tuple(
        _family(kind, tuple(members), with_parts if key == _WHOLE_FACE else alone, cosine)
        for (kind, key), members in sorted(found.items())
    )


def _family(kind: FamilyKind, members: tuple[int, ...], others: Flags, cosine: Floats) -> Family:
    if kind not in ("viseme", "emotion"):
        return Family(kind, members, _WORDS[kind])
    made = float(np.mean([best_sum(i, others, cosine).share for i in members]))
    if made < MOST:  # others do not make them: they stay on the face
        return Family(kind, members)
    return Family(kind, members, f"{_WORDS[kind]}; other controls make {made:.0%} of their motion")


def _combinations(names: Sequence[str]) -> frozenset[int]:
    """Names that are products of other controls' names: ``jawOpen_mouthSmileLeft``, and
    ``browDownEyeBlink_L`` beside ``browDown_L`` and ``eyeBlink_L``."""
    spelt = distinctive_words(names)
    known = {*spelt, *(bare for each in spelt if len(bare := without_last_side(each)) > 1)}
    return frozenset(i for i, each in enumerate(spelt) if _is_product(each, known))


def _is_product(each: tuple[str, ...], known: Collection[tuple[str, ...]]) -> bool:
    """Whether words are two or more names `known`, one behind the other."""
    cuts = range(1, len(each))
    return any(
        each[:at] in known and (each[at:] in known or _is_product(each[at:], known)) for at in cuts
    )
