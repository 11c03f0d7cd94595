"""The live link: two pages keep one animation in one file, through the real server and without a browser.

Both run the viewer's own sources in Node.js.  Their law: what both have keyed is in the file and on both pages, and USD
evaluates from the file over the source what they show.
"""

import base64
import json

import laid_out
import makers
import numpy as np
import pytest
from browser_pages import Viewer
from page_in_node import answer, serving
from pxr import Sdf
from random_characters import composed, off, random_character
from viewer_layouts import MIRRORS, peak_layout

from usdrigui.reading.character import read_rigs
from usdrigui.settings import load
from usdrigui.view.web.live import LiveFile
from usdrigui.view.web.packing import pack
from usdrigui.view.web.page import page_html

FRAMES = range(1, 13)
TOLERANCE = 2e-5 + 2.0**-10
"""A SkelAnimation holds scales that change in time as halves."""


def served(path, read=(), page="page"):
    return serving(page, LiveFile(path, read))


def pages(server, rig, rounds, times=(), more=()):
    asked = {
        "scene": base64.b64encode(pack([(each, laid_out.layout_of(each)) for each in (rig, *more)], "live")).decode(),
        "address": f"{server.address}edit",
        "origin": f"http://{server.host}",
        "rounds": rounds,
        "times": list(times),
    }
    return json.loads(answer("live_pages.mjs", asked))


def character(folder, seed):
    path = folder / "shot.usda"
    random_character(path, np.random.default_rng(seed))
    return path, read_rigs(path, load({"read": {"joints": "all"}}))[0]


def keyed(name, frame, value):
    return [["go", frame], ["set", {name: value}], ["key", [name]]]


def work_in(path):
    return json.loads(Sdf.Layer.FindOrOpen(str(path)).customLayerData["usdrigui"]["work"])


def random_rounds(rig, rng):
    """Keys of both pages at once, at frames of their own."""
    names = [control.name for control in rig.controls]
    rounds, expected = [], {}
    for _ in range(4):
        both = []
        for page in range(2):
            actions = []
            for _ in range(rng.integers(0, 4)):
                name, frame = str(rng.choice(names)), int(2 * rng.integers(1, 6) + page)
                value = round(float(rng.uniform(0.1, 0.9)), 3)
                control = next(each for each in rig.controls if each.name == name)
                value = control.minimum + value * (control.maximum - control.minimum)
                expected[name, frame] = value
                actions += keyed(name, frame, value)
            both.append(actions)
        rounds.append(both)
    return rounds, expected


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_two_pages_lose_no_key_of_each_other_and_usd_shows_what_they_show(tmp_path, seed):
    source, rig = character(tmp_path, seed)
    rounds, expected = random_rounds(rig, np.random.default_rng(seed))
    edit = tmp_path / "edit.usda"
    with served(edit, [source]) as server:
        found = pages(server, rig, rounds, FRAMES)
    assert found["states"] == ["saved", "saved"]
    one, other = found["after"][-1]
    assert one == other
    assert {name: one[name] for name in ("keys", "standing")} == {k: v for k, v in work_in(edit).items() if k != "root"}
    said = {(name, frame): value for name, track in one["keys"].items() for frame, value in track}
    assert said == pytest.approx(expected)
    stage = composed(tmp_path / "edit.usda", edit.read_text(), source)
    for k, time in enumerate(FRAMES):
        for page in found["frames"]:
            assert max(off(page[k], stage, rig, float(time))) < TOLERANCE, (seed, time)


def test_what_another_page_keyed_is_no_step_of_ones_own(tmp_path):
    """Undo takes back the page's own key, not the other page's, which came after; redo gives it again."""
    _, rig = character(tmp_path, 1)
    one, two = (control.name for control in rig.controls[:2])
    rounds = [[keyed(one, 3, 0.5), []], [[], keyed(two, 5, 0.25)], [[["undo"]], []], [[["redo"]], []]]
    with served(tmp_path / "edit.usda") as server:
        after = pages(server, rig, rounds)["after"]
    assert [page["keys"] for page in after[2]] == [{two: [[5, 0.25]]}] * 2
    assert [page["keys"] for page in after[3]] == [{one: [[3, 0.5]], two: [[5, 0.25]]}] * 2


