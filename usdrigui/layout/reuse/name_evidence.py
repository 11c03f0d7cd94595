"""The evidence of the names of two rigs' controls on which is which."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from usdrigui.character import Flags, Floats
from usdrigui.conventions import Meaning, Spelling, meanings, same_act, spellings

CHANCE = 2.5
"""Evidence that chance alone may give a pair, for it or against it: names all of whose words mean
the same, the same number from an exporter that counts shapes anew, another action, another motion
where shapes are replaced."""
SAME = 12.0
"""Of one name, however it is spelt, or one motion."""
_SAME_ACTION = 4.5
"""Of two names that mean one action of the field's conventions, or one action unit; less where
several of a rig do."""
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
            if (name == other or one == two) and not one.is_number:
                found[i, j] = SAME
            else:
                senses = meant[0][i], meant[1][j]
                found[i, j] = (
                    CHANCE * len(one.senses & two.senses) / max(1, len(one.senses | two.senses))
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
        return -CHANCE
    return _SAME_ACTION - float(np.log(max(first[_sense(one)], second[_sense(two)])))


def _other_side(
    one: Meaning | None, two: Meaning | None, first: Spelling, second: Spelling
) -> bool:
    """Whether one of two names has another side than the other, or none."""
    if one is not None and two is not None:
        return one.side != two.side
    return first.side != second.side
