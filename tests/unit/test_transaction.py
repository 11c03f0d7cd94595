"""usdrigui.replacing.transaction: whatever fails, the old or the new file is there, complete, and nothing else."""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import stat
import threading
from pathlib import Path

import pytest
from commands import contents
from programs import ran

from usdrigui.errors import Exit, RigUIError, refuse
from usdrigui.replacing import temporaries
from usdrigui.replacing.transaction import Transaction, commit

OLD = b"the old layer\n" * 1000
NEW = b"the new layer\n" * 2000


@pytest.fixture
def target(tmp_path):
    path = tmp_path / "char.rigui.usda"
    path.write_bytes(OLD)
    return path


def only_file(target: Path) -> bool:
    return [each.name for each in target.parent.iterdir()] == [target.name]


def test_new_file_is_written_and_same_content_left_alone(tmp_path):
    target = tmp_path / "a.json"
    assert commit("{}\n", target) == "written"
    before = target.stat()
    assert commit(b"{}\n", target) == "unchanged"
    assert (target.stat().st_mtime_ns, target.stat().st_ino) == (before.st_mtime_ns, before.st_ino)
    assert commit("ü", target) == "written"
    assert target.read_bytes() == "ü".encode()
    assert only_file(target)


def test_empty_file_and_file_of_same_size_are_told_apart(tmp_path):
    target = tmp_path / "a.png"
    assert commit(b"", target) == "written"
    assert commit(b"", target) == "unchanged"
    target.write_bytes(b"abc")
    assert commit(b"abd", target) == "written"


def test_the_temporary_is_synced_before_the_rename_and_the_folder_after(target, monkeypatch):
    events = []
    fsync, replace = os.fsync, Path.replace

    def seen_fsync(descriptor):
        events.append("folder" if stat.S_ISDIR(os.fstat(descriptor).st_mode) else "file")
        fsync(descriptor)

    def seen_replace(path, other):
        events.append("rename")
        return replace(path, other)

    monkeypatch.setattr(os, "fsync", seen_fsync)
    monkeypatch.setattr(Path, "replace", seen_replace)
    commit(NEW, target)
    assert events == ["file", "rename", "folder"]


@pytest.mark.parametrize(
    ("number", "code"),
    [
        (errno.ENOSPC, "FILE_FULL"),
        (errno.EDQUOT, "FILE_FULL"),
        (errno.EIO, "FILE_WRITE"),
        (errno.EROFS, "FILE_READ_ONLY"),
        (errno.EACCES, "FILE_PERMISSION"),
    ],
)
@pytest.mark.parametrize("step", ["open", "write", "second write", "fsync", "replace"])
def test_a_failure_at_any_step_leaves_the_old_file(target, monkeypatch, step, number, code):
    def fail(*_arguments, **_named):
        raise OSError(number, os.strerror(number))

    if step == "second write":
        write, calls = os.write, []

        def some(descriptor, view):
            if calls:
                fail()
            calls.append(1)
            return write(descriptor, view[:100])

        monkeypatch.setattr(os, "write", some)
    elif step == "replace":
        monkeypatch.setattr(Path, "replace", fail)
    else:
        real = getattr(os, step)

        def failing(first, *rest, **named):
            if step == "open" and "rigui-tmp" not in str(first):
                return real(first, *rest, **named)
            return fail()

        monkeypatch.setattr(os, step, failing)
    with pytest.raises(RigUIError) as caught:
        commit(NEW, target)
    monkeypatch.undo()
    assert caught.value.issue.code == code
    assert caught.value.exit_code is Exit.FILE
    assert str(target) in caught.value.issue.path
    assert target.read_bytes() == OLD
    assert only_file(target)


@pytest.mark.parametrize("number", [errno.EIO, errno.EINVAL])
def test_a_folder_that_cannot_be_synced_has_the_new_file_complete(target, monkeypatch, number):
    """It stands there already; how long it outlives a power cut is the file system's affair."""
    fsync = os.fsync

    def failing(descriptor):
        if stat.S_ISDIR(os.fstat(descriptor).st_mode):
            raise OSError(number, os.strerror(number))
        fsync(descriptor)

    monkeypatch.setattr(os, "fsync", failing)
    assert commit(NEW, target) == "written"
    assert target.read_bytes() == NEW
    assert only_file(target)


def test_a_real_size_limit_leaves_the_old_file(target):
    """The kernel itself refuses to let the file grow."""
    script = f"""
import resource, signal
from pathlib import Path
from usdrigui.errors import RigUIError
from usdrigui.replacing.transaction import commit
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))
try:
    commit(b"x" * 50000, Path({str(target)!r}))
except RigUIError as error:
    print(error.issue.code)
"""
    done = ran("-c", script)
    assert done.stdout.strip() == "FILE_FULL"
    assert target.read_bytes() == OLD
    assert only_file(target)


