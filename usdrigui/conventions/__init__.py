"""What the names of controls mean: the conventions of the field as one table.

Names are priors, never requirements: geometry overrules them (a rig may swap its sides), and a rig
whose names mean nothing is laid out by its motions alone.  But riggers share conventions, and a
cast that shares one should look alike.

A name is taken apart into words (`words`); words that nearly all names of a rig share in front or
behind are dropped; what is left is looked up among the codes of the conventions (``codes.toml``:
FACS numbers, phonemes, moods) and then read as a phrase (``phrases.toml``: *brow* and *up* is
`browUp`).  ``actions.toml`` defines the actions.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from usdrigui.conventions.name_words import (
    is_action,
    side_and_direction,
    without_makers,
    without_shared,
    without_side,
    words,
)
from usdrigui.conventions.sides import SIDES, Side
from usdrigui.conventions.tables import (
    Action,
    Words,
    action_of_unit,
    actions,
    joysticks,
    phrases,
    synonyms,
    table,
    units_of,
    vocabulary,
)

__all__ = [
    "Action",
    "Meaning",
    "Spelling",
    "actions",
    "distinctive_words",
    "joysticks",
    "meanings",
    "same_act",
    "same_name",
    "spellings",
    "without_last_side",
    "words",
]

_VERSION = re.compile(r"(?<=[^_])_[vV]\d+$")
"""Of a sculpt, behind its name: ``Angry_v2``."""
_MIDDLES = frozenset({"m", "mid", "middle", "c", "center", "centre"})
_CODED = 0.5
"""Share of a rig's names that are numbers of action units from which its numbers are such."""
_FOLLOWED = 0.5
"""Share of letters that are followed by the next one, beyond which they count; of the consonants of
ARPABET, where phonemes are densest, 8 of 16 are."""


@dataclass(frozen=True, slots=True)
class Meaning:
    """How a name is read."""

    action: Action
    side: Side
    """Side of the character on which it acts by its name; a guess that geometry
    overrules."""
    middle: bool = False
    """Whether it acts in the middle by its name, beside controls of either side:
    Lips_Lower_M."""
    numbered: bool = False
    """Whether the name is no more than the number of an action unit, by which it may as well be
    counted."""


def meanings(names: Sequence[str], *, numbers: bool = False) -> tuple[Meaning | None, ...]:
    """(names,) how each name of one rig is read; None where it has no known meaning.

    With `numbers`, where most names are numbers of action units, they are read as such: whether
    they count something else only the motions tell.
    """
    bare = distinctive_words(names)
    counting = _counting(bare)
    units = [_numbered_unit(each) for each in bare]
    if not numbers or sum(unit is not None for unit in units) < _CODED * len(bare):
        units = [None] * len(bare)
    found = []
    for name, each, unit in zip(names, bare, units, strict=True):
        spoken = not counting.issuperset(_plain(each))
        meaning = _meaning(each, _called_unit(words(name)) or unit, spoken=spoken)
        found.append(meaning and replace(meaning, numbered=meaning.action == unit))
    return tuple(found)


def distinctive_words(names: Sequence[str]) -> tuple[Words, ...]:
    """(names,) the words of each name of one rig, without those of their owner and its version."""
    bare = [words(_without_owner(_VERSION.sub("", name))) for name in names]
    return tuple(without_makers(without_shared(bare)))


def _without_owner(name: str) -> str:
    """What stands behind the last dot or colon of a name, where it has a meaning of its own:
    ``h_teeth.AE_AA`` and the sound of ``mesh:l_14``, not ``brow.L`` or ``brow.L_1``."""
    *owner, last = re.split(r"[.:]", name)
    own = words(last)
    means = own and (is_action(own) or _coded(own) is not None)
    if means and own[0] in SIDES:
        means = len(own) > 1 and vocabulary().isdisjoint(words(" ".join(owner)))
    return last if means else name


def without_last_side(each: Words) -> Words:
    """The words of a name without the last of those for a side; all of them where it has none."""
    return without_side(each)[1]


@dataclass(frozen=True, slots=True)
class Spelling:
    """A name without its spelling: ``browDown_L``, ``L_brow-down`` and ``face.BrowDownLeft`` are
    one."""

    words: frozenset[str]
    """Without the side and without what the names of the rig share."""
    side: Side

    @property
    def senses(self) -> frozenset[str]:
        """The words, each replaced by the one for all synonyms of two makers."""
        return frozenset(synonyms().get(word, word) for word in self.words)

    @property
    def is_number(self) -> bool:
        """Whether the name is only a number."""
        return all(word.isdigit() for word in self.words)


def spellings(names: Sequence[str]) -> tuple[Spelling, ...]:
    """(names,) the meaning of each name of one rig, in any spelling."""
    return tuple(_spelling(each) for each in without_shared([words(name) for name in names]))


