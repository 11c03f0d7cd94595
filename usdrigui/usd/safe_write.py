"""Writing a file so that at every moment the old or the new one is there, complete.

A temporary file in the target's folder is written, synced, read back and checked, and then renamed over
the target; the rename is atomic on every file system worth the name, and the folder is synced after it.
Whatever fails, the old file stays byte for byte and no temporary stays behind; those of runs that were
killed are swept by the next run.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import os
import platform
import re
import stat
import time
from collections.abc import Callable
from pathlib import Path
from typing import Literal

from usdrigui.errors import RigUIError, refuse

_DAY = 24 * 3600.0
_CODES = {
    errno.ENOSPC: "FILE_FULL",
    errno.EDQUOT: "FILE_FULL",
    errno.EFBIG: "FILE_FULL",
    errno.EROFS: "FILE_READ_ONLY",
    errno.EACCES: "FILE_PERMISSION",
    errno.EPERM: "FILE_PERMISSION",
    errno.ENOENT: "FILE_TARGET",
    errno.ENOTDIR: "FILE_TARGET",
    errno.EISDIR: "FILE_TARGET",
    errno.ENAMETOOLONG: "FILE_TARGET",
    errno.ELOOP: "FILE_TARGET",
}


def commit(
    content: str | bytes, target: Path, *, verify: Callable[[Path], bool] | None = None
) -> Literal["written", "unchanged"]:
    """Make `target` hold `content` (text as UTF-8), or leave everything as it was.

    `verify` is asked about the temporary file before it takes the target's place, after its bytes have
    been compared; the file has the target's suffix.  A target that is a symbolic link is followed: the
    file that it leads to is replaced, the link stays.  An existing file keeps its permission bits.

    Raises RigUIError with one of the FILE_ codes.
    """
    wanted = content.encode() if isinstance(content, str) else content
    try:
        place = _resolved(target)
        _sweep(place)
        if _holds(place, wanted):
            return "unchanged"
        _replace(place, wanted, target, verify)
    except OSError as error:
        raise file_error(target, error) from error
    return "written"


def file_error(target: Path, error: OSError) -> RigUIError:
    """The refusal that an operating-system error on the way to `target` calls for."""
    reason = error.strerror or type(error).__name__
    return refuse(_CODES.get(error.errno or 0, "FILE_WRITE"), str(target), reason)


def _resolved(target: Path) -> Path:
    """The file to replace: behind all symbolic links, in a folder that exists, and not something else."""
    place = Path(os.path.realpath(target))
    if place.is_symlink():
        raise refuse("FILE_TARGET", str(target), "is a symbolic link that leads to itself")
    if place.exists() and not stat.S_ISREG(place.stat().st_mode):
        raise refuse("FILE_TARGET", str(target), "exists and is not a file")
    if not place.parent.is_dir():
        raise refuse("FILE_TARGET", str(target), f"there is no folder {place.parent}")
    return place


def _holds(place: Path, wanted: bytes) -> bool:
    return place.is_file() and place.stat().st_size == len(wanted) and place.read_bytes() == wanted


def _replace(place: Path, wanted: bytes, target: Path, verify: Callable[[Path], bool] | None) -> None:
    mode = _mode(place)
    temporary = place.with_name(_temporary_name(place, os.getpid()))
    try:
        _write(temporary, wanted, mode)
        if temporary.read_bytes() != wanted or (verify is not None and not _accepted(verify, temporary)):
            raise refuse("FILE_VERIFY", str(target), "the new file does not read back")
        temporary.replace(place)
    except BaseException:
        with contextlib.suppress(OSError):
            temporary.unlink()
        raise
    _sync_folder(place.parent)


def _mode(place: Path) -> int:
    """Permission bits for the new file: those of the old one, which must be writable, or the default."""
    if not place.exists():
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
    if not os.access(place, os.W_OK):
        # A rename would succeed all the same, over a file that somebody has locked.
        number = errno.EROFS if _is_read_only(place) else errno.EACCES
        raise OSError(number, os.strerror(number), str(place))
    return stat.S_IMODE(place.stat().st_mode)


def _is_read_only(place: Path) -> bool:
    """Whether it is the file system, not the file, that forbids writing."""
    return hasattr(os, "statvfs") and bool(os.statvfs(place).f_flag & os.ST_RDONLY)


def _write(path: Path, content: bytes, mode: int) -> None:
    descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_CLOEXEC", 0), 0o600)
    try:
        view = memoryview(content)
        while view:
            view = view[os.write(descriptor, view) :]
        if hasattr(os, "fchmod"):
            os.fchmod(descriptor, mode)
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _accepted(verify: Callable[[Path], bool], path: Path) -> bool:
    """The checker's answer; a checker that raises something of its own does not accept."""
    try:
        return verify(path)
    except (RigUIError, OSError):
        raise
    except Exception:
        return False


def _sync_folder(folder: Path) -> None:
    """Make the rename last; file systems that cannot sync folders have nothing to make last."""
    with contextlib.suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


# --- temporaries -------------------------------------------------------------------------------------


def _temporary_name(place: Path, process: int) -> str:
    """Hidden, with the target's suffix, and telling which process of which machine made it."""
    return f".{place.stem}.{_machine()}.{process}.{os.urandom(6).hex()}.rigui-tmp{place.suffix}"


def _machine() -> str:
    return hashlib.blake2b(platform.node().encode(), digest_size=4).hexdigest()


def _sweep(place: Path) -> None:
    """Remove the temporaries that dead runs left for this target.

    Whether a process of another machine lives cannot be asked, so its temporaries are left for a day.
    """
    stem, suffix = re.escape(place.stem), re.escape(place.suffix)
    own = re.compile(rf"\.{stem}\.([0-9a-f]{{8}})\.(\d+)\.[0-9a-f]{{12}}\.rigui-tmp{suffix}")
    for each in sorted(place.parent.iterdir()):
        match = own.fullmatch(each.name)
        if match:
            with contextlib.suppress(OSError):
                here = match[1] == _machine()
                if not (_alive(int(match[2])) if here else time.time() - each.stat().st_mtime < _DAY):
                    each.unlink()


def _alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except (OSError, OverflowError):
        return True
    return True