def test_what_does_not_read_back_never_takes_the_place(target, monkeypatch):
    seen = []

    def picky(path: Path) -> bool:
        seen.append((path.suffix, path.read_bytes() == NEW, path.parent == target.parent))
        return False

    def broken(_path: Path) -> bool:
        raise ValueError("cannot parse")

    for check in (picky, broken):
        with pytest.raises(RigUIError, match="FILE_VERIFY"):
            commit(NEW, target, verify=check)
    assert seen == [(".usda", True, True)]
    monkeypatch.setattr(Path, "read_bytes", lambda _path: b"something else")
    with pytest.raises(RigUIError, match="FILE_VERIFY"):
        commit(NEW, target)
    monkeypatch.undo()
    assert target.read_bytes() == OLD
    assert only_file(target)


def test_a_checker_may_refuse_with_a_code_of_its_own(target):
    def check(path: Path) -> bool:
        raise refuse("LAYOUT_MISSING", str(path), "none")

    with pytest.raises(RigUIError, match="LAYOUT_MISSING"):
        commit(NEW, target, verify=check)
    assert only_file(target)


@pytest.mark.parametrize(
    ("make", "code"),
    [
        (lambda folder: folder, "FILE_TARGET"),
        (lambda folder: folder / ("x" * 300), "FILE_TARGET"),
        (lambda folder: _loop(folder / "loop"), "FILE_TARGET"),
        (lambda folder: _fifo(folder / "fifo"), "FILE_TARGET"),
        (lambda folder: _under_file(folder), "FILE_TARGET"),
    ],
)
def test_targets_that_cannot_be_files(tmp_path, make, code):
    target = make(tmp_path)
    before = sorted(each.name for each in tmp_path.iterdir())
    with pytest.raises(RigUIError, match=code):
        commit(NEW, target)
    assert sorted(each.name for each in tmp_path.iterdir()) == before


def _loop(path: Path) -> Path:
    path.symlink_to(path)
    return path


def _fifo(path: Path) -> Path:
    os.mkfifo(path)
    return path


def _under_file(folder: Path) -> Path:
    (folder / "plain").write_text("")
    return folder / "plain" / "a.usda"


def test_a_link_is_followed_and_stays(tmp_path):
    shelf = tmp_path / "shelf"
    shelf.mkdir()
    real, link = shelf / "real.usda", tmp_path / "link.usda"
    real.write_bytes(OLD)
    link.symlink_to(real)
    assert commit(NEW, link) == "written"
    assert link.is_symlink()
    assert real.read_bytes() == NEW
    assert only_file(real)
    dangling = tmp_path / "dangling.usda"
    dangling.symlink_to(shelf / "new.usda")
    assert commit(NEW, dangling) == "written"
    assert (shelf / "new.usda").read_bytes() == NEW
    assert dangling.is_symlink()


def test_permission_bits_are_kept_and_new_files_follow_the_mask(tmp_path):
    target = tmp_path / "a.usda"
    mask = os.umask(0o027)
    try:
        commit(OLD, target)
    finally:
        os.umask(mask)
    assert target.stat().st_mode & 0o777 == 0o640
    target.chmod(0o664)
    commit(NEW, target)
    assert target.stat().st_mode & 0o777 == 0o664


def test_a_file_locked_against_writing_stays(target, monkeypatch):
    """As an ordinary user sees it; a test may run as root, for whom nothing is locked."""
    monkeypatch.setattr(os, "access", lambda path, _mode: Path(path) != target)
    with pytest.raises(RigUIError, match="FILE_PERMISSION"):
        commit(NEW, target)
    assert target.read_bytes() == OLD


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_without_permission(tmp_path):
    folder = tmp_path / "locked"
    folder.mkdir(mode=0o500)
    with pytest.raises(RigUIError, match="FILE_PERMISSION"):
        commit(NEW, folder / "a.usda")


def test_temporaries_are_swept_unless_their_lock_is_held(target):
    """Who made them does not matter: two machines of one name, or two containers, share a folder."""
    left, dropped = temporaries.create(target.parent, ".usda")
    held, descriptor = temporaries.create(target.parent, ".usda")
    os.close(dropped)
    foreign = target.with_name(".char.rigui-tmp.usda")
    foreign.write_bytes(b"not one of ours")
    commit(NEW, target)
    assert {each.name for each in target.parent.iterdir()} == {target.name, held.name, foreign.name}
    os.close(descriptor)
    commit(OLD, target)
    assert {each.name for each in target.parent.iterdir()} == {target.name, foreign.name}
    assert not left.exists()


def test_a_temporary_is_claimed_for_as_long_as_it_is_checked(target):
    """Another writer comes at the worst moment: between the write and the rename."""

    def meanwhile(path: Path) -> bool:
        commit(OLD + OLD, target)
        return path.read_bytes() == NEW

    assert commit(NEW, target, verify=meanwhile) == "written"
    assert target.read_bytes() == NEW
    assert only_file(target)


