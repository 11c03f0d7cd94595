"""Reading USD that nobody has vouched for, in a process of its own.

A file of a few kilobytes can make USD crash, take gigabytes or never return, and nothing inside the same
process can prevent that.  So the asset is parsed by a reader with limits on time and memory, which answers
with plain records; whatever becomes of it is an issue code here.  `usdrigui.usd.reader_main` is the reader's side.
"""

from __future__ import annotations

import contextlib
import mmap
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any, Literal, TypeVar

from usdrigui.errors import Exit, Issue, RigUIError, refuse
from usdrigui.model import Floats, Layout, Performance, Record, Rig
from usdrigui.settings import Settings
from usdrigui.usd import serialization
from usdrigui.usd.source import SourceFile, check_source, check_unchanged

Task = Literal["rigs", "layouts", "clips", "faults", "layer"]
_Part = TypeVar("_Part")

_KEPT_TEXT = 1 << 16
"""Bytes kept of what the reader prints: USD can complain without end."""
_LAYERS_TOLD = 3
"""Layers in one message."""
_OUT_OF_MEMORY = (b"bad_alloc", b"MemoryError", b"Memory allocation", b"Cannot allocate memory")
"""What C++, Python, OpenBLAS and the C library print when there is no more."""


@dataclass(frozen=True, slots=True)
class Limits:
    """What the reading process may take."""

    seconds: float = 300.0
    """Wall clock."""
    memory: int = 8192
    """MiB of private memory, beyond what USD itself takes."""
    size: int = 8192
    """MiB of the asset's file."""

    @classmethod
    def of(cls, settings: Settings) -> Limits:
        """The limits that the settings name."""
        read = settings.read
        return cls(read.time_limit, read.memory_limit, read.size_limit)


@dataclass(frozen=True, eq=False)
class ReadResult(Record):
    """What an asset holds."""

    rigs: tuple[Rig, ...]
    metadata: Mapping[str, Any]
    """What a layer over the asset must repeat (`usdrigui.usd.layer.stage_metadata`), as JSON values."""
    cameras: Mapping[str, Floats]
    """Direction (3,) to the viewer of the camera that `candidates.view` names, in root space, by SkelRoot."""
    sources: tuple[SourceFile, ...]
    """Every file that composed it, the asset first."""
    layouts: tuple[str, ...] = ()
    """Scopes of the layouts that its root layer authors itself."""
    below: str = ""
    """The asset that such a root layer stands over; empty if it has none."""
    brought: Mapping[str, str] = field(default_factory=dict)
    """By SkelRoot, the file of the layout that another layer of it brings in."""


@dataclass(frozen=True, slots=True)
class StandingPrim:
    """One drawn prim of a layout that exists."""

    root: str
    """Of the character: its SkelRoot."""
    path: str
    element: str
    """Name of the element."""
    role: str
    """``track``, ``area`` or ``handle``."""
    controls: tuple[str, ...]
    """RigUIControlAPI instances that a track shows; none for the only one."""
    points: int
    shapes: tuple[str, ...]
    """``skel:blendShapes``."""
    targets: tuple[str, ...]
    """``skel:blendShapeTargets``."""


@dataclass(frozen=True, eq=False)
class LayoutsResult(Record):
    """What a layout layer holds."""

    layouts: tuple[Layout, ...]
    source: str
    """The asset it stands over; empty if it has none."""
    edited: Mapping[str, tuple[str, ...]]
    """By SkelRoot: names of the elements whose place or controls a stronger layer has changed."""
    sources: tuple[SourceFile, ...]
    prims: tuple[StandingPrim, ...] = ()
    brought: Mapping[str, str] = field(default_factory=dict)
    """By SkelRoot, the file of the layout that another layer of it brings in."""


@dataclass(frozen=True, eq=False)
class FaultsResult(Record):
    """What is wrong with an asset's blend shapes and animation, all of it."""

    issues: tuple[Issue, ...]
    empty: bool
    """Whether the stage has no prim at all."""


@dataclass(frozen=True, eq=False)
class LayerResult(Record):
    """A layer as its file has it, before anything is composed."""

    sublayers: tuple[str, ...]
    """As authored."""
    needed: tuple[str, ...]
    """Every file that it, or what it brings along, names for composition; each need not be there."""
    ours: bool
    """Whether it is a layout layer that we wrote, not one that brings such a layer in."""


@dataclass(frozen=True, eq=False)
class Request:
    """What the reader is asked; JSON on its standard input."""

    task: Task
    path: str
    settings: Settings
    limits: Limits
    parent: int
    """Process id: the reader ends with its parent."""


@dataclass(frozen=True, eq=False)
class Response:
    """What the reader answers: one of the results, or a refusal with its exit code."""

    rigs: ReadResult | None = None
    layouts: LayoutsResult | None = None
    faults: FaultsResult | None = None
    performances: tuple[Performance, ...] = ()
    layer: LayerResult | None = None
    refusal: Issue | None = None
    exit_code: int = 0


