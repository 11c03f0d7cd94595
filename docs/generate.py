"""Write the reference pages that are made from the source: ``python docs/generate.py [--check]``.

settings.md and the JSON Schema for editors come from usdrigui/settings (parts.py and
about.toml), codes.md from usdrigui/codes.toml, layer.md and the table at the end of
schemas/CONTRACT.md from schemas/generatedSchema.usda.

With ``--check`` nothing is written and the exit code is 1 if a page
is out of date.
"""

from __future__ import annotations

import argparse
import dataclasses
import inspect
import json
import re
import sys
import types
import typing
from collections.abc import Iterator, Mapping
from dataclasses import MISSING, Field, fields
from pathlib import Path
from typing import Any, Literal

from pxr import Sdf

from usdrigui.errors import catalogue
from usdrigui.settings import Settings, presets
from usdrigui.settings.about import About, settings_table

ROOT = Path(__file__).resolve().parents[1]
TEN = (
    *(
        f'controls."NAME".{key}'
        for key in ("exclude", "place", "near", "anchor", "minimum", "maximum", "twin")
    ),
    "groups.groups",
    "objective.handle_size",
    "read.joints",
)
"""What does nearly all that a rigger asks for; docs/rigger.md shows them in this order."""
_TABLES = {
    "user": "",
    "expert": "## For experts\n\nLimits, weights and thresholds of the stages.\n\n",
    "paper": "## Of the preset `paper`\n\n",
}
"""The level of the settings of each table, and its heading."""
_TABLE = "<!-- The table is made by docs/generate.py; do not edit. -->\n\n"
NOTE = "<!-- Made by docs/generate.py; do not edit. -->\n\n"


