"""Processes of a test: waiting for them, and those that they have started."""

import contextlib
import subprocess
import sys
import time
from pathlib import Path


def until(question, seconds=30.0):
    """The first answer that is true, or nothing empty."""
    end = time.monotonic() + seconds
    while not (found := question()):
        assert time.monotonic() < end, "waited too long"
        time.sleep(0.02)
    return found


def children_of(*processes):
    """Numbers of the processes that these have started and that are still listed."""
    parents = ",".join(map(str, processes))
    found = subprocess.run(["ps", "-o", "pid=", "--ppid", parents], capture_output=True, text=True, check=False)
    return [int(each) for each in found.stdout.split()]


def impostor(folder, monkeypatch, script):
    """Have a shell script run instead of Python, as each process that is not a reader; its file."""
    monkeypatch.setattr("usdrigui.isolation.supervising.FORKS", False)
    path = folder / "python"
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(path))
    return path


def gone(*processes):
    """Whether none of these runs any more; one that nobody has waited for yet has ended, too."""

    def ended(process):
        with contextlib.suppress(OSError):
            return " Z " in Path(f"/proc/{process}/stat").read_text()
        return True

    return all(map(ended, processes))
