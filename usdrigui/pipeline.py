"""process(): from an asset to its layout layer; the only owner of the order of the stages.

    Usd.Stage → Rig → Trajectories → Candidates → Groups → LayoutProblem → Assignment → Layout → Sdf.Layer

`process` lays out and writes, `inspect` stops before the search, `load_layer` reads a written layer back.
Nothing here prints; what a run has to say is in the record that it returns.
"""

from __future__ import annotations

import functools
import os
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from usdrigui import animation
from usdrigui.errors import Issue, RigUIError, issue, meant, refuse
from usdrigui.examples import ExampleLayers, Examples, precedent_of, read_examples, rigs_over, with_fixed
from usdrigui.inspection import CharacterFacts, ControlFacts, Inspection
from usdrigui.layout import additions as additions_stage
from usdrigui.layout import candidates as candidates_stage
from usdrigui.layout import difference as difference_stage
from usdrigui.layout import elements as elements_stage
from usdrigui.layout import gain as gain_stage
from usdrigui.layout import groups as groups_stage
from usdrigui.layout import levels as levels_stage
from usdrigui.layout import posed_symmetry as symmetry_stage
from usdrigui.layout import problem as problem_stage
from usdrigui.layout import review as review_stage
from usdrigui.layout import trajectory as trajectory_stage
from usdrigui.layout import visibility as visibility_stage
from usdrigui.layout.terms import Context
from usdrigui.model import Assignment, Candidates, Floats, Group, Layout, LayoutProblem, LeftOff, Rig
from usdrigui.report import CharacterReport, Outcome, Report, SourceRow, rows_of
from usdrigui.settings import Settings
from usdrigui.settings import document as settings_document
from usdrigui.usd.child import (
    LayoutsResult,
    ReadResult,
    read_faults_isolated,
    read_layouts_isolated,
    read_rigs_isolated,
)
from usdrigui.usd.source import SourceFile, check_unchanged

if TYPE_CHECKING:
    from usdrigui.solve.watch import Progress


_USD_SUFFIXES = (".usd", ".usda", ".usdc", ".usdz")


@dataclass(frozen=True, slots=True)
class Event:
    """Something worth showing while a run goes on."""

    stage: str
    detail: str = ""
    seconds: float | None = None
    """Given when the stage has ended."""
    can_stop: bool = False
    """True while a request to stop is answered with the best layout so far."""


Watch = Callable[[Event], None]


@dataclass(frozen=True, eq=False)
class Posed:
    """A layout problem with everything needed to turn its solution into a layout."""

    context: Context
    candidates: Candidates
    groups: tuple[Group, ...]
    problem: LayoutProblem
    choices: tuple[problem_stage.Choice, ...]
    base_values: Floats


@dataclass(frozen=True, slots=True)
class Loaded:
    """A layer read back with the characters that it stands over."""

    characters: tuple[tuple[Rig, Layout], ...]
    source: str
    cameras: Mapping[str, Floats]


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


def process(
    asset: Path,
    settings: Settings,
    *,
    output: Path | None = None,
    dry_run: bool = False,
    progress: Watch | None = None,
    stop: Callable[[], bool] | None = None,
    examples: ExampleLayers | None = None,
) -> Report:
    """Lay out every character of `asset` and write the layer.

    Parameters: `output` defaults to ``<asset>.rigui.usda`` beside the asset; `stop` is polled during the
    search, which then ends with the best layout so far; `examples` are existing layouts and animations to
    heed.  Raises
    `usdrigui.errors.RigUIError`; then nothing has been written.
    """
    clock = _Clock(progress)
    target = output if output is not None else default_output(asset)
    _check_target(asset, target)
    with clock.stage("read"):
        source = read_rigs_isolated(asset, settings)
        _check_character(asset, source)
        heeded = read_examples(examples or ExampleLayers(), settings)
    rigs = rigs_over(heeded, source.rigs)
    laid = [_lay_out(rig, settings, clock, stop, source.cameras, heeded) for rig in rigs]
    outcome: Outcome = "dry run"
    if not dry_run:
        # The best layout is found: a request to stop finds nothing to cut short, and must not break into USD.
        with clock.stage("write", can_stop=True):
            outcome = _written(asset, target, settings, source, laid, heeded)
    return Report(
        asset=str(asset),
        output="" if dry_run else str(target),
        outcome=outcome,
        characters=tuple(laid),
        issues=tuple(found for character in laid for found in character.issues),
        seconds=clock.seconds,
        settings=settings_document(settings),
        sources=tuple(_source_row(each, asset) for each in source.sources),
    )


