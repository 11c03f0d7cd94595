"""The face fills the view, the board is a strip beside it, nothing overlaps under the pointer, fingers pose."""

from dataclasses import replace
from itertools import cycle

import laid_out
import makers
import numpy as np
import pytest
from viewer_layouts import peak_layout

from usdrigui.model import LayoutPart
from usdrigui.view.web.page import page_html

SIZES = {"desk": (1366, 768), "tablet": (820, 1180), "phone": (390, 844)}
BOARD = ("chin", "jawLeft")


def characters():
    rig = makers.face()
    return [(rig, peak_layout(rig, beside=BOARD))]


@pytest.fixture
def shown(opened, page_path):
    return lambda size: opened(page_path, SIZES[size])


def on_face(viewer):
    return [each for each in viewer.page.evaluate("usdrigui.elements()") if each["name"] not in BOARD]


@pytest.mark.parametrize("size", SIZES)
def test_the_face_fills_what_the_board_leaves(shown, size):
    viewer = shown(size)
    dock, column = viewer.page.evaluate("[usdrigui.app.view.overlay.dock.rect, usdrigui.app.view.columns[0]]")
    if size == "desk":
        assert dock["left"] == column["width"]
    else:
        assert dock["top"] == column["height"]
    points = [point for each in on_face(viewer) for point in (each["handle"], *each["tracks"][0])]
    spans = [max(p[axis] for p in points) - min(p[axis] for p in points) for axis in (0, 1)]
    assert all(0 <= x <= column["width"] and 0 <= y <= column["height"] for x, y in points)
    assert max(spans[0] / column["width"], spans[1] / column["height"]) > 0.5
    assert not viewer.page.locator(".list").is_visible()


@pytest.mark.parametrize("size", SIZES)
def test_a_handle_of_the_board_is_dragged_where_it_is_drawn(shown, size):
    viewer = shown(size)
    element = viewer.element("chin")
    (start, *_, end) = element["tracks"][0]
    target = [a + 0.5 * (b - a) for a, b in zip(start, end, strict=True)]
    viewer.drag(element["handle"], target)
    assert viewer.moved() == pytest.approx({"chin": 0.5}, abs=0.02)
    assert viewer.element("chin")["handle"] == pytest.approx(target, abs=0.5)


def test_the_first_handle_is_two_tab_stops_away(shown):
    viewer = shown("desk")
    viewer.key("Tab")
    viewer.key("Tab")
    assert viewer.page.evaluate("document.activeElement.dataset.element")


def test_keys_hide_elements_and_show_the_pose_before_while_they_are_held(shown):
    viewer = shown("desk")
    viewer.set(pucker=0.7)
    shown = "getComputedStyle(document.querySelector('.marks')).visibility"
    viewer.page.keyboard.down("h")
    assert viewer.page.evaluate(shown) == "hidden"
    viewer.page.wait_for_timeout(300)
    viewer.page.keyboard.up("h")
    assert viewer.page.evaluate(shown) == "visible"
    assert viewer.page.evaluate("usdrigui.app.session.options.handles")
    viewer.page.keyboard.down("b")
    assert viewer.moved() == {}
    viewer.page.keyboard.up("b")
    assert viewer.moved() == {"pucker": 0.7}


def test_influence_is_gone_after_a_release_until_something_is_pointed_at(shown):
    viewer = shown("desk")
    element = viewer.element("brow_L")
    heated = "Boolean(usdrigui.app.view.stage.heated)"
    viewer.page.mouse.move(*viewer.on_page(element["handle"]))
    viewer.settle()
    assert viewer.page.evaluate(heated)
    viewer.drag(element["handle"], [element["handle"][0], element["handle"][1] - 8])
    assert not viewer.page.evaluate(heated)
    viewer.page.keyboard.down("i")
    viewer.settle()
    assert viewer.page.evaluate(heated)
    viewer.page.keyboard.up("i")
    viewer.settle()
    assert not viewer.page.evaluate(heated)


def test_a_double_click_looks_closely_and_another_back(shown):
    viewer = shown("desk")
    distance = "usdrigui.app.view.camera.distance"
    far = viewer.page.evaluate(distance)
    middle = viewer.page.evaluate(
        "[usdrigui.app.view.columns[0].width / 2, usdrigui.app.view.columns[0].height * 0.45]"
    )
    viewer.page.mouse.dblclick(*viewer.on_page(middle))
    assert viewer.page.evaluate(distance) < 0.5 * far
    viewer.page.mouse.dblclick(*viewer.on_page(middle))
    assert viewer.page.evaluate(distance) == pytest.approx(far)


PARTS = (("interior", ("chin",)), ("face", ("brow_L", "brow_R", "pucker")), ("hands", ("jawLeft", "jawRight")))
TITLES = {"interior": "inside the mouth"}


def test_each_part_has_a_tab_and_the_first_is_shown(opened, tmp_path):
    """A part without handles on the character, as the inside of a mouth, is looked at in the face."""
    rig = makers.face()
    layout = peak_layout(rig, beside=("chin",))
    names = {name: part for part, members in PARTS for name in members}
    elements = tuple(replace(each, part=names[each.name]) for each in layout.elements if each.name in names)
    given = {
        "face": (0.04, layout.frame.view),
        "interior": (0.01, layout.frame.view),
        "hands": (0.08, np.array([1.0, 0.0, 0.0])),
    }
    parts = tuple(LayoutPart(part, *seen, "optimal", 0.0, 0.0) for part, seen in given.items())
    path = tmp_path / "parts.html"
    path.write_text(
        page_html([(rig, replace(layout, elements=elements, frame=replace(layout.frame, parts=parts)))], "parts")
    )
    viewer, targets = opened(path), {}
    for part, members in PARTS:
        viewer.page.get_by_role("button", name=TITLES.get(part, part), exact=True).click()
        viewer.settle()
        assert {each["name"] for each in viewer.page.evaluate("usdrigui.elements()")} == set(members)
        targets[part] = viewer.page.evaluate("usdrigui.app.view.camera.target")
    assert targets["interior"] == pytest.approx(targets["face"], abs=0.05)
    assert viewer.page.evaluate("usdrigui.app.view.camera.towards") == pytest.approx([1.0, 0.0, 0.0], abs=1e-6)


