"""Controls as bones, if wanted: an armature beside the character whose bones stand on the handles
and drive its shape keys, so that all that Blender has for bones (channels, poses, NLA) serves the
face.

A bone's own location holds the values: its length is the way from the base to the far end of a
range, along its y and, for the second axis of a patch, its x.  So nothing but the armature is kept.
"""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass

import bpy
import mathutils
import numpy as np

from .anchors import Anchors
from .character import BONES, Character, at_frames, curves_of, frames_of, holders
from .exporting import selection_kept
from .inbetweens import drive
from .maths.handle_track import along

_PALETTES = {"right": "THEME01", "left": "THEME04"}


@dataclass(frozen=True)
class Handle:
    """One bone: the element it stands for and the controls that its location sets."""

    name: str
    element: int
    axes: dict
    """By component of the location, y first: (control, +1 or -1) pairs."""

    @property
    def controls(self):
        """Those of all axes."""
        return [control for axis in self.axes.values() for control, _ in axis]


def handles_of(layout):
    """The bones of a layout: one for a slider or a patch, one for each axis of a fan; for controls
    of one shape alone, since joints are bones already."""
    plain = {each.name: each for each in layout.controls if each.plain and each.maximum > each.base}
    found = []
    for number, element in enumerate(layout.elements):
        names = [member.control for member in element.members]
        axes = [
            tuple((plain[names[i]], 1.0 if i == axis[-1] else -1.0) for i in axis)
            for axis in element.axes
            if all(names[i] in plain for i in axis)
        ]
        for axis in axes:
            for control, _ in axis:
                del plain[control.name]  # it has its bone
        parts = [axes] if 0 < len(axes) < 3 else [[axis] for axis in axes]
        for axes_here in parts:
            label = element.name if len(parts) == 1 else axes_here[0][-1][0].name
            found.append(Handle(label, number, dict(zip((1, 0), axes_here, strict=False))))
    return found


def move_bones(character, values):
    """Put the bones where control ``values``, by name, have them."""
    for handle, bone in _bones(character):
        for component, axis in handle.axes.items():
            bone.location[component] = bone.bone.length * sum(
                sign * _share(control, values[control.name]) for control, sign in axis
            )


def bones_of(character):
    """By control, the bone that has its value."""
    return {control.name: bone for handle, bone in _bones(character) for control in handle.controls}


def _bones(character):
    """(`Handle`, bone) of all that are there."""
    bones = character.holder[BONES].pose.bones
    handles = handles_of(character.layout)
    return [(each, bones[each.name]) for each in handles if each.name in bones]


def make_bones(holder):
    """Build the armature of a character; its bones drive the shape keys, and have their keys."""
    character = Character(holder)
    values, tracks = character.values(), _curves(character)
    anchors = Anchors(character)
    placed = anchors.place(bpy.context.evaluated_depsgraph_get(), values)
    handles = [each for each in handles_of(character.layout) if placed[each.element] is not None]
    made = bpy.data.objects.new(f"{holder.name} controls", bpy.data.armatures.new("Controls"))
    made.show_in_front = True
    bpy.context.scene.collection.objects.link(made)
    with _editing(made):
        for handle in handles:
            _add_bone(made, handle, anchors, placed[handle.element])
    shape = bpy.data.objects.new("Control", None)  # in no scene
    shape.empty_display_type = "CIRCLE"
    for handle in handles:
        bone, element = made.pose.bones[handle.name], anchors.layout.elements[handle.element]
        bone.custom_shape, bone.use_custom_shape_bone_size = shape, False
        size = 0.5 * placed[handle.element].scale * element.width
        bone.custom_shape_scale_xyz = [size] * 3
        bone.custom_shape_rotation_euler.x = 0.5 * np.pi  # flat on the skin
        bone.lock_rotation = bone.lock_scale = [True] * 3
        bone.color.palette = _PALETTES.get(element.side, "THEME03")
        _drive(character, bone, handle)
        child = bone.constraints.new("CHILD_OF")
        carrier = _carrier(anchors.spots[handle.element])
        child.target, child.subtarget, child.inverse_matrix = carrier
    holder[BONES] = made
    for frame in frames_of(tracks.values()):
        then = {name: curve.evaluate(frame) for name, curve in tracks.items()}
        move_bones(character, values | then)
        character.insert_keys(tracks, frame)
    move_bones(character, values)


