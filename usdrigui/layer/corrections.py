"""Corrections of a person as USD: below each SkelRoot a Scope with one prim for each control."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Iterable, Mapping
from typing import Any

from pxr import Sdf, Usd

from usdrigui.layer import author
from usdrigui.layer.properties import has, invalid, refuse_broken, value_of
from usdrigui.model import Correction
from usdrigui.stages import schema

_EVERYTHING = Usd.PrimAllPrimsPredicate
_FIELDS = {
    "control": "control",
    "prim": "mesh",
    "place": "place",
    "position": "position",
    "up": "up",
    "metersPerUnit": "unit",
    "pointIndex": "point",
    "group": "group",
    "settings": "settings",
}
"""Properties of the schema, and the fields of `Correction` that they hold."""


def read_corrections(stage: Usd.Stage) -> tuple[Correction, ...]:
    """Every correction on a stage, by prim path; raises LAYOUT_INVALID, also where a control has
    two."""
    found: dict[Any, Correction] = {}
    for prim in Usd.PrimRange(stage.GetPseudoRoot(), _EVERYTHING):
        if prim.IsActive() and has(prim, schema.CORRECTION):
            each = _correction(prim)
            if found.setdefault((each.root, each.control), each) is not each:
                raise invalid(prim, f"is another correction of {each.control!r}")
    return tuple(found.values())


def own_corrections(layer: Sdf.Layer) -> tuple[Correction, ...]:
    """Those that a layer holds itself, whether or not what it sublayers is there."""
    alone = Sdf.Layer.CreateAnonymous(".usda")
    alone.TransferContent(layer)
    alone.subLayerPaths.clear()
    return read_corrections(Usd.Stage.Open(alone, Usd.Stage.LoadNone))


def _correction(prim: Usd.Prim) -> Correction:
    refuse_broken(prim, schema.CORRECTION)
    found: dict[str, Any] = {
        field: value_of(prim, schema.CORRECTION, name) for name, field in _FIELDS.items()
    }
    try:
        settings = tomllib.loads(found["settings"])
    except tomllib.TOMLDecodeError as error:
        raise invalid(prim.GetAttribute("rigUI:correction:settings"), str(error)) from None
    return Correction(
        root=str(prim.GetPath().GetParentPath().GetParentPath()),
        reason=str(prim.GetDocumentation() or ""),
        **found
        | {
            "control": found["control"] or prim.GetName(),
            "mesh": next(iter(found["mesh"]), ""),
            "group": tuple(found["group"]),
            "position": tuple(found["position"].tolist()),
            "up": tuple(found["up"].tolist()),
            "settings": settings,
        },
    )


def corrections_text(
    corrections: Iterable[Correction], sublayer: str, metadata: Mapping[str, Any]
) -> str:
    """A layer of corrections over the layer `sublayer`, an asset path, with that one's unit and up
    axis among its `metadata` (`stage_metadata`)."""
    layer = Sdf.Layer.CreateAnonymous(".usda")
    for key in ("upAxis", "metersPerUnit"):
        layer.pseudoRoot.SetInfo(key, metadata[key])
    layer.subLayerPaths.append(sublayer)
    used: dict[str, set[str]] = {}
    for each in corrections:
        holder = Sdf.CreatePrimInLayer(layer, f"{each.root}/{schema.CORRECTIONS}")
        holder.specifier, holder.typeName = Sdf.SpecifierDef, "Scope"
        name = author.identifier(each.control, used.setdefault(each.root, set()))
        spec = author.prim(holder, name, "Scope", (schema.CORRECTION,))
        if each.reason:
            spec.SetInfo("documentation", each.reason)
        values = {key: getattr(each, field) for key, field in _FIELDS.items()}
        lines = (f"{key} = {json.dumps(value)}" for key, value in each.settings.items())
        values |= {"prim": [each.mesh] if each.mesh else [], "settings": "\n".join(lines)}
        author.declare(spec, schema.CORRECTION, values)
    return str(layer.ExportToString())
