"""A character in Blender's window, and a hand for the test: code that it sends is run between two redraws.

The character is built from arrays, so that Blenders without a USD importer of their own can show it.
"""

import contextlib
import io
import json
import traceback
from pathlib import Path

import bpy
import mathutils
import numpy as np
from scene import job

TASK = job()
FOLDER = Path(TASK["result"]).parent


def build(rig):
    """The character's objects by prim path: root empty, armature and meshes, in metres and Z up."""
    root = bpy.data.objects.new("Char", None)
    root.matrix_world = mathutils.Matrix(rig["to_world"])
    bpy.context.collection.objects.link(root)
    armature = _armature(rig["skeleton"], root)
    objects = {rig["skeleton"]["path"]: armature}
    for mesh in rig["meshes"]:
        objects[mesh["path"]] = _mesh(mesh, armature, root)
    return objects


def _armature(skeleton, root):
    made = bpy.data.objects.new("Skeleton", bpy.data.armatures.new("Skeleton"))
    bpy.context.collection.objects.link(made)
    made.parent = root
    bpy.context.view_layer.objects.active = made
    bpy.ops.object.mode_set(mode="EDIT")
    for joint in skeleton["joints"]:
        bone = made.data.edit_bones.new(joint["name"])
        bone.head, bone.tail = (0.0, 0.0, 0.0), (0.0, 1.0, 0.0)
        bone.matrix = mathutils.Matrix(joint["bind"])
        if joint["parent"]:
            bone.parent = made.data.edit_bones[joint["parent"]]
    bpy.ops.object.mode_set(mode="OBJECT")
    for bone in made.pose.bones:
        bone.rotation_mode = "QUATERNION"
    return made


def _mesh(mesh, armature, root):
    data = bpy.data.meshes.new(mesh["name"])
    data.from_pydata(mesh["points"], [], mesh["faces"])
    made = bpy.data.objects.new(mesh["name"], data)
    bpy.context.collection.objects.link(made)
    made.parent = root
    made.matrix_local = mathutils.Matrix(mesh["to_root"])
    for polygon in data.polygons:
        polygon.use_smooth = True
    made.shape_key_add(name="Basis")
    points = np.array(mesh["points"])
    for token, indices, offsets in mesh["shapes"]:
        moved = points.copy()
        moved[indices] += offsets
        made.shape_key_add(name=token).data.foreach_set("co", moved.ravel())
    for name, indices, weights in mesh["groups"]:
        group = made.vertex_groups.new(name=name)
        for index, weight in zip(indices, weights, strict=True):
            group.add([index], weight, "REPLACE")
    made.modifiers.new("Armature", "ARMATURE").object = armature
    return made


def view_region():
    """(area, region, window) of the 3-D view."""
    window = bpy.context.window_manager.windows[0]
    area = next(each for each in window.screen.areas if each.type == "VIEW_3D")
    return area, next(each for each in area.regions if each.type == "WINDOW"), window


def pixel(point):
    """(x, y) on the screen, y down, of a world point."""
    from bpy_extras.view3d_utils import location_3d_to_region_2d

    area, region, window = view_region()
    at = location_3d_to_region_2d(region, area.spaces.active.region_3d, mathutils.Vector(point))
    return [region.x + at.x, window.height - (region.y + at.y)]


def handles():
    """Screen pixels of the middle of every handle that is drawn, by element."""
    from usdrigui_controls import visibility

    return {item.element.name: pixel(item.placed.handle) for item in visibility.items()}


def track(name, member=0):
    """Screen pixels of a track."""
    from usdrigui_controls import visibility

    item = next(each for each in visibility.items() if each.element.name == name)
    return [pixel(point) for point in item.placed.tracks[member]]


def character():
    """The character in the scene."""
    from usdrigui_controls.character import Character, holders

    return Character(holders()[0])


def look(centre, distance, yaw=0.0):
    """Look at the face from the front, turned by `yaw` radians."""
    area, _, _ = view_region()
    view = area.spaces.active.region_3d
    view.view_perspective = "PERSP"
    view.view_rotation = mathutils.Euler((np.pi / 2, 0.0, yaw)).to_quaternion()
    view.view_location, view.view_distance = mathutils.Vector(centre), distance
    area.tag_redraw()


def _serve():
    asked, told = FOLDER / "asked.json", FOLDER / "told.json"
    if asked.exists():
        with contextlib.suppress(json.JSONDecodeError):
            question = json.loads(asked.read_text())
            asked.unlink()
            told.with_suffix(".new").write_text(json.dumps(_answer(question)))
            told.with_suffix(".new").rename(told)
    return 0.02


def _answer(code):
    out = io.StringIO()
    space = dict(globals())
    try:
        with contextlib.redirect_stdout(out):
            exec(code, space)
    except Exception:
        return {"error": traceback.format_exc()}
    return {"result": space.get("result")}


def _start():
    import usdrigui_controls
    from usdrigui_controls.character import bind
    from usdrigui_controls.layout import from_json

    for each in list(bpy.data.objects):
        bpy.data.objects.remove(each)
    usdrigui_controls.register()
    objects = build(json.loads(Path(TASK["rig"]).read_text()))
    bind(from_json(Path(TASK["layout"]).read_text()), objects, {})
    area, _, window = view_region()
    with bpy.context.temp_override(window=window, area=area):
        for each in list(window.screen.areas):
            if each.type in ("DOPESHEET_EDITOR", "TIMELINE"):
                each.type = "INFO"
        area.spaces.active.overlay.show_floor = False
    bpy.ops.ed.undo_push(message="Scene")
    (FOLDER / "ready").write_text("")


bpy.context.preferences.view.show_splash = False
bpy.app.timers.register(_start, first_interval=0.5)
bpy.app.timers.register(_serve, first_interval=1.0, persistent=True)
