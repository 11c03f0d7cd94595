"""Processes of usdrigui that may crash, hang or take too much: how they start, end and are bounded,
and what an end means.

Both use it: the supervisor of a command (`usdrigui.supervision`) and the reader process of a host
(`usdrigui.usd.reader_process`).  Nothing here imports more than the standard library.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

from usdrigui.errors import Exit, RigUIError, refuse

_KEPT_TEXT = 1 << 16
"""Bytes kept of what a process prints: USD can complain without end."""
_OUT_OF_MEMORY = (b"bad_alloc", b"MemoryError", b"Memory allocation", b"Cannot allocate memory")
"""What C++, Python, OpenBLAS and the C library print when there is no more."""
_CONNECTIONS = ("socket.", "subprocess.", "os.exec", "os.posix_spawn", "os.system", "os.fork")
"""Events of Python's audit while something is connected to or started."""
_ADDRESSES = 4 << 30
"""Bytes of address space beyond the memory: libraries reserve far more than they touch."""


@dataclass(frozen=True, slots=True)
class Reading:
    """A foreign file that a process is reading, and what that may take."""

    path: str
    seconds: float
    memory: int
    """MiB."""


@dataclass(frozen=True, slots=True)
class ProcessEnd:
    """How a process ended that left no answer."""

    code: int
    """Exit code, or minus the signal."""
    late: bool
    """Killed because its time was up."""
    peak: int
    """MiB resident at most; 0 where that is unknown."""
    text: bytes
    """The last of what it printed."""

    def starved(self, memory: int) -> bool:
        """Whether it ran out of `memory` (MiB; 0 for no limit)."""
        printed = any(message in self.text for message in _OUT_OF_MEMORY)
        return printed or (memory > 0 and self.peak > 0.8 * memory)

    @property
    def last_line(self) -> str:
        """The last line that it printed."""
        return self.text.decode(errors="replace").strip().rpartition("\n")[2]


def not_started(error: Exception, code: str, path: str, what: str) -> RigUIError:
    """The refusal where `what` cannot be started: `code` about `path`, or PYTHON_PERMISSION."""
    if isinstance(error, PermissionError):
        message = f"{what} cannot be started: {error.strerror}"
        return refuse("PYTHON_PERMISSION", str(error.filename or sys.executable), message)
    return refuse(code, path, f"{what} cannot be started: {error}")


def reading_failed(end: ProcessEnd, reading: Reading) -> RigUIError:
    """What it means that a process ended while it read a foreign file."""
    path = reading.path
    if end.late or end.code == -getattr(signal, "SIGALRM", 0):
        return refuse("SOURCE_TIME_LIMIT", path, f"was not read within {reading.seconds:g} s")
    if end.starved(reading.memory):
        return refuse(
            "SOURCE_MEMORY_LIMIT", path, f"needs more than {reading.memory} MiB to be read"
        )
    if end.code == -getattr(signal, "SIGKILL", 0):
        return refuse("SOURCE_READER_LOST", path, "the reading process was killed from outside")
    if end.code < 0:
        return refuse("SOURCE_CRASHES_USD", path, f"USD crashed ({signal_name(-end.code)})")
    if end.code > 0:
        return refuse(
            "SOURCE_READER_LOST",
            path,
            f"the reading process ended with code {end.code}: {end.last_line}",
        )
    return answer_invalid(path)


def answer_invalid(path: str) -> RigUIError:
    """A reader that ended well gave no answer of ours: that is no fault of the asset."""
    return refuse("BUG", path, "the answer of the process that reads is invalid")


def signal_name(number: int) -> str:
    """``SIGSEGV`` for 11."""
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


# --- starting and ending --------------------------------------------------------------------------


def environment(**own: str) -> dict[str, str]:
    """The environment of a process of ours: this one's, our module path, `own`, and few threads of
    USD.

    With positional reads a crate file that shrinks under us is an error instead of a bus error.
    Arrays of a stage take the memory of the one before: given back to the system, each page would
    be cleared for them again.
    """
    always = {
        "PYTHONPATH": os.pathsep.join(each for each in sys.path if each),
        "USDC_USE_PREAD": "1",
        "MALLOC_ARENA_MAX": "2",
        "MALLOC_MMAP_THRESHOLD_": str(32 << 20),
        "MALLOC_TRIM_THRESHOLD_": str(128 << 20),
    }
    return {
        "PXR_WORK_THREAD_LIMIT": str(min(4, os.cpu_count() or 1)),
        **os.environ,
        **always,
        **own,
    }


@contextlib.contextmanager
def signals_later() -> Iterator[None]:
    """A signal between the start of a process and its being watched would leave it behind: it comes
    after."""
    came: list[int] = []
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    numbers = (signal.SIGINT, signal.SIGTERM)
    before = [signal.signal(number, lambda at, _: came.append(at)) for number in numbers]
    try:
        yield
    finally:
        for number, handler in zip(numbers, before, strict=True):
            signal.signal(number, handler)
    for late in came:
        signal.raise_signal(late)


