"""Reading processes by fork instead of a fresh start: the same bounds and the same code in 10 ms, not 400.

`Zygote` starts one process that has USD loaded but has opened nothing; each request makes it fork twice,
so that the reader becomes the child of whoever asked (a *subreaper*), exactly as if that one had started it.
Linux only.  `python tests/fuzz/zygote.py` is the other side.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import signal
import socket
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from typing import IO, Any

_SET_CHILD_SUBREAPER = 36


class Reader:
    """What `usdrigui.usd.reader_process` needs to know of a process."""

    def __init__(self, pid: int, stderr: IO[bytes]) -> None:
        self.pid = pid
        self.stderr = stderr
        self.returncode: int | None = None


class Zygote:
    """Stands in for `usdrigui.usd.reader_process._started`."""

    def __init__(self, environment: dict[str, str]) -> None:
        self._ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        self._process = subprocess.Popen(
            [sys.executable, __file__, str(os.getpid())], stdin=theirs, env=environment, start_new_session=True
        )
        theirs.close()

    def start(self, request: IO[bytes], response: IO[bytes]) -> Reader:
        """Fork a reader."""
        read_end, write_end = os.pipe()
        with _adopting():
            socket.send_fds(self._ours, [b"read"], [request.fileno(), response.fileno(), write_end])
            os.close(write_end)
            (pid,) = struct.unpack("<i", self._ours.recv(4))
        return Reader(pid, os.fdopen(read_end, "rb"))

    def close(self) -> None:
        """End the zygote."""
        self._ours.close()
        self._process.wait(10)


class Forking:
    """`usdrigui.usd.reader_process._started` by fork, wherever a fresh start would run the same program alike."""

    def __init__(self, fresh: Callable[..., Any]) -> None:
        self.fresh = fresh
        self.on = True
        self._zygote: Zygote | None = None
        self._world = _world()

    def start(self, request: IO[bytes], response: IO[bytes]) -> Any:
        """A forked reader; a fresh one where the program or its environment is another than it was, or if not `on`."""
        if not self.on or _world() != self._world:
            return self.fresh(request, response)
        if self._zygote is None:
            self._zygote = Zygote(self._world[1])
        return self._zygote.start(request, response)

    def close(self) -> None:
        """End the zygote, if there is one."""
        if self._zygote is not None:
            self._zygote.close()


def _world() -> tuple[str, dict[str, str]]:
    """The program and the environment of a reader; pytest's own name of the test that runs is no part of it."""
    from usdrigui.processes import environment

    told = environment(OPENBLAS_NUM_THREADS="1")
    return sys.executable, {name: value for name, value in told.items() if name != "PYTEST_CURRENT_TEST"}


@contextlib.contextmanager
def _adopting() -> Iterator[None]:
    """Be the parent of grandchildren whose parent ends; not for longer, or those of tests would never go."""
    ctypes.CDLL(None).prctl(_SET_CHILD_SUBREAPER, 1)
    try:
        yield
    finally:
        ctypes.CDLL(None).prctl(_SET_CHILD_SUBREAPER, 0)


def _serve(asker: int) -> None:
    from usdrigui.usd import reader_main

    reader_main.load()
    ours = socket.socket(fileno=os.dup(0))
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    while True:
        message, descriptors, _, _ = socket.recv_fds(ours, 16, 3)
        if not message:
            return
        if not (forked := os.fork()):
            if not os.fork():
                _become_reader(ours, descriptors, asker)
            os._exit(0)
        os.waitpid(forked, 0)
        for each in descriptors:
            os.close(each)


def _become_reader(ours: socket.socket, descriptors: Any, asker: int) -> None:
    from usdrigui.usd import reader_main

    os.setsid()
    for number, each in enumerate(descriptors):
        os.dup2(each, number)
        os.close(each)
    while (parent := os.getppid()) != asker:
        if parent == 1:  # Whoever asked has ended: nobody waits for this reader.
            os._exit(0)
        os.sched_yield()
    ours.send(struct.pack("<i", os.getpid()))
    ours.close()
    sys.stdin = os.fdopen(0, "r")
    reader_main.main()


if __name__ == "__main__":
    with contextlib.suppress(ConnectionError):
        _serve(int(sys.argv[1]))
