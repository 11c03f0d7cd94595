"""A real Pyblish publish, headless.  Its command exits 0 on errors, so the results themselves are looked at."""

import re
import sys
import types

import pytest
from pxr import Sdf, Usd

from usdrigui.cli import main

pyblish_api = pytest.importorskip("pyblish.api", reason="pyblish-base is not installed")
import ayon_plugins  # noqa: E402
import pyblish.util  # noqa: E402

from usdrigui.clients import publish  # noqa: E402


@pytest.fixture
def asset(folder):
    """A character with its layout, and Pyblish with nothing but our plug-ins."""
    pyblish_api.deregister_all_paths()
    pyblish_api.deregister_all_plugins()
    pyblish_api.register_host("shell")
    publish.register()
    yield folder / "char.usda"
    pyblish_api.deregister_all_paths()


def published(*assets, staging=None):
    context = pyblish_api.Context()
    context.data["rigUIAssets"] = [*map(str, assets)]
    if staging is not None:
        instance = context.create_instance("char")
        instance.data.update(family="rig", usdFile=str(assets[0]), stagingDir=str(staging), folderPath="/assets/World")
        context.data["rigUIAssets"] = []
    return pyblish.util.publish(context)


def errors(context):
    return {result["plugin"].__name__: result["error"] for result in context.data["results"] if result["error"]}


def layouts(context):
    return [instance for instance in context if instance.data.get("family") == "rigui"]


def spoil(asset):
    """Another topology than that which was laid out."""
    stage = Usd.Stage.Open(str(asset))
    mesh = next(prim for prim in stage.Traverse() if prim.GetTypeName() == "Mesh")
    counts, indices = (mesh.GetAttribute(f"faceVertex{name}") for name in ("Counts", "Indices"))
    first = counts.Get()[0]
    indices.Set(list(indices.Get())[first:])
    counts.Set(list(counts.Get())[1:])
    stage.GetRootLayer().Save()


def test_a_good_layout_is_published_as_a_bare_representation(asset, tmp_path):
    before = asset.read_bytes()
    context = published(asset, staging=tmp_path / "staging")
    assert errors(context) == {}
    (instance,) = layouts(context)
    (representation,) = instance.data["representations"]
    assert (representation["name"], representation["ext"]) == ("usd", "usd")
    staged = tmp_path / "staging" / representation["files"]
    assert list(Sdf.Layer.OpenAsAnonymous(str(staged)).subLayerPaths) == []
    over = Sdf.Layer.CreateAnonymous(".usda")
    over.subLayerPaths = [str(staged), str(asset)]
    assert Usd.Stage.Open(over).GetPrimAtPath("/World/Char/RigUI").GetChildren()
    assert asset.read_bytes() == before


def test_the_staged_layer_is_what_process_writes_bare(asset, tmp_path):
    published(asset, staging=tmp_path / "staging")
    assert main(["process", str(asset), "--bare", "--quiet", "-o", str(tmp_path / "bare.usd")]) == 0
    staged, bare = (Sdf.Layer.FindOrOpen(str(tmp_path / each)) for each in ("staging/char.rigui.usd", "bare.usd"))
    assert staged.ExportToString() == bare.ExportToString()


def test_a_stale_layout_stops_the_publish_and_can_be_repaired(asset, tmp_path):
    spoil(asset)
    context = published(asset, staging=tmp_path / "staging")
    failed = errors(context)
    assert list(failed) == ["ValidateRigUI"]
    error = failed["ValidateRigUI"]
    assert "LAYOUT_TOPOLOGY" in str(error)
    assert error.title
    assert "usdrigui process" in error.description
    assert not (tmp_path / "staging").exists()

    (validator,) = [each for each in pyblish_api.discover() if each.__name__ == "ValidateRigUI"]
    assert validator.label
    assert validator.__doc__
    (action,) = validator.actions
    assert (action.label, action.on) == ("Repair", "failed")
    action().process(context, validator)
    assert errors(published(asset, staging=tmp_path / "staging")) == {}


def test_a_missing_layout_stops_it_too(asset):
    asset.with_name("char.rigui.usda").unlink()
    assert "LAYOUT_MISSING" in str(errors(published(asset))["ValidateRigUI"])


def test_assets_can_be_named_in_the_environment(asset, monkeypatch):
    monkeypatch.setenv("USDRIGUI_PUBLISH", str(asset))
    (instance,) = layouts(published())
    assert instance.data["representations"]


