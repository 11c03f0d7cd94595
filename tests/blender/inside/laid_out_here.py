"""Press *Lay Out This Face* on native characters, drag, press it again."""

import bpy
import native
import numpy as np
from scene import job

task = job()
_, holder, before = native.laid_out(task)
from usdrigui_controls.character import Character  # noqa: E402
from usdrigui_controls.gizmos import Hand  # noqa: E402
from usdrigui_controls.inbetweens import key_offsets  # noqa: E402


def placed():
    """Where each element is."""
    return {element.name: (element.mesh, element.point) for element in Character(holder).layout.elements}


found = {}
character = Character(holder)
found["controls"], found["missing"] = len(character.controls), character.missing()
found["unchanged"] = native.fingerprint() == before
places = placed()
values = {each.name: 0.5 * each.maximum for each in list(character.controls.values())[::3]}
character.set_values(values)
read = character.values()
found["worst"] = max(abs(read[name] - value) for name, value in values.items())
character.set_values({name: character.controls[name].base for name in values})
pinned = next(each for each in character.layout.elements if each.mesh and len(each.members) == 1)
mesh, (shape, *_) = character.meshes[pinned.mesh], character.controls[pinned.members[0].control].shapes
moved = np.linalg.norm(key_offsets(mesh, character.shape_key(pinned.mesh, shape.token)), axis=1)
vertex = int(np.flatnonzero(moved >= 0.6 * moved.max())[-1])
mesh.data.vertices.foreach_set("select", [i == vertex for i in range(len(moved))])
Hand.chosen = ((holder.name, pinned.name),)
assert bpy.ops.usdrigui.pin() == {"FINISHED"}
assert bpy.ops.usdrigui.lay_out() == {"FINISHED"}
again = placed()
found["pinned"] = again[pinned.name] == (pinned.mesh, vertex) != places[pinned.name]
found["kept"] = sum(places[name] == again.get(name) for name in places) / len(places)
bpy.ops.usdrigui.remove_layout()
found["removed"] = native.fingerprint() == before and not [name for name in list(holder.keys()) if "usdrigui" in name]
np.savez(task["result"], **found)
