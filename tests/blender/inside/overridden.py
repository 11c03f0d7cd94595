"""A linked character with a library override: laid out, keyed, saved and opened again."""

import bpy
import native
import numpy as np
from scene import enabled, job

task = job()
native.build(task["source"])
face = bpy.data.collections["Face"]
for thing in bpy.data.objects:
    for collection in list(thing.users_collection):
        collection.objects.unlink(thing)
    face.objects.link(thing)
library, shot = (f"{task['result']}_{name}.blend" for name in ("library", "shot"))
bpy.ops.wm.save_as_mainfile(filepath=library)
bpy.ops.wm.read_factory_settings(use_empty=True)
enabled(task["python"])
with bpy.data.libraries.load(library, link=True) as (_, here):
    here.collections = ["Face"]
scene = bpy.context.scene
scene.collection.children.link(here.collections[0])
here.collections[0].override_hierarchy_create(scene, bpy.context.view_layer, do_fully_editable=True)
mine = [each for each in scene.objects if each.override_library and each.type == "MESH" and each.data.shape_keys]
for mesh in mine:
    mesh.data.override_create(remap_local_usages=True)
native.choose(mine[0])
bpy.ops.wm.save_as_mainfile(filepath=shot)
assert bpy.ops.usdrigui.lay_out() == {"FINISHED"}
from usdrigui_controls.character import Character, holders  # noqa: E402

character = Character(holders()[0])
name = next(each.name for each in character.layout.controls if each.plain)
character.set_values({name: 0.4})
bpy.ops.wm.save_as_mainfile(filepath=shot)
bpy.ops.wm.open_mainfile(filepath=shot)
(holder,) = holders()
character = Character(holder)
np.savez(task["result"], value=character.values()[name], missing=character.missing(), kind=holder.type)
