"""The door for every file that a run reads: what is let in, what it was, and whether it still is.

No pxr here: this runs in the process that must survive whatever the files hold.
"""

from __future__ import annotations

import errno
import hashlib
import io
import os
import stat
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from usdrigui.errors import refuse

_LFS_POINTER = b"version https://git-lfs"
_ACCESS = os.O_RDONLY
for _name in ("O_NONBLOCK", "O_CLOEXEC", "O_BINARY"):
    _ACCESS |= getattr(os, _name, 0)
_MOST = 16
"""MiB of a file that is read into memory whole: settings, reviews, results of a study, what a batch
remembers."""


@dataclass(frozen=True, slots=True)
class SourceFile:
    """One file that was read."""

    path: str
    """Absolute; never written to any output."""
    size: int
    """Bytes."""
    sha256: str
    """Hex digest."""


def open_regular(path: Path | str) -> io.BufferedReader:
    """A regular file, open for reading.

    Raises OSError, for a folder, pipe, socket or device too: a pipe would keep us waiting, a
    device has no end.
    """
    descriptor = os.open(path, _ACCESS)
    try:
        mode = os.fstat(descriptor).st_mode
        if kind := _kind(mode):
            code = errno.EISDIR if stat.S_ISDIR(mode) else errno.EINVAL
            raise OSError(code, f"is {kind}", str(path))
        return os.fdopen(descriptor, "rb")
    except BaseException:
        os.close(descriptor)
        raise


def whole_content(path: Path | str, most: int = _MOST) -> bytes:
    """What a regular file of at most `most` MiB holds; raises OSError."""
    with open_regular(path) as stream:
        found = stream.read((most << 20) + 1)
    if len(found) > most << 20:
        raise OSError(errno.EFBIG, f"has more than {most} MiB", str(path))
    return found


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
        if kind := _kind(path.stat().st_mode):
            raise refuse("SOURCE_NOT_A_FILE", path, f"is {kind}")
        with open_regular(path) as stream:
            size = os.fstat(stream.fileno()).st_size
            if size > size_limit << 20:
                message = f"has {size >> 20} MiB, more than {size_limit}"
                raise refuse("SOURCE_TOO_LARGE", path, message)
            if stream.read(len(_LFS_POINTER)) == _LFS_POINTER:
                message = "holds the address of the file, not the file"
                raise refuse("SOURCE_LFS_POINTER", path, message)
        return hashed(path)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise refuse("FILE_NOT_FOUND", path, f"cannot be read: {reason}") from error


def hashed(path: Path | str) -> SourceFile:
    """Size and digest of a regular file as it is now; raises OSError."""
    absolute = os.path.realpath(path)
    with open_regular(absolute) as stream:
        digest = hashlib.file_digest(stream, "sha256")
        return SourceFile(absolute, stream.tell(), digest.hexdigest())


def check_unchanged(sources: Iterable[SourceFile]) -> None:
    """Refuse with SOURCE_CHANGED if any of the files differs from what was read; call it before a
    commit."""
    for source in sources:
        if not _same(source):
            raise refuse("SOURCE_CHANGED", source.path, "is not the file that was read")


def _same(source: SourceFile) -> bool:
    try:
        return hashed(source.path) == source
    except OSError:
        return False


def _kind(mode: int) -> str:
    """What a file is that is no regular one; empty for a regular one."""
    if stat.S_ISREG(mode):
        return ""
    kinds = {stat.S_ISDIR: "a folder", stat.S_ISFIFO: "a pipe", stat.S_ISSOCK: "a socket"}
    return next((name for test, name in kinds.items() if test(mode)), "a device")
