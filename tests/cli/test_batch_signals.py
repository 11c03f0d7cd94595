"""A batch that is told to end: none of its processes goes on, and the signals' handlers are what they were."""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest
from processes import children_of, until

from usdrigui.cli import main
from usdrigui.clients.batch import run

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="POSIX signals")
ENDING = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP] if sys.platform != "win32" else []


@pytest.fixture(autouse=True)
def heeded():
    """No signal is ignored to begin with, as it is where a shell has put the tests in the background."""
    before = {each: signal.signal(each, signal.default_int_handler) for each in ENDING}
    yield
    for each, handler in before.items():
        signal.signal(each, handler)


def hanging(folder, count=3):
    """Assets that USD never finishes to read."""
    os.mkfifo(folder / "pipe.usda")
    for index in range(count):
        (folder / f"char{index}.usd").write_text("#usda 1.0\n(\n    subLayers = [@./pipe.usda@]\n)\n")
    return str(folder / "*.usd")


def gone(process):
    with contextlib.suppress(OSError):
        return " Z " in Path(f"/proc/{process}/stat").read_text()
    return True


@pytest.mark.parametrize("number", ENDING)
def test_a_signal_ends_the_processes_of_a_batch(tmp_path, number):
    batch = subprocess.Popen(
        [sys.executable, "-m", "usdrigui", "batch", hanging(tmp_path), "--jobs", "2"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    workers = until(lambda: found if len(found := children_of(batch.pid)) == 2 else None)
    readers = until(lambda: found if len(found := children_of(*workers)) == 2 else None)
    try:
        for _ in range(3):  # the later ones come while the processes are being ended, which they must not stop
            batch.send_signal(number)
        _, told = batch.communicate(timeout=60)
        assert batch.returncode == 4
        assert "INTERRUPTED" in told
        assert "Traceback" not in told
        until(lambda: all(map(gone, [*workers, *readers])))
        assert not [each.name for each in tmp_path.iterdir() if "rigui" in each.name]
    finally:
        for each in (*workers, *readers):
            with contextlib.suppress(OSError):
                os.kill(each, signal.SIGKILL)


@pytest.fixture
def nothing_to_do(monkeypatch, tmp_path):
    """A batch whose work is a look at the handlers that hold meanwhile."""
    seen = []

    def look(jobs, workers):
        del jobs, workers
        seen.append([signal.getsignal(each) for each in ENDING])
        yield from ()

    monkeypatch.setattr(run, "run_local", look)
    (tmp_path / "char.usda").touch()
    return ["batch", str(tmp_path / "char.usda"), "--quiet"], seen


def test_the_handlers_are_put_back(nothing_to_do):
    command, seen = nothing_to_do
    before = [signal.getsignal(each) for each in ENDING]
    assert main(command) == 0
    assert not set(seen[0]) & set(before)
    assert [signal.getsignal(each) for each in ENDING] == before


def test_a_signal_that_is_ignored_stays_ignored(nothing_to_do):
    """As under ``nohup``."""
    command, seen = nothing_to_do
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)
    try:
        assert main(command) == 0
        assert seen[0][ENDING.index(signal.SIGHUP)] == signal.SIG_IGN
        assert signal.getsignal(signal.SIGHUP) == signal.SIG_IGN
    finally:
        signal.signal(signal.SIGHUP, before)


def test_a_batch_of_another_thread_leaves_the_handlers_alone(nothing_to_do):
    """Python lets the main thread alone set them."""
    command, seen = nothing_to_do
    codes = []
    thread = threading.Thread(target=lambda: codes.append(main(command)))
    thread.start()
    thread.join(60)
    assert codes == [0]
    assert seen == [[signal.getsignal(each) for each in ENDING]]


def test_a_signal_while_jobs_are_handed_out_leaves_none_of_them(monkeypatch):
    """Else the pool would do them all while Python exits."""
    given = []

    class Pool(run.ThreadPoolExecutor):
        def submit(self, work, /, *arguments):
            if len(given) == 2:
                raise KeyboardInterrupt
            given.append(super().submit(work, *arguments))
            return given[-1]

    done = []

    def slow(job):
        time.sleep(0.5)
        done.append(job)

    monkeypatch.setattr(run, "ThreadPoolExecutor", Pool)
    monkeypatch.setattr(run, "run_job", slow)
    with pytest.raises(KeyboardInterrupt):
        next(run.run_local(["first", "second", "third"], 1))
    assert given[1].cancelled()
    assert done == ["first"]
