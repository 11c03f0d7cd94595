"""Reading what nobody has vouched for, in a process that may be lost.

A file of a few kilobytes can make USD crash, take gigabytes or never return, and nothing inside the
same process can prevent that.  So it is read by a confined process with limits on time and memory,
which answers with plain records; whatever becomes of it is an issue code here
(`usdrigui.isolation.reader` is its side).

On Linux the reader is forked from a warm parent (`usdrigui.isolation.forking`): a worker forks that
from itself before it has read anything, everybody else starts one, which serves them for as long as
they live.
"""

from __future__ import annotations

import contextlib
import importlib
import tempfile
import time
from typing import TypeVar

from usdrigui.errors import RigUIError, refuse
from usdrigui.isolation import worker
from usdrigui.isolation.forking import FORKS, Child, UnbornError, close, fresh, warm_parent
from usdrigui.isolation.process import (
    Drain,
    ProcessEnd,
    not_started,
    signal_name,
    signals_later,
)
from usdrigui.isolation.reader import Question, read
from usdrigui.isolation.record_stream import RecordStreamError, decode, encode

_READER = "usdrigui.isolation.reader"

_Answer = TypeVar("_Answer")


_begun: dict[bytes, Child] = {}
"""The readers that have a question already."""


def begin(question: Question, program: str) -> None:
    """Let a reader begin, while a worker loads what else it needs, on what `answered` is asked
    next; where none can be started, that says why."""
    if FORKS and worker.active():
        with contextlib.suppress(OSError, TypeError):
            _begun[_content(question)] = _started(question, program)


def answered(question: Question, program: str, kind: type[_Answer]) -> _Answer:
    """What the module `program` answers, a record of class `kind`.

    Raises RigUIError SOURCE_CRASHES_USD, SOURCE_TIME_LIMIT, SOURCE_MEMORY_LIMIT,
    SOURCE_READER_LOST, PYTHON_PERMISSION.
    """
    reader = None
    deadline = time.monotonic() + question.seconds
    try:
        reader = _begun.pop(_content(question), None) or _started(question, program)
        answer, printed = Drain(reader.stdout, question.memory << 20), Drain(reader.stderr)
        late = not answer.ended(deadline - time.monotonic())
        code, peak = reader.end()
        answer.close()
        printed.close()
    except UnbornError as unborn:
        raise _failure(unborn.end, unborn.late, question) from None
    except (OSError, TypeError, RuntimeError) as error:  # the last for want of a thread
        _end_at_once(program, reader)
        what = "the process that reads"
        raise not_started(error, "SOURCE_READER_LOST", question.path, what) from error
    except BaseException:
        _end_at_once(program, reader)
        raise
    try:
        return decode(memoryview(answer.content).toreadonly(), kind)
    except RecordStreamError:
        if answer.failure is not None:
            message = f"its answer was not received: {answer.failure.strerror}"
            raise refuse("SOURCE_READER_LOST", question.path, message) from None
        used = max(0, peak - reader.began)
        raise _failure(ProcessEnd(code, used, bytes(printed.content)), late, question) from None


def _failure(end: ProcessEnd, late: bool, question: Question) -> RigUIError:
    """What it means that a reader ended without an answer."""
    path = question.path
    if late or end.was_killed_by("SIGALRM"):
        return refuse("SOURCE_TIME_LIMIT", path, f"was not read within {question.seconds:g} s")
    if end.starved(question.memory):
        message = f"needs more than {question.memory} MiB to be read"
        return refuse("SOURCE_MEMORY_LIMIT", path, message)
    if end.was_killed_by("SIGKILL"):
        return refuse("SOURCE_READER_LOST", path, "the reading process was killed from outside")
    if end.code < 0:
        return refuse("SOURCE_CRASHES_USD", path, f"USD crashed ({signal_name(-end.code)})")
    if end.code > 0:
        message = f"the reading process ended with code {end.code}: {end.last_line}"
        return refuse("SOURCE_READER_LOST", path, message)
    # It ended well and gave no answer of ours: that is no fault of the asset.
    return refuse("BUG", path, "the answer of the process that reads is invalid")


# --- the reader -----------------------------------------------------------------------------------


def _content(question: Question) -> bytes:
    return b"".join(encode(question))


def _started(question: Question, program: str) -> Child:
    """A reader of the question; raises OSError, TypeError."""
    with tempfile.TemporaryFile() as asked:  # it has no name
        asked.write(_content(question))
        asked.seek(0)
        if FORKS:
            if worker.active():
                importlib.import_module(program)  # before it is forked from here
            parent = warm_parent((_READER, program, "warm"), lambda: read(program))
            return parent.forked(asked.fileno(), question.seconds)
        with signals_later():
            return fresh((_READER, program), asked)


def _end_at_once(program: str, reader: Child | None) -> None:
    """Nothing that was started may outlive a question that is given up."""
    if FORKS:
        close((_READER, program, "warm"))
    elif reader is not None:
        reader.end()
