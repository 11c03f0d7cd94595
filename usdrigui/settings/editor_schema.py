"""editor_schema(): the JSON Schema of a configuration, with which editors complete and check it."""

from __future__ import annotations

import types
import typing
from collections.abc import Mapping
from dataclasses import MISSING, Field, is_dataclass
from typing import Any, Literal

from usdrigui.settings.config_sections import section_types
from usdrigui.settings.table import About, settings_in

_TYPES = {bool: "boolean", int: "integer", float: "number", str: "string"}


def editor_schema() -> dict[str, Any]:
    """A JSON Schema (draft 7, which TOML editors read) of ``CHAR.rigui.toml``, from the table of
    settings."""
    return {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": "Configuration of usdrigui",
        **_table(section_types(), {}),
    }


def _part(part: Any) -> dict[str, Any]:
    hints = typing.get_type_hints(part)
    known = {
        each.name: _setting(each, about, hints[each.name]) for each, about in settings_in(part)
    }
    return _table({name: hint for name, hint in hints.items() if name not in known}, known)


def _table(inner: Mapping[str, Any], known: Mapping[str, Any]) -> dict[str, Any]:
    """Of a table with settings of `known` schemas and with others, by their types."""
    more = {name: _schema(hint) for name, hint in inner.items()}
    return {"type": "object", "additionalProperties": False, "properties": {**more, **known}}


def _setting(each: Field[Any], about: About, hint: Any) -> dict[str, Any]:
    doc = f"{about.doc} Unit: {about.unit}." if about.unit else about.doc
    found = {**_schema(hint), "description": doc}
    if about.bounds is not None:
        found |= {"minimum": about.bounds[0], "maximum": about.bounds[1]}
    if each.default is not MISSING and each.default is not None:
        found["default"] = list(each.default) if isinstance(each.default, tuple) else each.default
    return found


def _schema(hint: Any) -> dict[str, Any]:
    """Of a type as settings are annotated."""
    if is_dataclass(hint):
        return {**_part(hint), "description": " ".join((hint.__doc__ or "").split())}
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is Mapping:
        return {"type": "object", "additionalProperties": _schema(arguments[1])}
    if origin is tuple:
        return {"type": "array", "items": _schema(arguments[0])}
    if origin is Literal:
        return {"enum": list(arguments)}
    if origin in (types.UnionType, typing.Union):
        return _schema(next(each for each in arguments if each is not type(None)))
    return {"type": _TYPES[hint]}
