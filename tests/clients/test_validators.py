"""Faults crafted into blend shapes: found by our own checks and by UsdValidation, and repaired where that is safe."""

import subprocess
import sys

import numpy as np
import pytest
import skel_stages
from pxr import Sdf, Usd, UsdSkel, Vt

from usdrigui.clients import usd_validation as validation
from usdrigui.reader import faults

FACE = "/Char/Face"


def mesh(stage):
    return stage.GetPrimAtPath(FACE)


def shape(stage):
    return UsdSkel.BlendShape(stage.GetPrimAtPath(f"{FACE}/s_smile"))


def names(stage, tokens):
    UsdSkel.BindingAPI(mesh(stage)).GetBlendShapesAttr().Set(tokens)


def missing_target(stage):
    stage.RemovePrim(f"{FACE}/s_smile")


def out_of_range(stage):
    shape(stage).CreatePointIndicesAttr(Vt.IntArray([*range(24), 25]))


def short_offsets(stage):
    shape(stage).GetOffsetsAttr().Set(Vt.Vec3fArray(7))


def not_a_number(stage):
    offsets = np.zeros((25, 3), dtype=np.float32)
    offsets[3, 1] = np.nan
    shape(stage).GetOffsetsAttr().Set(Vt.Vec3fArray.FromNumpy(offsets))


def inbetween(stage, weight, count=25):
    each = shape(stage).CreateInbetween("half")
    if weight is not None:
        each.SetWeight(weight)
    each.SetOffsets(Vt.Vec3fArray(count))


def two_inbetweens(stage):
    inbetween(stage, 0.5)
    other = shape(stage).CreateInbetween("other")
    other.SetWeight(0.5)
    other.SetOffsets(Vt.Vec3fArray(25))


def repeated_name(stage):
    api = UsdSkel.BindingAPI(mesh(stage))
    names(stage, ["smile", "frown", "smile"])
    api.GetBlendShapeTargetsRel().SetTargets([f"{FACE}/s_frown", f"{FACE}/s_smile"])
    api.GetBlendShapeTargetsRel().AddTarget("/Char/Skel")


def weights(stage, values, time=None):
    attribute = UsdSkel.Animation(stage.GetPrimAtPath("/Char/Anim")).GetBlendShapeWeightsAttr()
    attribute.Set(Vt.FloatArray(values), Usd.TimeCode.Default() if time is None else Usd.TimeCode(time))
    return attribute


def beyond_limits(stage):
    limits = {"minimum": Vt.FloatArray([0, 0]), "maximum": Vt.FloatArray([1, 1])}
    weights(stage, [0.0, 1.5], 7.0).SetMetadata("limits", {"hard": limits})


FAULTS = {
    "names and targets of different length": ("TARGETS_LENGTH", lambda stage: names(stage, ["smile"])),
    "missing target": ("TARGET_INVALID", missing_target),
    "index out of range": ("INDEX_RANGE", out_of_range),
    "offsets of wrong length": ("OFFSETS_LENGTH", short_offsets),
    "NaN": ("NOT_FINITE", not_a_number),
    "in-between at 1": ("INBETWEEN_INVALID", lambda stage: inbetween(stage, 1.0)),
    "in-between without weight": ("INBETWEEN_INVALID", lambda stage: inbetween(stage, None)),
    "two in-betweens at one weight": ("INBETWEEN_INVALID", two_inbetweens),
    "in-between of wrong length": ("OFFSETS_LENGTH", lambda stage: inbetween(stage, 0.5, 7)),
    "a name twice": ("TOKEN_REPEATED", repeated_name),
    "token order": ("TOKEN_ORDER", lambda stage: names(stage, ["frown", "smile"])),
    "weights of wrong length": ("ANIMATION_LENGTH", lambda stage: weights(stage, [0.0])),
    "NaN weight": ("NOT_FINITE", lambda stage: weights(stage, [float("nan"), 0.0])),
    "weights beyond limits": ("WEIGHTS_BEYOND_LIMITS", beyond_limits),
}


@pytest.fixture
def stage(tmp_path):
    skel_stages.head(tmp_path / "char.usda")
    stage = Usd.Stage.Open(str(tmp_path / "char.usda"))
    over = Sdf.Layer.CreateAnonymous(".usda")
    stage.GetRootLayer().subLayerPaths.append(over.identifier)
    stage.SetStartTimeCode(0)
    return stage


@pytest.fixture(scope="module")
def validators():
    usd_validation = pytest.importorskip("pxr.UsdValidation", reason="USD before 26.5 takes no Python validators")
    if not hasattr(usd_validation.ValidationRegistry, "RegisterPluginPrimValidator"):
        pytest.skip("USD before 26.5 takes no Python validators")
    validation.register()
    registry = usd_validation.ValidationRegistry()
    kinds = ("BlendShapes", "ShapeWeights", "Layouts")
    found = registry.GetOrLoadValidatorsByName([f"{validation.NAME}:{kind}" for kind in kinds])
    assert len(found) == len(kinds)
    return usd_validation.ValidationContext(found)


@pytest.mark.usefixtures("validators")
def test_validators_can_be_registered_after_others_were_used():
    late = (
        "from pxr import UsdValidation\n"
        "registry = UsdValidation.ValidationRegistry()\n"
        "from usdrigui.clients import usd_validation as validation\n"
        "validation.register(); validation.register()\n"
        "names = [f'{validation.NAME}:{each}' for each in ('BlendShapes', 'ShapeWeights', 'Layouts')]\n"
        "print(*[each.GetMetadata().doc != '' for each in registry.GetOrLoadValidatorsByName(names)])"
    )
    assert subprocess.check_output([sys.executable, "-c", late], text=True).split() == ["True"] * 3


def test_a_sound_asset_is_silent(stage, validators):
    assert faults.stage_faults(stage) == ()
    assert validators.Validate(stage) == []


@pytest.mark.parametrize("name", FAULTS)
def test_a_crafted_fault_is_found(name, stage, validators):
    code, spoil = FAULTS[name]
    spoil(stage)
    assert code in {each.code for each in faults.stage_faults(stage)}
    errors = {error.GetName(): error for error in validators.Validate(stage)}
    assert code in errors
    assert errors[code].GetSites()[0].GetPrim()
    assert len(errors[code].GetMessage()) > 20


def test_stale_layouts_are_found(tmp_path, validators):
    import skinned_stages

    from usdrigui.cli import main

    character = skinned_stages.character(tmp_path / "char.usda")
    assert main(["process", str(character), "--quiet"]) == 0
    stage = Usd.Stage.Open(str(tmp_path / "char.rigui.usda"))
    assert {error.GetName() for error in validators.Validate(stage)} <= {"TOKEN_ORDER"}
    face = stage.GetPrimAtPath("/World/Char/face0")
    counts = face.GetAttribute("faceVertexCounts")
    indices = face.GetAttribute("faceVertexIndices")
    indices.Set(list(indices.Get())[counts.Get()[0] :])
    counts.Set(list(counts.Get())[1:])
    assert "LAYOUT_TOPOLOGY" in {error.GetName() for error in validators.Validate(stage)}
    face.SetActive(False)
    assert "LAYOUT_MESH_GONE" in {error.GetName() for error in validators.Validate(stage)}
