"""Layouts that are on a stage already."""

import pytest
from pxr import Usd, UsdGeom

from usdrigui.reader.existing_layouts import existing_prims


@pytest.mark.parametrize(("inside", "outside"), [(True, False), (True, True), (False, True)])
def test_a_drawing_of_which_any_opinion_is_in_a_variant_is_in_one(inside, outside):
    stage = Usd.Stage.CreateInMemory()
    variants = UsdGeom.Xform.Define(stage, "/Char").GetPrim().GetVariantSets().AddVariantSet("rigUI")
    variants.AddVariant("on")
    variants.SetVariantSelection("on")

    def draw():
        scope = stage.DefinePrim("/Char/RigUI", "Scope")
        scope.AddAppliedSchema("RigUILayoutAPI")
        mesh = UsdGeom.Mesh.Define(stage, "/Char/RigUI/drawing")
        mesh.GetPrim().AddAppliedSchema("RigUIDrawingAPI")

    if inside:
        with variants.GetVariantEditContext():
            draw()
    if outside:
        draw()
    (found,) = existing_prims(stage)
    assert found.path == "/Char/RigUI/drawing"
    assert found.in_variant is inside
