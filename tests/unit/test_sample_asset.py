"""The embedded sample is what its script makes, and holds every feature it promises."""

from __future__ import annotations

import subprocess
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Usd, UsdGeom, UsdSkel, Vt

SAMPLES = Path(__file__).resolve().parents[2] / "sample_assets"
ENTRY = SAMPLES / "char.usda"
FILES = ("char.usda", "char_geometry.usda")

PAIRED = [
    "browDown", "browOuterUp", "cheekSquint", "eyeBlink", "eyeSquint", "eyeWide", "jaw", "mouth", "mouthDimple",
    "mouthFrown", "mouthLowerDown", "mouthPress", "mouthSmile", "mouthStretch", "mouthUpperUp", "noseSneer",
]  # fmt: skip
SYMMETRIC = [
    "browInnerUp", "cheekPuff", "headSquash", "jawForward", "jawOpen", "mouthClose", "mouthFunnel", "mouthPucker",
    "mouthRollLower", "mouthRollUpper", "mouthShrugLower", "mouthShrugUpper", "tongueOut",
]  # fmt: skip
EYE, EYE_RADIUS = np.array([3.15, 0.0, 5.8]), 1.75


def controls() -> list[str]:
    return sorted([name + side for name in PAIRED for side in ("Left", "Right")] + SYMMETRIC)


@cache
def stage() -> Usd.Stage:
    return Usd.Stage.Open(str(ENTRY))


def meshes() -> dict[str, UsdGeom.Mesh]:
    return {prim.GetName(): UsdGeom.Mesh(prim) for prim in stage().Traverse() if prim.IsA(UsdGeom.Mesh)}


def rest_points(name: str) -> np.ndarray:
    """(n, 3) points in the character's space."""
    mesh = meshes()[name]
    bind = UsdSkel.BindingAPI(mesh.GetPrim()).GetGeomBindTransformAttr().Get()
    return np.array(mesh.GetPointsAttr().Get(), dtype=float) + np.array(bind.ExtractTranslation())


def shape_offsets(mesh_name: str, control: str) -> dict[float, np.ndarray]:
    """Offsets (n, 3) at each weight; empty where the control does not move the mesh."""
    mesh = meshes()[mesh_name]
    binding = UsdSkel.BindingAPI(mesh.GetPrim())
    names = list(binding.GetBlendShapesAttr().Get() or ())
    if control not in names:
        return {}
    target = binding.GetBlendShapeTargetsRel().GetTargets()[names.index(control)]
    shape = UsdSkel.BlendShape(stage().GetPrimAtPath(target))
    indices = np.array(shape.GetPointIndicesAttr().Get())
    offsets = {1.0: shape.GetOffsetsAttr().Get()}
    offsets |= {round(float(between.GetWeight()), 4): between.GetOffsets() for between in shape.GetInbetweens()}
    dense = {}
    for weight, values in sorted(offsets.items()):
        dense[weight] = np.zeros((len(mesh.GetPointsAttr().Get()), 3))
        dense[weight][indices] = np.array(values)
    return dense


def mirror_map(name: str) -> tuple[str, np.ndarray]:
    """The mesh that mirrors `name`, and its vertex at each mirrored place."""
    other = {"EyeLeft": "EyeRight", "EyeRight": "EyeLeft"}.get(name, name)
    mirrored, theirs = rest_points(name) * [-1, 1, 1], rest_points(other)
    apart = np.linalg.norm(mirrored[:, None] - theirs[None], axis=2)
    nearest = apart.argmin(axis=1)
    assert apart[np.arange(len(nearest)), nearest].max() < 1e-6
    return other, nearest


def posed(**weights: float) -> dict[str, np.ndarray]:
    """Points of every mesh, deformed by USD, at frame 1 with these weights."""
    own = Usd.Stage.Open(str(ENTRY))
    own.SetEditTarget(own.GetSessionLayer())
    animation = UsdSkel.Animation(own.GetPrimAtPath("/Char/Animation"))
    names = list(animation.GetBlendShapesAttr().Get())
    animation.GetBlendShapeWeightsAttr().Set(Vt.FloatArray([weights.get(name, 0.0) for name in names]))
    assert set(weights) <= set(names)
    return baked(own, 1.0)


