"""How long a crowded layout takes to author, write and read: ``python benchmarks/author_layer.py``.

A made-up face of 142 controls, each of whose anchors 40 shapes move: about the size of a
MetaHuman's. Prints processor seconds (best of three) and sizes.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

import laid_out
import makers

from usdrigui.layer.read_layout import read_layout
from usdrigui.layer.write_layout import layer_bytes, layer_for
from usdrigui.replacing.transaction import commit

CONTROLS, SHAPES = 142, 40


def crowded_face() -> Any:
    """A mask on which every point is moved by 40 of 142 shapes, and a random layout of it."""
    points, quads = makers.mask(65, 81)
    rng = np.random.default_rng(0)
    shapes = {}
    for control in range(CONTROLS):
        moved = (np.arange(len(points)) + control) % CONTROLS < SHAPES
        shapes[f"control{control}"] = moved[:, None] * rng.normal(size=(len(points), 3)) * 0.01
    rig = makers.rig(points, quads, shapes)
    layout = laid_out.layout_of(rig)
    return rig, replace(layout, frame=replace(layout.frame, handle_width=0.02))


def best(action: Callable[[], Any]) -> tuple[float, Any]:
    """Least processor seconds of three runs, and the last result."""
    seconds, result = [], None
    for _ in range(3):
        start = time.process_time()
        result = action()
        seconds.append(time.process_time() - start)
    return min(seconds), result


def main() -> None:
    rig, layout = crowded_face()
    seconds, layer = best(lambda: layer_for([(rig, layout)], "", {}))
    prims: list[Any] = []
    layer.Traverse("/", lambda path: prims.append(path) if path.IsPrimPath() else None)
    print(f"{len(layout.elements)} elements, {len(prims)} prims")
    print(f"author      {seconds:6.2f} s")
    with tempfile.TemporaryDirectory() as folder:
        for suffix in (".usda", ".usdc"):
            seconds, content = best(lambda suffix=suffix: layer_bytes(layer, suffix))
            target = Path(folder) / f"layout{suffix}"
            commit(content, target)
            print(f"to {suffix}    {seconds:6.2f} s  {len(content) / 1e6:.2f} MB")
            seconds, _ = best(lambda target=target: read_layout(target))
            print(f"read {suffix}  {seconds:6.2f} s")


if __name__ == "__main__":
    main()
