"""The same batch on a real dask scheduler with two workers, one of which is killed at work."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import batch_assets
import pytest
from processes import until

from usdrigui.clients.batch import run
from usdrigui.clients.batch.job import Job

pytest.importorskip("distributed", reason="distributed is not installed")
pytestmark = [pytest.mark.slow, pytest.mark.skipif(os.name != "posix", reason="kills processes")]


@pytest.fixture
def scheduler(tmp_path):
    """Address of a scheduler, and the processes of its two workers, all on loopback."""
    started = []

    def start(module, *arguments):
        environment = {**os.environ, "DASK_DISTRIBUTED__WORKER__DAEMON": "False"}
        command = [sys.executable, "-m", f"distributed.cli.{module}", *arguments]
        process = subprocess.Popen(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True, env=environment
        )
        started.append(process)
        return process

    where = tmp_path / "scheduler.json"
    start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard", "--scheduler-file", str(where))
    until(where.exists, 120.0)
    options = ["--scheduler-file", str(where), "--no-nanny", "--nthreads", "1", "--no-dashboard", "--host", "127.0.0.1"]
    workers = [start("dask_worker", *options, "--local-directory", str(tmp_path / f"w{i}")) for i in range(2)]
    yield where, workers
    for each in started:
        if each.poll() is None:
            os.killpg(each.pid, signal.SIGKILL)
        each.wait()


def test_a_killed_worker_loses_nothing(tmp_path, scheduler):
    import json

    from distributed import Client

    where, workers = scheduler
    address = json.loads(where.read_text())["address"]
    with Client(address, set_as_default=False) as client:
        client.wait_for_workers(2, timeout=120)
    folder = tmp_path / "assets"
    batch_assets.folder_of(folder, count=4)
    assets = [*sorted(folder.glob("a*/*.usda")), folder / "broken.usda"]
    many = [Job(str(each), str(each.with_suffix(".rigui.usda")), "") for each in assets]
    rows, killed = [], False
    for row in run.run_on_dask(many, address):
        rows.append(row)
        if not killed:
            os.kill(workers[0].pid, signal.SIGKILL)
            killed = True
    ordered = run.in_order(rows, many)
    assert workers[0].wait(10) == -signal.SIGKILL
    assert [(Path(row.asset).parent.name, row.exit) for row in ordered[:-1]] == [(f"a{i}", 0) for i in range(4)]
    assert ordered[-1].code == "FILE_NOT_USD"
    contents = {Path(row.output).read_bytes() for row in ordered[:-1]}
    assert len(contents) == 1