def read_rigs_isolated(path: Path, settings: Settings, limits: Limits | None = None) -> ReadResult:
    """As `usdrigui.usd.rig.read_rigs`, in a child process that may crash or hang without harm.

    Raises RigUIError with what the reader raises, unchanged, and FILE_NOT_FOUND, SOURCE_NOT_A_FILE,
    SOURCE_TOO_LARGE, SOURCE_LFS_POINTER, SOURCE_CRASHES_USD, SOURCE_TIME_LIMIT, SOURCE_MEMORY_LIMIT,
    SOURCE_READER_LOST, SOURCE_CHANGED.
    """
    limits = limits or Limits.of(settings)
    before = check_source(path, limits.size)
    try:
        result = _understood(_response("rigs", path, settings, limits).rigs, path)
    except RigUIError:
        check_unchanged([before])  # A file that is being written says nothing about the asset.
        raise
    if before not in result.sources:
        raise refuse("SOURCE_CHANGED", str(path), "was written while it was read")
    return result


def read_layouts_isolated(path: Path, settings: Settings, limits: Limits | None = None) -> LayoutsResult:
    """As `usdrigui.usd.read_layout.read_layout` and `source_of`, in a reader; raises as `read_rigs_isolated`."""
    return _understood(_asked("layouts", path, settings, limits).layouts, path)


def asset_below(found: LayoutsResult, layer: Path) -> str:
    """The asset that a layout layer stands over; `found` is what was read of it.  Raises RigUIError SOURCE_MISSING."""
    if found.source:
        return found.source
    brought = sorted(set(found.brought.values()))
    if brought and len(found.brought) == len(found.layouts):
        named = f"{', '.join(brought[:_LAYERS_TOLD])}{' and more' if len(brought) > _LAYERS_TOLD else ''}"
        reason = f"is no layout but a stage that references some; the layers that hold them: {named}"
        raise refuse("SOURCE_MISSING", str(layer), reason)
    raise refuse("SOURCE_MISSING", str(layer), "has no sublayer that it stands over")


def read_performances_isolated(path: Path, settings: Settings, limits: Limits | None = None) -> tuple[Performance, ...]:
    """As `usdrigui.usd.clips.read_performances`, in a reader; raises as `read_rigs_isolated`."""
    return _understood(_asked("clips", path, settings, limits).performances or None, path)


def read_faults_isolated(path: Path, settings: Settings, limits: Limits | None = None) -> FaultsResult:
    """As `usdrigui.usd.faults.stage_faults`, in a reader; raises as `read_rigs_isolated` where nothing can be read."""
    return _understood(_asked("faults", path, settings, limits).faults, path)


def read_layer_isolated(path: Path, settings: Settings, limits: Limits | None = None) -> LayerResult:
    """A layer by itself, in a reader; what it composes need not be there.  Raises as `read_rigs_isolated`."""
    return _understood(_asked("layer", path, settings, limits).layer, path)


def _understood(part: _Part | None, path: Path) -> _Part:
    """The part of a response that was asked for, which a sound response has."""
    if part is None:
        raise _garbled(path)
    return part


def _garbled(path: Path) -> RigUIError:
    return refuse("SOURCE_CRASHES_USD", str(path), "what USD made of it cannot be understood")


def _asked(task: Task, path: Path, settings: Settings, limits: Limits | None) -> Response:
    """The reader's response about a file that it may be shown."""
    limits = limits or Limits.of(settings)
    check_source(path, limits.size)
    return _response(task, path, settings, limits)


def _response(task: Task, path: Path, settings: Settings, limits: Limits) -> Response:
    request = Request(task, os.path.abspath(path), settings, limits, os.getpid())  # noqa: PTH100 (keeps links)
    with _private_file() as request_file, _private_file() as response_file:
        request_file.writelines(serialization.encode(request))
        request_file.seek(0)
        end = _run(request_file, response_file, path, limits.seconds)
        response = _opened(response_file)
    if response is None:
        raise _death(end, path, limits)
    if response.refusal is not None:
        raise RigUIError(response.refusal, Exit(response.exit_code))
    return response


# --- the process -------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class _End:
    """How the reader ended."""

    code: int
    """Exit code, or minus the signal."""
    late: bool
    """Killed because its time was up."""
    peak: int
    """MiB resident at most; 0 where that cannot be told."""
    text: bytes
    """The last of what it printed."""


