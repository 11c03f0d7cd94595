"""Kill writers at random moments and see that the old or the new layer is there, complete.

    python tests/faults/killing.py --commits 5000     # the write alone, killed in a forked process
    python tests/faults/killing.py --commands 100     # the whole command, killed as a user's would be

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
import subprocess
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


def kill_commands(count: int, folder: Path, seed: int = 0) -> dict[str, object]:
    """`usdrigui process` killed at random moments around its end, where the write is."""
    sys.path.append(str(Path(__file__).parents[1]))
    import skel_stages

    chance = random.Random(seed)
    source = skel_stages.head(folder / "char.usda")
    target = folder / "char.rigui.usda"
    command = [sys.executable, "-m", "usdrigui", "process", str(source), "--quiet"]
    start = time.monotonic()
    subprocess.run([*command, "--set", "objective.overlap_max=1.0"], check=True, stdout=subprocess.DEVNULL)
    old = target.read_bytes()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    usual = (time.monotonic() - start) / 2
    new, asset = target.read_bytes(), source.read_bytes()
    assert old != new
    seen: collections.Counter[str] = collections.Counter()
    faults = []
    for number in range(count):
        target.write_bytes(old)
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            time.sleep(usual * chance.uniform(0.7, 1.1))
            process.kill()
        usual *= 1.05 if process.returncode < 0 else 0.9
        content = target.read_bytes()
        state = "new" if content == new else "old" if content == old else "torn"
        seen[state if process.returncode < 0 else f"{state}, too late"] += 1
        if state == "torn" or source.read_bytes() != asset:
            faults.append(f"kill {number}: {state}")
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    left = {each.name for each in folder.iterdir()} - {source.name, target.name}
    if left:
        faults.append(f"left: {sorted(left)}")
    return {"what": "command", "kills": count, "states": dict(sorted(seen.items())), "faults": faults}


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
    parser.add_argument("--commits", type=int, default=0)
    parser.add_argument("--commands", type=int, default=0)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        found = (
            kill_commands(asked.commands, Path(place), asked.seed)
            if asked.commands
            else kill_commits(asked.commits, Path(place), asked.seed)
        )
    print(json.dumps(found, indent=2))
    sys.exit(bool(found["faults"]))
