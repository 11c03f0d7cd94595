"""Reading what nobody has vouched for, in a process that may be lost.

A file of a few kilobytes can make USD crash, take gigabytes or never return, and nothing inside the
same process can prevent that.  So it is read by a confined process with limits on time and memory,
which answers with plain records; whatever becomes of it is an issue code here
(`usdrigui.isolation.reader` is its side).

On Linux the reader is forked from a warm parent, in some hundredths of a second: a worker forks
that parent from itself before it has read anything, everybody else starts one, which serves them
for as long as they live.  Elsewhere each reader is a fresh process.
"""

from __future__ import annotations

import atexit
import contextlib
import importlib
import os
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import time
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from typing import IO, Any, TypeVar

from usdrigui.errors import RigUIError, refuse
from usdrigui.isolation import worker
from usdrigui.isolation.process import (
    Drain,
    Process,
    ProcessEnd,
    environment,
    kill,
    not_started,
    reaped,
    signal_name,
    signals_later,
)
from usdrigui.isolation.reader import FORKED, REAPED, Question, close_all_but, serve
from usdrigui.isolation.record_stream import RecordStreamError, decode, encode

_FAREWELL = 0.2
"""Seconds in which a warm parent that ends by itself has ended."""

_Answer = TypeVar("_Answer")


def answered(question: Question, program: str, kind: type[_Answer]) -> _Answer:
    """What the module `program` answers, a record of class `kind`.

    Raises RigUIError SOURCE_CRASHES_USD, SOURCE_TIME_LIMIT, SOURCE_MEMORY_LIMIT,
    SOURCE_READER_LOST, PYTHON_PERMISSION.
    """
    reader = None
    deadline = time.monotonic() + question.seconds
    try:
        with _private_file(question) as asked:
            reader = _started(program, asked, deadline)
        answer, printed = Drain(reader.answer, question.memory << 20), Drain(reader.printed)
        late = not answer.ended(deadline - time.monotonic())
        code, peak = reader.end()
        answer.close()
        printed.close()
    except _UnbornError as unborn:
        raise _failure(unborn.end, unborn.late, question) from None
    except (OSError, TypeError, RuntimeError) as error:  # the last for want of a thread
        _end_at_once(reader)
        what = "the process that reads"
        raise not_started(error, "SOURCE_READER_LOST", question.path, what) from error
    except BaseException:
        _end_at_once(reader)
        raise
    try:
        return decode(memoryview(answer.content).toreadonly(), kind)
    except RecordStreamError:
        if answer.failure is not None:
            message = f"its answer was not received: {answer.failure.strerror}"
            raise refuse("SOURCE_READER_LOST", question.path, message) from None
        raise _failure(ProcessEnd(code, peak, bytes(printed.content)), late, question) from None


def answer_invalid(path: str) -> RigUIError:
    """A reader that ended well gave no answer of ours: that is no fault of the asset."""
    return refuse("BUG", path, "the answer of the process that reads is invalid")


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
    return answer_invalid(path)


@contextlib.contextmanager
def _private_file(question: Question) -> Iterator[IO[bytes]]:
    """The question in a file without a name."""
    with tempfile.TemporaryFile() as file:
        file.writelines(encode(question))
        file.seek(0)
        yield file


# --- the reader -----------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _Reader:
    """A process that reads."""

    answer: IO[bytes]
    printed: IO[bytes]
    process: Process
    parent: _WarmParent | None = None
    """Who has forked it; none for one that is our own child."""

    def end(self) -> tuple[int, int]:
        """Be sure that it is gone; exit code and MiB resident at most."""
        if self.parent is not None:
            return self.parent.reaped(self.process)
        kill(self.process, group=True)
        return reaped(self.process)


class _UnbornError(Exception):
    """What was to fork a reader has ended instead."""

    def __init__(self, end: ProcessEnd, late: bool) -> None:
        super().__init__()
        self.end, self.late = end, late


def _started(program: str, asked: IO[bytes], deadline: float) -> _Reader:
    """A reader of the question; raises OSError, TypeError, _UnbornError."""
    if sys.platform == "linux":
        return _warm_parent(program).forked(asked, deadline)
    with signals_later():
        process = _python(program, stdin=asked, stdout=subprocess.PIPE)
    assert process.stdout is not None
    assert process.stderr is not None
    return _Reader(process.stdout, process.stderr, process)


def _end_at_once(reader: _Reader | None) -> None:
    """Nothing that was started may outlive a question that is given up."""
    if _parent is not None:
        _parent.close()
    elif reader is not None:
        reader.end()