def main() -> int:
    """Write or check every page; returns 1 when a page was out of date."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    stale = [name for name, text in pages().items() if _differs(ROOT / "docs" / name, text)]
    for name in stale:
        if arguments.check:
            print(f"docs/{name} is out of date: run python docs/generate.py")
        else:
            (ROOT / "docs" / name).write_text(pages()[name], encoding="utf-8")
            print(f"wrote docs/{name}")
    return int(arguments.check and bool(stale))


def pages() -> dict[str, str]:
    """File name below docs/ to its text."""
    return {
        "settings.md": settings_page(),
        "codes.md": codes_page(),
        "layer.md": schema_page(),
        "../schemas/CONTRACT.md": contract_page(),
        "../usdrigui/settings/editor_schema.json": json.dumps(editor_schema(), indent=2) + "\n",
    }


def settings_page() -> str:
    """Every setting with its type, default and meaning."""
    parts = [
        "# Settings\n",
        NOTE,
        (
            "Every setting may be given in `CHAR.rigui.toml` beside the asset, in files named by"
            " `--config` (of several a later one wins), or on the\ncommand line (`--set"
            " solve.gap=1e-3`, `--set controls.smile.maximum=0.5`; names with a dot in quotes:\n"
            "`--set 'controls.\"brow.L\".exclude=true'`). An environment variable"
            " (`USDRIGUI_SOLVE_GAP=1e-3`) can set\nevery setting but those of a control, pose or"
            " joint by its name (`controls`, `poses`, `joints`).\nStrongest first: command line,"
            " configuration file, environment, preset, default. Unknown keys are"
            " errors.\n\n`check`, `view`, `picture` and `picker` of a layout need the configuration"
            " that it was made with, as it\ndefines the controls of the character. They take the"
            " files of `--config`; without any that of the layout's\nown name (`looks/cfg.toml`"
            " for `looks/cfg.usda`), and without that `CHAR.rigui.toml` beside the asset that\nthe"
            " layout sublayers, wherever the layout lies. For an asset, by itself or with its"
            " layout attached, it is\n`CHAR.rigui.toml` beside it. A layer over a layout"
            " (corrections) takes that of the layout if it has none.\n\n`usdrigui config-schema >"
            " usdrigui.schema.json` writes a JSON Schema of all of this. An editor with a"
            " TOML\nlanguage server (Even Better TOML, taplo) completes and checks a configuration"
            " whose first line is\n`#:schema ./usdrigui.schema.json`.\n"
        ),
    ]
    rows = {level: dict(_settings_rows(level)) for level in _TABLES}
    parts += [
        "\n## The ten\n\nWith pictures: [rigger.md](rigger.md#the-ten-settings).\n\n",
        _HEAD,
        *(rows["user"].pop(key) for key in TEN),
    ]
    parts += ["\n## The rest\n\n"]
    parts += [f"- `[{name}]` {_first_sentences(part)}\n" for name, part in _parts()]
    for level, heading in _TABLES.items():
        parts += [f"\n{heading}{_HEAD}", *rows[level].values()]
    parts.append("\n## Presets\n\n")
    for name, values in presets().items():
        changed = [
            f"`{part}.{key}` = `{value}`"
            for part, keys in values.items()
            for key, value in keys.items()
        ]
        parts.append(f"- `{name}`: {', '.join(changed) or 'the defaults above'}\n")
    return "".join(parts)


def _first_sentences(part: type) -> str:
    """The first paragraph of its docstring, in one line."""
    return " ".join(inspect.cleandoc(part.__doc__ or "").partition("\n\n")[0].split())


def codes_page() -> str:
    """Every issue code with its severity, meaning and repair."""
    rows = [
        f"| `{name}` | {code.severity} | {int(code.exit) if code.severity == 'error' else 0} "
        f"| {code.meaning} | {code.repair} |\n"
        for name, code in sorted(catalogue().items())
    ]
    head = "| code | severity | exit | meaning | how to repair |\n|---|---|---|---|---|\n"
    intro = (
        "Codes are stable: never renamed, never reused. An error ends the run; the exit code is the"
        " one given.\n\n"
    )
    return "# Issue codes\n\n" + NOTE + intro + head + "".join(rows)


def schema_page() -> str:
    """Every applied schema of a layout layer with its properties."""
    intro = (
        "The properties of the prims of a layout layer. [The contract](../schemas/CONTRACT.md)"
        " explains how they\nbelong together and how versions change. With the folder that"
        " `usdrigui schema-path`"
        " prints in `PXR_PLUGINPATH_NAME`,\nUSD itself knows these schemas; without it every value"
        " still reads, but for fallbacks. `usdrigui conform 'READER'` asks a reader of your own the"
        " questions of the\ncontract's conformance suite.\n"
    )
    return "# The layer\n\n" + NOTE + intro + "".join(map(_schema, _schemas()))


_MUST = {
    "layout:handleWidth": "",
    "layout:skeleton": ", where anything is bound",
    "anchor:prim": " on the character; without it the element is on the board",
    "anchor:carrier": " on the board",
    "anchor:pointIndex": "",
    "anchor:position": "",
    "primvars:rigUI:role": "",
    "control:*:blendShapes": ", or `joints`",
    "control:*:joints": ", or `blendShapes`",
    "control:*:skeleton": " with `joints`",
    "control:*:trackPoints": "",
}
"""What an element needs, with the case in which it does; `usdrigui check` lists missing ones."""


def contract_page() -> str:
    """The contract with its table of properties, which follows the line that announces it."""
    text = (ROOT / "schemas" / "CONTRACT.md").read_text(encoding="utf-8")
    head = "| property | type, unit | space | if absent | meaning |\n|---|---|---|---|---|\n"
    rows = (_brief(each) for prim in _schemas() for each in prim.properties)
    return text.partition(_TABLE)[0] + _TABLE + head + "".join(rows)


def _brief(found: Sdf.PropertySpec) -> str:
    """One line of the table of the contract."""
    text, _, unit = _flat(found.documentation).partition(" Units: ")
    text, _, space = text.partition(" Range: ")[0].partition(" Space: ")
    meaning, absent = (
        (text[: named.start()], named[2])
        if (named := re.search(r" (Empty|Zero|No target): (.*?)(?=\. |\.$)", text))
        else (text, "")
    )
    name = found.name.removeprefix("rigUI:").replace("__INSTANCE_NAME__", "*")
    chosen = isinstance(found, Sdf.AttributeSpec) and found.allowedTokens
    first = (meaning if chosen else meaning.partition(". ")[0]).rstrip(".").replace("`rigUI:", "`")
    kind = "relationship"
    if isinstance(found, Sdf.AttributeSpec):
        kind = f"{found.typeName}, {unit}" if unit not in ("", "none") else str(found.typeName)
        absent = absent or _said(found.default)
    if name in _MUST:
        absent = "**must** be there" + _MUST[name]
    return f"| `{name}` | {kind} | {space} | {absent or 'none'} | {first} |\n"


def _said(fallback: Any) -> str:
    if isinstance(fallback, float):
        return f"`{fallback:g}`"
    text = str(fallback).lower() if isinstance(fallback, bool) else str(fallback)
    return f"`{text}`" if text not in ("", "[]") else ""


def _schemas() -> Iterator[Sdf.PrimSpec]:
    layer = Sdf.Layer.FindOrOpen(str(ROOT / "schemas" / "generatedSchema.usda"))
    yield from layer.rootPrims


def _schema(prim: Sdf.PrimSpec) -> str:
    many = any("__INSTANCE_NAME__" in each.name for each in prim.properties)
    kind = "one for each name" if many else "applied once"
    head = f"\n## `{prim.name}`\n\n{_flat(prim.documentation)} ({kind})\n"
    if not prim.properties:
        return head
    rows = "".join(_property(each) for each in prim.properties)
    return f"{head}\n| property | type | fallback | meaning |\n|---|---|---|---|\n{rows}"


def _property(found: Sdf.PropertySpec) -> str:
    meaning = _flat(found.documentation)
    if isinstance(found, Sdf.RelationshipSpec):
        return f"| `{found.name}` | relationship | | {meaning} |\n"
    allowed = ", ".join(f"`{each}`" for each in found.allowedTokens or ())
    meaning += f" One of {allowed}." if allowed else ""
    fallback = "" if found.default is None else f"`{found.default}`"
    return f"| `{found.name}` | `{found.typeName}` | {fallback} | {meaning} |\n"


def _flat(text: str) -> str:
    return " ".join(text.split()).replace("|", "or")


_HEAD = "| key | type | default | unit | from, to | meaning |\n|---|---|---|---|---|---|\n"


def _parts() -> Iterator[tuple[str, Any]]:
    """The parts of the settings, those with a name of the user's own as ``controls."NAME"``."""
    for name, hint in typing.get_type_hints(Settings).items():
        free = typing.get_origin(hint) is Mapping
        yield (f'{name}."NAME"', typing.get_args(hint)[1]) if free else (name, hint)


