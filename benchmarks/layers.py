"""What layouts cost a stage: ``python benchmarks/layers.py LAYER [LAYER ...] [--against FOLDER]
[--characters 10]``.

One row per layer: prims and bytes as text, seconds to open the stage and to play it, that is to
bake the skinning of made frames (``--frames 120``, five seconds), alone and for a shot of several
characters; without the layout (the variant ``rigUI = none``) and with it, and what each costs more
than the same shot of the source.  ``--against`` names a folder with layers of the same names, for
example of the first format, that get a row of their own.

Processor seconds.  All stages of a row take turns (``--rounds 7``), so that whatever else the
machine does meets all of them; the least of each counts, because other programs only ever add.  The
last column is by how much the two best rounds of the plain shot differ: what is below says nothing.
With PXR_WORK_THREAD_LIMIT=1 in the environment USD's threads do not wait for one another, which
counts as work too.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Gf, Sdf, Usd, UsdSkel, Vt

_ROW = "{:<28} {:<5} {:>6} {:>6} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8} {:>8}"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("layers", nargs="+", type=Path)
    parser.add_argument("--against", type=Path, metavar="FOLDER")
    parser.add_argument("--characters", type=int, default=10)
    parser.add_argument("--frames", type=int, default=120)
    parser.add_argument("--rounds", type=int, default=7)
    options = parser.parse_args()
    many = f"x{options.characters}"
    print(
        _ROW.format(
            "layer",
            "",
            "prims",
            "MB",
            "open",
            "play",
            f"open {many}",
            "play",
            "to play",
            "in all",
            "noise",
        )
    )
    for layer in options.layers:
        compare(layer, options)


def compare(layer: Path, options: argparse.Namespace) -> None:
    """Print the rows of one layer."""
    specs = Sdf.Layer.FindOrOpen(str(layer))
    source = Path(specs.ComputeAbsolutePath(specs.subLayerPaths[0]))
    stages = {"bare": (source, "")}
    if options.against and (options.against / layer.name).is_file():
        stages["old"] = (options.against / layer.name, "")
    stages |= {"none": (layer, "none"), "ui": (layer, "ui")}
    found = measured(stages, options)
    single, many = found[1], found[options.characters]
    seconds = {name: [min(each) for each in (*single[name].T, *many[name].T)] for name in stages}
    bare = seconds.pop("bare")
    best = np.sort(many["bare"].sum(axis=1))[:2]
    for name, each in seconds.items():
        path = stages[name][0]
        more = (
            each[3] / bare[3] - 1.0,
            (each[2] + each[3]) / (bare[2] + bare[3]) - 1.0,
            best[1] / best[0] - 1.0,
        )
        size = len(Sdf.Layer.FindOrOpen(str(path)).ExportToString())
        figures = (f"{value:.3f}" for value in each)
        shares = (f"{100.0 * value:+.1f} %" for value in more)
        print(
            _ROW.format(layer.name, name, prim_count(path), f"{size / 1e6:.2f}", *figures, *shares),
            flush=True,
        )


def prim_count(layer: Path) -> int:
    """Prims of the layer itself, with overs."""
    found: list[Any] = []
    specs = Sdf.Layer.FindOrOpen(str(layer))
    specs.Traverse("/", lambda path: found.append(path) if path.IsPrimPath() else None)
    return len(found)


def measured(
    stages: Mapping[str, tuple[Path, str]], options: argparse.Namespace
) -> dict[int, dict[str, np.ndarray]]:
    """By number of characters and stage, (rounds, 2) seconds to open and to play."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for count in (1, options.characters):
            shots = {
                name: shot(
                    Path(folder) / f"{name}{count}.usda", path, variant, count, options.frames
                )
                for name, (path, variant) in stages.items()
            }
            rounds = [
                {name: opened_and_played(path) for name, path in shots.items()}
                for _ in range(options.rounds)
            ]
            found[count] = {name: np.array([each[name] for each in rounds]) for name in shots}
    return found


def shot(path: Path, layer: Path, variant: str, count: int, frames: int) -> Path:
    """A shot that references the character of a layer as often as asked, each with the variant
    selected."""
    stage = Usd.Stage.CreateNew(str(path))
    asset = Usd.Stage.Open(str(layer))
    top = asset.GetDefaultPrim() or asset.GetPseudoRoot().GetAllChildren()[0]
    roots = [prim.GetPath() for prim in asset.Traverse() if prim.IsA(UsdSkel.Root)]
    for number in range(count):
        place = Sdf.Path(f"/Shot/hero{number}")
        prim = stage.DefinePrim(place)
        prim.GetReferences().AddReference(str(layer.resolve()), top.GetPath())
        for root in roots if variant else ():
            placed = stage.OverridePrim(root.ReplacePrefix(top.GetPath(), place))
            placed.GetVariantSet("rigUI").SetVariantSelection(variant)
    moving(stage, frames)
    stage.GetRootLayer().Save()
    return path


def moving(stage: Usd.Stage, frames: int) -> None:
    """Weights that change at every frame, and joints where nothing turns them."""
    stage.SetStartTimeCode(1)
    stage.SetEndTimeCode(frames)
    for prim in list(stage.Traverse()):
        if (
            prim.IsA(UsdSkel.Skeleton)
            and not UsdSkel.BindingAPI(prim).GetInheritedAnimationSource()
        ):
            rest = UsdSkel.Skeleton(prim).GetRestTransformsAttr().Get()
            motion = UsdSkel.Animation.Define(stage, prim.GetPath().AppendChild("motion"))
            motion.CreateJointsAttr(UsdSkel.Skeleton(prim).GetJointsAttr().Get())
            motion.SetTransforms(rest)
            UsdSkel.BindingAPI.Apply(prim).CreateAnimationSourceRel().SetTargets([motion.GetPath()])
    for prim in list(stage.Traverse()):
        if prim.IsA(UsdSkel.Animation):
            animate(UsdSkel.Animation(prim), frames)


def animate(animation: UsdSkel.Animation, frames: int) -> None:
    """Other weights at every frame; other rotations where there is one for all frames."""
    count = len(animation.GetBlendShapesAttr().Get() or ())
    still = list(animation.GetRotationsAttr().Get(Usd.TimeCode.EarliestTime()) or ())
    turning = animation.GetRotationsAttr().GetNumTimeSamples() > 1
    for frame in range(1, frames + 1):
        if count:
            weights = Vt.FloatArray([((frame * (i + 3)) % 17) / 17.0 for i in range(count)])
            animation.GetBlendShapeWeightsAttr().Set(weights, frame)
        if still and not turning:
            turn = Gf.Quatf(Gf.Rotation((1, 0, 0), frame % 17).GetQuat())
            animation.GetRotationsAttr().Set([turn * each for each in still], frame)


def opened_and_played(path: Path) -> tuple[float, float]:
    """Seconds to open a shot, and to compute every frame of everything that UsdSkel deforms."""
    start = time.process_time()
    stage = Usd.Stage.Open(Sdf.Layer.OpenAsAnonymous(str(path)))
    opened = time.process_time()
    for prim in list(stage.Traverse()):
        if prim.IsA(UsdSkel.Root):
            UsdSkel.BakeSkinning(UsdSkel.Root(prim))
    return opened - start, time.process_time() - opened


if __name__ == "__main__":
    main()
