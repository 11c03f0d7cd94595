"""The files that a run reads: what is let in, what they were, and whether they still are.

No pxr here: this runs in the process that must survive whatever the files hold.
"""

from __future__ import annotations

import errno
import hashlib
import os
import stat
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from usdrigui.errors import refuse

_LFS_POINTER = b"version https://git-lfs"


@dataclass(frozen=True, slots=True)
class SourceFile:
    """One file that was read."""

    path: str
    """Absolute; never written to any output."""
    size: int
    """Bytes."""
    sha256: str
    """Hex digest."""


def check_source(path: Path, size_limit: int) -> SourceFile:
    """Look at a file before USD does, and remember its content.

    `size_limit` in MiB.  Raises RigUIError FILE_NOT_FOUND, FILE_NAME (not UTF-8), SOURCE_NOT_A_FILE
    (a folder, pipe, socket or device), SOURCE_TOO_LARGE or SOURCE_LFS_POINTER.
    """
    try:
        str(path.absolute()).encode()  # USD resolves it against the working directory.
    except UnicodeEncodeError:
        raise refuse("FILE_NAME", ascii(str(path.absolute())), "the name is not UTF-8") from None
    try:
        found = path.stat()
        if not stat.S_ISREG(found.st_mode):
            raise refuse("SOURCE_NOT_A_FILE", str(path), f"is {_kind(found.st_mode)}")
        if found.st_size > size_limit << 20:
            raise refuse(
                "SOURCE_TOO_LARGE",
                str(path),
                f"has {found.st_size >> 20} MiB, more than {size_limit}",
            )
        with path.open("rb") as stream:
            pointer = stream.read(len(_LFS_POINTER)) == _LFS_POINTER
        if pointer:
            raise refuse(
                "SOURCE_LFS_POINTER", str(path), "holds the address of the file, not the file"
            )
        return hashed(path)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise refuse("FILE_NOT_FOUND", str(path), f"cannot be read: {reason}") from error


def hashed(path: Path | str) -> SourceFile:
    """Size and digest of a regular file as it is now; raises OSError."""
    absolute = os.path.realpath(path)
    # A pipe would keep us waiting, a device has no end.
    if not stat.S_ISREG(os.stat(absolute).st_mode):  # noqa: PTH116
        raise OSError(errno.EINVAL, "is not a regular file", absolute)
    # Paths here may hold bytes that are not text.
    with open(absolute, "rb") as stream:  # noqa: PTH123
        digest = hashlib.file_digest(stream, "sha256")
        return SourceFile(absolute, stream.tell(), digest.hexdigest())


def check_unchanged(sources: Iterable[SourceFile]) -> None:
    """Refuse with SOURCE_CHANGED if any of the files differs from what was read; call it before a
    commit."""
    for each in sources:
        if not _same(each):
            raise refuse("SOURCE_CHANGED", each.path, "is not the file that was read")


def _same(source: SourceFile) -> bool:
    try:
        return hashed(source.path) == source
    except OSError:
        return False


def _kind(mode: int) -> str:
    kinds = {stat.S_ISDIR: "a folder", stat.S_ISFIFO: "a pipe", stat.S_ISSOCK: "a socket"}
    return next((name for test, name in kinds.items() if test(mode)), "a device")
