"""The suites take what they say: nothing falls between quick and slow, and the sample meets every slow file."""

from __future__ import annotations

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
        ("sample", ["kills", "of_a_rig"]),
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


@pytest.mark.parametrize("change", ["executable", "environment", "switched off"])
def test_a_reader_of_another_program_or_environment_is_not_forked(change, forking, monkeypatch):
    if forking is None:
        pytest.skip("readers are forked on Linux only")
    monkeypatch.setattr(forking, "fresh", lambda *_: "fresh")
    if change == "executable":
        monkeypatch.setattr("sys.executable", "/bin/false")
    elif change == "environment":
        monkeypatch.setenv("PXR_PLUGINPATH_NAME", "/elsewhere")
    else:
        monkeypatch.setattr(forking, "on", False)
    assert forking.start(None, None) == "fresh"
