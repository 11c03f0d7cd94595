"""A batch that is told to end: none of its processes goes on, and the signals' handlers are what they were."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest
from processes import children_of, gone, until

from usdrigui.clients.batch import run

pytestmark = pytest.mark.slow
of_linux = pytest.mark.skipif(
    sys.platform != "linux", reason="only Linux forks the processes of a batch and ends them with their parent"
)
ENDING = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP]


def hanging(folder, count=3):
    """Assets that USD never finishes to read."""
    os.mkfifo(folder / "pipe.usda")
    for index in range(count):
        (folder / f"char{index}.usd").write_text("#usda 1.0\n(\n    subLayers = [@./pipe.usda@]\n)\n")
    return str(folder / "*.usd")


def batch_of(folder, *options):
    return subprocess.Popen(
        [sys.executable, "-m", "usdrigui", "batch", hanging(folder), "--jobs", "2", *options],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),  # as not in the background
    )


def processes_of(batch):
    """The batch's worker, the parent of those of its assets, and all of them."""
    (worker,) = until(lambda: children_of(batch.pid))
    (parent,) = until(lambda: children_of(worker))
    return worker, parent, *until(lambda: found if len(found := children_of(parent)) == 2 else None)


@pytest.mark.parametrize("number", ENDING)
def test_a_signal_ends_the_processes_of_a_batch_and_not_its_account(tmp_path, number):
    (tmp_path / "a.usd").write_text("#usda 1.0\n")  # refused at once
    batch = batch_of(tmp_path, "--summary", str(tmp_path / "summary.json"))
    processes = processes_of(batch)
    until(lambda: batch.stderr.readline().startswith("[1/4]"))
    batch.send_signal(number)
    told, errors = batch.communicate(timeout=60)
    assert batch.returncode == 4
    assert "Traceback" not in errors
    assert told.splitlines()[-1].startswith("usdrigui: stopped; 0 of 4 assets")
    until(lambda: gone(*processes))
    rows = json.loads((tmp_path / "summary.json").read_text())["assets"]
    assert [row["code"] == "INTERRUPTED" for row in rows] == [False, True, True, True]
    assert not [each.name for each in tmp_path.iterdir() if "rigui" in each.name]


@of_linux
def test_a_batch_that_is_killed_leaves_no_process(tmp_path):
    batch = batch_of(tmp_path)
    processes = processes_of(batch)
    batch.kill()
    batch.communicate(timeout=60)
    until(lambda: gone(*processes))


@of_linux
def test_a_parent_that_is_killed_takes_what_it_has_forked_and_no_more(tmp_path):
    batch = batch_of(tmp_path, "--summary", str(tmp_path / "summary.json"), "--timeout", "4")
    os.kill(processes_of(batch)[1], signal.SIGKILL)
    batch.communicate(timeout=60)
    rows = json.loads((tmp_path / "summary.json").read_text())["assets"]
    assert sorted(row["code"] for row in rows) == ["BATCH_TIME_LIMIT", "WORKER_LOST", "WORKER_LOST"]


def test_a_signal_while_jobs_are_handed_out_leaves_none_of_them(monkeypatch):
    """Else the pool would do them all while Python exits."""
    given = []

    class Pool(run.ThreadPoolExecutor):
        def submit(self, work, /, *arguments):
            if len(given) == 2:
                raise KeyboardInterrupt
            given.append(super().submit(work, *arguments))
            return given[-1]

    done, patient, ending = [], [], []

    def slow(job):
        time.sleep(0.5)
        done.append(job)

    monkeypatch.setattr(run, "ThreadPoolExecutor", Pool)
    monkeypatch.setattr(run, "run_job", slow)
    monkeypatch.setattr(run.worker, "be_patient", patient.append)
    monkeypatch.setattr(run, "end_all", lambda: ending.append(list(patient)))
    with pytest.raises(KeyboardInterrupt):
        list(run.run_local(["first", "second", "third"], 1))
    assert given[1].cancelled()
    assert done == ["first"]
    assert ending[0] == [True]  # a machine under load takes longer to end them than a worker has that was stopped
