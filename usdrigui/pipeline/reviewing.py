"""Layers that exist: load_layer() reads one back, check() tests whether it still fits, diff() lists
what changed."""

from __future__ import annotations

import functools
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from usdrigui.character import Rig
from usdrigui.errors import NO_LAYOUT, Issue, RigUIError, issue, of_character, refuse
from usdrigui.layout.reuse.other_world import in_world, other_up, up_of
from usdrigui.layout.review import difference as difference_stage, review as review_stage
from usdrigui.layout.review.layout_faults import not_animated, reshaped
from usdrigui.model import Element, Layout
from usdrigui.pipeline import variants
from usdrigui.pipeline.configuration import refuse_unsound
from usdrigui.pipeline.progress import Clock, ProgressCallback
from usdrigui.pipeline.records import Character, CharacterPart
from usdrigui.pipeline.requested import by_names_of_today
from usdrigui.pipeline.stages import character_of, part_problem
from usdrigui.pipeline.targets import default_output
from usdrigui.reader.reader_process import (
    read_composed_isolated,
    read_isolated,
    read_layouts_isolated,
    read_rigs_isolated,
    read_variants_isolated,
)
from usdrigui.reader.reader_records import FaultsResult, ReadResult
from usdrigui.settings import ReadSettings, Settings

if TYPE_CHECKING:
    from pxr import Sdf, Usd


@dataclass(frozen=True, slots=True)
class Loaded:
    """The layouts of a stage with their characters."""

    characters: tuple[tuple[Rig, Layout], ...]
    source: str
    """The asset that the layer sublayers; empty if it has none."""
    files: tuple[Path, ...]
    """Every file that was read."""
    without_layout: tuple[Issue, ...] = ()
    """LAYOUT_NONE or LAYOUT_OFF for each character beside them that has none, and OPINION_IGNORED
    for opinions that say nothing."""
    contradictions: tuple[Issue, ...] = ()
    """LAYOUT_INVALID of layouts that can be read all the same."""


@dataclass(frozen=True, slots=True)
class LayerReview:
    """What `check` finds out about one layer."""

    layer: str
    characters: tuple[tuple[str, review_stage.Review], ...]
    """By SkelRoot."""
    seconds: tuple[tuple[str, float], ...]
    faults: tuple[Issue, ...] = ()
    """Layouts whose character is gone and characters without a layout; of a source asset, which has
    none, all that is wrong with its shapes."""
    of_asset: bool = False
    """Whether it is a source asset that was checked, as the stage has no layout."""

    def __repr__(self) -> str:
        counts = Counter(each.severity for each in self.issues)
        findings = (
            ", ".join(f"{number} {severity}" for severity, number in counts.items())
            or "no findings"
        )
        return f"<LayerReview {self.layer}: {len(self.characters)} characters, {findings}>"

    @property
    def issues(self) -> tuple[Issue, ...]:
        """All findings."""
        return (*self.faults, *(found for _, review in self.characters for found in review.issues))


@dataclass(frozen=True, slots=True)
class LayerDifference:
    """What `diff` finds between two layers."""

    before: str
    after: str
    characters: tuple[difference_stage.Difference, ...]
    """Of the characters that both lay out."""
    only_in_one: tuple[str, ...]
    """SkelRoots that only one of the layers lays out."""
    issues: tuple[Issue, ...] = ()
    """Opinions in either layer that say nothing."""

    @property
    def empty(self) -> bool:
        """Whether both place every control alike."""
        return not self.only_in_one and not any(character.changes for character in self.characters)


def load_layer(layer: Path, settings: Settings) -> Loaded:
    """The layouts of a stage and their characters as it composes them, for viewers and checks.

    `layer` is a layout layer over its character, an asset with its layout inside, a shot of
    several, flattened or packed.  Raises RigUIError LAYOUT_MISSING, SOURCE_MISSING, LAYOUT_STALE
    where the stage lacks one of the characters, and everything that reading an asset can raise.
    """
    try:
        loaded, stale, source = _loaded(layer, settings)
    except RigUIError as error:
        beside = default_output(layer)
        if error.issue.code == "LAYOUT_MISSING" and beside.is_file():
            raise refuse(
                "LAYOUT_MISSING",
                layer,
                f"{error.issue.message}; {beside} beside it is a layout",
            ) from error
        raise
    refuse_unsound(source)
    _refuse_lost(stale)
    return _standing(loaded)


def _standing(loaded: Loaded) -> Loaded:
    """The characters with the up directions of their layouts: a shot that says nothing of its up
    axis, or has a character that lies down, is looked at as the layout is."""
    pairs = ((_upright(rig, layout), layout) for rig, layout in loaded.characters)
    return replace(loaded, characters=tuple(pairs))