def remove_bones(holder):
    """Take the armature away; the shape keys have its values, and the keys that they lack."""
    character, made = Character(holder), holder[BONES]
    driven = [*bones_of(character)]
    seen = at_frames(frames_of(curves_of(made)), character.values)
    now = character.values()
    for name in driven:
        for key in character.keys_of(character.controls[name]):
            key.driver_remove("value")
            animation = key.id_data.animation_data
            if not animation.action and not animation.drivers:
                key.id_data.animation_data_clear()
    # The shape of its bones goes with it.
    shapes = {bone.custom_shape for bone in made.pose.bones}
    bpy.data.armatures.remove(made.data)
    bpy.data.batch_remove(shapes - {None})
    del holder[BONES]
    tracks = _curves(character)
    for frame, values in seen.items():
        for name in driven:
            had = tracks[name].evaluate(frame) if name in tracks else now[name]
            if abs(had - values[name]) > 1e-5:
                character.set_values({name: values[name]})
                character.insert_keys([name], frame)
    character.set_values({name: now[name] for name in driven})


def _curves(character):
    """By control, the curve of its shape key, of those that have one."""
    return {
        control.name: curve
        for control in character.layout.controls
        if control.plain
        for key in character.keys_of(control)
        for curve in curves_of(key.id_data)
        if curve.data_path == key.path_from_id("value")
    }


# --- one bone -------------------------------------------------------------------------------------


@contextmanager
def _editing(armature):
    """The armature in edit mode; then mode and selection as they were."""
    mode = bpy.context.mode
    with selection_kept():
        if mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        bpy.context.view_layer.objects.active = armature
        bpy.ops.object.mode_set(mode="EDIT")
        yield
        bpy.ops.object.mode_set(mode="OBJECT")
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode=mode)


def _add_bone(made, handle, anchors, placed):
    """A bone along its first axis, flat on the skin."""
    spot = anchors.spots[handle.element]
    drawing = spot.drawing
    names = [member.control for member in drawing.element.members]
    ways = []
    for axis in handle.axes.values():
        member = names.index(axis[-1][0].name)
        track = placed.tracks[member]
        head = along(drawing.values[member], track, drawing.base[member])
        ways.append((head, mathutils.Vector(track[-1] - head)))
    (head, way), *others = ways
    normal = mathutils.Vector(placed.normal)
    if any(normal.dot(other.cross(way)) < 0.0 for _, other in others):
        normal.negate()
    bone = made.data.edit_bones.new(handle.name)
    bone.head = head
    bone.tail = bone.head + way.normalized() * max(way.length, 1e-4 * placed.scale)
    bone.align_roll(normal)
    bone.use_deform = False


def _carrier(spot):
    """What carries an element, mostly a bone, as the target of a constraint: its object, the bone's
    name, and the inverse of where it is now."""
    name, _ = max(spot.influences, key=lambda pair: pair[1], default=("", 1.0))
    place = spot.carrier.matrix_world
    if name:
        place = place @ spot.carrier.pose.bones[name].matrix
    return spot.carrier, name, place.inverted()


def _share(control, value):
    return (value - control.base) / (control.maximum - control.base)


def _drive(character, bone, handle):
    """Drivers from the location of a bone to the shape keys, within the ranges; and these are its
    limits, on its axes."""
    limit, length = bone.constraints.new("LIMIT_LOCATION"), bone.bone.length
    limit.owner_space, limit.use_transform_limit = "LOCAL", True
    bone.lock_location = [len(handle.axes) < 2, False, True]
    for part in "xyz":
        setattr(limit, f"use_min_{part}", True)
        setattr(limit, f"use_max_{part}", True)
    for component, axis in handle.axes.items():
        path, reached = f"{bone.path_from_id('location')}[{component}]", []
        for control, sign in axis:
            ends = (control.base if len(axis) > 1 else control.minimum, control.maximum)
            points = sorted((sign * length * _share(control, end), end) for end in ends)
            reached += [at for at, _ in points]
            for key in character.keys_of(control):
                drive(key, ("OBJECT", bone.id_data), path, points, "CONSTANT")
        setattr(limit, f"min_{'xyz'[component]}", min(reached))
        setattr(limit, f"max_{'xyz'[component]}", max(reached))


class SwitchBones(bpy.types.Operator):
    """Let bones with custom shapes drive the shape keys; or take them away and keep the values."""

    bl_idname = "usdrigui.switch_bones"
    bl_label = "Controls as Bones"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, _context):
        """Switch all characters: on, unless one has them."""
        held = holders()
        with_bones = [each for each in held if BONES in each]
        for holder in with_bones or held:
            (remove_bones if with_bones else make_bones)(holder)
        return {"FINISHED"}
