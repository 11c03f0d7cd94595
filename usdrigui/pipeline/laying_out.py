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

from usdrigui.character import Record, Rig
from usdrigui.errors import Issue, issue, of_character, refuse
from usdrigui.isolation.foreign_file import SourceFile, check_unchanged
from usdrigui.layout.element.elements import proof_of
from usdrigui.layout.reuse import existing_layout
from usdrigui.layout.review.difference import difference
from usdrigui.layout.review.legibility import legibility_of
from usdrigui.layout.review.shortfalls import shortfalls
from usdrigui.model import Layout, Legibility
from usdrigui.pipeline import variants
from usdrigui.pipeline.configuration import refuse_unsound, with_corrections
from usdrigui.pipeline.joining import issues_of, joined, joined_assignment
from usdrigui.pipeline.progress import Clock, ProgressCallback
from usdrigui.pipeline.records import Character, LaidPart
from usdrigui.pipeline.reference_layouts import (
    ReferenceLayers,
    ReferenceLayouts,
    as_sibling,
    followed,
    read_references,
    rigs_over,
)
from usdrigui.pipeline.stages import character_of, layout_of, part_problem, with_own_cost
from usdrigui.pipeline.targets import check_place, check_replaceable, check_target, default_output
from usdrigui.pipeline.writing import check_base, stage_layer
from usdrigui.reader.reader_process import read_rigs_isolated, read_variants_isolated
from usdrigui.reader.reader_records import ReadResult
from usdrigui.replacing.transaction import Transaction, same_file
from usdrigui.report import documents
from usdrigui.report.run_report import CharacterReport, Outcome, PartRow, Report, SourceRow, rows_of
from usdrigui.settings import Settings
from usdrigui.settings.parts import OutputSettings
from usdrigui.stages.schema import SCOPE
from usdrigui.stages.variant_paths import asset_selections, with_sets

if TYPE_CHECKING:
    from pxr import Sdf, Usd


def process(
    asset: Path,
    settings: Settings,
    *,
    output: Path | None = None,
    dry_run: bool = False,
    progress: ProgressCallback | None = None,
    stop: Callable[[], bool] | None = None,
    references: ReferenceLayers | None = None,
    read: Sequence[Path] = (),
    extras: Callable[[Report, Transaction], None] | None = None,
) -> Report:
    """Lay out every character of `asset` and write the layer.

    Parameters: `output` defaults to ``<asset>.rigui.usda`` beside the asset; `stop` is polled
    during the search, which then ends with the best layout so far; `references` are existing
    layouts and animations to use; `read` are further files behind the settings, which no output
    replaces; `extras` stages more files, such as the report, in one transaction with the layer.
    Raises `usdrigui.errors.RigUIError`; then nothing has been written.
    """
    clock = Clock(progress)
    target = output if output is not None else default_output(asset)
    check_target(asset, target)
    layers = references or ReferenceLayers()
    with clock.stage("read"):
        readings, plain = _readings(asset, settings, layers)
        for each in readings:
            _check_character(
                asset, target, each.source, each.settings.output, over_base=layers.base is not None
            )
            _check_base(each, target)
        opening = settings.read
        check_replaceable(target, opening, asset if output is None else None)
        if dry_run:
            check_place(target)
    laid = _laid_out(readings, clock, stop)
    reports = [report for _, report in laid]
    outcome: Outcome = "dry run"
    with Transaction(_never_replaced(target, settings.output, readings, layers, read)) as files:
        if not dry_run:
            # The best layout is found: a request to stop finds nothing to cut short, and must not
            # break into USD.
            with clock.stage("write", can_stop=True):
                pairs = [(reading.references.base, report) for reading, report in laid]
                outcome = stage_layer(
                    files, asset, target, readings[0].source, pairs, bare=settings.output.bare
                )
        sources = _sources(readings)
        report = _report(
            asset, "" if dry_run else str(target), outcome, reports, clock, settings, sources, plain
        )
        if extras is not None:
            extras(report, files)
        bases = [each.references.base for each in readings if each.references.base]
        check_unchanged((*sources, *(file for base in bases for file in base.sources)))
        files.commit()
    return report


