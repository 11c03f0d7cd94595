"""The controls in Blender's own window, under a real mouse: what an animator does, step by step."""

import sys

import blender_characters as characters
import blender_window
import numpy as np
import pytest
from pxr import Usd

pytestmark = pytest.mark.skipif(
    bool(blender_window.LACKING), reason=f"not installed: {', '.join(blender_window.LACKING)}"
)
NEAR = 3.0
"""Pixels; the track of a jaw is some eighteen long, and a pointer stands on whole ones."""
METRES_Z_UP = np.array([[0.01, 0, 0, 0], [0, 0, -0.01, 0], [0, 0.01, 0, 0], [0, 0, 0, 1]])


@pytest.fixture(scope="module")
def window(tmp_path_factory, extension):
    """Blender showing the sample."""
    folder = tmp_path_factory.mktemp("window")
    layer, rig, _ = characters.sample(folder)
    sys.path.insert(0, str(extension))
    try:
        from usdrigui_controls.layout import to_json
        from usdrigui_controls.reading import read_layouts
    finally:
        sys.path.remove(str(extension))
    (layout,) = read_layouts(Usd.Stage.Open(str(layer)))
    opened = blender_window.Window(folder, extension, blender_window.described(rig, METRES_Z_UP), to_json(layout))
    yield opened
    opened.close()


@pytest.fixture(autouse=True)
def at_rest(window):
    """The character at rest, seen from the front, nothing switched on."""
    window.ask(
        "look((0, -0.07, 0.0), 0.32)\n"
        "one = character()\n"
        "one.set_values({name: control.base for name, control in one.controls.items()})\n"
        "bpy.context.scene.tool_settings.use_keyframe_insert_auto = False\n"
        "[each.animation_data_clear() for each in bpy.data.shape_keys]\n"
        "for name, value in (('symmetric', False), ('show', True), ('opacity', 0.8)):\n"
        "    setattr(bpy.context.scene.usdrigui, name, value)\n"
        "bpy.ops.ed.undo_push(message='rest')"
    )
    window.hover((60, 400))


def away(window):
    """The controls that are not at rest."""
    return {name: value for name, value in window.values().items() if abs(value) > 1e-3}


def colour(window, name, at):
    """(3,) of a pixel, in a picture that is kept under a name."""
    return np.asarray(window.picture(name))[round(at[1]), round(at[0]), :3].astype(int)


def ends(window, element, member=0):
    """The element's handle, and the far end of one of its tracks, in pixels."""
    track = np.array(window.ask(f"result = track({element!r}, {member})"))
    return np.array(window.ask("result = handles()")[element]), track[-1]


def test_a_patch_follows_the_mouse_and_its_handle_ends_under_it(window):
    start, end = ends(window, "jaw", 2)
    goal = start + 0.8 * (end - start)
    window.drag(start, goal)
    assert away(window) == {"jawOpen": pytest.approx(0.8, abs=0.15)}
    at, _ = ends(window, "jaw")
    assert np.linalg.norm(at - goal) < NEAR
    assert colour(window, "jaw", at).min() > 180, "the handle in hand is white"


def test_two_controls_in_one_drag(window):
    start, down = ends(window, "jaw", 2)
    _, right = ends(window, "jaw", 0)
    goal = start + 0.6 * (down - start) + 0.5 * (right - start)
    window.drag(start, goal)
    assert away(window) == {"jawOpen": pytest.approx(0.6, abs=0.2), "jawRight": pytest.approx(0.5, abs=0.1)}
    assert np.linalg.norm(ends(window, "jaw")[0] - goal) < NEAR


def test_undo_and_redo(window):
    start, end = ends(window, "mouthSmileLeft")
    window.drag(start, end)
    after = away(window)
    assert after == {"mouthSmileLeft": pytest.approx(1.0, abs=0.05)}
    window.key("ctrl+z")
    assert away(window) == {}
    assert np.allclose(ends(window, "mouthSmileLeft")[0], start, atol=0.01)
    window.key("ctrl+shift+z")
    assert away(window) == pytest.approx(after)


