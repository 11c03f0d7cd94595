"""Real rigs in the viewer, with the layouts that `usdrigui process` gives them: sizes, drags, pulls, playback."""

from dataclasses import replace

import numpy as np
import pytest
from browser_pages import Viewer
from folders import ASSETS, SAMPLE
from makers import changed

from usdrigui import pipeline
from usdrigui.character.deform import deform
from usdrigui.cli import main
from usdrigui.settings import Settings

RIGS = {
    # file, most megabytes, a control to drag
    "sample": (SAMPLE, 3.0, "jawOpen"),
    "vitruvian": (ASSETS / "vitruvian.usdc", 12.0, "Jaw_Lower"),
    "ict": (ASSETS / "ict_face57.usdc", 12.0, "jawOpen"),
    "poses": (ASSETS / "mh_poseunits.usdc", 12.0, "JawDrop"),
}
LIMIT = 300_000
"""Work after which the solver stops: what is tested here does not need the optimum."""

pytestmark = pytest.mark.real


@pytest.fixture(scope="module", params=RIGS)
def shown(request, browser, tmp_path_factory):
    """(viewer, rig, layout, control to drag) of one asset, laid out and opened as a user does it."""
    path, most, control = RIGS[request.param]
    if not path.exists():
        pytest.skip(f"{path.name} is not there")
    folder = tmp_path_factory.mktemp(request.param)
    layer, page = folder / "char.rigui.usda", folder / "char.html"
    limits = ["--gap", "1e-2", "--set", f"solve.work_limit={LIMIT}"]
    assert main(["process", str(path), "--quiet", "-o", str(layer), *limits]) == 0
    assert main(["view", str(layer), "--quiet", "--html", str(page)]) == 0
    assert page.stat().st_size <= most * 1e6
    [(rig, layout)] = pipeline.load_layer(layer, Settings()).characters
    viewer = Viewer(browser, page)
    yield viewer, rig, layout, control
    assert viewer.trouble == []
    viewer.close()


@pytest.fixture(autouse=True)
def at_rest(shown):
    viewer = shown[0]
    viewer.page.evaluate("usdrigui.app.session.clear()")
    viewer.page.evaluate("usdrigui.app.view.home()")
    viewer.option("handles", True)
    viewer.option("skinDrag", True)


def element_of(viewer, control):
    return next(each for each in viewer.page.evaluate("usdrigui.elements()") if control in each["controls"])


def test_every_element_of_the_layout_is_in_the_picture_of_its_part(shown):
    viewer, _, layout, _ = shown
    scrolled = {each.name for each in layout.elements if each.anchor.on_board}
    found = []
    for part in range(viewer.page.evaluate("usdrigui.app.session.character.layout.sections.length")):
        viewer.page.evaluate(f"usdrigui.app.session.show({part})")
        elements = viewer.page.evaluate("usdrigui.elements()")
        width, height = viewer.page.evaluate("[usdrigui.app.view.width, usdrigui.app.view.height]")
        assert all(0 < each["handle"][0] < width for each in elements)
        assert all(each["name"] in scrolled or 0 < each["handle"][1] < height for each in elements)
        found += [each["name"] for each in elements]
    viewer.page.evaluate("usdrigui.app.session.show(0)")
    assert sorted(found) == sorted(each.name for each in layout.elements)


def test_handle_drag_sets_the_control_and_moves_the_skin(shown):
    viewer, rig, _, name = shown
    control = next(each for each in rig.controls if each.name == name)
    viewer.key("f")  # closer: a crowded face beside a large board has tracks of a few pixels
    before = viewer.skin_shot()
    element = element_of(viewer, name)
    member = element["controls"].index(name)
    track = element["tracks"][member]
    lengths = np.cumsum([0.0, *np.linalg.norm(np.diff(track, axis=0), axis=1)])
    target = [float(np.interp(0.5 * lengths[-1], lengths, [at[axis] for at in track])) for axis in (0, 1)]
    viewer.drag(element["handle"], target)
    value = viewer.values()[name]
    assert control.minimum + 0.3 * (control.maximum - control.minimum) < value < control.maximum
    assert element_of(viewer, name)["handle"] == pytest.approx(target, abs=1.5)
    assert viewer.skin_shot() != before


def test_the_animation_moves_joints_and_shapes_as_the_library_does(shown):
    """At every third of its samples; joints follow the animation, whatever the controls are."""
    viewer, rig, _, _ = shown
    if rig.clip is None or len(rig.clip.times) < 2:
        pytest.skip("this rig has no animation")
    clip = rig.clip
    for k in range(0, len(clip.times), max(1, len(clip.times) // 3)):
        viewer.page.evaluate("(frame) => usdrigui.app.timeline.go(frame)", float(clip.times[k]))
        viewer.settle()
        far = viewer.furthest(rig, deform(at_sample(rig, k)))
        assert far <= 3e-5, "as far as 16-bit steps allow"


def at_sample(rig, k):
    """The rig whose neutral pose is sample k of its animation."""
    clip = rig.clip
    weights = clip.weights[k] if clip.weights.size else rig.body.base_weights
    joints = rig.body.joints
    if clip.locals.size:
        joints = tuple(replace(joint, base=local) for joint, local in zip(joints, clip.locals[k], strict=True))
    return changed(rig, base_weights=np.asarray(weights, dtype=np.float64), joints=joints)
