"""Reading USD that nobody has vouched for, in a process that may be lost.

A file of a few kilobytes can make USD crash, take gigabytes or never return, and nothing inside the
same process can prevent that.  So the asset is parsed by a reader with limits on time and memory,
which answers with plain records; whatever becomes of it is an issue code here.
`usdrigui.usd.reader_main` is the reader's side.
"""

from __future__ import annotations

import mmap
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import IO, TypeVar

from usdrigui import worker
from usdrigui.errors import Exit, RigUIError, refuse
from usdrigui.isolation.foreign_file import check_source, check_unchanged
from usdrigui.model import Performance
from usdrigui.processes import (
    Printed,
    ProcessEnd,
    Reading,
    answer_invalid,
    environment,
    kill,
    not_started,
    reading_failed,
    reaped,
    signals_later,
)
from usdrigui.settings import ReadSettings, Settings, with_sections
from usdrigui.usd import serialization
from usdrigui.usd.reader_records import (
    FaultsResult,
    LayerResult,
    LayoutsResult,
    Limits,
    Opening,
    ReadResult,
    Request,
    Response,
    Task,
)

_Part = TypeVar("_Part")


def read_rigs_isolated(path: Path, settings: Settings, limits: Limits | None = None) -> ReadResult:
    """As `usdrigui.usd.rig.read_rigs`, in a child process that may crash or hang without harm.

    Raises RigUIError with what the reader raises, unchanged, and FILE_NOT_FOUND, SOURCE_NOT_A_FILE,
    SOURCE_TOO_LARGE, SOURCE_LFS_POINTER, SOURCE_CRASHES_USD, SOURCE_TIME_LIMIT,
    SOURCE_MEMORY_LIMIT, SOURCE_READER_LOST, SOURCE_CHANGED.
    """
    limits = limits or Limits.of(settings.rig.read)
    before = check_source(path, limits.size)
    try:
        result = _understood(_response("rigs", path, settings, limits).rigs, path)
    except RigUIError:
        check_unchanged([before])  # A file that is being written is not the asset.
        raise
    if before not in result.sources:
        raise refuse("SOURCE_CHANGED", str(path), "was written while it was read")
    return result


def read_layouts_isolated(path: Path, opening: Opening) -> LayoutsResult:
    """As `usdrigui.usd.read_layout.read_layout` and `source_of`, in a reader; raises as
    `read_rigs_isolated`."""
    return _understood(_asked("layouts", path, opening).layouts, path)


def read_composed_isolated(
    path: Path, settings: Settings, limits: Limits | None = None
) -> tuple[LayoutsResult, ReadResult]:
    """The layouts of a stage, and their characters as that stage composes them: variants,
    overrides, instances and all.

    Raises as `read_rigs_isolated`, LAYOUT_MISSING, LAYOUT_STALE where it has none of the
    characters, SOURCE_MISSING for a layer that brings in no character at all.
    """
    limits = limits or Limits.of(settings.rig.read)
    try:
        check_source(path, limits.size)
        response = _response("composed", path, settings, limits)
    except RigUIError as error:
        if (
            error.issue.code == "SKELROOT_MISSING"
            and not read_layouts_isolated(path, Opening(settings.rig.read.variants, limits)).source
        ):
            raise refuse("SOURCE_MISSING", str(path), "does not sublayer any asset") from error
        raise
    return _understood(response.layouts, path), _understood(response.rigs, path)


def read_performances_isolated(path: Path, opening: Opening) -> tuple[Performance, ...]:
    """As `usdrigui.usd.clips.read_performances`, in a reader; raises as `read_rigs_isolated`."""
    return _understood(_asked("clips", path, opening).performances or None, path)


def read_faults_isolated(path: Path, opening: Opening) -> FaultsResult:
    """As `usdrigui.usd.faults.stage_faults`, in a reader; raises as `read_rigs_isolated` where
    nothing can be read."""
    return _understood(_asked("faults", path, opening).faults, path)