def process_stage(
    stage: Usd.Stage | Sdf.Layer,
    settings: Settings,
    *,
    progress: ProgressCallback | None,
    stop: Callable[[], bool] | None,
) -> Report:
    """Lay out every character of an open stage or layer, in memory: nothing is written.

    `Report.layer` holds the layout and sublayers nothing.  Raises `RigUIError`.
    """
    from usdrigui.layer import write_layout as layer
    from usdrigui.reader import in_memory

    clock = Clock(progress)
    settings = replace(settings, output=replace(settings.output, bare=True))
    root = stage.GetRootLayer() if hasattr(stage, "GetRootLayer") else stage
    with clock.stage("read"):
        readings, plain = _read_each(
            settings,
            lambda: in_memory.read_open_variants(stage, settings.read.variants),
            functools.partial(
                _read, functools.partial(in_memory.read_open_rigs, stage), ReferenceLayers()
            ),
        )
    sources = [each.source for each in readings]
    found = [
        name
        for each in sources
        for name in (*each.layouts, *(f"{at}/{SCOPE}" for at in each.composed_from))
    ]
    if found:
        raise refuse("SOURCE_IS_LAYOUT", root.identifier, f"has the layout {found[0]}")
    reports = [report for _, report in _laid_out(readings, clock, stop)]
    laid = [(each.rig, each.layout) for each in reports]
    report = _report(Path(root.identifier), "", "in memory", reports, clock, settings, (), plain)
    return replace(report, layer=layer.layer_for(laid, "", readings[0].source.metadata))


# --- what is read ---------------------------------------------------------------------------------


class AssetReading(Record):
    """An asset and the layouts to use, with the variants that the settings select."""

    settings: Settings
    source: ReadResult
    references: ReferenceLayouts


def _readings(
    asset: Path, settings: Settings, layers: ReferenceLayers
) -> tuple[list[AssetReading], tuple[Issue, ...]]:
    """The asset in each of the variants that are to be laid out; and what says of the others that
    they are left off."""
    if layers.base is not None:
        if settings.read.each_variant:
            raise refuse(
                "CONFIG_VALUE",
                "--base",
                "adds to the variant that the shot selects, and to no other",
            )
        over = _read_over(asset, settings, layers)
        return over, over[0].references.ignored
    sets = functools.partial(read_variants_isolated, asset, settings.read)
    return _read_each(
        settings,
        sets,
        functools.partial(_read, functools.partial(read_rigs_isolated, asset), layers),
    )


def _read_each(
    settings: Settings,
    sets: Callable[[], Mapping[str, tuple[str, ...]]],
    read: Callable[[Settings], AssetReading],
) -> tuple[list[AssetReading], tuple[Issue, ...]]:
    readings, plain = variants.in_each_variant(settings, sets, read)
    _check_above(readings)
    ignored = dict.fromkeys(told for each in readings for told in each.references.ignored)
    return readings, (*ignored, *plain)


def _read(
    read: Callable[[Settings], ReadResult], layers: ReferenceLayers, settings: Settings
) -> AssetReading:
    source = read(settings)
    references = read_references(layers, settings.read, source)
    corrected = with_corrections(settings, references.corrections, source.rigs)
    if corrected != settings:
        source, settings = read(corrected), corrected
    refuse_unsound(source, settings, references.like)
    return AssetReading(settings, source, references)


def _read_over(shot: Path, settings: Settings, layers: ReferenceLayers) -> list[AssetReading]:
    """A shot and its base; where that has a layout for each variant, once for the characters of
    each selection."""
    found = _read(functools.partial(read_rigs_isolated, shot), layers, settings)
    assert found.references.base is not None
    sets = frozenset[str]().union(
        *(asset_selections(each.variant_path) for each in found.references.base.layouts)
    )
    if not sets:
        return [found]
    alike: dict[tuple[tuple[str, str], ...], list[Rig]] = {}
    for rig in found.source.rigs:
        path = with_sets(found.source.variant_paths[rig.path], sets)
        alike.setdefault(tuple(asset_selections(path).items()), []).append(
            replace(rig, variant_path=path)
        )
    return [_of_variant(found, layers, dict(chosen), rigs) for chosen, rigs in alike.items()]


