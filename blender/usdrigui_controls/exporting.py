"""A face of the scene as USD, written without touching the scene: what belongs to it, what is in
the way, and the file.

Blender's own exporter writes meshes, armatures and materials.  Its shape keys are written anew: it
passes over masks and over keys that are relative to others, and gives two keys one name.
"""

from __future__ import annotations

import json
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import bpy
import numpy as np

from .inbetweens import key_offsets, shape_keys
from .layout import LayoutError
from .matching import armatures_of, blender_name, identifier

_REFINING = {"SUBSURF", "MULTIRES", "SOLIDIFY", "ARRAY"}
"""Modifiers that add vertices behind those of the mesh."""
_CUTTING = {"MIRROR", "DECIMATE", "REMESH", "WELD", "MASK", "BOOLEAN", "BUILD", "SCREW", "SKIN"}
"""Modifiers that leave other vertices, or a face of which the mesh is one half."""
_OPTIONS = {
    "selected_objects_only": True,
    "convert_world_material": False,
    "allow_unicode": True,
    "export_textures_mode": "KEEP",
    "evaluation_mode": "VIEWPORT",
}


@dataclass(frozen=True)
class Face:
    """The objects that make up one character."""

    meshes: tuple
    armatures: tuple
    beside: tuple
    """Names of other armatures on the same parent."""

    @property
    def name(self):
        """Name of the character: that of its armature, or of the mesh with the most shapes."""
        return (*self.armatures, max(self.meshes, key=lambda mesh: len(shape_keys(mesh))))[0].name

    def free(self):
        """Names of the shape keys that a drag could move: not muted, nor set by a driver."""
        return {key.name for mesh in self.meshes for key in shape_keys(mesh) if _is_free(key)}

    def driven(self):
        """Names of the others."""
        return sorted({key.name for mesh in self.meshes for key in shape_keys(mesh)} - self.free())


def selected_face(context):
    """The `Face` that the selection means: a mesh, an armature, their parent, or with nothing
    selected the active collection.

    Raises LayoutError with what to do where it cannot be laid out.
    """
    if context.mode not in ("OBJECT", "POSE"):
        raise LayoutError("leave this mode first: a face is laid out in object or pose mode")
    shown = [each for each in context.view_layer.objects if each.visible_get()]
    chosen = [each for each in shown if each.select_get()]
    chosen = chosen or [each for each in context.collection.all_objects if each in shown]
    tops = {each.parent or each for each in chosen}
    wanted = {each for top in tops for each in (top, *top.children_recursive)}
    around = {rig for each in wanted for rig in armatures_of(each)}
    rigs = {
        rig for each in chosen for own in armatures_of(each) for rig in armatures_of(own)
    } or around
    # Beside another armature nothing tells whose the meshes without one are.
    alone = wanted if around <= rigs else chosen
    meshes = [
        each
        for each in shown
        if each.type == "MESH" and (each in alone or rigs & {*armatures_of(each)})
    ]
    hidden = next((each for each in rigs if each not in shown), None)
    if hidden is not None:
        raise LayoutError(f"the armature {hidden.name} of this face is hidden: show it first")
    face = Face(
        tuple(meshes),
        tuple(each for each in shown if each in rigs),
        tuple(each.name for each in shown if each in around - rigs),
    )
    _check(face, chosen)
    return face


def _check(face, chosen):
    if not face.meshes:
        raise LayoutError(
            "select the face: a mesh with shape keys, its armature, or its collection"
        )
    if not face.armatures and not face.free():
        if not face.driven():
            raise LayoutError(
                f"{chosen[0].name} has no shape keys and no bones: select the mesh that has the"
                " expressions"
            )
        raise LayoutError(
            f"all shape keys of {chosen[0].name} are driven or muted: free those that are to have"
            " controls"
        )
    for thing in (*face.meshes, *face.armatures):
        keys = getattr(thing.data, "shape_keys", None)
        linked = thing.library or (keys and keys.library)
        if linked is not None:
            what = thing.name if thing.library else f"the mesh data of {thing.name}"
            raise LayoutError(
                f"{what} is linked from {Path(linked.filepath).name}: make a library override of it"
                " first (in the outliner, Library Override > Make)"
            )
    for mesh in face.meshes:
        changing = _changing(mesh)
        if changing:
            raise LayoutError(
                f"the modifier {changing} of {mesh.name} changes its vertices: apply it, or switch"
                " it off in the viewport"
            )