def test_escape_takes_the_drag_back(window):
    start, end = ends(window, "browInnerUp")
    window.drag(start, end, release=False)
    assert "browInnerUp" in away(window)
    window.key("Escape")
    window.xdotool("mouseup", 1)
    window.settle()
    assert away(window) == {}


def test_a_symmetric_drag_moves_the_twin_along(window):
    window.ask("bpy.context.scene.usdrigui.symmetric = True")
    start, end = ends(window, "mouthSmileLeft")
    window.drag(start, start + 0.7 * (end - start))
    both = away(window)
    assert both.keys() == {"mouthSmileLeft", "mouthSmileRight"}
    assert both["mouthSmileLeft"] == pytest.approx(both["mouthSmileRight"]) == pytest.approx(0.7, abs=0.1)
    window.picture("symmetric")


def test_shift_drags_finely(window):
    start, end = ends(window, "browOuterUpLeft")
    window.drag(start, end, keys=("shift",))
    assert 0.0 < away(window)["browOuterUpLeft"] < 0.4


def test_a_bone_turns_under_its_handle(window):
    start, end = ends(window, "EyeLeft:ry")
    window.drag(start, end)
    turned = away(window)
    assert turned.keys() == {"EyeLeft:ry"}
    assert abs(turned["EyeLeft:ry"]) > 10.0
    assert window.ask(
        "result = abs(character().bone('/Char/Skeleton', 'Neck/Head/EyeLeft').rotation_quaternion[2]) > 0.05"
    )
    window.picture("eye")


def test_a_joystick_beside_the_face_moves_two_bones_axes(window):
    start, end = ends(window, "head", 0)
    _, other = ends(window, "head", 1)
    window.drag(start, start + 0.5 * (end - start) + 0.5 * (other - start))
    assert away(window).keys() == {"Head:ry", "Head:rx"}
    window.picture("joystick")


def test_auto_keys_and_the_key_i_over_a_handle(window):
    keys = (
        "block = bpy.data.objects['Head'].data.shape_keys\n"
        "curves = block.animation_data.action.fcurves if block.animation_data else []\n"
        "result = {each.data_path: [list(point.co) for point in each.keyframe_points] for each in curves}"
    )
    window.ask("bpy.context.scene.tool_settings.use_keyframe_insert_auto = True\nbpy.context.scene.frame_set(7)")
    start, end = ends(window, "cheekPuff")
    window.drag(start, start + 0.9 * (end - start))
    (frame, value), *none = window.ask(keys)['key_blocks["cheekPuff"].value']
    assert (frame, value, none) == (7.0, pytest.approx(window.values()["cheekPuff"]), [])
    window.ask("bpy.context.scene.frame_set(9)")
    start, _ = ends(window, "browInnerUp")
    assert 'key_blocks["browInnerUp"].value' not in window.ask(keys)
    window.hover(start)
    window.key("i")
    assert window.ask(keys)['key_blocks["browInnerUp"].value'][0][0] == 9.0


def test_hidden_controls_are_neither_drawn_nor_caught(window):
    start, end = ends(window, "mouthSmileLeft")
    blue = colour(window, "shown", start)
    assert blue[2] > blue[0] + 60, "a handle of the character's left is blue"
    window.ask("bpy.context.scene.usdrigui.show = False")
    window.ask("view_region()[0].tag_redraw()")
    window.hover((60, 400))
    skin = colour(window, "hidden", start)
    assert np.ptp(skin) < 25
    window.drag(start, end)
    assert away(window) == {}


def test_opacity(window):
    start, _ = ends(window, "mouthSmileLeft")
    full = colour(window, "opaque", start)
    window.ask("bpy.context.scene.usdrigui.opacity = 0.2\nview_region()[0].tag_redraw()")
    window.settle(0.5)
    faint = colour(window, "faint", start)
    assert np.ptp(faint) < 0.6 * np.ptp(full)


