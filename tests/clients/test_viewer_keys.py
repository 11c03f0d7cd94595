"""Keys and poses by hand: rows of keys, tweens, one side on the other; undo takes everything back."""

import wave

import makers
import pytest
from viewer_layouts import MIRRORS, peak_layout


def characters():
    rig = makers.face()
    return [(rig, peak_layout(rig, mirrors=MIRRORS))]


def keyed(viewer):
    """Frames and values of each control's keys."""
    return viewer.page.evaluate(
        """() => {
          const { keys, controls } = usdrigui.app.session;
          return Object.fromEntries([...keys].map(([control, track]) => [controls[control].name, track]));
        }"""
    )


def key(viewer, frame, **values):
    viewer.page.evaluate("(frame) => usdrigui.app.timeline.go(frame)", frame)
    viewer.set(**values)
    viewer.key("k")


def drag(page, start, end):
    page.mouse.move(*start)
    page.mouse.down()
    page.mouse.move(*end, steps=4)
    page.mouse.up()


KEYS_ON_THE_TRAIL = """() => {
  const { session, trails, view } = usdrigui.app;
  session.select(session.elements.list.filter(({ label }) => label === 'brow_L'));
  view.freshen();
  const { canvas, box: [left, top] } = view.overlay;
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const drawn = ({ frame, at }) => [frame, ...copy.getImageData(at[0] - left, at[1] - top, 1, 1).data];
  return trails.shown().map(({ places }) => places.filter(({ isKey }) => isKey).map(drawn));
}"""


def test_keys_are_dragged_copied_deleted_and_come_back(viewer):
    """Where they are dragged to they are on the trail of their handle, too."""
    page = viewer.page
    key(viewer, 1, brow_L=0.25)
    key(viewer, 11, brow_L=0.75)
    page.keyboard.press("d")
    row = page.locator(".dope-row", has_text="brow_L")
    mark, line = row.locator(".dope-key").nth(1), row.locator(".dope-line").bounding_box()
    box, per_frame = mark.bounding_box(), line["width"] / 47
    start = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    drag(page, start, (start[0] + 10 * per_frame, start[1]))
    assert keyed(viewer) == {"brow_L": [[1, 0.25], [21, 0.75]]}
    assert page.evaluate(KEYS_ON_THE_TRAIL) == []
    page.keyboard.press("t")
    assert page.evaluate(KEYS_ON_THE_TRAIL) == [[[frame, 240, 169, 75, 255] for frame in (1, 21)]]
    page.keyboard.press("Control+ArrowRight")
    assert keyed(viewer) == {"brow_L": [[1, 0.25], [21, 0.75], [22, 0.75]]}
    page.keyboard.press("Delete")
    assert keyed(viewer) == {"brow_L": [[1, 0.25], [21, 0.75]]}
    for _ in range(3):
        page.keyboard.press("Control+z")
    assert keyed(viewer) == {"brow_L": [[1, 0.25], [11, 0.75]]}


@pytest.mark.parametrize("shows", ["Rows", "Curves"])
def test_a_range_of_keys_is_scaled_turned_round_and_played(viewer, shows):
    """Alt-drag of its last key; play stays within it; frames and values are told beside the curves."""
    page, session = viewer.page, "usdrigui.app.session"
    for frame, value in ((1, 0.2), (11, 0.8), (21, 0.4)):
        key(viewer, frame, brow_L=value)
    page.keyboard.press("d")
    page.get_by_role("button", name=shows, exact=True).click()
    keys = (
        page.locator(".dope-row", has_text="brow_L").locator(".dope-key")
        if shows == "Rows"
        else page.locator(".curve-key")
    )
    page.locator(".dope").press("Control+a")
    first, last = (keys.nth(at).bounding_box() for at in (0, 2))
    page.keyboard.down("Alt")
    x, y = last["x"] + last["width"] / 2, last["y"] + last["height"] / 2
    drag(page, (x, y), (x + (last["x"] - first["x"]) / 2, y))
    page.keyboard.up("Alt")
    assert keyed(viewer) == {"brow_L": [[1, 0.2], [16, 0.8], [31, 0.4]]}
    page.get_by_role("button", name="Reverse").click()
    assert keyed(viewer) == {"brow_L": [[1, 0.4], [16, 0.8], [31, 0.2]]}
    page.evaluate("usdrigui.app.timeline.go(40)")
    page.keyboard.press("Space")
    viewer.until(f"{session}.frame < 40")
    page.keyboard.press("Space")
    assert page.evaluate(f"{session}.frame") < 31
    page.evaluate("usdrigui.app.timeline.openSheet(false)")
    page.evaluate("usdrigui.app.timeline.go(40)")
    page.keyboard.press("Space")
    viewer.until(f"{session}.frame > 40")
    page.keyboard.press("Space")
    page.evaluate("usdrigui.app.timeline.openSheet(true)")
    numbers = page.locator(".dope-ruler i" if shows == "Rows" else ".curve-number").all_text_contents()
    assert {"5", "45"} <= {*numbers}
    assert shows == "Rows" or {"0", "0.5", "1"} <= {*numbers}