def same_name(name: str, known: Sequence[str]) -> str:
    """The one of a rig's names that is `name`, spells it otherwise or means the same; empty if none
    or several do."""
    if name in known:
        return name
    spelling, (meaning,) = _spelling(words(name)), meanings([name])
    ways = ((spelling.words and spelling, spellings(known)), (meaning, meanings(known)))
    alike = (
        [each for each, one in zip(known, read, strict=True) if one == own]
        for own, read in ways
        if own
    )
    return next((each[0] for each in alike if len(each) == 1), "")


def same_act(one: Action, other: Action) -> bool:
    """Whether two actions are one, or one action unit: mouthShrugLower is what raises the chin."""
    return one == other or not units_of(one.name).isdisjoint(units_of(other.name))


def _spelling(each: Words) -> Spelling:
    side, rest = without_side(each)
    return Spelling(frozenset(rest), side)


def _plain(each: Words) -> list[str]:
    """The words of a name without its numbers and those in front that say whose it is."""
    makers = table("codes")["makers"]["words"]
    return [word for word in each if not word.isdigit() and word not in makers]


def _counting(names: Sequence[Words]) -> set[str]:
    """The letters by which the `names` that are no more than letters are counted, ``targetA``,
    ``targetB`` and on with ``targetAA``: most are followed by the next one, phonemes are not."""
    alone = (each[0] for each in map(_plain, names) if len(each) == 1)
    letters = {each for each in alone if len(each) < 3}
    followed = sum(each[:-1] + chr(ord(each[-1]) + 1) in letters for each in letters)
    return letters if followed > _FOLLOWED * len(letters) else set()


def _meaning(each: Words, unit: Action | None, *, spoken: bool) -> Meaning | None:
    """The words in their order first (in mouthLeft the side is a direction), then without the side;
    before both the action `unit` of which the name is the number.  Phonemes are `spoken`, but for
    letters that count."""
    side, toward, rest = side_and_direction(each)
    if unit is not None:
        return Meaning(unit, side)
    if spoken and (found := _coded(each)):
        return Meaning(found, "")
    for phrase in phrases():
        if phrase.fits(rest, toward):
            # In mouthLeft the only side is the direction; in lookLeft_R there is another one.
            alone = sum(word in SIDES for word in each) == 1
            spent = phrase.directed and alone and not phrase.fits(rest, "")
            return Meaning(
                actions()[phrase.action], "" if spent else side, not _MIDDLES.isdisjoint(each[1:])
            )
    return None


def _numbered_unit(each: Words) -> Action | None:
    """The action unit of ``AU12``, ``L12`` or ``12``, whatever side it names."""
    numbers = [word for word in each if word.isdigit()]
    if len(numbers) != 1 or not {*each} <= {*numbers, "au", "facs", *SIDES}:
        return None
    return action_of_unit(int(numbers[0]))


def _called_unit(each: Words) -> Action | None:
    """The action unit that a name gives: ``AU_27_MouthStretch``."""
    pairs = itertools.pairwise(each)
    numbers = {int(after) for word, after in pairs if word == "au" and after.isdigit()}
    return action_of_unit(*numbers) if len(numbers) == 1 else None


def _coded(each: Words) -> Action | None:
    """Visemes by their phonemes, moods and identity series by their words."""
    codes = table("codes")
    plain = _plain(each)
    # To the left and right, not the letters.
    if not plain or plain in (["mouth", "l"], ["mouth", "r"]):
        return None
    visemes, emotions, identities = codes["visemes"], codes["emotions"], codes["identities"]
    named = plain[0] in visemes["prefixes"] or not {*plain}.isdisjoint(visemes["words"])
    # The variant of a numbered sculpt: 12_a.
    spoken = not each[0].isdigit() and {*plain[plain[0] == "mouth" :]} <= {*visemes["phonemes"]}
    if named or spoken:
        return actions()["viseme"] if plain != ["mouth"] else None
    # Eyes have moods of one side; a mouth that is sad on one side is an action.
    mood = list(without_side(tuple(plain))[1]) if plain[0] == "eye" else plain
    if {*mood} <= {*emotions["words"]}:
        return actions()["emotion"]
    if len(mood) == 2 and mood[0] in emotions["parts"] and mood[1] in emotions["words"]:
        return actions()[emotions["parts"][mood[0]]]
    numbered = plain[0] in identities["prefixes"] and len(plain) < len(each)
    # A deformer's name in front of that of an action: blendShape1_jawOpen.
    if (numbered and not is_action(tuple(plain[1:]))) or plain[0] in identities["words"]:
        return actions()["identity"]
    return None
