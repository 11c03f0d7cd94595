"""An animator's session in the viewer: fans, time, the clipboard, what is shown, and reaching all by keyboard."""

import json
from dataclasses import replace

import makers
import numpy as np
import pytest
from browser_pages import DRAWN_BY, Viewer, decoded
from viewer_layouts import animated, on_track, peak_layout

from usdrigui.character.deform import deform

FAN = ("mouth", "fan", ("chin", "jawLeft", "jawRight"), ())
LONG = "mouthLowerDownwardsOuterCornerLeft"


def characters():
    """The mask with an animation: pucker rises to 1 at frame 11, brow_L to 0.5 at frame 21."""
    rig = animated(makers.face(), (1.0, 11.0, 21.0), pucker=(0.0, 1.0, 0.25), brow_L=(0.0, 0.0, 0.5))
    layout = peak_layout(rig, groups=(FAN,), beside=("sneer_R",))
    named = tuple(replace(each, label=LONG) if each.name == "sneer_L" else each for each in layout.elements)
    controls = tuple(replace(each, label=LONG) if each.name == "sneer_L" else each for each in rig.controls)
    return [(replace(rig, controls=controls), replace(layout, elements=named))]


@pytest.fixture(scope="module")
def shared(browser, page_path):
    made = Viewer(browser, page_path, permissions=("clipboard-read", "clipboard-write"))
    yield made
    made.close()


@pytest.fixture
def viewer(shared):
    """The module's page, put back as it was opened."""
    shared.page.mouse.move(1, 1)
    shared.page.evaluate("usdrigui.app.startAfresh()")
    shared.until("usdrigui.app.view.controlsColumn?.width > 0")
    shared.settle()
    yield shared
    assert shared.trouble == []


# --- fans --------------------------------------------------------------------------------------------


def test_one_drag_of_a_fan_drives_two_neighbours_and_leaves_the_third(viewer):
    element = viewer.element("mouth")
    chin, left, _ = element["tracks"]
    away = [0.5 * (a[1] - a[0]) + 0.4 * (b[1] - b[0]) for a, b in zip(ends(chin), ends(left), strict=True)]
    target = [at + by for at, by in zip(element["handle"], away, strict=True)]
    viewer.drag(element["handle"], target, steps=12)
    assert viewer.moved(2e-3) == pytest.approx({"chin": 0.5, "jawLeft": 0.4}, abs=5e-3)
    assert viewer.element("mouth")["handle"] == pytest.approx(target, abs=0.5)


def ends(track):
    """(x, y) pairs of first and last corner, per axis."""
    return [(track[0][axis], track[-1][axis]) for axis in (0, 1)]


# --- pulling in symmetry -----------------------------------------------------------------------------


def test_a_symmetric_pull_never_moves_the_jaw_to_one_side(viewer):
    start = viewer.page.evaluate(
        """() => {
          const { view, session } = usdrigui.app;
          const project = view.camera.projector(view.controlsColumn);
          let best = [Infinity, null];
          const { points } = session.deformer;
          for (let i = 0; i < points.length; i += 3) {
            const off = Math.hypot(points[i], points[i + 1] + 0.62);
            if (off < best[0]) best = [off, project(points.subarray(i, i + 3)).slice(0, 2)];
          }
          return best[1];
        }"""
    )
    viewer.option("handles", False)
    viewer.drag(start, [start[0] + 25, start[1] - 12])
    assert viewer.moved(0.02).keys() >= {"jawLeft"}
    viewer.key("Control+z")
    viewer.option("symmetric", True)
    viewer.drag(start, [start[0] + 25, start[1] - 12])
    moved = viewer.moved(0.02)
    assert "chin" in moved
    assert not {"jawLeft", "jawRight"} & moved.keys()


# --- time --------------------------------------------------------------------------------------------


def test_scrubbing_shows_the_animation(viewer):
    slider = viewer.page.get_by_role("slider", name="Frame")
    slider.focus()
    for _ in range(10):
        slider.press("ArrowRight")
    viewer.settle()
    assert viewer.page.locator("output.frame").inner_text() == "11"
    assert viewer.moved() == pytest.approx({"pucker": 1.0})
    slider.press("End")
    viewer.settle()
    assert viewer.moved() == pytest.approx({"pucker": 0.25, "brow_L": 0.5})
    rig = makers.face()
    values = [viewer.values()[control.name] for control in rig.controls]
    assert np.abs(viewer.points() - deform(rig, values)).max() < 1e-3


