"""Runs of the command in this process, with everything that they print."""

from __future__ import annotations

import contextlib
import os
import sys
import tempfile
from collections.abc import Iterator

from usdrigui.cli import main


def called(arguments: list[str]) -> tuple[int, list[str]]:
    """Exit code of `usdrigui` with these arguments, -1 where an exception left it, and that exception's name."""
    try:
        return main(arguments), []
    except BaseException as error:
        return -1, [f"{type(error).__name__} left the command"]


@contextlib.contextmanager
def captured() -> Iterator[list[bytes]]:
    """What is printed meanwhile, by Python or by C++: standard output and standard error."""
    printed: list[bytes] = []
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        saved = os.dup(1), os.dup(2)
        for stream in (sys.stdout, sys.stderr):
            stream.flush()
        os.dup2(out.fileno(), 1)
        os.dup2(err.fileno(), 2)
        try:
            yield printed
        finally:
            for stream in (sys.stdout, sys.stderr):
                stream.flush()
            for number, each in enumerate(saved, 1):
                os.dup2(each, number)
                os.close(each)
            for stream in (out, err):
                stream.seek(0)
                printed.append(stream.read())