def inspect(
    asset: Path, settings: Settings, *, progress: Watch | None = None, animations: Sequence[Path] = ()
) -> Inspection:
    """What the stages before the search find out about `asset`, and what `animations` tell of its controls;
    writes nothing.
    """
    clock = _Clock(progress)
    with clock.stage("read"):
        source = read_rigs_isolated(asset, settings)
        clips = animation.performances(animations, settings)
    found = [posed(rig, settings, clock, source.cameras) for rig in source.rigs]
    issues = [each for ready in found for each in _issues(ready)]
    characters = []
    for ready in found:
        facts = _facts(ready)
        if clips:
            told, heard = animation.animation_facts(ready.context, ready.candidates, clips)
            facts = replace(facts, animation=told)
            issues += heard
        characters.append(facts)
    return Inspection(str(asset), tuple(characters), tuple(issues), clock.seconds)


def posed(
    rig: Rig,
    settings: Settings,
    clock: _Clock | None = None,
    cameras: Mapping[str, Floats] | None = None,
    examples: Examples | None = None,
) -> Posed:
    """The layout problem of one rig: every stage between reading and solving."""
    clock, examples = clock or _Clock(None), examples or Examples()
    settings = with_fixed(examples, rig, settings)
    base_values = _base_values(rig, settings)
    with clock.stage("trajectories"):
        found = trajectory_stage.trajectories(rig, settings.trajectories, base_values)
    if not found.motions:
        raise refuse("CONTROLS_MISSING", rig.root, "none of its controls moves a point")
    standing = examples.standing(rig)
    if standing is not None:
        settings = additions_stage.as_drawn(standing, found, settings)
    with clock.stage("symmetry"):
        symmetry = symmetry_stage.symmetry_at_pose(rig, found, settings, base_values)
    settings = animation.heeded(rig, symmetry, settings, examples.clips)
    with clock.stage("candidates"):
        views = visibility_stage.find_views(
            rig,
            found,
            symmetry,
            settings.candidates.view,
            settings.candidates.occlusion,
            (cameras or {}).get(rig.root),
        )
        precedent = precedent_of(examples, rig, found, settings)
        context = Context(rig, found, symmetry, views, settings, precedent, standing)
        if standing is not None:
            review_stage.refuse_stale(context, standing)
        candidates = additions_stage.of_new_controls(context, candidates_stage.candidates(context))
    with clock.stage("problem"):
        groups = levels_stage.levelled(context, groups_stage.find_groups(context, candidates))
        problem, choices = problem_stage.layout_problem(context, candidates, groups)
    return Posed(context, candidates, groups, problem, choices, base_values)


def load_layer(layer: Path, settings: Settings) -> Loaded:
    """A layout layer and the rigs that it stands over, for viewers and checks.

    Raises RigUIError LAYOUT_MISSING, SOURCE_MISSING and everything that reading an asset can raise.
    """
    found = read_layouts_isolated(layer, settings)
    layouts, source = {each.root: each for each in found.layouts}, found.source
    if not source:
        raise refuse("SOURCE_MISSING", str(layer), "has no sublayer that it stands over")
    read = read_rigs_isolated(Path(source), settings)
    missing = set(layouts) - {each.root for each in read.rigs}
    if missing:
        raise refuse("LAYOUT_STALE", min(missing), f"{source} has no such character any more")
    characters = tuple((each, layouts[each.root]) for each in read.rigs if each.root in layouts)
    return Loaded(characters, source, read.cameras)


def check(layer: Path, settings: Settings, *, progress: Watch | None = None) -> LayerReview:
    """Whether a layout layer still fits its rig, and how good it is; writes nothing.

    Works on layers from any tool or hand.  Raises RigUIError where the layer or its source cannot be read.
    """
    clock = _Clock(progress)
    with clock.stage("read"):
        try:
            loaded = load_layer(layer, settings)
        except RigUIError as error:
            return LayerReview(str(layer), (), clock.seconds, _source_faults(layer, settings, error))
    reviews = []
    for rig, layout in loaded.characters:
        ready = posed(rig, settings, clock, loaded.cameras)
        with clock.stage("review"):
            reviews.append((rig.root, review_stage.review(ready.context, ready.candidates, layout)))
    return LayerReview(str(layer), tuple(reviews), clock.seconds)