def test_space_plays_and_stops(viewer):
    viewer.key("Space")
    viewer.until("usdrigui.app.timeline.frame >= 6")
    playing = viewer.values()["pucker"]
    viewer.key("Space")
    viewer.settle()
    frame = viewer.page.evaluate("usdrigui.app.timeline.frame")
    viewer.page.wait_for_timeout(150)
    assert viewer.page.evaluate("usdrigui.app.timeline.frame") == frame
    assert playing > 0.0


# --- poses, numbers, history -------------------------------------------------------------------------


def test_the_pose_goes_to_the_clipboard(viewer):
    viewer.set(brow_L=0.25)
    viewer.click("Copy JSON")
    viewer.until("document.querySelector('.notice').innerText === 'Pose copied'")
    copied = json.loads(viewer.page.evaluate("navigator.clipboard.readText()"))
    assert copied["values"] == {"brow_L": 0.25}


def test_numbers_of_the_selection_are_entered_and_undone(viewer):
    viewer.page.mouse.click(*viewer.on_page(viewer.element("brow_L")["handle"]))
    field = viewer.page.locator(".inspector").get_by_label("brow_L")
    field.fill("0.375")
    field.press("Tab")
    assert viewer.moved() == pytest.approx({"brow_L": 0.375})
    viewer.click("Undo")
    assert viewer.moved() == {}
    viewer.click("Redo")
    assert viewer.moved() == pytest.approx({"brow_L": 0.375})


# --- what is shown -----------------------------------------------------------------------------------


def test_opacity_makes_handles_fainter(viewer):
    at = viewer.element("brow_R")["handle"]
    before = viewer.marks_at(at)
    slider = viewer.page.get_by_role("slider", name="Opacity")
    slider.focus()
    slider.press("Home")
    viewer.settle()
    assert 0.0 < viewer.marks_at(at) < 0.4 * before


def test_others_fade_while_one_is_dragged_unless_told_not_to(viewer):
    other = viewer.element("brow_R")["handle"]
    still = viewer.marks_at(other)
    element = viewer.element("blink_L")
    for fade, share in ((True, 0.5), (False, 1.0)):
        if not fade:
            viewer.page.get_by_label("Fade the others while dragging").uncheck()
        viewer.press(viewer.element("blink_L")["handle"])
        viewer.glide(element["handle"], on_track(element["tracks"][0], 0.5))
        during = viewer.marks_at(other)
        viewer.page.mouse.up()
        viewer.settle()
        assert (during < 0.6 * still) == fade
        assert during > 0.05 * still
        assert during <= share * still + 1e-6
        viewer.key("Control+z")


def test_hidden_elements_are_neither_drawn_nor_caught_until_shown_again(viewer):
    element = viewer.element("brow_R")
    viewer.page.mouse.click(*viewer.on_page(element["handle"]))
    viewer.click("Hide", exact=True)
    viewer.option("skinDrag", False)
    assert viewer.marks_at(element["handle"]) == 0.0
    viewer.drag(element["handle"], on_track(element["tracks"][0], 0.5))
    assert viewer.moved() == {}
    viewer.page.evaluate("usdrigui.app.view.home()")
    viewer.click("Show hidden elements")
    viewer.settle()
    again = viewer.element("brow_R")
    viewer.drag(again["handle"], on_track(again["tracks"][0], 0.5))
    assert viewer.moved() == pytest.approx({"brow_R": 0.5}, abs=1e-3)


def test_a_long_name_keeps_its_end_and_says_the_whole_when_pointed_at(viewer):
    viewer.unfold()
    name = viewer.page.locator(".row[data-control=sneer_L] .name")
    assert LONG in name.get_attribute("title")
    start, end = name.locator("span.long-name > span").all()
    assert end.inner_text() == "Left"
    assert start.evaluate("(node) => node.scrollWidth > node.clientWidth"), "the start is what is cut"
    inside, outside = end.bounding_box(), name.bounding_box()
    assert inside["x"] + inside["width"] <= outside["x"] + outside["width"] + 1


