"""The viewer under a real mouse and keyboard: handles, skin, selection, history, poses, rearranging."""

import json

import makers
import numpy as np
import pytest
from pxr import Sdf, Usd
from viewer_layouts import MIRRORS, on_track, peak_layout

from usdrigui.view.web.page import page_html

JAW = ("jaw", "slider", ("jawLeft", "jawRight"), ((0, 1),))


def characters():
    rig = makers.face()
    return [(rig, peak_layout(rig, mirrors=MIRRORS, groups=(JAW,), beside=("chin",)))]


def drag_half_way(viewer):
    """The left brow, to half of its value."""
    element = viewer.element("brow_L")
    viewer.drag(element["handle"], on_track(element["tracks"][0], 0.5))


# --- handles -----------------------------------------------------------------------------------------


def test_handle_stays_under_the_pointer(viewer):
    element = viewer.element("smile_R")
    target = on_track(element["tracks"][0], 0.6)
    viewer.drag(element["handle"], target)
    assert viewer.element("smile_R")["handle"] == pytest.approx(target, abs=0.3)


def test_fine_key_slows_the_hand(viewer):
    element = viewer.element("brow_L")
    start, end = element["handle"], on_track(element["tracks"][0], 1.0)
    viewer.press(start)
    viewer.page.keyboard.down("Control")
    viewer.glide(start, end)
    viewer.page.keyboard.up("Control")
    viewer.page.mouse.up()
    viewer.settle()
    assert viewer.moved() == pytest.approx({"brow_L": 0.1}, abs=0.01)


def test_escape_takes_the_drag_back(viewer):
    element = viewer.element("brow_L")
    viewer.press(element["handle"])
    viewer.glide(element["handle"], on_track(element["tracks"][0], 0.8))
    assert viewer.moved()
    viewer.key("Escape")
    viewer.page.mouse.up()
    viewer.settle()
    assert viewer.moved() == {}


def test_symmetric_drag_moves_the_twin(viewer):
    viewer.click("Symmetry")
    drag_half_way(viewer)
    assert viewer.moved() == pytest.approx({"brow_L": 0.5, "brow_R": 0.5}, abs=1e-3)


def test_selected_elements_move_together(viewer):
    for name in ("brow_L", "blink_R"):
        viewer.page.keyboard.down("Shift")
        viewer.page.mouse.click(*viewer.on_page(viewer.element(name)["handle"]))
        viewer.page.keyboard.up("Shift")
    drag_half_way(viewer)
    assert viewer.moved() == pytest.approx({"brow_L": 0.5, "blink_R": 0.5}, abs=1e-3)


def test_marquee_selects_and_zero_clears(viewer):
    viewer.set(brow_L=0.4, brow_R=0.6, smile_L=0.3)
    left, right = viewer.element("brow_R")["handle"], viewer.element("brow_L")["handle"]
    start = [min(left[0], right[0]) - 30, min(left[1], right[1]) - 40]
    end = [max(left[0], right[0]) + 30, max(left[1], right[1]) + 15]
    viewer.page.keyboard.down("Shift")
    viewer.drag(start, end)
    viewer.page.keyboard.up("Shift")
    viewer.key("0")
    viewer.settle()
    assert viewer.moved() == pytest.approx({"smile_L": 0.3})


def test_double_click_resets(viewer):
    viewer.set(brow_L=0.4, brow_R=0.6)
    viewer.page.mouse.dblclick(*viewer.on_page(viewer.element("brow_L")["handle"]))
    viewer.settle()
    assert viewer.moved() == pytest.approx({"brow_R": 0.6})


# --- skin --------------------------------------------------------------------------------------------


def skin_point(viewer, x, y):
    """Pixel of the neutral mask's point nearest to (x, y) of the mask."""
    return viewer.page.evaluate(
        """([x, y]) => {
          const { view, session } = usdrigui.app;
          const points = session.deformer.points;
          let best = [Infinity, null];
          for (let i = 0; i < points.length; i += 3) {
            const off = Math.hypot(points[i] - x, points[i + 1] - y);
            if (off < best[0]) best = [off, [points[i], points[i + 1], points[i + 2]]];
          }
          return view.camera.projector(view.controlsColumn)(best[1]).slice(0, 2);
        }""",
        [x, y],
    )


