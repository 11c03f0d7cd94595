"""Time of direct manipulation: ``python benchmarks/posing.py [--controls 150] [--points 3] [ASSET]``.

Without an asset it makes a face-like sheet whose controls all act at the pulled points, the worst case
(locality would otherwise leave some 20 to 60 of them).  Prints the median and the 95th percentile of
`grab` and `solve` in milliseconds of processor time, how far the pulled points end from their targets, and how many
unbounded weights would have left their range.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np

from usdrigui.deform import posed, sweep
from usdrigui.model import Channel, Control, Drive, Rig, RigMesh, Shape
from usdrigui.pose.direct import Feel, grab, solve
from usdrigui.pose.reach import longest_paths


def sheet(controls: int, seed: int = 0) -> Rig:
    """A square sheet of 1 600 points; every control is a broad smooth bump in a direction of its own."""
    rng = np.random.default_rng(seed)
    x, y = np.meshgrid(np.linspace(-1, 1, 40), np.linspace(-1, 1, 40))
    points = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    shapes, made = [], []
    none = np.zeros(0, dtype=np.int64)
    still = np.zeros((2, 0, 3))
    for j in range(controls):
        centre, direction = rng.uniform(-0.4, 0.4, 2), rng.normal(size=3)
        fall = np.exp(-np.square(points[:, :2] - centre).sum(axis=1))
        offsets = (0.2 * fall[:, None] * direction).astype(np.float32)
        shapes.append(Shape(j, f"/S/m/s{j}", np.ones(1), np.arange(len(points)), offsets[None]))
        drive = Drive(np.array([0.0, 1.0]), np.array([j]), np.array([[0.0], [1.0]]), none, still, still, still)
        made.append(Control(f"c{j}", f"c{j}", "blendShape", f"c{j}", 0.0, 0.0, 1.0, "default", drive))
    mesh = RigMesh("/S/m", points, none, none, False, True, "none", np.eye(4), None, tuple(shapes), "sheet")
    channels = tuple(Channel(f"c{j}", "", -1) for j in range(controls))
    return Rig(
        "/S", (mesh,), (), (), channels, np.zeros(controls), tuple(made), None, np.array([0, 1.0, 0]), 1.0, (), ()
    )


def measure(rig: Rig, count: int, drags: int, feel: Feel) -> None:
    rng = np.random.default_rng(1)
    peaks = longest_paths(rig)
    low = np.array([control.minimum for control in rig.controls])
    high = np.array([control.maximum for control in rig.controls])
    base = posed(rig)
    moving = np.unique(np.concatenate([sweep(rig, base, j, high[j : j + 1])[0] for j in range(len(high))]))
    grabs, solves, missed, active, outside = [], [], [], [], []
    for _ in range(drags):
        start = low + (high - low) * np.where(rng.random(len(low)) < 0.2, rng.random(len(low)), 0.0)
        points = rng.choice(moving, count, replace=False).tolist()
        began = time.process_time()
        grip = grab(rig, start, points[:1], points[1:], peaks=peaks, feel=feel)
        grabs.append(time.process_time() - began)
        active.append(len(grip.controls))
        pull = rng.normal(size=3)
        for share in np.linspace(0.1, 1.0, 10):
            target = grip.positions[:1] + share * 0.7 * grip.length * pull / np.linalg.norm(pull)
            began = time.process_time()
            answer = solve(grip, target, np.array([0.0, 0.0, 1.0]))
            solves.append(time.process_time() - began)
        missed.append(np.linalg.norm((answer.reached[:1] - target)[:, :2]) / max(grip.length, 1e-30))
        outside.append(unbounded_outside(grip, target))
    for name, times in (("grab", grabs), ("solve", solves)):
        ms = 1e3 * np.array(times)
        print(f"{name:6} median {np.median(ms):6.2f} ms   95th percentile {np.percentile(ms, 95):6.2f} ms")
    print(f"controls taking part: median {np.median(active):.0f} of {len(rig.controls)}; points in hand: {count}")
    print(f"target missed in the picture plane by (of the longest path): median {np.median(missed):.3f}")
    print(f"weights that an unbounded solution would put outside their range: {100 * np.mean(outside):.0f} %")


def unbounded_outside(grip, target) -> float:
    """Share of the taking-part controls that leave their range without bounds, from rest."""
    rows = grip.paths.slopes(np.zeros(len(grip.cost))) / max(grip.length, 1e-30)
    wanted = np.zeros(grip.positions.shape)
    wanted[:1] = (target - grip.positions[:1]) / max(grip.length, 1e-30)
    x = np.linalg.solve(rows.T @ rows + np.diag(grip.cost), rows.T @ wanted.ravel())
    return float(((x < grip.low - 1e-3) | (x > grip.high + 1e-3)).mean()) if len(x) else 0.0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("asset", nargs="?", type=Path)
    parser.add_argument("--controls", type=int, default=150)
    parser.add_argument("--points", type=int, default=3)
    parser.add_argument("--drags", type=int, default=40)
    given = parser.parse_args()
    if given.asset is None:
        measure(sheet(given.controls), given.points, given.drags, Feel(locality=0.0))
        return
    from usdrigui.settings import Settings
    from usdrigui.usd.rig import read_rigs

    for rig in read_rigs(given.asset, Settings()):
        measure(rig, given.points, given.drags, Feel())


if __name__ == "__main__":
    main()
