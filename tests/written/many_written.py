"""Put written characters (written_rigs.py) through the commands: valid ones, damaged ones, and ends amid a run.

    python tests/written/many_written.py valid --count 1000
    python tests/written/many_written.py damaged --count 2000
    python tests/written/many_written.py ends --count 500

`valid`: UsdSkel's own deformed points are ours at random poses; the character is laid out, `check` finds nothing that
is an error, and finds of the flattened stage what it finds of the composed one.  `damaged`: words, numbers, lines and
bytes of a file are changed.  `ends`: a signal, or a limit of the system on files, descriptors or memory, or nobody who
listens.  No end is a bug, no exception leaves a command, nothing is left but the outputs, and these are whole.
Prints one JSON document.
"""

from __future__ import annotations

import argparse
import collections
import json
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

if __name__ == "__main__":
    sys.path += [str(Path(__file__).parents[1] / each) for each in ("", "fuzz")]

import numpy as np
from captured import called, captured
from pxr import Sdf, Usd, UsdGeom, UsdSkel, Vt
from written_rigs import write_rig

from usdrigui.character.deform import channel_state, deform
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

_QUICK = ("--set", "solve.work_limit=2000", "--set", "solve.time_limit=20")
_NUMBER, _NAME = re.compile(r"-?\d[\d.e+-]*"), re.compile(r'"[^"]*"')
_NUMBERS = ("nan", "inf", "-1", "1e39", "99999999999", "0", "7", "-0.5", "1e-45")
_NAME, _NAMES = (
    re.compile(r'"[^"]*"'),
    ('""', '"j0"', '"sure"', '"/"', '"a b"', '"é"', '"constant"', '"Mesh"', '"Scope"'),
)
_WORDS = ("nan", "inf", "-1", "1e39", "99999999999", "None", '""', "(", "]", "</World>", "double", "token[]", "0")


def run(*arguments: object) -> tuple[int, str]:
    """Exit code and what a command says, of which a traceback is a fault by itself."""
    with captured() as printed:
        code, escaped = called([str(each) for each in arguments])
    said = b"".join(printed).decode(errors="replace")
    return (-1 if escaped or "Traceback" in said else code), " ".join([*escaped, said])


# --- valid -------------------------------------------------------------------------------------------


def valid(seed: int, folder: Path) -> Iterator[tuple[str, int, str]]:
    """The ends of a character: what was done, exit code, and what was said."""
    asset, layer, flat = write_rig(seed, folder), folder / "layout.usda", folder / "flat.usda"
    (rig,) = read_rigs(asset, Settings())
    apart = _apart(asset, rig, np.random.default_rng(seed))
    yield "deform", 0 if apart < 1e-4 else -1, f"{apart:.2g} of its size beside UsdSkel"
    yield "process", *run("process", asset, "-o", layer, "--quiet", *_QUICK)
    if layer.exists():
        Usd.Stage.Open(str(layer)).Flatten().Export(str(flat))
        ends = [run("check", each, "--json", *_QUICK) for each in (layer, flat)]
        yield "check", *ends[0]
        found = [sorted((i["code"], i["path"]) for i in json.loads(said)["issues"]) for _, said in ends]
        yield "check flattened", ends[1][0] if found[0] == found[1] else -1, f"{found}"


