"""The result of `usdrigui inspect`: each control's kind, range, coverage, twin and flags, without
solving."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from usdrigui.errors import Issue
from usdrigui.report.documents import document


@dataclass(frozen=True, slots=True)
class ControlFacts:
    """One control as the layout stages see it."""

    control: str
    kind: str
    source: str
    minimum: float
    default: float
    maximum: float
    range_source: str
    points: int
    """Points that it moves."""
    coverage: float
    """Share of the visible face that it moves by a quarter of its peak at least."""
    peak: float
    """Largest arc length, in units of the typical control's."""
    twin: str
    twin_source: str
    flags: tuple[str, ...]
    """``global``, ``hidden``, ``composite``, ``on the board by request``, why it is
    left off, that it is tiny."""
    part: str = ""
    """The part of the character in which it is laid out; empty for a control that moves nothing."""


@dataclass(frozen=True, slots=True)
class PartFacts:
    """One part of a character."""

    name: str
    controls: int
    handle_width: float
    """In scene units."""


@dataclass(frozen=True, slots=True)
class UseFacts:
    """How much animations use one control."""

    control: str
    use: float
    """Mean activity over all frames, from 0 to 1."""
    active: float
    """Share of the frames in which it is off its default by a twentieth of its way or more."""
    importance: float
    """What `process --animation` takes for it."""


@dataclass(frozen=True, slots=True)
class AnimationFacts:
    """The use of one character's controls by animations."""

    clips: tuple[str, ...]
    frames: int
    controls: tuple[UseFacts, ...]
    """The most used first; without poses."""
    configuration: str
    """Their importances as lines of a configuration."""


@dataclass(frozen=True, slots=True)
class Likeness:
    """Which control of another character is which of this one."""

    matching: Any
    """`usdrigui.layout.reuse.identity.Matching`."""
    configuration: str
    """The same as lines of a configuration, for a person to complete."""


@dataclass(frozen=True, slots=True)
class CharacterFacts:
    """One SkelRoot."""

    root: str
    points: int
    meshes: int
    joints: int
    symmetric: float
    """Share of the points that have a mirror partner."""
    controls: tuple[ControlFacts, ...]
    groups: tuple[str, ...]
    """Elements that would carry several controls, and suggestions, one line each."""
    without: Mapping[str, Sequence[str]]
    """Joints that are no controls, by the reason."""
    animation: AnimationFacts | None = None
    """Where animations were given."""
    likeness: Likeness | None = None
    """Where the layout of another character was given."""
    parts: tuple[PartFacts, ...] = ()
    """In the order in which they are laid out."""


@dataclass(frozen=True, slots=True)
class Inspection:
    """The result of `usdrigui inspect` for one asset."""

    asset: str
    characters: tuple[CharacterFacts, ...]
    issues: tuple[Issue, ...]
    seconds: tuple[tuple[str, float], ...]


def to_json(found: Inspection) -> str:
    """The inspection as a JSON document."""
    return document(
        "inspection",
        asset=found.asset,
        characters=found.characters,
        issues=found.issues,
        seconds=dict(found.seconds),
    )
