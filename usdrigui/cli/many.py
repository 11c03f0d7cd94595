"""`batch` and `openjd`: many characters, here or on a farm."""

from __future__ import annotations

import argparse
import contextlib
import os
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from usdrigui.cli.options import files_read, passed_on, settings_digest, settings_quietly
from usdrigui.cli.outcomes import check_ending, screen_of, wrote
from usdrigui.errors import Exit, RigUIError, counted
from usdrigui.isolation import worker

if TYPE_CHECKING:
    from usdrigui.clients.batch.job import Job, Row


def batch(arguments: argparse.Namespace) -> Exit:
    """Lay out many characters, each in a process of its own."""
    _check_names(arguments)
    jobs, read = _jobs(arguments)
    _check_apart(jobs, read, arguments)
    return _all_of(jobs, read, arguments)


def _check_names(arguments: argparse.Namespace) -> None:
    """Refuse a summary and a sheet that cannot be written before the work, not after it."""
    from usdrigui import pipeline

    pipeline.check_outputs((arguments.summary, arguments.sheet))
    for target in filter(None, (arguments.summary, arguments.sheet)):
        pipeline.check_place(target)
    check_ending("--sheet", arguments.sheet, ".png")


def _check_apart(jobs: Sequence[Job], read: Sequence[Path], arguments: argparse.Namespace) -> None:
    """Nothing that a batch writes may take the place of something that it reads, or else writes."""
    from usdrigui import pipeline
    from usdrigui.clients.batch import places, state

    files = []
    for job in jobs:
        files += [
            (Path(job.output), f"the layer of {job.asset}"),
            (state.state_path(job.output), f"the batch record of {job.asset}"),
        ]
        files += [(Path(job.picture), f"the picture of {job.asset}")] if job.picture else []
    named = ((arguments.sheet, "the contact sheet"), (arguments.summary, "the summary"))
    files += [each for each in named if each[0] is not None]
    places.check_apart(files)
    layers = {Path(job.output) for job in jobs}  # `process` decides which layer may be replaced
    pipeline.check_outputs((path for path, _ in files if path not in layers), read)


def _all_of(jobs: Sequence[Job], read: Sequence[Path], arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.cli.terminal import review_lines
    from usdrigui.clients.batch import contact_sheet, run

    screen = screen_of(arguments)
    address = arguments.dask
    start = time.perf_counter()
    rows: list[Row] = []
    processes = arguments.jobs or os.cpu_count() or 1
    working = run.run_on_dask(jobs, address) if address else run.run_local(jobs, processes)
    width = len(str(len(jobs)))
    with contextlib.closing(working), _until_interrupted():
        for number, row in enumerate(working, 1):
            rows.append(row)
            outcome = f"{row.outcome:<9} {row.seconds:7.2f} s {row.asset} {row.code}"
            screen.note(f"[{number:>{width}}/{len(jobs)}] {outcome}".rstrip())
    ordered = run.with_parts(run.in_order(rows, jobs), jobs)
    summary = run.Summary(
        ordered, time.perf_counter() - start, address or "local", 0 if address else processes
    )
    files = {}
    if arguments.sheet is not None:
        files[arguments.sheet] = contact_sheet.sheet_png(ordered)
    if arguments.summary is not None:
        files[arguments.summary] = run.to_json(summary).encode()
    written = [f"{pipeline.write_file(files[path], path, read)} {path}" for path in files]
    screen.show(lambda: run.to_json(summary), review_lines.of_batch(summary, written))
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


def openjd(arguments: argparse.Namespace) -> Exit:
    """Write a farm job, one task a character."""
    from usdrigui import pipeline
    from usdrigui.clients import openjd
    from usdrigui.clients.batch import places

    assets = places.find_assets(arguments.patterns)
    pairs = list(zip(assets, places.outputs_of(assets, arguments.output_dir), strict=True))
    template = openjd.template(pairs, passed_on(arguments))
    if arguments.output is None:
        sys.stdout.write(template)
        return Exit.OK
    state = pipeline.write_file(
        template.encode(), arguments.output, (*assets, *files_read(arguments))
    )
    return wrote(arguments, {arguments.output: state}, more=f": {counted(len(assets), 'task')}")


def _jobs(arguments: argparse.Namespace) -> tuple[list[Job], list[Path]]:
    """One job per asset, each with the settings that its own configuration gives, and the files
    named to be read."""
    from usdrigui.clients.batch import places
    from usdrigui.clients.batch.job import Job

    settings_quietly(arguments)  # what is wrong with the command line is wrong for all assets
    assets = places.find_assets(arguments.patterns)
    passed = tuple(passed_on(arguments))
    found, read = [], []
    for asset, output in zip(assets, places.outputs_of(assets, arguments.output_dir), strict=True):
        picture = str(output.with_suffix(".png")) if arguments.sheet is not None else ""
        arguments.asset = asset
        try:
            digest = settings_digest(arguments)
        except RigUIError:
            # nothing is remembered under it; its own process reports what is wrong with its
            # configuration
            digest = ""
        read += files_read(arguments)  # known once the settings were read
        named = str(asset) in arguments.patterns
        how = passed, digest, arguments.timeout, arguments.again
        found.append(Job(str(asset), str(output), picture, named, *how))
    del arguments.asset
    return found, read