def diff(before: Path, after: Path, settings: Settings) -> LayerDifference:
    """What changed between two layout layers, character by character; reads only the layers, not their rigs.

    Raises RigUIError where a layer cannot be read.
    """
    old, new = (
        {each.root: each for each in read_layouts_isolated(layer, settings).layouts} for layer in (before, after)
    )
    found = tuple(difference_stage.difference(old[root], new[root]) for root in new if root in old)
    return LayerDifference(str(before), str(after), found, tuple(sorted(old.keys() ^ new.keys())))


def _source_faults(asset: Path, settings: Settings, refusal: RigUIError) -> tuple[Issue, ...]:
    """What is wrong with a source asset; raises the refusal of its layout again if it is no source asset."""
    if refusal.issue.code != "LAYOUT_MISSING":
        raise refusal
    found = read_faults_isolated(asset, settings)
    if not found.characters:
        raise refusal
    try:
        issues = tuple(each for rig in read_rigs_isolated(asset, settings).rigs for each in rig.issues)
    except RigUIError as error:
        issues = (error.issue,)
    known = {(each.code, each.path) for each in found.issues}
    return (*found.issues, *(each for each in issues if (each.code, each.path) not in known))


def default_output(asset: Path) -> Path:
    """``char.usda`` → ``char.rigui.usda``, beside it."""
    return asset.with_name(asset.stem + ".rigui.usda")


def write_file(content: bytes, target: Path) -> str:
    """Write a report, picture or page all or nothing; returns ``written`` or ``unchanged``.

    Raises FILE_TARGET for the name of a USD file, so that no slip of the hand replaces a character.
    """
    from usdrigui.usd.safe_write import commit

    if target.suffix in _USD_SUFFIXES:
        raise refuse("FILE_TARGET", str(target), "is named as a USD file, which this is not")
    _make_folder(target)
    return commit(content, target)


# --- one character -----------------------------------------------------------------------------------


def _lay_out(
    rig: Rig,
    settings: Settings,
    clock: _Clock,
    stop: Callable[[], bool] | None,
    cameras: Mapping[str, Floats],
    examples: Examples,
) -> CharacterReport:
    from usdrigui.solve import solve

    ready = posed(rig, settings, clock, cameras, examples)
    with clock.stage("solve", can_stop=True):
        assignment = solve(ready.problem, settings.solve, clock.solving, stop)
    with clock.stage("layout"):
        layout = elements_stage.layout(
            ready.context,
            ready.candidates,
            ready.groups,
            ready.problem,
            ready.choices,
            assignment,
            ready.base_values,
        )
    standing = ready.context.standing
    if standing is not None:
        layout = additions_stage.joined(standing, additions_stage.told_apart(layout, standing))
    previous = examples.previous.get(rig.root)
    return _character(ready, layout, assignment, _changes(ready, previous, layout, assignment) if previous else None)


def _changes(ready: Posed, previous: Layout, layout: Layout, assignment: Assignment) -> difference_stage.Difference:
    gains = gain_stage.gains_of_leaving(ready.context, ready.groups, ready.problem, ready.choices, assignment.labels)
    return difference_stage.difference(previous, layout, gains)


def _character(
    ready: Posed, layout: Layout, assignment: Assignment, changes: difference_stage.Difference | None
) -> CharacterReport:
    rig = ready.context.rig
    controls = rig.controls
    motions = ready.context.trajectories.motions
    peaks = {controls[each.control].name: float(each.arc_length.max()) for each in motions}
    laid = {member.control for element in layout.elements for member in element.members}
    return CharacterReport(
        root=rig.root,
        rig=rig,
        layout=layout,
        assignment=assignment,
        rows=rows_of(rig, layout, peaks, _twin_names(ready)),
        notes=tuple(note for note in _notes(ready) if note.control in laid),
        issues=(*_issues(ready), *_nothing_added(ready, layout)),
        difference=changes,
        added=_added(ready, layout),
    )


