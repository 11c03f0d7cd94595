"""usdrigui.replacing.exchange: an edited source takes the place of what was read, and of nothing else."""

from __future__ import annotations

import os
import signal
import sys
import threading
from pathlib import Path

import pytest
from programs import ran

from usdrigui.errors import RigUIError
from usdrigui.isolation.foreign_file import hashed
from usdrigui.replacing import attributes, exchange, temporaries
from usdrigui.replacing.exchange import Original, editing, replace_source

OLD, EDITED = b"#usda 1.0\n" * 100, b"#usda 1.0 edited\n" * 100
ONE, TWO = b"somebody's save\n", b"and another save\n"

linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux lets two files change places")


@pytest.fixture
def asset(tmp_path):
    path = tmp_path / "char.usda"
    path.write_bytes(OLD)
    return path


def edited(asset: Path, verify=lambda _: True) -> str:
    """The code with which the edit is refused, or nothing."""
    before = hashed(asset)
    try:
        replace_source(asset, Original(before, OLD), EDITED, verify)
    except RigUIError as error:
        return error.issue.code
    return ""


def save(asset: Path, content: bytes) -> None:
    beside = asset.with_name("saving.tmp")
    beside.write_bytes(content)
    beside.replace(asset)


def alone(asset: Path) -> bool:
    return [each.name for each in asset.parent.iterdir()] == [asset.name]


def exchanges(monkeypatch, asset, *, before=(), after=()):
    """Saves that come just before or just after the first, second ... exchange."""
    swap, calls = exchange._exchange, []

    def busy(first, second):
        calls.append(second)
        number = len(calls) - 1
        if number < len(before) and before[number]:
            save(asset, before[number])
        done = swap(first, second)
        if number < len(after) and after[number]:
            save(asset, after[number])
        return done

    monkeypatch.setattr(exchange, "_exchange", busy)
    return calls


def test_it_takes_the_place(asset):
    assert edited(asset) == ""
    assert asset.read_bytes() == EDITED
    assert alone(asset)


def test_a_save_during_the_check_stays(asset):
    assert edited(asset, lambda _: save(asset, ONE) or True) == "SOURCE_CHANGED"
    assert asset.read_bytes() == ONE
    assert alone(asset)


@linux
@pytest.mark.parametrize(
    ("saves", "code", "last"),
    [
        ({"before": [ONE]}, "SOURCE_CHANGED", ONE),
        ({"before": [ONE, TWO]}, "SOURCE_CHANGED", TWO),
        ({"before": [ONE, TWO, ONE]}, "SOURCE_CHANGED", ONE),
        ({"after": [ONE]}, "", ONE),
        ({"before": [ONE], "after": [None, TWO]}, "SOURCE_CHANGED", TWO),
    ],
)
def test_the_last_save_stays_whenever_it_comes(asset, monkeypatch, saves, code, last):
    """After the last comparison, while the file goes back, and after it went."""
    exchanges(monkeypatch, asset, **saves)
    assert edited(asset) == code
    assert asset.read_bytes() == last
    assert alone(asset)


@linux
def test_a_file_that_a_program_has_open_for_writing_is_left_to_it(asset):
    with asset.open("r+b") as stream:
        assert edited(asset) == "ATTACH_BUSY"
        stream.write(ONE)
    assert asset.read_bytes().startswith(ONE)
    assert alone(asset)
    with asset.open("rb"):
        asset.write_bytes(OLD)
        assert edited(asset) == "", "readers disturb nobody"


@linux
def test_a_program_that_opens_the_file_at_the_last_moment_keeps_it(asset, monkeypatch):
    swap, opened = exchange._exchange, []

    def busy(first, second):
        if not opened:
            opened.append(asset.open("r+b"))
        return swap(first, second)

    monkeypatch.setattr(exchange, "_exchange", busy)
    assert edited(asset) == "ATTACH_BUSY"
    with opened[0] as stream:
        stream.write(ONE)
    assert asset.read_bytes().startswith(ONE)


@pytest.mark.parametrize("save_first", [True, False])
def test_where_files_cannot_change_places_the_last_comparison_decides(asset, monkeypatch, save_first):
    monkeypatch.setattr(exchange, "_exchange", lambda *_: save(asset, ONE) if save_first else None)
    assert edited(asset) == ("SOURCE_CHANGED" if save_first else "")
    assert asset.read_bytes() == (ONE if save_first else EDITED)
    assert alone(asset)


