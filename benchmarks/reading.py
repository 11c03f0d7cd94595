"""How long reading and trajectories take beside usd-core alone, and how much memory.

    python benchmarks/reading.py ASSET...

*arrays* is usd-core alone: it opens the stage, lets UsdSkel resolve the bindings and hands over, as
numpy arrays, what a `Rig` is made of: points, faces, influences, offsets, point indices,
in-betweens, joints and animation.  *points* is usd-core alone handing over what trajectories are
made of as well: the points that UsdSkel computes for every blend shape at each of its weights, or
for every frame where there are no blend shapes.  *reading* is `read_rigs`, *ours* is `read_rigs`
and `trajectories`.  All start from the file; the best of several alternating runs in one process
counts.  Peak memory is that of a fresh process which does ours once.
"""

from __future__ import annotations

import argparse
import resource
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from pxr import Usd, UsdGeom, UsdSkel, Vt

from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings


def usd_alone(path: Path) -> int:
    """Bytes of all arrays of the asset, handed over by usd-core without any of our code."""
    stage = Usd.Stage.Open(str(path))
    total = 0
    for root in [prim for prim in stage.Traverse() if prim.IsA(UsdSkel.Root)]:
        cache = UsdSkel.Cache()
        cache.Populate(UsdSkel.Root(root), Usd.TraverseInstanceProxies())
        for binding in cache.ComputeSkelBindings(UsdSkel.Root(root), Usd.TraverseInstanceProxies()):
            total += _skeleton(cache.GetSkelQuery(binding.GetSkeleton()))
            total += sum(_influences(query) for query in binding.GetSkinningTargets())
        total += sum(_prim(prim) for prim in Usd.PrimRange(root))
    return total


def _skeleton(query: UsdSkel.SkeletonQuery) -> int:
    arrays = []
    if len(query.GetJointOrder()):
        arrays += [
            query.GetJointWorldBindTransforms(),
            query.ComputeJointLocalTransforms(Usd.TimeCode.Default(), True),
        ]
    animation = query.GetAnimQuery()
    if animation:
        for sample in animation.GetBlendShapeWeightTimeSamples():
            arrays.append(animation.ComputeBlendShapeWeights(sample))
        for sample in animation.GetJointTransformTimeSamples():
            arrays.append(query.ComputeJointLocalTransforms(sample))
    return sum(np.asarray(array).nbytes for array in arrays if array is not None)


def _influences(query: UsdSkel.SkinningQuery) -> int:
    if not query.HasJointInfluences():
        return 0
    return sum(np.asarray(array).nbytes for array in query.ComputeJointInfluences())


def _prim(prim: Usd.Prim) -> int:
    if prim.IsA(UsdGeom.Mesh):
        mesh = UsdGeom.Mesh(prim)
        attributes = [
            mesh.GetPointsAttr(),
            mesh.GetFaceVertexCountsAttr(),
            mesh.GetFaceVertexIndicesAttr(),
        ]
        UsdSkel.BindingAPI(prim).GetBlendShapesAttr().Get()
        UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().GetTargets()
    elif prim.IsA(UsdSkel.BlendShape):
        shape = UsdSkel.BlendShape(prim)
        attributes = [shape.GetOffsetsAttr(), shape.GetPointIndicesAttr()]
        attributes += [between.GetAttr() for between in shape.GetInbetweens()]
    else:
        return 0
    values = (attribute.Get(Usd.TimeCode.EarliestTime()) for attribute in attributes)
    return sum(np.asarray(value).nbytes for value in values if value is not None)


def usd_points(path: Path) -> int:
    """Bytes of those arrays and of the points at every weight of every blend shape, or at every
    frame."""
    total = usd_alone(path)
    stage = Usd.Stage.Open(str(path))
    for root in [prim for prim in stage.Traverse() if prim.IsA(UsdSkel.Root)]:
        cache = UsdSkel.Cache()
        cache.Populate(UsdSkel.Root(root), Usd.TraverseInstanceProxies())
        for binding in cache.ComputeSkelBindings(UsdSkel.Root(root), Usd.TraverseInstanceProxies()):
            skeleton = cache.GetSkelQuery(binding.GetSkeleton())
            for query in binding.GetSkinningTargets():
                total += (
                    _shaped(skeleton, query)
                    if query.HasBlendShapes()
                    else _animated(skeleton, query)
                )
    return total


