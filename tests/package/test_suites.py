"""The suites take what they say: nothing falls between quick and slow, and the sample meets every slow file."""

import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
import suites

ROOT = Path(__file__).parents[2]


def collected(path, name, marker=None, fixtures=()):
    return SimpleNamespace(
        path=path, name=name, fixturenames=fixtures, get_closest_marker=lambda asked: asked == marker
    )


TESTS = [
    collected("a.py", "plain"),
    collected("a.py", "kills", "slow"),
    collected("a.py", "drags", fixtures=("browser", "playwright")),
    collected("b.py", "of_a_rig", "real"),
    collected("b.py", "imports", fixtures=("run_inside",)),
    collected("c.py", "skipped_elsewhere", "skipif", ("tmp_path",)),
]


@pytest.mark.parametrize(
    ("suite", "names"),
    [
        ("quick", ["plain", "skipped_elsewhere"]),
        ("slow", ["kills", "drags", "of_a_rig", "imports"]),
        ("sample", ["plain", "kills", "imports", "skipped_elsewhere"]),
        ("all", [each.name for each in TESTS]),
    ],
)
def test_what_a_suite_takes(suite, names):
    assert [each.name for each in suites.taken(TESTS, suite)] == names


def test_every_test_of_this_run_is_in_quick_or_in_slow(request):
    items = request.session.items
    quick, slow = (suites.taken(items, suite) for suite in ("quick", "slow"))
    assert sorted([*quick, *slow], key=items.index) == items


def test_both_commands_are_reported_and_ci_runs_the_sample():
    for page in ("README.md", "docs/reliability.md"):
        assert "--suite slow" in (ROOT / page).read_text(encoding="utf-8"), page
    assert "--suite sample" in (ROOT / ".ci" / "run").read_text(encoding="utf-8")


CUT = """
import os
import time

def test_fails():
    assert "this" == "that"

def test_cuts_the_run():
    time.sleep(1)
    os.kill(os.getppid() if "PYTEST_XDIST_WORKER" in os.environ else os.getpid(), 9)
"""


@pytest.mark.skipif(os.name != "posix", reason="needs SIGKILL")
@pytest.mark.parametrize("workers", [[], ["-n", "1"]])
def test_a_run_that_is_cut_has_named_its_failures(tmp_path, workers):
    (tmp_path / "test_cut.py").write_text(CUT)
    (tmp_path / "conftest.py").write_text("from failures_at_once import pytest_configure\n")
    command = [sys.executable, "-m", "pytest", "-q", *workers, str(tmp_path)]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    environment.pop("PYTEST_XDIST_WORKER", None)
    done = subprocess.run(
        command, capture_output=True, text=True, cwd=tmp_path, env=environment, timeout=60, check=False
    )
    assert done.returncode == -9
    assert "test_cut.py::test_fails" in done.stdout
    assert "assert 'this' == 'that'" in done.stdout
