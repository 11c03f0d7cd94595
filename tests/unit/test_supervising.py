"""Whatever becomes of a worker, its supervisor has one closing line with a documented code, and the worker is gone."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from queue import SimpleQueue

import minimal_assets
import pytest
from processes import impostor
from programs import ran

from usdrigui.errors import Exit, refuse
from usdrigui.isolation.supervising import STOP, interrupted, supervise


def message(**fields):
    return f"echo '{json.dumps(fields)}'"


BUDGET = message(what="budget", seconds=0.3, memory=100, base=0)
SEARCHING = message(what="patient", patient=True)
WRITING = message(what="writing", paths=["out.usda"])
WROTE = message(what="wrote", paths=["out.usda"])
END = message(what="end", code=0, out="done", err="")
FULL = "echo std::bad_alloc >&2; kill -ABRT $$"

DEATHS = {
    "a crash of ours": ("kill -SEGV $$", "WORKER_CRASHED", Exit.BUG),
    "killed": ("kill -KILL $$", "WORKER_LOST", Exit.LIMIT),
    "no memory": (f"{BUDGET}; {FULL}", "RUN_MEMORY_LIMIT", Exit.LIMIT),
    "no time": (f"{BUDGET}; exec sleep 60", "RUN_TIME_LIMIT", Exit.LIMIT),
    "silence": ("exit 0", "WORKER_CRASHED", Exit.BUG),
    "another program": ("echo No module named pxr >&2; exit 1", "WORKER_CRASHED", Exit.BUG),
    "nonsense": ("head -c 5000 /dev/urandom", "WORKER_CRASHED", Exit.BUG),
    "a message cut off": (f"printf '{END[6:40]}'; kill -KILL $$", "WORKER_LOST", Exit.LIMIT),
}


def python(program, folder=None):
    """The process of a program that has ended."""
    return ran("-c", program, cwd=folder)


@pytest.fixture
def run(tmp_path, monkeypatch):
    """Supervise a shell script in a worker's place."""

    def supervised(script, *events, **options):
        impostor(tmp_path, monkeypatch, f"echo $$ > {tmp_path}/pid\n{script}")
        waiting, printed = SimpleQueue(), []
        for each in events:
            waiting.put(each)
        outcome = supervise(["process"], lambda *shown: printed.append(shown), waiting, **options)
        noted = tmp_path / "pid"  # unless it was killed before that
        for pid in noted.read_text().split() if noted.exists() else ():
            assert not Path(f"/proc/{pid}").exists()
        return outcome, printed

    return supervised


@pytest.mark.parametrize("how", DEATHS)
def test_every_death_has_its_code(how, run):
    script, code, leaves = DEATHS[how]
    outcome, _ = run(script)
    assert (outcome.death.issue.code, outcome.code) == (code, leaves)


def test_a_closing_message_counts_whatever_comes_after_it(run):
    outcome, printed = run(
        f"{message(what='print', stream='err', text='read')}; {WRITING}; {WROTE}; {END}; kill -SEGV $$"
    )
    assert (outcome.code, outcome.out, outcome.death, outcome.written) == (0, "done", None, ("out.usda",))
    assert printed == [("err", "read")]


def test_what_a_death_leaves_open_is_reported(run):
    outcome, _ = run(f"{WRITING}; kill -KILL $$")
    assert (outcome.written, outcome.unknown) == ((), ("out.usda",))


@pytest.mark.parametrize(
    ("script", "events"),
    [
        pytest.param("exec sleep 60", (interrupted(),), id="told to"),
        pytest.param("exec sleep 60", (STOP, STOP), id="a second request"),
        pytest.param("sleep 60 & exec sleep 60", (STOP, STOP), id="what it has started holds its pipe"),
        pytest.param(f"{SEARCHING}; exec sleep 60", (STOP, STOP), id="a second request while it searches"),
        pytest.param("exec sleep 60", (STOP,), id="it does not hear"),
    ],
)
def test_a_request_to_stop_ends_a_worker(script, events, run, monkeypatch):
    monkeypatch.setattr("usdrigui.isolation.supervising._PATIENCE", 0.5)
    before = time.monotonic()
    outcome, _ = run(script, *events)
    assert (outcome.death.issue.code, outcome.code) == ("INTERRUPTED", Exit.LIMIT)
    assert time.monotonic() - before < 10


@pytest.mark.parametrize("state", [SEARCHING, WRITING])
def test_a_search_and_a_write_may_finish(state, run, monkeypatch):
    monkeypatch.setattr("usdrigui.isolation.supervising._PATIENCE", 0.05)
    outcome, _ = run(f"read greeting; {state}; head -c 1 >/dev/null; sleep 0.3; {END}", STOP)
    assert (outcome.code, outcome.out) == (0, "done")


