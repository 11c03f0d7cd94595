"""Valid rigs from a seed: everything that USD allows of a character and that a layout must live with.

`make_rig` writes one stage.  What is drawn: 1 to 500 controls; copies of a control, exact and nearly; sums, halves
and opposites of others; mirrored pairs with and without names; whole-head, single-point, huge and tiny shapes and
shapes without offsets; in-betweens within and beyond 0 and 1; signed ranges by metadata, limits or animation; sizes
of the character from 1e-4 to 1e6 units, anywhere in the scene; masks, spheres, flat sheets, single faces, loose
points and degenerate faces; meshes that are a point, a line, or far from all else; several meshes, hidden ones, left-
handed ones; skins and joints, animated or not; Y up and Z up; no animation, one that lists only some shapes, one
without keys; two characters on one stage.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import skel_stages
from pxr import Gf, Usd, UsdGeom, UsdSkel, Vt

COUNTS = (1, 1, 2, 3, 4, 6, 8, 11, 12, 16, 24, 40, 70, 120, 250, 500)
SMALL = tuple(count for count in COUNTS if count <= 24)
NAMES = ("jawOpen", "smile_L", "smile_R", "brow.up", "眉", "a b", "ns:lid", "50", "Mouth Wide", "é", "_", "x" * 80)


@dataclass
class Plan:
    """What has been drawn for one character."""

    rng: np.random.Generator
    scale: float
    z_up: bool
    count: int
    """Shapes of the largest mesh."""


def make_rig(seed: int, path: Path, counts: tuple[int, ...] = COUNTS) -> Path:
    """Write the rig of a seed to `path`; the same seed gives the same stage."""
    rng = np.random.default_rng([2021, seed])
    stage = Usd.Stage.CreateNew(str(path))
    z_up = bool(rng.random() < 0.3)
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z if z_up else UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, float(rng.choice([0.001, 0.01, 1.0])))
    world = UsdGeom.Xform.Define(stage, "/World")
    stage.SetDefaultPrim(world.GetPrim())
    if rng.random() < 0.3:
        world.AddTransformOp().Set(skel_stages.matrix(rng.normal(size=3) * 90.0, rng.normal(size=3) * 10.0))
    for number in range(2 if rng.random() < 0.1 else 1):
        scale = float(10.0 ** rng.uniform(-4.0, 6.0)) if rng.random() < 0.5 else 1.0
        _character(stage, f"/World/Char{number or ''}", Plan(rng, scale, z_up, int(rng.choice(counts))))
    stage.GetRootLayer().Save()
    return path


# --- a character -------------------------------------------------------------------------------------


def _character(stage: Usd.Stage, root: str, plan: Plan) -> None:
    rng = plan.rng
    prim = UsdSkel.Root.Define(stage, root).GetPrim()
    if rng.random() < 0.3:
        turned = skel_stages.matrix(rng.normal(size=3) * 60.0, rng.normal(size=3) * 5.0 * plan.scale)
        UsdGeom.Xformable(prim).AddTransformOp().Set(turned)
    joints = _joints(plan)
    rest = [skel_stages.matrix(rng.normal(size=3) * 10.0, rng.normal(size=3) * 0.2 * plan.scale) for _ in joints]
    skeleton = f"{root}/Skel"
    skel_stages.add_skeleton(stage, skeleton, joints, rest)
    tokens: dict[str, None] = {}
    for index in range(int(rng.choice([1, 1, 1, 2, 3, 5]))):
        tokens |= dict.fromkeys(_mesh(stage, f"{root}/Mesh{index}", skeleton, plan, index, joints))
    _animation(stage, root, skeleton, plan, list(tokens), joints, rest)


def _joints(plan: Plan) -> tuple[str, ...]:
    count = int(plan.rng.choice([0, 0, 0, 1, 2, 5, 12]))
    names: list[str] = []
    for index in range(count):
        parent = names[int(plan.rng.integers(len(names)))] + "/" if names else ""
        names.append(f"{parent}joint{index}")
    return tuple(names)


def _animation(
    stage: Usd.Stage,
    root: str,
    skeleton: str,
    plan: Plan,
    tokens: list[str],
    joints: tuple[str, ...],
    rest: list[Gf.Matrix4d],
) -> None:
    """None, one without keys, or one with keys; it lists all shapes in another order, or some, or others too."""
    rng, kind = plan.rng, plan.rng.choice(["none", "default", "keys", "keys"])
    if kind == "none" and not (joints and rng.random() < 0.5):
        return
    listed = [tokens[i] for i in rng.permutation(len(tokens))[: int(rng.choice([0, 1, len(tokens), len(tokens)]))]]
    listed += ["nobody has this"] * bool(rng.random() < 0.2)
    times = [0.0, 5.0, 7.5] if kind == "keys" else [None]
    reach = rng.choice([0.3, 1.0, -1.0, 3.0])
    weights = {time: reach * rng.random(len(listed)) * bool(i) for i, time in enumerate(times)}
    turned = {
        0.0 if time is None else time: [
            skel_stages.matrix(rng.normal(size=3) * 25.0 * i, (0, 0, 0)) * each if rng.random() < 0.7 else each
            for each in rest
        ]
        for i, time in enumerate(times)
    }
    animation = skel_stages.add_animation(stage, f"{root}/Anim", skeleton, listed, weights, joints, turned)
    if listed and rng.random() < 0.3:
        ranges = {token: [-1.0, 1.0] for token in listed if token.isidentifier()}
        stage.GetPrimAtPath(root).SetCustomDataByKey("ranges", json.dumps(ranges))
    if listed and rng.random() < 0.2:
        limits = {"minimum": Vt.FloatArray([-5.0] * len(listed)), "maximum": Vt.FloatArray([5.0] * len(listed))}
        animation.GetBlendShapeWeightsAttr().SetMetadata("limits", {"hard": limits})


# --- meshes ------------------------------------------------------------------------------------------


def _mesh(
    stage: Usd.Stage, path: str, skeleton: str, plan: Plan, index: int, joints: tuple[str, ...]
) -> tuple[str, ...]:
    """One mesh with its skin and shapes; returns the shapes' names."""
    rng = plan.rng
    count = plan.count if index == 0 else int(rng.integers(0, min(plan.count, 12) + 1))
    kind = rng.choice(["mask", "mask", "sphere", "sheet", "triangle", "quad", "loose", "seams", "point", "line"])
    points, counts, indices = _surface(kind, rng, 9 if count > 100 else 15)
    mesh = UsdGeom.Mesh.Define(stage, path)
    far = float(rng.choice([0.0, 1e3, 1e6], p=[0.9, 0.05, 0.05]))
    placed = (_upright(points, plan.z_up) + (1.5 * index + far) * np.eye(3)[0]) * plan.scale
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(placed.astype(np.float32)))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray(counts))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray(indices))
    if rng.random() < 0.15:
        mesh.CreateOrientationAttr(UsdGeom.Tokens.leftHanded)
    if index and rng.random() < 0.3:
        mesh.CreateVisibilityAttr(UsdGeom.Tokens.invisible)
    if index and rng.random() < 0.2:
        mesh.CreatePurposeAttr(UsdGeom.Tokens.proxy)
    if rng.random() < 0.2:
        mesh.AddTransformOp().Set(skel_stages.matrix(rng.normal(size=3) * 40.0, rng.normal(size=3) * plan.scale))
    api = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    api.CreateSkeletonRel().SetTargets([skeleton])
    if joints and rng.random() < 0.7:
        _skin(mesh, rng, len(points), len(joints))
    names = _names(rng, count, index)
    drawn: list[np.ndarray] = []
    for name in names:
        drawn.append(_offsets(points, drawn, rng))
        _shape(mesh, name, _upright(drawn[-1], plan.z_up) * plan.scale, rng)
    return names


