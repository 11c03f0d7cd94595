"""Do other versions of USD read our layers in silence, and move the handles as we say?

    python tests/usd_versions.py PYTHON [PYTHON ...]

Each PYTHON is an interpreter that can import pxr (nothing else is needed there), for example of a virtual
environment with ``pip install usd-core==24.11``.  Prints one line per interpreter, layer and way of
loading; ends with 1 if any fails.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import laid_out
import numpy as np
import skinned_stages

from usdrigui.character.deform import deform
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings
from usdrigui.stages.schema import schema_path

CLOSE = 1e-5
"""Of the diagonal of the character's box."""

READER = """
import json, sys
from pxr import Usd, UsdGeom, UsdSkel
stage = Usd.Stage.Open(sys.argv[1])
root = stage.GetPrimAtPath(sys.argv[2])
names = [prim.GetName() for prim in stage.Traverse()]
for prim in stage.Traverse():
    for attribute in prim.GetAttributes():
        attribute.Get()
        attribute.GetAllMetadata()
assert UsdSkel.BakeSkinning(UsdSkel.Root(root))
found = {}
for mesh in root.GetChild("RigUI").GetChildren():
    counts, corners = (list(mesh.GetAttribute("faceVertex" + each).Get()) for each in ("Counts", "Indices"))
    starts = [sum(counts[:face]) for face in range(len(counts))]
    for element in mesh.GetChildren():
        primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("rigUI:role")
        said = list(primvar.Get())  # ComputeFlattened knows no indexed tokens in the USD of Blender 4.5 and 5.0
        roles = [said[i] for i in primvar.GetIndices()] if primvar.IsIndexed() else said
        faces = [face for face in element.GetAttribute("indices").Get() or () if roles[face] == "handle"]
        if not faces:
            continue
        handle = {corners[starts[face] + corner] for face in faces for corner in range(counts[face])}
        for time in range(int(stage.GetEndTimeCode()) + 1):
            cache = UsdGeom.XformCache(time)
            matrix = cache.GetLocalToWorldTransform(mesh) * cache.GetLocalToWorldTransform(root).GetInverse()
            drawn = mesh.GetAttribute("points").Get(time)
            anchor = matrix.Transform(drawn[min(handle)])
            found.setdefault(element.GetName(), []).append(list(anchor))
print(json.dumps({"version": ".".join(map(str, Usd.GetVersion()[1:])), "handles": found}))
"""


def write_samples(folder: Path) -> dict[str, list[str]]:
    """Posed layers to read: file name to SkelRoot and, as JSON, the expected handles and the diagonal."""
    samples = {}
    for name, kind, suffix in (
        ("linear", {"moved": True, "animated_joints": ("Hips/Head", "Hips/Head/Jaw")}, ".usda"),
        ("dual", {"method": "dualQuaternion", "meshes": 2, "reordered": True}, ".usdc"),
        ("shapes", {"skinned": False, "left_handed": True}, ".usda"),
    ):
        source = skinned_stages.character(folder / f"{name}.usda", **kind)
        (rig,) = read_rigs(source, Settings())
        layout = laid_out.layout_of(rig)
        target = folder / f"{name}.rigui{suffix}"
        laid_out.written(source, rig, layout, target.name)
        rng = np.random.default_rng(11)
        poses = [rig.defaults, *(laid_out.random_values(rig, rng) for _ in range(2))]
        top = laid_out.keyed(str(target), rig, poses).GetRootLayer()
        top.subLayerPaths[0] = f"./{target.name}"
        top.Export(str(folder / f"{name}.posed.usda"))
        samples[f"{name}.posed.usda"] = [rig.path, json.dumps(_expected(rig, layout, poses))]
    return samples


def _expected(rig, layout, poses):
    starts = {mesh.path: int(start) for mesh, start in zip(rig.body.meshes, rig.body.starts, strict=False)}
    points = [deform(rig, pose) for pose in poses]
    handles = {
        element.name.replace(":", "_"): [
            each[starts[element.anchor.mesh] + element.anchor.point].tolist() for each in points
        ]
        for element in layout.elements
    }
    return {"handles": handles, "diagonal": float(np.linalg.norm(np.ptp(points[0], axis=0)))}


def complaint(python: str, path: Path, root: str, expected: str, plugin: bool) -> str:
    """What is wrong when an interpreter reads one posed layer; empty if nothing is."""
    environment = {key: value for key, value in os.environ.items() if key != "PXR_PLUGINPATH_NAME"}
    if plugin:
        environment["PXR_PLUGINPATH_NAME"] = str(schema_path())
    done = subprocess.run(
        [python, "-c", READER, str(path), root], capture_output=True, text=True, env=environment, timeout=300
    )
    if done.returncode or done.stderr.strip():
        return f"exit {done.returncode}: {done.stderr.strip()[:500]}"
    # Blender's Python logs about its own surroundings to the output before; USD complains to the errors.
    said, wanted = json.loads(done.stdout.splitlines()[-1]), json.loads(expected)
    if said["handles"].keys() != wanted["handles"].keys():
        return f"other handles: {sorted(said['handles'].keys() ^ wanted['handles'].keys())}"
    worst = max(
        float(np.abs(np.array(said["handles"][name]) - wanted["handles"][name]).max()) for name in wanted["handles"]
    )
    return "" if worst < CLOSE * wanted["diagonal"] else f"a handle is off by {worst / wanted['diagonal']:.2g}"


def main(interpreters: list[str]) -> int:
    """Print a table; 1 if anything was wrong."""
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        samples = write_samples(Path(folder))
        for python in interpreters:
            for name, (root, expected) in samples.items():
                for plugin in (False, True):
                    wrong = complaint(python, Path(folder) / name, root, expected, plugin)
                    failed += bool(wrong)
                    print(f"{python}  {name}  {'with' if plugin else 'without'} plug-in: {wrong or 'ok'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
