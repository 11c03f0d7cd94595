"""What *Lay Out This Face*, *Make Environment* and *Save USD Animation* say where they cannot work: one line each."""

import shutil
import sys
from types import SimpleNamespace

import bpy
import native
import numpy as np
from scene import enabled, job, refusal

task = job()
enabled(task["python"])
said = {}


def refused(name, operator=None, **options):
    """Keep the line that an operator answers with."""
    said[name] = refusal(operator or bpy.ops.usdrigui.lay_out, **options).removeprefix("Error: ").strip()


def emptied():
    """A scene with nothing in it but the extension."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.preferences.addon_enable(module="usdrigui_controls")


def head(*shapes):
    """A scene with one cube, selected, with shape keys."""
    emptied()
    bpy.ops.mesh.primitive_cube_add()
    cube = bpy.context.object
    for name in ("Basis", *shapes):
        cube.shape_key_add(name=name)
    return cube


emptied()
refused("nothing")
refused("no layer", bpy.ops.usdrigui.load_layout, filepath=__file__)
refused("no controls", bpy.ops.usdrigui.save_animation, filepath=task["result"] + ".usda")
cube = head()
refused("no keys")
cube = head("jaw")
bpy.ops.object.mode_set(mode="EDIT")
refused("edit mode")
bpy.ops.object.mode_set(mode="OBJECT")
cube.modifiers.new("Half", "MIRROR")
refused("mirror")
cube.modifiers.clear()
cube.active_shape_key_index = 1
cube.active_shape_key.mute = True
refused("muted")
cube.active_shape_key.mute = False
preferences = bpy.context.preferences.addons["usdrigui_controls"].preferences
preferences.python = "absent"
refused("no environment")
preferences.python = sys.executable
refused("a python without usdrigui")
whole = shutil.disk_usage
shutil.disk_usage = lambda _path: SimpleNamespace(free=1000)
refused("no room")
refused("no room for the environment", bpy.ops.usdrigui.make_environment)
shutil.disk_usage = whole
refused("no network", bpy.ops.usdrigui.make_environment)
bpy.ops.wm.save_as_mainfile(filepath=task["result"] + ".blend")
emptied()
with bpy.data.libraries.load(task["result"] + ".blend", link=True) as (there, here):
    here.objects = there.objects
bpy.context.scene.collection.objects.link(here.objects[0])
native.choose(here.objects[0])
refused("linked")
np.savez(task["result"], names=list(said), lines=list(said.values()))
