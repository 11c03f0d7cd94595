"""The reader's side of `usdrigui.isolation.reading`: one question, one answer, and nothing
else that a process could do.

A *program* is a module that knows how to answer and imports all that it needs: `QUESTION` is the
class of what it is asked, `answer` gives the record that goes back.  `serve` is a warm parent: it
has imported a program, reads nothing itself, and forks a confined reader for each question.
"""

from __future__ import annotations

import gc
import importlib
import os
import signal
import socket
import struct
import sys
from types import ModuleType
from typing import NoReturn, Protocol

from usdrigui.isolation.confinement import bind_to, confine
from usdrigui.isolation.process import in_mib, resident
from usdrigui.isolation.record_stream import decode, encode

FORKED = struct.Struct("<i")
"""The number of a process: what was forked, or is to be reaped."""
REAPED = struct.Struct("<ii")
"""How it ended: exit code, or minus the signal, and MiB resident at most, beyond what it began
with."""
MESSAGE = 1 << 16
"""Bytes of a message at most."""


class Question(Protocol):
    """What can be asked about a file."""

    @property
    def path(self) -> str:
        """Of the file."""

    @property
    def seconds(self) -> float:
        """Wall clock that the answer may take."""

    @property
    def memory(self) -> int:
        """MiB of private memory that it may take, beyond what the program itself does."""


def main() -> NoReturn:
    """``python -P -m usdrigui.isolation.reader PROGRAM``: a warm parent where standard input is a
    socket, else a reader of the question that it holds."""
    program = importlib.import_module(sys.argv[1])
    if sys.argv[2:] == ["warm"]:
        serve(program, socket.socket(fileno=os.dup(0)))
    answer_to = os.dup(1)
    os.dup2(2, 1)
    _answer(program, 0, answer_to)


def serve(program: ModuleType, asker: socket.socket) -> NoReturn:
    """Fork a reader for every question that comes, until nobody can ask any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.freeze()
    begun_with = resident()
    while True:
        message, descriptors, _, _ = socket.recv_fds(asker, MESSAGE, 3)
        if not message:
            os._exit(0)
        if descriptors:
            parent = os.getpid()
            reader = os.fork()
            if not reader:
                _become_reader(program, parent, os.fsdecode(message), descriptors)
            for descriptor in descriptors:
                os.close(descriptor)
            asker.send(FORKED.pack(reader))
        else:
            (ended,) = FORKED.unpack(message)
            _, status, usage = os.wait4(ended, 0)
            peak = max(0, in_mib(usage.ru_maxrss) - begun_with)
            asker.send(REAPED.pack(os.waitstatus_to_exitcode(status), peak))


def _become_reader(
    program: ModuleType, parent: int, folder: str, descriptors: list[int]
) -> NoReturn:
    """Answer in `folder`; the descriptors are the question, where the answer goes, and what is
    printed."""
    try:
        bind_to(parent)
        question, answer, printed = descriptors
        close_all_but(question, answer, printed=printed)
        os.chdir(folder)
        _answer(program, question, answer)
    finally:
        os._exit(1)


def _answer(program: ModuleType, question_from: int, answer_to: int) -> NoReturn:
    """Read the question, be confined, write the answer, and leave without the interpreter's
    farewell, which may crash on what was read."""
    with os.fdopen(question_from, "rb") as stream:
        question = decode(stream.read(), program.QUESTION)
    confine(question.seconds, question.memory)
    for chunk in encode(program.answer(question)):
        rest = chunk
        while rest:
            rest = rest[os.write(answer_to, rest) :]
    os._exit(0)


def close_all_but(*needed: int, printed: int | None = None) -> None:
    """Close everything that is not needed; what is printed goes to `printed`, or nowhere."""
    nowhere = os.open(os.devnull, os.O_RDWR)
    os.dup2(nowhere, 0)
    for stream in (1, 2):
        os.dup2(nowhere if printed is None else printed, stream)
    sys.stdout = sys.stderr = os.fdopen(2, "w", closefd=False)
    above = 3
    for descriptor in sorted(needed):
        os.closerange(above, descriptor)
        above = descriptor + 1
    os.closerange(above, os.sysconf("SC_OPEN_MAX"))


if __name__ == "__main__":
    main()
