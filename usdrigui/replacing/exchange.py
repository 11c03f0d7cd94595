"""Replacing a source file with its edited content, if it still is the file that was read, and only
then.

Edits by usdrigui wait for each other (`editing`).  Other programs know nothing of our locks, so the
file that is replaced is looked at after the fact: where the system can let two files change places
in one step, what comes out is compared with what was read, and goes back if it is something else
(`replace_source`; decision 090).
"""

from __future__ import annotations

import contextlib
import ctypes
import errno
import functools
import hashlib
import os
import signal
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from usdrigui.errors import refuse
from usdrigui.isolation import worker
from usdrigui.isolation.foreign_file import SourceFile, check_unchanged, open_regular
from usdrigui.replacing import temporaries
from usdrigui.replacing.transaction import Staged, Verify, file_error, sync_folder

_PAUSE = 0.05
"""Seconds between two attempts to take the lock."""
_RENAME_EXCHANGE = 2
_AT_FDCWD = -100


@contextlib.contextmanager
def editing(asset: Path, seconds: float) -> Iterator[None]:
    """Hold the lock against other edits of `asset` by usdrigui.

    Raises ATTACH_BUSY when another one has it for more than `seconds`, and the FILE_ codes of
    writing.
    """
    path, descriptor = _lock(asset, time.monotonic() + seconds)
    try:
        yield
    finally:
        with contextlib.suppress(OSError):
            path.unlink()
        os.close(descriptor)


@dataclass(frozen=True, slots=True)
class Original:
    """A source as it was read."""

    file: SourceFile
    content: bytes

    @classmethod
    def of(cls, file: SourceFile) -> Original:
        """With the content that it must still have; raises SOURCE_CHANGED and OSError."""
        with open_regular(file.path) as stream:
            content = stream.read(file.size + 1)
        _check_content(content, file)
        return cls(file, content)


def replace_source(asset: Path, original: Original, content: bytes, verify: Verify) -> None:
    """Let `content` take the place of `asset`, which must still be `original`.

    At every moment one of the two, or a save that came meanwhile, is there complete.  Owner,
    group, mode, access list and other attributes are kept.  Raises SOURCE_CHANGED, ATTACH_BUSY (a
    program has the file open for writing), ATTACH_HARD_LINK, ATTACH_ATTRIBUTES and the FILE_ codes;
    then the asset is as it was, or as somebody saved it.
    """
    place = Path(original.file.path)
    try:
        names = place.stat().st_nlink
        if names > 1:
            raise refuse("ATTACH_HARD_LINK", asset, f"is one of {names} names of its file")
        temporaries.sweep(place.parent)
        staged = Staged.beside(place, asset)
        try:
            if lost := staged.fill(content, verify):
                message = f"the new file cannot have the same {', '.join(lost)}"
                raise refuse("ATTACH_ATTRIBUTES", asset, message)
            staged = _ready(staged, original.content, content)
            check_unchanged([original.file])
            _check_no_writer(place, asset)
            with worker.committing([str(asset)]):
                _take_place(staged, original.file)
        finally:
            staged.discard()
        sync_folder(place.parent)
    except OSError as error:
        raise file_error(asset, error) from error


def _lock(asset: Path, deadline: float) -> tuple[Path, int]:
    try:
        while (lock := temporaries.try_lock(Path(os.path.realpath(asset)))) is None:
            if time.monotonic() > deadline:
                raise refuse("ATTACH_BUSY", asset, "another attach or detach is editing it")
            time.sleep(_PAUSE)
        return lock
    except OSError as error:
        raise file_error(asset, error) from error


# --- the exchange ---------------------------------------------------------------------------------


def _ready(staged: Staged, old: bytes, new: bytes) -> Staged:
    """The new file, complete, under the name that it has while the two change places."""
    path = temporaries.name_for_exchange(staged.path, old, new)
    return replace(staged, path=staged.path.rename(path))


