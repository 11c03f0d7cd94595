"""The page in Firefox, with WebGL and without, and in a Chromium that has no WebGL at all."""

import time

import pytest
from browser_pages import Viewer, chromium
from firefox_pages import Firefox

PICTURE = """(() => {
  const { stage } = page.usdrigui.app.view;
  const canvas = stage.node.firstChild;
  const copy = page.document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const pen = copy.getContext('2d');
  page.usdrigui.app.view.stage.draw(page.usdrigui.app.view.columns, page.usdrigui.app.view.camera);
  pen.drawImage(canvas, 0, 0);
  const { data } = pen.getImageData(0, 0, copy.width, copy.height);
  let sum = 0, lit = 0;
  for (let i = 0; i < data.length; i += 4) { sum += data[i] * (1 + (i % 7919)); lit += data[i] > 80; }
  return [sum, lit / (data.length / 4)];
})()"""


@pytest.mark.parametrize(("headless", "drawn_by"), [(False, "graphics card"), (True, "processor")])
def test_firefox_drags_a_handle_and_the_skin(page_path, tmp_path, headless, drawn_by):
    firefox = Firefox(tmp_path, headless)
    try:
        # Software WebGL is not what the page would choose: insist on it where there is one.
        firefox.open(page_path, "" if headless else "#draw=webgl")
        firefox.until("page.usdrigui.app.view.drawn > 0")
        assert firefox.script("page.usdrigui.app.view.stage.drawnBy") == drawn_by
        before = firefox.script(PICTURE)
        assert before[1] > 0.1, "a face is in the picture"
        box = firefox.script("page.document.querySelector('.surface').getBoundingClientRect()")
        element = next(each for each in firefox.script("page.usdrigui.elements()") if each["name"] == "brow_L")
        start, end = ([box["x"] + x, box["y"] + y] for x, y in (element["tracks"][0][0], element["tracks"][0][-1]))
        firefox.drag(start, [a + 0.5 * (b - a) for a, b in zip(start, end, strict=True)])
        values = firefox.script("page.usdrigui.values()")
        # The mouse moves by whole pixels.
        assert {name: value for name, value in values.items() if value} == {"brow_L": pytest.approx(0.5, abs=0.05)}
        assert firefox.script(PICTURE) != before
        smile = next(each for each in firefox.script("page.usdrigui.elements()") if each["name"] == "smile_L")
        grasp = [box["x"] + smile["handle"][0] + 14, box["y"] + smile["handle"][1] + 14]
        firefox.drag(grasp, [grasp[0] + 6, grasp[1] - 6])
        assert firefox.script("page.usdrigui.values().smile_L") > 0.05
        assert firefox.complaints() == []
        firefox.script("page.setTimeout(() => { throw new Error('planted'); }, 0)")
        time.sleep(0.2)
        assert "planted" in firefox.complaints()[0], "an error would have been heard"
    finally:
        firefox.close()


@pytest.fixture(scope="module")
def without_webgl(playwright):
    made = chromium(playwright, "--disable-3d-apis")
    yield made
    made.close()


def test_without_webgl_the_page_draws_by_itself_and_says_so(without_webgl, page_path):
    viewer = Viewer(without_webgl, page_path)
    assert viewer.page.evaluate("document.createElement('canvas').getContext('webgl2')") is None
    note = viewer.page.get_by_text("Drawn by the processor")
    assert note.is_visible()
    before = viewer.skin_shot()
    element = viewer.element("brow_L")
    track = element["tracks"][0]
    viewer.drag(element["handle"], [a + 0.5 * (b - a) for a, b in zip(track[0], track[-1], strict=True)])
    assert viewer.moved() == pytest.approx({"brow_L": 0.5}, abs=1e-3)
    assert viewer.skin_shot() != before
    assert viewer.trouble == []
    viewer.close()


def test_with_a_graphics_card_nothing_is_reported(browser, page_path):
    viewer = Viewer(browser, page_path, draw="webgl")
    assert not viewer.page.get_by_text("Drawn by the processor").is_visible()
    viewer.close()
