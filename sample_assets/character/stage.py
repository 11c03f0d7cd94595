"""Writes the character as USD: a text layer with the rig that references a text layer with the geometry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from pxr import Gf, Kind, Sdf, Usd, UsdGeom, UsdSkel, Vt

from .form import EYE, Floats
from .motion import FIRST_FRAME, FRAMES_PER_SECOND, LAST_FRAME, joint_turns, weight_curves
from .parts import Part
from .shapes import JAW_PIVOT, Body, ControlShape

ENTRY = "char.usda"
GEOMETRY = "char_geometry.usda"
ROOT = Sdf.Path("/Char")

_MIRRORED_EYE = EYE * [-1.0, 1.0, 1.0]
JOINTS: Mapping[str, Floats] = {
    "Neck": np.array([0.0, -14.0, -4.0]),
    "Neck/Head": np.array([0.0, -8.0, -1.8]),
    "Neck/Head/Jaw": JAW_PIVOT,
    "Neck/Head/EyeLeft": EYE,
    "Neck/Head/EyeRight": _MIRRORED_EYE,
}
"""Joint and its place in the bind pose; all axes lie along those of the character."""
RIGID: Mapping[str, str] = {
    "Brows": "Neck/Head",
    "Lashes": "Neck/Head",
    "Hair": "Neck/Head",
    "UpperTeeth": "Neck/Head",
    "LowerTeeth": "Neck/Head/Jaw",
    "Tongue": "Neck/Head/Jaw",
    "EyeLeft": "Neck/Head/EyeLeft",
    "EyeRight": "Neck/Head/EyeRight",
}
"""Meshes that follow one joint."""
SKIN_JOINTS = ("Neck", "Neck/Head", "Neck/Head/Jaw")
"""The head's own joint list, shorter than the skeleton's."""
LICENCE = {"licence": "Apache-2.0", "made by": "sample_assets/make_char.py of usdrigui"}


@dataclass(frozen=True)
class Character:
    """Everything that is written."""

    parts: Sequence[Part]
    body: Body
    controls: Sequence[ControlShape]


def write_character(character: Character, folder: Path) -> tuple[Path, Path]:
    """Write both layers into `folder`; the same character gives the same bytes."""
    folder.mkdir(parents=True, exist_ok=True)
    geometry, entry = folder / GEOMETRY, folder / ENTRY
    shapes = _geometry_stage(character)
    geometry.write_bytes(shapes.GetRootLayer().ExportToString().encode())
    posed = _entry_stage(character, geometry)
    rig = Sdf.Layer.CreateAnonymous(".usda")
    rig.TransferContent(posed.GetRootLayer())
    rig.GetPrimAtPath(ROOT).referenceList.Prepend(Sdf.Reference(f"./{GEOMETRY}"))
    entry.write_bytes(rig.ExportToString().encode())
    return entry, geometry


def _new_stage(comment: str) -> Usd.Stage:
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    root = UsdSkel.Root.Define(stage, ROOT).GetPrim()
    stage.SetDefaultPrim(root)
    layer = stage.GetRootLayer()
    layer.documentation = comment
    layer.customLayerData = dict(LICENCE)
    return stage


# --- geometry layer ----------------------------------------------------------------------------------


def _geometry_stage(character: Character) -> Usd.Stage:
    stage = _new_stage("Meshes, blend shapes and skin weights of the sample character, which char.usda references.")
    UsdGeom.Scope.Define(stage, ROOT.AppendChild("Geometry"))
    starts = character.body.starts
    for part, start, end in zip(character.parts, starts, starts[1:], strict=False):
        mesh = _add_mesh(stage, part)
        _bind(mesh, part, character.body.jaw[start:end])
        _add_shapes(mesh, character.controls, slice(start, end))
    return stage


def _add_mesh(stage: Usd.Stage, part: Part) -> UsdGeom.Mesh:
    mesh = UsdGeom.Mesh.Define(stage, ROOT.AppendPath(f"Geometry/{part.name}"))
    points = part.points - _own_origin(part.name)
    mesh.CreatePointsAttr(_vectors(points))
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray([len(face) for face in part.faces]))
    mesh.CreateFaceVertexIndicesAttr(Vt.IntArray([int(vertex) for face in part.faces for vertex in face]))
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.catmullClark)
    if part.name == "Lashes":
        mesh.CreateDoubleSidedAttr(True)
    whole = len(part.colors) == 1
    colors = mesh.CreateDisplayColorPrimvar(UsdGeom.Tokens.constant if whole else UsdGeom.Tokens.vertex)
    colors.Set(_vectors(np.round(part.colors, 3)))
    mesh.CreateExtentAttr(_vectors(np.array([points.min(axis=0), points.max(axis=0)])))
    return mesh


def _own_origin(name: str) -> Floats:
    """Where the mesh's own space begins: the eyeballs are modelled about their centres."""
    return {"EyeLeft": EYE, "EyeRight": _MIRRORED_EYE}.get(name, np.zeros(3))