def test_ctrl_and_a_press_put_an_element_back(window):
    window.ask(
        "character().set_values({'mouthSmileLeft': 0.6, 'browInnerUp': 0.5})\nbpy.ops.ed.undo_push(message='posed')"
    )
    start, _ = ends(window, "mouthSmileLeft")
    window.drag(start, np.add(start, (3.0, 0.0)), keys=("ctrl",))
    assert away(window) == {"browInnerUp": pytest.approx(0.5)}
    window.key("ctrl+z")
    assert away(window)["mouthSmileLeft"] == pytest.approx(0.6)


def test_a_click_opens_a_coarse_element_and_closes_it_again(window):
    start, _ = ends(window, "cheekPuff")
    assert "cheekSquintLeft" not in window.ask("result = handles()")
    window.drag(start, start, steps=1)
    shown = window.ask("result = handles()")
    assert "cheekPuff" not in shown
    window.drag(shown["cheekSquintLeft"], shown["cheekSquintLeft"], steps=1)
    shown = window.ask("result = handles()")
    assert "cheekPuff" in shown
    assert "cheekSquintLeft" not in shown
    assert away(window) == {}


def test_a_bone_is_taken_by_the_mouse_moves_its_shape_and_is_undone(window):
    window.ask(
        "area, region, view = view_region()\n"
        "with bpy.context.temp_override(window=view, area=area, region=region):\n"
        "    bpy.context.scene.usdrigui.show = False\n"
        "    bpy.ops.usdrigui.switch_bones()\n"
        "    made = character().holder['usdrigui_bones']\n"
        "    bpy.ops.object.select_all(action='DESELECT')\n"
        "    made.select_set(True)\n"
        "    bpy.context.view_layer.objects.active = made\n"
        "    bpy.ops.object.mode_set(mode='POSE')\n"
        "    bpy.ops.ed.undo_push(message='bones')\n"
    )
    window.settle(0.5)
    where = (
        "made = character().holder['usdrigui_bones']\n"
        "bone = made.pose.bones['browInnerUp']\n"
        "result = [pixel(made.matrix_world @ bone.{}), pixel(made.matrix_world @ bone.tail)]"
    )
    start, end = (np.array(each) for each in window.ask(where.format("head")))
    window.picture("bones")
    window.hover(start)
    window.xdotool("click", 1)
    window.settle(0.3)
    window.key("g")
    window.hover(start + 0.7 * (end - start))
    window.xdotool("click", 1)
    window.settle(0.3)
    window.picture("bone_moved")
    assert away(window) == {"browInnerUp": pytest.approx(0.7, abs=0.15)}
    window.key("ctrl+z")
    window.settle(0.5)
    assert not away(window)
    window.ask("bpy.ops.object.mode_set(mode='OBJECT')\nbpy.ops.usdrigui.switch_bones()")
    assert window.ask("result = [each.name for each in bpy.data.armatures]") == ["Skeleton"]


def test_handles_that_are_chosen_with_shift_are_keyed_and_broken_down_together(window):
    both = {"browInnerUp": 0.8, "mouthSmileLeft": 0.6}
    for element, keys in (("browInnerUp", ()), ("mouthSmileLeft", ("shift",))):
        at, _ = ends(window, element)
        window.drag(at, at, steps=1, keys=keys)
    window.ask(
        "for each in (1, 11):\n"
        "    bpy.context.scene.frame_set(each)\n"
        f"    character().set_values({{name: value * (each > 1) for name, value in {both}.items()}})\n"
        "    bpy.ops.usdrigui.insert_keys()\n"
        "bpy.context.scene.frame_set(6)\n"
        "bpy.ops.usdrigui.breakdown(share=0.25)"
    )
    window.picture("broken_down")
    assert away(window) == pytest.approx({name: 0.25 * value for name, value in both.items()})
