"""What can be asked of a confined reader (`usdrigui.isolation.reading`) about a USD file, and
what it answers; `usdrigui.reader.reader_main` is the reader's side."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from usdrigui.errors import Exit, RigUIError, refuse
from usdrigui.isolation.foreign_file import check_source, check_unchanged
from usdrigui.isolation.reading import answered, begin
from usdrigui.reader.reader_records import (
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


def begin_to_read(path: Path, settings: Settings) -> None:
    """Let a reader begin on what `read_rigs_isolated` is asked next."""
    begin(Request("rigs", os.path.abspath(path), settings), _PROGRAM)  # noqa: PTH100


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


def read_isolated(task: Task, path: Path, opening: ReadSettings, kind: type[Result]) -> Result:
    """What a reader does about a file that it may be shown, whatever becomes a control, which
    gives a `kind`; raises as `read_rigs_isolated`, and what is named in
    `usdrigui.reader.reader_main`."""
    check_source(path, opening.size_limit)
    return _answer(task, path, Settings(read=opening), kind)


def read_layouts_isolated(path: Path, opening: ReadSettings) -> LayoutsResult:
    """As `usdrigui.layer.read_layout.read_layout` and `source_of`, in a reader; raises as
    `read_rigs_isolated`."""
    return read_isolated("layouts", path, opening, LayoutsResult)


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


def read_layer_isolated(path: Path, opening: ReadSettings) -> LayerResult:
    """A layer by itself, in a reader; what it composes need not be there.  Raises as
    `read_rigs_isolated`."""
    return read_isolated("layer", path, opening, LayerResult)


def read_variants_isolated(path: Path, opening: ReadSettings) -> Mapping[str, tuple[str, ...]]:
    """As `usdrigui.stages.variants.variant_sets`, in a reader; raises as `read_rigs_isolated` and
    VARIANT_UNKNOWN."""
    return read_isolated("variants", path, opening, dict[str, tuple[str, ...]])


def shared_isolated(task: Task, path: Path, opening: ReadSettings, *contents: bytes) -> str:
    """As the function `task` of `usdrigui.layer.shared_animation`, of contents of the file at
    `path`, in a reader; raises FILE_NOT_USD and SOURCE_ codes."""
    texts = tuple(each.decode(errors="surrogateescape") for each in contents)
    return _answer(task, path, Settings(read=opening), str, texts)


def _answer(
    task: Task, path: Path, settings: Settings, kind: type[Result], texts: tuple[str, ...] = ()
) -> Result:
    """What the reader answers, which is of this kind."""
    # It keeps symbolic links, where resolve() would follow them.
    request = Request(task, os.path.abspath(path), settings, texts)  # noqa: PTH100
    response = answered(request, _PROGRAM, Response[kind])  # type: ignore[valid-type]
    if response.refusal is not None:
        raise RigUIError(response.refusal, Exit(response.exit_code), response.others)
    assert response.result is not None
    return response.result
