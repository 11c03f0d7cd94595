"""A character in the scene: which objects, shape keys and bones a layout means, its values and its
keys.

The value of a control lives where Blender keeps it, in shape keys and pose bones, so that the
controls agree with every other way to pose the character.  Only poses made of several weights or
joints have no such place; theirs is a custom property of the holder.
"""

from __future__ import annotations

import json
import math
import zlib
from functools import lru_cache

import bpy
import mathutils
import numpy as np
from bpy_extras import anim_utils

from .inbetweens import coordinates, shape_keys
from .layout import LayoutError, from_json, gained, to_json
from .matching import armatures_of

LAYOUT = "usdrigui_layout"
"""Custom property of the holder with the layout as JSON."""
SOURCE = "usdrigui_source"
"""Custom property of the holder with the path of the layer that the layout was read from."""
EXPORTED = "usdrigui_exported"
"""Custom property of the holder where that layer is of an export of this scene."""
BONES = "usdrigui_bones"
"""Custom property of the holder: the armature whose bones drive the shape keys, if there is one."""
_OBJECTS, _NAMES, _SUMS = "usdrigui_objects", "usdrigui_names", "usdrigui_sums"
_VALUE = "rig: "
"""Prefix of the custom properties that hold the values of poses."""


def bind(layout, objects, names):
    """Store a layout with the ``objects`` that it means, by prim path, and the ``names`` of their
    keys and bones, as of `matching.names_of`; returns its `Character`.

    The holder is the armature, or the first mesh where there is none; for a library override, which
    keeps no properties of its own when it is saved, an empty.  Raises LayoutError when a mesh that
    carries controls is missing or has another number of points.
    """
    check_meshes(layout, objects)
    here = {str(i): objects[path] for i, path in enumerate(layout.paths) if path in objects}
    if not here:
        raise LayoutError(f"no object of the scene belongs to {layout.root}")
    mine = [*here.values()]
    holder = holder_of(mine)
    if holder and holder.data and holder not in mine:  # it had the layout of these and of others
        unbind(holder)
        holder = None
    holder = holder or (_stand_in(mine[0]) if mine[0].override_library else mine[0])
    holder[LAYOUT] = to_json(layout)
    sums = {path: {key.name: _sum(key) for key in shape_keys(objects[path])} for path in objects}
    holder[_OBJECTS], holder[_NAMES], holder[_SUMS] = here, json.dumps(names), json.dumps(sums)
    character = Character(holder)
    character.widen_ranges()
    return character


def _stand_in(thing):
    made = bpy.data.objects.new(f"{thing.name} controls", None)
    made.hide_viewport = made.hide_render = True
    bpy.context.scene.collection.objects.link(made)
    return made


def holder_of(objects):
    """The object that holds the layout of some of these, one of them if it can be, or None."""
    held = holders()
    found = (each for each in held if {*objects} & {*Character(each).objects.values()})
    return max(found, key=objects.count, default=None)


def unbind(holder):
    """Forget the controls of a character."""
    if holder.type == "EMPTY":
        bpy.data.objects.remove(holder)
        return
    for name in list(holder.keys()):
        if name.startswith(("usdrigui_", _VALUE)):
            del holder[name]


def holders():
    """The objects of the scene that hold a layout."""
    return [each for each in bpy.context.scene.objects if LAYOUT in each]


def at_frames(frames, look):
    """By frame, what ``look()`` gives there; the scene is then at the frame where it was."""
    scene = bpy.context.scene

    def go_to(frame):
        scene.frame_set(math.floor(frame), subframe=frame % 1.0)

    before, seen = scene.frame_current_final, {}
    try:
        for frame in frames:
            go_to(frame)
            seen[frame] = look()
    finally:
        if scene.frame_current_final != before:
            go_to(before)
    return seen


def check_meshes(layout, objects):
    """Raise LayoutError unless the meshes that carry controls are among ``objects``, by prim path,
    with the points that they had."""
    needed = {element.mesh for element in layout.elements}
    for mesh in layout.meshes:
        if mesh.path not in needed:
            continue
        here = objects.get(mesh.path)
        if here is None:
            raise LayoutError(
                f"no object of the scene is the mesh {mesh.path} with {mesh.points} vertices:"
                " import that character, or lay out the one that is here"
            )
        count = len(here.data.vertices)
        if count != mesh.points:
            raise LayoutError(
                f"{here.name} has {count} vertices, {mesh.path} has {mesh.points}: lay it out again"
            )


