"""Which object of the scene is which prim, which shape key which shape, which bone which joint.

A character may have been imported, renamed, parented and moved since, or it is Blender's own and
was exported: names, what Blender's exporter writes down, the topology and the points each tell a
part; what they tell together counts.
"""

from __future__ import annotations

import math
import re

import numpy as np

from .inbetweens import coordinates, shape_keys, tokens_of

_CLOSE = 1e-4
"""Of the size of a mesh: points so near are the same."""


def match(stage, layouts, objects):
    """By prim path, those of the ``objects`` of the scene that are meshes and skeletons of some
    layouts, each of them one at most."""
    found = {}
    for records, kind, likeness in (
        ([each for layout in layouts for each in layout.skeletons], "ARMATURE", _like_armature),
        ([each for layout in layouts for each in layout.meshes], "MESH", _like_mesh),
    ):
        pairs = [
            (score, record.path, thing)
            for record in records
            for thing in objects
            if thing.type == kind and (score := likeness(stage, record, thing, found)) > 0.0
        ]
        for _, path, thing in sorted(pairs, key=lambda pair: -pair[0]):
            if path not in found and thing not in found.values():
                found[path] = thing
    return found


def names_of(stage, layout, objects):
    """By prim path of the ``objects`` that are known, blend-shape tokens to names of shape keys, or
    joints to names of bones."""
    found = {}
    for path in (each.path for each in layout.meshes if each.path in objects):
        keys = [key.name for key in shape_keys(objects[path])]
        found[path] = _paired(tokens_of(stage.GetPrimAtPath(path)), keys)
    for each in layout.skeletons:
        if each.path in objects:
            bones = [bone.name for bone in objects[each.path].data.bones]
            found[each.path] = _paired([joint.path for joint in each.joints], bones, _last)
    return found


# --- how much an object is like a prim ------------------------------------------------------------


def _like_armature(stage, skeleton, thing, _found):
    joints = [_last(joint.path) for joint in skeleton.joints]
    share = _share(joints, thing.data.bones)
    named = _like_names(stage.GetPrimAtPath(skeleton.path), thing)
    chosen = any(each.select_get() for each in (thing, *thing.children_recursive))
    return share >= 0.5 and 4.0 * share + named + chosen


def _like_mesh(stage, record, thing, found):
    from .properties import get, points_of

    prim = stage.GetPrimAtPath(record.path)
    if len(thing.data.vertices) != record.points:
        return 0.0
    counts = [len(face.vertices) for face in thing.data.polygons]
    same = counts == get(prim, "faceVertexCounts", [])
    rest = rest_points(thing)
    near = np.abs(np.array(points_of(prim)) - rest).max() <= _CLOSE * np.ptp(rest)
    share = _share(tokens_of(prim), shape_keys(thing))
    likeness = 4.0 * same + 4.0 * near + 2.0 * share + _like_names(prim, thing)
    carried = any(each in found.values() for each in armatures_of(thing))
    return likeness and likeness + carried + thing.select_get() + 0.5 * _nearness(prim, thing, rest)


def _share(wanted, present):
    """Of some names, that of those which keys or bones that are present have."""
    there = {_plain(each.name) for each in present}
    return sum(_plain(name) in there for name in wanted) / max(len(wanted), 1)


def _like_names(prim, thing):
    """How many names of a prim and of an object agree: its own, the data's, the parents'."""
    own = [blender_name(prim), blender_name(prim.GetParent())]
    told = [*own, blender_name(prim, "data"), *(each.name for each in prim.GetPath().GetPrefixes())]
    names = {_plain(name) for name in told if name}
    here = [_plain(each.name) for each in (thing, thing.data, thing.parent) if each]
    return 2.0 * (thing.name in own) + sum(name in names for name in here)


def _nearness(prim, thing, rest):
    """1 where a mesh stands in the scene where the stage has it, towards 0 far away."""
    from pxr import UsdGeom

    placed = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(prim))
    apart = placed @ scene_of(prim.GetStage()) - np.array(thing.matrix_world).T
    away = np.linalg.norm([*rest.mean(axis=0), 1.0] @ apart)
    return math.exp(-away / max(thing.dimensions.length, 1e-9))


def scene_of(stage):
    """(4, 4) from a stage's world to the scene's, in metres with Z up, for row vectors."""
    from pxr import UsdGeom

    turn = np.eye(4)
    if UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.y:
        turn[:3, :3] = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]
    turn[:3, :3] *= UsdGeom.GetStageMetersPerUnit(stage)
    return turn


def armatures_of(thing):
    """The armatures that deform or carry an object; an armature is its own."""
    found = [each.object for each in thing.modifiers if each.type == "ARMATURE"]
    return [each for each in (*found, thing, thing.parent) if each and each.type == "ARMATURE"]


# --- names ----------------------------------------------------------------------------------------


def _paired(wanted, present, short=str):
    """The names that are present for those that are wanted: the same, or as USD would write them
    alike."""
    found = {each: short(each) for each in wanted if short(each) in present}
    left = [name for name in present if name not in found.values()]
    for plain in (_plain, _ascii):
        for each in wanted:
            alike = [name for name in left if plain(name) == plain(short(each))]
            if alike and each not in found:
                found[each] = alike[0]
                left.remove(alike[0])
    return found


def identifier(name):
    """A name as a prim may have it."""
    return re.sub(r"^(?=\d)|\W", "_", name) or "_"


def _plain(name):
    """A name as Blender's exporter makes a prim of it, without the number of a copy."""
    return identifier(re.sub(r"\.\d{3,}$", "", name))


def _ascii(name):
    from pxr import Tf

    return Tf.MakeValidIdentifier(name)


def _last(path):
    return path.rpartition("/")[2]


def blender_name(prim, kind="object"):
    """The name that the object, or its data, had when Blender exported it as a prim; empty if it
    did not."""
    from .properties import get

    return get(prim, f"userProperties:blender:{kind}_name", "")


# --- points ---------------------------------------------------------------------------------------


def rest_points(mesh):
    """(n, 3) points of a mesh object's data without any shape."""
    block = mesh.data.shape_keys
    return coordinates(block.reference_key.points if block else mesh.data.vertices)
