"""Nothing that an animator does in the viewer is lost without a word: other characters, scrubbing, reloads, closing."""

import laid_out
import makers
import pytest
from skel_stages import character
from viewer_layouts import animated, peak_layout

from usdrigui.character.deform import deform
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load
from usdrigui.view.web.page import page_html


def characters():
    """Two masks on one page, the pucker rising from 0 to 1 between frames 1 and 11."""
    moving = animated(makers.face(), pucker=(0.0, 1.0))
    rigs = [makers.changed(moving, path=root) for root in ("/One", "/Two")]
    return [(rig, peak_layout(rig)) for rig in rigs]


def choose(viewer, root):
    viewer.page.get_by_label("Character", exact=True).select_option(label=root)
    viewer.until("usdrigui.app.view.controlsColumn?.width > 0")


def go(viewer, frame):
    viewer.page.evaluate("(frame) => usdrigui.app.timeline.go(frame)", frame)


def ticks(viewer):
    return viewer.page.locator(".ticks i").count()


def key_chin(viewer):
    """Chin at .5 on frame 6, keyed, and brow_L at .25, which nothing animates."""
    go(viewer, 6)
    viewer.set(chin=0.5)
    viewer.key("k")
    viewer.set(brow_L=0.25)


WORK = {"chin": 0.5, "brow_L": 0.25, "pucker": 0.5}


def test_another_character_and_back_keeps_pose_keys_and_undo(viewer):
    key_chin(viewer)
    choose(viewer, "/Two")
    assert (viewer.moved(), ticks(viewer)) == ({}, 0)
    viewer.set(chin=1.0)
    choose(viewer, "/One")
    assert viewer.moved() == pytest.approx(WORK)
    assert ticks(viewer) == 1
    for _ in range(3):
        viewer.key("Control+z")
    assert (viewer.moved(), ticks(viewer)) == (pytest.approx({"pucker": 0.5}), 0)
    choose(viewer, "/Two")
    assert viewer.moved() == {"chin": 1.0}


def reload(viewer):
    viewer.page.reload()
    viewer.until("window.usdrigui !== undefined", 60.0)
    viewer.settle()


def test_a_reload_offers_the_work_back(viewer):
    reload(viewer)
    assert viewer.page.locator(".offer").is_hidden()
    key_chin(viewer)
    reload(viewer)
    assert viewer.moved() == {}
    offer = viewer.page.locator(".offer")
    assert "1 key of 1 control, 1 control changed without a key" in offer.inner_text()
    offer.get_by_role("button", name="Restore").click()
    assert viewer.moved() == pytest.approx(WORK)
    assert (ticks(viewer), offer.is_hidden()) == (1, True)
    reload(viewer)
    offer.get_by_role("button", name="Discard").click()
    reload(viewer)
    assert offer.is_hidden()
    assert viewer.moved() == {}


def test_two_pages_on_one_character_lose_nothing_of_each_other(viewer, page_path):
    other = viewer.page.context.new_page()
    other.goto(page_path.resolve().as_uri())
    other.wait_for_selector(".timeline")
    other.evaluate("usdrigui.set({ chin: 1 })")
    viewer.set(brow_L=1.0)
    other.close(run_before_unload=True)
    offer = viewer.page.locator(".offer")
    found = []
    for _ in range(2):
        reload(viewer)
        offer.get_by_role("button", name="Restore").click()
        found.append(viewer.moved())
        viewer.page.evaluate("usdrigui.app.startAfresh()")
    assert sorted(found, key=str) == [{"brow_L": 1.0}, {"chin": 1.0}]


def test_a_browser_that_keeps_nothing_is_reported_before_work_is_lost(opened, page_path):
    no_storage = "{ get() { throw new DOMException('no', 'SecurityError'); } }"
    viewer = opened(page_path, script=f"Object.defineProperty(window, 'localStorage', {no_storage})")
    asked = []
    viewer.page.on("dialog", lambda dialog: (asked.append(dialog.type), dialog.accept()))
    viewer.page.mouse.click(5, 5)
    reload(viewer)
    assert asked == []
    viewer.page.mouse.click(5, 5)
    viewer.set(chin=0.5)
    reload(viewer)
    assert asked == ["beforeunload"]
    viewer.page.mouse.click(5, 5)
    viewer.set(chin=0.5)
    with viewer.page.expect_download():
        viewer.click("Save JSON")
    reload(viewer)
    assert asked == ["beforeunload"], "what is saved to a file is not lost"


def test_unkeyed_changes_end_with_the_frame_by_word_and_come_back_by_undo(viewer):
    go(viewer, 6)
    viewer.set(pucker=0.9, chin=0.3)
    assert viewer.page.locator(".unkeyed").inner_text() == "1 not keyed"
    go(viewer, 7)
    assert viewer.moved() == pytest.approx({"pucker": 0.6, "chin": 0.3}), "nothing else says what the chin is"
    notice = viewer.page.locator(".notice")
    assert notice.inner_text() == "pucker of frame 6 not keyed and left behind · Ctrl+Z goes back"
    go(viewer, 8)
    viewer.key("Control+z")
    assert viewer.page.locator("output.frame").inner_text() == "6"
    assert viewer.moved() == pytest.approx({"pucker": 0.9, "chin": 0.3})


def test_reset_reaches_the_neutral_pose_from_every_frame(opened, tmp_path):
    """The clip turns and scales joints that no control does."""
    character(tmp_path / "char.usda")
    rig = read_rigs(tmp_path / "char.usda", load({"read": {"joints": "none"}}))[0]
    path = tmp_path / "page.html"
    path.write_text(page_html([(rig, laid_out.layout_of(rig))], "char"))
    viewer = opened(path)

    def off():
        viewer.settle()
        return viewer.furthest(rig, deform(rig))

    for frame in (3, 10):
        go(viewer, frame)
        assert off() > 0.05
        viewer.click("Reset all")
        assert off() < 1e-4
        viewer.key("Control+z")
        assert off() > 0.05
