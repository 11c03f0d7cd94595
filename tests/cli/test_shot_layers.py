"""`process SHOT --base LAYER`: what a shot adds gets a layer of its own, and the asset's layout stays."""

import numpy as np
import pytest
import shot_stages
from commands import elements, run
from pxr import Sdf, Usd, UsdGeom, UsdSkel, Vt

from usdrigui.cli import main
from usdrigui.layer.read_layout import element_prims, layout_scopes, points_by_role, read_layout
from usdrigui.pipeline import laying_out

SHAPES = {
    "browCrease": ((0.0, 0.55), (0, 0.3, 1), 0.25, 0.12),
    "cheekFix_L": ((0.45, -0.1), (0.3, 0, 1), 0.5, 0.12),
    "cheekFix_R": ((-0.45, -0.1), (-0.3, 0, 1), 0.5, 0.12),
}
FACE = "/World/Char/face0"


@pytest.fixture(scope="module")
def made(laid_out):
    """The folder of the asset with its layout, a shot over it, and the shot's layer."""
    shot_stages.shot(laid_out / "shot.usda", "./char.usda", FACE, SHAPES)
    assert main(["process", str(laid_out / "shot.usda"), "--base", str(laid_out / "char.rigui.usda"), "-q"]) == 0
    return laid_out


def handles(stage):
    """Anchor point, mesh and points of every handle on the face."""
    prims = [prim for scope in layout_scopes(stage) for prim in element_prims(scope)]
    return [
        (prim.GetAttribute("rigUI:anchor:pointIndex").Get(), prim.GetParent().GetPath(), points_by_role(prim, "handle"))
        for prim in prims
        if prim.GetRelationship("rigUI:anchor:prim").GetTargets()
    ]


def points(stage, path, time):
    return np.array(UsdGeom.PointBased(stage.GetPrimAtPath(path)).GetPointsAttr().Get(time), dtype=np.float64)


def as_text(layer):
    return Usd.Stage.Open(str(layer)).Flatten().ExportToString()


def test_the_base_is_kept_to_the_point_and_only_new_controls_are_placed(made):
    base, both = elements(made / "char.rigui.usda"), elements(made / "shot.rigui.usda")
    assert set(both) - set(base) == set(SHAPES)
    for name, element in base.items():
        assert (both[name].anchor.mesh, both[name].anchor.point) == (element.anchor.mesh, element.anchor.point)
        np.testing.assert_array_equal(both[name].anchor.position, element.anchor.position)


def test_the_layer_defines_the_new_elements_only(made):
    layer = Sdf.Layer.FindOrOpen(str(made / "shot.rigui.usda"))
    scope = layer.GetPrimAtPath("/World/Char{rigUI=ui}RigUI")
    assert scope.specifier == Sdf.SpecifierOver
    (mesh,) = (child for child in scope.nameChildren if child.specifier == Sdf.SpecifierDef)
    assert {child.name for child in mesh.nameChildren if child.typeName == "GeomSubset"} == set(SHAPES)


def test_removed_the_assets_layout_is_bit_for_bit_as_before(folder):
    before, told = (folder / "char.rigui.usda").read_bytes(), as_text(folder / "char.rigui.usda")
    for path in ("shot.rigui.usda", "shot.usda"):
        (folder / path).unlink()
    assert (folder / "char.rigui.usda").read_bytes() == before
    assert as_text(folder / "char.rigui.usda") == told


def test_a_run_with_a_base_does_not_touch_it(folder, capsys):
    before = (folder / "char.rigui.usda").read_bytes()
    run(capsys, "process", folder / "shot.usda", "--base", folder / "char.rigui.usda", "-o", folder / "again.usda")
    assert (folder / "char.rigui.usda").read_bytes() == before
    assert (folder / "again.usda").read_bytes() == (folder / "shot.rigui.usda").read_bytes()


def wrong(checked):
    """What `check` finds, but for the pucker: it moves straight at the viewer, and its track is a point."""
    return [each for each in checked["issues"] if each["code"] != "LAYOUT_UNCLEAR"]


