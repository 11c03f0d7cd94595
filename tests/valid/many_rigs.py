"""Lay out, check and view many valid rigs, and see that no end is a bug.

    python tests/valid/many_rigs.py --count 1000
    python tests/valid/many_rigs.py --count 1000 --written

The points of a rig are those of UsdSkel's queries at random poses; it is laid out, made into a page and checked, and
`check` finds of the flattened stage what it finds of the composed one.  The commands run in this process, as
`usdrigui.cli.main`.  Prints one JSON document: how each step ended and every end that is not exit 0.  With
``--digests`` the rigs are only laid out, and a digest of every layer is told, by which processors are compared
(benchmarks/processors.py).  Rigs are made again from their seed: ``--first SEED --count 1 --keep FOLDER``.
"""

from __future__ import annotations

import argparse
import collections
import hashlib
import json
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path

if __name__ == "__main__":
    sys.path += [str(Path(__file__).parents[1] / each) for each in ("", "fuzz")]

import numpy as np
from captured import called, captured
from pxr import Usd
from usdskel_oracle import Oracle
from valid_rigs import COUNTS, SMALL, make_rig
from written_rigs import write_rig

from usdrigui.character.deform import channel_state, deform
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

_SETTINGS = ("--set", "solve.work_limit=2000", "--set", "solve.time_limit=20")
"""The search for the best layout ends early: every other stage is as always."""


def ends(asset: Path) -> Iterator[tuple[str, int, str]]:
    """What is done with a rig, each with its exit code and what was said."""
    layer = asset.with_suffix(".rigui.usda")
    yield "process", *run("process", asset, "-o", layer, "--quiet")
    yield "view", *run("view", layer, "--html", asset.with_suffix(".html"))
    flat = asset.with_suffix(".flat.usda")
    Usd.Stage.Open(str(layer)).Flatten().Export(str(flat))
    composed, flattened = (run("check", each, "--json") for each in (layer, flat))
    yield "check", *composed
    found = [sorted((i["code"], i["path"]) for i in json.loads(said)["issues"]) for _, said in (composed, flattened)]
    yield "check flattened", flattened[0] if found[0] == found[1] else -1, f"{found}"
    apart = max(map(_apart, [asset] * 9, read_rigs(asset, Settings())))
    yield "deform", 0 if apart < 1e-4 else -1, f"{apart:.2g} of its size beside UsdSkel"


def run(*arguments: object) -> tuple[int, str]:
    """Exit code and what a command says."""
    with captured() as printed:
        code, escaped = called([*map(str, arguments), *_SETTINGS])
    return code, " ".join([*escaped, b"".join(printed).decode(errors="replace")])


def _apart(asset: Path, rig) -> float:
    """How far our points are from UsdSkel's at random poses, at most, as a share of the size of their mesh."""
    rng, oracle, worst = np.random.default_rng(0), Oracle(asset, rig), 0.0
    for _ in range(3):
        values = [rng.uniform(control.minimum, control.maximum) for control in rig.controls]
        pair = deform(rig, values), oracle.deformed(*channel_state(rig, values))
        for ours, theirs in zip(*(np.split(points, rig.body.starts[1:-1]) for points in pair), strict=True):
            worst = max(worst, float(np.abs(ours - theirs).max() / max(np.abs(theirs).max(), 1e-9)))
    return worst


def digest(layer: Path) -> str:
    """Of a layer; empty where there is none."""
    return hashlib.blake2b(layer.read_bytes(), digest_size=8).hexdigest() if layer.exists() else ""


def campaign(seeds: range, make: Callable[[int, Path], Path], keep: Path | None, *, digests: bool) -> dict[str, object]:
    """Run many, or only lay them out; returns the figures."""
    layers: dict[int, str] = {}
    tally: collections.Counter[str] = collections.Counter()
    others, slowest = [], (0.0, -1)
    for seed in seeds:
        start = time.monotonic()
        with tempfile.TemporaryDirectory() as place:
            asset = make(seed, keep or Path(place))
            for name, code, said in ends(asset):
                tally[f"{name}: exit {code}"] += 1
                if code:
                    others.append({"seed": seed, "command": name, "said": said[-1500:]})
                if code or digests:
                    break
            layers[seed] = digest(asset.with_suffix(".rigui.usda"))
        slowest = max(slowest, (round(time.monotonic() - start, 1), seed))
        if seed % 50 == 49:
            print(f"{seed + 1 - seeds.start} rigs: {dict(tally)}", file=sys.stderr, flush=True)
    return {
        "rigs": len(seeds),
        "ends": dict(sorted(tally.items())),
        "slowest": slowest,
        "not exit 0": others,
        **({"layers": layers} if digests else {}),
    }


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--small", action="store_true", help="24 controls at most")
    parser.add_argument("--written", action="store_true", help="characters as plain text, of another structure")
    parser.add_argument("--digests", action="store_true", help="only lay out, and tell a digest of every layer")
    parser.add_argument("--keep", type=Path, help="an existing folder for the rigs, layers and pages")
    asked = parser.parse_args()
    counts = SMALL if asked.small else COUNTS
    found = campaign(
        range(asked.first, asked.first + asked.count),
        write_rig if asked.written else lambda seed, folder: make_rig(seed, folder / f"rig{seed}.usdc", counts),
        asked.keep,
        digests=asked.digests,
    )
    print(json.dumps(found, indent=2))
    sys.exit(any("exit 5" in end or "exit -1" in end for end in found["ends"]))
