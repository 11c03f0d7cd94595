"""A layout behind every composition arc: it is read where it is composed, and its handles are on the moving skin."""

import laid_out
import numpy as np
import pytest
import skinned_stages
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, UsdUtils
from usdskel_oracle import deformed_points

from usdrigui.layer.read_layout import element_prims, layout_scopes, points_by_role, read_layout
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

CLOSE = 1e-5
"""Of the diagonal of the character's box."""
POSES = 3


@pytest.fixture(scope="module")
def posed(tmp_path_factory):
    """A layer with animation over a laid-out character."""
    folder = tmp_path_factory.mktemp("char")
    source = skinned_stages.character(folder / "char.usda", moved=True, animated_joints=("Hips/Head", "Hips/Head/Jaw"))
    (rig,) = read_rigs(source, Settings())
    target = folder / "char.rigui.usda"
    laid_out.written(source, rig, laid_out.layout_of(rig))
    rng = np.random.default_rng(3)
    poses = [laid_out.random_values(rig, rng) for _ in range(POSES)]
    top = laid_out.keyed(str(target), rig, poses).GetRootLayer()
    top.subLayerPaths[0] = "./char.rigui.usda"
    top.Export(str(folder / "posed.usda"))
    return folder / "posed.usda"


def on(stage, path, how, asset, prim="/World"):
    """Bring the asset in at a path, by a reference or payload."""
    placed = stage.DefinePrim(path)
    arc = placed.GetReferences().AddReference if how == "reference" else placed.GetPayloads().AddPayload
    arc(str(asset), prim)
    return placed


def reference(stage, asset):
    on(stage, "/Shot/hero", "reference", asset)


def moved_reference(stage, asset):
    placed = UsdGeom.Xform.Define(stage, "/Shot/hero")
    on(stage, "/Shot/hero", "reference", asset)
    turned = Gf.Matrix4d().SetRotate(Gf.Rotation((1, 2, 3), 50))
    placed.AddTransformOp().Set(turned * Gf.Matrix4d().SetTranslate((5, 6, 7)))


def two_references(stage, asset):
    on(stage, "/Shot/hero", "reference", asset)
    on(stage, "/Shot/twin", "reference", asset)


def payload(stage, asset):
    on(stage, "/Shot/hero", "payload", asset)


def variant(stage, asset):
    prim = stage.DefinePrim("/Shot/hero")
    choices = prim.GetVariantSets().AddVariantSet("lod")
    choices.AddVariant("high")
    choices.SetVariantSelection("high")
    with choices.GetVariantEditContext():
        prim.GetReferences().AddReference(str(asset), "/World")


def instanceable(stage, asset):
    on(stage, "/Shot/hero", "reference", asset).SetInstanceable(True)


def flattened(stage, asset):
    stage.GetRootLayer().TransferContent(Usd.Stage.Open(str(asset)).Flatten())


def layer_stack_flattened(stage, asset):
    stage.GetRootLayer().TransferContent(UsdUtils.FlattenLayerStack(Usd.Stage.Open(str(asset))))


def session_override(stage, asset):
    stage.GetRootLayer().subLayerPaths.append(str(asset))
    scope = next(layout_scopes(stage))
    stage.SetEditTarget(stage.GetSessionLayer())
    for mesh in scope.GetChildren():
        UsdGeom.Imageable(mesh).MakeInvisible()
    element_prims(scope)[0].SetDisplayName("overridden")


def usdz(stage, asset):
    package = asset.parent / "char.usdz"
    assert UsdUtils.CreateNewUsdzPackage(str(asset), str(package))
    stage.GetRootLayer().subLayerPaths.append(str(package))


def value_clips(stage, asset):
    """The animation comes from a clip over the layer without it."""
    on(stage, "/Shot/hero", "reference", asset.parent / "char.rigui.usda")
    found = next(prim for prim in stage.Traverse() if prim.IsA(UsdSkel.Animation))
    inside = str(found.GetPath()).replace("/Shot/hero", "/World")
    for name in ("blendShapeWeights", "rotations", "translations", "scales"):
        found.GetAttribute(name).Block()
        found.RemoveProperty(name)
    manifest = Usd.ClipsAPI.GenerateClipManifestFromLayers([Sdf.Layer.FindOrOpen(str(asset))], inside)
    manifest.Export(str(asset.parent / "manifest.usda"))
    clips = Usd.ClipsAPI(found)
    clips.SetClipAssetPaths([str(asset)])
    clips.SetClipPrimPath(inside)
    clips.SetClipActive([(0.0, 0.0)])
    clips.SetClipTimes([(float(time), float(time)) for time in range(POSES)])
    clips.SetClipManifestAssetPath(str(asset.parent / "manifest.usda"))


ARCS = (
    reference, moved_reference, two_references, payload, variant, instanceable, flattened, layer_stack_flattened,
    session_override, usdz, value_clips,
)  # fmt: skip


@pytest.mark.parametrize("arc", ARCS, ids=lambda arc: arc.__name__)
def test_handles_are_on_the_skin_behind_the_arc(posed, tmp_path, arc):
    stage = Usd.Stage.CreateNew(str(tmp_path / "shot.usda"))
    arc(stage, posed)
    layouts = read_layout(stage)
    assert len(layouts) == (2 if arc is two_references else 1)
    for layout, scope in zip(layouts, layout_scopes(stage), strict=True):
        travelled = 0.0
        skin = {element.anchor.mesh: [] for element in layout.elements}
        for path in skin:
            skin[path] = [deformed_points(stage, layout.root, path, time) for time in range(POSES)]
        size = laid_out.extent(np.concatenate([skin[path][0] for path in skin]))
        drawn = {}
        for element, prim in zip(layout.elements, element_prims(scope), strict=True):
            mesh, points = str(prim.GetParent().GetPath()), points_by_role(prim, "handle")
            for time in range(POSES):
                if (mesh, time) not in drawn:
                    drawn[mesh, time] = deformed_points(stage, layout.root, mesh, time)
                first, anchor = (skin[element.anchor.mesh][at][element.anchor.point] for at in (0, time))
                assert np.abs(drawn[mesh, time][points[0]] - anchor).max() < CLOSE * size, element.name
                travelled = max(travelled, float(np.linalg.norm(anchor - first)))
        assert travelled > 0.01 * size


def test_a_shot_that_selects_none_composes_nothing_of_the_layout(posed, tmp_path):
    stage = Usd.Stage.CreateNew(str(tmp_path / "shot.usda"))
    hero = on(stage, "/Shot/hero", "reference", posed)
    (scope,) = layout_scopes(stage)
    root = scope.GetParent()
    assert root.GetVariantSet("rigUI").GetVariantNames() == ["none", "ui"]
    root.GetVariantSet("rigUI").SetVariantSelection("none")
    assert not list(layout_scopes(stage))
    assert not hero.GetStage().GetPrimAtPath(root.GetPath().AppendChild("RigUI"))
    plain = Usd.Stage.CreateNew(str(tmp_path / "plain.usda"))
    on(plain, "/Shot/hero", "reference", posed.parent / "char.usda")
    assert [prim.GetPath() for prim in stage.TraverseAll()] == [prim.GetPath() for prim in plain.TraverseAll()]
