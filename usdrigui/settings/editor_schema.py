"""editor_schema(): the JSON Schema of a configuration, with which editors complete and check it."""

from __future__ import annotations

import types
import typing
from collections.abc import Mapping
from dataclasses import MISSING, Field, fields
from typing import Any, Literal

from usdrigui.settings.about import About, settings_table
from usdrigui.settings.config_sections import section_types

_TYPES = {bool: "boolean", int: "integer", float: "number", str: "string"}


def editor_schema() -> dict[str, Any]:
    """A JSON Schema (draft 7, which TOML editors read) of ``CHAR.rigui.toml``, from the table of
    settings."""
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "Configuration of usdrigui",
        **_table({name: _section(name, kind) for name, kind in section_types().items()}),
    }


def _section(name: str, kind: Any) -> dict[str, Any]:
    if typing.get_origin(kind) is Mapping:
        return {
            "type": "object",
            "additionalProperties": _section(name, typing.get_args(kind)[1]),
        }
    hints, known = typing.get_type_hints(kind), settings_table()[name]
    settings = {
        each.name: _setting(each, known[each.name], hints[each.name]) for each in fields(kind)
    }
    return {**_table(settings), "description": " ".join((kind.__doc__ or "").split())}


def _table(properties: dict[str, Any]) -> dict[str, Any]:
    return {"type": "object", "additionalProperties": False, "properties": properties}


def _setting(each: Field[Any], about: About, hint: Any) -> dict[str, Any]:
    doc = f"{about.doc} Unit: {about.unit}." if about.unit else about.doc
    found = {**_schema(hint), "description": doc}
    if about.bounds:
        found |= {"minimum": about.bounds[0], "maximum": about.bounds[1]}
    if each.default is not MISSING and each.default is not None:
        found["default"] = list(each.default) if isinstance(each.default, tuple) else each.default
    return found


def _schema(hint: Any) -> dict[str, Any]:
    """Of a type as settings are annotated."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is Mapping:
        return {"type": "object", "additionalProperties": _schema(arguments[1])}
    if origin is tuple:
        return {"type": "array", "items": _schema(arguments[0])}
    if origin is Literal:
        return {"enum": list(arguments)}
    if origin is types.UnionType:
        return _schema(arguments[0])
    return {"type": _TYPES[hint]}