def test_check_finds_nothing_wrong_with_the_composed_layout(made, capsys):
    found = run(capsys, "check", made / "shot.rigui.usda", "--strict")
    assert wrong(found) == []
    assert set(SHAPES) < {each["element"] for each in found["characters"][0]["elements"]}


def test_the_report_tells_what_stands_and_the_new_ones_are_proven(made, capsys):
    told = run(capsys, "process", made / "shot.usda", "--base", made / "char.rigui.usda", "--dry-run")
    character = told["characters"][0]
    assert {each["name"] for each in character["elements"] if not each["existing"]} == set(SHAPES)
    assert character["solution"]["status"] == "optimal"
    main(["process", str(made / "shot.usda"), "--base", str(made / "char.rigui.usda"), "--dry-run"])
    printed = capsys.readouterr().out
    assert "which are in another layer" in printed
    assert "browCrease" in printed
    assert "smile_L" not in printed


def test_a_new_handle_gives_way_to_one_that_stands(folder, capsys):
    """A corrective whose best place is taken goes elsewhere, a handle's width away at least."""
    best = elements(folder / "char.rigui.usda")["smile_L"].anchor
    x, y, _ = best.position
    shot_stages.shot(folder / "fix.usda", "./char.usda", FACE, {"smileFix": ((x, y), (0.2, 0.5, 1), 0.35, 0.15)})
    run(capsys, "process", folder / "fix.usda", "--base", folder / "char.rigui.usda")
    both = elements(folder / "fix.rigui.usda")
    (layout,) = read_layout(folder / "fix.rigui.usda")
    assert not both["smileFix"].anchor.on_board
    apart = np.linalg.norm(both["smileFix"].anchor.position - both["smile_L"].anchor.position)
    assert apart >= layout.frame.handle_width * 0.999
    assert wrong(run(capsys, "check", folder / "fix.rigui.usda", "--strict")) == []


def test_existing_handles_follow_the_new_shapes_in_any_application(made):
    """Baked by UsdSkel with a corrective on, every handle goes where its anchor goes."""
    layer = Sdf.Layer.CreateAnonymous(".usda")
    layer.subLayerPaths.append(str(made / "shot.rigui.usda"))
    stage = Usd.Stage.Open(layer)
    animation = UsdSkel.Animation(stage.GetPrimAtPath("/World/Char/Anim"))
    tokens = list(animation.GetBlendShapesAttr().Get())
    for attribute in (animation.GetTranslationsAttr(), animation.GetRotationsAttr(), animation.GetScalesAttr()):
        attribute.Set(attribute.Get(1.0), 0.0)
    for time, weight in enumerate((0.0, 1.0)):
        values = [weight if token in SHAPES else 0.0 for token in tokens]
        animation.GetBlendShapeWeightsAttr().Set(Vt.FloatArray(values), float(time))
    placed = handles(stage)
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath("/World/Char")))
    face = [points(stage, FACE, time) for time in (0.0, 1.0)]
    moved = 0
    for point, path, drawn in placed:
        handle = [points(stage, path, time)[drawn[0]] for time in (0.0, 1.0)]
        way = face[1][point] - face[0][point]
        np.testing.assert_allclose(handle[1] - handle[0], way, atol=2e-6)
        moved += np.linalg.norm(way) > 1e-3
    assert moved > len(SHAPES), "correctives move anchors of existing elements too"


# --- shots that reference the asset ------------------------------------------------------------------


@pytest.mark.parametrize("brought", ["char.rigui.usda", "char.usda"])
def test_a_shot_may_have_the_character_at_another_path(folder, capsys, brought):
    """Either the shot references the layout itself, or its layer references a bare one."""
    base = "char.rigui.usda"
    if brought == "char.usda":
        base = "bare.rigui.usda"
        run(capsys, "process", folder / "char.usda", "--bare", "-o", folder / base)
    shot_stages.shot(folder / "two.usda", f"./{brought}", "/Shot/hero/Char/face0", SHAPES, at="/Shot/hero")
    run(capsys, "process", folder / "two.usda", "--base", folder / base)
    both, alone = elements(folder / "two.rigui.usda"), elements(folder / "char.rigui.usda")
    assert set(both) == set(alone) | set(SHAPES)
    assert all(both[name].anchor.point == each.anchor.point for name, each in alone.items())
    assert all(each.anchor.mesh.startswith("/Shot/hero/") for each in both.values())
    assert wrong(run(capsys, "check", folder / "two.rigui.usda", "--strict")) == []


