"""What an animator changes in the viewer goes back into the pipeline: a moved element, and a saved pose."""

import numpy as np
import pytest
import skinned_stages
from laid_out import extent
from pxr import Sdf, Usd, UsdSkel

from usdrigui import pipeline
from usdrigui.cli import main
from usdrigui.settings import Settings


@pytest.fixture(scope="module")
def asset(tmp_path_factory):
    """A character laid out, and its page."""
    folder = tmp_path_factory.mktemp("asset")
    source = skinned_stages.character(folder / "char.usda")
    layer, page = folder / "char.rigui.usda", folder / "char.html"
    assert main(["process", str(source), "-o", str(layer), "--quiet"]) == 0
    assert main(["view", str(layer), "--html", str(page), "--quiet"]) == 0
    return source, layer, page


@pytest.fixture
def viewer(opened, asset):
    return opened(asset[2])


def layout_of(layer):
    [(rig, layout)] = pipeline.load_layer(layer, Settings()).characters
    return rig, {element.name: element for element in layout.elements}


def reachable(viewer):
    """(element, pixel to drop it on) where its one control moves another point by half of its longest path."""
    for element in viewer.page.evaluate("usdrigui.elements()"):
        found = viewer.page.evaluate(
            """(name) => {
              const { view, session } = usdrigui.app;
              const element = session.elements.list.find((each) => each.name === name);
              if (element.onBoard || element.members.length > 1) return null;
              const heat = session.influence.ofControl(element.members[0].control);
              const project = view.camera.projector(view.controlsColumn);
              const from = project(element.handle);
              const { points } = session.deformer;
              for (let i = 0; i < heat.length; i++) {
                const [x, y] = project(points.subarray(3 * i, 3 * i + 3));
                const off = Math.hypot(x - from[0], y - from[1]);
                if (heat[i] < 128 || off < 25) continue;
                const hit = view.pick({ x, y, column: view.controlsColumn });
                if (hit?.nearest === i) return [[x, y], i];
              }
              return null;
            }""",
            element["name"],
        )
        if found is not None:
            return element, found
    raise AssertionError("no element has room")


def laid_out_again(viewer, source, folder, control):
    """The element of a control where the corrections of the page are kept."""
    said = viewer.saved("Save corrections", folder / "corrections.usda")
    again = folder / "again.rigui.usda"
    assert main(["process", str(source), "--corrections", str(said), "-o", str(again), "--quiet"]) == 0
    _, after = layout_of(again)
    [kept] = [each for each in after.values() if control in [one.control for one in each.members]]
    return kept


def test_an_element_moved_in_the_browser_stays_there_when_laid_out_again(viewer, asset, tmp_path):
    source, layer, _ = asset
    rig, before = layout_of(layer)
    viewer.option("occlusion", "overlay")
    element, (target, point) = reachable(viewer)
    viewer.page.get_by_role("button", name="Rearrange").first.click()
    viewer.drag(element["handle"], target)
    kept = laid_out_again(viewer, source, tmp_path, element["controls"][0])
    starts = {mesh.path: start for mesh, start in zip(rig.body.meshes, rig.body.starts, strict=False)}
    assert starts[kept.anchor.mesh] + kept.anchor.point == point
    old = before[element["name"]].anchor
    assert (old.mesh, old.point) != (kept.anchor.mesh, kept.anchor.point)


def test_an_element_cannot_be_dropped_where_its_control_moves_nothing(viewer):
    element = viewer.element("blink_L")
    far = viewer.page.evaluate(
        """() => {
          const { view, session } = usdrigui.app;
          const control = session.controls.findIndex(({ name }) => name === 'blink_L');
          const heat = session.influence.ofControl(control);
          const project = view.camera.projector(view.controlsColumn);
          const { points } = session.deformer;
          for (let i = 0; i < heat.length; i++) {
            const [x, y] = project(points.subarray(3 * i, 3 * i + 3));
            const hit = view.pick({ x, y, column: view.controlsColumn });
            const { width, height } = view.controlsColumn;
            if (x > 0 && y > 0 && x < width && y < height && heat[i] === 0 && hit?.nearest === i) return [x, y];
          }
          return null;
        }"""
    )
    viewer.option("occlusion", "overlay")
    viewer.option("rearrange", True)
    viewer.drag(element["handle"], far)
    assert "does not move this point" in viewer.page.locator(".notice").inner_text()
    assert viewer.element("blink_L")["handle"] == pytest.approx(element["handle"])
    assert viewer.page.get_by_role("button", name="Save corrections").is_disabled()


def test_an_element_moved_off_the_face_stays_beside_it(viewer, asset, tmp_path):
    source, layer, _ = asset
    _, before = layout_of(layer)
    element = next(
        each for each in viewer.page.evaluate("usdrigui.elements()") if not before[each["name"]].anchor.on_board
    )
    viewer.option("rearrange", True)
    viewer.drag(element["handle"], [25, 60])
    rows = "[...usdrigui.app.view.overlay.dock.cells.keys()].map(({ name, heading }) => [name, heading])"
    assert [element["name"], "By request"] in viewer.page.evaluate(rows)
    kept = laid_out_again(viewer, source, tmp_path, element["controls"][0])
    assert kept.anchor.on_board
    assert kept.category == "requested"


def test_a_saved_layer_moves_the_character_in_usd(viewer, asset, tmp_path):
    """Two keyed frames over the asset: UsdSkel's points are those that the page shows."""
    source, _, _ = asset
    shown = {}
    for frame, share in ((1, 0.3), (9, 0.8)):
        viewer.page.evaluate("(frame) => usdrigui.app.timeline.go(frame)", frame)
        # One that is covered is reached by the keyboard.
        name = viewer.page.evaluate("usdrigui.elements()")[0]["name"]
        viewer.page.locator(f".stops [data-element='{name}']").focus()
        viewer.key("Home")
        for _ in range(round(50 * share)):
            viewer.key("ArrowRight")
        viewer.key("k")
        viewer.settle()
        shown[frame] = viewer.points()
    path = viewer.saved("Save animation layer", tmp_path / "animation.usda")
    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.subLayerPaths = [str(path), str(source)]
    stage = Usd.Stage.Open(layer)
    stage.SetInterpolationType(Usd.InterpolationTypeLinear)
    root = UsdSkel.Root(stage.GetPrimAtPath("/World/Char"))
    cache = UsdSkel.Cache()
    cache.Populate(root, Usd.PrimDefaultPredicate)
    assert np.abs(shown[1] - shown[9]).max() > 1e-2
    assert UsdSkel.BakeSkinning(root)
    mesh = stage.GetPrimAtPath("/World/Char/face0")
    for frame, expected in shown.items():
        points = np.array(mesh.GetAttribute("points").Get(frame))
        diagonal = extent(expected)
        # A SkelAnimation's scales have 11 bits.
        assert np.abs(points - expected[: len(points)]).max() < 3e-4 * diagonal