def test_what_changed_is_keyed_whatever_is_selected(viewer):
    viewer.page.evaluate("usdrigui.app.session.select([usdrigui.app.session.elements.list[0]])")
    selected = viewer.page.evaluate(
        "usdrigui.app.session.chosenControls.map((i) => usdrigui.app.session.controls[i].name)"
    )
    other = next(each for each in ("brow_L", "brow_R") if each not in selected)
    key(viewer, 1, **{other: 0.5})
    assert {*keyed(viewer)} == {other, *selected}


def test_a_tween_lies_between_the_keys_around(viewer):
    key(viewer, 1, brow_L=0.2)
    key(viewer, 11, brow_L=0.6)
    viewer.page.evaluate("usdrigui.app.timeline.go(4)")
    tween = viewer.page.get_by_label("Tween between the keys before and after")
    tween.fill("75")
    assert viewer.moved() == pytest.approx({"brow_L": 0.5})
    viewer.key("Control+z")
    assert viewer.moved() == pytest.approx({"brow_L": 0.32})


def test_a_pose_is_copied_pasted_flipped_and_mirrored(viewer):
    def act(name):
        viewer.click(name, exact=True)

    pose = {"brow_L": 0.3, "smile_R": 0.6, "pucker": 0.5}
    viewer.set(**pose)
    act("Copy")
    act("Flip")
    assert viewer.moved() == pytest.approx({"brow_R": 0.3, "smile_L": 0.6, "pucker": 0.5})
    act("Left to right")
    assert viewer.moved() == pytest.approx({"smile_L": 0.6, "smile_R": 0.6, "pucker": 0.5})
    act("Paste")
    assert viewer.moved() == pytest.approx(pose)
    for _ in range(3):
        viewer.key("Control+z")
    assert viewer.moved() == pytest.approx(pose)


def test_ways_shelf_and_sound_are_undone_and_come_back_with_the_page(viewer, tmp_path):
    """Picked keys go on smoothly; a pose is kept and taken; a sound lengthens time; outlines show keys around."""
    page = viewer.page
    session = "usdrigui.app.session"
    for frame, value in ((1, 0.2), (11, 0.6), (31, 0.4)):
        key(viewer, frame, brow_L=value)
    page.keyboard.press("d")
    line = page.locator(".dope-row", has_text="brow_L").locator(".dope-line").bounding_box()
    start, end = ((line["x"] + share * line["width"], line["y"] + 8) for share in (0.15, 0.7))
    drag(page, start, end)
    page.get_by_role("button", name="Smooth").click()
    ways = {"brow_L": [[1, 0.2], [11, 0.6, "smooth"], [31, 0.4, "smooth"]]}
    assert keyed(viewer) == ways
    sound = tmp_path / "voice.wav"
    with wave.open(str(sound), "wb") as out:
        out.setparams((1, 2, 8000, 0, "NONE", ""))
        out.writeframes(bytes(2 * 8000 * 3))
    with page.expect_file_chooser() as asked:
        page.get_by_role("button", name="Sound…").click()
    asked.value.set_files(str(sound))
    viewer.until("usdrigui.app.timeline.sound.isReady")
    assert page.evaluate(f"{session}.range") == [1, 73]
    page.get_by_role("button", name="Keep pose").click()
    viewer.set(smile_R=0.8)
    page.get_by_role("button", name="Take the pose pose 1").click()
    assert viewer.moved() == pytest.approx({"brow_L": 0.4})
    page.evaluate("usdrigui.app.timeline.go(20)")
    page.keyboard.press("o")
    viewer.until("usdrigui.app.view.onion.drawn.length > 0")
    page.reload()
    viewer.until("window.usdrigui !== undefined")
    page.get_by_role("button", name="Restore").click()
    assert keyed(viewer) == ways
    said = page.evaluate(f"({{ shelf, sound }} = {session}, [shelf.map(({{ name }}) => name), sound])")
    assert said == [["pose 1"], {"name": "voice.wav", "start": 1, "seconds": 3}]
    page.keyboard.press("Control+z")
    assert page.evaluate(f"[{session}.shelf.length, {session}.sound, {session}.keys.size]") == [0, None, 0]


def test_a_tangent_of_a_picked_key_bends_the_curve_within_the_range(viewer):
    for frame, value in ((1, 0.2), (11, 0.8), (21, 0.4)):
        key(viewer, frame, brow_L=value)
    viewer.key("d")
    viewer.click("Curves", exact=True)
    viewer.click("Smooth", exact=True)
    page = viewer.page
    page.locator(".curve-key").nth(1).click()
    end = page.locator("circle.curve-tangent").nth(1).bounding_box()
    x, y = end["x"] + end["width"] / 2, end["y"] + end["height"] / 2
    drag(page, (x, y), (x, y - 400))
    assert keyed(viewer) == {"brow_L": [[1, 0.2, "smooth"], [11, 0.8, "smooth", 0.06], [21, 0.4, "smooth"]]}
    viewer.key("Control+z")
    assert keyed(viewer)["brow_L"][1] == [11, 0.8, "smooth"]