def _upright(vectors: np.ndarray, z_up: bool) -> np.ndarray:
    """What was drawn for Y up, in the stage's world."""
    return vectors @ np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]) if z_up else vectors


def _surface(kind: str, rng: np.random.Generator, side: int) -> tuple[np.ndarray, list[int], list[int]]:
    """Points (n, 3) about a unit in size, facing +z, with face counts and indices."""
    if kind == "triangle":
        return np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]), [3], [0, 1, 2]
    if kind == "quad":
        return np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]), [4], [0, 1, 2, 3]
    x, y = np.meshgrid(np.linspace(-0.8, 0.8, side), np.linspace(-1.0, 1.0, side))
    if kind == "sphere":
        theta, phi = np.pi * (0.5 + 0.48 * y), np.pi * x / 0.8
        points = np.stack([np.sin(theta) * np.sin(phi), -np.cos(theta), np.sin(theta) * np.cos(phi)], axis=-1)
    else:
        height = 0.0 if kind == "sheet" else 0.7 * np.sqrt(np.maximum(0.0, 1.0 - x**2 - 0.6 * y**2))
        points = np.stack([x, y, np.broadcast_to(height, x.shape)], axis=-1)
    quads, points = skel_stages.quads(side), points.reshape(-1, 3)
    if kind == "point":
        points = np.zeros_like(points)
    if kind == "line":
        points = points * [0.0, 1.0, 0.0]
    if kind == "loose":
        # Points of no face, a face of one line, and points that fall together.
        points = np.concatenate([points, rng.normal(size=(5, 3)), points[:3]])
        return points, [4] * len(quads) + [3], [*quads.ravel().tolist(), 0, 0, 1]
    if kind == "seams":
        # Every face has points of its own; half of the faces are triangles.
        split = len(quads) // 2
        triangles = np.concatenate([quads[:split, [0, 1, 2]], quads[:split, [0, 2, 3]]])
        order = np.concatenate([triangles.ravel(), quads[split:].ravel()])
        return points[order], [3] * len(triangles) + [4] * (len(quads) - split), list(range(len(order)))
    return points, [4] * len(quads), quads.ravel().tolist()