def _shaped(skeleton: UsdSkel.SkeletonQuery, query: UsdSkel.SkinningQuery) -> int:
    shapes = UsdSkel.BlendShapeQuery(UsdSkel.BindingAPI(query.GetPrim()))
    indices, offsets = shapes.ComputeBlendShapePointIndices(), shapes.ComputeSubShapePointOffsets()
    rest = UsdGeom.Mesh(query.GetPrim()).GetPointsAttr().Get(Usd.TimeCode.EarliestTime())
    matrices = skeleton.ComputeSkinningTransforms(Usd.TimeCode.Default())
    weights = np.zeros(shapes.GetNumBlendShapes(), dtype=np.float32)
    total = 0
    for index in range(len(weights)):
        for knot in {
            1.0,
            *(between.GetWeight() for between in shapes.GetBlendShape(index).GetInbetweens()),
        }:
            weights[:] = 0.0
            weights[index] = knot
            points = Vt.Vec3fArray(rest)
            shapes.ComputeDeformedPoints(
                *shapes.ComputeSubShapeWeights(Vt.FloatArray.FromNumpy(weights)),
                indices,
                offsets,
                points,
            )
            if query.HasJointInfluences():
                query.ComputeSkinnedPoints(matrices, points, Usd.TimeCode.Default())
            total += np.asarray(points).nbytes
    return total


def _animated(skeleton: UsdSkel.SkeletonQuery, query: UsdSkel.SkinningQuery) -> int:
    animation = skeleton.GetAnimQuery()
    rest = UsdGeom.Mesh(query.GetPrim()).GetPointsAttr().Get(Usd.TimeCode.EarliestTime())
    total = 0
    for sample in animation.GetJointTransformTimeSamples() if animation else ():
        points = Vt.Vec3fArray(rest)
        query.ComputeSkinnedPoints(skeleton.ComputeSkinningTransforms(sample), points, sample)
        total += np.asarray(points).nbytes
    return total


def ours(path: Path) -> int:
    """Number of trajectories of the asset."""
    settings = Settings()
    return sum(
        len(trajectories(rig, settings.trajectories).motions) for rig in read_rigs(path, settings)
    )


def seconds(action, path: Path) -> float:
    started = time.perf_counter()
    action(path)
    return time.perf_counter() - started


ACTIONS = (usd_alone, usd_points, lambda path: read_rigs(path, Settings()), ours)


def measured(path: Path, runs: int) -> list[float]:
    """Seconds of each of the actions, each the best of `runs`."""
    return np.min(
        [[seconds(action, path) for action in ACTIONS] for _ in range(runs)], axis=0
    ).tolist()


def peak_memory(path: Path) -> float:
    """MiB that a fresh process takes at most for reading and trajectories."""
    command = [sys.executable, __file__, "--child", str(path)]
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def _own_peak() -> float:
    """MiB that this process has taken at most."""
    status = Path("/proc/self/status")
    if status.exists():
        # The rusage of a child starts at what its parent held.
        return int(status.read_text().split("VmHWM:")[1].split()[0]) / 1024
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("assets", nargs="+", type=Path)
    parser.add_argument("--runs", type=int, default=7)
    parser.add_argument("--child", action="store_true", help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if arguments.child:
        ours(arguments.assets[0])
        print(_own_peak())
        return
    heads = (
        "arrays",
        "points",
        "reading",
        "ours",
        "reading/arrays",
        "ours/arrays",
        "ours/points",
        "peak MiB",
    )
    print(f"{'asset':<26}" + "".join(f"{head:>{max(9, len(head) + 2)}}" for head in heads))
    for path in arguments.assets:
        arrays, points, reading, both = measured(path, arguments.runs)
        times = "".join(f"{each:>9.3f}" for each in (arrays, points, reading, both))
        ratios = f"{reading / arrays:>16.2f}{both / arrays:>13.2f}{both / points:>13.2f}"
        print(f"{path.name:<26}{times}{ratios}{peak_memory(path):>10.0f}")


if __name__ == "__main__":
    main()
