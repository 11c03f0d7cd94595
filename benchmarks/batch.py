"""Throughput of batches: ``python benchmarks/batch.py RIG [RIG ...] [--count 40] [--timeout 120]``.

Makes `count` assets of the rigs named (the rigs themselves, and copies of other proportions), lays
them all out by one process, by two, and by two workers of a dask scheduler on this machine, and
prints assets per hour and the ratio to one process.  Layers of the three runs must be the same to
the byte.
"""

from __future__ import annotations

import argparse
import hashlib
import itertools
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from pxr import Usd, UsdGeom, UsdSkel


def main() -> int:
    """Print the table; returns 1 if an asset failed or two runs differ."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("rigs", nargs="+", type=Path)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--timeout", type=float, default=120.0, help="seconds for one asset")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        make_assets(arguments.rigs, arguments.count, folder / "assets")
        print(f"{arguments.count} assets of {len(arguments.rigs)} rigs, {os.cpu_count()} cores")
        print(
            "| where | seconds | assets/hour | ratio | written | refused or failed"
            " |\n|---|---|---|---|---|---|"
        )
        digests, base = set(), 0.0
        for name, options in (
            ("1 process", ["--jobs", "1"]),
            ("2 processes", ["--jobs", "2"]),
            ("dask, 2 workers", []),
        ):
            out = folder / "layouts"
            seconds, counts = run_batch(folder / "assets", out, options, arguments.timeout)
            base = base or seconds
            failed = counts["refused"] + counts["failed"]
            rate = 3600 * arguments.count / seconds
            row = (
                f"{seconds:.1f} | {rate:.0f} | {base / seconds:.2f} | {counts['written']} |"
                f" {failed}"
            )
            print(f"| {name} | {row} |", flush=True)
            digests.add(digest(out))
            if failed:
                return 1
            shutil.rmtree(out)
    print("the same bytes in every run" if len(digests) == 1 else "RUNS DIFFER")
    return int(len(digests) > 1)


def make_assets(rigs: Sequence[Path], count: int, folder: Path) -> None:
    """`count` files: each rig in turn, every round after the first 2 % taller and 1 % wider than
    the last."""
    folder.mkdir()
    for number, rig in zip(range(count), itertools.cycle(rigs), strict=False):
        layer = Usd.Stage.Open(str(rig)).Flatten()
        stage = Usd.Stage.Open(layer)
        grown = number // len(rigs)
        scale = np.array([1 + 0.01 * grown, 1 + 0.02 * grown, 1.0])
        for prim in stage.TraverseAll():
            if prim.IsA(UsdGeom.PointBased):
                _grow(UsdGeom.PointBased(prim).GetPointsAttr(), scale)
            if prim.IsA(UsdSkel.BlendShape):
                shape = UsdSkel.BlendShape(prim)
                inner = [each.GetAttr() for each in shape.GetInbetweens()]
                for attribute in (shape.GetOffsetsAttr(), *inner):
                    _grow(attribute, scale)
        layer.Export(str(folder / f"{number:02d}_{rig.stem}.usdc"))


def _grow(attribute: Usd.Attribute, scale: np.ndarray) -> None:
    value = attribute.Get()
    if value is not None and len(value):
        attribute.Set(type(value).FromNumpy((np.asarray(value) * scale).astype(np.float32)))


def run_batch(
    assets: Path, out: Path, options: list[str], timeout: float
) -> tuple[float, dict[str, int]]:
    """Seconds and counts of one `usdrigui batch`; on a cluster of its own if no `options` say
    where."""
    command = [
        sys.executable,
        "-m",
        "usdrigui",
        "batch",
        str(assets / "*.usdc"),
        "--output-dir",
        str(out),
        "--json",
    ]
    command += ["--bare", f"--timeout={timeout}"]
    if options:
        done = subprocess.run([*command, *options], capture_output=True, text=True, check=False)
    else:
        with cluster(assets.parent) as address:
            done = subprocess.run(
                [*command, "--dask", address], capture_output=True, text=True, check=False
            )
    told = json.loads(done.stdout)
    for row in told["assets"]:
        if row["exit"]:
            print(row["asset"], row["code"], row["message"], file=sys.stderr)
    return told["seconds"], told["counts"]


@contextmanager
def cluster(folder: Path) -> Iterator[str]:
    """Address of a dask scheduler with two workers of one thread each, on loopback."""
    started = []

    def start(module: str, *arguments: str) -> None:
        command = [sys.executable, "-m", f"distributed.cli.{module}", *arguments, "--no-dashboard"]
        silent = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        started.append(subprocess.Popen(command, start_new_session=True, **silent))

    where = folder / "scheduler.json"
    start("dask_scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(where))
    for number in range(2):
        own = ["--local-directory", str(folder / f"worker{number}"), "--host", "127.0.0.1"]
        start("dask_worker", "--scheduler-file", str(where), "--no-nanny", "--nthreads", "1", *own)
    try:
        deadline = time.monotonic() + 60
        while not where.exists() and time.monotonic() < deadline:
            time.sleep(0.1)
        time.sleep(5)  # the workers' registration is no part of the throughput
        yield json.loads(where.read_text())["address"]
    finally:
        for each in started:
            os.killpg(each.pid, signal.SIGKILL)
            each.wait()
        where.unlink(missing_ok=True)


def digest(folder: Path) -> str:
    """Digest of all layers of a folder."""
    found = sorted(folder.glob("*.usda"))
    return hashlib.sha256(
        b"".join(hashlib.sha256(each.read_bytes()).digest() for each in found)
    ).hexdigest()


if __name__ == "__main__":
    sys.exit(main())