def _bind(mesh: UsdGeom.Mesh, part: Part, jaw: Floats) -> None:
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    origin = Gf.Vec3d(*_own_origin(part.name).tolist())
    binding.CreateGeomBindTransformAttr(Gf.Matrix4d().SetTranslate(origin))
    if origin != Gf.Vec3d(0):
        mesh.AddTranslateOp().Set(origin)
    if part.name in RIGID:
        indices, weights = np.array([[list(JOINTS).index(RIGID[part.name])]]), np.ones((1, 1))
    else:
        binding.CreateJointsAttr(Vt.TokenArray(SKIN_JOINTS))
        weights = _skin_weights(part.points, jaw)
        indices = np.tile(np.arange(len(SKIN_JOINTS)), (len(weights), 1))
    rigid, width = part.name in RIGID, indices.shape[1]
    binding.CreateJointIndicesPrimvar(rigid, width).Set(Vt.IntArray(indices.ravel().tolist()))
    binding.CreateJointWeightsPrimvar(rigid, width).Set(Vt.FloatArray(weights.ravel().tolist()))


def _skin_weights(points: Floats, jaw: Floats) -> Floats:
    """(n, 3) neck, head, jaw: the neck gives way to the head along a line that falls from nape to throat."""
    t = np.clip((points[:, 1] + 11.5 + 0.4 * points[:, 2] + 2.5) / 5.0, 0.0, 1.0)
    above = t * t * (3 - 2 * t)
    neck, hung = np.round(1.0 - above, 4), np.round(above * jaw, 4)
    return np.column_stack([neck, np.round(1.0 - neck - hung, 4), hung])


def _add_shapes(mesh: UsdGeom.Mesh, controls: Sequence[ControlShape], own: slice) -> None:
    tokens, targets = [], []
    for control in controls:
        offsets = control.offsets[:, own]
        moved = np.flatnonzero(np.abs(offsets).max(axis=(0, 2)) > 0)
        if len(moved):
            tokens.append(control.name)
            targets.append(_add_shape(mesh, control, offsets[:, moved], moved))
    if tokens:
        binding = UsdSkel.BindingAPI(mesh.GetPrim())
        binding.CreateBlendShapesAttr(Vt.TokenArray(tokens))
        binding.CreateBlendShapeTargetsRel().SetTargets(targets)


def _add_shape(mesh: UsdGeom.Mesh, control: ControlShape, offsets: Floats, moved: np.ndarray) -> Sdf.Path:
    shape = UsdSkel.BlendShape.Define(mesh.GetPrim().GetStage(), mesh.GetPath().AppendChild(control.name))
    shape.CreateOffsetsAttr(_vectors(offsets[-1]))
    shape.CreatePointIndicesAttr(Vt.IntArray(moved.tolist()))
    for weight, between in zip(control.weights[:-1], offsets, strict=False):
        added = shape.CreateInbetween(f"at{round(weight * 100)}")
        added.SetWeight(weight)
        added.SetOffsets(_vectors(between))
    return shape.GetPath()


def _vectors(values: Floats) -> Vt.Vec3fArray:
    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(np.round(values, 4) + 0.0, dtype=np.float32))


# --- rig layer ---------------------------------------------------------------------------------------


def _entry_stage(character: Character, geometry: Path) -> Usd.Stage:
    stage = _new_stage(
        "Sample character of usdrigui: a head with 45 blend-shape controls, a skeleton and a short clip."
    )
    stage.SetStartTimeCode(FIRST_FRAME)
    stage.SetEndTimeCode(LAST_FRAME)
    stage.SetTimeCodesPerSecond(FRAMES_PER_SECOND)
    stage.SetFramesPerSecond(FRAMES_PER_SECOND)
    root = stage.GetDefaultPrim()
    model = Usd.ModelAPI(root)
    model.SetKind(Kind.Tokens.component)
    model.SetAssetName("char")
    model.SetAssetVersion("1")
    binding = UsdSkel.BindingAPI.Apply(root)
    skeleton = _add_skeleton(stage)
    binding.CreateSkeletonRel().SetTargets([skeleton.GetPath()])
    animation = _add_animation(stage, [control.name for control in character.controls])
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets([animation.GetPath()])
    UsdSkel.Root(root).CreateExtentAttr(_swept_extent(stage, geometry))
    return stage