def _changing(mesh):
    """Name of a modifier that leaves other vertices than those of the mesh; empty if none does."""
    used = _used(mesh)
    cutting = [each for each in used if each.type in _CUTTING]
    shown = mesh.evaluated_get(bpy.context.evaluated_depsgraph_get())
    others = len(shown.data.vertices) != len(mesh.data.vertices)
    if others and not any(each.type in _REFINING for each in used):
        cutting = cutting or used
    return cutting[0].name if cutting else ""


def _used(mesh):
    """The modifiers that change a mesh but for its armatures."""
    return [each for each in mesh.modifiers if each.show_viewport and each.type != "ARMATURE"]


def _is_free(key):
    animated = key.id_data.animation_data
    driven = [each.data_path for each in animated.drivers] if animated else ()
    return not key.mute and key.path_from_id("value") not in driven


# --- the file -------------------------------------------------------------------------------------


def write_character(face, target):
    """Write a face as a neutral character, without animation.

    Raises LayoutError where the file cannot be written.
    """
    modifiers = [each for mesh in face.meshes for each in _used(mesh)]
    with selection_kept():
        for each in bpy.context.view_layer.objects:
            each.select_set(each in face.meshes or each in face.armatures)
        try:
            for each in modifiers:
                each.show_viewport = False
            bpy.ops.wm.usd_export(filepath=str(target), **_OPTIONS)
        except RuntimeError as error:
            raise LayoutError(f"{target} cannot be written: {error}") from error
        finally:
            for each in modifiers:
                each.show_viewport = True
    _finish(face, target)


@contextmanager
def selection_kept():
    """Afterwards the selection and the active object are as they were."""
    layer = bpy.context.view_layer
    chosen, active = [each for each in layer.objects if each.select_get()], layer.objects.active
    try:
        yield
    finally:
        for each in layer.objects:
            each.select_set(each in chosen)
        layer.objects.active = active


def _finish(face, target):
    """Write the shapes exactly, and take the present pose away."""
    from pxr import Usd, UsdGeom, UsdSkel

    stage = Usd.Stage.Open(str(target))
    ranges = {}
    meshes = {each.name: each for each in face.meshes}
    for prim in list(stage.Traverse()):
        if not prim:
            continue  # a shape that was written anew
        if prim.IsA(UsdSkel.Animation):
            stage.RemovePrim(prim.GetPath())
        elif prim.IsA(UsdSkel.Skeleton):
            UsdSkel.BindingAPI(prim).GetAnimationSourceRel().ClearTargets(removeSpec=True)
        elif prim.IsA(UsdGeom.Mesh) and (mesh := meshes.get(blender_name(prim.GetParent()))):
            if shape_keys(mesh):
                ranges.update(_write_shapes(stage, prim, mesh))
            if any(each.type == "SUBSURF" for each in mesh.modifiers):
                UsdGeom.Mesh(prim).CreateSubdivisionSchemeAttr("catmullClark")
    layer = stage.GetRootLayer()
    layer.customLayerData = {**layer.customLayerData, "ranges": json.dumps(ranges)}
    layer.Export(str(target))  # a crate that was changed keeps what it had; a new one does not


def _write_shapes(stage, prim, mesh):
    """All shape keys of a mesh, under their own names; returns the ranges other than 0 to 1."""
    from pxr import UsdSkel, Vt

    binding = UsdSkel.BindingAPI.Apply(prim)
    for child in list(prim.GetChildren()):
        if child.IsA(UsdSkel.BlendShape):
            stage.RemovePrim(child.GetPath())
    keys = shape_keys(mesh)
    targets, ranges = [], {}
    for key in keys:
        name = identifier(key.name)
        while prim.GetChild(name):
            name += "_"
        shape = UsdSkel.BlendShape.Define(stage, prim.GetPath().AppendChild(name))
        offsets = key_offsets(mesh, key).astype(np.float32)
        moved = np.flatnonzero(offsets.any(axis=1))
        shape.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(offsets[moved])))
        shape.CreatePointIndicesAttr(Vt.IntArray.FromNumpy(moved.astype(np.int32)))
        targets.append(shape.GetPath())
        if (key.slider_min, key.slider_max) != (0.0, 1.0):
            ranges[key.name] = [key.slider_min, key.slider_max]
    binding.CreateBlendShapesAttr([key.name for key in keys])
    binding.CreateBlendShapeTargetsRel().SetTargets(targets)
    return ranges
