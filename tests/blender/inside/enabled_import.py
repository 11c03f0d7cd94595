"""Import a layer with the extension switched on; and load its layout by the menu, which needs USD in Python."""

import bpy
import numpy as np
from scene import imported, job, refusal

task = job()
holders = imported(task["layer"], import_guide=True)
from usdrigui_controls.importing import has_usd  # noqa: E402

refused = refusal(bpy.ops.usdrigui.load_layout, filepath=task["layer"])
drawn = [each for each in bpy.data.objects if each.name.endswith("Controls")]
np.savez(
    task["result"],
    objects=len(bpy.data.objects),
    layouts=len(holders),
    usd=has_usd(),
    refused=refused,
    hidden=all(each.hide_render and each.hide_viewport for each in drawn) and len(drawn),
)

import usdrigui_controls  # noqa: E402

usdrigui_controls.unregister()
