"""The live link: pages and a program keep one animation in one file, through the real server and without a browser.

Pages run the viewer's own sources in Node.js.  The law: what any has keyed is in the file and on every page, and USD
evaluates from the file over the source what they show.
"""

import base64
import json
from contextlib import contextmanager

import laid_out
import makers
import numpy as np
import pytest
from browser_pages import Viewer
from page_in_node import conversation, serving
from pxr import Sdf
from random_characters import composed, off, random_character
from viewer_layouts import MIRRORS, peak_layout

from usdrigui.reading.character import read_rigs
from usdrigui.settings import ReadSettings, load
from usdrigui.view.web.live import LiveFile, revision
from usdrigui.view.web.packing import pack
from usdrigui.view.web.page import page_html

FRAMES = range(1, 13)
TOLERANCE = 2e-5 + 2.0**-10
"""A SkelAnimation holds scales that change in time as halves."""


@contextmanager
def open_pages(path, rig):
    """A function that lets two pages of a server do steps (live_pages.mjs) and returns what they hold then."""
    scene = base64.b64encode(pack([(rig, laid_out.layout_of(rig))], "live")).decode()
    with serving("page", LiveFile(path, (), ReadSettings())) as server, conversation("live_pages.mjs") as told:
        told({"scene": scene, "address": f"{server.address}edit", "origin": f"http://{server.host}"})
        yield lambda *steps: told(steps)


def character(folder, seed):
    path = folder / "shot.usda"
    random_character(path, np.random.default_rng(seed))
    return path, read_rigs(path, load({"read": {"joints": "all"}}))[0]


def keyed(name, frame, value):
    return [["go", frame], ["set", {name: value}], ["key", [name]]]


def work_in(path):
    return json.loads(Sdf.Layer.OpenAsAnonymous(str(path)).customLayerData["usdrigui"]["work"])


# --- programs ------------------------------------------------------------------------------------------


def attribute_of(rig, control):
    name = f"c{rig.control_names.index(control)}"
    return f"{rig.path}/rigUI/{name}.rigUI:control:{name}:value"


class Program:
    """A program that reads the layer anew, edits it by USD and saves it."""

    def __init__(self, path, rig):
        self.layer, self.rig = Sdf.Layer.FindOrOpen(str(path)), rig
        self.own = {}

    def edit(self, control, frame, value, number):
        """Also something that no page says: of a prim, a property, the layer."""
        self.layer.Reload(force=True)
        path = Sdf.Path(attribute_of(self.rig, control))
        if not self.layer.GetAttributeAtPath(path):
            prim = Sdf.CreatePrimInLayer(self.layer, path.GetPrimPath())
            Sdf.AttributeSpec(prim, path.name, Sdf.ValueTypeNames.Double)
        self.layer.SetTimeSample(path, frame, value)
        prim = Sdf.CreatePrimInLayer(self.layer, f"{self.rig.path}/Prop{number % 3}")
        attribute = Sdf.AttributeSpec(prim, f"n{number}", Sdf.ValueTypeNames.Int)
        attribute.default = number
        self.layer.comment = f"{number}"
        self.layer.subLayerPaths = [f"./below{number}.usda"]
        self.layer.customLayerData = {**self.layer.customLayerData, "studio": number}
        self.layer.Save()
        self.own[str(attribute.path)] = number

    def check(self):
        self.layer.Reload(force=True)
        number = [*self.own.values()][-1]
        assert {path: self.layer.GetAttributeAtPath(path).default for path in self.own} == self.own
        assert [self.layer.comment, *self.layer.subLayerPaths] == [f"{number}", f"./below{number}.usda"]
        assert self.layer.customLayerData["studio"] == number


def together(do, program, rng, count, path):
    """Edits of two pages and a program in a random order, which see the others' now and then.  What came last of each
    control at each frame, but where somebody was asked; who is asked has set it, and so has somebody else meanwhile."""
    last, own, others = {}, [set(), set()], [set(), set()]
    for number in range(count):
        party, control, frame = int(rng.integers(0, 3)), rng.choice(program.rig.controls), int(rng.integers(1, 13))
        what, share = (control.name, frame), float(rng.uniform(0.1, 0.9))
        last[what] = round(control.minimum + share * (control.maximum - control.minimum), 4)
        if party < 2:
            own[party].add(what)
            do(["act", party, *keyed(*what, last[what])])
        else:
            program.edit(*what, last[what], number)
            others = [each | {what} for each in others]
        for page in rng.permutation(2)[: rng.integers(0, 3)].tolist():
            before = path.read_bytes()
            found = do(["turn", page])[page]
            asked = set(map(tuple, found["asked"]))
            assert asked <= own[page] & others[page], number
            for each in asked:
                last.pop(each, None)
            if path.read_bytes() != before:
                others[1 - page] |= own[page]
                own[page] = set()
            if found["revision"] == revision(path.read_bytes()):
                others[page] = set()
    return last


