"""Which tests reach which marked places: a plug-in of pytest that the mutation job puts into its
copy of the package as `usdrigui/_seen.py`.

One runner and the processes it starts append to one file: `T test` where a test begins, `S place`
where a place is reached for the first time by that process in that test, `E seconds` where a test
that passed ends.  Places reached before the first test are reached by importing.
"""

from __future__ import annotations

import os

import pytest

_reached: set[str] = set()


def seen(*places: str) -> None:
    """Note that the places were reached; false, so that `seen(place) or value` is the value."""
    for place in places:
        if place not in _reached:
            _reached.add(place)
            _append(f"S {place}")


def _append(line: str) -> None:
    try:
        file = os.open(os.environ["MUTANTS_SEEN"], os.O_WRONLY | os.O_APPEND | os.O_CREAT)
        os.write(file, (line + "\n").encode())
        os.close(file)
    except (KeyError, OSError):
        pass  # a process that may not write, or that was started without our environment


def _seconds() -> float:
    return sum(os.times()[:4])


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> object:
    """Note where the test begins and ends, and the processor seconds between."""
    _reached.clear()
    _append(f"T {item.nodeid}")
    start = _seconds()
    result = yield
    if getattr(item, "passed", False):
        _append(f"E {_seconds() - start:.3f}")
    return result


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> pytest.TestReport:
    """Note whether the test passed."""
    report: pytest.TestReport = yield
    if report.when == "call":
        item.passed = report.passed  # type: ignore[attr-defined]
    return report
