"""Faults crafted into blend shapes: found by our own checks and by UsdValidation, and repaired where that is safe."""

import subprocess
import sys

import minimal_assets
import pytest
import skel_stages
import traps
from pxr import Usd

from usdrigui.clients import usd_validation as validation
from usdrigui.reader import faults


def named_twice(folder, _):
    path = minimal_assets.character(folder)
    names = 'skel:blendShapes = ["smile", "%s"]'
    path.write_text(path.read_text().replace(names % "frown", names % "smile"))
    return path


TRAPS = {
    "TARGETS_LENGTH": "more names than targets",
    "TARGET_INVALID": "a target that is not there",
    "INDEX_RANGE": "an index too high",
    "OFFSETS_LENGTH": "too few offsets",
    "NOT_FINITE": "NaN in an offset",
    "INBETWEEN_INVALID": "two in-betweens at one weight",
}
EDITS = ("NOT_FINITE", "ANIMATION_LENGTH", "WEIGHTS_BEYOND_LIMITS", "INBETWEEN_INVALID")
FAULTS = [(code, traps.trapped, name) for code, name in TRAPS.items()]
FAULTS += [("TOKEN_REPEATED", named_twice, "")]
FAULTS += [(code, minimal_assets.character, code) for code in EDITS]
"""A code, and how a character that calls for it is made."""


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


def test_a_sound_asset_is_silent(tmp_path, validators):
    stage = Usd.Stage.Open(str(skel_stages.head(tmp_path / "char.usda")))
    assert faults.stage_faults(stage) == ()
    assert validators.Validate(stage) == []


@pytest.mark.parametrize(("code", "make", "name"), FAULTS)
def test_a_crafted_fault_is_found(tmp_path, code, make, name, validators):
    stage = Usd.Stage.Open(str(make(tmp_path, name)))
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
    assert validators.Validate(stage) == []
    face = stage.GetPrimAtPath("/World/Char/face0")
    counts = face.GetAttribute("faceVertexCounts")
    indices = face.GetAttribute("faceVertexIndices")
    indices.Set(list(indices.Get())[counts.Get()[0] :])
    counts.Set(list(counts.Get())[1:])
    assert "LAYOUT_TOPOLOGY" in {error.GetName() for error in validators.Validate(stage)}
    face.SetActive(False)
    assert "LAYOUT_MESH_GONE" in {error.GetName() for error in validators.Validate(stage)}