def _settings_rows(level: str) -> Iterator[tuple[str, str]]:
    """Each setting's key with its row of the table of a level."""
    for name, part in _parts():
        known = settings_table()[name.partition(".")[0]]
        for each in dataclasses.fields(part):
            if known[each.name].level == level:
                key = f"{name}.{each.name}"
                yield key, _row(key, each, known[each.name])


def _row(key: str, each: dataclasses.Field[Any], about: About) -> str:
    default = "{}" if each.default is dataclasses.MISSING else repr(each.default)
    bounds = f"{about.bounds[0]:g}, {about.bounds[1]:g}" if about.bounds else ""
    kind, doc = (_flat(str(text)) for text in (each.type, about.doc))
    return f"| `{key}` | `{kind}` | `{default}` | {about.unit} | {bounds} | {doc} |\n"


def _differs(path: Path, text: str) -> bool:
    return not path.is_file() or path.read_text(encoding="utf-8") != text


# --- the JSON Schema of a configuration -----------------------------------------------------------

_JSON_TYPES = {bool: "boolean", int: "integer", float: "number", str: "string"}


def editor_schema() -> dict[str, Any]:
    """A JSON Schema (draft 7, which TOML editors read) of ``CHAR.rigui.toml``, from the table of
    settings."""
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "Configuration of usdrigui",
        **_object(
            {
                name: _editor_section(name, kind)
                for name, kind in typing.get_type_hints(Settings).items()
            }
        ),
    }


def _editor_section(name: str, kind: Any) -> dict[str, Any]:
    if typing.get_origin(kind) is Mapping:
        return {
            "type": "object",
            "additionalProperties": _editor_section(name, typing.get_args(kind)[1]),
        }
    hints, known = typing.get_type_hints(kind), settings_table()[name]
    settings = {
        each.name: _editor_setting(each, known[each.name], hints[each.name])
        for each in fields(kind)
    }
    return {**_object(settings), "description": " ".join((kind.__doc__ or "").split())}


def _object(properties: dict[str, Any]) -> dict[str, Any]:
    return {"type": "object", "additionalProperties": False, "properties": properties}


def _editor_setting(each: Field[Any], about: About, hint: Any) -> dict[str, Any]:
    doc = f"{about.doc} Unit: {about.unit}." if about.unit else about.doc
    found = {**_of_hint(hint), "description": doc}
    if about.bounds:
        found |= {"minimum": about.bounds[0], "maximum": about.bounds[1]}
    if each.default is not MISSING and each.default is not None:
        found["default"] = list(each.default) if isinstance(each.default, tuple) else each.default
    return found


def _of_hint(hint: Any) -> dict[str, Any]:
    """Of a type as settings are annotated."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is Mapping:
        return {"type": "object", "additionalProperties": _of_hint(arguments[1])}
    if origin is tuple:
        return {"type": "array", "items": _of_hint(arguments[0])}
    if origin is Literal:
        return {"enum": list(arguments)}
    if origin is types.UnionType:
        return _of_hint(arguments[0])
    return {"type": _JSON_TYPES[hint]}


if __name__ == "__main__":
    sys.exit(main())
