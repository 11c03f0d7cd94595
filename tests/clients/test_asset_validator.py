"""Our rules in NVIDIA's asset validator: the real engine and its real fixer on crafted faults."""

from importlib.metadata import entry_points

import pytest
import skel_stages
from programs import ran
from pxr import Usd, UsdSkel, Vt

validator = pytest.importorskip("omni.asset_validator", reason="usd-validation-nvidia is not installed")

from usdrigui.clients import asset_validator  # noqa: E402

RULES = (asset_validator.BlendShapeChecker, asset_validator.RigUILayoutChecker)


def issues(stage):
    engine = validator.ValidationEngine(init_rules=False)
    for rule in RULES:
        engine.enable_rule(rule)
    return list(engine.validate(stage).issues())


@pytest.fixture
def stage(tmp_path):
    return Usd.Stage.Open(str(skel_stages.head(tmp_path / "char.usda")))


def test_rules_are_registered(stage):
    registered = validator.CategoryRuleRegistry()
    assert all(registered.get_category(rule) == asset_validator.CATEGORY for rule in RULES)
    assert issues(stage) == []


def test_the_validator_finds_the_rules_by_what_is_installed():
    (named,) = (each for each in entry_points(group="usd_validation_nvidia") if each.name == "usdrigui")
    script = "import omni.asset_validator as v; v.ValidationEngine(); print(v.CategoryRuleRegistry().categories)"
    done = ran("-c", script)
    assert named.value == "usdrigui.clients.asset_validator:Rules"
    assert asset_validator.CATEGORY in done.stdout


def test_a_fault_that_cannot_be_repaired_is_reported(stage):
    shape = UsdSkel.BlendShape(stage.GetPrimAtPath("/Char/Face/s_smile"))
    shape.GetOffsetsAttr().Set(Vt.Vec3fArray(3))
    (found,) = issues(stage)
    assert "OFFSETS_LENGTH" in found.message
    assert not found.suggestions


def test_a_dangling_target_is_reported(stage):
    stage.RemovePrim("/Char/Face/s_smile")
    (found,) = issues(stage)
    assert "TARGET_INVALID" in found.message
