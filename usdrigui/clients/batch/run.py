"""A whole batch: jobs in, rows out as they are done, a summary at the end.

`run_local` uses processes of this machine, `run_on_dask` the workers of a dask.distributed cluster,
which must see the same files under the same paths and have usdrigui installed.
"""

from __future__ import annotations

import importlib
import os
import time
from collections.abc import Generator, Iterable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor, as_completed, wait
from dataclasses import dataclass, replace
from typing import Any

from usdrigui.clients.batch.job import Job, Row
from usdrigui.clients.batch.jobs import end_all, failed, run_job
from usdrigui.errors import Exit, catalogue, refuse
from usdrigui.isolation import worker
from usdrigui.report.documents import document, plain

OUTCOMES = ("written", "unchanged", "skipped", "refused", "failed", "part")
_ENDING = 2.0
"""Seconds in which what runs must have ended."""
_RETRIES = 3
"""Workers that a job may lose before it is given up."""


@dataclass(frozen=True, slots=True)
class Summary:
    """What became of every asset, in the order in which they were named."""

    rows: tuple[Row, ...]
    seconds: float
    """Wall clock of the whole batch."""
    where: str
    """``local``, or the address of the scheduler."""
    workers: int

    @property
    def exit_code(self) -> Exit:
        """0 if every asset has its layout, else the gravest exit code of any."""
        return Exit(max((row.exit for row in self.rows), default=0))

    def count(self, outcome: str) -> int:
        """Number of assets with that outcome."""
        return sum(row.outcome == outcome for row in self.rows)


def run_local(jobs: Sequence[Job], workers: int) -> Generator[Row, None, None]:
    """Rows as they are done, `workers` at a time; leaving the loop early ends what still runs.

    An interruption ends it too; the rows that are known by then come before KeyboardInterrupt does.
    """
    pool = ThreadPoolExecutor(max_workers=max(1, workers))
    futures: list[Future[Row]] = []
    reported: set[Future[Row]] = set()
    try:
        for job in (
            jobs
        ):  # within, as Python would do at its exit all that an interruption leaves in the pool
            # Where it is interrupted, what was handed out until then is known.
            futures.append(pool.submit(run_job, job))  # noqa: PERF401
        for future in as_completed(futures):
            reported.add(future)
            yield future.result()
    except KeyboardInterrupt:
        worker.be_patient(True)  # ending them may take longer than a command that was stopped has
        _end(pool, futures)
        yield from [
            each.result()
            for each in futures
            if each not in reported and each.done() and not each.cancelled()
        ]
        raise
    finally:
        _end(pool, futures)


def _end(pool: ThreadPoolExecutor, futures: Sequence[Future[Row]]) -> None:
    """End what runs; a thread that compares what is remembered of a large asset is not waited
    for."""
    pool.shutdown(wait=False, cancel_futures=True)
    end = time.monotonic() + _ENDING
    while time.monotonic() < end and (running := [each for each in futures if not each.done()]):
        # again and again: a job that was taken up just before may start its worker just after
        end_all()
        wait(running, timeout=0.05)


def in_order(rows: Iterable[Row], jobs: Sequence[Job]) -> tuple[Row, ...]:
    """The rows in the order of the jobs, with one for each job that has none because the batch was
    stopped."""
    known = {row.output: row for row in rows}
    stopped = refuse("INTERRUPTED", "", "the batch was stopped before this asset was done")
    return tuple(known.get(job.output) or failed(job, stopped) for job in jobs)


def with_parts(rows: Iterable[Row], jobs: Sequence[Job]) -> tuple[Row, ...]:
    """The rows, where a file that a pattern found and that is no character is a part of the asset
    that needs it."""
    rows = tuple(rows)
    named = {job.output for job in jobs if job.named}
    whole = {path: row.asset for row in rows if row.sound for path in row.sources[1:]}

    def as_part(row: Row) -> Row:
        asset = whole.get(os.path.realpath(row.asset))
        if (
            asset is None
            or row.outcome != "refused"
            or row.exit != Exit.REFUSED
            or row.output in named
        ):
            return row
        return replace(
            row, outcome="part", exit=int(Exit.OK), code="", message=f"is a part of {asset}"
        )

    return tuple(map(as_part, rows))


def run_on_dask(jobs: Sequence[Job], address: str) -> Generator[Row, None, None]:
    """Rows as they are done by a cluster; a job whose worker dies is given to another one.

    Raises EXTRA_MISSING without dask.distributed, BATCH_SCHEDULER where no scheduler answers.
    """
    try:
        distributed = importlib.import_module("distributed")
    except ImportError:
        raise refuse(
            "EXTRA_MISSING",
            "dask",
            "dask.distributed is not installed: `pip install distributed`",
        ) from None
    try:
        client = distributed.Client(address, timeout=10, set_as_default=False)
    except (OSError, ValueError) as error:
        raise refuse("BATCH_SCHEDULER", address, f"no dask scheduler answers: {error}") from error
    with client:
        futures = client.map(run_job, jobs, pure=False, retries=_RETRIES)
        by_key = {future.key: job for future, job in zip(futures, jobs, strict=True)}
        for future in distributed.as_completed(futures, loop=client.loop):
            yield (
                future.result()
                if future.status == "finished"
                else failed(
                    by_key[future.key],
                    refuse(
                        "WORKER_LOST",
                        "",
                        f"the cluster abandoned it: {type(future.exception()).__name__}",
                    ),
                )
            )


def to_json(summary: Summary) -> str:
    """The summary as a JSON document."""
    return document(
        "batch",
        exit=int(summary.exit_code),
        where=summary.where,
        workers=summary.workers,
        seconds=round(summary.seconds, 3),
        counts={outcome: summary.count(outcome) for outcome in OUTCOMES},
        assets=[_asset(row) for row in summary.rows],
    )


def _asset(row: Row) -> dict[str, Any]:
    """A row with the repair of what is wrong, and without the files of the asset."""
    repair = catalogue()[row.code].repair if row.code in catalogue() else ""
    columns = {key: value for key, value in plain(row).items() if key != "sources"}
    return {**columns, "repair": repair}
