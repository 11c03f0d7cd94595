"""Hidden files beside a target: each is claimed by a lock that its writer holds for as long as it
needs the file.

A lock ends with its process however that ends, and every process that sees the file sees the lock,
in other containers and, where the file system passes locks on, on other machines.  So whoever can
take the lock of a temporary may remove it, and nobody needs to know who made it.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path

if sys.platform != "win32":
    import fcntl

_NAME = re.compile(
    r"\.[0-9a-f]{16}(?:-([0-9a-f]{16})-([0-9a-f]{16}))?\.rigui-(?:tmp|lock)(?:\.\w{1,8})?", re.ASCII
)
"""The two digests are those of the only contents that may be removed (`swap_name`)."""
_SUFFIX = re.compile(r"\.\w{1,8}", re.ASCII)


def create(folder: Path, suffix: str, digests: str = "") -> tuple[Path, int]:
    """A new temporary in `folder` and its open descriptor, which holds its lock until it is closed.

    The name is short and keeps only the target's `suffix`, by which USD chooses a
    reader.  `digests` is empty or a `swap_name`.  Raises OSError.
    """
    ending = f".rigui-tmp{suffix if _SUFFIX.fullmatch(suffix) else ''}"
    while True:
        path = folder / f".{os.urandom(8).hex()}{digests}{ending}"
        descriptor = os.open(
            path, os.O_RDWR | os.O_CREAT | os.O_EXCL | getattr(os, "O_CLOEXEC", 0), 0o600
        )
        if claim(descriptor, path):
            return path, descriptor
        os.close(descriptor)  # swept between the two lines above


def swap_name(*contents: bytes) -> str:
    """The part of a name for the contents of a temporary that exist elsewhere: the old and
    the new one."""
    return "".join(f"-{_digest(each)}" for each in contents)


def claim(descriptor: int, path: Path) -> bool:
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


def try_lock(place: Path) -> tuple[Path, int] | None:
    """The lock file of edits of `place` and its open descriptor, which holds it; None while another
    process has it.

    A file of its own beside the edited one: a lock on that would go with it when it is replaced,
    and on some network file systems keep others from reading it.  Raises OSError.
    """
    path = place.with_name(f".{_digest(os.fsencode(place.name))}.rigui-lock")
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_CLOEXEC", 0), 0o666)
    if claim(descriptor, path):
        return path, descriptor
    os.close(descriptor)
    return None


def remove(path: Path) -> None:
    """Remove a temporary, unless it holds what can be had nowhere else; raises OSError."""
    named = _NAME.fullmatch(path.name)
    if named is not None and _is_elsewhere(path, named):
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


@contextlib.contextmanager
def _locked(path: Path) -> Iterator[int]:
    """The file with its lock held; raises OSError if it is claimed, or cannot be."""
    descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise
        except OSError:  # NFS grants a lock for writing only to those who may write
            os.close(descriptor)
            descriptor = os.open(path, os.O_RDWR | os.O_NOFOLLOW | os.O_NONBLOCK)
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield descriptor
    finally:
        os.close(descriptor)


def _is_at(descriptor: int, path: Path) -> bool:
    try:
        return os.path.samestat(os.fstat(descriptor), path.lstat())
    except FileNotFoundError:
        return False


def _is_elsewhere(path: Path, named: re.Match[str]) -> bool:
    """Whether nothing is lost with this temporary: one that was swapped with a file may hold
    somebody's save."""
    return named[1] is None or _digest(path.read_bytes()) in named.groups()


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:16]