def baked(own: Usd.Stage, frame: float) -> dict[str, np.ndarray]:
    own.SetEditTarget(own.GetSessionLayer())
    assert UsdSkel.BakeSkinning(UsdSkel.Root(own.GetPrimAtPath("/Char")), Gf.Interval(frame, frame))
    found = {}
    for name in meshes():
        mesh = UsdGeom.Mesh(own.GetPrimAtPath(f"/Char/Geometry/{name}"))
        points = np.array(mesh.GetPointsAttr().Get(frame), dtype=float)
        world = np.array(UsdGeom.Xformable(mesh).ComputeLocalToWorldTransform(frame))
        found[name] = points @ world[:3, :3] + world[3, :3]
    return found


# --- the files ---------------------------------------------------------------------------------------


def test_script_makes_the_committed_bytes(tmp_path: Path) -> None:
    subprocess.run([sys.executable, SAMPLES / "make_char.py", tmp_path], check=True, timeout=120, capture_output=True)
    for name in FILES:
        assert (tmp_path / name).read_bytes() == (SAMPLES / name).read_bytes(), (
            f"{name}: run sample_assets/make_char.py"
        )


def test_stays_small() -> None:
    assert sum((SAMPLES / name).stat().st_size for name in FILES) < 1_500_000
    assert 3000 <= sum(len(mesh.GetPointsAttr().Get()) for mesh in meshes().values()) <= 6000


def test_stage_metadata() -> None:
    assert UsdGeom.GetStageUpAxis(stage()) == UsdGeom.Tokens.y
    assert UsdGeom.GetStageMetersPerUnit(stage()) == 0.01
    root = stage().GetDefaultPrim()
    assert root.GetPath() == "/Char"
    assert root.IsA(UsdSkel.Root)
    assert stage().GetRootLayer().customLayerData["licence"] == "Apache-2.0"


def test_validators_find_no_error() -> None:
    validation = pytest.importorskip("pxr.UsdValidation")
    registry = validation.ValidationRegistry()
    found = validation.ValidationContext(registry.GetOrLoadAllValidators()).Validate(stage())
    assert [each.GetMessage() for each in found] == []


# --- the controls ------------------------------------------------------------------------------------


def test_control_names() -> None:
    animation = UsdSkel.Animation(stage().GetPrimAtPath("/Char/Animation"))
    assert list(animation.GetBlendShapesAttr().Get()) == controls()
    assert len(controls()) == 45


@pytest.mark.parametrize("name", ["Head", "Brows", "Lashes", "Hair", "UpperTeeth", "LowerTeeth", "Tongue", "EyeLeft"])
def test_pairs_mirror_and_symmetric_controls_mirror_themselves(name: str) -> None:
    other, partner = mirror_map(name)
    twins = [(base + "Left", base + "Right") for base in PAIRED] + [(each, each) for each in SYMMETRIC]
    for left, right in twins:
        ours, theirs = shape_offsets(name, left), shape_offsets(other, right)
        assert list(ours) == list(theirs), left
        for weight, offsets in ours.items():
            np.testing.assert_allclose(theirs[weight][partner], offsets * [-1, 1, 1], atol=1e-6, err_msg=left)


def test_every_control_moves_something_visible() -> None:
    for control in controls():
        peak = max(
            np.linalg.norm(offsets, axis=1).max()
            for name in meshes()
            for offsets in shape_offsets(name, control).values()
        )
        assert 0.2 < peak < 6.0, control


# --- the skeleton and the clip -----------------------------------------------------------------------


def test_first_frame_is_the_neutral_pose() -> None:
    for name, points in posed().items():
        np.testing.assert_allclose(points, rest_points(name), atol=1e-5, err_msg=name)