def _added(ready: Posed, layout: Layout) -> frozenset[str]:
    """Names of the elements that do not stand in another layer."""
    standing = ready.context.standing
    return frozenset(e.name for e in layout.elements[len(standing.elements) if standing is not None else 0 :])


def _nothing_added(ready: Posed, layout: Layout) -> tuple[Issue, ...]:
    if ready.context.standing is None or _added(ready, layout):
        return ()
    return (issue("BASE_COMPLETE", layout.root, f"{len(layout.elements)} elements stand"),)


def _issues(ready: Posed) -> tuple[Issue, ...]:
    return (*ready.context.rig.issues, *ready.context.trajectories.issues)


def _notes(ready: Posed) -> tuple[LeftOff, ...]:
    return (*ready.context.trajectories.left_off, *ready.candidates.left_off)


def _twin_names(ready: Posed) -> dict[str, str]:
    controls = ready.context.rig.controls
    twins = ready.context.symmetry.twins
    return {
        control.name: controls[twin].name
        for control, twin in zip(controls, twins, strict=True)
        if twin >= 0 and controls[twin] is not control
    }


def _base_values(rig: Rig, settings: Settings) -> Floats:
    """(controls,) the base pose (paper: P)."""
    index = {control.name: i for i, control in enumerate(rig.controls)}
    values = np.array([control.default for control in rig.controls], dtype=np.float64)
    for name, value in settings.read.pose.items():
        if name not in index:
            what = f"{rig.root} has no control of this name{meant(name, index)}"
            raise refuse("CONFIG_UNKNOWN_CONTROL", f'read.pose."{name}"', what)
        values[index[name]] = value
    return values


def _facts(ready: Posed) -> CharacterFacts:
    rig, trajectories, symmetry = ready.context.rig, ready.context.trajectories, ready.context.symmetry
    sets = {trajectories.motions[each.motion].control: each for each in ready.candidates.sets}
    motions = {each.control: each for each in trajectories.motions}
    twins = _twin_names(ready)
    said: dict[str, list[str]] = {}
    for note in (*rig.left_off, *_notes(ready)):
        said.setdefault(note.control, []).append(note.reason)
    for found in trajectories.issues:
        said.setdefault(found.path, []).append(found.message)
    rows = []
    for index, control in enumerate(rig.controls):
        chosen, motion = sets.get(index), motions.get(index)
        flags = list(said.get(control.name, ()))
        if chosen is not None:
            marks = (
                ("global", chosen.globally),
                ("hidden", chosen.hidden),
                ("composite", chosen.composite),
                ("beside by request", chosen.requested),
            )
            flags += [name for name, on in marks if on]
        rows.append(
            ControlFacts(
                control=control.name,
                kind=control.kind,
                source=control.source,
                minimum=control.minimum,
                default=control.default,
                maximum=control.maximum,
                range_source=control.range_source,
                points=0 if motion is None else len(motion.points),
                coverage=0.0 if chosen is None else chosen.coverage,
                peak=0.0 if motion is None else float(motion.arc_length.max()) / trajectories.typical_length,
                twin=twins.get(control.name, "self" if symmetry.twins[index] == index else ""),
                twin_source=symmetry.sources[index],
                flags=tuple(flags),
            )
        )
    return CharacterFacts(
        root=rig.root,
        points=len(trajectories.base),
        meshes=len(rig.meshes),
        joints=len(rig.joints),
        symmetric=float((symmetry.partner >= 0).mean()),
        controls=tuple(rows),
        groups=_group_lines(ready),
    )


def _group_lines(ready: Posed) -> tuple[str, ...]:
    names = [control.name for control in ready.context.rig.controls]
    return tuple(
        f"{group.kind} {group.name}: {', '.join(names[each] for each in group.controls)} ({group.reason})"
        for group in ready.groups
        if len(group.controls) > 1
    ) + tuple(
        f"suggestion: {', '.join(found)} move the same region; [groups.groups] would make them one element"
        for found in groups_stage.suggested_groups(ready.context, ready.candidates)
    )


# --- the two ends ------------------------------------------------------------------------------------


def _check_target(asset: Path, target: Path) -> None:
    if target.resolve() == asset.resolve():
        raise refuse("FILE_TARGET", str(target), "is the source itself, which is never written")


