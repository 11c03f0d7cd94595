"""Feed damaged files to `usdrigui process` and see that every end is one that the documentation knows.

    python tests/fuzz/fuzz.py --format usdc --count 10000

The command runs in this process, as `usdrigui.cli.main`.  Files that find a fault are kept in `--keep`.
Prints one JSON document: how the runs ended, and the faults.
"""

from __future__ import annotations

import argparse
import collections
import json
import os
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import mutations
from captured import called, captured
from pxr import Sdf

from usdrigui.errors import Exit, catalogue

SECONDS = 10.0
"""Limit on reading one file."""
_MEMORY = "/dev/shm" if Path("/dev/shm").is_dir() else None
"""Where syncing costs nothing."""
_DOCUMENTED = {int(each) for each in Exit} - {int(Exit.BUG)}
_SETTINGS = (f"read.time_limit={SECONDS}", "read.memory_limit=1024", "solve.work_limit=20000")


@dataclass(frozen=True)
class End:
    """How one run ended."""

    exit_code: int
    code: str
    """Of the issue that ended it; empty if none did."""
    seconds: float
    faults: tuple[str, ...]
    """What should not have happened."""


def seeds(folder: Path) -> dict[str, bytes]:
    """Small sound characters that have all that a character can have, as text and as crate."""
    sys.path += [str(Path(__file__).parents[1] / each) for each in ("", "valid")]
    import skel_stages
    import skinned_stages
    from written_rigs import write_rig

    makers = {
        "all": skel_stages.character,
        "head": skel_stages.head,
        "face": skinned_stages.character,
        "written": lambda path: write_rig(6, path.parent).rename(path),
    }
    found = {}
    for name, make in makers.items():
        path = make(folder / f"{name}.usda")
        Sdf.Layer.FindOrOpen(str(path)).Export(str(folder / f"{name}.usdc"))
        for form in ("usda", "usdc"):
            found[f"{name}.{form}"] = (folder / f"{name}.{form}").read_bytes()
    return found


def run(content: bytes, form: str, folder: Path) -> End:
    """Process one file in an empty folder, and look at everything that is left."""
    source, target = folder / f"char.{form}", folder / "out.usda"
    source.write_bytes(content)
    arguments = ["process", str(source), "-o", str(target), "--json", "--quiet"]
    for setting in _SETTINGS:
        arguments += ["--set", setting]
    start, before = time.monotonic(), time.process_time()
    with captured() as printed:
        exit_code, escaped = called(arguments)
    seconds, used = time.monotonic() - start, time.process_time() - before
    out, err = printed
    faults = list(escaped)
    code = _code(out, exit_code, faults)
    if b"Traceback" in out + err:
        faults.append("a traceback")
    if seconds > SECONDS + 2 and code == "SOURCE_TIME_LIMIT":
        faults.append(f"{seconds:.1f} s")
    if used > SECONDS + 2:  # Of this process alone; time that it was stopped for does not count.
        faults.append(f"{used:.1f} s of processor time after reading")
    if code == "SOURCE_READER_LOST":
        faults.append(f"the reader was lost: {json.loads(out)['issues'][0]['message']}")
    if source.read_bytes() != content:
        faults.append("the source was changed")
    left = {each.name for each in folder.iterdir()} - {source.name}
    if left != ({target.name} if exit_code == 0 else set()):
        faults.append(f"files left: {sorted(left)}")
    for each in folder.iterdir():
        each.unlink()
    return End(exit_code, code, seconds, tuple(faults))


def _code(out: bytes, exit_code: int, faults: list[str]) -> str:
    """The code that the printed report gives, after checking that the report is one."""
    try:
        document = json.loads(out)
        issues = document["issues"]
        code = str(issues[0]["code"]) if exit_code else ""
    except (ValueError, KeyError, IndexError) as error:
        faults.append(f"the report is none: {error}")
        return ""
    if exit_code not in _DOCUMENTED:
        faults.append(f"exit {exit_code}: {issues[0]['message'] if issues else ''}")
    if document["exit"] != exit_code or any(each["code"] not in catalogue() for each in issues):
        faults.append("exit or issue code are not the documented ones")
    if code and not issues[0]["repair"]:
        faults.append("no word on how to repair it")
    return code


def campaign(form: str, numbers: range, seed: int, keep: Path | None) -> dict[str, object]:
    """Run many; returns the figures."""
    ends: collections.Counter[str] = collections.Counter()
    faulty, slowest = [], 0.0
    with tempfile.TemporaryDirectory(dir=_MEMORY, prefix="fuzz-") as place:
        grounds = Path(place) / "run"
        grounds.mkdir()
        stock = seeds(Path(place))
        current = (keep or Path(place)) / f"running-{os.getpid()}.{form}"
        for number in numbers:
            content = mutations.mutant(form, stock, number, seed)
            current.write_bytes(content)  # Should this very process die of it.
            end = run(content, form, grounds)
            ends[f"{end.exit_code} {end.code}".strip()] += 1
            slowest = max(slowest, end.seconds)
            if number % 100 == 99:
                print(f"{form} {number + 1 - numbers.start}: {len(faulty)} faults", file=sys.stderr)
            if end.faults:
                faulty.append({"number": number, "faults": end.faults, "bytes": len(content)})
                if keep is not None:
                    (keep / f"fault-{form}-{seed}-{number}.{form}").write_bytes(content)
        current.unlink()
    return {"format": form, "count": len(numbers), "seed": seed, "ends": dict(sorted(ends.items())),
            "slowest_seconds": round(slowest, 2), "faults": faulty}  # fmt: skip


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--format", choices=("usda", "usdc", "usdz"), required=True)
    parser.add_argument("--count", type=int, default=150)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=Path, help="folder for the files that find a fault")
    asked = parser.parse_args()
    if asked.keep:
        asked.keep.mkdir(parents=True, exist_ok=True)
    span = range(asked.first, asked.first + asked.count)
    found = campaign(asked.format, span, asked.seed, asked.keep)
    print(json.dumps(found, indent=2))
    sys.exit(bool(found["faults"]))
