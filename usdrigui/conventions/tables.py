"""The tables of the conventions: what a face can do (``actions.toml``), the codes that names are
(``codes.toml``) and the phrases of which they consist (``phrases.toml``)."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Any, Literal

import msgspec

from usdrigui.conventions.sides import SIDES, Side

Category = Literal["atom", "viseme", "emotion", "identity", "interior", "detail"]
Region = Literal[
    "eye", "gaze", "brow", "forehead", "cheek", "nose", "jaw", "chin",
    "mouth", "mouthCorner", "upperLip", "lowerLip", "ear", "neck", "head", "interior", "face",
]  # fmt: skip
Words = tuple[str, ...]
"""Those of a name, as `usdrigui.conventions.words` gives them."""

_CORE = 2.0
"""Importance of the actions without which no face is animated."""


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
    def is_central(self) -> bool:
        """Whether it is one action of both sides, as a pucker is, and halves of it refine it."""
        return self.both or (not self.vague and self.place is not None and self.place[0] == 0.0)

    @property
    def in_family(self) -> bool:
        """Whether it is one of a set that is used as a set, not an end or an axis of something."""
        return self.category in ("viseme", "emotion", "identity")

    @property
    def is_essential(self) -> bool:
        """Whether it is on the face even where its peak is hidden: no face is animated without it,
        or its family is split."""
        is_core = self.category == "atom" and self.importance >= _CORE
        return is_core or self.category in ("viseme", "emotion")


@dataclass(frozen=True, slots=True)
class Phrase:
    """Words that together mean an action: one of every set must be among those of the name."""

    action: str
    every: tuple[frozenset[str], ...]
    without: frozenset[str]
    directed: bool
    """Whether a word for a side is a direction here: mouthLeft goes to the left."""
    alone: frozenset[str] | None
    """The only other words that may be beside them; None for any."""

    def fits(self, rest: Words, toward: Side) -> bool:
        """Whether the words of a name, and the side to which it may go, are such."""
        own = {*rest, toward} if self.directed else set(rest)
        if self.without & own:
            return False
        if not all(alternatives & own for alternatives in self.every):
            return False
        others = {word for word in own if not word.isdigit()}.difference(*self.every)
        return self.alone is None or others <= self.alone


@cache
def table(name: str) -> dict[str, Any]:
    """What ``NAME.toml`` holds."""
    return tomllib.loads((files(__package__) / f"{name}.toml").read_text(encoding="utf-8"))


@cache
def _action_rows() -> Mapping[str, Mapping[str, Any]]:
    return {name: row for name, row in table("actions").items() if not name.startswith("_")}


@cache
def actions() -> Mapping[str, Action]:
    """Every action by its name."""
    rows = _action_rows().items()
    return {name: msgspec.convert({"name": name, **row}, Action) for name, row in rows}


def units_of(action: str) -> frozenset[int]:
    """The numbers of an action in the Facial Action Coding System."""
    return frozenset(_action_rows()[action].get("au", ()))


def action_of_unit(number: int) -> Action | None:
    """The first action that has a number there."""
    return next((each for each in actions().values() if number in units_of(each.name)), None)


def joysticks() -> Mapping[str, tuple[str, str]]:
    """Names of joysticks to their axes: the one that runs across, the one that runs up."""
    return {name: (pair[0], pair[1]) for name, pair in table("actions")["_joysticks"].items()}


@cache
def synonyms() -> Mapping[str, str]:
    """Words of which two makers use another for the same, each to the one for all of them."""
    rows = table("codes")["synonyms"]
    return {word: stands_for for stands_for, same in rows.items() for word in same.split()}


@cache
def phrases() -> tuple[Phrase, ...]:
    """Every phrase; the first that fits counts."""
    return tuple(
        Phrase(
            row["action"],
            tuple(frozenset(words.split()) for words in row["words"]),
            frozenset(row.get("without", ())),
            bool(row.get("directed", False)),
            frozenset(row["alone"].split()) if "alone" in row else None,
        )
        for row in table("phrases")["phrase"]
    )


@cache
def vocabulary() -> frozenset[str]:
    """The words of all phrases."""
    return frozenset(word for phrase in phrases() for every in phrase.every for word in every)


@cache
def known_words() -> frozenset[str]:
    """Words that mean something at the front of a name."""
    codes = table("codes")
    visemes, emotions = codes["visemes"], codes["emotions"]
    coded = {*visemes["words"], *visemes["prefixes"], *visemes["phonemes"], *emotions["words"]}
    named = {"au", *emotions["parts"], *codes["identities"]["prefixes"]}
    return vocabulary() | coded | named | SIDES.keys()