def test_the_left_is_the_characters_own_seen_from_behind(viewer):
    viewer.option("occlusion", "overlay")
    for view in ("Front", "Back"):
        viewer.page.get_by_role("button", name=f"View: {view}").click()
        viewer.settle()
        left, right = viewer.element("brow_L")["handle"], viewer.element("brow_R")["handle"]
        assert (left[0] > right[0]) == (view == "Front")
        viewer.page.mouse.move(*viewer.on_page(left))
        viewer.settle()
        assert "Character’s left" in viewer.page.locator(".tip").inner_text()
        tags = viewer.page.locator(".side-tag").all()
        shown = [tag.inner_text() for tag in sorted(tags, key=lambda tag: tag.bounding_box()["x"])]
        assert ("left" in shown[1]) == (view == "Front")
        assert ("right" in shown[0]) == (view == "Front")


# --- keyboard ----------------------------------------------------------------------------------------


def test_tab_reaches_everything_and_comes_round(viewer):
    page = viewer.page
    viewer.unfold()
    wanted = page.evaluate(
        """() => [...document.querySelectorAll('button, input, select, summary, [tabindex="0"]')]
          .filter((node) => node.tabIndex >= 0 && !node.disabled && node.checkVisibility())
          .map((node, i) => (node.dataset.stop = i))"""
    )
    assert len(wanted) > 60
    page.evaluate("document.activeElement.blur()")
    met = set()
    for _ in range(2 * len(wanted)):
        page.keyboard.press("Tab")
        stop = page.evaluate("document.activeElement.dataset.stop ?? null")
        if stop is not None and int(stop) in met and len(met) == len(wanted):
            break
        if stop is not None:
            met.add(int(stop))
    assert met == set(wanted)
    assert viewer.moved() == {}


def test_a_session_by_keyboard_alone(viewer):
    """Search, reach the element, move it, key it, look from the side, undo."""
    page = viewer.page
    page.keyboard.press("/")
    page.keyboard.type("pucker")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.getAttribute('aria-label')") == "pucker"
    page.keyboard.press("End")
    assert viewer.moved() == {"pucker": 1.0}
    page.keyboard.press("k")
    assert page.locator(".ticks i").count() == 1
    page.keyboard.press("3")
    assert page.evaluate("usdrigui.app.view.camera.azimuth") == pytest.approx(np.pi / 2)
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    assert viewer.moved() == {}


# --- how it is drawn ---------------------------------------------------------------------------------


def test_processor_and_graphics_card_draw_the_same(opened, page_path):
    pixels = {}
    for draw in ("canvas", "webgl"):
        viewer = opened(page_path, draw=draw)
        assert viewer.page.evaluate("usdrigui.app.view.stage.drawnBy") == DRAWN_BY[draw]
        viewer.page.evaluate("() => { usdrigui.app.view.setFineness(1); usdrigui.app.view.pace = () => {}; }")
        viewer.set(brow_L=0.7, smile_R=1.0)
        viewer.page.evaluate("usdrigui.app.view.pointAt(0)")
        viewer.settle()
        pixels[draw] = decoded(viewer.skin_shot())
    off = np.abs(pixels["canvas"] - pixels["webgl"]).max(axis=2)
    assert np.ptp(pixels["canvas"]) > 150
    assert (off > 12).mean() < 0.004, "only pixels of the outline may differ"


def test_losing_the_graphics_card_does_not_end_the_session(browser, page_path):
    viewer = Viewer(browser, page_path, draw="webgl")
    viewer.set(brow_L=0.5)
    before = decoded(viewer.skin_shot())
    viewer.page.evaluate(
        "usdrigui.app.view.stage.drawer.renderer.getContext().getExtension('WEBGL_lose_context').loseContext()"
    )
    viewer.until("usdrigui.app.view.stage.drawnBy === 'processor'")
    viewer.settle()
    assert (np.abs(decoded(viewer.skin_shot()) - before).max(axis=2) > 12).mean() < 0.01
    element = viewer.element("brow_R")
    viewer.drag(element["handle"], on_track(element["tracks"][0], 0.5))
    assert viewer.moved() == pytest.approx({"brow_L": 0.5, "brow_R": 0.5}, abs=1e-3)
    viewer.close()
