"""The same layers on every processor: ``python benchmarks/processors.py [ASSET ...] [--rigs N] [--
OPTION ...]``.

Lays every asset out as other processors would: with OpenBLAS's kernels for them
(OPENBLAS_CORETYPE), without what numpy dispatches beyond its baseline (NPY_DISABLE_CPU_FEATURES),
and with the C library's plain functions (GLIBC_TUNABLES); prints one row per asset and one column
per processor, and returns 1 if two layers differ in a byte.  ``--rigs N`` adds a row of N valid
rigs from a seed (tests/valid), of 24 controls at most.  Kernels that this processor cannot run are
left out.  OPTIONs go to ``usdrigui process``.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

DISPATCHED = ",".join(np.show_config(mode="dicts")["SIMD Extensions"].get("found", []))
"""What numpy uses of this processor beyond what it needs of any."""
KERNELS = ("Haswell", "Zen", "SkylakeX", "SandyBridge", "Nehalem")
PLAIN = {
    "NPY_DISABLE_CPU_FEATURES": DISPATCHED,
    "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-AVX,-FMA,-AVX512F",
}
"""Numpy's baseline, and mathematical functions without fused multiplication."""


MANY = Path(__file__).resolve().parents[1] / "tests" / "valid" / "many_rigs.py"


def processors() -> dict[str, dict[str, str]]:
    """Environment by name of each processor that this one can stand for."""
    kernels = {name: {"OPENBLAS_CORETYPE": name} for name in KERNELS if _kernel(name)}
    return {
        "own": {},
        **kernels,
        "own, plain": PLAIN,
        "Nehalem, plain": {**kernels["Nehalem"], **PLAIN},
    }


def main() -> int:
    """Print the table; returns 1 if two layers of an asset differ, or if one could not be made."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("assets", nargs="*", type=Path)
    parser.add_argument(
        "--rigs", type=int, default=0, metavar="N", help="valid rigs from seeds 0 to N - 1"
    )
    end = sys.argv.index("--") if "--" in sys.argv else len(sys.argv)
    arguments, options = parser.parse_args(sys.argv[1:end]), sys.argv[end + 1 :]
    worlds = processors()
    print(
        f"own kernel: {_kernel('')}; Zen runs {_kernel('Zen')}'s; numpy dispatches"
        f" {DISPATCHED or 'nothing'}"
    )
    print(f"| asset | {' | '.join(worlds)} |\n|---|{'---|' * len(worlds)}")
    differs = False
    for asset in arguments.assets:
        layers = [layer(asset, world, options) for world in worlds.values()]
        cells = [
            "same" if each == layers[0] else difference(layers[0], each) for each in layers[1:]
        ]
        print(f"| {asset.stem} | {len(layers[0])} bytes | {' | '.join(cells)} |", flush=True)
        differs |= len(set(layers)) > 1
    if arguments.rigs:
        digests = [rig_digests(arguments.rigs, world) for world in worlds.values()]
        others = [
            [seed for seed, own in digests[0].items() if each.get(seed) != own]
            for each in digests[1:]
        ]
        cells = [f"differ: {', '.join(seeds)}" if seeds else "same" for seeds in others]
        print(
            f"| {arguments.rigs} valid rigs | {len(set(digests[0].values()))} layers |"
            f" {' | '.join(cells)} |"
        )
        differs |= any(others)
    print("LAYERS DIFFER" if differs else "the same bytes on every processor")
    return int(differs)


def layer(asset: Path, world: dict[str, str], options: list[str]) -> bytes:
    """The layer that `usdrigui process` writes in an environment; what it says where it writes
    none."""
    with tempfile.TemporaryDirectory() as folder:
        target = Path(folder) / "out.rigui.usda"
        command = [
            sys.executable,
            "-m",
            "usdrigui",
            "process",
            str(asset),
            "-o",
            str(target),
            "--bare",
            "--quiet",
        ]
        run = subprocess.run(
            [*command, *options], env={**os.environ, **world}, capture_output=True, check=False
        )
        return target.read_bytes() if target.exists() else run.stderr


def rig_digests(count: int, world: dict[str, str]) -> dict[str, str]:
    """A digest of the layer of each valid rig, by its seed, in an environment."""
    command = [sys.executable, str(MANY), "--small", "--digests", "--count", str(count)]
    run = subprocess.run(command, env={**os.environ, **world}, capture_output=True, check=False)
    return dict(json.loads(run.stdout)["layers"])


def difference(one: bytes, other: bytes) -> str:
    """The first line in which two layers differ, and how many do."""
    ours, theirs = one.decode().splitlines(), other.decode().splitlines()
    pairs = [(a.strip(), b.strip()) for a, b in zip(ours, theirs, strict=False) if a != b]
    first = " / ".join(each[:60] for each in pairs[0]) if pairs else "length"
    return f"{len(pairs)} of {len(ours)} lines: {first}"


def _kernel(name: str) -> str:
    """The kernel that OpenBLAS runs when asked for one; empty where this processor has none of
    it."""
    environment = {**os.environ, "OPENBLAS_VERBOSE": "2", "OPENBLAS_CORETYPE": name}
    run = subprocess.run(
        [sys.executable, "-c", "import numpy; numpy.eye(64) @ numpy.ones((64, 64))"],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    found = [
        line.removeprefix("Core: ") for line in run.stderr.splitlines() if line.startswith("Core: ")
    ]
    return found[0] if run.returncode == 0 and found else ""


if __name__ == "__main__":
    sys.exit(main())