def test_characters_of_a_shot_and_the_frames_set_by_hand_share_one_file(tmp_path):
    """Keys of each character and the first and last frame are with the other page; those of the others stay."""
    face = makers.face()
    other = makers.changed(face, path="/Other")
    name = face.controls[0].name
    second = [["of", 1, action] for action in keyed(name, 5, 0.25)]
    rounds = [[keyed(name, 3, 0.5), second], [[["span", 101, 120]], []]]
    with served(tmp_path / "edit.usda") as server:
        found = pages(server, face, rounds, more=[other])
    first = {"keys": {name: [[3, 0.5]]}, "standing": {}, "span": [101, 120]}
    assert found["all"] == [[first, {"keys": {name: [[5, 0.25]]}, "standing": {}}]] * 2
    assert found["states"] == ["saved", "saved"]
    assert {each["root"] for each in work_in(tmp_path / "edit.usda")["characters"]} == {face.path, "/Other"}


def resaved(path):
    """As another program writes it: USD's own text, strings in other quotes."""
    layer = Sdf.Layer.FindOrOpen(str(path))
    text = layer.ExportToString()
    path.write_text(text)
    return text


def test_a_file_that_usd_wrote_again_is_read_and_one_with_more_in_it_is_not_replaced(tmp_path):
    """Keys are read in whatever quotes; what no page wrote is kept until a person says so."""
    _, rig = character(tmp_path, 1)
    name, edit = rig.controls[0].name, tmp_path / "edit.usda"
    with served(edit) as server:
        pages(server, rig, [[keyed(name, 3, 0.5)]])
        assert resaved(edit).count("string work = '") == 1
        again = pages(server, rig, [[[]], [keyed(name, 5, 0.25)]])
        assert again["after"][0][0]["keys"] == {name: [[3, 0.5]]}
        assert work_in(edit)["keys"] == {name: [[3, 0.5], [5, 0.25]]}
        layer = Sdf.Layer.FindOrOpen(str(edit))
        layer.Reload()
        work = {**work_in(edit), "keys": {"gone": [[1, 1.0]]}}
        layer.customLayerData = {"usdrigui": {"work": json.dumps(work)}}
        held = resaved(edit)
        foreign = pages(server, rig, [[keyed(name, 7, 0.25)]])
        assert foreign["states"] == ["foreign"]
        assert edit.read_text() == held


def test_what_another_program_writes_while_a_page_is_open(tmp_path):
    """Keys are taken where the page would write the same; where the file holds more, the page waits to be told."""
    _, rig = character(tmp_path, 1)
    name, edit = rig.controls[0].name, tmp_path / "edit.usda"

    def change(old, new):
        return {"path": str(edit), "from": old, "to": new}

    with served(edit) as server:
        found = pages(
            server, rig, [[keyed(name, 3, 0.5)], change("#usda 1.0", "#usda 1.0\n# mine"), [keyed(name, 5, 1)]]
        )
        assert found["states"] == ["foreign"]
        assert edit.read_text().startswith("#usda 1.0\n# mine")
        assert work_in(edit)["keys"] == {name: [[3, 0.5]]}
        back = pages(server, rig, [[[]], change("# mine\n", ""), [keyed(name, 5, 1)]])
        assert back["states"] == ["saved"]
        lines = edit.read_text().split("\n")
        head = lines.index(")")
        written = "\n\n".join([*lines[6:head], *lines[2:6]])
        turned = pages(server, rig, [[[]], change("\n".join(lines[2:head]), written)])
        assert turned["states"] == ["saved"], "lines of the head in another order, as USD writes them"
        assert work_in(edit)["keys"] == {name: [[3, 0.5], [5, 1.0]]}


def test_a_drag_in_the_browser_is_in_the_file(browser, tmp_path):
    """With the page's own policy, origin and clock."""
    rig = makers.face()
    html = page_html([(rig, peak_layout(rig, mirrors=MIRRORS))], "face", live="edit.usda")
    with served(tmp_path / "edit.usda", page=html) as server:
        viewer = Viewer(browser, server.address)
        name = "chin"
        start = viewer.element(name)["handle"]
        viewer.drag(start, viewer.element(name)["tracks"][0][-1])
        viewer.until("usdrigui.app.session.keys.size && usdrigui.app.live.holds(usdrigui.app.session)")
        assert viewer.page.locator(".link").inner_text() == "edit.usda: saved"
        assert work_in(tmp_path / "edit.usda")["keys"][name][0][1] == pytest.approx(viewer.values()[name])
        assert [each for each in viewer.trouble if server.host not in each] == []
        viewer.close()
