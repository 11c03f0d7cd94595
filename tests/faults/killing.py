"""Kill writers at random moments and see that the old or the new layer is there, complete.

    python tests/faults/killing.py --commits 5000     # the write alone, killed in a forked process

Prints one JSON document: how many kills met which state, and the faults.
"""

from __future__ import annotations

import argparse
import collections
import contextlib
import json
import os
import random
import signal
import sys
import tempfile
import time
from pathlib import Path

from usdrigui.replacing.transaction import commit

OLD, NEW = b"old\n" * 100_000, b"new\n" * 150_000


def kill_commits(count: int, folder: Path, seed: int = 0) -> dict[str, object]:
    """`commit` killed at random moments of its few milliseconds."""
    chance = random.Random(seed)
    target = folder / "char.rigui.usda"
    seen: collections.Counter[str] = collections.Counter()
    faults = []
    longest = _usual(target)
    for number in range(count):
        commit(OLD, target)
        pid = os.fork()
        if not pid:
            with contextlib.suppress(BaseException):
                commit(NEW, target)
            os._exit(0)
        time.sleep(chance.uniform(0, 1.2 * longest))
        os.kill(pid, signal.SIGKILL)
        _, status = os.waitpid(pid, 0)
        content = target.read_bytes()
        state = "new" if content == NEW else "old" if content == OLD else "torn"
        orphans = len(list(folder.iterdir())) - 1
        seen[f"{state}{', temporary left' if orphans else ''}{'' if os.WIFSIGNALED(status) else ', too late'}"] += 1
        if state == "torn":
            faults.append(f"kill {number}: torn")
        commit(OLD + b".", target)
        if len(list(folder.iterdir())) != 1:
            faults.append(f"kill {number}: not swept")
    return {"what": "commit", "kills": count, "states": dict(sorted(seen.items())), "faults": faults}


def _usual(target: Path) -> float:
    """Seconds of one commit in a process of its own."""
    taken = []
    for _ in range(5):
        commit(OLD, target)
        start = time.monotonic()
        pid = os.fork()
        if not pid:
            commit(NEW, target)
            os._exit(0)
        os.waitpid(pid, 0)
        taken.append(time.monotonic() - start)
    return sorted(taken)[2]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--commits", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        found = kill_commits(asked.commits, Path(place), asked.seed)
    print(json.dumps(found, indent=2))
    sys.exit(bool(found["faults"]))