def _python(program: str, *more: str, **streams: Any) -> subprocess.Popen[bytes]:
    """A fresh process, leader of a group of its own, so that all that it may start can be killed
    with it."""
    return subprocess.Popen(
        [sys.executable, "-P", "-m", "usdrigui.isolation.reader", program, *more],
        stderr=subprocess.PIPE,
        env=environment(OPENBLAS_NUM_THREADS="1"),
        start_new_session=True,
        **streams,
    )


# --- its warm parent ------------------------------------------------------------------------------


@dataclass
class _Forked:
    """A process that was forked."""

    pid: int
    returncode: int | None = None


class _WarmParent:
    """A process that has a program loaded and forks a reader for every question.

    It ends when nobody holds the other end of its socket, and what it has forked with it.
    """

    def __init__(self, world: Any, process: Process, asking: socket.socket) -> None:
        self.world = world
        self.alive = True
        self._process = process
        self._asking = asking
        self._lock = threading.Lock()
        stderr = getattr(process, "stderr", None)
        self._printed = Drain(stderr) if stderr is not None else None

    def forked(self, asked: IO[bytes], deadline: float) -> _Reader:
        """A reader of the question; raises _UnbornError."""
        answer, to_answer = os.pipe()
        printed, to_print = os.pipe()
        folder = os.fsencode(os.getcwd())  # noqa: PTH109 (names may hold bytes that are not text)
        try:
            with self._lock:
                self._asking.settimeout(max(0.01, deadline - time.monotonic()))
                socket.send_fds(self._asking, [folder], [asked.fileno(), to_answer, to_print])
                (number,) = FORKED.unpack(self._asking.recv(FORKED.size))
        except (OSError, struct.error) as error:
            os.close(answer)
            os.close(printed)
            raise _UnbornError(self.close(), isinstance(error, TimeoutError)) from error
        finally:
            os.close(to_answer)
            os.close(to_print)
        return _Reader(os.fdopen(answer, "rb"), os.fdopen(printed, "rb"), _Forked(number), self)

    def reaped(self, reader: Process) -> tuple[int, int]:
        """Be sure that a reader is gone; exit code and MiB resident at most."""
        kill(reader)
        try:
            with self._lock:
                self._asking.settimeout(None)
                self._asking.send(FORKED.pack(reader.pid))
                code, peak = REAPED.unpack(self._asking.recv(REAPED.size))
        except (OSError, struct.error):
            return self.close().code, 0
        return code, peak

    def close(self) -> ProcessEnd:
        """End it, and all that it has forked."""
        if not self.alive:
            return ProcessEnd(0, 0, b"")
        self.alive = False
        self._asking.close()
        if self._printed is not None:
            self._printed.ended(_FAREWELL)  # one that ends by itself has a code of its own
        kill(self._process, group=True)
        code, peak = reaped(self._process)
        if self._printed is None:
            return ProcessEnd(code, peak, b"")
        self._printed.close()
        return ProcessEnd(code, peak, bytes(self._printed.content))


_parent: _WarmParent | None = None
_starting = threading.Lock()


def _warm_parent(program: str) -> _WarmParent:
    """The warm parent of this process: the one that there is, if nothing has changed since it was
    started."""
    global _parent
    world = (os.getpid(), program, sys.executable, environment())
    with _starting:
        if _parent is not None and _parent.alive and _parent.world == world:
            return _parent
        if _parent is not None and _parent.world[0] == os.getpid():
            _parent.close()
        asking, served = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        process: Process
        with served, signals_later():
            if _parent is None and worker.active():
                process = _Forked(_forked_from_here(program, served))
            else:
                process = _python(program, "warm", stdin=served, stdout=subprocess.DEVNULL)
        _parent = _WarmParent(world, process, asking)
        return _parent


def _forked_from_here(program: str, served: socket.socket) -> int:
    """A warm parent that is this process as it is now, which has loaded the program and read
    nothing."""
    module = importlib.import_module(program)
    with warnings.catch_warnings():
        # The only other thread of a worker waits for its supervisor and holds nothing.
        warnings.simplefilter("ignore", DeprecationWarning)
        number = os.fork()
    if not number:
        try:
            worker.resign()
            os.setsid()
            close_all_but(served.fileno())
            serve(module, served)
        finally:
            os._exit(1)
    return number


@atexit.register
def _close() -> None:
    if _parent is not None and _parent.world[0] == os.getpid():
        _parent.close()
