"""Install the archive as users do, import, key, save and open again; and load a layout by the menu."""

import importlib

import bpy
import numpy as np
from scene import job, refusal

task = job()
bpy.ops.preferences.addon_enable(module="bl_pkg")
bpy.ops.extensions.package_install_files(filepath=task["archive"], repo="user_default", enable_on_install=True)
module = "bl_ext.user_default.usdrigui_controls"
assert module in bpy.context.preferences.addons
assert hasattr(bpy.types.Scene, "usdrigui")

room = importlib.import_module(f"{module}.character")


def character():
    """The only one in the scene."""
    (holder,) = room.holders()
    return room.Character(holder)


bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=False)
for each in list(bpy.data.objects):
    bpy.data.objects.remove(each)
bpy.ops.wm.usd_import(filepath=task["layer"])
for frame, value in ((60, 0.25), (70, 0.75)):
    bpy.context.scene.frame_set(frame)
    character().set_values({"mouthSmileLeft": value, "EyeLeft:ry": 10 * value})
    character().insert_keys(["mouthSmileLeft", "EyeLeft:ry"])
bpy.ops.wm.save_as_mainfile(filepath=task["result"] + ".blend")
bpy.ops.wm.open_mainfile(filepath=task["result"] + ".blend")
keyed = []
for frame in (60, 70):
    bpy.context.scene.frame_set(frame)
    keyed.append([character().values()[name] for name in ("mouthSmileLeft", "EyeLeft:ry")])
bpy.context.scene.frame_set(60)
bpy.ops.usdrigui.reset(everything=True)
character().set_values({"jawLeft": 0.5})
bpy.ops.usdrigui.mirror(side="both")
flipped = [character().values()[name] for name in ("jawLeft", "jawRight")]
bpy.ops.usdrigui.reset(everything=True)
rest = np.abs(list(character().values().values())).max()
bpy.ops.usdrigui.remove_layout()
assert not room.holders()
assert bpy.ops.usdrigui.load_layout(filepath=task["layer"]) == {"FINISHED"}
loaded = len(character().layout.elements)
refused = [refusal(bpy.ops.usdrigui.load_layout, filepath=task["source"])]
mesh = next(each for each in character().meshes.values() if each.data.shape_keys)
key = mesh.data.shape_keys.key_blocks["jawLeft"]
key.name = "Kiefer links"
character().set_values({"jawLeft": 0.5})
assert key.value == 0.5
lost = importlib.import_module(f"{module}.interface").lost
assert not lost()
key.points[0].co.x += 1.0  # nothing tells now which key this was
assert "of jawLeft is gone" in lost()
mesh.shape_key_clear()
bpy.ops.object.select_all(action="SELECT")
for spoil in (lambda: mesh.data.vertices.add(1), bpy.ops.object.duplicate):
    spoil()
    refused.append(refusal(bpy.ops.usdrigui.save_animation, filepath=task["result"] + ".usda"))
np.savez(task["result"], keyed=keyed, flipped=flipped, rest=rest, loaded=loaded, refused=refused)
bpy.ops.preferences.addon_disable(module=module)
