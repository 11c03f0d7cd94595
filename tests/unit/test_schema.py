"""The schema: found without USD, generated from its source, registered in time or not at all."""

from __future__ import annotations

import importlib.util
import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from folders import ROOT
from programs import ran
from pxr import Sdf, Usd

from usdrigui.layer import author
from usdrigui.stages import schema

SOURCE = ROOT / "schemas"


def run(code: str, **environment: str) -> str:
    """Output of a fresh Python."""
    done = ran("-c", code, env={**os.environ, **environment})
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_the_path_is_found_without_loading_usd():
    code = "import sys; from usdrigui.stages.schema import schema_path; print(schema_path(), 'pxr' in sys.modules)"
    path, loaded = run(code).rsplit(" ", 1)
    assert {"plugInfo.json", "generatedSchema.usda"} <= {each.name for each in Path(path).iterdir()}
    assert loaded == "False"


@pytest.mark.skipif(importlib.util.find_spec("jinja2") is None, reason="usdGenSchema needs jinja2")
@pytest.mark.skipif(not SOURCE.is_dir(), reason="only in a source tree")
def test_committed_files_are_what_the_generator_makes(tmp_path):
    subprocess.run([sys.executable, str(SOURCE / "generate.py"), str(tmp_path)], check=True, timeout=120)
    for name in ("generatedSchema.usda", "plugInfo.json"):
        assert (tmp_path / name).read_text() == (SOURCE / name).read_text(), f"run python schemas/generate.py ({name})"


NOT_NUMBERS = ("token", "token[]", "string", "string[]", "bool")


@pytest.mark.skipif(not SOURCE.is_dir(), reason="only in a source tree")
def test_every_class_of_the_source_is_known_by_name_and_documented():
    layer = Sdf.Layer.FindOrOpen(str(SOURCE / "generatedSchema.usda"))
    assert {prim.name for prim in layer.rootPrims} == set(schema.APIS)
    for prim in layer.rootPrims:
        assert prim.documentation, prim.path
        for each in prim.properties:
            numeric = isinstance(each, Sdf.AttributeSpec) and str(each.typeName) not in NOT_NUMBERS
            assert ("Units: " in each.documentation) == numeric, each.path
            assert ("Range: " in each.documentation) == numeric, each.path
            spatial = isinstance(each, Sdf.AttributeSpec) and str(each.typeName).startswith(("point", "vector"))
            assert ("Space: " in each.documentation) == spatial, each.path
            assert each.displayName, each.path
            assert each.displayGroup, each.path
    types = json.loads((SOURCE / "plugInfo.json").read_text())["Plugins"][0]["Info"]["Types"]
    assert {each["schemaIdentifier"] for each in types.values()} == set(schema.APIS)


@pytest.mark.skipif(not hasattr(Usd, "AttributeLimits"), reason="USD before 25.11 has no limits")
def test_every_bound_of_a_number_is_a_limit_of_its_type():
    layer = Sdf.Layer.FindOrOpen(str(SOURCE / "generatedSchema.usda"))
    stage = Usd.Stage.CreateInMemory()
    bounded = 0
    for each in (each for top in layer.rootPrims for each in top.attributes if "Range: " in each.documentation):
        low, high = re.search(r"^Range: [\[(](\S+), (\S+)[\])]$", each.documentation, re.MULTILINE).groups()
        hard = (each.GetInfo("limits") or {}).get("hard", {})
        assert ("minimum" in hard, "maximum" in hard) == tuple(re.search(r"\d", end) is not None for end in (low, high))
        for found, said in ((hard.get("minimum", low), low), (hard.get("maximum", high), high)):
            assert found == said or np.all(np.asarray(found) == float(said)), each.path
        made = stage.DefinePrim(f"/{each.owner.name}").CreateAttribute(each.name, each.typeName)
        validated = made.GetHardLimits().Validate(hard)
        assert validated.success, each.path
        assert {*map(type, validated.conformedSubDict.values())} == {*map(type, hard.values())}, each.path
        bounded += bool(hard)
    assert bounded > 10


def test_registration_in_time_brings_fallbacks():
    code = """
from usdrigui.stages import schema
schema.register()
schema.register()
from pxr import Usd
stage = Usd.Stage.CreateInMemory()
prim = stage.DefinePrim("/a")
prim.AddAppliedSchema("RigUIElementAPI")
prim.AddAppliedSchema("RigUIControlAPI:smile")
print(prim.GetAttribute("rigUI:element:elementType").Get(), prim.GetAttribute("rigUI:control:smile:maximum").Get())
print(prim.GetAttribute("rigUI:control:smile:magnification").GetMetadataByDictKey("limits", "hard:minimum"))
"""
    assert run(code) == "slider 1.0\n0.0"


@pytest.mark.parametrize("early", ["Usd.Stage.CreateInMemory().DefinePrim('/a', 'Xform')", "Usd.SchemaRegistry()"])
def test_registration_too_late_refuses(early):
    code = f"""
from pxr import Usd
keep = {early}
from usdrigui.errors import RigUIError
from usdrigui.stages import schema
try:
    schema.register()
except RigUIError as error:
    print(error.issue.code, "PXR_PLUGINPATH_NAME" in error.issue.repair, int(error.exit_code))
"""
    assert run(code) == "SCHEMA_TOO_LATE True 2"


def test_the_environment_variable_registers_too():
    code = """
from pxr import Usd
stage = Usd.Stage.CreateInMemory()
from usdrigui.stages import schema
schema.register()
print(Usd.SchemaRegistry().FindAppliedAPIPrimDefinition("RigUIDrawingAPI") is not None)
"""
    assert run(code, PXR_PLUGINPATH_NAME=str(schema.schema_path())) == "True"


def test_a_property_that_the_schema_lacks_cannot_be_written():
    layer = Sdf.Layer.CreateAnonymous(".usda")
    prim = Sdf.CreatePrimInLayer(layer, "/a")
    with pytest.raises(KeyError):
        author.declare(prim, schema.ELEMENT, {"elementKind": "slider"})
    author.declare(prim, schema.ELEMENT, {"elementType": "slider", "side": "left"})
    assert [each.name for each in prim.properties] == ["rigUI:element:side"]


@pytest.mark.parametrize(
    ("text", "name"),
    [("jawOpen", "jawOpen"), ("25_x", "_25_x"), ("", "_"), ("a:b.c-d e", "a_b_c_d_e"), ("ärger", "_rger"), ("口", "_")],
)
def test_identifiers_are_ascii_and_unique(text, name):
    taken: set[str] = set()
    assert author.identifier(text, taken) == name
    assert author.identifier(text, taken) == f"{name}_2"
    assert all(Sdf.Path.IsValidIdentifier(each) for each in taken)