def test_a_temporary_that_is_swept_before_it_is_claimed_is_made_again(target, monkeypatch):
    claim, seen = temporaries._claimed, []

    def late(descriptor, path):
        seen.append(path)
        if len(seen) == 1:
            temporaries.sweep(path.parent)
        return claim(descriptor, path)

    monkeypatch.setattr(temporaries, "_claimed", late)
    assert commit(NEW, target) == "written"
    assert len(seen) == 2
    assert target.read_bytes() == NEW
    assert only_file(target)


@pytest.mark.parametrize("stem", ["x" * 250, "ü" * 125])
def test_names_as_long_as_the_file_system_allows(tmp_path, stem):
    target = tmp_path / f"{stem}.usda"
    assert commit(NEW, target) == "written"
    assert only_file(target)


# --- several files -----------------------------------------------------------------------------------


@pytest.mark.parametrize("failing", [0, 1, 2, "stage", "block", None])
def test_files_of_one_run_are_replaced_together_or_not_at_all(tmp_path, monkeypatch, failing):
    """The second is new, the others are there already; `failing` is the rename that fails."""
    names = ["char.rigui.usda", "report.json", "preview.png"]
    targets = [tmp_path / name for name in names]
    for each in targets[::2]:
        each.write_bytes(OLD)
    before = contents(tmp_path)
    replace, order = Path.replace, []

    def seen(path, other):
        if other.name in names and len(order) < 3:
            order.append(other.name)
            if len(order) - 1 == failing:
                raise OSError(errno.EIO, "input or output error")
        return replace(path, other)

    monkeypatch.setattr(Path, "replace", seen)
    with contextlib.ExitStack() as stack:
        if failing is not None:
            stack.enter_context(pytest.raises((RigUIError, ZeroDivisionError)))
        with Transaction(()) as files:
            for each in targets:
                check = (lambda _: False) if failing == "stage" and each == targets[2] else None
                assert files.stage(NEW, each, verify=check) == "written"
            if failing == "block":
                raise ZeroDivisionError
            files.commit()
    after = contents(tmp_path)
    assert after == (before if failing is not None else dict.fromkeys(names, NEW))
    assert failing is not None or order == names[::-1], "the layer comes last"


def test_a_kill_between_two_renames_leaves_the_layer_with_its_report_or_the_layer_of_before(tmp_path):
    script = f"""
import os, signal
from pathlib import Path
from usdrigui.replacing.transaction import Transaction
folder = Path({str(tmp_path)!r})
replace = Path.replace
def killed(path, other):
    replace(path, other)
    os.kill(os.getpid(), signal.SIGKILL)
Path.replace = killed
with Transaction(()) as files:
    files.stage(b"new layer", folder / "char.rigui.usda")
    files.stage(b"new report", folder / "report.json")
    files.commit()
"""
    (tmp_path / "char.rigui.usda").write_bytes(OLD)
    (tmp_path / "report.json").write_bytes(OLD)
    assert ran("-c", script).returncode == -signal.SIGKILL
    assert (tmp_path / "char.rigui.usda").read_bytes() == OLD
    assert (tmp_path / "report.json").read_bytes() == b"new report"
    commit(NEW, tmp_path / "report.json")
    assert {each.name for each in tmp_path.iterdir()} == {"char.rigui.usda", "report.json"}


@pytest.mark.skipif(not hasattr(os, "setxattr"), reason="there are no extended attributes")
def test_access_lists_and_other_attributes_are_kept(target):
    folder_list = bytes.fromhex("0200000001000700ffffffff04000700ffffffff20000500ffffffff")
    access = bytes.fromhex("0200000001000600ffffffff02000600e803000004000400ffffffff10000600ffffffff20000000ffffffff")
    try:
        os.setxattr(target, "user.task", b"rig")
        os.setxattr(target, "system.posix_acl_access", access)
        os.setxattr(target.parent, "system.posix_acl_default", folder_list)
    except OSError:
        pytest.skip("this file system has no access lists")
    before = target.stat().st_mode
    commit(NEW, target)
    assert os.getxattr(target, "user.task") == b"rig"
    assert os.getxattr(target, "system.posix_acl_access") == access
    assert target.stat().st_mode == before


@pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() != 0, reason="only root gives files away")
def test_the_owner_is_kept_where_that_is_allowed(target):
    os.chown(target, 1234, 1235)
    commit(NEW, target)
    assert (target.stat().st_uid, target.stat().st_gid) == (1234, 1235)


def test_writers_at_once_all_end_with_a_whole_file(target):
    contents = [bytes([65 + i]) * 300_000 for i in range(4)]
    failures = []

    def write(content: bytes) -> None:
        try:
            for _ in range(10):
                commit(content, target)
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=write, args=(content,)) for content in contents]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        assert target.read_bytes() in (OLD, *contents)
    assert not failures
    assert only_file(target)
