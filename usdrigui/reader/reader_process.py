"""What can be asked of a confined reader (`usdrigui.isolation.reading`) about a USD file, and
what it answers; `usdrigui.reader.reader_main` is the reader's side."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from usdrigui.character import Performance
from usdrigui.errors import Exit, RigUIError, refuse
from usdrigui.isolation.foreign_file import check_source, check_unchanged
from usdrigui.isolation.reading import answer_invalid, answered
from usdrigui.reader.reader_records import (
    FaultsResult,
    LayerResult,
    LayoutsResult,
    ReadResult,
    Request,
    Response,
    Result,
    Task,
)
from usdrigui.settings import ReadSettings, Settings

_PROGRAM = "usdrigui.reader.reader_main"


def read_rigs_isolated(path: Path, settings: Settings) -> ReadResult:
    """As `usdrigui.reading.character.read_rigs`, in a child process that may crash or hang without
    harm.

    Raises RigUIError with what the reader raises, unchanged, and FILE_NOT_FOUND, SOURCE_NOT_A_FILE,
    SOURCE_TOO_LARGE, SOURCE_LFS_POINTER, SOURCE_CRASHES_USD, SOURCE_TIME_LIMIT,
    SOURCE_MEMORY_LIMIT, SOURCE_READER_LOST, SOURCE_CHANGED.
    """
    before = check_source(path, settings.read.size_limit)
    try:
        result = _answer("rigs", path, settings, ReadResult)
    except RigUIError:
        check_unchanged([before])  # A file that is being written is not the asset.
        raise
    if before not in result.sources:
        raise refuse("SOURCE_CHANGED", path, "was written while it was read")
    return result


def read_layouts_isolated(path: Path, opening: ReadSettings) -> LayoutsResult:
    """As `usdrigui.layer.read_layout.read_layout` and `source_of`, in a reader; raises as
    `read_rigs_isolated`."""
    return _asked("layouts", path, opening, LayoutsResult)


def read_composed_isolated(path: Path, settings: Settings) -> tuple[LayoutsResult, ReadResult]:
    """The layouts of a stage, and their characters as that stage composes them: variants,
    overrides, instances and all.

    Raises as `read_rigs_isolated`, LAYOUT_MISSING, LAYOUT_STALE where it has none of the
    characters, SOURCE_MISSING for a layer that brings in no character at all.
    """
    try:
        check_source(path, settings.read.size_limit)
        return _answer("composed", path, settings, tuple[LayoutsResult, ReadResult])
    except RigUIError as error:
        if (
            error.issue.code == "SKELROOT_MISSING"
            and not read_layouts_isolated(path, settings.read).source
        ):
            raise refuse("SOURCE_MISSING", path, "does not sublayer any asset") from error
        raise


def read_performances_isolated(path: Path, opening: ReadSettings) -> tuple[Performance, ...]:
    """As `usdrigui.reading.clips.read_performances`, in a reader; raises as
    `read_rigs_isolated`."""
    return _asked("clips", path, opening, tuple[Performance, ...])


def read_faults_isolated(path: Path, opening: ReadSettings) -> FaultsResult:
    """As `usdrigui.reader.faults.stage_faults`, in a reader; raises as `read_rigs_isolated` where
    nothing can be read."""
    return _asked("faults", path, opening, FaultsResult)


def read_layer_isolated(path: Path, opening: ReadSettings) -> LayerResult:
    """A layer by itself, in a reader; what it composes need not be there.  Raises as
    `read_rigs_isolated`."""
    return _asked("layer", path, opening, LayerResult)


def read_variants_isolated(path: Path, opening: ReadSettings) -> Mapping[str, tuple[str, ...]]:
    """As `usdrigui.stages.variants.variant_sets`, in a reader; raises as `read_rigs_isolated` and
    VARIANT_UNKNOWN."""
    return _asked("variants", path, opening, dict[str, tuple[str, ...]])


def read_baked_isolated(path: Path, opening: ReadSettings) -> str:
    """As `usdrigui.layer.baking.bake`, as text, in a reader; raises as `read_rigs_isolated`."""
    return _asked("bake", path, opening, str)


def shared_isolated(task: Task, path: Path, opening: ReadSettings, *contents: bytes) -> str:
    """As the function `task` of `usdrigui.layer.shared_animation`, of contents of the file at
    `path`, in a reader; raises FILE_NOT_USD and SOURCE_ codes."""
    texts = tuple(each.decode(errors="surrogateescape") for each in contents)
    return _answer(task, path, Settings(read=opening), str, texts)


def _asked(task: Task, path: Path, opening: ReadSettings, kind: type[Result]) -> Result:
    """The reader's answer about a file that it may be shown, whatever becomes a control."""
    check_source(path, opening.size_limit)
    return _answer(task, path, Settings(read=opening), kind)


def _answer(
    task: Task, path: Path, settings: Settings, kind: type[Result], texts: tuple[str, ...] = ()
) -> Result:
    """What the reader answers, which is of this kind."""
    # It keeps symbolic links, where resolve() would follow them.
    request = Request(task, os.path.abspath(path), settings, texts)  # noqa: PTH100
    response = answered(request, _PROGRAM, Response[kind])  # type: ignore[valid-type]
    if response.refusal is not None:
        raise RigUIError(response.refusal, Exit(response.exit_code), response.others)
    if response.result is None:
        raise answer_invalid(str(path))
    return response.result