def test_a_bare_layer_is_composed_by_the_shot(folder, capsys):
    bare = folder / "shot.bare.usda"
    run(capsys, "process", folder / "shot.usda", "--base", folder / "char.rigui.usda", "--bare", "-o", bare)
    assert not Sdf.Layer.FindOrOpen(str(bare)).subLayerPaths
    top = Sdf.Layer.CreateNew(str(folder / "top.usda"))
    top.subLayerPaths[:] = ["./shot.bare.usda", "./shot.usda", "./char.rigui.usda"]
    top.Save()
    assert set(elements(folder / "top.usda")) == set(elements(folder / "shot.rigui.usda"))


# --- refusals ----------------------------------------------------------------------------------------


def test_nothing_new_is_reported_and_adds_nothing(folder, capsys):
    out = folder / "none.rigui.usda"
    told = run(capsys, "process", folder / "char.usda", "--base", folder / "char.rigui.usda", "-o", out)
    assert [each["code"] for each in told["issues"]] == ["BASE_COMPLETE"]
    assert not Sdf.Layer.FindOrOpen(str(out)).rootPrims
    assert elements(out).keys() == elements(folder / "char.rigui.usda").keys()


def test_one_character_of_a_shot_that_still_fits_can_be_laid_out_alone(folder, capsys):
    """Another reference to the same layout has another topology; the refusal tells the way past it."""
    stage = Usd.Stage.CreateNew(str(folder / "two.usda"))
    for name in ("/Hero", "/Twin"):
        stage.DefinePrim(name).GetReferences().AddReference("./char.rigui.usda", "/World")
    face = UsdGeom.Mesh(stage.GetPrimAtPath("/Twin/Char/face0"))
    indices = list(face.GetFaceVertexIndicesAttr().Get())
    face.GetFaceVertexIndicesAttr().Set([*indices[4:], *indices[:4]])
    stage.GetRootLayer().Save()
    arguments = ("process", folder / "two.usda", "--base", folder / "char.rigui.usda", "--dry-run")
    (found,) = run(capsys, *arguments, expected=1)["issues"]
    assert found["code"] == "LAYOUT_TOPOLOGY"
    assert "/Twin/" in found["message"]
    assert "`--set read.skel_root=PATH`" in found["repair"]
    run(capsys, *arguments, "--set", "read.skel_root=/Hero/Char")


def test_a_base_that_the_shot_does_not_show_is_refused(folder, capsys, monkeypatch):
    shot_stages.shot(folder / "none.usda", "./char.rigui.usda", FACE, SHAPES)
    stage = Usd.Stage.Open(str(folder / "none.usda"))
    arguments = ("process", folder / "none.usda", "--base", folder / "char.rigui.usda", "-o", folder / "o.usda")
    run(capsys, *arguments)
    (folder / "o.usda").unlink()
    stage.GetPrimAtPath("/World/Char").GetVariantSet("rigUI").SetVariantSelection("none")
    stage.Save()
    monkeypatch.setattr(laying_out, "_laid_out", None)  # told before the long work
    (found,) = run(capsys, *arguments, expected=1)["issues"]
    assert (found["code"], found["path"]) == ("BASE_APART", "/World/Char")
    assert not (folder / "o.usda").exists()


@pytest.mark.parametrize("option", ["--fixed", "--previous", "--like"])
def test_a_base_goes_with_no_other_layout(folder, capsys, option):
    layer = folder / "char.rigui.usda"
    told = run(capsys, "process", folder / "shot.usda", "--base", layer, option, layer, expected=2)
    assert (told["issues"][0]["code"], told["issues"][0]["path"]) == ("CONFIG_VALUE", "--base")
