"""What layouts cost a stage: ``python benchmarks/layers.py LAYER [LAYER ...] [--against FOLDER]
[--characters 10]``.

One row per layer: prims and bytes as text, seconds to open the stage and to play it, that is to
bake the skinning of made frames (``--frames 120``, five seconds), alone and for a shot of several
characters; without the layout (the variant ``rigUI = none``) and with it, and what both together
cost more than the same shot of the source, for one character and for several.  ``p none`` and
``p ui`` are the same of the layout as ``usdrigui attach --payload`` puts it into the asset.
``--against`` names a folder with layers of the same names that get a row of their own.

Layers are opened as crates, as shots have them (as text they take 1 to 17 ms more to open).
Processor seconds of one thread; medians.  All stages of a row take turns, in another order each
time, so that whatever else the machine does meets all of them, and each is compared with the source
of its own round.  The source plays along once more under another name: what the row ``again`` shows
is noise.  A row takes ``--rounds 15`` rounds at least, and ``--seconds 30``.
"""

from __future__ import annotations

import argparse
import os
import shutil
import tempfile
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

os.environ["PXR_WORK_THREAD_LIMIT"] = "1"  # threads that wait for one another count as work

import numpy as np
from pxr import Gf, Sdf, Usd, UsdSkel, UsdUtils, Vt

from usdrigui.clients.attaching.attach import attach
from usdrigui.settings import Settings

_ROW = "{:<28} {:<6} {:>6} {:>6} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7}"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("layers", nargs="+", type=Path)
    parser.add_argument("--against", type=Path, metavar="FOLDER")
    parser.add_argument("--characters", type=int, default=10)
    parser.add_argument("--frames", type=int, default=120)
    parser.add_argument("--rounds", type=int, default=15)
    parser.add_argument("--seconds", type=float, default=30.0)
    options = parser.parse_args()
    many = f"x{options.characters}"
    titles = ("open", "play", f"open {many}", "play", "more", f"more {many}", "rounds")
    print(_ROW.format("layer", "", "prims", "MB", *titles))
    for layer in options.layers:
        compare(layer, options)


def compare(layer: Path, options: argparse.Namespace) -> None:
    """Print the rows of one layer."""
    source = source_of(layer)
    stages = {"source": (source, ""), "again": (source, "")}
    if options.against and (options.against / layer.name).is_file():
        stages["old"] = (options.against / layer.name, "")
    stages |= {"none": (layer, "none"), "ui": (layer, "ui")}
    with tempfile.TemporaryDirectory() as folder:
        attached = with_layer_in_variant(layer, Path(folder))
        shots = {"p none": (attached, "none"), "p ui": (attached, "ui")}
        found = measured(stages | shots, options)
    for name in found[0]:
        path, _ = stages[name.removeprefix("p ")]
        size = len(Sdf.Layer.FindOrOpen(str(path)).ExportToString())
        counts = ("", "") if path == source else (prim_count(path), f"{size / 1e6:.2f}")
        seconds = [each for taken in found for each in np.median(taken[name], axis=0)]
        figures = (f"{value:.3f}" for value in seconds)
        shares = (f"{100.0 * more(taken[name], taken['source']):+.1f} %" for taken in found)
        rounds = len(found[0][name])
        print(_ROW.format(layer.name, name, *counts, *figures, *shares, rounds), flush=True)


def more(taken: np.ndarray, source: np.ndarray) -> float:
    """What a stage costs more than the source, both in seconds (rounds, 2)."""
    return float(np.median(taken.sum(axis=1) / source.sum(axis=1))) - 1.0


def source_of(layer: Path) -> Path:
    """The file that a layout layer sublayers."""
    specs = Sdf.Layer.FindOrOpen(str(layer))
    return Path(specs.ComputeAbsolutePath(specs.subLayerPaths[0]))


def prim_count(layer: Path) -> int:
    """Prims of the layer itself, with overs."""
    found: list[Any] = []
    specs = Sdf.Layer.FindOrOpen(str(layer))
    specs.Traverse("/", lambda path: found.append(path) if path.IsPrimPath() else None)
    return len(found)


def measured(
    stages: Mapping[str, tuple[Path, str]], options: argparse.Namespace
) -> list[dict[str, np.ndarray]]:
    """For one character and for several, by stage, (rounds, 2) seconds to open and to play."""
    with tempfile.TemporaryDirectory() as folder:
        layers = {"old", "none", "ui"} & stages.keys()
        crates = {name: path for name, (path, _) in stages.items()}
        crates |= {name: crate(crates[name], Path(folder) / f"{name}.usdc") for name in layers}
        shots = [
            {
                name: shot(
                    Path(folder) / f"{name}{count}.usda",
                    crates[name],
                    variant,
                    count,
                    options.frames,
                )
                for name, (_, variant) in stages.items()
            }
            for count in (1, options.characters)
        ]
        found = [{name: [opened_and_played(each[name])] for name in stages} for each in shots]
        until = time.process_time() + options.seconds
        turn = 0
        while turn < options.rounds or time.process_time() < until:
            names = np.random.default_rng(turn).permutation(list(stages)).tolist()
            for paths, taken in zip(shots, found, strict=True):
                for name in names:
                    taken[name].append(opened_and_played(paths[name]))
            turn += 1
    # The first round fills the caches.
    return [{name: np.array(each[1:]) for name, each in taken.items()} for taken in found]


def with_layer_in_variant(layer: Path, folder: Path) -> Path:
    """A copy of the source with the layer attached in its variant."""
    source = source_of(layer)
    needed, _, _ = UsdUtils.ComputeAllDependencies(str(source))
    for each in needed:
        beside = folder / os.path.relpath(each.realPath, source.parent)
        beside.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(each.realPath, beside)
    bare = Sdf.Layer.OpenAsAnonymous(str(layer))
    bare.subLayerPaths.clear()
    bare.Export(str(folder / "bare.usdc"))
    attach(folder / source.name, folder / "bare.usdc", Settings(), in_variant=True)
    return folder / source.name


def crate(layer: Path, path: Path) -> Path:
    """A layout layer as a binary one, over the same source."""
    specs = Sdf.Layer.OpenAsAnonymous(str(layer))
    specs.subLayerPaths[0] = str(source_of(layer))
    specs.Export(str(path))
    return path


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
    for root in skel_roots(stage):
        UsdSkel.BakeSkinning(root)
    return opened - start, time.process_time() - opened


def skel_roots(stage: Usd.Stage) -> list[UsdSkel.Root]:
    """The SkelRoots of a shot, found without a look at what is below them."""
    found = []
    prims = iter(Usd.PrimRange(stage.GetPseudoRoot()))
    for prim in prims:
        if prim.IsA(UsdSkel.Root):
            found.append(UsdSkel.Root(prim))
            prims.PruneChildren()
    return found


if __name__ == "__main__":
    main()