def _refuse_lost(lost: Sequence[Issue]) -> None:
    """Raise why the first of some layouts has no character any more."""
    if lost:
        raise refuse(lost[0].code, lost[0].path, lost[0].message)


def _loaded(layer: Path, settings: Settings) -> tuple[Loaded, tuple[Issue, ...], ReadResult]:
    """What the stage has, why layouts have no character there any more, and what was read."""
    found, read = read_composed_isolated(layer, settings)
    wanted = settings.read.skel_root
    layouts = {each.root: each for each in found.layouts if not wanted or each.root == wanted}
    lacking = sorted(layouts.keys() - {rig.path for rig in read.rigs})
    lost = {each.character: each for each in read.lost}
    stale = tuple(
        lost.get(root) or issue("LAYOUT_STALE", root, f"{layer} no longer has this character", root)
        for root in lacking
    )
    loaded = _with_characters(layouts, read, found.source)
    return replace(loaded, without_layout=(*loaded.without_layout, *found.ignored)), stale, read


def _with_characters(layouts: Mapping[str, Layout], read: ReadResult, source: str) -> Loaded:
    """The layouts by SkelRoot with their characters, of what was read."""
    rigs = [rig for rig in read.rigs if rig.path in layouts]
    return Loaded(
        tuple((rig, _with_base(rig, layouts[rig.path])) for rig in rigs),
        source,
        tuple(Path(each.path) for each in read.sources),
        read.without_layout,
        read.contradictions,
    )


def _with_base(rig: Rig, layout: Layout) -> Layout:
    """The layout with a base pose in the order of the rig's controls, where its own is of just
    these, listed in any order; where it lists none, with that of the defaults."""
    own, listed = layout.base_values, layout.listed
    if not len(own):
        values = {each.name: each.default for each in rig.controls}
    elif len(listed) != len(rig.controls) or not set(listed).issubset(rig.control_names):
        return layout
    else:
        values = dict(zip(listed, own.tolist(), strict=True))
    base = np.array([values[each.name] for each in rig.controls])
    return replace(layout, base_values=base)


def check(
    layer: Path, settings: Settings, *, progress: ProgressCallback | None = None
) -> LayerReview:
    """Whether the layouts of a stage fit their characters as the stage composes them, and how good
    they are.

    Works on layers from any tool or hand; writes nothing.  Raises RigUIError where the stage cannot
    be read.
    """
    clock = Clock(progress)
    try:
        return _checked(layer, settings, clock)
    except RigUIError as error:
        faults = _source_faults(layer, settings, error)
        return LayerReview(str(layer), (), clock.seconds, faults, of_asset=True)


def _checked(layer: Path, settings: Settings, clock: Clock) -> LayerReview:
    reviews, plain = variants.in_each_variant(
        settings,
        functools.partial(read_variants_isolated, layer, settings.read),
        lambda chosen: _checked_as_selected(layer, chosen, clock),
    )
    characters = {root: review for each in reviews for root, review in each.characters}
    faults = dict.fromkeys((*(fault for each in reviews for fault in each.faults), *plain))
    return LayerReview(str(layer), tuple(characters.items()), clock.seconds, tuple(faults))


def _checked_as_selected(layer: Path, settings: Settings, clock: Clock) -> LayerReview:
    with clock.stage("read"):
        loaded, stale, source = _loaded(layer, settings)
        refuse_unsound(source, settings)
    corrected = (by_names_of_today(source.corrections, rig, {}) for rig in source.rigs)
    told = tuple(each for _, issues in corrected for each in issues)
    return _review_of(str(layer), loaded, (*stale, *told), settings, clock)


def open_layouts(stage: Usd.Stage | Sdf.Layer, settings: Settings) -> Loaded:
    """The layouts on an open stage and their characters, as `load_layer` reads those of a file."""
    from usdrigui.reader.in_memory import read_open_layouts

    layouts, read = read_open_layouts(stage, settings)
    refuse_unsound(read)
    _refuse_lost(read.lost)
    return _standing(_with_characters({each.root: each for each in layouts}, read, ""))


def review(
    name: str, loaded: Loaded, settings: Settings, *, progress: ProgressCallback | None = None
) -> LayerReview:
    """As `check`, of layouts that are read already; `name` is what the review calls them."""
    return _review_of(name, loaded, (), settings, Clock(progress))


