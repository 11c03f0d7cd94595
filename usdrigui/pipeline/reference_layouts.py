"""Layouts that exist and that a run uses as references: fixed ones, the previous one, another
character's, the base.

Reads their layers and finds out of which characters they are.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from usdrigui.character import Performance, Record, Rig
from usdrigui.errors import (
    Faults,
    Issue,
    RigUIError,
    check_known,
    issue,
    meant,
    of_character,
    refuse,
)
from usdrigui.isolation.foreign_file import SourceFile
from usdrigui.layout.reuse.existing_layout import layout_of, moved_path
from usdrigui.layout.reuse.identity import Matching
from usdrigui.layout.reuse.pinned import Pins, with_rest_places
from usdrigui.model import Correction, Layout, Match, Trajectories
from usdrigui.pipeline.animation import performances
from usdrigui.reader.reader_process import (
    read_composed_isolated,
    read_layer_isolated,
    read_layouts_isolated,
)
from usdrigui.reader.reader_records import LayoutsResult, ReadResult
from usdrigui.settings import ReadSettings, Settings


@dataclass(frozen=True, slots=True)
class ReferenceLayers:
    """Paths of the layers to use."""

    fixed: Path | None = None
    """Its anchors and groups are kept to the point."""
    previous: Path | None = None
    """Its anchors and groups are kept unless leaving them saves more than
    ``objective.keep_penalty``."""
    like: Path | None = None
    """The layout of another character, over that character, to be imitated; not together with
    `previous`."""
    animations: tuple[Path, ...] = ()
    """Controls that these use often matter more."""
    base: Path | None = None
    """The asset's own layout, which stays: only controls that it lacks are laid out; not together
    with the others."""
    corrections: tuple[Path, ...] = ()
    """Layers of corrections that hold, besides those of the asset and of the layouts to succeed."""


class ReferenceLayouts(Record):
    """What those layers hold, by SkelRoot."""

    fixed: Mapping[str, Layout] = field(default_factory=dict)
    previous: Mapping[str, Layout] = field(default_factory=dict)
    like: tuple[tuple[Rig, Layout], ...] = ()
    """Other characters with their layouts."""
    clips: tuple[Performance, ...] = ()
    """Animations that weigh the controls."""
    base: LayoutsResult | None = None
    """Existing layouts, with the paths of their own layer."""
    sources: tuple[SourceFile, ...] = ()
    """Every file that composed those layers and characters."""
    ignored: tuple[Issue, ...] = ()
    """Opinions in those layers that say nothing."""
    corrections: tuple[Correction, ...] = ()
    """Those of a person, one for each control."""

    def existing(self, rig: Rig) -> Layout | None:
        """The existing layout of this character, with its paths; none where there is none."""
        return layout_of(self.base.layouts, rig) if self.base is not None else None


def read_references(
    layers: ReferenceLayers, opening: ReadSettings, source: ReadResult
) -> ReferenceLayouts:
    """Read the layers, each in a process of its own, for an asset that was read.

    Raises LAYOUT_MISSING, SOURCE_MISSING for a `like` that does not name its character, and
    everything that reading a layer or an asset can raise.
    """
    if layers.previous and layers.like:
        raise refuse(
            "CONFIG_VALUE",
            "--like",
            "a layout is either this character's previous one or another's",
        )
    if layers.base and (layers.fixed or layers.previous or layers.like):
        raise refuse(
            "CONFIG_VALUE",
            "--base",
            "keeps the whole layout, and cannot be combined with another layout",
        )
    base = read_layouts_isolated(layers.base, opening) if layers.base else None
    kept = [_kept(each, opening) for each in (layers.fixed, layers.previous)]
    like, theirs = _characters(layers.like, opening) if layers.like else ((), ())
    read = [each for each in (base, *kept) if each is not None]
    given = (read_layer_isolated(each, opening).corrections for each in layers.corrections)
    stacked = (*(each.corrections for each in read), source.corrections)
    said = [each for own in (*stacked, *given) for each in own]
    corrections, lost = _of_characters(said, source.rigs)
    told = (*lost, *(each for result in read for each in result.ignored))
    fixed, previous = map(_by_root, kept)
    return ReferenceLayouts(
        fixed,
        previous,
        like,
        performances(layers.animations, opening),
        base,
        sources=(*theirs, *(file for each in read for file in each.sources)),
        ignored=tuple(dict.fromkeys(told)),
        corrections=corrections,
    )


def _of_characters(
    said: Sequence[Correction], rigs: Sequence[Rig]
) -> tuple[tuple[Correction, ...], list[Issue]]:
    """Corrections of the characters of an asset, of several of one control the last; those of a
    single character are of the single one of the asset, whatever its path.  And PIN_LOST for those
    of characters that it does not have."""
    roots, here = {each.root for each in said}, [rig.path for rig in rigs]
    if len(roots) == len(here) == 1:
        said = [
            replace(each, root=here[0], mesh=moved_path(each.mesh, each.root, here[0]))
            for each in said
        ]
    lost = [
        issue(
            "PIN_LOST", each.control, f"there is no character {each.root}{meant(each.root, here)}"
        )
        for each in said
        if each.root not in here
    ]
    found = {(each.root, each.control): each for each in said if each.root in here}
    return tuple(found.values()), lost


def _kept(layer: Path | None, opening: ReadSettings) -> LayoutsResult | None:
    """A layout to keep; anchors that a stronger layer gives as a point alone have the place of that
    point in the stage that the layer composes."""
    if layer is None:
        return None
    found = read_layouts_isolated(layer, opening)
    pinned = (e.pinned_position for each in found.layouts for e in each.elements)
    if np.isfinite([*pinned]).all():
        return found
    settings = _unconfigured(opening, opening.variants)
    try:
        _, composed = read_composed_isolated(layer, settings)
    except RigUIError:
        return found  # the character is gone; what is lost is told where it is missed
    rigs = {rig.path: rig for rig in composed.rigs}
    layouts = tuple(
        with_rest_places(each, rigs[each.root]) if each.root in rigs else each
        for each in found.layouts
    )
    return replace(found, layouts=layouts)


def as_sibling(references: ReferenceLayouts, rig: Rig, first: Layout) -> ReferenceLayouts:
    """The references with the layout of another variant of the same character as its earlier one:
    what both have stands at the same places.  As they are where a layout is given for it already,
    or the two have no control in common.
    """
    root = rig.path
    given = bool(references.like) or root in references.fixed or root in references.previous
    if given or first.controls.isdisjoint(rig.control_names):
        return references
    return replace(references, previous={**references.previous, root: first})


def followed(
    references: ReferenceLayouts, rigs: tuple[Rig, ...]
) -> tuple[ReferenceLayouts, tuple[Rig, ...]]:
    """The references with the earlier layout of the one character where that has another path
    now.

    Only where there is one character on either side, with a mesh of the same name below its
    SkelRoot and a control in common; its rig then has PREVIOUS_RENAMED.
    """
    if len(rigs) != 1 or len(references.previous) != 1 or rigs[0].path in references.previous:
        return references, rigs
    (rig,), (before,) = rigs, references.previous.values()
    layout = layout_of((before,), rig)
    if layout is None:
        return references, rigs
    was = f"was {before.root} in the previous layout"
    renamed = issue("PREVIOUS_RENAMED", rig.path, was)
    told = (*rig.issues, *of_character(rig.path_in_variants, (renamed,)))
    return replace(references, previous={rig.path: layout}), (replace(rig, issues=told),)


def rigs_over(references: ReferenceLayouts, rigs: tuple[Rig, ...]) -> tuple[Rig, ...]:
    """The characters to lay out: all, or those with an existing layout.

    Raises BASE_MISMATCH or PREVIOUS_MISMATCH where no layout of `base` or `previous` is of any of
    them.
    """
    if references.previous and not any(r.path in references.previous for r in rigs):
        theirs = ", ".join(references.previous)
        what = f"has another path than the characters of the layer, {theirs}"
        raise refuse("PREVIOUS_MISMATCH", rigs[0].path, what)
    if references.base is None:
        return rigs
    found = tuple(rig for rig in rigs if references.existing(rig) is not None)
    if not found:
        theirs = ", ".join(layout.root for layout in references.base.layouts)
        raise refuse(
            "BASE_MISMATCH",
            rigs[0].path,
            f"shares mesh and controls with none of the layouts, or with several: {theirs}",
        )
    return found


class OwnReferences(Record):
    """What the references hold for one character, by its own names for its controls."""

    fixed: Layout | None = None
    previous: Layout | None = None
    like: tuple[Rig, Trajectories, Layout] | None = None
    """Another character and its layout, by the names that it has there."""
    existing: Layout | None = None
    clips: tuple[Performance, ...] = ()
    pins: Pins = Pins()
    """What a person has decided in the layouts that the new one succeeds."""
    matchings: Mapping[str, Matching] = field(default_factory=dict)
    """By ``fixed``, ``previous`` and ``like``: whose control there is which one here."""
    earlier: Layout | None = None
    """The previous layout by the names that it has itself, in the units of today."""

    @property
    def matches(self) -> tuple[Match, ...]:
        """What the new layout has on record of the names of the one that it succeeds."""
        found = self.matchings.get("previous") or self.matchings.get("fixed") or Matching()
        return tuple(each for each in found.matches if each.before != each.after)

    @property
    def followed(self) -> bool:
        """Whether the layout follows another one of the same controls."""
        return any(each is not None for each in (self.fixed, self.previous, self.like))


def check_like(like: tuple[tuple[Rig, Layout], ...], rig: Rig, names: Mapping[str, str]) -> None:
    """Raise CONFIG_UNKNOWN_CONTROL for all names of `names` (``[like.names]``) that nobody bears,
    CONFIG_VALUE when none of several characters to imitate has the path of this one."""
    if not like:
        return
    other, _ = imitated(like, rig.path)
    faults = Faults()
    for theirs, ours in names.items():
        for whose, name in ((other, theirs), (rig, ours)):
            with faults.collected():
                if name:
                    known, lacking = whose.control_names, f"{whose.path} has no control"
                    check_known(name, known, f'like.names."{theirs}"', lacking)
    faults.raise_all()


def imitated(like: Sequence[tuple[Rig, Layout]], root: str) -> tuple[Rig, Layout]:
    """The character to imitate: of several the one with the path of this one."""
    by_root = {other.path: (other, layout) for other, layout in like}
    if root not in by_root and len(by_root) > 1:
        raise refuse(
            "CONFIG_VALUE", "--like", f"has layouts of {', '.join(by_root)}; none is of {root}"
        )
    return by_root.get(root) or like[0]


def _characters(
    layer: Path, opening: ReadSettings
) -> tuple[tuple[tuple[Rig, Layout], ...], tuple[SourceFile, ...]]:
    """The characters of a layer to imitate, read without the configuration of ours, and
    their files."""
    found, read = read_composed_isolated(layer, _unconfigured(opening, {}))
    layouts = _by_root(found)
    characters = tuple((rig, layouts[rig.path]) for rig in read.rigs if rig.path in layouts)
    return characters, read.sources


def _unconfigured(opening: ReadSettings, variants: Mapping[str, str]) -> Settings:
    """The limits of reading and some variants; nothing else that is said of our character."""
    return Settings(
        read=ReadSettings(
            variants=variants,
            time_limit=opening.time_limit,
            memory_limit=opening.memory_limit,
            size_limit=opening.size_limit,
        )
    )


def _by_root(found: LayoutsResult | None) -> Mapping[str, Layout]:
    return {layout.root: layout for layout in found.layouts} if found else {}