def _apart(asset: Path, rig, rng) -> float:
    """How far our points are from those that UsdSkel's queries deform, at most, as a share of their size."""
    stage, worst = Usd.Stage.Open(str(asset)), 0.0
    cache, root = UsdSkel.Cache(), UsdSkel.Root(stage.GetPrimAtPath(rig.skel_root.path))
    cache.Populate(root, Usd.TraverseInstanceProxies())
    transforms = UsdGeom.XformCache(Usd.TimeCode.EarliestTime())
    low, high = (np.array([getattr(each, end) for each in rig.controls]) for end in ("minimum", "maximum"))
    for _ in range(3):
        values = rng.uniform(low, high)
        weights, local = channel_state(rig, values)
        ours, start = deform(rig, values), 0
        of_token = {each.token: weight for each, weight in zip(rig.body.channels, weights, strict=True)}
        for mesh in rig.body.meshes:
            prim = stage.GetPrimAtPath(mesh.path)
            query, points = cache.GetSkinningQuery(prim), Vt.Vec3fArray.FromNumpy(mesh.points.astype(np.float32))
            if query.HasBlendShapes():
                shapes = UsdSkel.BlendShapeQuery(UsdSkel.BindingAPI(prim))
                wanted = Vt.FloatArray([float(of_token.get(name, 0.0)) for name in query.GetBlendShapeOrder()])
                parts = shapes.ComputeSubShapeWeights(wanted)
                indices, offsets = shapes.ComputeBlendShapePointIndices(), shapes.ComputeSubShapePointOffsets()
                shapes.ComputeDeformedPoints(*parts, indices, offsets, points)
            place = transforms.GetLocalToWorldTransform(prim)
            if query.HasJointInfluences():
                skeleton = UsdSkel.BindingAPI(prim).GetInheritedSkeleton()
                bones = cache.GetSkelQuery(skeleton)
                posed = UsdSkel.ConcatJointTransforms(bones.GetTopology(), Vt.Matrix4dArray.FromNumpy(local))
                bind = bones.GetJointWorldBindTransforms()
                moved = Vt.Matrix4dArray([b.GetInverse() * p for b, p in zip(bind, posed, strict=True)])
                query.ComputeSkinnedPoints(moved, points)
                place = transforms.GetLocalToWorldTransform(skeleton.GetPrim())
            place *= transforms.GetLocalToWorldTransform(root.GetPrim()).GetInverse()
            theirs = np.array([place.Transform(each) for each in np.asarray(points, dtype=np.float64).tolist()])
            size = max(np.abs(theirs).max(), np.abs(mesh.points).max(), 1e-9)
            worst = max(worst, float(np.abs(theirs - ours[start : start + len(theirs)]).max() / size))
            start += len(theirs)
    return worst


# --- damaged -----------------------------------------------------------------------------------------


def damaged(seed: int, folder: Path) -> Iterator[tuple[str, int, str]]:
    """A character of which a file was changed, as text or as a crate."""
    rng = random.Random(f"damaged {seed}")
    asset = write_rig(seed, folder)
    broken = rng.choice(sorted(folder.iterdir()))
    if rng.random() < 0.3:
        Sdf.Layer.FindOrOpen(str(broken)).Export(str(folder / "crate.usdc"))
        content = bytearray((folder / "crate.usdc").read_bytes())
        for _ in range(rng.choice([1, 3, 30])):
            content[rng.randrange(len(content))] = rng.randrange(256)
        (folder / "crate.usdc").unlink()
        broken.write_bytes(bytes(content[: rng.choice([len(content), rng.randrange(len(content))])]))
        if broken == asset:
            asset = asset.rename(asset.with_suffix(".usdc"))
    else:
        broken.write_text(_changed(broken.read_text(encoding="utf-8"), rng), encoding="utf-8")
    layer = folder / "layout.usda"
    yield "process", *run("process", asset, "-o", layer, "--quiet", *_QUICK)
    if layer.exists():
        yield "check", *run("check", layer, "--quiet", *_QUICK)


def _changed(text: str, rng: random.Random) -> str:
    """The text with a few words, numbers or lines changed, or cut off."""
    lines = text.split("\n")
    for _ in range(rng.choice([1, 1, 2, 5])):
        at = rng.randrange(len(lines))
        words = lines[at].split(" ")
        way = rng.choice(["number"] * 6 + ["name"] * 3 + ["word", "swap", "drop", "double", "cut"])
        if way in ("number", "name"):
            found = [*(_NUMBER if way == "number" else _NAME).finditer(lines[at])]
            if found:
                begin, end = rng.choice(found).span()
                lines[at] = lines[at][:begin] + rng.choice(_NUMBERS if way == "number" else _NAMES) + lines[at][end:]
        elif way == "word":
            words[rng.randrange(len(words))] = rng.choice(_WORDS)
            lines[at] = " ".join(words)
        elif way == "swap":
            other = rng.randrange(len(lines))
            lines[at], lines[other] = lines[other], lines[at]
        elif way == "drop" and len(lines) > 1:
            del lines[at]
        elif way == "double":
            lines.insert(at, lines[at])
        elif rng.random() < 0.1:
            del lines[at + 1 :]
    return "\n".join(lines)