def _of_variant(
    found: AssetReading, layers: ReferenceLayers, chosen: Mapping[str, str], rigs: Sequence[Rig]
) -> AssetReading:
    """Some characters of a shot, over the layout that the base has for the variants that they
    select."""
    source = replace(found.source, rigs=tuple(rigs))
    opening = variants.selecting(found.settings, chosen).read
    return AssetReading(found.settings, source, read_references(layers, opening, source))


def _check_above(readings: Sequence[AssetReading]) -> None:
    """Raise VARIANT_BELOW where a layout would be composed for every variant of a set."""
    for name in readings[0].settings.read.variants:
        rigs = [rig for each in readings for rig in each.source.rigs]
        if not any(name in asset_selections(rig.variant_path) for rig in rigs):
            raise refuse(
                "VARIANT_BELOW",
                rigs[0].path,
                f"the variant set {name} is neither on it nor above it",
            )


def _sources(readings: Sequence[AssetReading]) -> tuple[SourceFile, ...]:
    """Every file that composed the asset in some variant, the asset first."""
    return tuple(
        {each.path: each for reading in readings for each in reading.source.sources}.values()
    )


# --- what is laid out -----------------------------------------------------------------------------


def _laid_out(
    readings: Sequence[AssetReading], clock: Clock, stop: Callable[[], bool] | None
) -> list[tuple[AssetReading, CharacterReport]]:
    """The characters of all variants, the later ones as the first unless configured otherwise."""
    reports: list[tuple[AssetReading, CharacterReport]] = []
    for each in readings:
        references, characters = followed(each.references, each.source.rigs)
        for rig in rigs_over(references, characters):
            same = [report for _, report in reports if report.root == rig.path]
            if not any(report.rig.variant_path == rig.variant_path for report in same):
                own = as_sibling(references, rig, same[0].layout) if same else references
                whose = clock.of(rig.path, told=len(each.source.rigs) > 1)
                laid = _lay_out(rig, each.settings, own, whose, stop)
                if own is not references:
                    # What a variant keeps of the first one is no history of its own.
                    kept = {same[0].layout.variant_path: laid.matchings["previous"]}
                    laid = replace(laid, difference=None, matchings=kept)
                reports.append((each, laid))
    return reports


def _report(
    asset: Path,
    output: str,
    outcome: Outcome,
    reports: Sequence[CharacterReport],
    clock: Clock,
    settings: Settings,
    sources: Sequence[SourceFile],
    plain: Sequence[Issue],
) -> Report:
    return Report(
        asset=str(asset),
        output=output,
        outcome=outcome,
        characters=tuple(reports),
        issues=(*(found for character in reports for found in character.issues), *plain),
        seconds=clock.seconds,
        settings=documents.plain(settings),
        sources=tuple(_source_row(each, asset) for each in sources),
    )


def _never_replaced(
    target: Path,
    settings: OutputSettings,
    readings: Sequence[AssetReading],
    layers: ReferenceLayers,
    more: Sequence[Path],
) -> tuple[Path, ...]:
    """Every file that the run has read, but for the layout that its layer succeeds:
    `check_replaceable` has seen it."""
    parts = [Path(each.path) for each in _sources(readings)]
    earlier = [each for each in (layers.fixed, layers.previous) if each is not None]
    succeeded = {
        os.path.realpath(each) for each in (*earlier, *(parts[1:] if settings.bare else ()))
    }
    others = [Path(each.path) for found in readings for each in found.references.sources]
    read = (*parts, *others, *layers.animations, *more)
    return tuple(
        each
        for each in read
        if not (os.path.realpath(each) in succeeded and same_file(each, target))
    )


