"""A review: a pose, strokes and words at a frame go out as a small USD layer and open on another page."""

from itertools import pairwise

import makers
import pytest
from pxr import Gf, Usd, UsdGeom
from viewer_layouts import animated, peak_layout

from usdrigui.view.web.page import page_html, read_review

ARROW = [[0.0, 0.0], [60.0, -10.0], [45.0, 12.0]]
SKIN = 0.02
"""Of the face's height: how far a stroke may be drawn from the place of the skin that it was drawn over."""


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """Write the page with reviews, and give its path."""
    folder = tmp_path_factory.mktemp("review")
    rig = animated(makers.face(), pucker=(0.0, 1.0))

    def written(*reviews):
        path = folder / f"face{len(reviews)}.html"
        path.write_text(page_html([(rig, peak_layout(rig))], "face", reviews=[read_review(each) for each in reviews]))
        return path

    return written


@pytest.fixture
def shown(opened):
    return lambda path, size=(1366, 768): opened(path, size)


def chin(viewer):
    """Where a point of the chin is seen."""
    return viewer.page.evaluate(
        """() => {
          const { view, session } = usdrigui.app;
          const { points } = session.deformer;
          let best = [Infinity, null];
          for (let i = 0; i < points.length; i += 3) {
            const off = Math.hypot(points[i], points[i + 1] + 0.62);
            if (off < best[0]) best = [off, points.slice(i, i + 3)];
          }
          return view.camera.projector(view.controlsColumn)(best[1]).slice(0, 2);
        }"""
    )


def draw(viewer, start, stroke=ARROW):
    path = [[a + b for a, b in zip(start, step, strict=True)] for step in stroke]
    viewer.press(path[0])
    for a, b in pairwise(path):
        viewer.glide(a, b)
    viewer.page.mouse.up()
    viewer.settle()


def lines(viewer):
    """Strokes drawn over the view, as points of the screen."""
    viewer.settle()
    return viewer.page.evaluate("usdrigui.app.review.lines().map((line) => line.map((at) => at.slice(0, 2)))")


def amber(viewer, at):
    """Whether a stroke is to be seen at a place, blended with its dark rim perhaps."""
    return viewer.page.evaluate(
        """([x, y]) => {
          const { canvas, ratio, box: [left, top] } = usdrigui.app.view.overlay;
          const copy = new OffscreenCanvas(1, 1).getContext('2d');
          copy.drawImage(canvas, -Math.round((x - left) * ratio), -Math.round((y - top) * ratio));
          const [red, green, blue] = copy.getImageData(0, 0, 1, 1).data;
          return Math.abs(red - 240) + Math.abs(green - 169) + Math.abs(blue - 75) < 90;
        }""",
        at,
    )


def notes(viewer):
    return viewer.page.evaluate(
        """() => usdrigui.app.session.notes.map(({ frame, text, done, strokes }) => (
          { frame, text, done, strokes: strokes.length }))"""
    )


def reviewed(viewer, folder):
    """Pose, draw and write at frame 6, from the side; the saved file."""
    viewer.page.evaluate("usdrigui.app.timeline.go(6)")
    viewer.page.evaluate("usdrigui.app.view.home(0.7, 0.1)")
    viewer.set(brow_L=0.75)
    viewer.key("n")
    viewer.click("Draw")
    draw(viewer, chin(viewer))
    viewer.click("Draw")
    viewer.page.get_by_label("Comment of note 1").fill('More of "this" here,\nless < there')
    return viewer.saved("Save review", folder / "review.usda")


def test_a_review_opens_elsewhere_at_its_frame_view_and_pose(shown, pages, tmp_path):
    sender = shown(pages())
    path = reviewed(sender, tmp_path)
    at = chin(sender)
    (sent,) = lines(sender)
    assert sent[0] == pytest.approx(at, abs=1.0)
    assert len(sent) < 12, "points on a line are left out"
    assert all(amber(sender, corner) for corner in sent)
    assert path.stat().st_size < 8000

    reader = shown(pages(path), (390, 844))
    assert reader.page.get_by_label("Comment of note 1").input_value() == 'More of "this" here,\nless < there'
    assert lines(reader) == []
    reader.page.get_by_role("button", name="1 · Frame 6, 1 stroke").click()
    assert reader.page.evaluate("usdrigui.app.session.frame") == 6
    assert reader.moved() == pytest.approx({"pucker": 0.5, "brow_L": 0.75})
    (found,) = lines(reader)
    height = reader.page.evaluate("usdrigui.app.view.controlsColumn.height")
    assert found[0] == pytest.approx(chin(reader), abs=SKIN * height)
    assert len(found) == len(sent)
    assert amber(reader, found[0])
    column = reader.page.evaluate("usdrigui.app.view.controlsColumn")
    assert all(0 < x < column["width"] and 0 < y < column["height"] for x, y in found)
    reader.page.evaluate("usdrigui.app.view.home()")
    assert lines(reader) == [], "seen from elsewhere, the strokes would lie over something else"


