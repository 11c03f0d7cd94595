"""Real rigs in the viewer: file sizes, drags of handle and skin, no trouble."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from browser_pages import Viewer
from viewer_layouts import peak_layout

from usdrigui.deform import deform
from usdrigui.settings import Settings
from usdrigui.usd.rig import read_rigs
from usdrigui.view.page import page_html

REPOSITORY = Path(__file__).resolve().parents[2]
ASSETS = REPOSITORY.parent / "shared" / "assets"
RIGS = {
    # file, view, most megabytes, a control to drag
    "sample": (REPOSITORY / "sample_assets" / "char.usda", (0.0, 0.0, 1.0), 3.0, "jawOpen"),
    "vitruvian": (ASSETS / "vitruvian.usdc", (0.0, -1.0, 0.0), 12.0, "Jaw_Lower"),
    "ict": (ASSETS / "ict_face57.usdc", (0.0, 0.0, 1.0), 12.0, "jawOpen"),
    "poses": (ASSETS / "mh_poseunits.usdc", (0.0, 0.0, 1.0), 12.0, "JawDrop"),
}

pytestmark = pytest.mark.real


@pytest.fixture(scope="module", params=RIGS)
def shown(request, browser, tmp_path_factory):
    """(viewer, rig, control to drag), the page's size checked."""
    path, view, most, control = RIGS[request.param]
    if not path.exists():
        pytest.skip(f"{path.name} is not there")
    rig = read_rigs(path, Settings())[0]
    page = tmp_path_factory.mktemp("real") / f"{request.param}.html"
    page.write_text(page_html([(rig, peak_layout(rig, view))], request.param))
    assert page.stat().st_size <= most * 1e6
    viewer = Viewer(browser, page)
    viewer.option("occlusion", "overlay")
    yield viewer, rig, control
    assert viewer.trouble == []
    viewer.close()


@pytest.fixture(autouse=True)
def at_rest(shown):
    viewer = shown[0]
    viewer.option("handles", True)
    viewer.page.evaluate("usdrigui.app.session.reset()")
    viewer.settle()


def test_handle_drag_sets_the_control_and_moves_the_skin(shown):
    viewer, rig, name = shown
    control = next(each for each in rig.controls if each.name == name)
    before = viewer.skin_shot()
    element = viewer.element(name)
    track = element["tracks"][0]
    grasp = element["handle"]
    # Other handles may lie on top of this one at its peak: take the gesture itself to the element.
    viewer.page.evaluate(
        """(name) => {
          const { view, session } = usdrigui.app;
          const wanted = session.elements.list.find((element) => element.name === name);
          view.overlay.elementAt = () => wanted;
        }""",
        name,
    )
    share = 0.5
    lengths = np.cumsum([0.0, *np.linalg.norm(np.diff(track, axis=0), axis=1)])
    target = [float(np.interp(share * lengths[-1], lengths, [at[axis] for at in track])) for axis in (0, 1)]
    viewer.drag(grasp, target)
    viewer.page.evaluate("() => { delete usdrigui.app.view.overlay.elementAt; }")
    value = viewer.values()[name]
    assert control.minimum + 0.3 * (control.maximum - control.minimum) < value < control.maximum
    assert viewer.element(name)["handle"] == pytest.approx(target, abs=1.5)
    assert viewer.skin_shot() != before


def test_pose_equals_the_library(shown):
    viewer, rig, _ = shown
    rng = np.random.default_rng(3)
    chosen = rng.choice(len(rig.controls), size=min(9, len(rig.controls)), replace=False)
    values = np.array([control.default for control in rig.controls])
    for index in chosen:
        control = rig.controls[index]
        values[index] = control.minimum + rng.random() * (control.maximum - control.minimum)
    viewer.set(**{rig.controls[index].name: float(values[index]) for index in chosen})
    points = np.array(viewer.page.evaluate("usdrigui.points()")).reshape(-1, 3)
    expected = deform(rig, values)
    shown_points = np.concatenate([np.full(len(mesh.points), mesh.visible) for mesh in rig.meshes])
    diagonal = float(np.linalg.norm(np.ptp(expected, axis=0)))
    assert np.abs(points - expected)[shown_points].max() <= 3e-5 * diagonal


def test_pulled_skin_follows_within_the_ranges(shown):
    viewer, rig, name = shown
    viewer.option("handles", False)
    start = viewer.page.evaluate(
        """(name) => {
          const { view, session } = usdrigui.app;
          const element = session.elements.list.find((each) => each.name === name);
          return view.camera.projector(view.columns[0])(element.handle).slice(0, 2);
        }""",
        name,
    )
    before = viewer.skin_shot()
    viewer.drag(start, [start[0], start[1] + 6])
    moved = viewer.moved(1e-3)
    assert moved
    for control in rig.controls:
        assert control.minimum <= viewer.values()[control.name] <= control.maximum
    assert viewer.skin_shot() != before
