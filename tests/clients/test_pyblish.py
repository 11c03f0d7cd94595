"""A real Pyblish publish, headless.  Its command exits 0 on errors, so the results themselves are looked at."""

import shutil
import sys
import types

import pytest
from pxr import Sdf, Usd

from usdrigui.cli import main

pyblish_api = pytest.importorskip("pyblish.api", reason="usdrigui[pyblish] is not installed")
import pyblish.util  # noqa: E402

from usdrigui.clients import publish  # noqa: E402


@pytest.fixture
def asset(laid_out, tmp_path):
    """A character with its layout, and Pyblish with nothing but our plug-ins."""
    shutil.copytree(laid_out, tmp_path / "asset")
    pyblish_api.deregister_all_paths()
    pyblish_api.deregister_all_plugins()
    pyblish_api.register_host("shell")
    publish.register()
    yield tmp_path / "asset" / "char.usda"
    pyblish_api.deregister_all_paths()


def published(*assets, staging=None):
    context = pyblish_api.Context()
    context.data["rigUIAssets"] = [str(each) for each in assets]
    if staging is not None:
        instance = context.create_instance("char")
        instance.data.update(family="rig", usdFile=str(assets[0]), stagingDir=str(staging), folderPath="/char")
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
    assert (representation["name"], representation["ext"]) == ("usd", "usda")
    staged = tmp_path / "staging" / representation["files"]
    layer = Sdf.Layer.OpenAsAnonymous(str(staged))
    assert list(layer.subLayerPaths) == []
    over = Sdf.Layer.CreateAnonymous(".usda")
    over.subLayerPaths = [str(staged), str(asset)]
    assert Usd.Stage.Open(over).GetPrimAtPath("/World/Char/RigUI").GetChildren()
    assert asset.read_bytes() == before


def test_the_staged_layer_is_what_process_writes_bare(asset, tmp_path):
    published(asset, staging=tmp_path / "staging")
    assert main(["process", str(asset), "--bare", "--quiet", "-o", str(tmp_path / "bare.usda")]) == 0
    assert (tmp_path / "staging" / "char.rigui.usda").read_bytes() == (tmp_path / "bare.usda").read_bytes()


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
    assert "FILE_NOT_FOUND" in str(errors(published(asset))["ValidateRigUI"])


def test_a_layout_over_another_asset_stops_it(asset):
    other = asset.with_name("other.usda")
    shutil.copy(asset, other)
    shutil.copy(asset.with_name("char.rigui.usda"), asset.with_name("other.rigui.usda"))
    assert "LAYOUT_STALE" in str(errors(published(other))["ValidateRigUI"])


def test_assets_can_be_named_in_the_environment(asset, monkeypatch):
    monkeypatch.setenv("USDRIGUI_PUBLISH", str(asset))
    (instance,) = layouts(published())
    assert instance.data["representations"]


def test_under_ayon_its_classes_are_used_and_the_rig_layer_is_contributed_to(asset, tmp_path, monkeypatch):
    """AYON itself is stood in for: its exception, its repair action, its collector of USD contributions."""

    class PublishValidationError(Exception):
        def __init__(self, message, title=None, description=None, detail=None):
            super().__init__(message)
            self.title, self.description, self.detail = title, description, detail

    class RepairAction(pyblish_api.Action):
        pass

    pipeline = types.ModuleType("ayon_core.pipeline")
    pipeline.PublishValidationError = PublishValidationError
    publishing = types.ModuleType("ayon_core.pipeline.publish")
    publishing.RepairAction = RepairAction
    for name, module in (
        ("", types.ModuleType("ayon_core")),
        (".pipeline", pipeline),
        (".pipeline.publish", publishing),
    ):
        monkeypatch.setitem(sys.modules, f"ayon_core{name}", module)
    monkeypatch.delitem(sys.modules, "usdrigui.clients.publish.framework", raising=False)
    spoil(asset)
    context = published(asset, staging=tmp_path / "staging")
    assert isinstance(errors(context)["ValidateRigUI"], PublishValidationError)
    (validator,) = [each for each in pyblish_api.discover() if each.__name__ == "ValidateRigUI"]
    assert validator.actions == [RepairAction]
    (instance,) = layouts(context)
    contribution = instance.data["publish_attributes"]["CollectUSDLayerContributions"]
    assert contribution["contribution_enabled"]
    assert contribution["contribution_layer"] == "rig"
    assert "usd" in instance.data["families"]
    monkeypatch.delitem(sys.modules, "usdrigui.clients.publish.framework", raising=False)
