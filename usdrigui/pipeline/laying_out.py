"""process(): from an asset to its layout layer.

    Usd.Stage → Rig → LayoutProblem → Assignment → Layout → Sdf.Layer

The stages between a rig and its problem are those of `usdrigui.pipeline.stages`.
"""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from usdrigui.errors import Issue, explained, issue, refuse
from usdrigui.examples import ExampleLayers, Examples, followed, read_examples, rigs_over
from usdrigui.layout.reuse import existing_layout
from usdrigui.layout.review.difference import Difference, difference
from usdrigui.layout.review.improvement import improvements
from usdrigui.model import Floats, Layout, Rig
from usdrigui.pipeline.progress import Clock, Watch
from usdrigui.pipeline.stages import LaidPart, divided, issues_of, joined, joined_assignment, layout_of, part_problem
from usdrigui.pipeline.targets import check_replaceable, check_target, default_output
from usdrigui.pipeline.writing import stage_layer
from usdrigui.report import CharacterReport, Outcome, PartRow, Report, SourceRow, rows_of
from usdrigui.settings import Settings
from usdrigui.settings import document as settings_document
from usdrigui.usd.reader_process import read_rigs_isolated
from usdrigui.usd.reader_records import ReadResult
from usdrigui.usd.safe_write import Transaction, same_file
from usdrigui.usd.schema import SCOPE
from usdrigui.usd.source import SourceFile, check_unchanged

if TYPE_CHECKING:
    from pxr import Sdf, Usd


def process(
    asset: Path,
    settings: Settings,
    *,
    output: Path | None = None,
    dry_run: bool = False,
    progress: Watch | None = None,
    stop: Callable[[], bool] | None = None,
    examples: ExampleLayers | None = None,
    read: Sequence[Path] = (),
    extras: Callable[[Report, Transaction], None] | None = None,
) -> Report:
    """Lay out every character of `asset` and write the layer.

    Parameters: `output` defaults to ``<asset>.rigui.usda`` beside the asset; `stop` is polled during the
    search, which then ends with the best layout so far; `examples` are existing layouts and animations to
    use; `read` are further files behind the settings, which no output replaces; `extras` stages more files, such as
    the report, in one transaction with the layer.  Raises `usdrigui.errors.RigUIError`; then nothing has been written.
    """
    clock = Clock(progress)
    target = output if output is not None else default_output(asset)
    check_target(asset, target)
    with clock.stage("read"):
        source = read_rigs_isolated(asset, settings)
        _check_character(asset, target, source, settings, over_base=examples is not None and examples.base is not None)
        check_replaceable(target, settings, asset if output is None else None)
        references = read_examples(examples or ExampleLayers(), settings)
    references, characters = followed(references, source.rigs)
    rigs = rigs_over(references, characters, settings)
    reports = [_lay_out(rig, settings, clock, stop, source.cameras, references) for rig in rigs]
    outcome: Outcome = "dry run"
    with Transaction(_never_replaced(target, settings, source, references, examples or ExampleLayers(), read)) as files:
        if not dry_run:
            # The best layout is found: a request to stop finds nothing to cut short, and must not break into USD.
            with clock.stage("write", can_stop=True):
                outcome = stage_layer(files, asset, target, settings, source, reports, references)
        report = _report(asset, "" if dry_run else str(target), outcome, reports, clock, settings, source)
        if extras is not None:
            extras(report, files)
        check_unchanged((*source.sources, *(references.base.sources if references.base else ())))
        files.commit()
    return report


def process_stage(
    stage: Usd.Stage | Sdf.Layer,
    settings: Settings,
    *,
    progress: Watch | None = None,
    stop: Callable[[], bool] | None = None,
) -> Report:
    """Lay out every character of an open stage or layer, in memory: nothing is written.

    `Report.layer` holds the layout and sublayers nothing.  Raises `RigUIError`.
    """
    from usdrigui.usd import in_memory, layer

    clock = Clock(progress)
    settings = replace(settings, output=replace(settings.output, bare=True))
    root = stage.GetRootLayer() if hasattr(stage, "GetRootLayer") else stage
    with clock.stage("read"):
        source = in_memory.read_open_rigs(stage, settings)
    found = (*source.layouts, *(f"{root}/{SCOPE}" for root in source.composed_from))
    if found:
        raise refuse("SOURCE_IS_LAYOUT", str(root.identifier), f"has the layout {found[0]}")
    reports = [_lay_out(rig, settings, clock, stop, source.cameras, Examples()) for rig in source.rigs]
    laid = [(each.rig, each.layout) for each in reports]
    report = _report(Path(root.identifier), "", "in memory", reports, clock, settings, source)
    return replace(report, layer=layer.layer_for(laid, "", settings.output, source.metadata))


def _report(
    asset: Path,
    output: str,
    outcome: Outcome,
    reports: Sequence[CharacterReport],
    clock: Clock,
    settings: Settings,
    source: ReadResult,
) -> Report:
    return Report(
        asset=str(asset),
        output=output,
        outcome=outcome,
        characters=tuple(reports),
        issues=tuple(found for character in reports for found in character.issues),
        seconds=clock.seconds,
        settings=settings_document(settings),
        sources=tuple(_source_row(each, asset) for each in source.sources),
    )


