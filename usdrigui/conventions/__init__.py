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
import tomllib
import unicodedata
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal

from usdrigui.conventions.sides import SIDES, Side

Category = Literal["atom", "viseme", "emotion", "identity", "interior", "detail"]
Region = Literal[
    "eye", "gaze", "brow", "forehead", "cheek", "nose", "jaw", "chin",
    "mouth", "mouthCorner", "upperLip", "lowerLip", "ear", "neck", "head", "interior", "face",
]  # fmt: skip

_WORD = re.compile(
    r"[A-Z]{2,}(?=[a-z][A-Z])|[A-Z]+(?![a-z])|[A-Z][a-z]*|[a-z]+|\d+|[左右]|[^\W\d_A-Za-z左右]+"
)
_MIDDLES = frozenset({"m", "mid", "middle", "c", "center", "centre"})
_GAZE = frozenset({"look", "gaze", "turn"})
"""Words behind which the first side is where the eyes turn: EyesLookRightL, Eye_L_Look_R."""
_SHARED = 0.8
"""Share of a rig's names that begin (or end) with a word from which the word has no meaning."""
_CORE = 2.0
"""Importance of the actions without which no face is animated."""
_SEVERAL = 3
"""Names of actions with which a word must begin to be their maker's."""
_CODED = 0.5
"""Share of a rig's names that are numbers of action units from which its numbers are such."""


@dataclass(frozen=True, slots=True)
class Action:
    """What a control does to a face, whatever its rig calls it."""

    name: str
    region: Region
    category: Category = "atom"
    axis: str = ""
    """Name of the axis of which it is an end; empty for a control without an opposite."""
    pole: int = 0
    """-1 or 1: which end."""
    importance: float = 1.0
    place: tuple[float, float] | None = None
    """Its place on a canonical face: to the side on which it acts, and up from between the
    eyes, in distances of the pupils."""
    radius: float = 0.4
    """Of the region around that place in which it may be, in the same unit."""
    vague: bool = False
    """Whether only the region is known, not which way it goes."""
    both: bool = False
    """Whether its convention has one control for both sides."""

    @property
    def is_core(self) -> bool:
        """Whether it is one of those without which no face is animated."""
        return self.category == "atom" and self.importance >= _CORE

    @property
    def is_central(self) -> bool:
        """Whether it is one action of both sides, as a pucker is, and halves of it refine it."""
        return self.both or (not self.vague and self.place is not None and self.place[0] == 0.0)

    @property
    def in_family(self) -> bool:
        """Whether it is one of a set that is used as a set, not an end or an axis of something."""
        return self.category in ("viseme", "emotion", "identity")

    @property
    def is_needed(self) -> bool:
        """Whether it is missed where it leaves the face: no face is animated without it, or its
        family is split."""
        return self.is_core or self.in_family


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


def meanings(names: Sequence[str]) -> tuple[Meaning | None, ...]:
    """(names,) how each name of one rig is read; None where it has no known meaning."""
    every = [words(name) for name in names]
    bare = distinctive_words(names)
    units = sum(_action_unit(each) is not None for each in bare)
    coded = units >= _CODED * max(1, len(bare)) and not _counted(bare)
    called = [
        _called_unit(whole) or (_action_unit(each) if coded else None)
        for whole, each in zip(every, bare, strict=True)
    ]
    return tuple(_meaning(each, unit) for each, unit in zip(bare, called, strict=True))


def distinctive_words(names: Sequence[str]) -> tuple[tuple[str, ...], ...]:
    """(names,) the words of each name of one rig, without those of their owner."""
    return tuple(_without_makers(_without_shared([words(name) for name in names])))


def without_last_side(each: tuple[str, ...]) -> tuple[str, ...]:
    """The words of a name without the last of those for a side; all of them where it has none."""
    return _side(each)[1]


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
        return frozenset(_synonyms().get(word, word) for word in self.words)

    @property
    def is_number(self) -> bool:
        """Whether the name is only a number."""
        return all(word.isdigit() for word in self.words)