def test_a_search_out_of_time_ends_with_what_it_has(run):
    outcome, _ = run(f"read greeting; {SEARCHING}; {BUDGET}; head -c 1 >/dev/null; {END}")
    assert (outcome.code, outcome.out) == (0, "done")


def test_a_limit_of_the_caller(run):
    outcome, _ = run("exec sleep 60", refuse("BATCH_TIME_LIMIT", "", "late"))
    assert outcome.death.issue.code == "BATCH_TIME_LIMIT"


@pytest.mark.parametrize(
    ("executable", "code"),
    [("/no/such/python", "WORKER_LOST"), ("/", "PYTHON_PERMISSION"), (None, "WORKER_LOST")],
)
def test_a_worker_that_cannot_be_started(executable, code, monkeypatch):
    monkeypatch.setattr(sys, "executable", executable)
    found = supervise(["process"], print).death.issue
    assert found.code == code
    assert found.path == (executable if code == "PYTHON_PERMISSION" else "")


# --- the command -------------------------------------------------------------------------------------


def command(*arguments, stdout=subprocess.PIPE, **options):
    argv = [sys.executable, "-m", "usdrigui", *map(str, arguments)]
    return subprocess.run(argv, stdout=stdout, stderr=subprocess.PIPE, text=True, check=False, **options)


def closing_lines(text):
    return [line for line in text.splitlines() if line.startswith("usdrigui: ")]


def test_the_supervisor_loads_neither_numpy_nor_usd(tmp_path):
    """Even when it has to say itself that the worker has no closing line."""
    program = (
        "import sys; from queue import SimpleQueue; from usdrigui.cli.supervised import run\n"
        "sys.executable = '/no/such/python'\n"
        "code = run(['inspect', 'char.usda', '--json'], SimpleQueue())\n"
        'sys.exit(f\'{code} {sorted({"numpy", "pxr", "scipy", "rich"} & set(sys.modules))}\')'
    )
    done = python(program, tmp_path)
    assert json.loads(done.stdout)["issues"][0]["code"] == "WORKER_LOST"
    assert done.stderr.splitlines()[-1] == "4 []"


@pytest.mark.parametrize("stream", ["full", "closed"])
def test_standard_output_that_takes_nothing(stream, tmp_path):
    """The layer is written all the same, and the closing line, which says so, is on standard error."""
    asset = minimal_assets.character(tmp_path)
    shut = {"stdout": None, "preexec_fn": lambda: os.close(1)} if stream == "closed" else {}
    with Path("/dev/full").open("w") as full:
        done = command("process", asset, "--quiet", **({"stdout": full} | shut))
    assert done.returncode == Exit.FILE
    (_, closing) = closing_lines(done.stderr)
    assert closing.endswith(f"without its report; written {asset.with_name('char.rigui.usda')}")
    assert asset.with_name("char.rigui.usda").is_file()


def test_a_working_directory_that_was_deleted(tmp_path):
    asset, folder = minimal_assets.character(tmp_path), tmp_path / "gone"
    folder.mkdir()
    done = command("process", asset, cwd=folder, preexec_fn=folder.rmdir)
    assert (done.returncode, "WORKING_DIRECTORY" in done.stderr) == (Exit.FILE, True)
    assert "Traceback" not in done.stderr


def test_signals_are_heeded_before_anything_is_loaded_that_python_has_not():
    program = (
        "import enum, importlib, os, signal, sys; before = {*sys.modules}\n"
        "signal.signal = lambda *_: sys.exit(str(sorted({*sys.modules} - before - {'__future__'})))\n"
        "from usdrigui.__main__ import main; main()"
    )
    done = python(program)
    assert done.stderr.strip() == "['usdrigui', 'usdrigui.__main__', 'usdrigui.version']"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_while_options_are_parsed(number, tmp_path):
    program = f"""
import argparse, os, signal, sys
from usdrigui.__main__ import main
made = argparse.ArgumentParser.__init__
def interrupted(*arguments, **options):
    os.kill(os.getpid(), {int(number)})
    made(*arguments, **options)
argparse.ArgumentParser.__init__ = interrupted
signal.signal(signal.SIGINT, signal.default_int_handler)
sys.argv = ["usdrigui", "inspect", "char.usda"]
sys.exit(main())
"""
    done = python(program, tmp_path)
    assert done.returncode == Exit.LIMIT
    assert "INTERRUPTED" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_signal_after_the_closing_line_changes_no_exit_code(tmp_path):
    # The last that Python does, after it has put the default actions of signals back, is to empty the modules.
    program = """
import os, signal, sys
from usdrigui.__main__ import main
class Last:
    def __del__(self, kill=os.kill, me=os.getpid(), number=signal.SIGHUP):
        kill(me, number)
signal.last = Last()
sys.argv = ["usdrigui", "--version"]
sys.exit(main())
"""
    done = python(program, tmp_path)
    assert (done.returncode, done.stdout.split()[0]) == (0, "usdrigui")
