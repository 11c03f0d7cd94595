"""Characters that are native to Blender: given rigs through Blender's own importer, then renamed, parented, put
into collections and given modifiers, as a file of an animator has them; and what may not change in them."""

import hashlib

import bpy
import numpy as np
from scene import enabled


def build(source, scene="plain"):
    """Import a rig without the extension and make it one's own; returns its meshes."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.wm.usd_import(filepath=source)
    for holder in [each for each in bpy.data.objects if each.type == "EMPTY" and each.parent is None]:
        holder.name = "Grp Character"
    meshes = [each for each in bpy.data.objects if each.type == "MESH"]
    _make_own(meshes, [each for each in bpy.data.objects if each.type == "ARMATURE"])
    if scene == "modified":
        _modify(meshes)
    bpy.context.view_layer.update()
    return meshes


def _make_own(meshes, armatures):
    """Names of an animator, a collection of its own, and another parent."""
    face = bpy.data.collections.new("Face")
    bpy.context.scene.collection.children.link(face)
    for number, mesh in enumerate(meshes):
        mesh.name, mesh.data.name = f"geo.{number} Kopf", f"Mesh{number}.001"
        for collection in list(mesh.users_collection):
            collection.objects.unlink(mesh)
        face.objects.link(mesh)
    for number, armature in enumerate(armatures):
        armature.name, armature.data.name = f"Rig {number}", f"rig.data.{number}"


def _modify(meshes):
    for mesh in meshes:
        mesh.modifiers.new("Smooth", "SUBSURF").levels = 1
        mesh.modifiers.new("Corrective", "CORRECTIVE_SMOOTH").show_viewport = False
        block = mesh.data.shape_keys
        if block is not None:
            block.key_blocks[1].name = "Mund auf 口"
            block.key_blocks[2].name = block.key_blocks[2].name + ".left"
            block.key_blocks[3].relative_key = block.key_blocks[4]


def laid_out(task):
    """A native character once its button was pressed: its meshes, what holds the layout, and the digest before."""
    meshes = build(task["source"], task["scene"])
    enabled(task["python"])
    from usdrigui_controls.character import holders
    from usdrigui_controls.inbetweens import shape_keys

    bpy.ops.wm.save_as_mainfile(filepath=task["result"] + ".blend")
    choose(max(meshes, key=lambda each: len(shape_keys(each))))
    before = fingerprint()
    assert bpy.ops.usdrigui.lay_out() == {"FINISHED"}
    (holder,) = holders()
    return meshes, holder, before


def fingerprint():
    """A digest of all that makes up the rig: points, keys, groups, bones, modifiers, drivers, constraints, places."""
    digest = hashlib.sha256()

    def add(*values):
        for value in values:
            digest.update(value.tobytes() if isinstance(value, np.ndarray) else repr(value).encode())

    for thing in sorted(bpy.data.objects, key=lambda each: each.name):
        parent = thing.parent.name if thing.parent else ""
        add(
            thing.name, thing.type, parent, np.array(thing.matrix_world), [each.name for each in thing.users_collection]
        )
        add(*((each.name, each.type, each.show_viewport, each.show_render) for each in thing.modifiers))
        add(*(each.name for each in thing.constraints), thing.hide_viewport, thing.hide_render, thing.select_get())
        if thing.type == "MESH":
            add(thing.data.name, np.array([vertex.co for vertex in thing.data.vertices], dtype=np.float32))
            add(*(group.name for group in thing.vertex_groups))
            block = thing.data.shape_keys
            for key in block.key_blocks if block else ():
                add(
                    key.name,
                    key.value,
                    key.slider_min,
                    key.slider_max,
                    key.mute,
                    key.relative_key.name,
                    key.vertex_group,
                )
                add(np.array([point.co for point in key.data], dtype=np.float32))
            add(len(block.animation_data.drivers) if block and block.animation_data else 0)
        if thing.type == "ARMATURE":
            for bone in thing.pose.bones:
                # A pose that was taken back is so to single precision.
                add(bone.name, np.array(bone.bone.matrix_local), np.round(np.array(bone.matrix_basis), 5) + 0.0)
                add(len(bone.constraints))
                add(bone.rotation_mode, bone.custom_shape, bone.parent.name if bone.parent else "")
    return digest.hexdigest()


def choose(thing):
    """Select one object alone."""
    for each in bpy.context.view_layer.objects:
        each.select_set(each == thing)
    bpy.context.view_layer.objects.active = thing
