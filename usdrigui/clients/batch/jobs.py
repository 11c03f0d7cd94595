"""One asset of a batch: what is asked, what came of it, and the process that does it.

`run_job` never raises for what an asset does to it: a refusal, a crash, a process that is killed or hangs
are all rows of the summary.  It is a plain function of a plain record, so that a cluster can run it.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from time import perf_counter
from typing import Any

from usdrigui.clients.batch import state
from usdrigui.clients.batch.job import Job
from usdrigui.errors import CODES, Exit

_PROCESSES: set[subprocess.Popen[bytes]] = set()
_STARTING = threading.Lock()
"""Held while a process is started or all are ended, so that none is missed."""


@dataclass(frozen=True, slots=True)
class Row:
    """What became of one asset."""

    asset: str
    output: str
    picture: str
    """Empty where none was asked for, and where there is no layout."""
    outcome: str
    """``written``, ``unchanged``, ``skipped`` (nothing has changed since the last batch), ``refused`` or ``failed``."""
    exit: int
    """Exit code that `usdrigui process` gave or would have given."""
    code: str = ""
    """Issue code of a refusal or failure."""
    message: str = ""
    controls: int = 0
    face: int = 0
    beside: int = 0
    left_off: int = 0
    gap: float = 0.0
    """Largest relative gap of its characters."""
    warnings: int = 0
    seconds: float = 0.0

    @property
    def sound(self) -> bool:
        """Whether there is a layout now."""
        return self.exit == Exit.OK


def run_job(job: Job) -> Row:
    """Lay out one asset, unless nothing has changed since that was last done."""
    known = None if job.again else state.recall(job)
    if known is not None:
        return replace(Row(**known), outcome="skipped", seconds=0.0)
    state.forget(job)
    start = perf_counter()
    code, printed = _process(job)
    row = replace(_row(job, code, printed), seconds=round(perf_counter() - start, 3))
    if row.sound:
        state.remember(job, printed["sources"], asdict(row))
    return row


def end_all() -> None:
    """End every process that `run_job` has started in this process and that still runs."""
    with _STARTING:
        for each in tuple(_PROCESSES):
            _end(each)


# --- the process -------------------------------------------------------------------------------------


def _process(job: Job) -> tuple[int, dict[str, Any]]:
    """Exit code (minus a signal; one more than any signal when the time was up) and report of the process."""
    files = [_no_option(job.asset), "-o", _no_option(job.output)]
    command = [sys.executable, "-m", "usdrigui", "process", *files, "--json", *job.arguments]
    if job.picture:
        command += ["--preview", _no_option(job.picture)]
    with _started(command) as process:
        try:
            printed, _ = process.communicate(timeout=job.timeout or None)
        except subprocess.TimeoutExpired:
            _end(process)
            process.communicate()
            return _TIME_IS_UP, {}
    try:
        document = json.loads(printed)
    except ValueError:
        return process.returncode, {}
    return process.returncode, document if isinstance(document, dict) else {}


def _no_option(path: str) -> str:
    """The path so that a command line cannot take it for an option, as it would ``-x.usda``."""
    return os.path.join(os.curdir, path) if path.startswith("-") else path  # noqa: PTH118 (a Path drops the dot)


_TIME_IS_UP = -1000


@contextlib.contextmanager
def _started(command: list[str]) -> Iterator[subprocess.Popen[bytes]]:
    """The process, in a group of its own so that the reader that it starts can be ended with it."""
    with _STARTING:
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, start_new_session=True
        )
        _PROCESSES.add(process)
    try:
        yield process
    finally:
        _PROCESSES.discard(process)
        _end(process)
        process.wait()


def _end(process: subprocess.Popen[bytes]) -> None:
    if process.poll() is None:
        with contextlib.suppress(OSError):
            if sys.platform == "win32":
                process.kill()
            else:
                os.killpg(process.pid, signal.SIGKILL)


# --- the row -----------------------------------------------------------------------------------------


def _row(job: Job, code: int, document: Mapping[str, Any]) -> Row:
    empty = Row(job.asset, job.output, "", "failed", int(Exit.BUG))
    if code == _TIME_IS_UP:
        return _failed(empty, "BATCH_TIME_LIMIT", f"was not done within {job.timeout:g} s")
    if code < 0:
        return _failed(empty, "BATCH_KILLED", f"its process was ended by {_signal(-code)}")
    if document.get("format") != "usdrigui.report":
        return _failed(empty, "BATCH_NO_REPORT", f"its process ended with code {code} and said nothing")
    if document["outcome"] == "refused":
        found = document["issues"][0]
        where = f"{found['path']}: " if found["path"] not in ("", job.asset) else ""
        return replace(empty, outcome="refused", exit=code, code=found["code"], message=where + found["message"])
    return _laid_out(replace(empty, picture=job.picture), code, document)


def _laid_out(empty: Row, code: int, document: Mapping[str, Any]) -> Row:
    counts = [each["counts"] for each in document["characters"]]
    gaps = [each["solution"]["gap"] for each in document["characters"]]
    face, beside, left_off = (sum(each[place] for each in counts) for place in ("face", "beside", "left off"))
    warnings = sum(each["severity"] == "warning" for each in document["issues"])
    return replace(
        empty,
        outcome=document["outcome"],
        exit=code,
        controls=face + beside + left_off,
        face=face,
        beside=beside,
        left_off=left_off,
        gap=max((each for each in gaps if each is not None), default=0.0),
        warnings=warnings,
    )


def _failed(row: Row, code: str, message: str) -> Row:
    return replace(row, code=code, message=message, exit=int(CODES[code].exit))


def _signal(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


Watch = Callable[[Row], None]