def test_one_cause_is_reported_in_one_line(asset, caplog):
    spoil(asset)
    error = errors(published(asset))["ValidateRigUI"]
    lines = [record.getMessage() for record in caplog.records if record.name == "pyblish.ValidateRigUI"]
    assert len(lines) == error.description.count("LAYOUT_TOPOLOGY") == 1
    assert re.search(r"blink_L, blink_R, brow_L and \d+ more: ", lines[0])


# --- AYON --------------------------------------------------------------------------------------------


class PublishValidationError(Exception):
    """With the arguments of AYON's."""

    def __init__(self, message, title=None, description=None, detail=None):
        super().__init__(message)
        self.title, self.description, self.detail = title, description, detail


class RepairAction(pyblish_api.Action):
    """Named as AYON's."""


class OptionalPyblishPluginMixin:
    """Switched off per instance in the publish attributes, as AYON's."""

    def is_active(self, data):
        return data.get("publish_attributes", {}).get(type(self).__name__, {}).get("active", True)


@pytest.fixture
def in_ayon(asset, monkeypatch):
    """The character; AYON's classes that we import, and plug-ins that read instances as its own do, stood in for."""
    pipeline = types.ModuleType("ayon_core.pipeline")
    pipeline.PublishValidationError = PublishValidationError
    publishing = types.ModuleType("ayon_core.pipeline.publish")
    publishing.RepairAction = RepairAction
    publishing.OptionalPyblishPluginMixin = OptionalPyblishPluginMixin
    for module in (types.ModuleType("ayon_core"), pipeline, publishing):
        monkeypatch.setitem(sys.modules, module.__name__, module)
    monkeypatch.delitem(sys.modules, "usdrigui.clients.publish.framework", raising=False)
    for plugin in ayon_plugins.PLUGINS:
        pyblish_api.register_plugin(plugin)
    yield asset
    sys.modules.pop("usdrigui.clients.publish.framework", None)


def ayon_published(asset, made=None, folder="/assets/World"):
    """Publish the character that the context lists, or one instance as AYON's creators make them."""
    context = pyblish_api.Context()
    context.data.update(folderPath=folder, task="rigging")
    if made is None:
        context.data["rigUIAssets"] = [str(asset)]
    else:
        instance = context.create_instance("rigMain")
        instance.data.update(ayon_plugins.created("rigMain", "rig"), usdFile=str(asset), **made)
    return pyblish.util.publish(context)


def contributed(context):
    (layer,) = [each for each in context if each.data.get("usd_contributions")]
    return layer.name, layer.data["usd_contributions"]


def test_ayons_collectors_make_a_sublayer_contribution_of_a_listed_character(in_ayon):
    context = ayon_published(in_ayon)
    assert errors(context) == {}
    name, (contribution,) = contributed(context)
    assert name == "usdAsset_rig"
    assert contribution["variant"] is None
    # AYON refers to the file by the representation's name, so that must be its extension.
    assert contribution["path"].endswith("usdCharRigUI_v001.usd")


def test_a_layout_that_would_lie_beside_the_asset_is_refused(in_ayon):
    assert "PUBLISH_ROOT /World/Char" in str(errors(ayon_published(in_ayon, folder="/assets/hero"))["ValidateRigUI"])


def test_a_layout_contributes_as_its_rig_does_and_over_it(in_ayon):
    said = {"contribution_apply_as_variant": True, "contribution_layer": "model", "contribution_in_layer_order": 4}
    attributes = {"CollectUSDLayerContributions": ayon_plugins.CONTRIBUTION | said}
    context = ayon_published(in_ayon, {"publish_attributes": attributes})
    assert errors(context) == {}
    name, contributions = contributed(context)
    assert name == "usdAsset_model"
    by_product = {each["product"]: each for each in contributions}
    assert by_product["rigMainRigUI"]["variant"] == by_product["rigMain"]["variant"] == ("model", "Main")
    assert by_product["rigMainRigUI"]["order"] == by_product["rigMain"]["order"] + 1


def test_ayons_classes_are_used_and_the_check_can_be_switched_off(in_ayon):
    spoil(in_ayon)
    assert isinstance(errors(ayon_published(in_ayon))["ValidateRigUI"], PublishValidationError)
    (validator,) = [each for each in pyblish_api.discover() if each.__name__ == "ValidateRigUI"]
    assert validator.actions == [RepairAction]
    context = pyblish_api.Context()
    instance = context.create_instance("layout")
    layer = in_ayon.with_name("char.rigui.usda")
    instance.data.update(rigUIAsset=str(in_ayon), rigUILayer=str(layer))
    instance.data["publish_attributes"] = {"ValidateRigUI": {"active": False}}
    validator().process(instance)