def _review_of(
    name: str, loaded: Loaded, stale: tuple[Issue, ...], settings: Settings, clock: Clock
) -> LayerReview:
    reviews = []
    for rig, layout in loaded.characters:
        whose = clock.of(rig.path, told=len(loaded.characters) > 1)
        found = _reviewed(rig, layout, settings, whose)
        known = {each.code for each in found.issues}
        wrong = [
            replace(e, character="")
            for e in loaded.contradictions
            if e.character == rig.path and e.code not in known
        ]
        wrong += [*found.issues, *not_animated(rig, layout)]
        told = of_character(rig.path_in_variants, reshaped(rig, layout, wrong))
        reviews.append((rig.path_in_variants, replace(found, issues=told)))
    return LayerReview(name, tuple(reviews), clock.seconds, (*stale, *loaded.without_layout))


def _reviewed(
    rig: Rig,
    layout: Layout,
    settings: Settings,
    clock: Clock,
) -> review_stage.Review:
    """Every part of a layout rated by the problem of that part, beside the parts before it."""
    # Other views are named by the up of the stage.
    front = settings.candidates.view in ("", "front")
    upright = _upright(rig, layout) if front else rig
    character = character_of(upright, settings, clock=clock)
    found, before = [], tuple[Element, ...]()
    for part in character.parts:
        own = _of_part(layout, character, part)
        own_clock = clock.of(part.name)
        inputs = part_problem(character, part, before, own_clock)
        before += own.elements
        with own_clock.stage("review"):
            found.append(review_stage.review(inputs.measured, inputs.candidates, own, layout))
    return review_stage.joined(found)


def _upright(rig: Rig, layout: Layout) -> Rig:
    """The character with the up direction that its layout was made for, where it lies down in the
    stage or comes from one with another up axis."""
    up = other_up(layout, rig.up)
    return rig if up is None else replace(rig, up=up)


def _of_part(layout: Layout, character: Character, part: CharacterPart) -> Layout:
    """The elements of a part, known by their first control; the first part has those of controls
    that move nothing."""
    index = character.rig.control_indices
    known = frozenset[int]().union(*(each.controls for each in character.parts))

    def own(element: Element) -> bool:
        control = index.get(element.members[0].control, -1)
        return control in part.controls or (part is character.parts[0] and control not in known)

    elements = tuple(element for element in layout.elements if own(element))
    width = layout.frame.handle_width_of(part.name)
    return replace(layout, elements=elements, frame=replace(layout.frame, handle_width=width))


def _source_faults(asset: Path, settings: Settings, refusal: RigUIError) -> tuple[Issue, ...]:
    """What is wrong with a source asset; raises the refusal of its layout again if it holds nothing
    at all."""
    missing = refusal.issue
    if missing.code not in NO_LAYOUT:
        raise refusal
    off = [] if missing.code == "LAYOUT_MISSING" else [replace(missing, severity="info")]
    found = read_isolated("faults", asset, settings.read, FaultsResult)
    if found.empty:
        raise refusal
    try:
        source = read_rigs_isolated(asset, settings)
        refuse_unsound(source, settings)
        issues = tuple(each for rig in source.rigs for each in rig.issues)
    except RigUIError as error:
        issues = error.issues
    # What was left off for a fault says it too.
    known = {(e.path, said) for e in found.issues for said in (e.code, f"{e.code}: {e.message}")}
    more = (e for e in issues if not known & {(e.path, e.code), (e.path, e.message)})
    return (*off, *found.issues, *more)


def diff(before: Path, after: Path, settings: Settings) -> LayerDifference:
    """What changed between two layout layers, character by character; reads only the layers, not
    their rigs.

    Of the variants of `read.each_variant` each by itself, as far as the second layer has a layout
    in it.  Raises RigUIError where a layer cannot be read.
    """
    each, _ = variants.in_each_variant(
        settings,
        functools.partial(read_variants_isolated, after, settings.read),
        lambda chosen: _difference(before, after, chosen.read),
    )
    characters = {one.root: one for found in each for one in found.characters}
    only = {root for found in each for root in found.only_in_one}
    issues = tuple(dict.fromkeys(told for found in each for told in found.issues))
    compared = tuple(characters.values())
    return LayerDifference(str(before), str(after), compared, tuple(sorted(only)), issues)


def _difference(before: Path, after: Path, opening: ReadSettings) -> LayerDifference:
    layers = [read_layouts_isolated(layer, opening) for layer in (before, after)]
    old, new = ({each.root: each for each in read.layouts} for read in layers)
    issues = tuple(dict.fromkeys(told for read in layers for told in read.ignored))
    found = []
    for root in (root for root in new if root in old):
        up = up_of(new[root])
        first = in_world(old[root], new[root].metres_per_unit, np.zeros(3) if up is None else up)
        change = difference_stage.difference(first, new[root])
        found.append(replace(change, root=new[root].path_in_variants))
    alone = tuple(sorted(old.keys() ^ new.keys()))
    return LayerDifference(str(before), str(after), tuple(found), alone, issues)
