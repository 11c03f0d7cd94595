"""Switch the controls of a native character to bones and back: values, keys, what renders, and no trace."""

import bpy
import native
import numpy as np
from scene import job, world_points

task = job()
meshes, holder, _ = native.laid_out(task)
from usdrigui_controls.bones import handles_of  # noqa: E402
from usdrigui_controls.character import BONES, Character  # noqa: E402


def state():
    """All that bones could leave a trace in."""
    return native.fingerprint(), len(bpy.data.objects), len(bpy.data.meshes), len(bpy.data.armatures)


random, before = np.random.default_rng(4), state()
assert bpy.ops.usdrigui.switch_bones() == {"FINISHED"}
character = Character(holder)
bones = holder[BONES].pose.bones
found = {"worst": 0.0, "points": 0.0}
plain = [each for each in character.controls.values() if each.plain]
found["driven"] = len({c.name for each in handles_of(character.layout) for c in each.controls})


def posed(values):
    """Values and points once Blender has evaluated."""
    character.set_values(values)
    bpy.context.view_layer.update()
    return character.values(), np.concatenate([world_points(each) for each in meshes])


def free():
    """A pose in which one end of each signed axis is away from its base."""
    values = {each.name: random.uniform(each.minimum, each.maximum) for each in plain}
    for handle in handles_of(character.layout):
        for axis in handle.axes.values():
            values.update({axis[0][0].name: axis[0][0].base} if len(axis) > 1 else {})
    return values


poses = [free() for _ in range(3)]
with_bones = [posed(each) for each in poses]
for (read, _), asked in zip(with_bones, poses, strict=True):
    found["worst"] = max(found["worst"], *(abs(read[name] - value) for name, value in asked.items()))
for bone in bones:
    bone.location = (9.0, 9.0, 0.0)
bpy.context.view_layer.update()
character = Character(holder)
read = character.values()
found["clamped"] = max(read[each.name] - each.maximum for each in plain)
character.set_values({each.name: each.base for each in plain})
for frame, pose in zip((1, 11), poses, strict=False):
    character.set_values(pose)
    character.insert_keys(list(pose), frame)
bpy.context.scene.frame_set(11)
keyed = Character(holder).values()
found["keyed"] = max(abs(keyed[name] - value) for name, value in poses[1].items())
found["renders"] = bool(bones[0].custom_shape.users_scene)
assert bpy.ops.usdrigui.switch_bones() == {"FINISHED"}
bpy.context.scene.frame_set(1)
back = Character(holder).values()
found["back"] = max(abs(back[name] - value) for name, value in poses[0].items())
for (_, points), pose in zip(with_bones, poses, strict=True):
    for block in {mesh.data.shape_keys for mesh in meshes} - {None}:
        block.animation_data_clear()
    character = Character(holder)
    found["points"] = max(found["points"], np.abs(posed(pose)[1] - points).max() / np.ptp(points))
character.set_values({each.name: each.base for each in plain})
bpy.context.view_layer.update()
found["trace"] = state() != before
np.savez(task["result"], **found)