@linux
def test_a_save_that_a_kill_left_under_the_name_of_a_temporary_is_not_swept(asset):
    """The kill came between the exchange and the look at what came out."""
    for content, swept in ((OLD, True), (EDITED, True), (ONE, False)):
        made, descriptor = temporaries.create(asset.parent, ".usda")
        path = made.rename(temporaries.name_for_exchange(made, OLD, EDITED))
        path.write_bytes(content)
        os.close(descriptor)
        temporaries.sweep(asset.parent)
        assert path.exists() is not swept


@pytest.mark.parametrize("end", ["the disk is full", "killed"])
def test_what_is_left_of_a_new_file_that_was_not_complete_goes(asset, end):
    """Half of it is neither the old nor the new content, and nobody's save."""
    script = f"""
import os, signal
from pathlib import Path
from usdrigui.errors import RigUIError
from usdrigui.isolation.foreign_file import hashed
from usdrigui.replacing.exchange import Original, replace_source
asset, write = Path({str(asset)!r}), os.write
def half(descriptor, content):
    write(descriptor, content[: len(content) // 2])
    if {end == "killed"}:
        os.kill(os.getpid(), signal.SIGKILL)
    raise OSError(28, "No space left on device")
os.write = half
try:
    replace_source(asset, Original.of(hashed(asset)), {EDITED!r}, lambda _: True)
except RigUIError as error:
    print(error.issue.code)
"""
    done = ran("-c", script)
    assert (done.stdout, done.returncode) == (("", -signal.SIGKILL) if end == "killed" else ("FILE_FULL\n", 0))
    assert alone(asset) is (end != "killed")
    assert asset.read_bytes() == OLD
    temporaries.sweep(asset.parent)
    assert alone(asset)


def test_a_sweep_does_not_wait_for_a_pipe_of_such_a_name(asset):
    pipe = temporaries.name_for_exchange(asset.with_name(".0123456789abcdef.rigui-tmp"), OLD, EDITED)
    os.mkfifo(pipe)
    signal.alarm(20)
    temporaries.sweep(asset.parent)
    signal.alarm(0)
    assert pipe.exists()


def test_an_interruption_after_the_exchange_gives_the_old_file_back(asset, monkeypatch):
    def interrupted(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr(exchange, "_check_content", interrupted)
    with pytest.raises(KeyboardInterrupt):
        edited(asset)
    assert asset.read_bytes() == OLD
    assert alone(asset)


def test_a_file_of_several_names_is_refused(asset):
    other = asset.with_name("other.usda")
    other.hardlink_to(asset)
    assert edited(asset) == "ATTACH_HARD_LINK"
    assert asset.samefile(other)


@pytest.mark.parametrize("call", ["fchown", "setxattr"])
def test_what_cannot_be_kept_is_refused(asset, monkeypatch, call):
    def denied(*_):
        raise PermissionError(1, "not permitted")

    if call == "fchown":
        monkeypatch.setattr(attributes, "_attributes", lambda _: {})
        stat = Path.stat
        fields = list(asset.stat())
        fields[4] += 1
        monkeypatch.setattr(
            Path, "stat", lambda path, **how: os.stat_result(fields) if path == asset else stat(path, **how)
        )
    else:
        monkeypatch.setattr(attributes, "_attributes", lambda file: {"user.task": b"rig"} if file == asset else {})
    monkeypatch.setattr(os, call, denied)
    assert edited(asset) == "ATTACH_ATTRIBUTES"
    monkeypatch.undo()
    assert asset.read_bytes() == OLD
    assert alone(asset)


def test_edits_wait_for_each_other_and_leave_no_lock(asset):
    order = []

    def second():
        with editing(asset, 30.0):
            order.append("second")

    with editing(asset, 0.0):
        waiting = threading.Thread(target=second)
        waiting.start()
        with pytest.raises(RigUIError, match="ATTACH_BUSY"), editing(asset.parent / "." / asset.name, 0.1):
            pass
        order.append("first")
    waiting.join()
    assert order == ["first", "second"]
    assert alone(asset)
