"""Processes of usdrigui that may crash, hang or take too much: how they start and end, and what an
end means.

Both use it: the supervisor of a command (`usdrigui.isolation.supervising`) and who asks a confined
reader (`usdrigui.isolation.reading`).  Nothing here imports more than the standard library.
"""

from __future__ import annotations

import contextlib
import math
import os
import signal
import sys
import threading
from collections.abc import Iterator
from dataclasses import dataclass
from typing import IO, Protocol

from usdrigui.errors import RigUIError, refuse

_KEPT_TEXT = 1 << 16
"""Bytes kept of what a process prints: USD can complain without end."""
_BLOCK = 1 << 20
_OUT_OF_MEMORY = (
    b"bad_alloc",
    b"MemoryError",
    b"Memory allocation",
    b"Cannot allocate memory",
    b"Resource temporarily unavailable",
)
"""What C++, Python, OpenBLAS and the C library print when there is no more; the last for a thread
whose stack finds no room."""


class Process(Protocol):
    """What is needed of a process to end it: a `subprocess.Popen`, or one that was forked."""

    pid: int
    returncode: int | None


@dataclass(frozen=True, slots=True)
class ProcessEnd:
    """How a process ended that left no answer."""

    code: int
    """Exit code, or minus the signal."""
    peak: int
    """MiB resident at most; 0 where that is unknown."""
    text: bytes
    """The last of what it printed."""

    def starved(self, memory: int) -> bool:
        """Whether it ran out of `memory` (MiB; 0 for no limit)."""
        printed = any(message in self.text for message in _OUT_OF_MEMORY)
        return printed or (memory > 0 and self.peak > 0.8 * memory)

    def was_killed_by(self, name: str) -> bool:
        """Whether a signal of this name ended it."""
        return self.code < 0 and signal_name(-self.code) == name

    @property
    def last_line(self) -> str:
        """The last line that it printed."""
        return self.text.decode(errors="replace").strip().rpartition("\n")[2]


def addresses_allowed() -> float | int:
    """Bytes of addresses that the system allows this process, and all that it starts; inf without a
    limit."""
    with contextlib.suppress(ImportError):
        import resource

        limit = resource.getrlimit(resource.RLIMIT_AS)[0]
        return math.inf if limit == resource.RLIM_INFINITY else limit
    return math.inf


def not_started(error: Exception, code: str, path: str, what: str) -> RigUIError:
    """The refusal where `what` cannot be started: `code` about `path`, or PYTHON_PERMISSION."""
    if isinstance(error, PermissionError):
        message = f"{what} cannot be started: {error.strerror}"
        return refuse("PYTHON_PERMISSION", error.filename or sys.executable, message)
    return refuse(code, path, f"{what} cannot be started: {error}")


def signal_name(number: int) -> str:
    """``SIGSEGV`` for 11."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def environment(**special: str) -> dict[str, str]:
    """The environment of a process of ours: this one's, our module path, and what is `special`.

    USD starts no threads: a fork would lose them, and no asset of ours is read faster with four.
    With positional reads a crate file that shrinks under us is an error instead of a bus error.
    Arrays of a stage take the memory of the one before: given back to the system, each page would
    be cleared for them again.
    """
    always = {
        "PYTHONPATH": os.pathsep.join(folder for folder in sys.path if folder),
        "PXR_WORK_THREAD_LIMIT": "1",
        "USDC_USE_PREAD": "1",
        "MALLOC_ARENA_MAX": "2",
        "MALLOC_MMAP_THRESHOLD_": str(32 << 20),
        "MALLOC_TRIM_THRESHOLD_": str(128 << 20),
    }
    return {**os.environ, **always, **special}


@contextlib.contextmanager
def signals_later() -> Iterator[None]:
    """A signal between the start of a process and its being watched would leave it behind: it comes
    after."""
    came: list[int] = []
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    numbers = (signal.SIGINT, signal.SIGTERM)
    before = [signal.signal(number, lambda late, _: came.append(late)) for number in numbers]
    try:
        yield
    finally:
        for number, handler in zip(numbers, before, strict=True):
            signal.signal(number, handler)
    for late in came:
        signal.raise_signal(late)


class Drain:
    """What a process writes to a pipe, read as it comes: the last of it, or with `most` all of it
    up to so many bytes."""

    def __init__(self, stream: IO[bytes], most: int | None = None) -> None:
        self.content = bytearray()
        self.failure: OSError | None = None
        """Why not all of it could be read."""
        self._stream = stream
        self._most = most
        self._thread = threading.Thread(target=self._drain, daemon=True)
        self._thread.start()

    def ended(self, seconds: float) -> bool:
        """Whether nothing more comes, or more than may, within `seconds`: the process has ended."""
        self._thread.join(max(0.0, seconds))
        return not self._thread.is_alive()

    def close(self) -> None:
        """Let go of the stream, of a process that has ended."""
        self._thread.join(1.0)
        self._stream.close()

    def _drain(self) -> None:
        try:
            while block := os.read(self._stream.fileno(), _BLOCK):
                self.content += block
                if self._most is None:
                    del self.content[:-_KEPT_TEXT]
                elif len(self.content) > self._most:
                    return
        except ValueError:  # somebody has let go of the stream
            return
        except OSError as error:
            self.failure = error


def kill(process: Process, *, group: bool = False) -> None:
    """End a process that nobody has waited for yet, so that `reaped` still finds it; `group`: with
    all its group."""
    with contextlib.suppress(OSError):
        if sys.platform == "win32":
            os.kill(process.pid, signal.SIGTERM)
        else:
            os.kill(process.pid, signal.SIGKILL)
            if group:
                os.killpg(process.pid, signal.SIGKILL)


def reaped(process: Process) -> tuple[int, int]:
    """Exit code and peak memory in MiB of a process that has ended or is about to."""
    if sys.platform == "win32":
        import subprocess

        assert isinstance(process, subprocess.Popen)
        return process.wait(), 0
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    # Until it loads its own program a process counts as its parent, so a smaller figure shows
    # nothing.
    peak = in_mib(usage.ru_maxrss)
    return process.returncode, peak if peak > resident() else 0


def resident() -> int:
    """MiB that this process has had resident at most; 0 where that is unknown."""
    if sys.platform == "win32":
        return 0
    import resource

    return in_mib(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)


def in_mib(usage: int) -> int:
    """MiB of what the system reports as ``ru_maxrss``."""
    return usage >> (20 if sys.platform == "darwin" else 10)
