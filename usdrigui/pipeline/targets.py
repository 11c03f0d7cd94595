"""Where output goes: its name, its folder, and what it may replace."""

from __future__ import annotations

import errno
import os
from collections.abc import Iterable
from pathlib import Path

from usdrigui.errors import RigUIError, refuse
from usdrigui.reader.reader_process import read_layer_isolated
from usdrigui.replacing.transaction import (
    State,
    Transaction,
    check_not_read,
    commit,
    file_error,
    same_file,
)
from usdrigui.settings import ReadSettings

_LAYER_SUFFIXES = (".usd", ".usda", ".usdc")
_USD_SUFFIXES = (*_LAYER_SUFFIXES, ".usdz")


def default_output(asset: Path) -> Path:
    """``char.usda`` → ``char.rigui.usda``, beside it.  Raises SOURCE_NOT_A_FILE for a folder
    without a name."""
    if not asset.name:
        raise refuse("SOURCE_NOT_A_FILE", asset, "is a folder")
    return asset.with_name(asset.stem + ".rigui.usda")


def write_file(content: bytes, target: Path, read: Iterable[Path | str]) -> State:
    """Write a report, picture or page all or nothing; `read` are the files that the run has read.

    Raises FILE_TARGET for one of those and for a USD file, so that no slip of the hand replaces a
    character.
    """
    check_outputs([target])
    return commit(content, target, read=read)


def stage_file(files: Transaction, content: bytes, target: Path) -> State:
    """Stage a report, picture or page among the files of a run; raises as `write_file`."""
    check_outputs([target])
    return files.stage(content, target)


def check_outputs(targets: Iterable[Path | None], read: Iterable[Path | str] = ()) -> None:
    """Refuse outputs that are USD files, or files that the run reads, by whatever name; raises
    FILE_TARGET."""
    given = [each for each in targets if each is not None]
    for target in given:
        if {target.suffix.lower(), Path(os.path.realpath(target)).suffix.lower()} & {
            *_USD_SUFFIXES
        }:
            raise refuse("FILE_TARGET", target, "output is not USD; use another file extension")
    check_not_read(given, read)


def check_target(asset: Path, target: Path) -> None:
    """Refuse to write over the asset, and to a file that is not named as a layer; raises
    FILE_TARGET."""
    if same_file(target, asset):
        raise refuse("FILE_TARGET", target, "is the source itself, which is never written")
    if target.suffix not in _LAYER_SUFFIXES:
        raise refuse("FILE_TARGET", target, "a layout layer ends in .usda, .usdc or .usd")


def check_replaceable(target: Path, opening: ReadSettings, asset: Path | None) -> None:
    """A file at the target must be a layout layer of ours: no other work is replaced by a
    slip of the hand.

    An asset with its layout attached, a shot over one and a layer of corrections hold work that
    cannot be made again. With `asset`, whose default name the target is, it must not be the layout
    of another file either: ``char.usdc`` and ``char.usda`` share that name.  A layout whose source
    is gone may be replaced.  Raises FILE_TARGET.
    """
    if not target.is_file() or not target.stat().st_size or not os.access(target, os.W_OK):
        return  # writing will refuse what may not be written
    try:
        existing = read_layer_isolated(target, opening)
    except RigUIError as error:
        raise refuse(
            "FILE_TARGET", target, f"exists and cannot be read as a layout layer: {error}"
        ) from error
    if not existing.ours:
        raise refuse("FILE_TARGET", target, "exists and is not a layout layer that process wrote")
    if asset is None or not existing.sublayers:
        return
    source = target.parent / existing.sublayers[0]
    if source.is_file() and not source.samefile(asset):
        raise refuse("FILE_TARGET", target, f"is the layout of {source.name}, not of {asset.name}")


def check_place(target: Path) -> None:
    """Refuse what could not be written, for a run that writes it last, or not at all; raises
    RigUIError with a FILE_ code."""
    try:
        if target.exists() and not target.is_file():
            raise IsADirectoryError(errno.EISDIR, "exists and is not a file")
        folder = next(each for each in target.absolute().parents if os.path.lexists(each))
        if not folder.is_dir():
            raise NotADirectoryError(errno.ENOTDIR, f"{folder} is no folder")
        if not os.access(target if target.exists() else folder, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    except OSError as error:
        raise file_error(target, error) from error