def test_pulled_skin_follows_the_pointer(viewer):
    before = viewer.skin_shot()
    start = skin_point(viewer, 0.4, -0.36)
    viewer.drag(start, [start[0] + 5, start[1] - 5])
    moved = viewer.moved(0.02)
    assert set(moved) == {"smile_L"}
    assert 0.2 < moved["smile_L"] < 1.0
    assert viewer.skin_shot() != before


def test_lock_sends_the_pull_to_others(viewer):
    viewer.unfold()
    viewer.click("Lock smile_L")
    start = skin_point(viewer, 0.4, -0.36)
    viewer.drag(start, [start[0] + 14, start[1] - 14])
    assert "smile_L" not in viewer.moved()


def test_pin_holds_its_point(viewer):
    """Two shapes overlap at the grabbed point; a pin inside one of them makes the other do more."""
    start = skin_point(viewer, 0.22, -0.22)
    viewer.drag(start, [start[0], start[1] - 10])
    free = viewer.values()
    viewer.key("Control+z")
    viewer.page.keyboard.down("Shift")
    viewer.page.mouse.click(*viewer.on_page(skin_point(viewer, 0.34, -0.52)))
    viewer.page.keyboard.up("Shift")
    viewer.settle()
    assert viewer.page.evaluate("usdrigui.app.session.pins.length") == 1
    viewer.drag(start, [start[0], start[1] - 10])
    pinned = viewer.values()
    assert free["smile_L"] > 0.02
    assert pinned["smile_L"] < 0.5 * free["smile_L"]


def test_clicked_skin_lists_what_acts_there(viewer):
    viewer.page.mouse.click(*viewer.on_page(skin_point(viewer, 0.4, -0.36)))
    viewer.settle()
    rows = viewer.page.locator(".ranked-row")
    assert rows.first.get_attribute("data-control") == "smile_L"
    assert viewer.moved() == {}
    section = viewer.page.locator("details", has=viewer.page.locator(".ranked"))
    rows.first.click()
    viewer.settle()
    assert section.is_visible(), "one chooses from the list"
    viewer.page.mouse.click(*viewer.on_page(viewer.element("brow_L")["handle"]))
    viewer.settle()
    assert not section.is_visible(), "it is about the point clicked before"


def test_empty_space_orbits_and_sides_are_named_from_behind(viewer):
    names = viewer.page.locator(".side-tag")
    assert ["right" in names.nth(0).inner_text(), "left" in names.nth(1).inner_text()] == [True, True]
    viewer.drag([20, 20], [160, 40])
    assert viewer.page.evaluate("usdrigui.app.view.camera.azimuth") < -0.5
    viewer.click("View: Back")
    viewer.settle()
    assert ["left" in names.nth(0).inner_text(), "right" in names.nth(1).inner_text()] == [True, True]
    assert viewer.moved() == {}


# --- panels and keys ---------------------------------------------------------------------------------


def test_undo_and_redo(viewer):
    drag_half_way(viewer)
    after = viewer.values()
    viewer.key("Control+z")
    assert viewer.moved() == {}
    viewer.key("Control+Shift+Z")
    assert viewer.values() == after


def test_hover_shows_label_and_heat(viewer):
    before = viewer.skin_shot()
    viewer.page.mouse.move(*viewer.on_page(viewer.element("brow_L")["handle"]))
    viewer.settle()
    tip = viewer.page.locator(".tip").inner_text()
    assert "brow_L" in tip
    assert "left" in tip
    assert viewer.skin_shot() != before


def test_covered_handles_are_out_of_reach_unless_overlaid(viewer):
    viewer.click("View: Back")
    viewer.settle()
    assert viewer.element("pucker")["hidden"]
    viewer.option("occlusion", "overlay")
    assert not viewer.element("pucker")["hidden"]


