"""What layouts cost a stage: ``python benchmarks/layers.py LAYER [LAYER ...] [--against FOLDER] [--characters 10]``.

One row per layer: prims and bytes as text, seconds to open the stage and to play it, that is to bake the skinning of
24 made frames, alone and for a shot of several characters; each once without the layout (the variant ``rigUI = none``)
and once with it.  ``--against`` names a folder with layers of the same names, for example of the first format, that get
a row of their own.  Processor seconds, the better of two.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from pxr import Sdf, Usd, UsdSkel, Vt

_ROW = "{:<28} {:<5} {:>6} {:>6} {:>9} {:>9} {:>9} {:>9} {:>8}"
_FRAMES = 24


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("layers", nargs="+", type=Path)
    parser.add_argument("--against", type=Path, metavar="FOLDER")
    parser.add_argument("--characters", type=int, default=10)
    options = parser.parse_args()
    print(_ROW.format("layer", "", "prims", "MB", "open", "play", f"open x{options.characters}", "play", "more"))
    for layer in options.layers:
        old = options.against / layer.name if options.against else None
        source = Path(Sdf.Layer.FindOrOpen(str(layer)).ComputeAbsolutePath(
            Sdf.Layer.FindOrOpen(str(layer)).subLayerPaths[0]
        ))  # fmt: skip
        bare = measured(source, "", options.characters)
        for name, path, variant in (("old", old, ""), ("none", layer, "none"), ("ui", layer, "ui")):
            if path is not None and path.is_file():
                print_row(
                    layer.name if name != "ui" else "", name, path, measured(path, variant, options.characters), bare
                )


def print_row(title: str, name: str, layer: Path, found: tuple[float, ...], bare: tuple[float, ...]) -> None:
    count, size = prim_count(layer), len(Sdf.Layer.FindOrOpen(str(layer)).ExportToString())
    more = f"{100.0 * (found[3] + found[2] - bare[3] - bare[2]) / (bare[3] + bare[2]):+.0f} %"
    print(_ROW.format(title, name, count, f"{size / 1e6:.2f}", *(f"{each:.3f}" for each in found), more), flush=True)


def prim_count(layer: Path) -> int:
    """Prims of the layer itself, with overs."""
    found: list[Any] = []
    specs = Sdf.Layer.FindOrOpen(str(layer))
    specs.Traverse("/", lambda path: found.append(path) if path.IsPrimPath() else None)
    return len(found)


def measured(layer: Path, variant: str, characters: int) -> tuple[float, float, float, float]:
    """Seconds to open and to play one character, and the same for a shot of several."""
    with tempfile.TemporaryDirectory() as folder:
        single, several = (shot(Path(folder), layer, variant, count) for count in (1, characters))
        opened = [
            best(lambda path=path: Usd.Stage.Open(Sdf.Layer.OpenAsAnonymous(str(path)))) for path in (single, several)
        ]
        played = [best(lambda path=path: play(path)) for path in (single, several)]
    return opened[0], max(played[0] - opened[0], 0.0), opened[1], max(played[1] - opened[1], 0.0)


def shot(folder: Path, layer: Path, variant: str, count: int) -> Path:
    """A shot that references the character of a layer as often as asked, each with the variant selected."""
    stage = Usd.Stage.CreateNew(str(folder / f"shot{count}.usda"))
    asset = Usd.Stage.Open(str(layer))
    top = asset.GetDefaultPrim() or asset.GetPseudoRoot().GetAllChildren()[0]
    roots = [prim.GetPath() for prim in asset.Traverse() if prim.IsA(UsdSkel.Root)]
    for number in range(count):
        path = Sdf.Path(f"/Shot/hero{number}")
        prim = stage.DefinePrim(path)
        prim.GetReferences().AddReference(str(layer.resolve()), top.GetPath())
        for root in roots if variant else ():
            placed = stage.OverridePrim(root.ReplacePrefix(top.GetPath(), path))
            placed.GetVariantSet("rigUI").SetVariantSelection(variant)
    moving(stage)
    stage.GetRootLayer().Save()
    return folder / f"shot{count}.usda"


def moving(stage: Usd.Stage) -> None:
    """Weights that change at every frame."""
    stage.SetStartTimeCode(1)
    stage.SetEndTimeCode(_FRAMES)
    for prim in stage.Traverse():
        if prim.IsA(UsdSkel.Animation):
            weights = UsdSkel.Animation(prim).GetBlendShapeWeightsAttr()
            count = len(UsdSkel.Animation(prim).GetBlendShapesAttr().Get() or ())
            for frame in range(1, _FRAMES + 1) if count else ():
                weights.Set(Vt.FloatArray([((frame * (i + 3)) % 17) / 17.0 for i in range(count)]), frame)


def opened_stage(path: Path) -> Usd.Stage:
    return Usd.Stage.Open(Sdf.Layer.OpenAsAnonymous(str(path)))


def play(path: Path) -> None:
    """Open a shot and compute every frame of everything that UsdSkel deforms."""
    stage = opened_stage(path)
    for prim in list(stage.Traverse()):
        if prim.IsA(UsdSkel.Root):
            UsdSkel.BakeSkinning(UsdSkel.Root(prim))


def best(action: Callable[[], Any]) -> float:
    seconds = []
    for _ in range(2):
        start = time.process_time()
        action()
        seconds.append(time.process_time() - start)
    return min(seconds)


if __name__ == "__main__":
    main()