def spellings(names: Sequence[str]) -> tuple[Spelling, ...]:
    """(names,) the meaning of each name of one rig, in any spelling."""
    return tuple(_spelling(each) for each in _without_shared([words(name) for name in names]))


def same_name(name: str, known: Sequence[str]) -> str:
    """The one of a rig's names that `name` spells otherwise, or that means the same; empty if none
    or several do."""
    rig = spellings(known)
    spelt = [
        each
        for each, one in zip(known, rig, strict=True)
        if one == _spelling(words(name)) and one.words
    ]
    meant, senses = meanings([name])[0], meanings(known)
    means = [
        each for each, one in zip(known, senses, strict=True) if one is not None and one == meant
    ]
    return next((each[0] for each in (spelt, means) if len(each) == 1), "")


def same_act(one: Action, other: Action) -> bool:
    """Whether two actions are one, or one action unit: mouthShrugLower is what raises the chin."""
    units = set(_units().get(one.name, ())) & set(_units().get(other.name, ()))
    return one == other or bool(units)


def _spelling(each: tuple[str, ...]) -> Spelling:
    side, rest = _side(each)
    return Spelling(frozenset(rest), side)


def words(name: str) -> tuple[str, ...]:
    """The words of a name, lower case: ``eye-left-slit``, ``Look_In_Right`` and ``AU12L`` come
    apart alike."""
    codes = _table("codes")
    found: list[str] = []
    for word in _WORD.findall(_in_english(unicodedata.normalize("NFKC", name))):
        # A side is glued to the front of a word that is known: LbrowUp.
        glued = word[0] in "LR" and word[1:] in _vocabulary() and word.lower() not in _vocabulary()
        found += [word[0], word[1:]] if glued else _unglued(word.lower())
    return tuple(codes["abbreviations"].get(word.lower(), word.lower()) for word in found)


def _in_english(name: str) -> str:
    """A name with the Japanese words in it that are known translated."""
    japanese = _table("codes")["japanese"]
    if name.isascii() or name in japanese:
        return str(japanese.get(name, name))
    return _WORD.sub(lambda word: f"{japanese[word[0]]} " if word[0] in japanese else word[0], name)


@cache
def _unglued(word: str) -> tuple[str, ...]:
    """The known words of which a word without capitals consists, the longest first: ``jawopen``,
    ``eyeblinkleft``, ``visemee``; the word itself where it is known or they do not make it up."""
    found = None if word in _known() else _said(word) or _pieces(word)
    return found or (word,)


def _said(word: str) -> tuple[str, ...] | None:
    """`word` as a word for visemes and the phoneme behind it, which may be one letter."""
    visemes = _table("codes")["visemes"]
    heads = (head for head in visemes["words"] if len(head) > 2 and word.startswith(head))
    return next(
        ((head, word[len(head) :]) for head in heads if word[len(head) :] in visemes["phonemes"]),
        None,
    )


def _pieces(word: str) -> tuple[str, ...] | None:
    """`word` as known words of two letters or more; None where it is no such row."""
    if not word:
        return ()
    for end in range(len(word), 1, -1):
        if word[:end] in _known() and (rest := _pieces(word[end:])) is not None:
            return (word[:end], *rest)
    return None


def joysticks() -> Mapping[str, tuple[str, str]]:
    """Names of joysticks to their axes: the one that runs across, the one that runs up."""
    return {name: (pair[0], pair[1]) for name, pair in _table("actions")["_joysticks"].items()}


def _meaning(each: tuple[str, ...], unit: Action | None) -> Meaning | None:
    """The words in their order first (in mouthLeft the side is a direction), then without the side;
    before both the action `unit` of which the name is the number."""
    side, toward, rest = _side_and_direction(each)
    if unit is not None:
        return Meaning(unit, side)
    if found := _coded(each):
        return Meaning(found, "")
    for phrase in _phrases():
        if phrase.fits(rest, toward):
            # In mouthLeft the only side is the direction; in lookLeft_R there is another one.
            alone = sum(word in SIDES for word in each) == 1
            spent = phrase.directed and alone and not phrase.fits(rest, "")
            return Meaning(
                _actions()[phrase.action], "" if spent else side, not _MIDDLES.isdisjoint(each[1:])
            )
    return None


