"""Layers that exist: load_layer() reads one back, check() tells whether it still fits, diff() what changed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from usdrigui.errors import Issue, RigUIError, refuse
from usdrigui.layout.review import difference as difference_stage
from usdrigui.layout.review import review as review_stage
from usdrigui.model import Floats, Layout, Rig
from usdrigui.pipeline.progress import Clock, Watch
from usdrigui.pipeline.stages import build_problem
from usdrigui.settings import Settings
from usdrigui.usd.reader_process import asset_below, read_faults_isolated, read_layouts_isolated, read_rigs_isolated


@dataclass(frozen=True, slots=True)
class Loaded:
    """A layer read back with the characters that it sublayers."""

    characters: tuple[tuple[Rig, Layout], ...]
    source: str
    cameras: Mapping[str, Floats]
    files: tuple[Path, ...]
    """Every file that was read."""


@dataclass(frozen=True, slots=True)
class LayerReview:
    """What `check` finds out about one layer."""

    layer: str
    characters: tuple[tuple[str, review_stage.Review], ...]
    """By SkelRoot."""
    seconds: tuple[tuple[str, float], ...]
    faults: tuple[Issue, ...] = ()
    """Of a source asset, which has no layout: everything that is wrong with its blend shapes."""

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
    """A layout layer and the rigs that it sublayers, for viewers and checks.

    Raises RigUIError LAYOUT_MISSING, SOURCE_MISSING and everything that reading an asset can raise.
    """
    found = read_layouts_isolated(layer, settings)
    layouts, source = {each.root: each for each in found.layouts}, asset_below(found, layer)
    read = read_rigs_isolated(Path(source), settings)
    missing = set(layouts) - {each.root for each in read.rigs}
    if missing:
        raise refuse("LAYOUT_STALE", min(missing), f"{source} has no such character any more")
    characters = tuple((each, layouts[each.root]) for each in read.rigs if each.root in layouts)
    files = tuple(Path(each.path) for each in (*found.sources, *read.sources))
    return Loaded(characters, source, read.cameras, files)


def check(layer: Path, settings: Settings, *, progress: Watch | None = None) -> LayerReview:
    """Whether a layout layer still fits its rig, and how good it is; writes nothing.

    Works on layers from any tool or hand.  Raises RigUIError where the layer or its source cannot be read.
    """
    clock = Clock(progress)
    with clock.stage("read"):
        try:
            loaded = load_layer(layer, settings)
        except RigUIError as error:
            return LayerReview(str(layer), (), clock.seconds, _source_faults(layer, settings, error))
    reviews = []
    for rig, layout in loaded.characters:
        inputs = build_problem(rig, settings, clock, loaded.cameras)
        with clock.stage("review"):
            found = review_stage.review(inputs.face, inputs.candidates, inputs.requests, inputs.settings, layout)
            reviews.append((rig.root, found))
    return LayerReview(str(layer), tuple(reviews), clock.seconds)


def _source_faults(asset: Path, settings: Settings, refusal: RigUIError) -> tuple[Issue, ...]:
    """What is wrong with a source asset; raises the refusal of its layout again if it holds nothing at all."""
    if refusal.issue.code != "LAYOUT_MISSING":
        raise refusal
    found = read_faults_isolated(asset, settings)
    if found.empty:
        raise refusal
    try:
        issues = tuple(each for rig in read_rigs_isolated(asset, settings).rigs for each in rig.issues)
    except RigUIError as error:
        issues = (error.issue,)
    known = {(each.code, each.path) for each in found.issues}
    return (*found.issues, *(each for each in issues if (each.code, each.path) not in known))


def diff(before: Path, after: Path, settings: Settings) -> LayerDifference:
    """What changed between two layout layers, character by character; reads only the layers, not their rigs.

    Raises RigUIError where a layer cannot be read.
    """
    old, new = (
        {each.root: each for each in read_layouts_isolated(layer, settings).layouts} for layer in (before, after)
    )
    found = tuple(difference_stage.difference(old[root], new[root]) for root in new if root in old)
    return LayerDifference(str(before), str(after), found, tuple(sorted(old.keys() ^ new.keys())))