@pytest.mark.parametrize(("seed", "count"), [(1, 60), (2, 60), pytest.param(3, 1000, marks=pytest.mark.slow)])
def test_two_pages_and_a_program_end_with_the_same_and_only_true_conflicts_are_asked(tmp_path, seed, count):
    source, rig = character(tmp_path, seed)
    edit, rng = tmp_path / "edit.usda", np.random.default_rng(seed)
    with open_pages(edit, rig) as do:
        do(["act", 0, *keyed(rig.controls[0].name, 1, 0.5)], ["settle"])
        program = Program(edit, rig)
        last = together(do, program, rng, count, edit)
        one, other = do(["settle"])
        shown = do(["show", list(FRAMES)])
    assert one["state"] == other["state"] == "saved"
    work = work_in(edit)
    for page in (one, other):
        assert [page["keys"], page["standing"]] == [work["keys"], work["standing"]]
    said = {(name, frame): value for name, track in one["keys"].items() for frame, value in track}
    assert said.items() >= last.items()
    program.check()
    stage = composed(edit, edit.read_text(), source)
    for page in shown:
        for time, frame in zip(FRAMES, page["frames"], strict=True):
            assert max(off(frame, stage, rig, float(time))) < TOLERANCE, time


@pytest.mark.parametrize("name", ["a0", "neck:ry"])
def test_another_weight_or_rotation_comes_as_a_key(tmp_path, name):
    _, rig = character(tmp_path, 1)
    edit, control = tmp_path / "edit.usda", rig.controls[rig.control_names.index(name)]
    first, second = (round(share * control.maximum, 4) for share in (0.3, 0.6))
    with open_pages(edit, rig) as do:
        do(["act", 0, *keyed(name, 5, first)], ["settle"])
        layer = Sdf.Layer.FindOrOpen(str(edit))
        arrays = {}
        layer.Traverse("/", lambda path: arrays.update({path: layer.QueryTimeSample(path, 5.0)}))
        do(["act", 0, *keyed(name, 5, second)], ["settle"])
        layer.Reload()
        for path in arrays:
            if path.name in ("blendShapeWeights", "rotations"):
                layer.SetTimeSample(path, 5.0, arrays[path])
        layer.Save()
        assert do(["settle"])[0]["keys"] == {name: [[5, pytest.approx(first, abs=1e-4)]]}
        layer.Reload()
        assert layer.GetAttributeAtPath(attribute_of(rig, name)).default == pytest.approx(first, abs=1e-4)


def test_an_old_file_put_back_is_old(tmp_path):
    _, rig = character(tmp_path, 1)
    name, edit = rig.controls[0].name, tmp_path / "edit.usda"
    with open_pages(edit, rig) as do:
        do(["act", 0, *keyed(name, 3, 0.5)], ["settle"])
        old = edit.read_bytes()
        do(["act", 1, *keyed(name, 5, 0.25)], ["settle"])
        edit.write_bytes(old)
        assert [page["keys"] for page in do(["settle"])] == [{name: [[3, 0.5]]}] * 2


def test_a_drag_in_the_browser_is_in_the_file(browser, tmp_path):
    """With the page's own policy, origin and clock."""
    rig = makers.face()
    html = page_html([(rig, peak_layout(rig, mirrors=MIRRORS))], "face", live="edit.usda")
    with serving(html, LiveFile(tmp_path / "edit.usda", (), ReadSettings())) as server:
        viewer = Viewer(browser, server.address)
        name = "chin"
        start = viewer.element(name)["handle"]
        viewer.drag(start, viewer.element(name)["tracks"][0][-1])
        viewer.until("usdrigui.app.session.keys.size && usdrigui.app.live.holds(usdrigui.app.session)")
        assert viewer.page.locator(".link").inner_text() == "edit.usda: saved"
        assert work_in(tmp_path / "edit.usda")["keys"][name][0][1] == pytest.approx(viewer.values()[name])
        assert [each for each in viewer.trouble if server.host not in each] == []
        viewer.close()
