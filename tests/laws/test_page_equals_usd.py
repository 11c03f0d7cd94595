"""The page has handles and tracks where UsdSkel puts those of the layer, at every frame of the clip.

The layer lies over its character and plays the character's own animation; the page's sources run in Node.js.  The
layouts are such that UsdSkel can say all of it: no joint that an element turns, nor one below it, is turned by another.
"""

import base64
import functools
import json
import shutil
import subprocess
from dataclasses import replace
from types import SimpleNamespace

import laid_out
import numpy as np
import pytest
import skinned_stages
from folders import ROOT
from page_in_node import placed_by_the_page
from pxr import Sdf, Usd, UsdSkel

from usdrigui.layer.write_layout import layer_for, stage_metadata
from usdrigui.model.levels import states
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings
from usdrigui.view.clip import clip_values
from usdrigui.view.web.packing import pack

pytestmark = pytest.mark.usefixtures("every_point_drawn")
CLOSE = 8e-5
"""Of the character's diagonal: what 16-bit positions and offsets leave of a handle's place."""
HAIR = 0.3
"""Of a handle's width: as far as a drawn track may be from where it would be if it followed everything exactly."""
JAW, EYE = ("Jaw:rx", "Jaw:ry"), ("Eye:rx", "Eye:ry")
FACE = (JAW, ("half",), ("smile_L", "sneer_L"), ("brow_L",), ("pucker", "jawLeft", "chin"))
"""Joystick of a joint, in-betweens, joystick and fan of shapes."""
MADE = {
    "joints and the skin": {"groups": FACE},
    "a board with a joint": {"groups": (*FACE[:2], EYE, ("chin",), ("brow_L",)), "beside": (EYE[0], "chin")},
    "static": {"groups": FACE, "adapt": "static"},
    "a static board": {"groups": (EYE, ("chin",)), "beside": (EYE[0], "chin"), "adapt": "static"},
}


def made(folder):
    """A mask on joints that an animation turns, the head among them, with shapes and in-betweens that it moves."""
    names = ("Hips/Head", "Hips/Head/Jaw", "Hips/Head/Eye")
    path = skinned_stages.character(folder / "made.usda", animated_joints=names)
    stage = Usd.Stage.Open(str(path))
    animation = UsdSkel.Animation(stage.GetPrimAtPath("/World/Char/Anim"))
    count, rng = len(animation.GetBlendShapesAttr().Get()), np.random.default_rng(4)
    for time in range(1, 21):
        animation.GetBlendShapeWeightsAttr().Set(rng.uniform(-0.3, 1.0, count).tolist(), time)
    stage.Save()
    return path


def sample_layout(rig):
    """Joystick, fan and sliders on the face; jaw, an eye and two shapes on the board.  The head turns all of them."""
    groups = [
        ("Jaw:rx",),
        ("EyeLeft:rx", "EyeLeft:ry"),
        ("EyeRight:rx", "EyeRight:ry"),
        ("jawLeft", "jawRight"),
        ("mouthSmileLeft", "mouthStretchLeft"),
        ("mouthLeft", "mouthRight", "mouthFunnel"),
    ]
    grouped = {name for group in groups for name in group}
    alone = [(each.name,) for each in rig.controls if each.name not in grouped and each.kind == "blendShape"]
    beside = ("Jaw:rx", "EyeLeft:rx", "headSquash", "tongueOut")
    return laid_out.layout_of(rig, groups=[*groups, *alone], beside=beside)


@pytest.fixture(scope="module")
def cases(tmp_path_factory):
    """By name: rig, layout and the character's file."""
    folder = tmp_path_factory.mktemp("clips")
    sample = ROOT / "sample_assets" / "char.usda"
    (face,), (rig,) = read_rigs(sample, Settings()), read_rigs(source := made(folder), Settings())
    found = {name: (rig, laid_out.layout_of(rig, seed=5, **given), source) for name, given in MADE.items()}
    return {"sample": (face, sample_layout(face), sample), **found}


@pytest.fixture(scope="module")
def pages(cases):
    """By name, handle and tracks of each element at each sample of the clip; one process for all."""
    asked = [
        {"scene": base64.b64encode(pack([(rig, layout)], "law")).decode(), "times": rig.clip.times.tolist()}
        for rig, layout, _ in cases.values()
    ]
    return dict(zip(cases, placed_by_the_page(asked), strict=True))


