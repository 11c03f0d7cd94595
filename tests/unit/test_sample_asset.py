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
IRIS_DEGREES = 29.0


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


def front_depth(points: np.ndarray, name: str, at: np.ndarray) -> np.ndarray:
    """Largest z of the mesh over each place (m, 2) seen from the front; -inf where there is nothing."""
    mesh, corners, start = meshes()[name], [], 0
    indices = np.array(mesh.GetFaceVertexIndicesAttr().Get())
    for count in mesh.GetFaceVertexCountsAttr().Get():
        face = indices[start : start + count]
        corners += [(face[0], face[k], face[k + 1]) for k in range(1, count - 1)]
        start += count
    a, b, c = (points[list(column)] for column in zip(*corners, strict=True))
    d1, d2 = (b - a)[:, :2], (c - a)[:, :2]
    area = d1[:, 0] * d2[:, 1] - d1[:, 1] * d2[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        r = at[:, None] - a[None, :, :2]
        u = (r[..., 0] * d2[:, 1] - r[..., 1] * d2[:, 0]) / area
        v = (d1[:, 0] * r[..., 1] - d1[:, 1] * r[..., 0]) / area
        z = a[:, 2] + u * (b - a)[:, 2] + v * (c - a)[:, 2]
        inside = (u >= 0) & (v >= 0) & (u + v <= 1)
    return np.where(inside, z, -np.inf).max(axis=1)


def iris_places(degrees: float = IRIS_DEGREES) -> np.ndarray:
    """(m, 3) points all over the left iris, up to an angle from the middle of the pupil."""
    rings = np.radians(np.linspace(2.0, degrees, 8))
    turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    tilt, around = (grid.ravel() for grid in np.meshgrid(rings, turn))
    return EYE + EYE_RADIUS * np.column_stack(
        [np.sin(tilt) * np.cos(around), np.sin(tilt) * np.sin(around), np.cos(tilt)]
    )


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


def test_faces_are_quads_but_for_a_few() -> None:
    counts = np.array(meshes()["Head"].GetFaceVertexCountsAttr().Get())
    assert set(counts) <= {3, 4}
    assert (counts == 3).sum() <= 2


def test_no_edge_has_more_than_two_faces() -> None:
    for name, mesh in meshes().items():
        indices, start, edges = np.array(mesh.GetFaceVertexIndicesAttr().Get()), 0, []
        for count in mesh.GetFaceVertexCountsAttr().Get():
            face = indices[start : start + count]
            edges += list(zip(face, np.roll(face, -1), strict=True))
            start += count
        _, uses = np.unique(np.array(edges), axis=0, return_counts=True)
        assert uses.max() == 1, f"{name}: two faces run along an edge in the same direction"


def test_head_faces_are_convex_but_at_the_corners_of_the_lips() -> None:
    mesh, points = meshes()["Head"], rest_points("Head")
    counts = np.array(mesh.GetFaceVertexCountsAttr().Get())
    starts = np.cumsum(counts) - counts
    quads = np.array(mesh.GetFaceVertexIndicesAttr().Get())[starts[counts == 4][:, None] + np.arange(4)]
    corners = points[quads]
    turns = np.cross(np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners)
    concave = ((turns * turns.sum(axis=1, keepdims=True)).sum(axis=2) < 0).any(axis=1)
    assert np.linalg.norm(np.abs(corners[concave].mean(axis=1)) - [2.1, 6.1, 7.3], axis=1).max(initial=0.0) < 0.3
    assert concave.sum() <= 2


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


def test_lids_travel_on_an_arc_outside_the_eyeball() -> None:
    points, shape = rest_points("Head"), shape_offsets("Head", "eyeBlinkLeft")
    assert list(shape) == [0.33, 0.67, 1.0]
    full = np.linalg.norm(shape[1.0], axis=1)
    edge = full > 0.8 * full.max()
    chord = 0.67 * shape[1.0][edge]
    assert np.linalg.norm(shape[0.67][edge] - chord, axis=1).min() > 0.05
    for offsets in shape.values():
        assert np.linalg.norm(points[full > 0] + offsets[full > 0] - EYE, axis=1).min() > EYE_RADIUS


def hidden_share(pose: dict[str, np.ndarray], places: np.ndarray) -> float:
    skin = front_depth(pose["Head"], "Head", places[:, :2])
    return float((skin > front_depth(pose["EyeLeft"], "EyeLeft", places[:, :2])).mean())


def test_blink_covers_the_iris_that_the_open_eye_shows() -> None:
    iris, pupil = iris_places(IRIS_DEGREES), iris_places(12.0)
    neutral = posed()
    assert hidden_share(neutral, pupil) == 0.0
    assert hidden_share(neutral, iris) < 0.2
    assert hidden_share(posed(eyeBlinkLeft=1.0), iris) == 1.0


def test_eyeball_never_pokes_through_the_lids() -> None:
    for weight in (0.2, 0.33, 0.5, 0.67, 0.85):
        pose, at = posed(eyeBlinkLeft=weight), iris_places()[:, :2]
        skin, ball = front_depth(pose["Head"], "Head", at), front_depth(pose["EyeLeft"], "EyeLeft", at)
        over = skin > EYE[2]
        assert (skin[over] > ball[over]).all(), weight


def test_tongue_control_moves_the_tongue_alone() -> None:
    assert [name for name in meshes() if shape_offsets(name, "tongueOut")] == ["Tongue"]


@pytest.mark.parametrize("control", ["jawOpen", "jawLeft", "jawForward"])
def test_jaw_takes_lower_teeth_and_tongue_along(control: str) -> None:
    teeth, tongue = shape_offsets("LowerTeeth", control), shape_offsets("Tongue", control)
    assert np.linalg.norm(teeth[1.0], axis=1).min() > 0.3
    assert np.linalg.norm(tongue[1.0], axis=1).min() > 0.3
    assert not shape_offsets("UpperTeeth", control)


def test_whole_head_control_moves_every_mesh() -> None:
    for name in meshes():
        assert np.count_nonzero(shape_offsets(name, "headSquash")[1.0].any(axis=1)) > 0.8 * len(rest_points(name))


def test_one_sided_controls_stay_on_their_side() -> None:
    x = rest_points("Head")[:, 0]
    for control in ("eyeBlinkLeft", "browOuterUpLeft", "mouthSmileLeft", "cheekSquintLeft"):
        assert not shape_offsets("Head", control)[1.0][x < -1.0].any(), control


# --- the skeleton and the clip -----------------------------------------------------------------------


def test_rest_and_bind_agree() -> None:
    skeleton = UsdSkel.Skeleton(stage().GetPrimAtPath("/Char/Skeleton"))
    joints = list(skeleton.GetJointsAttr().Get())
    rest = dict(zip(joints, skeleton.GetRestTransformsAttr().Get(), strict=True))
    for joint, bind in zip(joints, skeleton.GetBindTransformsAttr().Get(), strict=True):
        chain = [joint.rsplit("/", drop)[0] for drop in range(joint.count("/") + 1)]
        place = sum((rest[each].ExtractTranslation() for each in chain), Gf.Vec3d(0))
        assert (place - bind.ExtractTranslation()).GetLength() < 1e-9, joint


def test_skin_weights_sum_to_one() -> None:
    for name, mesh in meshes().items():
        binding = UsdSkel.BindingAPI(mesh.GetPrim())
        width = binding.GetJointWeightsPrimvar().GetElementSize()
        weights = np.array(binding.GetJointWeightsPrimvar().Get()).reshape(-1, width)
        assert weights.min() >= 0
        np.testing.assert_allclose(weights.sum(axis=1), 1.0, atol=1e-6, err_msg=name)


def test_clip_turns_head_jaw_and_eyes_only() -> None:
    animation = UsdSkel.Animation(stage().GetPrimAtPath("/Char/Animation"))
    rotations = np.array(
        [
            [2 * np.degrees(np.arccos(min(1.0, abs(q.GetReal())))) for q in animation.GetRotationsAttr().Get(frame)]
            for frame in range(1, 49)
        ]
    )
    turned = {
        joint for joint, most in zip(animation.GetJointsAttr().Get(), rotations.max(axis=0), strict=True) if most > 0.5
    }
    assert turned == {"Neck/Head", "Neck/Head/Jaw", "Neck/Head/EyeLeft", "Neck/Head/EyeRight"}
    assert rotations[0].max() < 1e-3


def test_first_frame_is_the_neutral_pose() -> None:
    for name, points in posed().items():
        np.testing.assert_allclose(points, rest_points(name), atol=1e-5, err_msg=name)


@pytest.mark.parametrize("frame", [10.0, 18.0, 30.0, 40.0])
def test_usd_deforms_the_clip_within_its_extent(frame: float) -> None:
    own = Usd.Stage.Open(str(ENTRY))
    low, high = np.array(UsdGeom.Boundable(own.GetPrimAtPath("/Char")).GetExtentAttr().Get(), dtype=float)
    moved = baked(own, frame)
    every = np.concatenate(list(moved.values()))
    assert np.isfinite(every).all()
    assert (every >= low - 0.05).all()
    assert (every <= high + 0.05).all()
    assert np.abs(moved["Head"] - rest_points("Head")).max() > 0.5


def test_turned_eyes_stay_in_their_sockets() -> None:
    moved = baked(Usd.Stage.Open(str(ENTRY)), 7.0)
    for name, side in (("EyeLeft", 1), ("EyeRight", -1)):
        rest = rest_points(name)
        assert np.abs(moved[name] - rest).max() > 0.3, "the eyes look aside at frame 7"
        away = np.linalg.norm(rest - EYE * [side, 1, 1], axis=1)
        np.testing.assert_allclose(away, EYE_RADIUS, atol=1e-3)
