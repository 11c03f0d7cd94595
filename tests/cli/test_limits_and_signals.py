"""Limits and signals on the real command: the best so far or a typed error, quickly, nothing half-written."""

import json
import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import commands
import numpy as np
import pytest
from processes import children_of, gone, until
from skel_stages import add_mesh, add_shape, character, grid, head

from usdrigui.cli import main
from usdrigui.layer.read_layout import read_layout
from usdrigui.settings import Settings

pytestmark = pytest.mark.slow
SAMPLE = Path(__file__).parents[2] / "sample_assets" / "char.usda"
SOON = 60.0
"""Seconds; generous, for a busy machine."""


def start(*arguments):
    return subprocess.Popen(
        [sys.executable, "-u", "-m", "usdrigui", "process", *map(str, arguments)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def processes_below(process):
    """The worker, the warm parent and the reader, once the reader is there."""
    below = [until(lambda: children_of(process.pid))]
    for _ in range(2 if sys.platform == "linux" else 1):
        below.append(until(lambda: children_of(*below[-1])))
    return [number for numbers in below for number in numbers]


def wait_for_line(process, word):
    """Read standard error until a line that begins with the word."""
    for line in process.stderr:
        if line.startswith(word):
            return
    raise AssertionError(f"never said {word}")


def ended(process, sent):
    out, err = process.communicate(timeout=90)
    assert time.monotonic() - sent < SOON
    assert "Traceback" not in out + err
    return out, err


@pytest.fixture
def hanging(tmp_path):
    """An asset that USD never finishes to read, and the layer of an earlier day."""
    os.mkfifo(tmp_path / "pipe.usda")
    path = tmp_path / "char.usda"
    path.write_text("#usda 1.0\n(\n    subLayers = [@./pipe.usda@]\n)\n")
    (tmp_path / "char.rigui.usda").write_bytes(b"#usda 1.0\n")
    return path


def untouched(asset):
    layer = asset.with_name("char.rigui.usda")
    return layer.read_bytes() == b"#usda 1.0\n" and not [each for each in layer.parent.iterdir() if "tmp" in each.name]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_reading_ends_the_run_and_the_reader(hanging, number):
    process = start(hanging)
    below = processes_below(process)
    sent = time.monotonic()
    process.send_signal(number)
    _, err = ended(process, sent)
    assert process.returncode == 4
    assert "INTERRUPTED" in err
    assert err.splitlines()[-1].endswith("nothing was written")
    until(lambda: gone(*below))
    assert untouched(hanging)


@pytest.fixture(scope="module")
def crowded(tmp_path_factory):
    """200 controls on the middle of one sheet: its best layout is not proven within a minute."""
    path = tmp_path_factory.mktemp("crowd") / "char.usda"
    points, _ = grid(31)
    random = np.random.default_rng(1)

    def crowd(stage):
        mesh = add_mesh(stage, "/Char/Sheet", "/Char/Skel", side=31)
        for number in range(200):
            far = np.sum((points[:, :2] - random.uniform(-0.4, 0.4, 2)) ** 2, axis=1)
            bump = np.exp(-far / random.uniform(0.01, 0.06))
            add_shape(mesh, f"shape{number}", 0.2 * bump[:, None] * random.normal(size=3))

    return head(path, edit=crowd)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_solving_gives_the_best_so_far(tmp_path, crowded, number):
    target, report = tmp_path / "out.usda", tmp_path / "out.json"
    endless = ("--gap", "0", "--set", "solve.work_limit=2000000000000")
    process = start(crowded, "-o", target, "--report", report, *endless)
    wait_for_line(process, "problem")
    time.sleep(0.5)
    sent = time.monotonic()
    process.send_signal(number)
    said = "".join(ended(process, sent))
    assert process.returncode == 0
    assert "the search was interrupted; its best layout is kept" in said
    (layout,) = read_layout(target)
    (found,) = json.loads(report.read_text())["characters"]
    assert found["solution"]["closed_by"] == layout.proof.closed_by == "interrupt"
    assert found["solution"]["status"] == layout.proof.status == "stopped"
    assert found["solution"]["bound"] < found["solution"]["cost"]


def test_a_second_signal_ends_at_once(hanging):
    process = start(hanging)
    until(lambda: children_of(process.pid))
    sent = time.monotonic()
    for _ in range(3):
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
    ended(process, sent)
    assert process.returncode == 4
    assert untouched(hanging)


@pytest.mark.parametrize("which", ["worker", "warm parent", "reader"])
def test_whatever_is_killed_the_command_ends_with_a_code(hanging, which):
    process = start(hanging)
    worker, parent, reader = below = processes_below(process)
    os.kill({"worker": worker, "warm parent": parent, "reader": reader}[which], signal.SIGKILL)
    out, err = ended(process, time.monotonic())
    assert process.returncode == 4
    assert ("WORKER_LOST" if which == "worker" else "SOURCE_READER_LOST") in out + err
    until(lambda: gone(*below))
    assert untouched(hanging)


def test_a_time_limit_on_the_search_gives_an_honest_layout(tmp_path, capsys):
    target = tmp_path / "out.usda"
    endless = ("--gap", "0", "--set", "solve.work_limit=2000000000000")
    (found,) = commands.run(capsys, "process", SAMPLE, "-o", target, "--time-limit", "0.2", *endless)["characters"]
    solution = found["solution"]
    assert solution["status"] == "stopped"
    assert solution["bound"] < solution["cost"]
    assert solution["gap"] == pytest.approx((solution["cost"] - solution["bound"]) / abs(solution["cost"]), rel=1e-6)
    assert read_layout(target)


@pytest.mark.parametrize("limit", [1, 8, 64])
def test_a_memory_limit_on_the_search_gives_a_layout_or_a_code(tmp_path, limit, capsys):
    asset = character(tmp_path / "char.usda")
    code = main(["process", str(asset), "--memory-limit", str(limit), "--json"])
    document = json.loads(capsys.readouterr().out)
    assert code in (0, 4)
    assert document["exit"] == code
    for found in document["characters"] if code == 0 else ():
        solution = found["solution"]
        assert solution["bound"] <= solution["cost"]
        assert solution["status"] == ("optimal" if solution["gap"] <= Settings().solve.gap else "stopped")
    assert (tmp_path / "char.rigui.usda").exists() == (code == 0)


@pytest.mark.parametrize("most", [100, 300, 1200])
def test_a_limit_of_the_system_on_addresses_is_no_bug(tmp_path, most):
    """Libraries are not loaded, wait for ever or crash where they get none."""
    path = head(tmp_path / "char.usda")

    def bounded():
        resource.setrlimit(resource.RLIMIT_AS, (most << 20,) * 2)

    command = [sys.executable, "-m", "usdrigui", "process", str(path)]
    done = subprocess.run(command, preexec_fn=bounded, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 4
    assert "RUN_MEMORY_LIMIT the system allows" in done.stderr
