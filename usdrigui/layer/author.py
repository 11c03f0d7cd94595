"""Writing specs into a layer: prims, typed values, and properties as the usdrigui schema declares
them."""

from __future__ import annotations

import functools
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from pxr import Sdf

from usdrigui.stages import schema

_DIGITS, _MATRIX_DIGITS = 7, 12
"""Significant digits authored of numbers: as many as a source in single precision has."""
TOLD = 10.0 ** (1 - _DIGITS)
"""Of the largest number of a value: so exactly a layer tells each of its numbers (`settled`)."""
_RULE = re.compile(r"^(Range|Length|Order|Norm): (.+)$", re.MULTILINE)
_NOT_PLAIN = re.compile(r"[^A-Za-z0-9_]")


@dataclass(frozen=True)
class Property:
    """One property that the schema declares."""

    name: str
    """Name on the prim, with ``__INSTANCE_NAME__`` for a multiple-apply schema."""
    type_name: str
    """Sdf type name; empty for a relationship."""
    fallback: Any
    allowed: tuple[str, ...]
    """Tokens that the schema allows; empty for no limit."""
    rules: Mapping[str, str]
    """What its documentation says of its numbers: ``Range``, ``Length``, ``Order`` and ``Norm``
    (`usdrigui.layer.rules`)."""


@functools.cache
def properties(api: str) -> Mapping[str, Property]:
    """The properties of an applied API schema by their last name, from generatedSchema.usda."""
    layer = Sdf.Layer.OpenAsAnonymous(str(schema.schema_path() / "generatedSchema.usda"))
    found = {}
    for spec in layer.GetPrimAtPath(f"/{api}").properties:
        is_attribute = isinstance(spec, Sdf.AttributeSpec)
        type_name = str(spec.typeName) if is_attribute else ""
        fallback = spec.default if is_attribute else None
        allowed = tuple(map(str, spec.allowedTokens or ())) if is_attribute else ()
        rules = dict(_RULE.findall(spec.documentation))
        found[spec.name.rpartition(":")[2]] = Property(
            spec.name, type_name, fallback, allowed, rules
        )
    return found


@functools.cache
def prim_types(api: str) -> list[str]:
    """What prims one of our schemas may be applied to, from plugInfo.json."""
    (plugin,) = json.loads((schema.schema_path() / "plugInfo.json").read_text("utf-8"))["Plugins"]
    return list(plugin["Info"]["Types"][f"Usd{api}"]["apiSchemaCanOnlyApplyTo"])


def prim(parent: Sdf.PrimSpec, name: str, type_name: str, apis: Sequence[str] = ()) -> Sdf.PrimSpec:
    """Define a child prim with applied API schemas."""
    spec = Sdf.PrimSpec(parent, name, Sdf.SpecifierDef, type_name)
    if apis:
        apply(spec, apis)
    return spec


def apply(spec: Sdf.PrimSpec, apis: Sequence[str]) -> None:
    """Apply API schemas to a prim."""
    schemas = Sdf.TokenListOp()
    schemas.prependedItems = list(apis)
    spec.SetInfo("apiSchemas", schemas)


def note(spec: Sdf.PrimSpec, text: str) -> None:
    """Put what only usdrigui asks for into the prim's customData."""
    spec.SetInfo("customData", {schema.NOTES: text})


def put(
    spec: Sdf.PrimSpec,
    name: str,
    type_name: str,
    value: Any,
    *,
    uniform: bool = False,
    exact: bool = False,
    **metadata: Any,
) -> None:
    """Author an attribute that USD's own schemas declare, `exact` where its numbers are settled one
    by one already; metadata that are None are left out."""
    variability = Sdf.VariabilityUniform if uniform else Sdf.VariabilityVarying
    attribute = Sdf.AttributeSpec(spec, name, _type(type_name), variability)
    attribute.default = usd_value(type_name, value if exact else settled(value, type_name))
    for key, said in metadata.items():
        if said is not None:
            attribute.SetInfo(key, said)


def link(spec: Sdf.PrimSpec, name: str, targets: Iterable[Sdf.Path | str]) -> None:
    """Author a relationship; an empty one is left out."""
    paths = [Sdf.Path(target).StripAllVariantSelections() for target in targets]
    if paths:
        relationship = Sdf.RelationshipSpec(spec, name, custom=False)
        relationship.targetPathList.explicitItems = paths


def declare(
    spec: Sdf.PrimSpec,
    api: str,
    values: Mapping[str, Any],
    instance: str = "",
    *,
    fallbacks: bool = False,
) -> None:
    """Author properties of one of our API schemas; values equal to the schema's fallback are left
    out, unless `fallbacks`: where a weaker layer has another opinion.

    Relationships take a sequence of paths.  KeyError for a name that the schema does not have.
    """
    known = properties(api)
    for key, value in values.items():
        declared = known[key]
        name = declared.name.replace("__INSTANCE_NAME__", instance)
        if not declared.type_name:
            link(spec, name, value)
        elif fallbacks or not _is_fallback(declared, value):
            put(spec, name, declared.type_name, value, uniform=True)


def usd_value(type_name: str, value: Any) -> Any:
    """A Python or numpy value as the type that USD stores for `type_name`."""
    example = _type(type_name).defaultValue
    if hasattr(example, "FromNumpy"):
        return type(example).FromNumpy(np.ascontiguousarray(value, dtype=np.asarray(example).dtype))
    return type(example)(np.asarray(value).tolist())


def settled(value: Any, type_name: str) -> Any:
    """Numbers without the last digits, which depend on the processor: sums are formed in another
    order on each.

    Kept are 7 digits (12 of matrices) of the largest number of the value.
    """
    if type_name.startswith(("int", "token", "string", "bool")):
        return value
    numbers = np.asarray(value, dtype=np.float64)
    largest = np.abs(numbers[np.isfinite(numbers)]).max(initial=0.0)
    # A power of two, so that noise about a power of ten (unit vectors) does not change the digits
    # kept.
    mantissa, exponent = np.frexp(largest)
    scale = (exponent + (1.5 * mantissa >= 1.0)) * np.log10(2.0) if largest > 0.0 else 0.0
    digits = _MATRIX_DIGITS if type_name == "matrix4d" else _DIGITS
    decimals = min(digits - int(np.ceil(scale)), 290)  # ten to that power is finite
    kept = np.round(numbers, decimals) + 0.0  # no -0
    return kept if kept.ndim else kept.item()


@functools.cache
def _type(name: str) -> Any:
    return Sdf.ValueTypeNames.Find(name)


def _is_fallback(declared: Property, value: Any) -> bool:
    if declared.type_name.endswith("[]"):
        return len(value) == 0  # no array of the schema has another fallback
    told = settled(value, declared.type_name)
    return bool(usd_value(declared.type_name, told) == declared.fallback)


def identifier(text: str, taken: set[str]) -> str:
    """A valid prim or instance name made from any text, ASCII only, not in `taken`, to which it is
    added."""
    plain = _NOT_PLAIN.sub("_", text)
    if not plain or plain[0].isdigit():
        plain = f"_{plain}"
    name, count = plain, 1
    while name in taken:
        count += 1
        name = f"{plain}_{count}"
    taken.add(name)
    return name
