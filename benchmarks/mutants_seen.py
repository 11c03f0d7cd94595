"""Which tests reach which marked places: a plug-in of pytest that the mutation job puts into its
copy of the package as `usdrigui/_seen.py`.

A file of one byte per place is in the memory of the runner and of every process that it starts: so
what a process reaches is known that may write no file, and in every test that it outlives. The
runner writes `T test` where a test begins, `S place` for what was reached, `E seconds` where a test
that passed ends. Places reached before the first test are reached by importing.
"""

from __future__ import annotations

import mmap
import os
from pathlib import Path

import pytest

_FILE = Path(os.environ.get("MUTANTS_SEEN", "none"))


def _places() -> list[str]:
    try:
        return _FILE.with_suffix(".places").read_text(encoding="utf-8").splitlines()
    except OSError:
        return []  # a process that was started without our environment


def _shared(size: int) -> mmap.mmap | bytearray:
    """A byte for each place, shared by all processes."""
    try:
        with _FILE.with_suffix(".bytes").open("r+b") as file:
            return mmap.mmap(file.fileno(), size)
    except (OSError, ValueError):
        return bytearray(size)


_names = _places()
_number = {place: number for number, place in enumerate(_names)}
_reached = _shared(len(_names))


def seen(*places: str) -> None:
    """Note that the places were reached; false, so that `seen(place) or value` is the value."""
    for place in places:
        if place in _number:
            _reached[_number[place]] = 1


def _write(*lines: str) -> None:
    """Lines, after the places reached since the last."""
    reached = [f"S {place}" for place, byte in zip(_names, _reached[:], strict=True) if byte]
    _reached[:] = bytes(len(_names))
    with _FILE.open("a", encoding="utf-8") as file:
        file.writelines(f"{line}\n" for line in (*reached, *lines))


def _seconds() -> float:
    return sum(os.times()[:4])


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> object:
    """Note where the test begins and ends, and the processor seconds between."""
    _write(f"T {item.nodeid}")
    start = _seconds()
    result = yield
    if getattr(item, "passed", False):
        _write(f"E {_seconds() - start:.3f}")
    return result


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> pytest.TestReport:
    """Note whether the test passed."""
    report: pytest.TestReport = yield
    if report.when == "call":
        item.passed = report.passed  # type: ignore[attr-defined]
    return report