def read_layer_isolated(path: Path, opening: Opening) -> LayerResult:
    """A layer by itself, in a reader; what it composes need not be there.  Raises as
    `read_rigs_isolated`."""
    return _understood(_asked("layer", path, opening).layer, path)


def read_variants_isolated(path: Path, opening: Opening) -> Mapping[str, tuple[str, ...]]:
    """As `usdrigui.usd.variants.variant_sets`, in a reader; raises as `read_rigs_isolated` and
    VARIANT_UNKNOWN."""
    return _understood(_asked("variants", path, opening).variants, path)


def _understood(part: _Part | None, path: Path) -> _Part:
    """The part of a response that was asked for, which a sound response has."""
    if part is None:
        raise answer_invalid(str(path))
    return part


def _asked(task: Task, path: Path, opening: Opening) -> Response:
    """The reader's response about a file that it may be shown, whatever becomes a control."""
    check_source(path, opening.limits.size)
    settings = with_sections(Settings(), read=ReadSettings(variants=opening.variants))
    return _response(task, path, settings, opening.limits)


def _response(task: Task, path: Path, settings: Settings, limits: Limits) -> Response:
    # It keeps symbolic links, where resolve() would follow them.
    request = Request(task, os.path.abspath(path), settings, limits, os.getpid())  # noqa: PTH100
    response = _from_here(request, path) if worker.active() else _from_reader(request, path)
    if response.refusal is not None:
        raise RigUIError(response.refusal, Exit(response.exit_code), response.others)
    return response


def _from_here(request: Request, path: Path) -> Response:
    """The response of this process, whose supervisor decides what its death means."""
    from usdrigui.usd import reader_main

    with worker.reading(str(path), request.limits.seconds, request.limits.memory, reader_main.load):
        response = reader_main.respond(request)
    # As another process would have given it: arrays of one layout, which hold nothing of USD.
    try:
        return serialization.decode(b"".join(serialization.encode(response)), Response)
    except serialization.SerializationError as error:
        raise answer_invalid(str(path)) from error


def _from_reader(request: Request, path: Path) -> Response:
    """The response of a reader process, which is fresh for each file."""
    with _private_file() as request_file, _private_file() as response_file:
        request_file.writelines(serialization.encode(request))
        request_file.seek(0)
        end = _run(request_file, response_file, path, request.limits.seconds)
        response = _opened(response_file)
    if response is None:
        raise reading_failed(end, Reading(str(path), request.limits.seconds, request.limits.memory))
    return response


# --- the process ----------------------------------------------------------------------------------


def _run(
    request_file: IO[bytes], response_file: IO[bytes], path: Path, seconds: float
) -> ProcessEnd:
    """Start the reader, wait for its end, and be sure that it is gone whatever happens here."""
    deadline = time.monotonic() + seconds
    process, late = None, False
    try:
        with signals_later():
            try:
                process = _started(request_file, response_file)
            except (OSError, TypeError) as error:
                raise not_started(
                    error, "SOURCE_READER_LOST", str(path), "the process that reads"
                ) from error
            assert process.stderr is not None
            printed = Printed(process.stderr)
        late = not printed.ended(deadline - time.monotonic())
    finally:
        if process is not None:
            kill(process, group=True)
            code, peak = reaped(process)
            printed.close()
    return ProcessEnd(code, late, peak, printed.text)


def _started(request_file: IO[bytes], response_file: IO[bytes]) -> subprocess.Popen[bytes]:
    """The reader, leader of a process group of its own, so that all that it may start can be killed
    with it."""
    return subprocess.Popen(
        [sys.executable, "-P", "-m", "usdrigui.usd.reader_main"],
        stdin=request_file,
        stdout=response_file,
        stderr=subprocess.PIPE,
        env=environment(OPENBLAS_NUM_THREADS="1"),
        start_new_session=True,
    )


# --- the response ---------------------------------------------------------------------------------


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
        return serialization.decode(
            mmap.mmap(response_file.fileno(), 0, access=mmap.ACCESS_READ), Response
        )
    except serialization.SerializationError:
        return None
