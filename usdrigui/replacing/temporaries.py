"""Hidden files beside a target: each is claimed by a lock that its writer holds for as long as it
needs the file.

A lock ends with its process however that ends, and every process that sees the file sees the lock,
in other containers and, where the file system passes locks on, on other machines.  So whoever can
take the lock of a temporary may remove it, and nobody needs to know who made it.  Only a temporary
that is about to change places with a source may come to hold what somebody else saved: it gets a
name of its own for that, once it is complete (`name_for_exchange`).
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

from usdrigui.isolation.foreign_file import open_regular

if sys.platform != "win32":
    import fcntl

_NAME = re.compile(
    r"\.[0-9a-f]{16}(?:-([0-9a-f]{16})-([0-9a-f]{16}))?\.rigui-(?:tmp|lock)(?:\.\w{1,8})?", re.ASCII
)
"""The two digests are those of the only contents that may be removed (`name_for_exchange`)."""
_SUFFIX = re.compile(r"\.\w{1,8}", re.ASCII)
_OPEN = os.O_RDWR | os.O_CREAT | getattr(os, "O_CLOEXEC", 0)


def create(folder: Path, suffix: str) -> tuple[Path, int]:
    """A new temporary in `folder` and its open descriptor, which holds its lock until it is closed.

    The name is short and keeps only the target's `suffix`, by which USD chooses a reader.  Raises
    OSError.
    """
    ending = f".rigui-tmp{suffix if _SUFFIX.fullmatch(suffix) else ''}"
    while True:
        path = folder / f".{os.urandom(8).hex()}{ending}"
        descriptor = os.open(path, _OPEN | os.O_EXCL, 0o600)
        if _claimed(descriptor, path):
            return path, descriptor
        os.close(descriptor)  # swept between the two lines above


def name_for_exchange(path: Path, old: bytes, new: bytes) -> Path:
    """The name of a temporary while it changes places with a file that held `old` and is to hold
    `new`.

    No sweep removes a file of this name with another content, which is somebody's save.
    """
    random, _, ending = path.name[1:].partition(".")
    return path.with_name(f".{random}-{_digest(old)}-{_digest(new)}.{ending}")


def try_lock(place: Path) -> tuple[Path, int] | None:
    """The lock file of edits of `place` and its open descriptor, which holds it; None while another
    process has it.

    A file of its own beside the edited one: a lock on that would go with it when it is replaced,
    and on some network file systems keep others from reading it.  Raises OSError.
    """
    path = place.with_name(f".{_digest(os.fsencode(place.name))}.rigui-lock")
    descriptor = os.open(path, _OPEN, 0o666)
    if _claimed(descriptor, path):
        return path, descriptor
    os.close(descriptor)
    return None


def remove(path: Path) -> None:
    """Remove a temporary, unless it holds what can be had nowhere else; raises OSError."""
    named = _NAME.fullmatch(path.name)
    if named is not None and (named[1] is None or _digest(_content(path)) in named.groups()):
        path.unlink()


def sweep(folder: Path) -> None:
    """Remove the temporaries that ended runs have left in `folder`: those whose lock can be
    taken."""
    if sys.platform == "win32":
        return
    for path in sorted(folder.iterdir()):
        if _NAME.fullmatch(path.name):
            with contextlib.suppress(OSError), _locked(path) as descriptor:
                if _is_at(descriptor, path):
                    remove(path)


def _claimed(descriptor: int, path: Path) -> bool:
    """Take the lock of a file that `descriptor` has open; False if another process has it or has
    removed the file.

    Where the file system knows no locks the claim is granted: nobody can take the lock to remove
    the file either.
    """
    if sys.platform == "win32":
        return True
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:
        pass
    return _is_at(descriptor, path)


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[int]:
    """The file with its lock held; raises OSError if it is claimed, or cannot be.

    NFS grants a lock for writing only to those who may write.
    """
    access = os.O_RDWR if os.access(path, os.W_OK) else os.O_RDONLY
    descriptor = os.open(path, access | os.O_NOFOLLOW | os.O_NONBLOCK)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield descriptor
    finally:
        os.close(descriptor)


def _is_at(descriptor: int, path: Path) -> bool:
    try:
        return os.path.samestat(os.fstat(descriptor), path.lstat())
    except FileNotFoundError:
        return False


def _content(path: Path) -> bytes:
    with open_regular(path) as stream:
        return stream.read()


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]
