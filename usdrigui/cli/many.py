"""`batch` and `openjd`: many characters, here or on a farm."""

from __future__ import annotations

import argparse
import contextlib
import os
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from usdrigui import worker
from usdrigui.cli.options import (
    add_each_variant,
    add_settings,
    command,
    files_read,
    passed_on,
    settings_digest,
    settings_quietly,
)
from usdrigui.cli.outcomes import say, screen_of
from usdrigui.errors import Exit, RigUIError, refuse

if TYPE_CHECKING:
    from usdrigui.clients.batch.job import Job, Row


def add_batch(commands: Any) -> None:
    """Add ``batch`` to the commands."""
    parser = command(
        commands, "batch", _batch, "lay out many characters, each in a process of its own"
    )
    _add_assets(parser)
    parser.add_argument(
        "--jobs", type=int, default=os.cpu_count() or 1, metavar="N", help="processes at a time"
    )
    parser.add_argument(
        "--dask", metavar="ADDRESS", help="use the workers of this dask scheduler instead"
    )
    parser.add_argument(
        "--timeout",
        type=float,
        default=0.0,
        metavar="SECONDS",
        help="end an asset that takes longer",
    )
    parser.add_argument("--again", action="store_true", help="lay out unchanged assets as well")
    parser.add_argument(
        "--summary",
        type=Path,
        metavar="JSON",
        help="write a JSON summary with the outcome of every asset",
    )
    parser.add_argument(
        "--sheet",
        type=Path,
        metavar="PNG",
        help="write a contact sheet; each picture is kept beside its layer",
    )
    add_settings(parser)


def add_openjd(commands: Any) -> None:
    """Add ``openjd`` to the commands."""
    parser = command(
        commands, "openjd", _openjd, "write a farm job, one task a character (Open Job Description)"
    )
    _add_assets(parser)
    parser.add_argument("-o", "--output", type=Path, metavar="JSON", help="default: print it")
    add_settings(parser)


def _add_assets(parser: Any) -> None:
    parser.add_argument(
        "patterns",
        nargs="+",
        metavar="PATTERN",
        help="files, or patterns in quotes; ** is any depth",
    )
    parser.add_argument(
        "--output-dir", dest="folder", type=Path, metavar="DIR", help="default: beside each asset"
    )
    add_each_variant(parser, "lay out every variant of this set, each in its variant")
    parser.add_argument(
        "--bare", action="store_true", help="leave the assets out of the layers' sublayers"
    )


def _batch(arguments: argparse.Namespace) -> Exit:
    _check_names(arguments)
    jobs, read = _jobs(arguments)
    _check_apart(jobs, read, arguments)
    return _all_of(jobs, read, arguments)


def _check_names(arguments: argparse.Namespace) -> None:
    """Refuse what the summary and the sheet cannot be called before the work, not after it."""
    from usdrigui import pipeline

    pipeline.check_outputs((arguments.summary, arguments.sheet))
    for target in filter(None, (arguments.summary, arguments.sheet)):
        if target.is_dir():
            raise refuse("FILE_TARGET", str(target), "is a folder")
    if arguments.sheet is not None and arguments.sheet.suffix.lower() != ".png":
        raise refuse(
            "CONFIG_VALUE",
            "--sheet",
            f"a contact sheet ends in .png, not in {arguments.sheet.suffix!r}",
        )


def _check_apart(jobs: Sequence[Job], read: Sequence[Path], arguments: argparse.Namespace) -> None:
    """Nothing that a batch writes may take the place of something that it reads, or else writes."""
    from usdrigui import pipeline
    from usdrigui.clients.batch import places, state

    files = []
    for job in jobs:
        files += [(Path(job.output), f"the layer of {job.asset}")]
        files += [(state.state_path(job.output), f"the batch record of {job.asset}")]
        files += [(Path(job.picture), f"the picture of {job.asset}")] if job.picture else []
    files += [(arguments.sheet, "the contact sheet")] if arguments.sheet is not None else []
    files += [(arguments.summary, "the summary")] if arguments.summary is not None else []
    places.check_apart(files)
    layers = {Path(job.output) for job in jobs}  # `process` decides which layer may be replaced
    pipeline.check_outputs((path for path, _ in files if path not in layers), read)


def _all_of(jobs: Sequence[Job], read: Sequence[Path], arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.clients.batch import contact_sheet, run

    screen = screen_of(arguments)
    address = arguments.dask
    start = time.perf_counter()
    rows: list[Row] = []
    working = run.run_on_dask(jobs, address) if address else run.run_local(jobs, arguments.jobs)
    with (
        screen.batch_progress(len(jobs)) as shown,
        contextlib.closing(working),
        _until_interrupted(),
    ):
        for row in working:
            rows.append(row)
            shown(row)
    ordered = run.with_parts(run.in_order(rows, jobs), jobs)
    summary = run.Summary(
        ordered, time.perf_counter() - start, address or "local", 0 if address else arguments.jobs
    )
    written = []
    if arguments.sheet is not None:
        written.append(
            f"{pipeline.write_file(contact_sheet.sheet_png(ordered), arguments.sheet, read)}"
            f" {arguments.sheet}"
        )
    if arguments.summary is not None:
        state = pipeline.write_file(run.to_json(summary).encode(), arguments.summary, read)
        written.append(f"{state} {arguments.summary}")
    if arguments.json:
        sys.stdout.write(run.to_json(summary))
    else:
        screen.batch(summary, written)
    warned = arguments.strict and any(row.warnings for row in ordered)
    return max(summary.exit_code, Exit.REFUSED if warned else Exit.OK)


@contextlib.contextmanager
def _until_interrupted() -> Iterator[None]:
    """An interruption ends the work, not the batch: what became of the assets is still
    printed."""
    try:
        yield
    except KeyboardInterrupt:
        worker.be_patient(True)


def _openjd(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.clients import openjd
    from usdrigui.clients.batch import places

    assets = places.find_assets(arguments.patterns)
    pairs = list(zip(assets, places.outputs_of(assets, arguments.folder), strict=True))
    template = openjd.template(pairs, passed_on(arguments))
    if arguments.output is None:
        sys.stdout.write(template)
        return Exit.OK
    state = pipeline.write_file(
        template.encode(), arguments.output, (*assets, *files_read(arguments))
    )
    say(f"usdrigui: {state} {arguments.output}: {len(assets)} tasks", arguments)
    return Exit.OK


def _jobs(arguments: argparse.Namespace) -> tuple[list[Job], list[Path]]:
    """One job per asset, each with the settings that its own configuration gives, and the files
    named to be read."""
    from usdrigui.clients.batch import places
    from usdrigui.clients.batch.job import Job, JobOptions

    settings_quietly(arguments)  # what is wrong with the command line is wrong for all assets
    assets = places.find_assets(arguments.patterns)
    passed = tuple(passed_on(arguments))
    found, read = [], []
    for asset, output in zip(assets, places.outputs_of(assets, arguments.folder), strict=True):
        picture = str(output.with_suffix(".png")) if arguments.sheet is not None else ""
        arguments.asset = asset
        try:
            digest = settings_digest(arguments)
        except RigUIError:
            # nothing is remembered under it; its own process reports what is wrong with its
            # configuration
            digest = ""
        read += files_read(arguments)  # known once the settings were read
        options = JobOptions(passed, digest, arguments.timeout, arguments.again)
        named = str(asset) in arguments.patterns
        found.append(Job(str(asset), str(output), picture, options, named))
    del arguments.asset
    return found, read
