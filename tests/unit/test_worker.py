"""A request to stop interrupts a worker once, and what it breaks is not taken for a bug."""

import os
import signal
import sys
import time

import pytest

from usdrigui import cli, pipeline
from usdrigui.errors import Exit
from usdrigui.isolation import worker


@pytest.fixture
def ask(monkeypatch):
    """This process as a worker, and what asks it to stop."""
    unread = os.open(os.devnull, os.O_WRONLY)
    found = worker._Worker(0, unread)
    monkeypatch.setattr(worker, "_worker", found)
    monkeypatch.setattr(sys, "unraisablehook", found.on_unraisable)
    before = signal.signal(signal.SIGINT, found.on_signal)

    def ask():
        found.asked = True
        signal.raise_signal(signal.SIGINT)

    yield ask
    signal.signal(signal.SIGINT, before)
    os.close(unread)


def test_an_interruption_that_python_drops_in_a_callback_comes_again(ask):
    class Dropping:
        def __del__(self):
            ask()

    with pytest.raises(KeyboardInterrupt):  # noqa: PT012 (on a slow machine it comes before the second line)
        Dropping()
        time.sleep(2)


def test_an_interruption_that_a_library_turns_into_another_error_is_no_bug(ask, monkeypatch, tmp_path, capsys):
    def broken(*_, **__):
        try:
            ask()
        except KeyboardInterrupt as error:
            raise SystemError("a callback failed") from error

    monkeypatch.setattr(pipeline, "process", broken)
    # The limits of a worker hold for good: browsers that later tests of this process start would die of them.
    monkeypatch.setattr(worker, "limit_memory", lambda _: None)
    code = cli.main(["process", str(tmp_path / "char.usda")])
    printed = capsys.readouterr().err
    assert (code, "INTERRUPTED" in printed, "BUG" in printed) == (Exit.LIMIT, True, False)
