"""Processes forked from a warm parent, which has a program loaded, has read nothing and has one
thread: some hundredths of a second each, where a fresh one takes more than half a second.

So confined readers are started on Linux (`usdrigui.isolation.reading`), and the workers of a batch
(`usdrigui.isolation.supervising`).  Elsewhere each process is a fresh one.  Nothing here imports
more than the standard library.
"""

from __future__ import annotations

import atexit
import contextlib
import gc
import os
import signal
import socket
import struct
import subprocess
import sys
import threading
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import IO, Any, NoReturn

from usdrigui.isolation import worker
from usdrigui.isolation.confinement import bind_to
from usdrigui.isolation.process import (
    Drain,
    Process,
    ProcessEnd,
    environment,
    in_mib,
    kill,
    reaped,
    resident,
    signals_later,
)

FORKS = sys.platform == "linux"
"""On macOS a process that has loaded the system's libraries cannot be forked safely."""
Program = tuple[str, ...]
"""A module, run with ``python -m``, and its arguments."""

_PAIR = struct.Struct("<ii")
"""Of a process that was forked its number, and MiB resident that it began with; of one that was
reaped its exit code, or minus the signal, and MiB resident at most."""
_MESSAGE = 1 << 16
"""Bytes of a question at most: the folder of the process that is to be forked, or the number of one
that is to be reaped."""
_FAREWELL = 0.2
"""Seconds in which a warm parent that ends by itself has ended."""


class UnbornError(OSError):
    """What was to fork a process has ended instead."""

    def __init__(self, end: ProcessEnd, late: bool) -> None:
        super().__init__(f"its parent ended with code {end.code}: {end.last_line}")
        self.end, self.late = end, late


@dataclass(frozen=True, slots=True)
class Child:
    """A process of ours that was forked from a warm parent, or is fresh, and what it writes."""

    process: Process
    stdout: IO[bytes]
    stderr: IO[bytes]
    stdin: IO[bytes] | None
    """Where it hears us, if it does."""
    parent: WarmParent | None = None
    """Who has forked it; none for one that is our own child."""
    began: int = 0
    """MiB resident when it was forked."""
    leads: bool = True
    """Whether it leads a group, which ends with it."""

    def say(self, what: bytes) -> None:
        """Tell it something; it may have ended."""
        assert self.stdin is not None
        with contextlib.suppress(OSError):
            self.stdin.write(what)
            self.stdin.flush()

    def end(self) -> tuple[int, int]:
        """Be sure that it is gone; exit code and MiB resident at most."""
        kill(self.process, group=self.leads)
        if self.parent is not None:
            return self.parent.reaped(self.process)
        return reaped(self.process)


def fresh(program: Program, stdin: Any, *, alone: bool = True, **special: str) -> Child:
    """A fresh Python that runs the program, `special` in its environment; `alone`: one of many, the
    leader of a group of its own, so that all that it may start can be killed with it."""
    one = {"OPENBLAS_NUM_THREADS": "1"} if alone else {}
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", *program],
        stdin=stdin,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=environment(**one, **special),
        start_new_session=alone,
    )
    assert process.stdout is not None
    assert process.stderr is not None
    return Child(process, process.stdout, process.stderr, process.stdin, leads=alone)


# --- who asks -------------------------------------------------------------------------------------


@dataclass
class _Forked:
    """A process that was forked."""

    pid: int
    returncode: int | None = None


