"""Writing files so that at every moment the old or the new one is there, complete.

A temporary file in the target's folder is written, synced, read back and checked, and then renamed
over the target; the rename is atomic on every file system worth the name, and the folder is synced
after it. Whatever fails, the old file stays byte for byte and no temporary stays behind; those of
runs that were killed are swept by the next run (`usdrigui.replacing.temporaries`).
"""

from __future__ import annotations

import contextlib
import errno
import os
import stat
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal, Self

from usdrigui.errors import RigUIError, refuse
from usdrigui.isolation import worker
from usdrigui.isolation.foreign_file import whole_content
from usdrigui.replacing import temporaries
from usdrigui.replacing.attributes import keep_attributes, mode_of

State = Literal["written", "unchanged"]
Verify = Callable[[Path], bool]

_CODES = {
    errno.ENOSPC: "FILE_FULL",
    errno.EDQUOT: "FILE_FULL",
    errno.EFBIG: "FILE_FULL",
    errno.EROFS: "FILE_READ_ONLY",
    errno.EACCES: "FILE_PERMISSION",
    errno.EPERM: "FILE_PERMISSION",
    errno.EEXIST: "FILE_TARGET",
    errno.ENOENT: "FILE_TARGET",
    errno.ENOTDIR: "FILE_TARGET",
    errno.EISDIR: "FILE_TARGET",
    errno.ENAMETOOLONG: "FILE_TARGET",
    errno.ELOOP: "FILE_TARGET",
}


def commit(
    content: str | bytes,
    target: Path,
    *,
    verify: Verify | None = None,
    read: Iterable[Path | str] = (),
) -> State:
    """Make `target` hold `content`, or leave everything as it was: a `Transaction` of one file."""
    with Transaction(read) as files:
        state = files.stage(content, target, verify=verify)
        files.commit()
    return state


class Transaction:
    """The files of one run: all are written and checked beside their targets before the first takes
    its place.

    `read` are the files that the run has read, none of which is ever replaced.  Leaving the block
    without `commit` leaves every target as it was.
    """

    def __init__(self, read: Iterable[Path | str]) -> None:
        self._read = tuple(read)
        self._places: set[Path] = set()
        self._staged: list[Staged] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *exc: object) -> None:
        for staged in self._staged:
            staged.discard()

    def stage(self, content: str | bytes, target: Path, *, verify: Verify | None = None) -> State:
        """Prepare `target` to hold `content` (text as UTF-8); ``unchanged`` if it does already.

        `verify` is asked about the temporary file, which has the target's suffix, after its bytes
        have been compared. A target that is a symbolic link is followed: the file that it leads to
        is replaced, the link stays.  An existing file keeps its permission bits, and owner and
        access list where the process may give them.

        Raises RigUIError with one of the FILE_ codes.
        """
        wanted = content.encode() if isinstance(content, str) else content
        try:
            check_not_read([target], self._read)
            place = _resolved(target)
            if place in self._places:
                raise refuse(
                    "FILE_TARGET", target, f"is {place.name}, which this run writes already"
                )
            self._places.add(place)
            temporaries.sweep(place.parent)
            held = place.is_file() and place.stat().st_size == len(wanted)
            if held and place.read_bytes() == wanted:
                return "unchanged"
            staged = Staged.beside(place, target)
            try:
                staged.fill(wanted, verify)
            except BaseException:
                staged.discard()
                raise
            self._staged.append(staged)
        except OSError as error:
            raise file_error(target, error) from error
        return "written"

    def commit(self) -> None:
        """Let the files take their places, the first staged last, so that a kill leaves it with
        what it describes.

        Raises RigUIError with one of the FILE_ codes; then the files that had theirs already have
        given them back.
        """
        targets = [str(staged.target) for staged in self._staged]
        with worker.committing(targets), contextlib.ExitStack() as placed:
            for staged in reversed(self._staged):
                placed.enter_context(_placed(staged, undo=len(self._staged) > 1))
        for folder in dict.fromkeys(staged.place.parent for staged in self._staged):
            sync_folder(folder)