def _skin(mesh: UsdGeom.Mesh, rng: np.random.Generator, points: int, joints: int) -> None:
    width, rigid = int(rng.integers(1, min(joints, 4) + 1)), bool(rng.random() < 0.2)
    rows = 1 if rigid else points
    indices = rng.integers(0, joints, size=(rows, width))
    weights = rng.dirichlet(np.ones(width), rows)
    method = str(rng.choice(["classicLinear", "dualQuaternion"]))
    skel_stages.add_skin(mesh, indices, weights, width, Gf.Matrix4d(1.0), method, rigid=rigid)


# --- shapes ------------------------------------------------------------------------------------------


def _names(rng: np.random.Generator, count: int, mesh: int) -> tuple[str, ...]:
    """As many names: some of a list, some shared by all meshes, some steps of others."""
    own = "" if rng.random() < 0.5 else f"m{mesh}_"
    pool = [*NAMES, *(f"{own}shape{i}" for i in range(count)), *(f"{own}shape{i}_50" for i in range(count // 4))]
    return tuple(dict.fromkeys(pool[i] for i in rng.permutation(len(pool))))[:count]


def _offsets(points: np.ndarray, drawn: list[np.ndarray], rng: np.random.Generator) -> np.ndarray:
    """(n, 3) offsets of one more shape; the first moves something."""
    kind = rng.choice(["bump", "copy", "near", "opposite", "sum", "half", "mirror", "odd"], p=_CHANCES)
    if not drawn or kind == "bump":
        return _bump(points, rng)
    other = drawn[int(rng.integers(len(drawn)))]
    if kind == "sum":
        chosen = rng.choice(len(drawn), size=min(len(drawn), int(rng.integers(2, 12))), replace=False)
        return np.sum([drawn[i] for i in chosen], axis=0)
    if kind == "mirror":
        image = np.linalg.norm(points[:, None] * [-1.0, 1.0, 1.0] - points[None], axis=2).argmin(axis=1)
        return other[image] * [-1.0, 1.0, 1.0]
    if kind == "odd":
        return _odd(points, rng)
    factor = {"copy": 1.0, "near": 1.0 + 1e-3 * rng.normal(), "opposite": -1.0, "half": 0.5}[kind]
    noise = 1e-4 * rng.normal(size=other.shape) if kind == "near" else 0.0
    return factor * other + noise


_CHANCES = (0.3, 0.12, 0.12, 0.12, 0.1, 0.08, 0.1, 0.06)


def _bump(points: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    apart = np.linalg.norm(points - points[int(rng.integers(len(points)))], axis=1) / rng.uniform(0.1, 1.2)
    fall = np.where(apart < 1.0, (1.0 - apart**2) ** 2, 0.0)
    return float(rng.uniform(0.01, 0.3)) * fall[:, None] * rng.normal(size=3)


def _odd(points: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Everything moved alike, swollen or collapsed; one point; nothing; far too much and next to nothing."""
    one = np.zeros_like(points)
    one[int(rng.integers(len(points)))] = rng.normal(size=3)
    noise = rng.normal(size=points.shape)
    found = [np.full_like(points, 0.3), 0.3 * points, -points, one, 0.0 * one, 1e3 * noise, 1e-6 * noise]
    return found[int(rng.integers(len(found)))]


def _shape(mesh: UsdGeom.Mesh, name: str, offsets: np.ndarray, rng: np.random.Generator) -> None:
    """Dense, or sparse with the points in any order and perhaps twice, with or without in-betweens."""
    indices = None
    if rng.random() < 0.5:
        indices = rng.permutation(np.flatnonzero(offsets.any(axis=1)))
        indices = np.append(indices, indices[:1]) if len(indices) else np.array([0])
        offsets = offsets[indices]
    between = {}
    if rng.random() < 0.15:
        between = {float(w): offsets * w + 0.05 * rng.normal() * offsets for w in rng.choice([-1, -0.5, 0.5, 1.5], 2)}
    prim = mesh.GetPrim()
    taken = {each.GetName() for each in prim.GetChildren()}
    child = f"s{len(taken)}"
    api, shape = UsdSkel.BindingAPI(prim), UsdSkel.BlendShape.Define(prim.GetStage(), prim.GetPath().AppendChild(child))
    shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(offsets.astype(np.float32)))
    if indices is not None:
        shape.CreatePointIndicesAttr(Vt.IntArray(indices.tolist()))
    for i, (weight, each) in enumerate(between.items()):
        made = shape.CreateInbetween(f"b{i}")
        made.SetWeight(weight)
        made.SetOffsets(Vt.Vec3fArray.FromNumpy(each.astype(np.float32)))
    api.CreateBlendShapesAttr(Vt.TokenArray([*(api.GetBlendShapesAttr().Get() or ()), name]))
    api.CreateBlendShapeTargetsRel().AddTarget(shape.GetPath())