def _never_replaced(
    target: Path,
    settings: Settings,
    source: ReadResult,
    references: Examples,
    layers: ExampleLayers,
    more: Sequence[Path],
) -> tuple[Path, ...]:
    """Every file that the run has read, but for the layout that its layer succeeds: `check_replaceable` has seen it."""
    parts = [Path(each.path) for each in source.sources]
    earlier = [each for each in (layers.fixed, layers.previous) if each is not None]
    succeeded = {os.path.realpath(each) for each in (*earlier, *(parts[1:] if settings.output.bare else ()))}
    read = (*parts, *(Path(each.path) for each in references.sources), *layers.animations, *more)
    return tuple(each for each in read if not (os.path.realpath(each) in succeeded and same_file(each, target)))


def _check_character(asset: Path, target: Path, source: ReadResult, settings: Settings, *, over_base: bool) -> None:
    """Refuse what was laid out already, unless the new layer adds to that layout or stands by itself (decision 105).

    Raises SOURCE_IS_LAYOUT, SOURCE_HAS_LAYOUT, and ATTACH_CYCLE for a target that is a part of the asset.
    """
    if source.layouts:
        below = f"stands over {source.below}" if source.below else "stands over nothing else"
        raise refuse("SOURCE_IS_LAYOUT", str(asset), f"has the layout {source.layouts[0]} and {below}")
    if settings.output.bare:
        return
    if any(os.path.realpath(target) == each.path for each in source.sources):
        raise refuse("ATTACH_CYCLE", str(target), f"is a part of {asset}")
    for rig in source.rigs:
        if rig.root in source.composed_from and not over_base:
            raise refuse(
                "SOURCE_HAS_LAYOUT", rig.root, f"{asset} brings in its layout from {source.composed_from[rig.root]}"
            )


def _lay_out(
    rig: Rig,
    settings: Settings,
    clock: Clock,
    stop: Callable[[], bool] | None,
    cameras: Mapping[str, Floats],
    examples: Examples,
) -> CharacterReport:
    from usdrigui.solve import solve

    character = divided(rig, settings, clock, cameras, examples)
    laid: list[LaidPart] = []
    for part in character.parts:
        neighbours = tuple(element for each in laid for element in each.layout.elements)
        inputs = part_problem(character, part, neighbours, clock)
        with clock.stage("solve", can_stop=True):
            assignment = solve(inputs.placement.problem, settings.solve, clock.solving, stop)
        with clock.stage("layout"):
            laid.append(LaidPart(inputs, layout_of(inputs, assignment), assignment))
    layout = joined(laid)
    existing = examples.existing(rig)
    if existing is not None:
        layout = existing_layout.combined(existing, existing_layout.uniquify_names(layout, existing))
    previous = examples.previous.get(rig.root)
    if previous is None:
        return _account(laid, layout, existing)
    tell = functools.partial(_changes, laid, previous, layout)
    changes, issues = explained(tell, None, rig.root)
    return _account(laid, layout, existing, changes, issues)


def _changes(laid: Sequence[LaidPart], previous: Layout, layout: Layout) -> Difference:
    improved: dict[str, float] = {}
    for each in laid:
        inputs = each.inputs
        improved |= improvements(inputs.face, inputs.requests, inputs.placement, each.assignment.labels)
    return difference(previous, layout, improved, laid[0].inputs.matchings["previous"])


def _account(
    laid: Sequence[LaidPart],
    layout: Layout,
    existing: Layout | None,
    changes: Difference | None = None,
    unexplained: tuple[Issue, ...] = (),
) -> CharacterReport:
    parts = [each.inputs for each in laid]
    rig = parts[0].face.rig
    peaks = {
        rig.controls[each.control].name: each.peak for inputs in parts for each in inputs.face.trajectories.motions
    }
    twins = {control: twin for inputs in parts for control, twin in inputs.twin_names.items()}
    rows = rows_of(rig, layout, peaks, twins)
    added = _added(existing, layout)
    nothing = () if existing is None or added else (_nothing_added(layout),)
    return CharacterReport(
        root=rig.root,
        rig=rig,
        layout=layout,
        assignment=joined_assignment([each.assignment for each in laid], [inputs.part for inputs in parts]),
        rows=rows,
        notes=tuple(dict.fromkeys(note for each in parts for note in each.left_off if note.control in layout.controls)),
        issues=(*issues_of(parts), *unexplained, *nothing),
        difference=changes,
        added=added,
        matchings=parts[0].matchings,
        parts=tuple(_part_row(each) for each in laid),
    )


def _part_row(laid: LaidPart) -> PartRow:
    elements = [element for element in laid.layout.elements if not element.anchor.on_board]
    controls = [motion.control for motion in laid.inputs.face.trajectories.motions]
    names = tuple(laid.inputs.face.rig.controls[control].name for control in controls)
    on_it = frozenset().union(*(element.controls for element in elements))
    return PartRow(laid.inputs.part, names, len(on_it), laid.layout.handle_width, laid.layout.view, laid.assignment)


def _added(existing: Layout | None, layout: Layout) -> frozenset[str]:
    """Names of the elements that do not stand in another layer."""
    return frozenset(e.name for e in layout.elements[len(existing.elements) if existing is not None else 0 :])


def _nothing_added(layout: Layout) -> Issue:
    return issue("BASE_COMPLETE", layout.root, f"{len(layout.elements)} elements stand")


def _source_row(source: SourceFile, asset: Path) -> SourceRow:
    folder = os.path.realpath(asset.parent)
    return SourceRow(os.path.relpath(source.path, folder).replace(os.sep, "/"), source.sha256)