class WarmParent:
    """It ends when nobody holds the other end of its socket, and what it has forked with it."""

    def __init__(
        self, world: Any, process: Process, asking: socket.socket, printed: IO[bytes]
    ) -> None:
        self.world = world
        self.alive = True
        self.process, self._asking, self._printed = process, asking, Drain(printed)
        self._lock = threading.Lock()

    def forked(self, given: int, seconds: float, stdin: IO[bytes] | None = None) -> Child:
        """A child in the folder of this process that is `given` its standard input, to which
        `stdin` leads; raises UnbornError where there is none within `seconds`."""
        answer, to_answer = os.pipe()
        printed, to_print = os.pipe()
        folder = os.fsencode(os.getcwd())  # noqa: PTH109 (names may hold bytes that are not text)
        try:
            number, began = self._told(folder, [given, to_answer, to_print], max(0.01, seconds))
        except (OSError, struct.error) as error:
            os.close(answer)
            os.close(printed)
            raise UnbornError(self.close(), isinstance(error, TimeoutError)) from error
        finally:
            os.close(to_answer)
            os.close(to_print)
        streams = os.fdopen(answer, "rb"), os.fdopen(printed, "rb")
        return Child(_Forked(number), *streams, stdin, self, began)

    def reaped(self, child: Process) -> tuple[int, int]:
        """Exit code and MiB resident at most of a child that was killed."""
        try:
            return self._told(b"%d" % child.pid, [], None)
        except (OSError, struct.error):
            self.close()
            return -signal.SIGKILL, 0  # what it has forked ends with it

    def _told(
        self, question: bytes, descriptors: list[int], seconds: float | None
    ) -> tuple[int, int]:
        with self._lock:
            self._asking.settimeout(seconds)
            socket.send_fds(self._asking, [question], descriptors)
            first, second = _PAIR.unpack(self._asking.recv(_PAIR.size))
            return first, second

    def close(self) -> ProcessEnd:
        """End it, and all that it has forked."""
        if not self.alive:
            return ProcessEnd(0, 0, b"")
        self.alive = False
        self._asking.close()
        self._printed.ended(_FAREWELL)  # one that ends by itself has a code of its own
        kill(self.process, group=True)
        code, peak = reaped(self.process)
        self._printed.close()
        return ProcessEnd(code, peak, bytes(self._printed.content))


_parents: dict[Program, WarmParent] = {}
_starting = threading.Lock()


def warm_parent(program: Program, here: Callable[[], NoReturn] | None = None) -> WarmParent:
    """The warm parent that runs the program and serves this process: the one that there is, if
    nothing has changed since it was started.

    The first one of a worker is forked from itself where `here` is what its children do: it has
    loaded that by then.
    """
    world = (os.getpid(), sys.executable, environment())
    with _starting:
        known = _parents.get(program)
        if known is not None and known.alive and known.world == world:
            return known
        if known is not None and known.world[0] == os.getpid():
            known.close()
        asking, served = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        with served, signals_later():
            if known is None and here is not None and worker.active():
                process: Process = _Forked(_forked_from_here(here, served))
                nothing = os.fdopen(os.open(os.devnull, os.O_RDONLY), "rb")
                _parents[program] = WarmParent(world, process, asking, nothing)
            else:
                child = fresh(program, served)
                _parents[program] = WarmParent(world, child.process, asking, child.stderr)
        return _parents[program]


def _forked_from_here(begin: Callable[[], NoReturn], served: socket.socket) -> int:
    """A warm parent that is this process as it is now, which has read nothing."""
    with warnings.catch_warnings():
        # The only other thread of a worker waits for its supervisor and holds nothing.
        warnings.simplefilter("ignore", DeprecationWarning)
        number = os.fork()
    if not number:
        try:
            worker.resign()
            os.setsid()
            nowhere = os.open(os.devnull, os.O_RDWR)
            _take(served.fileno(), nowhere, nowhere)
            serve(begin)
        finally:
            os._exit(1)
    return number


def close(program: Program) -> None:
    """End the warm parent that runs a program, if there is one."""
    if program in _parents:
        _parents[program].close()


@atexit.register
def _close() -> None:
    for parent in _parents.values():
        if parent.world[0] == os.getpid():
            parent.close()


# --- the warm parent ------------------------------------------------------------------------------


def serve(begin: Callable[[], NoReturn]) -> NoReturn:
    """Fork a child that begins so for everybody who asks on standard input, a socket, until nobody
    can ask any more: with the three descriptors that come as its standard streams, and no other."""
    asker = socket.socket(fileno=os.dup(0))
    os.dup2(2, 1)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.freeze()
    began = resident()
    while True:
        message, descriptors, _, _ = socket.recv_fds(asker, _MESSAGE, 3)
        if not message:
            os._exit(0)
        if descriptors:
            parent = os.getpid()
            child = os.fork()
            if not child:
                try:
                    bind_to(parent)
                    os.setsid()
                    _take(*descriptors)
                    os.chdir(message)
                    begin()
                finally:
                    os._exit(1)
            for descriptor in descriptors:
                os.close(descriptor)
            asker.send(_PAIR.pack(child, began))
        else:
            _, status, usage = os.wait4(int(message), 0)
            asker.send(_PAIR.pack(os.waitstatus_to_exitcode(status), in_mib(usage.ru_maxrss)))


def _take(*descriptors: int) -> None:
    """Make them the standard streams, and close everything else."""
    for stream, descriptor in enumerate(descriptors):
        os.dup2(descriptor, stream)
    os.closerange(len(descriptors), os.sysconf("SC_OPEN_MAX"))
