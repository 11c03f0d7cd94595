"""Layouts that already exist and that a run is told to heed: fixed ones, and the one before.

Reads their layers and says what they mean for one character: settings that fix anchors, and a precedent
that the stages weigh against everything else.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from usdrigui.errors import refuse
from usdrigui.layout.partial import fixed_by
from usdrigui.layout.precedent import NONE, Precedent, joined, kept_groups, of_previous
from usdrigui.model import Layout, Rig
from usdrigui.settings import Settings
from usdrigui.usd.child import LayoutsResult, read_layouts_isolated


@dataclass(frozen=True, slots=True)
class ExampleLayers:
    """Paths of the layers to heed."""

    fixed: Path | None = None
    """Its anchors and groups are kept to the point."""
    previous: Path | None = None
    """Its anchors and groups are kept unless leaving them gains more than ``objective.keep_price``."""


@dataclass(frozen=True, eq=False)
class Examples:
    """What those layers hold, by SkelRoot."""

    fixed: Mapping[str, Layout] = field(default_factory=dict)
    previous: Mapping[str, Layout] = field(default_factory=dict)
    edited: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """Elements of `previous` that a stronger layer has corrected: they are fixed."""


def read_examples(layers: ExampleLayers, settings: Settings) -> Examples:
    """Read the layers, each in a process of its own.

    Raises LAYOUT_MISSING and everything that reading a layer can raise.
    """
    fixed = read_layouts_isolated(layers.fixed, settings) if layers.fixed else None
    previous = read_layouts_isolated(layers.previous, settings) if layers.previous else None
    return Examples(_by_root(fixed), _by_root(previous), previous.edited if previous else {})


def with_fixed(examples: Examples, rig: Rig, settings: Settings) -> Settings:
    """The settings of one character with the anchors that the examples fix.

    Raises FIXED_IMPOSSIBLE, CONFIG_UNKNOWN_CONTROL, and CONFIG_VALUE when the fixed layer has no such character.
    """
    if examples.fixed:
        if rig.root not in examples.fixed:
            raise refuse("CONFIG_VALUE", "--fixed", f"has layouts of {', '.join(examples.fixed)}, not of {rig.root}")
        settings = fixed_by(examples.fixed[rig.root], rig, settings)
    corrected = frozenset(examples.edited.get(rig.root, ()))
    if corrected and settings.objective.keep_price > 0.0:
        settings = fixed_by(_known(examples.previous[rig.root], rig), rig, settings, corrected)
    return settings


def precedent_of(examples: Examples, rig: Rig, settings: Settings) -> Precedent:
    """What the examples ask of one character besides fixed anchors."""
    precedent = NONE
    if rig.root in examples.previous:
        precedent = of_previous(examples.previous[rig.root], rig, settings.objective.keep_price)
    if rig.root in examples.fixed:
        precedent = joined(Precedent(kept_groups(examples.fixed[rig.root], rig)), precedent)
    return precedent


def _known(layout: Layout, rig: Rig) -> Layout:
    """The layout without the controls that the rig has lost: a correction of those has nothing left to hold."""
    names = {control.name for control in rig.controls}
    whole = [each for each in layout.elements if all(member.control in names for member in each.members)]
    return replace(layout, elements=tuple(whole))


def _by_root(found: LayoutsResult | None) -> Mapping[str, Layout]:
    return {layout.root: layout for layout in found.layouts} if found else {}
