"""What a new file keeps of the one that it replaces: owner, group, access list, mode."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable
from pathlib import Path


def mode_of(place: Path) -> int:
    """Permission bits for the new file: those of the old one, or the default.

    Raises OSError for an old one without permission to write: a rename would succeed all the same,
    over a file that somebody has locked.
    """
    if not place.exists():
        mask = os.umask(0)
        os.umask(mask)
        return 0o666 & ~mask
    if not os.access(place, os.W_OK):
        read_only = hasattr(os, "statvfs") and os.statvfs(place).f_flag & os.ST_RDONLY
        number = errno.EROFS if read_only else errno.EACCES
        raise OSError(number, os.strerror(number), str(place))
    return stat.S_IMODE(place.stat().st_mode)


def keep_attributes(descriptor: int, place: Path, mode: int) -> list[str]:
    """Give a new file the owner, group, extended attributes (access lists among them) and mode of
    the one at `place`.

    Returns the names of what it could not be given.  `security.` attributes are for the
    system to decide.
    """
    lost: list[str] = []
    if place.exists() and hasattr(os, "fchown"):
        old, new = place.stat(), os.fstat(descriptor)
        if new.st_uid != old.st_uid:
            lost += _failed("owner", os.fchown, descriptor, old.st_uid, -1)
        if new.st_gid != old.st_gid:
            lost += _failed("group", os.fchown, descriptor, -1, old.st_gid)
    if place.exists() and hasattr(os, "listxattr"):
        wanted, given = _attributes(place), _attributes(descriptor)
        for name in wanted.keys() | given.keys():
            if name not in wanted:
                lost += _failed(name, os.removexattr, descriptor, name)
            elif wanted[name] != given.get(name):
                lost += _failed(name, os.setxattr, descriptor, name, wanted[name])
    if hasattr(os, "fchmod"):
        os.fchmod(descriptor, mode)
    return sorted(lost)


def _attributes(file: Path | int) -> dict[str, bytes]:
    try:
        return {
            name: os.getxattr(file, name)
            for name in os.listxattr(file)
            if not name.startswith("security.")
        }
    except OSError:  # a file system without any
        return {}


def _failed(name: str, call: Callable[..., None], *arguments: object) -> list[str]:
    try:
        call(*arguments)
    except OSError:
        return [name]
    return []