# --- ends --------------------------------------------------------------------------------------------

_LIMITS = {
    "RLIMIT_FSIZE": (0, 100, 4000, 20_000),
    "RLIMIT_NOFILE": (6, 12, 20),
    "RLIMIT_AS": (200 << 20, 600 << 20, 1500 << 20),
    "RLIMIT_CPU": (1, 2),
}
_SIGNALS = ("SIGTERM", "SIGINT", "SIGHUP", "SIGQUIT", "SIGKILL", "SIGUSR1", "SIGXCPU")


def ends(seed: int, folder: Path) -> Iterator[tuple[str, int, str]]:
    """A run that something stops; afterwards the same run goes through."""
    rng = random.Random(f"ends {seed}")
    asset, layer = write_rig(seed % 40, folder), folder / "layout.usda"
    command = [sys.executable, "-m", "usdrigui", "process", str(asset), "-o", str(layer), *_QUICK]
    way = rng.choice([*_LIMITS, *_SIGNALS, *_SIGNALS, "nobody listens"])

    def bounded() -> None:
        if way in _LIMITS:
            most = rng.choice(_LIMITS[way])
            resource.setrlimit(getattr(resource, way), (most, most))

    run_ = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=bounded)
    if way == "nobody listens":
        run_.stdout.close()
        run_.stderr.close()
        said, code = b"", run_.wait(timeout=120)
    else:
        try:
            if way in _SIGNALS:
                run_.wait(rng.uniform(0.05, 4.0))
        except subprocess.TimeoutExpired:
            run_.send_signal(getattr(signal, way))
        out, said = run_.communicate(timeout=120)
        code, said = run_.returncode, out + said
    text = said.decode(errors="replace")
    bad = code == 5 or "Traceback" in text or (code > 5 and code < 128)
    yield way, -1 if bad else 0, f"{code}: {text[-400:]}"
    if layer.exists():
        yield "whole", 0 if Sdf.Layer.OpenAsAnonymous(str(layer)) else -1, "the layer is torn"
    yield "once more", *run("process", asset, "-o", layer, "--quiet", *_QUICK)


# --- all ---------------------------------------------------------------------------------------------


def campaign(kind: str, seeds: range) -> dict[str, object]:
    """How the runs ended, and what must not be."""
    tally, faults = collections.Counter[str](), []
    for seed in seeds:
        with tempfile.TemporaryDirectory() as place:
            folder = Path(place)
            try:
                for what, code, said in {"valid": valid, "damaged": damaged, "ends": ends}[kind](seed, folder):
                    tally[f"{what}: {code}"] += 1
                    if code in (-1, 5) or (code and kind == "valid"):
                        faults.append({"seed": seed, "what": what, "code": code, "said": said[:1500]})
            except Exception as error:
                faults.append({"seed": seed, "what": "harness", "said": f"{type(error).__name__}: {error}"[:1500]})
            left = [each.name for each in folder.iterdir() if each.name.startswith(".") or "tmp" in each.name]
            faults += [{"seed": seed, "what": "left", "said": name} for name in left]
    return {"kind": kind, "runs": len(seeds), "ends": dict(sorted(tally.items())), "faults": faults}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("kind", choices=["valid", "damaged", "ends"])
    parser.add_argument("--count", type=int, default=30)
    parser.add_argument("--first", type=int, default=0)
    asked = parser.parse_args()
    result = campaign(asked.kind, range(asked.first, asked.first + asked.count))
    print(json.dumps(result, indent=2))
    sys.exit(bool(result["faults"]))