def test_static_elements_stay_and_deforming_ones_follow(viewer):
    rest = viewer.element("pucker")["handle"]
    viewer.set(jawLeft=1.0)
    assert np.linalg.norm(np.subtract(viewer.element("pucker")["handle"], rest)) > 2.0
    viewer.option("follow", False)
    assert viewer.element("pucker")["handle"] == pytest.approx(rest, abs=0.02)


def test_f_looks_closely_and_goes_back(viewer):
    camera = "(({ target, towards, distance }) => [...target, ...towards, distance])(usdrigui.app.view.camera)"
    before = viewer.page.evaluate(camera)
    viewer.key("f")
    assert viewer.page.evaluate(camera)[6] < before[6]
    viewer.key("f")
    assert viewer.page.evaluate(camera) == pytest.approx(before)
    viewer.key("f")
    viewer.key("4")
    viewer.key("f")
    assert viewer.page.evaluate(camera) != pytest.approx(before)


def test_copy_beside_the_clean_face(viewer):
    viewer.click("On copy", exact=True)
    viewer.settle()
    drag_half_way(viewer)
    assert viewer.moved() == pytest.approx({"brow_L": 0.5}, abs=1e-3)
    columns = viewer.page.evaluate("usdrigui.app.view.columns.map(({ kind }) => kind)")
    assert columns == ["controls", "clean"]


# --- poses out and in --------------------------------------------------------------------------------


def loaded(viewer, path):
    with viewer.page.expect_file_chooser() as chooser:
        viewer.click("Load…")
    chooser.value.set_files(path)
    viewer.until("!document.querySelector('.notice').hidden")
    viewer.settle()


def test_pose_out_and_in_as_json(viewer, tmp_path):
    viewer.set(brow_L=0.25, pucker=1.0)
    path = viewer.saved("Save JSON", tmp_path / "pose.json")
    assert json.loads(path.read_text())["values"] == {"brow_L": 0.25, "pucker": 1.0}
    viewer.set(brow_L=0.9, chin=0.5)
    loaded(viewer, path)
    assert viewer.moved() == {"brow_L": 0.25, "pucker": 1.0}


def test_other_json_is_refused_in_words(viewer, tmp_path):
    path = tmp_path / "other.json"
    path.write_text('{"values": {"somebody": 1}}')
    loaded(viewer, path)
    assert "No control" in viewer.page.locator(".notice").inner_text()
    assert viewer.moved() == {}


def test_keys_out_as_a_usd_layer_and_in_again(viewer, tmp_path):
    """A drag keys when auto-key is on; USD reads the samples; the viewer reads its own layer again."""
    viewer.click("Auto-key")
    drag_half_way(viewer)
    viewer.page.evaluate("usdrigui.app.timeline.go(11)")
    viewer.set(brow_L=1.0, pucker=0.5)
    pose = Sdf.Layer.FindOrOpen(str(viewer.saved("Save pose layer", tmp_path / "pose.usda")))
    assert pose.ListTimeSamplesForPath("/Root/anim.blendShapeWeights") == [11.0]
    path = viewer.saved("Save animation layer", tmp_path / "animation.usda")
    stage = Usd.Stage.Open(str(path))
    names = [*viewer.values()]
    at = {
        time: dict(zip(names, stage.GetAttributeAtPath("/Root/anim.blendShapeWeights").Get(time), strict=True))
        for time in (1, 6, 11, 40)
    }
    assert [at[time]["brow_L"] for time in (1, 6, 11, 40)] == pytest.approx([0.5, 0.75, 1.0, 1.0], abs=1e-3)
    assert at[11]["pucker"] == pytest.approx(0.5)
    viewer.page.evaluate("usdrigui.app.startAfresh()")
    viewer.until("usdrigui.app.view.controlsColumn?.width > 0")
    loaded(viewer, path)
    viewer.page.evaluate("usdrigui.app.timeline.go(6)")
    assert viewer.values()["brow_L"] == pytest.approx(0.75, abs=1e-3)


# --- evaluation --------------------------------------------------------------------------------------