def _check_character(
    asset: Path, target: Path, source: ReadResult, settings: OutputSettings, *, over_base: bool
) -> None:
    """Refuse what was laid out already, unless the new layer adds to that layout or stands by
    itself (decision 105).

    Raises SOURCE_IS_LAYOUT, SOURCE_HAS_LAYOUT, and ATTACH_CYCLE for a target that is a part of the
    asset.
    """
    if source.layouts:
        below = f"sublayers {source.below}" if source.below else "sublayers nothing else"
        raise refuse("SOURCE_IS_LAYOUT", asset, f"has the layout {source.layouts[0]} and {below}")
    if settings.bare:
        return
    if any(os.path.realpath(target) == each.path for each in source.sources):
        raise refuse("ATTACH_CYCLE", target, f"is a part of {asset}")
    for rig in source.rigs:
        inside = source.layout_inside(rig.path)
        if inside and not over_base:
            raise refuse("SOURCE_HAS_LAYOUT", rig.path, f"{asset} {inside}")


def _check_base(reading: AssetReading, target: Path) -> None:
    base = reading.references.base
    if base is not None:
        rigs = [rig for rig in reading.source.rigs if reading.references.existing(rig) is not None]
        check_base(base, reading.source, rigs, target, bare=reading.settings.output.bare)


def _lay_out(
    rig: Rig,
    settings: Settings,
    references: ReferenceLayouts,
    clock: Clock,
    stop: Callable[[], bool] | None,
) -> CharacterReport:
    from usdrigui.solve import solve

    character = character_of(rig, settings, references, clock)
    laid: list[LaidPart] = []
    for part in character.parts:
        neighbours = tuple(element for each in laid for element in each.layout.elements)
        own_clock = clock.of(part.name)
        inputs = part_problem(character, part, neighbours, own_clock)
        with own_clock.stage("solve", can_stop=True):
            assignment = solve(inputs.placement.problem, settings.solve, own_clock.solving, stop)
        with own_clock.stage("layout"):
            made = layout_of(inputs, assignment)
            own = with_own_cost(inputs, part, made, assignment)
            made = replace(made, proof=proof_of(own, made.proof.weights))
            laid.append(LaidPart(inputs, made, own))
    layout, existing = joined(laid).with_pairs(), character.references.existing
    if existing is not None:
        layout = existing_layout.combined(
            existing, existing_layout.uniquify_names(layout, existing)
        )
    return _account(character, laid, layout)


def _account(character: Character, laid: Sequence[LaidPart], layout: Layout) -> CharacterReport:
    parts, rig, references = [each.inputs for each in laid], character.rig, character.references
    existing, previous = references.existing, references.earlier
    twins = {control: twin for inputs in parts for control, twin in inputs.twin_names.items()}
    explained_by = {
        control: others for inputs in parts for control, others in inputs.explained_by.items()
    }
    kept = 0 if existing is None else len(existing.elements)
    added = frozenset(element.name for element in layout.elements[kept:])
    told = [found for e in laid for found in shortfalls(e.inputs.measured, e.layout.elements)]
    if existing is not None and not added:
        told.append(issue("BASE_COMPLETE", layout.root, f"{kept} elements in it"))
    legible = (legibility_of(each.inputs.face, each.layout.elements) for each in laid)
    return CharacterReport(
        root=rig.path,
        rig=rig,
        layout=layout,
        assignment=joined_assignment(
            [each.assignment for each in laid], [inputs.part for inputs in parts]
        ),
        rows=rows_of(rig, layout, twins, explained_by),
        issues=(
            *issues_of(parts),
            *of_character(rig.path_in_variants, tuple(dict.fromkeys(told))),
        ),
        difference=None if previous is None else difference(previous, layout),
        added=added,
        matchings=references.matchings,
        parts=tuple(_part_row(each) for each in laid),
        legibility=sum(legible, Legibility(0, ())),
    )


def _part_row(laid: LaidPart) -> PartRow:
    elements = [element for element in laid.layout.elements if not element.anchor.on_board]
    face = laid.inputs.face
    on_it = frozenset().union(*(element.controls for element in elements))
    return PartRow(
        laid.inputs.part,
        tuple(face.names),
        len(on_it),
        laid.layout.frame.handle_width,
        laid.layout.frame.view,
        laid.assignment,
    )


def _source_row(source: SourceFile, asset: Path) -> SourceRow:
    folder = os.path.realpath(asset.parent)
    return SourceRow(os.path.relpath(source.path, folder).replace(os.sep, "/"), source.sha256)
