"""An asset's own textures on the page: of a small one made here, and of one given."""

import tempfile
from pathlib import Path

import numpy as np
import pytest
from browser_pages import DRAWN_BY, decoded
from makers import changed
from PIL import Image
from pxr import Sdf, UsdGeom, UsdShade
from skel_stages import head
from viewer_layouts import peak_layout

from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings
from usdrigui.view.web import packing, page

RED, GREEN = (230, 20, 20, 255), (20, 200, 20, 255)


def painted(folder):
    """A sheet with an image that is red on the left, green on the right, and cuts out the lowest quarter."""
    texels = np.zeros((64, 64, 4), dtype=np.uint8)
    texels[:, :32], texels[:, 32:] = RED, GREEN
    texels[48:, :, 3] = 0
    Image.fromarray(texels).save(folder / "skin.png")

    def paint(stage):
        mesh = UsdGeom.Mesh.Get(stage, "/Char/Face")
        mesh.GetPointsAttr().Set([(x, y, 0.0) for x, y, _ in mesh.GetPointsAttr().Get()])
        uv = UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, "vertex")
        # Whole tiles away, where the image is repeated.
        uv.Set([(x / 2 - 2.5, y / 2 + 7.5) for x, y, _ in mesh.GetPointsAttr().Get()])
        material = UsdShade.Material.Define(stage, "/Char/skin")
        surface, texture = (UsdShade.Shader.Define(stage, f"/Char/skin/{name}") for name in ("surface", "texture"))
        surface.CreateIdAttr("UsdPreviewSurface")
        texture.CreateIdAttr("UsdUVTexture")
        texture.CreateInput("file", Sdf.ValueTypeNames.Asset).Set("./skin.png")
        for name, kind, output in (("diffuseColor", "Color3f", "rgb"), ("opacity", "Float", "a")):
            given = surface.CreateInput(name, getattr(Sdf.ValueTypeNames, kind))
            given.ConnectToSource(texture.ConnectableAPI(), output)
        material.CreateSurfaceOutput().ConnectToSource(surface.ConnectableAPI(), "surface")
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)

    (rig,) = read_rigs(Path(head(str(folder / "char.usda"), edit=paint)), Settings())
    return rig, peak_layout(rig)


def characters():
    with tempfile.TemporaryDirectory() as folder:
        return [painted(Path(folder))]


def test_images_take_at_most_half_of_a_page_without_them():
    ((rig, layout),) = characters()
    (mesh,) = rig.body.meshes
    plain = changed(rig, meshes=(changed(mesh, texturing=None),))
    whole, bare = (len(page.page_html([(each, layout)], "sheet")) for each in (rig, plain))
    assert bare < whole <= 1.5 * bare
    noise = np.random.default_rng(0).integers(0, 255, (256, 256, 4), dtype=np.uint8)
    finer, coarser = (sum(map(len, packing.image_files([noise, noise], room))) for room in (1e9, 30_000))
    assert coarser <= 30_000 < finer


@pytest.mark.parametrize("draw", ["canvas", "webgl"])
def test_both_drawers_show_the_texture_and_what_it_cuts_out(opened, page_path, draw):
    viewer = opened(page_path, draw=draw)
    assert viewer.page.evaluate("usdrigui.app.view.stage.drawnBy") == DRAWN_BY[draw]
    viewer.option("handles", False)
    viewer.settle()
    places = [(-0.75, 0.5), (-0.25, 0.5), (0.25, 0.5), (0.75, 0.5), (-0.5, -0.75), (0.5, -0.75)]
    at = viewer.page.evaluate(
        """(places) => {
          const { camera, columns, node } = usdrigui.app.view;
          const { x, y } = node.getBoundingClientRect();
          const on = places.map((place) => camera.projector(columns[0])([...place, 0]));
          return on.map((at) => [Math.round(x + at[0]), Math.round(y + at[1])]);
        }""",
        places,
    )
    pixels = decoded(viewer.page.screenshot())
    found = [pixels[y, x] for x, y in at]
    for colour in found[:2]:
        assert colour[0] > 3 * max(colour[1:])
    for colour in found[2:4]:
        assert colour[1] > 3 * max(colour[0], colour[2])
    for colour in found[4:]:
        assert np.ptp(colour) < 12, "the ground is seen where the image cuts the sheet out"