def _add_skeleton(stage: Usd.Stage) -> UsdSkel.Skeleton:
    skeleton = UsdSkel.Skeleton.Define(stage, ROOT.AppendChild("Skeleton"))
    names = list(JOINTS)
    bind = [Gf.Matrix4d().SetTranslate(Gf.Vec3d(*JOINTS[name].tolist())) for name in names]
    rest = [Gf.Matrix4d().SetTranslate(Gf.Vec3d(*_local(name).tolist())) for name in names]
    skeleton.CreateJointsAttr(Vt.TokenArray(names))
    skeleton.CreateBindTransformsAttr(Vt.Matrix4dArray(bind))
    skeleton.CreateRestTransformsAttr(Vt.Matrix4dArray(rest))
    skeleton.CreatePurposeAttr(UsdGeom.Tokens.guide)
    places = np.array(list(JOINTS.values()))
    skeleton.CreateExtentAttr(_vectors(np.array([places.min(axis=0), places.max(axis=0)])))
    return skeleton


def _local(name: str) -> Floats:
    """Joint's place relative to its parent, centimetres."""
    parent = name.rpartition("/")[0]
    return np.round(JOINTS[name] - JOINTS[parent] if parent else JOINTS[name], 4) + 0.0


def _add_animation(stage: Usd.Stage, controls: list[str]) -> UsdSkel.Animation:
    """Joints in an order of their own, without the neck, which keeps its rest transform."""
    animation = UsdSkel.Animation.Define(stage, ROOT.AppendChild("Animation"))
    turns = joint_turns()
    animation.CreateBlendShapesAttr(Vt.TokenArray(controls))
    animation.CreateJointsAttr(Vt.TokenArray(list(turns)))
    animation.CreateTranslationsAttr(_vectors(np.array([_local(name) for name in turns])))
    animation.CreateScalesAttr(Vt.Vec3hArray([Gf.Vec3h(1.0)] * len(turns)))
    curves = weight_curves()
    unknown = set(curves) - set(controls)
    if unknown:
        raise ValueError(f"the clip drives unknown controls: {sorted(unknown)}")
    rest = np.zeros(LAST_FRAME - FIRST_FRAME + 1)
    weights = animation.CreateBlendShapeWeightsAttr()
    rotations = animation.CreateRotationsAttr()
    for step, frame in enumerate(range(FIRST_FRAME, LAST_FRAME + 1)):
        weights.Set(Vt.FloatArray([float(curves.get(name, rest)[step]) for name in controls]), frame)
        quats = [Gf.Quatf(float(q[0]), Gf.Vec3f(*q[1:].tolist())) for q in (turn[step] for turn in turns.values())]
        rotations.Set(Vt.QuatfArray(quats), frame)
    return animation


def _swept_extent(stage: Usd.Stage, geometry: Path) -> Vt.Vec3fArray:
    """Bounds of the deformed meshes over all frames of the clip."""
    posed = Usd.Stage.CreateInMemory()
    posed.GetRootLayer().TransferContent(stage.GetRootLayer())
    posed.GetDefaultPrim().GetReferences().AddReference(str(geometry))
    if not UsdSkel.BakeSkinning(UsdSkel.Root(posed.GetDefaultPrim()), Gf.Interval(FIRST_FRAME, LAST_FRAME)):
        raise RuntimeError("USD could not skin the character")
    bounds = UsdGeom.BBoxCache(FIRST_FRAME, [UsdGeom.Tokens.default_])
    total = Gf.Range3d()
    for frame in range(FIRST_FRAME, LAST_FRAME + 1):
        bounds.SetTime(frame)
        total.UnionWith(
            bounds.ComputeWorldBound(posed.GetPrimAtPath(ROOT.AppendChild("Geometry"))).ComputeAlignedRange()
        )
    return _vectors(np.array([total.GetMin(), total.GetMax()]))