def _check_character(asset: Path, source: ReadResult) -> None:
    """Refuse what was laid out already: a layer over a layout layer would hold a second layout in the first."""
    if source.layouts:
        below = f"stands over {source.below}" if source.below else "stands over nothing else"
        raise refuse("SOURCE_IS_LAYOUT", str(asset), f"has the layout {source.layouts[0]} and {below}")


def _written(
    asset: Path, target: Path, settings: Settings, source: ReadResult, laid: list[CharacterReport], examples: Examples
) -> Outcome:
    """Write the layer, unless a file that it was made from has changed meanwhile."""
    from usdrigui.usd import layer

    own = os.path.realpath(target)
    if any(own == each.path for each in source.sources) and not settings.output.bare:
        raise refuse("ATTACH_CYCLE", str(target), f"is a part of {asset}")
    _check_replaceable(target, settings)
    _make_folder(target)
    if examples.base is not None:
        return _written_over(examples.base, asset, target, settings, source, laid)
    pairs = [(character.rig, character.layout) for character in laid]
    unchanged = functools.partial(check_unchanged, source.sources)
    return layer.write_layout(pairs, asset, target, settings.output, source.metadata, guard=unchanged)


def _written_over(
    base: LayoutsResult, shot: Path, target: Path, settings: Settings, source: ReadResult, laid: list[CharacterReport]
) -> Outcome:
    """Write what a shot adds to a layout that stands."""
    from usdrigui.usd.additions import Addition, write_additions

    layer = Path(base.sources[0].path)
    if os.path.realpath(target) == base.sources[0].path:
        raise refuse("FILE_TARGET", str(target), "is the layout that is to stay as it is")
    composed = any(each.path == base.sources[0].path for each in source.sources)
    additions = []
    for character in laid:
        root = additions_stage.root_in_base(base.layouts, character.rig)
        if root != character.root and not composed and base.source and not settings.output.bare:
            raise refuse("BASE_APART", character.root, f"stands at {root} in {layer.name}")
        prims = tuple(prim for prim in base.prims if prim.root == root)
        additions.append(Addition(character.rig, character.layout, character.added, root, prims))
    return write_additions(
        additions,
        shot,
        layer,
        target,
        source.metadata,
        composed=composed,
        bare=settings.output.bare,
        guard=functools.partial(check_unchanged, (*source.sources, *base.sources)),
    )


def _check_replaceable(target: Path, settings: Settings) -> None:
    """What stands at the target must be a layout layer: nobody's own work is replaced by a slip of the hand."""
    if not target.is_file() or not target.stat().st_size:
        return
    try:
        read_layouts_isolated(target, settings)
    except RigUIError as error:
        if error.issue.code == "LAYOUT_MISSING" or error.issue.code.startswith("FILE_NOT"):
            raise refuse("FILE_TARGET", str(target), "exists and is no layout layer") from error


def _make_folder(target: Path) -> None:
    from usdrigui.usd.safe_write import file_error

    try:
        target.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise file_error(target, error) from error


def _source_row(source: SourceFile, asset: Path) -> SourceRow:
    folder = os.path.realpath(asset.parent)
    return SourceRow(os.path.relpath(source.path, folder).replace(os.sep, "/"), source.sha256)


@dataclass
class _Clock:
    """Times the stages and tells the watcher."""

    watch: Watch | None
    _seconds: dict[str, float] = field(default_factory=dict)

    @property
    def seconds(self) -> tuple[tuple[str, float], ...]:
        return tuple(self._seconds.items())

    @contextmanager
    def stage(self, name: str, *, can_stop: bool = False) -> Iterator[None]:
        self._tell(Event(name, can_stop=can_stop))
        start = time.perf_counter()
        yield
        spent = time.perf_counter() - start
        self._seconds[name] = self._seconds.get(name, 0.0) + spent
        self._tell(Event(name, seconds=spent))

    def solving(self, progress: Progress) -> None:
        detail = f"{progress.step}: cost {progress.cost:.4f}, bound {progress.bound:.4f}, gap {progress.gap:.1e}"
        self._tell(Event("solve", detail, can_stop=True))

    def _tell(self, event: Event) -> None:
        if self.watch is not None:
            self.watch(event)