@dataclass(frozen=True, slots=True)
class _Phrase:
    """Words that together mean an action: one of every set must be among those of the name."""

    action: str
    every: tuple[frozenset[str], ...]
    without: frozenset[str]
    directed: bool
    """Whether a word for a side is a direction here: mouthLeft goes to the left."""
    alone: frozenset[str] | None
    """The only other words that may be beside them; None for any."""

    def fits(self, rest: tuple[str, ...], toward: Side) -> bool:
        own = {*rest, toward} if self.directed else set(rest)
        if self.without & own:
            return False
        if not all(alternatives & own for alternatives in self.every):
            return False
        others = {word for word in own if not word.isdigit()}.difference(*self.every)
        return self.alone is None or others <= self.alone


def _side(each: tuple[str, ...]) -> tuple[Side, tuple[str, ...]]:
    """The side that the words name, the last such word counting, and the words without it."""
    for i in reversed(range(len(each))):
        if each[i] in SIDES and len(each) > 1:
            return SIDES[each[i]], each[:i] + each[i + 1 :]
    return "", each


def _side_and_direction(each: tuple[str, ...]) -> tuple[Side, Side, tuple[str, ...]]:
    """The side on which a control acts by its name, the one to which it may go, and the words
    without the two: one word holds both unless there is another one behind which the eyes look."""
    looks = [i for i, word in enumerate(each) if word in _GAZE]
    behind = [i for i, word in enumerate(each) if word in SIDES and looks and i > looks[0]]
    side, rest = _side(each)
    if not behind or sum(word in SIDES for word in each) < 2:
        return side, side, rest
    side, rest = _side(each[: behind[0]] + each[behind[0] + 1 :])
    return side, SIDES[each[behind[0]]], rest


def _without_shared(names: list[tuple[str, ...]]) -> list[tuple[str, ...]]:
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


def _without_makers(names: list[tuple[str, ...]]) -> list[tuple[str, ...]]:
    """The names without the word of their owner: a word of no convention with which several
    names begin that mean actions without it.  VRoid's Fcl_MTH_A is beside ARKit's names in some
    rigs."""
    while True:
        heads = Counter(each[0] for each in names if len(each) > 1 and _acts(each[1:]))
        found = {
            word for word, count in heads.items() if count >= _SEVERAL and word not in _known()
        }
        if not found:
            return names
        names = [each[1:] if len(each) > 1 and each[0] in found else each for each in names]


@cache
def _acts(each: tuple[str, ...]) -> bool:
    _, toward, rest = _side_and_direction(each)
    return any(phrase.fits(rest, toward) for phrase in _phrases())


def _action_unit(each: tuple[str, ...]) -> Action | None:
    """The action unit of ``AU12``, ``L12`` or ``12``, whatever side it names."""
    numbers = [word for word in each if word.isdigit()]
    others = {word for word in each if not word.isdigit()} - {"au", "facs", *SIDES}
    if len(numbers) != 1 or others:
        return None
    return next(
        (a for a in _actions().values() if int(numbers[0]) in _units().get(a.name, ())), None
    )


def _called_unit(each: tuple[str, ...]) -> Action | None:
    """The action unit that a name gives: ``AU_27_MouthStretch``."""
    numbers = {
        int(after) for word, after in itertools.pairwise(each) if word == "au" and after.isdigit()
    }
    return next(
        (
            a
            for a in _actions().values()
            if len(numbers) == 1 and numbers <= {*_units().get(a.name, ())}
        ),
        None,
    )