@pytest.mark.parametrize("size", [(2560, 1440), (1366, 768), (1024, 700), (820, 1180), (390, 844)])
def test_what_is_always_needed_is_in_sight_and_the_rest_is_in_a_menu(opened, tmp_path, size):
    """Of a character in seven parts, as a body without names of shapes is."""
    rig = makers.face()
    layout = peak_layout(rig)
    parts = ("face", "inside the mouth", "eyes", "left hand and arm", "right hand and arm", "feet and legs", "body")
    path = tmp_path / "parts.html"
    path.write_text(page_html([(rig, laid_out.parted(layout, dict.fromkeys(parts, 0.04), cycle(parts)))], "p"))
    viewer = opened(path, size)
    for name in ("Undo", "Redo", "Key", "Panel", "Shortcuts"):
        box = viewer.page.get_by_role("button", name=name, exact=True).bounding_box()
        assert box["x"] >= 0 <= box["y"], name
        assert box["x"] + box["width"] <= size[0], name
    menu = viewer.page.locator(".menu summary")
    assert menu.is_visible() == (size[0] < 2560)
    if menu.is_visible():
        menu.click()
    for name in ("body", "Symmetry", "List", "Review", "Handles", "On copy", "Rearrange", "View: Side"):
        box = viewer.page.get_by_role("button", name=name, exact=True).bounding_box()
        assert box["x"] >= 0, name
        assert box["x"] + box["width"] <= size[0], name
    tag = "[...document.querySelectorAll('.side-tag')].map((each) => getComputedStyle(each).color)"
    assert viewer.page.evaluate(tag) == ["rgb(244, 245, 247)"] * 2, "words are not in the colours of marks"
    viewer.click("Symmetry", exact=True)
    assert viewer.page.evaluate("usdrigui.app.session.options.symmetric")


# --- fingers -----------------------------------------------------------------------------------------


def test_one_finger_poses_and_two_hold_the_camera(shown):
    viewer = shown("phone")
    element = viewer.element("brow_L")
    end = element["tracks"][0][-1]
    viewer.touch("touchStart", [element["handle"][0] + 9, element["handle"][1] + 9])
    for share in (0.25, 0.5):
        viewer.touch("touchMove", [h + 9 + share * (e - h) for h, e in zip(element["handle"], end, strict=True)])
    viewer.touch("touchEnd")
    moved = viewer.moved(0.01)
    assert moved == pytest.approx({"brow_L": 0.5}, abs=0.02)
    far = viewer.page.evaluate("usdrigui.app.view.camera.distance")
    viewer.touch("touchStart", [150, 200])
    viewer.touch("touchStart", [150, 200], [250, 200])
    viewer.touch("touchMove", [100, 200], [300, 200])
    viewer.touch("touchEnd", [100, 200])
    viewer.touch("touchEnd")
    assert viewer.page.evaluate("usdrigui.app.view.camera.distance") == pytest.approx(far / 2, rel=0.02)
    assert viewer.moved(0.01) == moved


def test_a_finger_that_rests_on_the_skin_pins_it_and_a_tap_takes_the_pin_out(shown):
    viewer = shown("phone")
    viewer.option("handles", False)
    at = viewer.page.evaluate("[usdrigui.app.view.columns[0].width / 2, usdrigui.app.view.columns[0].height * 0.45]")
    pins = "usdrigui.app.session.pins.length"
    viewer.touch("touchStart", at)
    viewer.until(f"{pins} === 1")
    viewer.touch("touchMove", [at[0] + 40, at[1] - 30])
    viewer.touch("touchEnd")
    assert (viewer.page.evaluate(pins), viewer.moved()) == (1, {})
    head = viewer.page.evaluate("usdrigui.app.view.overlay.pinned[0].slice(0, 2)")
    viewer.touch("touchStart", [head[0] + 5 - 15, head[1] - 15])
    viewer.touch("touchEnd")
    assert viewer.page.evaluate(pins) == 0


def test_a_question_mark_shows_the_keys(shown):
    viewer = shown("desk")
    shown = viewer.page.locator(".help")
    for visible in (True, False):
        viewer.key("?")
        assert shown.is_visible() == visible


def test_the_frames_of_a_page_without_a_clip_are_set_undone_and_kept(shown):
    viewer = shown("desk")
    ends = "usdrigui.app.session.range"
    viewer.page.get_by_label("First frame", exact=True).fill("101")
    viewer.key("Enter")
    assert viewer.page.evaluate(ends) == [101, 148], "the last frame goes along"
    viewer.page.get_by_label("Last frame", exact=True).fill("150")
    viewer.key("Enter")
    assert viewer.page.evaluate(ends) == [101, 150]
    viewer.page.locator(".surface").focus()
    viewer.key("Control+z")
    assert viewer.page.evaluate(ends) == [101, 148]
    viewer.page.reload()
    viewer.until("window.usdrigui !== undefined", 60.0)
    assert viewer.page.evaluate(ends) == [1, 48]
    viewer.click("Restore")
    assert viewer.page.evaluate(ends) == [101, 148]
