"""The evidence of the names of two rigs' controls on which is which."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from usdrigui.character import Flags, Floats
from usdrigui.conventions import Meaning, Spelling, meanings, same_act, spellings

_SAME_NAME = 9.5
_SAME_SPELLING = 9.0
_NUMBER = 2.0
"""Of equal names that are mere numbers: exporters count shapes anew."""
_SAME_ACTION = 4.5
"""Of two names that mean one action of the field's conventions, or one action unit; less where
several of a rig do."""
_OTHER_ACTION = -2.5
_SHARED_WORDS = 2.5
"""Of names all of whose words mean the same; in proportion where some do."""
_OTHER_SIDE = 1.5
"""What names lose of which one has another side than the other, or none: rigs that mean the side of
the viewer are not rare."""


def name_evidence(before: Sequence[str], after: Sequence[str]) -> Floats:
    """(before, after) logarithms of odds that two names are of one control."""
    spelt, meant = (spellings(before), spellings(after)), (meanings(before), meanings(after))
    usual = tuple(Counter(_sense(each) for each in rig if each is not None) for rig in meant)
    found = np.zeros((len(before), len(after)))
    for i, name in enumerate(before):
        for j, other in enumerate(after):
            one, two = spelt[0][i], spelt[1][j]
            if name == other or one == two:
                found[i, j] = (
                    _NUMBER if one.is_number else _SAME_NAME if name == other else _SAME_SPELLING
                )
            else:
                senses = meant[0][i], meant[1][j]
                found[i, j] = (
                    _SHARED_WORDS
                    * len(one.senses & two.senses)
                    / max(1, len(one.senses | two.senses))
                    + _by_meaning(*senses, *usual)
                    - _OTHER_SIDE * _other_side(*senses, one, two)
                )
    return found


def same_meaning(before: Sequence[str], after: Sequence[str]) -> Flags:
    """(before, after) whether two names mean one action of the conventions."""
    one, two = meanings(before), meanings(after)
    same = [[bool(a and b and same_act(a.action, b.action)) for b in two] for a in one]
    return np.array(same, dtype=bool).reshape(len(one), len(two))


def _sense(meaning: Meaning) -> tuple[str, str]:
    return meaning.action.name, meaning.side


def _by_meaning(
    one: Meaning | None,
    two: Meaning | None,
    first: Counter[tuple[str, str]],
    second: Counter[tuple[str, str]],
) -> float:
    if one is None or two is None:
        return 0.0
    if not same_act(one.action, two.action):
        return _OTHER_ACTION
    return _SAME_ACTION - float(np.log(max(first[_sense(one)], second[_sense(two)])))


def _other_side(
    one: Meaning | None, two: Meaning | None, first: Spelling, second: Spelling
) -> bool:
    """Whether one of two names has another side than the other, or none."""
    if one is not None and two is not None:
        return one.side != two.side
    return first.side != second.side
