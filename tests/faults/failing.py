"""Let the n-th call of everything that can fail fail, n counted up, and see that every end is one that is documented.

    python tests/faults/failing.py                 # every call of every kind, in all commands
    python tests/faults/failing.py --every 25      # one call in 25

A forked process runs the command as a worker does, with one call that raises: writes, renames, locks, files that are
opened and made, pipes and processes that are started (OSError: no space, or a device that fails), arrays that are made
(MemoryError).  Afterwards every file holds what it held or what it was to hold, the exit code is a documented one and
no bug, and nothing else is left in the folder, but for what could not be removed, which the next run removes.
Prints one JSON document: how the runs ended, and the faults.
"""

from __future__ import annotations

import argparse
import collections
import contextlib
import errno
import io
import json
import os
import sys
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import minimal_assets
import numpy as np

from usdrigui.cli import main
from usdrigui.isolation import forking
from usdrigui.replacing import temporaries

KINDS: dict[str, tuple[Any, str, Callable[[], BaseException]]] = {
    **{
        f"os.{name}: {what}": (os, name, lambda number=number: OSError(number, os.strerror(number)))
        for name, number, what in (
            ("write", errno.ENOSPC, "no space"),
            ("open", errno.ENOSPC, "no space"),
            ("open", errno.EMFILE, "too many files"),
            ("fsync", errno.EIO, "the device fails"),
            ("replace", errno.EIO, "the device fails"),
            ("rename", errno.EIO, "the device fails"),
            ("unlink", errno.EIO, "the device fails"),
            ("link", errno.EMLINK, "too many names"),
            ("fchmod", errno.EPERM, "not permitted"),
            ("fstat", errno.EIO, "the device fails"),
            ("pipe", errno.EMFILE, "too many files"),
            ("fork", errno.EAGAIN, "too many processes"),
            ("fdopen", errno.ENOMEM, "no memory"),
            ("read", errno.EIO, "the device fails"),
        )
    },
    "fcntl.flock: the device fails": (temporaries.fcntl, "flock", lambda: OSError(errno.EIO, "the device fails")),
    "a thread: too many": (threading.Thread, "start", lambda: RuntimeError("can't start new thread")),
    "a socket: too many files": (forking.socket, "socketpair", lambda: OSError(errno.EMFILE, "too many files")),
    "a temporary file: no space": (tempfile, "TemporaryFile", lambda: OSError(errno.ENOSPC, "no space")),
    **{
        f"numpy.{name}: no memory": (np, name, MemoryError)
        for name in ("empty", "zeros", "full", "concatenate", "array", "stack", "zeros_like", "frombuffer")
    },
}
COMMANDS = {
    "process": ["process", "char.usda", "-o", "out.usda", "--report", "report.json", "--quiet"],
    "attach": ["attach", "char.usda", "bare.usda", "--quiet"],
    "detach": ["detach", "attached.usda", "bare.usda", "--quiet"],
}


def prepare(folder: Path, make: Callable[[Path], object]) -> None:
    """A character, ``char.usda``, with a layout, attached and beside it, and outputs of an earlier day."""
    make(folder)
    with contextlib.chdir(folder), contextlib.redirect_stdout(sys.stderr):
        assert main(["process", "char.usda", "--bare", "-o", "bare.usda", "--quiet"]) == 0
        Path("attached.usda").write_bytes(Path("char.usda").read_bytes())
        assert main(["attach", "attached.usda", "bare.usda", "--quiet"]) == 0
        Path("out.usda").write_bytes(Path("bare.usda").read_bytes())
        Path("report.json").write_text("of an earlier day")


def content(folder: Path) -> dict[str, Any]:
    """Of every file; of a report all but its times."""
    held: dict[str, Any] = {path.name: path.read_bytes() for path in folder.iterdir()}
    with contextlib.suppress(ValueError):
        held["report.json"] = _without_times(json.loads(held["report.json"]))
    return held


def _without_times(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _without_times(item) for name, item in value.items() if name != "seconds"}
    return [_without_times(item) for item in value] if isinstance(value, list) else value


def run(command: str, kind: str, number: int, folder: Path) -> dict[str, Any]:
    """How the command ends when the call of this number fails; `met` is whether there was one."""
    read_end, write_end = os.pipe()
    child = os.fork()
    if not child:
        with os.fdopen(write_end, "w") as answer:
            os.chdir(folder)
            json.dump(_ended(COMMANDS[command], kind, number), answer)
        os._exit(0)
    os.close(write_end)
    with os.fdopen(read_end) as answer:
        text = answer.read()
    os.waitpid(child, 0)
    return json.loads(text) if text else {"code": "none", "said": "", "met": True}


def _ended(arguments: list[str], kind: str, number: int) -> dict[str, Any]:
    forking.worker.active = lambda: True  # readers are forked as a worker forks them
    forking._parents.clear()
    out, err = io.StringIO(), io.StringIO()
    with _failing(kind, number) as calls, contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main(arguments)
    return {"code": code, "said": out.getvalue() + err.getvalue(), "met": len(calls) >= number}


@contextlib.contextmanager
def _failing(kind: str, number: int) -> Iterator[list[str]]:
    owner, name, error = KINDS[kind]
    real, calls, mine = getattr(owner, name), [], os.getpid()

    def call(*arguments: Any, **named: Any) -> Any:
        if os.getpid() == mine:
            calls.append(name)
            if len(calls) == number:
                raise error()
        return real(*arguments, **named)

    setattr(owner, name, call)
    try:
        yield calls
    finally:
        setattr(owner, name, real)


def faults(end: dict[str, Any], folder: Path, before: dict[str, Any], after: dict[str, Any]) -> Iterator[str]:
    """What is wrong with an end, whose folder held `before` and holds `after` if nothing fails."""
    if end["code"] not in (0, 1, 2, 3, 4):
        yield f"exit {end['code']}"
    if "Traceback" in end["said"]:
        yield "a traceback"
    temporaries.sweep(folder)
    found = content(folder)
    if litter := found.keys() - after.keys():
        yield f"left {sorted(litter)}"
    torn = [name for name in after if found.get(name) not in (before[name], after[name])]
    if torn:
        yield f"torn {torn}"
    if end["code"] == 0 and found != after:
        yield "exit 0 without what it was to write"


def campaign(
    every: int,
    commands: Iterable[str] = tuple(COMMANDS),
    make: Callable[[Path], object] = minimal_assets.character,
) -> dict[str, Any]:
    """All kinds, one call in `every`, from the first of each, on the character that `make` writes into a folder."""
    ends: collections.Counter[str] = collections.Counter()
    faulty = []
    for command in commands:
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place)
            prepare(folder, make)
            before = content(folder)
            held = {path.name: path.read_bytes() for path in folder.iterdir()}
            run(command, "os.fork: too many processes", 1 << 30, folder)
            after = content(folder)
            assert after != before
            for kind in KINDS:
                number, met = 1, True
                while met:
                    for name, text in held.items():
                        (folder / name).write_bytes(text)
                    end = run(command, kind, number, folder)
                    met = end["met"]
                    ends[f"exit {end['code']}"] += met
                    faulty += [
                        {"command": command, "kind": kind, "call": number, "fault": fault, "said": end["said"][-300:]}
                        for fault in faults(end, folder, before, after)
                    ]
                    number += every
    return {"ends": dict(sorted(ends.items())), "faults": faulty}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--every", type=int, default=1)
    figures = campaign(parser.parse_args().every)
    print(json.dumps(figures, indent=2))
    sys.exit(bool(figures["faults"]))
