"""Animate a native character by its controls, its bones and its object, save the layer, and keep where Blender has
its points."""

import bpy
import native
import numpy as np
from scene import job, world_points

task = job()
meshes, holder, _ = native.laid_out(task)
from usdrigui_controls.character import Character  # noqa: E402

character = Character(holder)
random = np.random.default_rng(3)
scene = bpy.context.scene
scene.frame_start, scene.frame_end = 1, 24
some = list(character.controls.values())[:: max(1, len(character.controls) // 9)]
for frame in (1, 9, 17, 24):
    scene.frame_set(frame)
    character = Character(holder)
    character.set_values({each.name: random.uniform(each.minimum, each.maximum) for each in some})
    character.insert_keys([each.name for each in some])
    for armature in character.armatures.values():
        for bone in list(armature.pose.bones)[:6]:
            bone.rotation_mode = "XYZ"
            bone.rotation_euler = random.uniform(-0.3, 0.3, 3)
            bone.keyframe_insert("rotation_euler")
    top = holder.parent or holder
    top.location = random.uniform(-1.0, 1.0, 3)
    top.keyframe_insert("location")
before = scene.frame_current
assert bpy.ops.usdrigui.save_animation(filepath=task["target"], with_values=True) == {"FINISHED"}
assert scene.frame_current == before
for mesh in meshes:
    for modifier in mesh.modifiers:
        modifier.show_viewport = modifier.type == "ARMATURE"
saved = {"paths": np.array(list(character.meshes), dtype=str)}
for frame in range(1, 25):
    scene.frame_set(frame)
    for i, mesh in enumerate(Character(holder).meshes.values()):
        saved[f"{frame}_{i}"] = world_points(mesh)
np.savez(task["result"], **saved)