@dataclass(frozen=True, slots=True)
class Staged:
    """A file beside the one that it is to replace, under the name of a temporary."""

    path: Path
    descriptor: int
    """Holds the lock of `path`."""
    place: Path
    """What is replaced, behind all links."""
    target: Path
    """As it was asked for."""

    @classmethod
    def beside(cls, place: Path, target: Path) -> Staged:
        """An empty one, to be discarded whatever comes; raises OSError."""
        return cls(*temporaries.create(place.parent, place.suffix), place, target)

    def fill(self, wanted: bytes, verify: Verify | None) -> list[str]:
        """Write it, check it, and make it last; returns the attributes of the old file that it
        could not be given.

        Raises OSError and FILE_VERIFY.
        """
        mode, rest = mode_of(self.place), memoryview(wanted)
        while rest:
            rest = rest[os.write(self.descriptor, rest) :]
        lost = keep_attributes(self.descriptor, self.place, mode)
        os.fsync(self.descriptor)
        if self.path.read_bytes() != wanted or not _accepted(verify, self.path):
            raise refuse("FILE_VERIFY", self.target, "the new file does not read back")
        return lost

    def discard(self) -> None:
        """Remove the file, unless it has taken its place."""
        with contextlib.suppress(OSError):
            temporaries.remove(self.path)
        with contextlib.suppress(OSError):
            os.close(self.descriptor)


def check_not_read(targets: Iterable[Path], read: Iterable[Path | str]) -> None:
    """Refuse an output that is, by whatever name or link, a file that the run reads; raises
    FILE_TARGET."""
    known = {key: path for path in read for key in _identities(path)}
    for target in targets:
        for key in known.keys() & _identities(target):
            raise refuse(
                "FILE_TARGET",
                target,
                f"is {known[key]}, which this run reads and never replaces",
            )


def check_own(target: Path, what: str, mark: str) -> None:
    """Refuse an output that is not named as USD text, or holds something else than `what` it is to
    hold, which has the `mark`; raises FILE_TARGET and OSError."""
    if target.suffix != ".usda":
        raise refuse("FILE_TARGET", target, f"{what} is USD text and ends in .usda")
    held = whole_content(target, 256) if target.exists() else b""
    if held and mark.encode() not in held:
        raise refuse("FILE_TARGET", target, f"exists and is not {what}")


def same_file(first: Path | str, second: Path | str) -> bool:
    """Whether two names lead to one file, through links, hard links and other cases too; neither
    need exist."""
    return not _identities(first).isdisjoint(_identities(second))


def _identities(path: Path | str) -> set[object]:
    """What a file has in common with its other names: the place behind all links and, if it exists,
    its inode."""
    place = os.path.realpath(path)
    try:
        status = os.stat(place)  # noqa: PTH116 (names may hold bytes that are not text)
    except (OSError, ValueError):
        return {place}
    return {place, (status.st_dev, status.st_ino)}


def file_error(target: Path, error: OSError) -> RigUIError:
    """The refusal that an operating-system error on the way to `target` calls for."""
    reason = error.strerror or type(error).__name__
    return refuse(_CODES.get(error.errno or 0, "FILE_WRITE"), target, reason)


def sync_folder(folder: Path) -> None:
    """Make the rename last; file systems that cannot sync folders have nothing to make last."""
    with contextlib.suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


# --- one file -------------------------------------------------------------------------------------


def _resolved(target: Path) -> Path:
    """The file to replace: behind all symbolic links, in a folder that is made if there is none,
    and not something else."""
    place = Path(os.path.realpath(target))
    if place.is_symlink():
        raise refuse("FILE_TARGET", target, "is a symbolic link that leads to itself")
    if place.exists() and not stat.S_ISREG(place.stat().st_mode):
        raise refuse("FILE_TARGET", target, "exists and is not a file")
    place.parent.mkdir(parents=True, exist_ok=True)
    return place


def _accepted(verify: Verify | None, path: Path) -> bool:
    """The checker's answer; a checker that raises something of its own does not accept."""
    try:
        return verify is None or verify(path)
    except (RigUIError, OSError):
        raise
    except Exception:
        return False


@contextlib.contextmanager
def _placed(staged: Staged, *, undo: bool) -> Iterator[None]:
    """The file in its target's place; with `undo` the old one, or none, is there again if the block
    fails."""
    existed = staged.place.exists()
    old = _second_name(staged.place) if undo and existed else None
    try:
        try:
            staged.path.replace(staged.place)
        except OSError as error:
            raise file_error(staged.target, error) from error
        yield
    except BaseException:
        with contextlib.suppress(OSError):
            if old is not None:
                old.replace(staged.place)
            elif undo and not existed:
                staged.place.unlink()
        raise
    finally:
        if old is not None:
            with contextlib.suppress(OSError):
                old.unlink()


def _second_name(place: Path) -> Path | None:
    """Another name of a file, under which it outlives its replacement; none where the file system
    has but one."""
    second = place.with_name(f".{os.urandom(8).hex()}.rigui-tmp")
    try:
        os.link(place, second)
    except OSError:
        return None
    return second
