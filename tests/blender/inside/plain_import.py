"""Import a layer as anybody would, without the extension, and save where its handles are over time."""

import bpy
import numpy as np
from scene import job, world_points

task = job()
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.wm.usd_import(filepath=task["layer"], import_guide=True)
saved = {}
for frame in task["frames"]:
    bpy.context.scene.frame_set(frame)
    for name, (mesh, point) in task["anchors"].items():
        saved[f"anchor_{name}_{frame}"] = world_points(bpy.data.objects[mesh])[point]
    for name, (mesh, points) in task["handles"].items():
        saved[f"{name}_{frame}"] = world_points(bpy.data.objects[mesh])[points[0]]
saved["frames"] = np.array([bpy.context.scene.frame_start, bpy.context.scene.frame_end])
np.savez(task["result"], **saved)