class Printed:
    """Keeps the last of what a process prints; that it prints no more means that it has ended."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream = stream
        self._kept = bytearray()
        self._thread = threading.Thread(target=self._drain, daemon=True)
        self._thread.start()

    @property
    def text(self) -> bytes:
        """The last of it."""
        return bytes(self._kept)

    def ended(self, seconds: float) -> bool:
        """Whether the process ends within `seconds`."""
        self._thread.join(max(0.0, seconds))
        return not self._thread.is_alive()

    def close(self) -> None:
        """Let go of the stream, of a process that has ended."""
        self._thread.join(1.0)
        self._stream.close()

    def _drain(self) -> None:
        with contextlib.suppress(OSError, ValueError):
            while block := os.read(self._stream.fileno(), _KEPT_TEXT):
                self._kept += block
                del self._kept[:-_KEPT_TEXT]


def kill(process: subprocess.Popen[bytes], *, group: bool = False) -> None:
    """End a process that nobody has waited for yet, so that `reaped` still finds it; `group`: with
    all its group."""
    with contextlib.suppress(OSError):
        if sys.platform == "win32":
            process.kill()
        elif group:
            os.killpg(process.pid, signal.SIGKILL)
        else:
            os.kill(process.pid, signal.SIGKILL)


def reaped(process: subprocess.Popen[bytes]) -> tuple[int, int]:
    """Exit code and peak memory in MiB of a process that has ended or is about to."""
    if sys.platform == "win32":
        return process.wait(), 0
    import resource

    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    # Until it loads its own program a process counts as its parent, so a smaller figure shows
    # nothing.
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    per_mib = 1 << 20 if sys.platform == "darwin" else 1 << 10
    return process.returncode, usage.ru_maxrss // per_mib if usage.ru_maxrss > own else 0


def bind_to(parent: int) -> None:
    """End this process when its parent `parent` does, however that ends; only Linux can."""
    if sys.platform != "linux":
        return
    import ctypes

    set_parent_death_signal = 1
    ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)
    if os.getppid() != parent:
        os._exit(int(Exit.LIMIT))


# --- bounds of this process -----------------------------------------------------------------------


def own_memory() -> int:
    """Bytes of private memory that this process has; 0 if the system does not report them."""
    try:
        return int(Path("/proc/self/statm").read_text().split()[5]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError):
        return 0


def lower(kind: int, soft: int, hard: int | None = None) -> None:
    """Lower a limit of this process for good, as far as the system lets us; `hard` is `soft` unless
    given."""
    import resource

    _, highest = resource.getrlimit(kind)
    wanted = soft if hard is None else hard
    top = wanted if highest == resource.RLIM_INFINITY else min(wanted, highest)
    with contextlib.suppress(ValueError, OSError):
        resource.setrlimit(kind, (min(soft, top), top))


def limit_memory(memory: int) -> int:
    """Let this process have `memory` MiB more than it has, for good; bytes that it may have
    then."""
    data = own_memory() + (memory << 20)
    if sys.platform != "win32":
        import resource

        lower(resource.RLIMIT_DATA, data)
        lower(resource.RLIMIT_AS, data + _ADDRESSES)
    return data


_offline: set[str] = set()
"""Holds a word while this process may open no connection and start no program; empty before the
first time."""


def stay_offline() -> None:
    """From now on this process opens no connection from Python and starts no program."""
    if not _offline:
        sys.addaudithook(_refuse_connections)
    _offline.update({"hooked", "offline"})


def _refuse_connections(event: str, _: tuple[Any, ...]) -> None:
    if "offline" in _offline and event.startswith(_CONNECTIONS):
        raise PermissionError(f"{event} is not allowed while an asset is read")


@contextlib.contextmanager
def bounded(memory: int) -> Iterator[None]:
    """For a while this process may take `memory` MiB more than it has, no file may grow, and it
    stays offline."""
    stay_offline()
    try:
        with _limited(memory):
            yield
    finally:
        _offline.discard("offline")


@contextlib.contextmanager
def _limited(memory: int) -> Iterator[None]:
    if sys.platform == "win32":
        yield
        return
    import resource

    data = own_memory() + (memory << 20)
    wanted = {
        resource.RLIMIT_DATA: data,
        resource.RLIMIT_AS: data + _ADDRESSES,
        resource.RLIMIT_FSIZE: 0,
    }
    before = {kind: resource.getrlimit(kind) for kind in wanted}
    try:
        for kind, (soft, hard) in before.items():
            least = wanted[kind] if soft == resource.RLIM_INFINITY else min(soft, wanted[kind])
            resource.setrlimit(kind, (least, hard))
        yield
    finally:
        for kind, limits in before.items():
            resource.setrlimit(kind, limits)
