"""Lay out, check and view many valid rigs, and see that no end is a bug.

    python tests/valid/many_rigs.py --count 1000

The commands run in this process, as `usdrigui.cli.main`.
Prints one JSON document: how each command ended and every end that is not exit 0.  With ``--digests`` the rigs are only
laid out, and a digest of every layer is told, by which processors are compared (benchmarks/processors.py).  Rigs are
made again from their seed: ``--first SEED --count 1 --keep FOLDER``.
"""

from __future__ import annotations

import argparse
import collections
import hashlib
import json
import sys
import tempfile
import time
from pathlib import Path

if __name__ == "__main__":
    sys.path += [str(Path(__file__).parents[1] / each) for each in ("", "fuzz")]

from captured import called, captured
from valid_rigs import COUNTS, SMALL, make_rig

_SETTINGS = ("solve.work_limit=2000", "solve.time_limit=20")
"""The search for the best layout ends early: every other stage is as always."""


def commands(asset: Path, layer: Path, page: Path) -> dict[str, list[str]]:
    """Arguments of every command that a rig is put through."""
    return {
        "process": ["process", str(asset), "-o", str(layer), "--quiet"],
        "check": ["check", str(layer)],
        "view": ["view", str(layer), "--html", str(page)],
    }


def run(asset: Path, most: int) -> dict[str, tuple[int, str]]:
    """Exit code and first words of the first `most` commands on a rig, as far as one gets."""
    ends = {}
    wanted = commands(asset, asset.with_suffix(".rigui.usda"), asset.with_suffix(".html"))
    for name, arguments in list(wanted.items())[:most]:
        settings = [each for setting in _SETTINGS for each in ("--set", setting)]
        with captured() as printed:
            code, escaped = called([*arguments, *settings])
        words = printed[1].decode(errors="replace").strip().splitlines()
        ends[name] = code, " ".join([*escaped, *words[:1]]) if code else ""
        if code:
            break
    return ends


def digest(layer: Path) -> str:
    """Of a layer; empty where there is none."""
    return hashlib.blake2b(layer.read_bytes(), digest_size=8).hexdigest() if layer.exists() else ""


def campaign(seeds: range, counts: tuple[int, ...], keep: Path | None, most: int = 3) -> dict[str, object]:
    """Run many; returns the figures."""
    digests: dict[int, str] = {}
    tally: collections.Counter[str] = collections.Counter()
    others, slowest = [], (0.0, -1)
    with tempfile.TemporaryDirectory() as place:
        for seed in seeds:
            start = time.monotonic()
            asset = make_rig(seed, (keep or Path(place)) / f"rig{seed}.usdc", counts)
            found = run(asset, most)
            digests[seed] = digest(asset.with_suffix(".rigui.usda"))
            slowest = max(slowest, (round(time.monotonic() - start, 1), seed))
            tally.update(f"{name}: exit {code}" for name, (code, _) in found.items())
            others += [{"seed": seed, "command": name, "said": said} for name, (code, said) in found.items() if code]
            for each in () if keep else Path(place).iterdir():
                each.unlink()
            if seed % 50 == 49:
                print(f"{seed + 1 - seeds.start} rigs: {dict(tally)}", file=sys.stderr, flush=True)
    return {
        "rigs": len(seeds),
        "ends": dict(sorted(tally.items())),
        "slowest": slowest,
        "not exit 0": others,
        "layers": digests,
    }


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--small", action="store_true", help="24 controls at most")
    parser.add_argument("--digests", action="store_true", help="only lay out, and tell a digest of every layer")
    parser.add_argument("--keep", type=Path, help="an existing folder for the rigs, layers and pages")
    asked = parser.parse_args()
    span = range(asked.first, asked.first + asked.count)
    found = campaign(span, SMALL if asked.small else COUNTS, asked.keep, 1 if asked.digests else 3)
    if not asked.digests:
        del found["layers"]
    print(json.dumps(found, indent=2))
    sys.exit(any("exit 5" in end or "exit -1" in end for end in found["ends"]))