@pytest.mark.parametrize("name", ["sample", *MADE])
def test_the_page_has_handles_and_tracks_where_usd_has_them(cases, pages, tmp_path, monkeypatch, name):
    for asked in ("root_points", "element_prim"):  # of many elements in one mesh
        monkeypatch.setattr(laid_out, asked, functools.cache(getattr(laid_out, asked)))
    rig, layout, source = cases[name]
    stage = attached(tmp_path, rig, layout, source)
    drives = {control.name: control.drive for control in rig.controls}
    diagonal = laid_out.extent(laid_out.posed(rig).points)
    travels = np.zeros(len(layout.elements))
    for time, placed in zip(rig.clip.times.tolist(), pages[name], strict=True):
        for i, (element, page) in enumerate(zip(layout.elements, placed["elements"], strict=True)):
            for ours, theirs in zip(page["tracks"], laid_out.tracks(stage, rig.path, element, time), strict=True):
                assert np.abs(np.array(ours) - theirs).max() < HAIR * layout.frame.handle_width, (element.name, time)
            if told(element, drives):
                centre = laid_out.handle(stage, rig.path, element, time)[0]
                assert np.abs(page["handle"] - centre).max() < CLOSE * diagonal, (element.name, time)
            travels[i] = max(travels[i], np.abs(np.array(page["handle"]) - element.anchor.position).max())
    assert (travels > 0.5 * layout.frame.handle_width).mean() > 0.8


def told(element, drives):
    """Whether a gprim can be where the handle is: on the skin, or sliding by weights; no gprim slides by joints."""
    slides = element.anchor.on_board or element.adapt == "static"
    return not slides or not any(len(drives[member.control].joints) for member in element.members)


def attached(folder, rig, layout, source):
    """The layer over its character, with UsdSkel's deformation baked into points."""
    layer = layer_for([(rig, layout)], str(source), stage_metadata(Sdf.Layer.FindOrOpen(str(source))))
    layer.Export(str(folder / "layout.usda"))
    stage = Usd.Stage.Open(str(folder / "layout.usda"))
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath(rig.path)))
    return stage


def test_a_page_reads_the_values_of_a_clip_as_a_film_does(cases):
    rig, layout, _ = cases["joints and the skin"]
    away = replace(rig, body=replace(rig.body, base_weights=rig.body.base_weights + 0.2))
    scene = base64.b64encode(pack([(away, layout)], "law")).decode()
    (frames,) = placed_by_the_page([{"scene": scene, "times": rig.clip.times.tolist()}])
    values = np.array([frame["values"] for frame in frames])
    assert values == pytest.approx(clip_values(away), abs=1e-5)
    assert (np.ptp(values, axis=0) > 0.1).sum() > 10


OPENING = """
import { text } from 'node:stream/consumers';
import { Levels } from '%s';
const found = JSON.parse(await text(process.stdin)).map((elements) => {
  const coarse = elements.filter(({ inner }) => inner.length).map((each) => [each]);
  return [[], ...coarse].map((opened) => {
    const levels = new Levels(elements);
    levels.toggle(opened, true);
    return elements.filter((each) => levels.shows(each)).map(({ name }) => name);
  });
});
process.stdout.write(JSON.stringify(found));
"""


def test_the_page_shows_the_elements_that_the_levels_have():
    if shutil.which("node") is None:
        pytest.skip("Node.js is not installed")
    layouts = [random_levels(np.random.default_rng(seed)) for seed in range(20)]
    program = OPENING % (ROOT / "viewer" / "src" / "levels.js").as_uri()
    done = subprocess.run(
        ["node", "--input-type=module", "-e", program],
        input=json.dumps(layouts), capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    for elements, found in zip(layouts, json.loads(done.stdout), strict=True):
        ours = states([element_of(**each) for each in elements])
        assert [set(shown) for shown in found] == [
            {name for name, visible in ours.items() if state in visible} for state in range(len(found))
        ]


def element_of(name, inner, mirror):
    return SimpleNamespace(
        name=name, inner=inner, mirror=mirror
    )  # fmt: skip


def random_levels(rng):
    """Coarse elements, some of them mirrored, that share members."""
    names, coarse = [f"e{i}" for i in range(8)], [f"c{i}" for i in range(4)]
    inner = {name: rng.choice(names, rng.integers(1, 4), replace=False).tolist() for name in coarse}
    mirrors = {"c0": "c1", "c1": "c0"}
    return [{"name": each, "inner": inner.get(each, []), "mirror": mirrors.get(each, "")} for each in [*coarse, *names]]
