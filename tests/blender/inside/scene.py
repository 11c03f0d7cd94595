"""What the scripts that run inside Blender share: their job, the import, the world points of meshes."""

import json
import sys
from pathlib import Path

import bpy
import numpy as np


def job():
    """The job of this run; makes the extension importable."""
    found = json.loads(Path(sys.argv[-1]).read_text())
    sys.path.insert(0, found["extension"])
    return found


def imported(layer, **options):
    """An empty scene with the extension switched on and a layer imported; the holders of layouts."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    import usdrigui_controls

    usdrigui_controls.register()
    bpy.ops.wm.usd_import(filepath=layer, **options)
    from usdrigui_controls.character import holders

    return holders()


def enabled(python):
    """Switch the extension on as preferences do, with a Python that has usdrigui."""
    bpy.ops.preferences.addon_enable(module="usdrigui_controls")
    bpy.context.preferences.addons["usdrigui_controls"].preferences.python = python


def refusal(work, **options):
    """The line with which an operator refuses; empty where it does not."""
    try:
        work(**options)
    except RuntimeError as error:
        return str(error)
    return ""


def world_points(thing):
    """(n, 3) evaluated vertices of a mesh object in world space."""
    shown = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
    flat = np.zeros(3 * len(shown.data.vertices), dtype=np.float32)
    shown.data.vertices.foreach_get("co", flat)
    matrix = np.array(shown.matrix_world, dtype=np.float64)
    return flat.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]