def test_the_pose_of_a_note_is_looked_at_until_an_edit_takes_it(shown, pages, tmp_path):
    path = reviewed(shown(pages()), tmp_path)
    reader = shown(pages(path))
    work = "JSON.parse(JSON.stringify(usdrigui.app.kept[0].autosave.isUnsaved))"
    show = reader.page.get_by_role("button", name="1 · Frame 6, 1 stroke")
    show.click()
    assert not reader.page.evaluate(work), "looking is no work"
    reader.page.evaluate("usdrigui.app.timeline.go(7)")
    assert reader.moved() == pytest.approx({"pucker": 0.6})
    show.click()
    reader.page.get_by_role("checkbox", name="Note 1 is done").click()
    assert reader.moved() == pytest.approx({"pucker": 0.5, "brow_L": 0.75}), "an answer leaves the pose in sight"
    element = reader.element("chin")
    reader.page.mouse.click(*reader.on_page(element["handle"]))
    assert reader.page.evaluate("usdrigui.app.session.looks"), "a click takes nothing over"
    reader.drag(
        element["handle"], [(a + b) / 2 for a, b in zip(element["tracks"][0][0], element["tracks"][0][-1], strict=True)]
    )
    assert reader.moved(0.01) == pytest.approx({"pucker": 0.5, "brow_L": 0.75, "chin": 0.5}, abs=0.05)
    reader.page.keyboard.press("Control+z")
    assert reader.moved() == pytest.approx({"pucker": 0.5})
    assert notes(reader)[0]["done"]
    show.click()
    reader.page.get_by_role("button", name="Take this pose").click()
    reader.page.keyboard.press("k")
    reader.page.evaluate("usdrigui.app.timeline.go(5)")
    reader.page.evaluate("usdrigui.app.timeline.go(6)")
    assert reader.moved() == pytest.approx({"pucker": 0.5, "brow_L": 0.75})


def test_a_review_is_a_layer_that_usd_opens_over_the_character(shown, pages, tmp_path):
    sender = shown(pages())
    path = reviewed(sender, tmp_path)
    (sent,) = lines(sender)
    column = sender.page.evaluate("usdrigui.app.view.controlsColumn")
    stage = Usd.Stage.Open(str(path))
    note = next(prim for prim in stage.TraverseAll() if prim.GetName() == "note_1")
    assert note.GetMetadata("documentation") == 'More of "this" here,\nless < there'
    assert UsdGeom.Imageable(note).ComputePurpose() == "guide"
    curves = UsdGeom.BasisCurves(note.GetChild("strokes"))
    camera = UsdGeom.Camera(note.GetChild("view")).GetCamera(6.0)
    shown = [UsdGeom.Imageable(curves).ComputeVisibility(frame) for frame in (5.0, 6.0, 7.0)]
    assert shown == ["invisible", "inherited", "invisible"]
    view = camera.frustum.ComputeViewMatrix() * camera.frustum.ComputeProjectionMatrix()
    for point, at in zip(curves.GetPointsAttr().Get(), sent, strict=True):
        x, y, _ = view.Transform(Gf.Vec3d(point))
        seen = column["left"] + column["width"] * (x + 1) / 2, column["top"] + column["height"] * (1 - y) / 2
        assert seen == pytest.approx(at, abs=0.6)


def test_notes_are_undone_and_offered_back_like_all_work(shown, pages, tmp_path):
    path = reviewed(shown(pages()), tmp_path)
    viewer = shown(pages(path))
    viewer.click("Add note")
    viewer.page.keyboard.type("Mine")
    viewer.click("Take note 1 away")
    assert [each["text"] for each in notes(viewer)] == ["Mine"]
    viewer.page.reload()
    viewer.until("window.usdrigui !== undefined", 60.0)
    assert [each["frame"] for each in notes(viewer)] == [6]
    offer = viewer.page.locator(".offer")
    assert "1 note" in offer.inner_text()
    offer.get_by_role("button", name="Restore").click()
    assert [each["text"] for each in notes(viewer)] == ["Mine"], "what was taken away does not come back with the page"
    viewer.page.locator(".surface").focus()
    viewer.key("Control+z")
    assert [each["frame"] for each in notes(viewer)] == [6]