def _take_place(staged: Staged, before: SourceFile) -> None:
    """Swap the new file with the one that it replaces, and swap back unless that is the one that
    was read."""
    accepted = False
    try:
        if not _exchange(staged.path, staged.place):
            check_unchanged([before])
            staged.path.replace(staged.place)
            accepted = True
            return
        _check_content(staged.path.read_bytes(), before)
        _check_no_writer(staged.path, staged.target)
        accepted = True
    finally:
        if not accepted and _is_file(staged.place, os.fstat(staged.descriptor)):
            _put_back(staged)


def _put_back(staged: Staged) -> None:
    """Let the file that came out have its place again, or the last one that was saved over ours
    meanwhile."""
    expected = os.fstat(staged.descriptor)
    while True:
        returned = staged.path.stat()
        _exchange(staged.path, staged.place)
        if _is_file(staged.path, expected):
            staged.path.unlink()  # ours, or a save that a later one has replaced
            return
        expected = (
            returned  # something newer came out than what we had put there: it goes back in turn
        )


def _is_file(path: Path, known: os.stat_result) -> bool:
    with contextlib.suppress(FileNotFoundError):
        return os.path.samestat(path.stat(), known)
    return False


def _exchange(first: Path, second: Path) -> bool:
    """Let two files change places in one step; False where the system or the file system cannot.
    Raises OSError."""
    call = _renameat2()
    if call is None:
        return False
    if call(_AT_FDCWD, os.fsencode(first), _AT_FDCWD, os.fsencode(second), _RENAME_EXCHANGE) == 0:
        return True
    number = ctypes.get_errno()
    if number in (errno.ENOSYS, errno.EINVAL, errno.ENOTSUP):
        return False
    raise OSError(number, os.strerror(number), str(second))


@functools.cache
def _renameat2() -> Callable[..., int] | None:
    if sys.platform != "linux":
        return None
    try:
        call = ctypes.CDLL(None, use_errno=True).renameat2
    except (OSError, AttributeError):
        return None
    call.argtypes = (ctypes.c_int, ctypes.c_char_p, ctypes.c_int, ctypes.c_char_p, ctypes.c_uint)
    call.restype = ctypes.c_int
    return call


def _check_content(content: bytes, file: SourceFile) -> None:
    """Refuse with SOURCE_CHANGED content that is not that of the file that was read."""
    if hashlib.sha256(content).hexdigest() != file.sha256:
        raise refuse("SOURCE_CHANGED", file.path, "is not the file that was read")


# --- writers --------------------------------------------------------------------------------------


def _check_no_writer(path: Path, asset: Path) -> None:
    """Refuse a file that a program has open for writing: what it writes after our look at it would
    be lost.

    The system answers by granting a lease or not.  Where leases mean nothing (some network file
    systems) that is unknown.
    """
    if sys.platform != "linux" or _lease_error(path) != errno.EAGAIN:
        return
    sample, descriptor = temporaries.create(path.parent, "")
    os.close(descriptor)
    try:
        if _lease_error(sample) == 0:
            raise refuse("ATTACH_BUSY", asset, "another program has it open for writing")
    finally:
        sample.unlink(missing_ok=True)


def _lease_error(path: Path) -> int:
    """The error number with which a lease for reading is refused; 0 if it is granted."""
    import fcntl

    descriptor = os.open(path, os.O_RDONLY)
    try:
        # A program that opens the file now waits for us, and the system reports it by a signal:
        # SIGIO would end us.
        fcntl.fcntl(descriptor, fcntl.F_SETSIG, signal.SIGURG)
        fcntl.fcntl(descriptor, fcntl.F_SETLEASE, fcntl.F_RDLCK)
        fcntl.fcntl(descriptor, fcntl.F_SETLEASE, fcntl.F_UNLCK)
    except OSError as error:
        return error.errno or errno.EIO
    finally:
        os.close(descriptor)
    return 0
