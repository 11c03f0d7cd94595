"""Layers that exist: load_layer() reads one back, check() tests whether it still fits, diff() lists
what changed."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from usdrigui.character import Floats, Rig
from usdrigui.errors import NO_LAYOUT, Issue, RigUIError, issue, of_character, refuse
from usdrigui.layout.review import difference as difference_stage
from usdrigui.layout.review import review as review_stage
from usdrigui.layout.review.layout_faults import not_animated
from usdrigui.model import Element, Layout
from usdrigui.pipeline import variants
from usdrigui.pipeline.configuration import refuse_unsound
from usdrigui.pipeline.progress import Clock, ProgressCallback
from usdrigui.pipeline.records import Character, CharacterPart, Task
from usdrigui.pipeline.stages import character_of, part_problem
from usdrigui.pipeline.targets import default_output
from usdrigui.reader.reader_process import (
    read_composed_isolated,
    read_faults_isolated,
    read_layouts_isolated,
    read_rigs_isolated,
    read_variants_isolated,
)
from usdrigui.reader.reader_records import Opening, ReadResult
from usdrigui.settings import Settings

if TYPE_CHECKING:
    from pxr import Sdf, Usd


_SIDEWAYS = 0.5
"""Sine of the angle between the view and the left below which they do not determine up."""
_LYING = 0.7
"""Cosine of the angle to the up axis from which a character lies."""


@dataclass(frozen=True, slots=True)
class Loaded:
    """The layouts of a stage with their characters."""

    characters: tuple[tuple[Rig, Layout], ...]
    source: str
    """The asset that the layer sublayers; empty if it has none."""
    cameras: Mapping[str, Floats]
    files: tuple[Path, ...]
    """Every file that was read."""
    without_layout: tuple[Issue, ...] = ()
    """LAYOUT_NONE or LAYOUT_OFF for each character beside them that has none."""
    contradictions: tuple[Issue, ...] = ()
    """LAYOUT_INVALID of layouts that can be read all the same."""
    listed: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    """By SkelRoot, the names of the controls that its layout knows, with and without an element."""


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
                str(layer),
                f"{error.issue.message}; {beside} beside it is a layout",
            ) from error
        raise
    refuse_unsound(source)
    _refuse_lost(stale)
    return loaded


def _refuse_lost(lost: Sequence[Issue]) -> None:
    """Raise why the first of some layouts has no character any more."""
    if lost:
        raise refuse(lost[0].code, lost[0].path, lost[0].message)


def _loaded(layer: Path, settings: Settings) -> tuple[Loaded, tuple[Issue, ...], ReadResult]:
    """What the stage has, why layouts have no character there any more, and what was read."""
    found, read = read_composed_isolated(layer, settings)
    wanted = settings.rig.read.skel_root
    layouts = {
        each.character.root: each
        for each in found.layouts
        if not wanted or each.character.root == wanted
    }
    characters = tuple(
        (
            each,
            _with_base(
                each, layouts[each.skel_root.path], read.listed.get(each.skel_root.path, ())
            ),
        )
        for each in read.rigs
        if each.skel_root.path in layouts
    )
    lacking = sorted(layouts.keys() - {rig.skel_root.path for rig, _ in characters})
    lost = {each.character: each for each in read.lost}
    stale = tuple(
        lost.get(root) or issue("LAYOUT_STALE", root, f"{layer} no longer has this character", root)
        for root in lacking
    )
    files = tuple(Path(each.path) for each in read.sources)
    loaded = Loaded(
        characters,
        found.source,
        read.cameras,
        files,
        read.without_layout,
        read.contradictions,
        read.listed,
    )
    return loaded, stale, read


def _with_base(rig: Rig, layout: Layout, listed: Sequence[str]) -> Layout:
    """The layout with a base pose in the order of the rig's controls, where its own is of just
    these, `listed` in any order; where it lists none, with that of the defaults."""
    own = layout.character.base_values
    if not len(own):
        values = {each.name: each.default for each in rig.controls}
    elif len(listed) != len(rig.controls) or not rig.control_names.issuperset(listed):
        return layout
    else:
        values = dict(zip(listed, own.tolist(), strict=True))
    base = np.array([values[each.name] for each in rig.controls])
    return replace(layout, character=replace(layout.character, base_values=base))


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
    if not settings.rig.read.each_variant:
        return _checked_as_selected(layer, settings, clock)
    reviews, plain = variants.in_each_variant(
        settings,
        read_variants_isolated(layer, Opening.of(settings.rig.read)),
        lambda chosen: _checked_as_selected(layer, chosen, clock),
    )
    characters = {root: review for each in reviews for root, review in each.characters}
    faults = dict.fromkeys((*(fault for each in reviews for fault in each.faults), *plain))
    return LayerReview(str(layer), tuple(characters.items()), clock.seconds, tuple(faults))


def _checked_as_selected(layer: Path, settings: Settings, clock: Clock) -> LayerReview:
    with clock.stage("read"):
        loaded, stale, source = _loaded(layer, settings)
        refuse_unsound(source, settings)
    return _review_of(str(layer), loaded, stale, settings, clock)


def open_layouts(stage: Usd.Stage | Sdf.Layer, settings: Settings) -> Loaded:
    """The layouts on an open stage and their characters, as `load_layer` reads those of a file."""
    from usdrigui.reader.in_memory import read_open_layouts

    layouts, read = read_open_layouts(stage, settings)
    refuse_unsound(read)
    _refuse_lost(read.lost)
    by_root = {each.character.root: each for each in layouts}
    characters = tuple(
        (rig, _with_base(rig, by_root[rig.skel_root.path], read.listed.get(rig.skel_root.path, ())))
        for rig in read.rigs
    )
    return Loaded(
        characters,
        "",
        read.cameras,
        (),
        read.without_layout,
        read.contradictions,
        read.listed,
    )


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
        listed = frozenset(loaded.listed.get(rig.skel_root.path, ()))
        found = _reviewed(rig, layout, listed, settings, clock, loaded.cameras)
        wrong = [
            replace(e, character="")
            for e in loaded.contradictions
            if e.character == rig.skel_root.path
        ]
        wrong += [*found.issues, *not_animated(rig, layout)]
        own = replace(found, issues=of_character(rig.skel_root.path_in_variants, wrong))
        reviews.append((rig.skel_root.path_in_variants, own))
    return LayerReview(name, tuple(reviews), clock.seconds, (*stale, *loaded.without_layout))


def _reviewed(
    rig: Rig,
    layout: Layout,
    listed: frozenset[str],
    settings: Settings,
    clock: Clock,
    cameras: Mapping[str, Floats],
) -> review_stage.Review:
    """Every part of a layout rated by the problem of that part."""
    # Other views are named by the up of the stage.
    front = settings.layout.candidates.view in ("", "front")
    task = Task(settings, cameras=cameras)
    character = character_of(_upright(rig, layout) if front else rig, task, clock)
    found = []
    for part in character.parts:
        inputs = part_problem(character, part, (), clock)
        with clock.stage("review"):
            own = layout if len(character.parts) == 1 else _of_part(layout, character, part)
            found.append(
                review_stage.review(
                    inputs.measured, inputs.candidates, own, review_stage.Whole(layout, listed)
                )
            )
    return review_stage.joined(found)


def _upright(rig: Rig, layout: Layout) -> Rig:
    """The character with the up direction that its layout was made for, where it lies down in the
    stage or comes from one with another up axis.

    The layout's view and the left of the character give that direction up to the tilt of the view.
    """
    left = _left(layout.elements, layout.frame.plane.normal)
    up = np.cross(layout.frame.view, left / max(float(np.linalg.norm(left)), 1e-300))
    length = float(np.linalg.norm(up))
    ahead = np.sum([each.anchor.normal for each in layout.elements], axis=0)
    if layout.frame.view @ ahead <= _LYING * np.linalg.norm(ahead):
        return rig  # a view from above or aside gives none
    if length < _SIDEWAYS or abs(float(up @ rig.skel_root.up)) > _LYING * length:
        return rig
    axis = int(np.abs(up).argmax())
    straight = np.sign(up[axis]) * np.eye(3)[axis]
    up = straight if abs(up[axis]) > _LYING * length else up / length
    return replace(rig, skel_root=replace(rig.skel_root, up=up))


def _left(elements: tuple[Element, ...], plane_normal: Floats) -> Floats:
    """(3,) to the left of the character: the plane's normal, else from the elements of the right
    to those of the left; 0 where it is unknown."""
    if plane_normal.any():
        return plane_normal
    left, right = (
        [each.anchor.position for each in elements if each.look.side == side]
        for side in ("left", "right")
    )
    return np.mean(left, axis=0) - np.mean(right, axis=0) if left and right else np.zeros(3)


def _of_part(layout: Layout, character: Character, part: CharacterPart) -> Layout:
    """The elements of a part, known by their first control; the first part has those of controls
    that move nothing."""
    index = {control.name: i for i, control in enumerate(character.rig.controls)}
    others = frozenset[int]().union(
        *(each.controls for each in character.parts if each is not part)
    )

    def own(element: Element) -> bool:
        control = index.get(element.manipulator.members[0].control, -1)
        return control in part.controls or (part is character.parts[0] and control not in others)

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
    found = read_faults_isolated(asset, Opening.of(settings.rig.read))
    if found.empty:
        raise refusal
    try:
        source = read_rigs_isolated(asset, settings)
        refuse_unsound(source, settings)
        issues = tuple(each for rig in source.rigs for each in rig.findings.issues)
    except RigUIError as error:
        issues = error.issues
    known = {(each.code, each.path) for each in found.issues}
    return (*off, *found.issues, *(each for each in issues if (each.code, each.path) not in known))


def diff(before: Path, after: Path, settings: Settings) -> LayerDifference:
    """What changed between two layout layers, character by character; reads only the layers, not
    their rigs.

    Of the variants of `read.each_variant` each by itself, as far as the second layer has a layout
    in it.  Raises RigUIError where a layer cannot be read.
    """
    opening = Opening.of(settings.rig.read)
    if not settings.rig.read.each_variant:
        return _difference(before, after, opening)
    each, _ = variants.in_each_variant(
        settings,
        read_variants_isolated(after, opening),
        lambda chosen: _difference(before, after, Opening.of(chosen.rig.read)),
    )
    characters = {one.root: one for found in each for one in found.characters}
    only = {root for found in each for root in found.only_in_one}
    return LayerDifference(str(before), str(after), tuple(characters.values()), tuple(sorted(only)))


def _difference(before: Path, after: Path, opening: Opening) -> LayerDifference:
    old, new = (
        {each.character.root: each for each in read_layouts_isolated(layer, opening).layouts}
        for layer in (before, after)
    )
    shared = [(old[root], new[root]) for root in new if root in old]
    found = tuple(
        replace(
            difference_stage.difference(first, second),
            root=second.character.path_in_variants,
        )
        for first, second in shared
    )
    return LayerDifference(str(before), str(after), found, tuple(sorted(old.keys() ^ new.keys())))
