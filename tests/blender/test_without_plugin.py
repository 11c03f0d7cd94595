"""Our layers in programs that know nothing of us: Blender's importer, Hydra Storm, the USD inside bpy."""

import blender_characters as characters
import numpy as np
import usd_versions
from PIL import Image
from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.layer.read_layout import element_prims, points_by_role, read_layout

CLOSE = 1e-5
FRAMES = [1, 9, 24, 37, 48]

EXPOSED = """
import sys
import bpy
bpy.utils.expose_bundled_modules()
"""


def test_imported_handles_stay_on_the_face_through_the_animation(run_inside, usd_python, tmp_path):
    layer, rig, source = characters.sample(tmp_path)
    expected = anchors(layer, rig)
    where = {
        element.name.replace(":", "_"): (element.anchor.mesh.rpartition("/")[2], element.anchor.point)
        for element in shown_at_first(layer)
        if not element.anchor.on_board
    }
    drawn = handles(layer, rig, where)
    found = run_inside([usd_python], "plain_import", layer=str(layer), frames=FRAMES, anchors=where, handles=drawn)
    place = characters.to_world(source, rig)
    close = CLOSE * characters.diagonal([place(mesh.points) for mesh in rig.body.meshes])
    assert found["frames"].tolist() == [1, 48]
    travelled, exact = 0.0, 0
    for name, points in expected.items():
        handle = np.array([found[f"{name}_{frame}"] for frame in FRAMES])
        skin = np.array([found[f"anchor_{name}_{frame}"] for frame in FRAMES])
        assert np.abs(handle - skin).max() < close, name
        # Blender leaves in-betweens out: where the skin itself is where UsdSkel has it, so is the handle.
        right = np.abs(skin - place(points)).max(axis=1) < close
        assert np.abs(handle - place(points))[right].max() < close, name
        exact += int(right.sum())
        travelled = max(travelled, float(np.ptp(handle, axis=0).max()))
    assert exact >= 0.7 * len(expected) * len(FRAMES)
    assert travelled > 1000 * close


def shown_at_first(layer):
    """The elements that are not invisible members of a coarse one: importers pass over those."""
    elements = read_layout(layer)[0].elements
    inner = {name for element in elements for name in element.inner}
    assert inner
    return [element for element in elements if element.name not in inner]


def handles(layer, rig, names):
    """By prim name, the mesh that draws a handle, and its points."""
    stage = Usd.Stage.Open(str(layer))
    prims = element_prims(stage.GetPrimAtPath(rig.path).GetChild("RigUI"))
    return {
        prim.GetName(): (prim.GetParent().GetName(), points_by_role(prim, "handle").tolist())
        for prim in prims
        if prim.GetName() in names
    }


def anchors(layer, rig):
    """By prim name, the deformed anchors (FRAMES, 3) of the elements on the face in root space, by UsdSkel."""
    stage = Usd.Stage.Open(str(layer))
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath(rig.path)))
    found = {}
    for element in shown_at_first(layer):
        if not element.anchor.on_board:
            points = stage.GetPrimAtPath(element.anchor.mesh).GetAttribute("points")
            found[element.name.replace(":", "_")] = root_points(stage, rig, element, points)
    return found


def root_points(stage, rig, element, points):
    root, mesh = map(stage.GetPrimAtPath, (rig.path, element.anchor.mesh))
    at = []
    for frame in FRAMES:
        cache = UsdGeom.XformCache(frame)
        to_root = cache.GetLocalToWorldTransform(mesh) * cache.GetLocalToWorldTransform(root).GetInverse()
        at.append(to_root.Transform(points.Get(frame)[element.anchor.point]))
    return np.array(at)


def test_storm_draws_guides_on_demand_and_they_move(run_inside, usd_python, tmp_path):
    layer, _, _ = characters.sample(tmp_path)
    run_inside([usd_python], "storm", {"MESA_NO_ERROR": "1"}, layer=str(layer), eye=[0.0, -1.0, 60.0], frames=[1, 24])
    shown = {
        name: np.asarray(Image.open(tmp_path / f"{name}.png").convert("RGB")).astype(int)
        for name in ("plain1", "guides1", "plain24", "guides24")
    }
    coloured = {name: np.ptp(picture, axis=2) > 60 for name, picture in shown.items()}
    assert np.abs(shown["plain1"] - shown["plain24"]).max() > 60, "the character moves"
    for frame in (1, 24):
        only_guides = coloured[f"guides{frame}"] & ~coloured[f"plain{frame}"]
        assert only_guides.sum() > 50
    assert (coloured["guides1"] != coloured["guides24"]).sum() > 100, "the guides move with it"


def test_the_usd_inside_bpy_reads_our_layers_with_and_without_the_schema(usd_python, tmp_path, monkeypatch):
    samples = usd_versions.write_samples(tmp_path)
    monkeypatch.setattr(usd_versions, "READER", EXPOSED + usd_versions.READER)
    for name, (root, expected) in samples.items():
        for plugin in (False, True):
            said = usd_versions.complaint(usd_python, tmp_path / name, root, expected, plugin)
            assert said == "", (name, plugin)
