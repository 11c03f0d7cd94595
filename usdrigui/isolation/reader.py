"""The reader's side of `usdrigui.isolation.reading`: one question, one answer, and nothing
else that a process could do.

A *program* is a module that knows how to answer and imports all that it needs: `QUESTION` is the
class of what it is asked, `answer` gives the record that goes back.
"""

from __future__ import annotations

import importlib
import os
import sys
from typing import NoReturn, Protocol

from usdrigui.isolation.confinement import confine
from usdrigui.isolation.forking import serve
from usdrigui.isolation.record_stream import decode, encode


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
    """``python -P -m usdrigui.isolation.reader PROGRAM``: a warm parent of readers where standard
    input is a socket, else a reader of the question that it holds."""
    importlib.import_module(sys.argv[1])
    if sys.argv[2:] == ["warm"]:
        serve(lambda: read(sys.argv[1]))
    read(sys.argv[1])


def read(name: str) -> NoReturn:
    """Take the question from standard input, be confined, write the answer of the program of this
    name to standard output, and leave without the interpreter's farewell, which may crash on what
    was read."""
    answer_to, program = os.dup(1), importlib.import_module(name)
    os.dup2(2, 1)
    with os.fdopen(0, "rb") as stream:
        question = decode(stream.read(), program.QUESTION)
    confine(question.seconds, question.memory)
    with os.fdopen(answer_to, "wb") as stream:
        stream.writelines(encode(program.answer(question)))
    os._exit(0)


if __name__ == "__main__":
    main()