class Character:
    """One character at one moment: hold it no longer than a call, Blender moves its objects
    about."""

    def __init__(self, holder):
        self.holder = holder
        self.layout = parsed(holder[LAYOUT])
        self.controls = {control.name: control for control in self.layout.controls}
        stored = holder[_OBJECTS]
        pairs = ((path, stored.get(str(i))) for i, path in enumerate(self.layout.paths))
        self.objects = {path: each for path, each in pairs if each and each.data}
        self.armatures, self.meshes = (
            {path: each for path, each in self.objects.items() if each.type == kind}
            for kind in ("ARMATURE", "MESH")
        )
        self.names = json.loads(holder[_NAMES])
        self.sums = json.loads(holder.get(_SUMS, "{}"))

    # --- values -----------------------------------------------------------------------------------

    def values(self):
        """The value of every control, by name."""
        found, turning = {}, {}
        for control in self.layout.controls:
            bone = self.bone(*control.joints[0].at) if is_single_joint(control) else None
            if control.plain:
                keys = self.keys_of(control)
                found[control.name] = keys[0].value if keys else control.base
            elif bone:
                turning.setdefault(bone.as_pointer(), []).append(control)
            else:
                found[control.name] = float(self.holder.get(_VALUE + control.name, control.base))
        for controls in turning.values():
            found.update(self._joint_values(controls))
        return found

    def set_values(self, changed):
        """Give some controls, by name, new values; all else stays."""
        before, others = self.values(), []
        for name, value in changed.items():
            control = self.controls[name]
            if control.plain:
                for key in self.keys_of(control):
                    key.value = value
                continue
            others.append(control)
            if not is_single_joint(control):
                self.holder[_VALUE + name] = value
        weights, moves = gained(others, before, changed)
        if BONES in self.holder:
            from .bones import move_bones

            move_bones(self, before | changed)
        for token, step in weights.items():
            for key in self.shape_keys(token):
                key.value += step
        for joint, move in moves.items():
            self._add_move(joint, move)

    def channels(self, name):
        """(owner, property) of all that holds the value of a control, in the order of its drive."""
        if BONES in self.holder:
            from .bones import bones_of

            bone = bones_of(self).get(name)
            if bone:
                return [(bone, "location")]
        control = self.controls[name]
        found = [(key, "value") for key in self.keys_of(control)]
        for joint in control.joints:
            bone = self.bone(*joint.at)
            if bone:
                moved = np.any(joint.moves, axis=(0, 2))
                parts = (_rotation_path(bone), "location", "scale")
                found += [(bone, part) for part, is_so in zip(parts, moved, strict=True) if is_so]
        if _VALUE + name in self.holder:
            found.append((self.holder, f'["{bpy.utils.escape_identifier(_VALUE + name)}"]'))
        return found

    def insert_keys(self, names, frame=None):
        """Insert keyframes for the controls ``names`` at ``frame``, or the current one."""
        at = {} if frame is None else {"frame": frame}
        for owner, path in dict.fromkeys(each for name in names for each in self.channels(name)):
            group = owner.name if isinstance(owner, bpy.types.PoseBone) else ""
            owner.keyframe_insert(path, group=group, **at)

    def frames_around(self, name, frame):
        """The frames of the last key of a control before a frame and of the first one after it;
        none without both."""
        found = []
        for owner, path in self.channels(name):
            whole = path if owner == owner.id_data else owner.path_from_id(path)
            curves = (each for each in curves_of(owner.id_data) if each.data_path == whole)
            found += frames_of(curves)
        before = [each for each in found if each < frame]
        after = [each for each in found if each > frame]
        return (max(before), min(after)) if before and after else ()

    def widen_ranges(self):
        """Let the shape keys take every value of their controls."""
        for control in self.layout.controls:
            for shape in control.shapes:
                ends = 0.0, 1.0, *shape.weights
                if control.plain:
                    ends = control.minimum, control.maximum
                for key in self.shape_keys(shape.token):
                    key.slider_min = min(key.slider_min, *ends)
                    key.slider_max = max(key.slider_max, *ends)

    def place_meshes(self):
        """Put skinned meshes where the skeleton has them: Blender's import passes over its own
        transform."""
        bpy.context.view_layer.update()
        to_root = self.layout.to_root
        for path, mesh in self.meshes.items():
            for skeleton, armature in self.armatures.items():
                if armature in armatures_of(mesh):
                    to_skeleton = np.linalg.inv(to_root(skeleton)) @ to_root(path)
                    wanted = np.array(armature.matrix_world) @ to_skeleton
                    apart = np.abs(np.array(mesh.matrix_world) - wanted).max()
                    if apart > 1e-6 * np.abs(wanted).max():
                        mesh.matrix_world = mathutils.Matrix(wanted.tolist())

    # --- parts ------------------------------------------------------------------------------------

    def keys_of(self, control):
        """The shape keys that a control moves."""
        return [key for shape in control.shapes for key in self.shape_keys(shape.token)]

    def shape_keys(self, token):
        """The shape keys of a token, one per mesh that has it."""
        return [*filter(None, (self.shape_key(path, token) for path in self.meshes))]

    def shape_key(self, path, token):
        """The shape key of a token on the mesh of a path, or None.

        One that was renamed since the layout was bound is the new name in its place that has its
        points.
        """
        mesh, name = self.meshes[path], self.names.get(path, {}).get(token, token)
        block, sums = mesh.data.shape_keys, self.sums.get(path, {})
        found = block and block.key_blocks.get(name)
        if not found and name in sums:
            there = dict(zip(sums, shape_keys(mesh), strict=False)).get(name)
            if there and there.name not in sums and _sum(there) == sums[name]:
                return there
        return found

    def bone(self, skeleton, joint):
        """The pose bone of a joint, or None."""
        armature = self.armatures.get(skeleton)
        return armature.pose.bones.get(self.bone_name(skeleton, joint)) if armature else None

    def bone_name(self, skeleton, joint):
        """The name that the bone of a joint has, if there is one."""
        return self.names.get(skeleton, {}).get(joint, joint.rpartition("/")[2])

    def missing(self):
        """Names of the controls that nothing in the scene answers to, or not all that did."""
        had = ((path, token) for path in self.meshes for token in self.names.get(path, ()))
        gone = {token for path, token in had if not self.shape_key(path, token)}
        return [
            control.name
            for control in self.layout.controls
            if not (self.keys_of(control) or any(self.bone(*each.at) for each in control.joints))
            or not gone.isdisjoint(shape.token for shape in control.shapes)
        ]

    # --- joints -----------------------------------------------------------------------------------

    def _joint_values(self, controls):
        """Values of the controls that move one joint, read off its bone: those that together make
        its move, nearest in the least squares."""
        joint = controls[0].joints[0].at
        move = move_of(self.bone(*joint), self.layout.frames[joint])
        slopes = np.transpose([_slope(control) for control in controls])
        steps = np.linalg.lstsq(slopes, move.ravel(), rcond=1e-9)[0]
        return {
            control.name: control.default + step
            for control, step in zip(controls, steps, strict=True)
        }

    def _add_move(self, joint, move):
        bone = self.bone(*joint)
        if bone is None:
            return
        frame = self.layout.frames[joint]
        location, rotation, scale = frame.basis(move_of(bone, frame) + move)
        if move[0].any():
            _set_rotation(bone, rotation)
        if move[0].any() or move[1].any():
            bone.location = location
        if move[2].any():
            bone.scale = scale