def _run(request_file: IO[bytes], response_file: IO[bytes], path: Path, seconds: float) -> _End:
    """Start the reader, wait for its end, and be sure that it is gone whatever happens here."""
    deadline = time.monotonic() + seconds
    process, late = None, False
    try:
        with _signals_later():
            try:
                process = _started(request_file, response_file)
            except (OSError, TypeError) as error:
                raise refuse("SOURCE_READER_LOST", str(path), f"cannot be started: {error}") from error
            printed = _Printed(process)
        late = not printed.ended(deadline - time.monotonic())
    finally:
        if process is not None:
            _kill(process)
            code, peak = _reaped(process)
            printed.close()
    return _End(code, late, peak, printed.text)


@contextlib.contextmanager
def _signals_later() -> Iterator[None]:
    """A signal between the start of the reader and its being watched would leave it behind: it comes after."""
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


def _started(request_file: IO[bytes], response_file: IO[bytes]) -> subprocess.Popen[bytes]:
    """The reader, leader of a process group of its own, so that all that it may start can be killed with it."""
    return subprocess.Popen(
        [sys.executable, "-P", "-m", "usdrigui.usd.reader_main"],
        stdin=request_file,
        stdout=response_file,
        stderr=subprocess.PIPE,
        env=_environment(),
        start_new_session=True,
    )


def _environment() -> dict[str, str]:
    """The reader's environment: ours, our module path, and few threads, whose stacks would count as memory.

    With positional reads a crate file that shrinks under us is an error instead of a bus error.
    """
    own = {
        "PYTHONPATH": os.pathsep.join(each for each in sys.path if each),
        "USDC_USE_PREAD": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "MALLOC_ARENA_MAX": "2",
    }
    return {"PXR_WORK_THREAD_LIMIT": str(min(4, os.cpu_count() or 1)), **os.environ, **own}


class _Printed:
    """Keeps the last of what a process prints; that it prints no more means that it has ended."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        assert process.stderr is not None
        self._stream = process.stderr
        self._kept = bytearray()
        self._thread = threading.Thread(target=self._drain, daemon=True)
        self._thread.start()

    @property
    def text(self) -> bytes:
        return bytes(self._kept)

    def ended(self, seconds: float) -> bool:
        self._thread.join(max(0.0, seconds))
        return not self._thread.is_alive()

    def close(self) -> None:
        self._thread.join(1.0)
        self._stream.close()

    def _drain(self) -> None:
        with contextlib.suppress(OSError, ValueError):
            while block := os.read(self._stream.fileno(), _KEPT_TEXT):
                self._kept += block
                del self._kept[:-_KEPT_TEXT]


def _kill(process: subprocess.Popen[bytes]) -> None:
    with contextlib.suppress(OSError):
        if sys.platform == "win32":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL)


def _reaped(process: subprocess.Popen[bytes]) -> tuple[int, int]:
    """Exit code and peak memory in MiB of an ended process."""
    if sys.platform == "win32":
        return process.wait(), 0
    import resource

    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    # Until it loads its own program a reader counts as its parent, so a smaller figure says nothing.
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    per_mib = 1 << 20 if sys.platform == "darwin" else 1 << 10
    return process.returncode, usage.ru_maxrss // per_mib if usage.ru_maxrss > own else 0


# --- the response --------------------------------------------------------------------------------------


def _private_file() -> IO[bytes]:
    """A file without a name, in memory where the system can."""
    if sys.platform == "linux":
        return os.fdopen(os.memfd_create("usdrigui"), "w+b")
    return tempfile.TemporaryFile()


def _opened(response_file: IO[bytes]) -> Response | None:
    """The reader's response, or none if it is not whole; its arrays stay in the file's pages."""
    if not os.fstat(response_file.fileno()).st_size:
        return None
    try:
        return serialization.decode(mmap.mmap(response_file.fileno(), 0, access=mmap.ACCESS_READ), Response)
    except serialization.SerializationError:
        return None


def _death(end: _End, path: Path, limits: Limits) -> RigUIError:
    """What it means that the reader ended without a response."""
    if end.late or end.code == -signal.SIGALRM:
        return refuse("SOURCE_TIME_LIMIT", str(path), f"was not read within {limits.seconds:g} s")
    if _is_memory(end, limits):
        return refuse("SOURCE_MEMORY_LIMIT", str(path), f"needs more than {limits.memory} MiB to be read")
    if end.code == -signal.SIGKILL:
        return refuse("SOURCE_READER_LOST", str(path), "the reading process was killed from outside")
    if end.code < 0:
        return refuse("SOURCE_CRASHES_USD", str(path), f"USD crashed ({signal.Signals(-end.code).name})")
    if end.code > 0:
        last = end.text.decode(errors="replace").strip().rpartition("\n")[2]
        return refuse("SOURCE_READER_LOST", str(path), f"the reading process ended with code {end.code}: {last}")
    return _garbled(path)


def _is_memory(end: _End, limits: Limits) -> bool:
    return any(message in end.text for message in _OUT_OF_MEMORY) or end.peak > 0.8 * limits.memory
