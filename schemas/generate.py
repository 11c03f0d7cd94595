"""Make generatedSchema.usda and plugInfo.json from schema.usda: ``python schemas/generate.py
[FOLDER]``.

Runs the `usdGenSchema` of usd-core (needs jinja2; 26.11 made the files kept here), names the
resource plug-in, puts the full documentation back, of which it keeps the first sentences only, and
writes the ranges of the documentation as `limits`.  FOLDER is the output; by default that of
schema.usda.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from pxr import Sdf

HERE = Path(__file__).resolve().parent
_RANGE = re.compile(r"^Range: [\[(](\S+), (\S+)[\])]$", re.MULTILINE)
_NUMBER = re.compile(r"-?[\d.]+")
_FLOW = re.compile(r"\s*\n\s*(?=\S)(?!Range:|Length:|Order:|Norm:|Space:|Units:|Zero:)|(?<=\.)  ")


def generate(folder: Path) -> None:
    """Write both files to `folder`; raises CalledProcessError when usdGenSchema fails."""
    with tempfile.TemporaryDirectory() as scratch:
        _run_generator(Path(scratch))
        plug_info = json.loads(
            _without_comments((Path(scratch) / "plugInfo.json").read_text("utf-8"))
        )
        schema = Sdf.Layer.OpenAsAnonymous(str(Path(scratch) / "generatedSchema.usda"))
        _restore_documentation(schema, Sdf.Layer.FindOrOpen(str(HERE / "schema.usda")))
        _author_limits(schema)
        schema.comment = ""
        schema.documentation = "Generated from schema.usda by generate.py. Do not edit."
        (folder / "generatedSchema.usda").write_text(schema.ExportToString(), "utf-8", newline="\n")
        _name_plugin(plug_info["Plugins"][0])
        (folder / "plugInfo.json").write_text(
            json.dumps(plug_info, indent=4, sort_keys=True) + "\n", "utf-8"
        )


def _run_generator(folder: Path) -> None:
    subprocess.run(
        [sys.executable, "-m", "pxr.Usd.usdGenSchema", str(HERE / "schema.usda"), str(folder)],
        # Without this the generator refuses a schema that no built plug-in declares yet.
        env={**os.environ, "USD_DISABLE_PRIM_DEFINITIONS_FOR_USDGENSCHEMA": "1"},
        check=True,
        capture_output=True,
        text=True,
    )


def _without_comments(text: str) -> str:
    return "".join(line for line in text.splitlines(keepends=True) if not line.startswith("#"))


def _name_plugin(plugin: dict[str, object]) -> None:
    """Fill in what the build of USD itself would: the schema is a resource, beside its
    plugInfo.json."""
    plugin.update(Name="usdRigUI", Type="resource", Root=".", ResourcePath=".", LibraryPath="")


def _restore_documentation(schema: Sdf.Layer, source: Sdf.Layer) -> None:
    for prim in schema.rootPrims:
        prefix = _property_prefix(source, prim)
        for spec, original in [
            (prim, source.GetObjectAtPath(prim.path)),
            *(
                (each, _source_property(source, prim, each.name.removeprefix(prefix)))
                for each in prim.properties
            ),
        ]:
            spec.SetInfo("documentation", _reflowed(original.documentation))
            if "userDocBrief" in spec.customData:
                del spec.customData["userDocBrief"]


def _property_prefix(source: Sdf.Layer, prim: Sdf.PrimSpec) -> str:
    """What a multiple-apply schema's properties are called in the registry before their own
    names."""
    custom = source.GetPrimAtPath(prim.path).customData
    return (
        f"{custom['propertyNamespacePrefix']}:__INSTANCE_NAME__:"
        if "propertyNamespacePrefix" in custom
        else ""
    )


def _source_property(source: Sdf.Layer, prim: Sdf.PrimSpec, name: str) -> Sdf.PropertySpec:
    return source.GetPropertyAtPath(prim.path.AppendProperty(name))


def _author_limits(schema: Sdf.Layer) -> None:
    """Say each range once more for machines, as hard `limits`; an end without a number has no
    limit."""
    for prim in schema.rootPrims:
        for spec in prim.attributes:
            for ends in _RANGE.findall(spec.documentation):
                bounds = dict(zip(("minimum", "maximum"), ends, strict=True))
                hard = {
                    key: _bound(spec.typeName, end)
                    for key, end in bounds.items()
                    if _NUMBER.fullmatch(end)
                }
                if hard:
                    spec.SetInfo("limits", {"hard": hard})


def _bound(kind: Sdf.ValueTypeName, end: str) -> object:
    """A limit has the type of its attribute: a vector for its components, an array with one entry
    for all of its."""
    scalar = type(kind.scalarType.defaultValue)(float(end))
    return type(kind.defaultValue)([scalar]) if kind.isArray else scalar


def _reflowed(text: str) -> str:
    """One line per paragraph; lines that begin a field (``Range:``, ``Units:``) stay apart."""
    paragraphs = re.split(r"\n\s*\n", text.strip())
    return "\n\n".join(re.sub(r"\s*\n\s*", "\n", _FLOW.sub(" ", each)) for each in paragraphs)


if __name__ == "__main__":
    generate(Path(sys.argv[1]) if len(sys.argv) > 1 else HERE)
