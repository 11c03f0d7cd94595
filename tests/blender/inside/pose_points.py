"""Pose a character through the extension and save where its meshes, handles and tracks are."""

import bpy
import numpy as np
from scene import imported, job, world_points

task = job()
(holder,) = imported(task["layer"])
from usdrigui_controls.anchors import Anchors  # noqa: E402
from usdrigui_controls.character import Character  # noqa: E402

character = Character(holder)
anchors = Anchors(character)
assert not character.missing()
saved = {}
for number, pose in enumerate(task["poses"]):
    character.set_values(pose)
    bpy.context.view_layer.update()
    values = character.values()
    saved[f"values{number}"] = np.array([values[name] for name in pose])
    for i, mesh in enumerate(character.layout.meshes):
        saved[f"mesh{number}_{i}"] = world_points(character.meshes[mesh.path])
    placed = anchors.place(bpy.context.evaluated_depsgraph_get(), values)
    for element, each in zip(character.layout.elements, placed, strict=True):
        saved[f"handle{number}_{element.name}"] = each.handle
        for k, track in enumerate(each.tracks):
            saved[f"track{number}_{element.name}_{k}"] = track
saved["meshes"] = np.array([mesh.path for mesh in character.layout.meshes])
np.savez(task["result"], **saved)

import usdrigui_controls  # noqa: E402

usdrigui_controls.unregister()
