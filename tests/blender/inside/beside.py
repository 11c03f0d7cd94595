"""A character and its copy, which has names of its own, each laid out by itself; then both on one parent."""

import bpy
import native
from scene import job

head = native.laid_out(job())[0][0]
from usdrigui_controls.character import Character, holders  # noqa: E402


def pressed(mesh):
    """The places of two characters without an object in common, once a face was laid out."""
    native.choose(mesh)
    assert bpy.ops.usdrigui.lay_out() == {"FINISHED"}
    one, other = map(Character, holders())
    assert {*one.objects.values()}.isdisjoint(other.objects.values())
    return [{each.name: each.point for each in face.layout.elements if each.mesh} for face in (one, other)]


bpy.ops.object.select_all(action="SELECT")
bpy.ops.object.duplicate()
copy = bpy.context.object
places, copied = pressed(copy)
assert places == copied
bpy.ops.object.empty_add()
for thing in bpy.data.objects:
    if thing != bpy.context.object:
        thing.parent = bpy.context.object
pressed(head)
pressed(copy)