def _sum(key):
    """A checksum of the points of a shape key."""
    return zlib.crc32(coordinates(key.points))


parsed = lru_cache(maxsize=8)(from_json)
"""`layout.from_json`, remembered: the text of a holder is asked for at every redraw."""


def curves_of(block):
    """The animation curves of a datablock."""
    animation = block.animation_data
    if animation is None or animation.action is None:
        return []
    keyed = animation.action
    if hasattr(keyed, "layers"):  # not in Blender 4.3, in whose window it is tested
        keyed = anim_utils.action_get_channelbag_for_slot(keyed, animation.action_slot)
    return keyed.fcurves if keyed else []


def frames_of(curves):
    """The frames of the keys of animation curves, ascending."""
    return sorted({point.co.x for curve in curves for point in curve.keyframe_points})


def is_single_joint(control):
    """Whether the value can be read off one bone: one joint, moving evenly with the value, and
    nothing else."""
    return len(control.joints) == 1 and not control.shapes and len(control.keys) == 2


def _slope(control):
    """(9,) moves of the joint per unit of the control."""
    first, last = np.array(control.joints[0].moves).reshape(-1, 9)[[0, -1]]
    return (last - first) / (control.keys[-1] - control.keys[0])


def move_of(bone, frame):
    """(3, 3) the move of a bone now, in the `JointFrame` of its joint."""
    location, rotation, scale = bone.matrix_basis.decompose()
    return frame.move(location, np.array(rotation.to_matrix()), scale)


def _rotation_path(bone):
    names = {"QUATERNION": "rotation_quaternion", "AXIS_ANGLE": "rotation_axis_angle"}
    return names.get(bone.rotation_mode, "rotation_euler")


def _set_rotation(bone, rotation):
    turned = mathutils.Matrix(rotation.tolist())
    if bone.rotation_mode == "QUATERNION":
        found = turned.to_quaternion()
        found.make_compatible(bone.rotation_quaternion)
        bone.rotation_quaternion = found
    elif bone.rotation_mode == "AXIS_ANGLE":
        axis, angle = turned.to_quaternion().to_axis_angle()
        bone.rotation_axis_angle = (angle, *axis)
    else:
        bone.rotation_euler = turned.to_euler(bone.rotation_mode, bone.rotation_euler)