def _counted(names: Sequence[tuple[str, ...]]) -> bool:
    """Whether the numbers of the names count something, one after the other: action units have
    gaps."""
    numbers = [int(word) for each in names for word in each if word.isdigit()]
    return len(numbers) > 1 and len(set(numbers)) == len(numbers) == max(numbers) - min(numbers) + 1


def _coded(each: tuple[str, ...]) -> Action | None:
    """Visemes by their phonemes, moods and identity series by their words."""
    codes = _table("codes")
    plain = [word for word in each if not word.isdigit() and word not in codes["makers"]["words"]]
    if not plain or plain in (
        ["mouth", "l"],
        ["mouth", "r"],
    ):  # To the left and right, not the letters.
        return None
    phonemes, parts = codes["visemes"]["phonemes"], codes["emotions"]["parts"]
    named = plain[0] in codes["visemes"]["prefixes"] or not {*plain}.isdisjoint(
        codes["visemes"]["words"]
    )
    if named or all(word in phonemes for word in plain[plain[0] == "mouth" :]):
        return _actions()["viseme"] if plain != ["mouth"] else None
    # Eyes have moods of one side; a mouth that is sad on one side is an action.
    mood = list(_side(tuple(plain))[1]) if plain[0] == "eye" else plain
    if mood[-1] in codes["emotions"]["words"] and (
        len(mood) == 1 or (len(mood) == 2 and mood[0] in parts)
    ):
        return _actions()[parts[mood[0]] if len(mood) == 2 else "emotion"]
    numbered = plain[0] in codes["identities"]["prefixes"] and len(plain) < len(each)
    # A deformer's name in front of that of an action: blendShape1_jawOpen.
    numbered = numbered and not _acts(tuple(plain[1:]))
    if numbered or plain[0] in codes["identities"]["words"]:
        return _actions()["identity"]
    return None


@cache
def _table(name: str) -> dict[str, Any]:
    return tomllib.loads((files(__package__) / f"{name}.toml").read_text(encoding="utf-8"))


@cache
def _actions() -> Mapping[str, Action]:
    rows = {name: row for name, row in _table("actions").items() if not name.startswith("_")}
    return {name: _action(name, row) for name, row in rows.items()}


def _action(name: str, row: Mapping[str, Any]) -> Action:
    fields = {key: value for key, value in row.items() if key not in ("au", "place")}
    return Action(name, place=tuple(row["place"]) if "place" in row else None, **fields)


@cache
def _units() -> Mapping[str, tuple[int, ...]]:
    return {
        name: tuple(row.get("au", ()))
        for name, row in _table("actions").items()
        if not name.startswith("_")
    }


@cache
def _synonyms() -> Mapping[str, str]:
    rows = _table("codes")["synonyms"]
    return {word: stands_for for stands_for, same in rows.items() for word in _alternatives(same)}


@cache
def _phrases() -> tuple[_Phrase, ...]:
    return tuple(_phrase(row) for row in _table("phrases")["phrase"])


@cache
def _vocabulary() -> frozenset[str]:
    return frozenset(word for phrase in _phrases() for every in phrase.every for word in every)


@cache
def _known() -> frozenset[str]:
    """Words that mean something at the front of a name."""
    codes = _table("codes")
    lists = (
        ("visemes", "words"),
        ("visemes", "prefixes"),
        ("visemes", "phonemes"),
        ("emotions", "words"),
    )
    words = {
        word for table, key in (*lists, ("identities", "prefixes")) for word in codes[table][key]
    }
    return _vocabulary() | words | {"au", *codes["emotions"]["parts"], *SIDES}


def _phrase(row: Mapping[str, Any]) -> _Phrase:
    sets = tuple(frozenset(_alternatives(each)) for each in row["words"])
    alone = frozenset(_alternatives(row["alone"])) if "alone" in row else None
    without = frozenset(row.get("without", ()))
    return _Phrase(row["action"], sets, without, bool(row.get("directed", False)), alone)


def _alternatives(text: str) -> Iterable[str]:
    return text.split()
