"""One asset of a batch: what is asked, what came of it, and the process that does it.

`run_job` never raises for what an asset does to it: a refusal, a crash, a process that is killed or
hangs are all rows of the summary.  It is a plain function of a plain record, so that a cluster can
run it.
"""

from __future__ import annotations

import json
import threading
from collections.abc import Mapping
from dataclasses import replace
from queue import SimpleQueue
from time import perf_counter
from typing import Any

import msgspec

from usdrigui.clients.batch import state
from usdrigui.clients.batch.job import Job, Row
from usdrigui.errors import Issue, RigUIError, refuse
from usdrigui.isolation.supervising import Events, Outcome, interrupted, supervise

_RUNNING: set[Events] = set()
"""Of each worker that runs: ends it when asked."""
_ENTERING = threading.Lock()
"""Held while a worker enters them, or all are ended, so that none is missed."""


def run_job(job: Job) -> Row:
    """Lay out one asset, unless nothing has changed since that was last done."""
    try:
        known = None if job.again else state.recall(job)
        return known or _laid_out(job)
    except Exception as error:
        return failed(job, refuse("BUG", "", f"{type(error).__name__}: {error}"))


def failed(job: Job, error: RigUIError) -> Row:
    """The row of an asset that has no layout because of an error."""
    found = error.issue
    outcome = "refused" if found.code.startswith(("SOURCE_", "CONFIG_", "FILE_")) else "failed"
    return _without_layout(job, outcome, int(error.exit_code), found)


def _without_layout(job: Job, outcome: str, code: int, found: Issue) -> Row:
    """The row of an asset, and why it has no layout."""
    where = f"{found.path}: " if found.path not in ("", job.asset) else ""
    return Row(job.asset, job.output, "", outcome, code, found.code, where + found.message)


def end_all() -> None:
    """End every worker that `run_job` has started in this process and that still runs."""
    with _ENTERING:
        for each in _RUNNING:
            each.put(interrupted())


def _laid_out(job: Job) -> Row:
    state.forget(job.output)
    start = perf_counter()
    outcome = _supervised(job)
    row = replace(_row(job, outcome), seconds=round(perf_counter() - start, 3))
    if row.sound:
        state.remember(job, json.loads(outcome.out)["sources"], row)
    return row


def _supervised(job: Job) -> Outcome:
    """How `usdrigui process` ends on the asset, in a worker of its own."""
    # Names may begin with a dash.
    options = ["--json", f"--output={job.output}", *job.arguments]
    if job.picture:
        options.append(f"--preview={job.picture}")
    command = ["process", *options, "--", job.asset]
    events: Events = SimpleQueue()
    late = refuse("BATCH_TIME_LIMIT", "", f"was not done within {job.timeout:g} s")
    limit = threading.Timer(job.timeout, events.put, (late,))
    limit.daemon = True
    with _ENTERING:
        _RUNNING.add(events)
    try:
        if job.timeout:
            limit.start()
        return supervise(command, lambda *_: None, events, alone=True)
    finally:
        limit.cancel()
        with _ENTERING:
            _RUNNING.discard(events)


# --- the row --------------------------------------------------------------------------------------


def _row(job: Job, outcome: Outcome) -> Row:
    if outcome.death is not None:
        return failed(job, outcome.death)
    document = json.loads(outcome.out)
    if document["outcome"] == "refused":
        found = msgspec.convert(document["issues"][0], Issue)
        return _without_layout(job, "refused", outcome.code, found)
    return _with_counts(
        Row(job.asset, job.output, job.picture, document["outcome"], outcome.code), document
    )


def _with_counts(row: Row, document: Mapping[str, Any]) -> Row:
    counts = [each["counts"] for each in document["characters"]]
    gaps = [each["solution"]["gap"] for each in document["characters"]]
    face, board, left_off = (
        sum(each[place] for each in counts) for place in ("face", "board", "left off")
    )
    return replace(
        row,
        controls=face + board + left_off,
        face=face,
        board=board,
        left_off=left_off,
        gap=max((each for each in gaps if each is not None), default=0.0),
        warnings=sum(each["severity"] == "warning" for each in document["issues"]),
        sources=state.real_paths(row.asset, [each["path"] for each in document["sources"]]),
    )