@pytest.fixture
def study(opened, tmp_path):
    """The page with the evaluation, which the ordinary one does not offer, and a shelf of one pose."""
    rig = makers.face()
    path = tmp_path / "study.html"
    shelf = '#usda 1.0\nstring pose = "{\\"values\\": {\\"chin\\": 1}}"\n'
    path.write_text(page_html([(rig, peak_layout(rig, mirrors=MIRRORS))], "face", study=True, reviews=[shelf]))
    return opened(path)


def agree(page):
    page.get_by_role("button", name="Evaluate").click()
    page.locator(".evaluation [type=checkbox]").check()
    page.get_by_label("Experience").select_option("amateur")


def test_the_ordinary_page_offers_no_evaluation(viewer):
    assert viewer.page.get_by_role("button", name="Shortcuts").count() == 1
    assert viewer.page.get_by_role("button", name="Evaluate").count() == 0


def test_evaluation_measures_as_the_paper_does(study, tmp_path):
    """Two trials: one left neutral (both errors 1), one matched exactly (both errors 0)."""
    viewer = study
    agree(viewer.page)
    assert "1 of the poses given" in viewer.page.locator(".evaluation").inner_text()
    viewer.page.get_by_label("Participant number").fill("2")
    viewer.click("Start")
    viewer.settle()
    assert viewer.page.evaluate("usdrigui.app.view.columns.map(({ kind }) => kind)") == ["target", "controls"]
    viewer.key("s")
    assert not viewer.page.evaluate("usdrigui.app.session.options.symmetric"), "no shortcut helps in a trial"
    shown = viewer.page.locator("button:visible").all_inner_texts()
    assert sorted(shown) == ["Done", "Pause", "Stop"], "nothing else can be pressed in a trial"
    done = viewer.page.get_by_role("button", name="Done")
    done.click()  # the face to practise on is not counted
    done.click()
    viewer.page.evaluate(
        "() => { const { session, evaluation } = usdrigui.app; session.set([...evaluation.running.target.entries()]); }"
    )
    done.click()
    viewer.click("Stop")
    path = viewer.saved("Save CSV", tmp_path / "evaluation-2.csv")
    heads, *rows = [line.split(",") for line in path.read_text().splitlines()]
    first, second = (dict(zip(heads, row, strict=True)) for row in rows)
    assert first["interface"] == "face"
    assert [float(first[key]) for key in ("weight_error_squared", "vertex_error_squared")] == pytest.approx([1.0, 1.0])
    assert [float(second[key]) for key in ("weight_error_squared", "vertex_error_squared")] == [0.0, 0.0]
    assert float(first["share_of_time"]) + float(second["share_of_time"]) == pytest.approx(1.0, abs=1e-4)
    assert viewer.moved() == {}


def test_a_session_is_gone_on_with_and_ends_with_questions(study, tmp_path):
    """After a reload in the middle of the second block; the answers are in the file."""
    page = study.page

    def press(name, times=1):
        for _ in range(times):
            page.get_by_role("button", name=name, exact=True).click()

    agree(page)
    press("Start")
    press("Done", 6 + 3)
    page.reload()
    study.until("window.usdrigui !== undefined")
    press("Evaluate")
    press("Go on with participant 1")
    assert page.locator(".strip").inner_text().split("\n")[1] == "practice, not counted"
    press("Done")
    assert "8 of 15" in page.locator(".strip").inner_text()
    press("Done", 3 + 6)
    for question in page.locator("fieldset").all():
        question.get_by_role("radio").nth(3).check()
    press("Done")
    rows = [line.split(",") for line in study.saved("Save CSV", tmp_path / "evaluation-1.csv").read_text().splitlines()]
    assert [row[3] for row in rows[1:16]] == [str(i) for i in range(1, 16)]
    assert {row[12] for row in rows[16:]} == {"4"}
    assert len({size for row in rows[1:16] for size in row[14:16]}) == 1, "face and target are as large everywhere"
    assert len(rows) == 16 + 8
    press("Close")
    press("Evaluate")
    assert page.get_by_role("button", name="Go on").count() == 0
