"""`process` and `inspect`, `check` and `diff`, `attach` and `detach`: from a character to its
layout, and what becomes of that."""

from __future__ import annotations

import argparse
import functools
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

from usdrigui.cli.options import files_read, settings_of, settings_of_command_line
from usdrigui.cli.outcomes import check_ending, screen_of, strict
from usdrigui.errors import Exit, Issue
from usdrigui.isolation import worker

if TYPE_CHECKING:
    from usdrigui.cli.terminal.screen import ProgressCallback, Screen
    from usdrigui.replacing.transaction import Transaction
    from usdrigui.report import run_report


def process(arguments: argparse.Namespace) -> Exit:
    """Lay out a character and write the layer beside it."""
    from usdrigui.reader.reader_process import begin_to_read

    settings = settings_of(arguments)
    if not settings.read.each_variant:  # each is read by itself
        begin_to_read(arguments.asset, settings)
    # Meanwhile what else is needed is loaded: a quarter of a second.
    from usdrigui import pipeline
    from usdrigui.cli.terminal import run_lines
    from usdrigui.pipeline.reference_layouts import ReferenceLayers
    from usdrigui.report import run_documents

    references = ReferenceLayers(
        fixed=arguments.fixed,
        previous=arguments.previous,
        like=arguments.like,
        animations=tuple(arguments.animation),
        base=arguments.base,
        corrections=tuple(arguments.corrections),
    )
    # Before the work, not after.
    pipeline.check_outputs((arguments.report, arguments.preview), files_read(arguments))
    check_ending("--preview", arguments.preview, ".png")
    screen = screen_of(arguments)
    written: list[str] = []
    with _progress(screen, arguments) as shown:

        def watch(event: pipeline.Event) -> None:
            worker.be_patient(event.can_stop)
            shown(event)

        result = pipeline.process(
            arguments.asset,
            settings,
            output=arguments.output,
            dry_run=arguments.dry_run,
            progress=watch,
            stop=worker.stop_requested,
            references=references,
            read=files_read(arguments),
            extras=functools.partial(_stage_extras, arguments, written),
        )
        arguments.written = f"the layout itself is {result.outcome} {result.output}".rstrip()
    screen.show(
        lambda: run_documents.to_json(result),
        run_lines.report_lines(result, written, verbose=arguments.verbose),
    )
    return strict(result.issues, arguments)


def _progress(
    screen: Screen, arguments: argparse.Namespace
) -> AbstractContextManager[ProgressCallback]:
    if not arguments.openjd:
        return screen.progress()
    from usdrigui.clients import openjd

    return nullcontext(openjd.progress_lines(worker.print_now))


def _stage_extras(
    arguments: argparse.Namespace,
    written: list[str],
    result: run_report.Report,
    files: Transaction,
) -> None:
    """Stage the report and the picture that were asked for with the layer; one line in `written`
    for each."""
    from usdrigui.model import levels
    from usdrigui.pipeline import stage_file
    from usdrigui.report import run_documents

    if arguments.report is not None:
        content = run_documents.to_json(result).encode()
        written.append(f"{stage_file(files, content, arguments.report)} {arguments.report}")
    if arguments.preview is not None:
        from usdrigui.view import sheet

        characters = [(each.rig, levels.shown(each.layout)) for each in result.characters]
        content = sheet.sheet_png(characters, labels=arguments.labels)
        written.append(f"{stage_file(files, content, arguments.preview)} {arguments.preview}")
        written += sheet.spelt_out(characters)


def inspect(arguments: argparse.Namespace) -> Exit:
    """List the controls without solving."""
    from usdrigui import pipeline
    from usdrigui.cli.terminal import review_lines
    from usdrigui.report import inspection

    settings, screen = settings_of(arguments), screen_of(arguments)
    with screen.progress() as shown:
        found = pipeline.inspect(
            arguments.asset,
            settings,
            progress=shown,
            animations=arguments.animation,
            like=arguments.like,
        )
    screen.show(lambda: inspection.to_json(found), review_lines.of_inspection(found))
    return strict(found.issues, arguments)


def check(arguments: argparse.Namespace) -> Exit:
    """Check that a layout still fits its rig, or that an asset is valid."""
    from usdrigui import pipeline
    from usdrigui.cli.terminal import review_lines
    from usdrigui.report import run_documents

    settings, screen = settings_of(arguments), screen_of(arguments)
    with screen.progress() as shown:
        found = pipeline.check(arguments.layer, settings, progress=shown)
    screen.show(
        lambda: run_documents.review_json(found.layer, found.characters, found.issues),
        review_lines.of_review(found),
    )
    if any(each.severity == "error" for each in found.issues):
        return Exit.REFUSED
    return strict(found.issues, arguments)


def diff(arguments: argparse.Namespace) -> Exit:
    """List the controls that two layouts of a character place differently, and why."""
    from usdrigui import pipeline
    from usdrigui.cli.terminal import review_lines
    from usdrigui.report import run_documents

    found = pipeline.diff(arguments.before, arguments.layer, settings_of_command_line(arguments))
    screen_of(arguments).show(
        lambda: run_documents.difference_json(found), review_lines.of_difference(found)
    )
    return Exit.REFUSED if arguments.strict and not found.empty else strict(found.issues, arguments)


def attach(arguments: argparse.Namespace) -> Exit:
    """Put a bare layout layer among the sublayers of the asset itself, or in a variant of it."""
    from usdrigui.clients.attaching.attach import attach

    issues: list[Issue] = []
    state = attach(
        arguments.asset,
        arguments.layer,
        settings_of(arguments),
        issues.append,
        in_variant=arguments.payload,
    )
    return _edited(state, "is attached", issues, arguments)


def detach(arguments: argparse.Namespace) -> Exit:
    """Remove an attached layout layer from the asset."""
    from usdrigui.clients.attaching.attach import detach

    state = detach(arguments.asset, arguments.layer, settings_of(arguments))
    return _edited(state, "is not attached", (), arguments)


def _edited(state: str, what: str, issues: Sequence[Issue], arguments: argparse.Namespace) -> Exit:
    from usdrigui.cli.terminal.run_lines import issue_lines
    from usdrigui.report.documents import document

    code = strict(issues, arguments)
    screen_of(arguments).show(
        lambda: document(
            "attach",
            asset=str(arguments.asset),
            layer=str(arguments.layer),
            outcome=state,
            exit=int(code),
            issues=issues,
        ),
        [*issue_lines(issues), f"usdrigui: {state} {arguments.asset}: {arguments.layer} {what}"],
    )
    return code
