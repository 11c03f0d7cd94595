"""What USD imports when it loads our plug-in: registers the validators."""

from __future__ import annotations

from typing import Any

from pxr import Plug, Sdf, Usd, UsdGeom, UsdSkel, UsdValidation

from usdrigui.clients.usd_validation import NAME
from usdrigui.errors import Issue, sentences
from usdrigui.reader import faults

_KINDS = {
    "error": UsdValidation.ValidationErrorType.Error,
    "warning": UsdValidation.ValidationErrorType.Warn,
    "info": UsdValidation.ValidationErrorType.Info,
}


def _of_prim(prim: Usd.Prim, kind: Any) -> list[Any]:
    found = faults.prim_faults(prim) if prim.IsA(kind) else ()
    return [_as_error(each, prim.GetStage(), prim.GetPath()) for each in found]


def _layouts(stage: Usd.Stage, *_: Any) -> list[Any]:
    root = stage.GetPseudoRoot().GetPath()
    return [_as_error(each, stage, root) for each in faults.layout_faults(stage)]


def _as_error(found: Issue, stage: Usd.Stage, owner: Sdf.Path) -> Any:
    """One finding, at the prim that was looked at and, where it is another, at the prim that it is
    about."""
    sites = [UsdValidation.ValidationErrorSite(stage, owner)]
    if found.path.startswith("/") and found.path != str(owner) and stage.GetPrimAtPath(found.path):
        sites.append(UsdValidation.ValidationErrorSite(stage, Sdf.Path(found.path)))
    message = f"{found.where}: {sentences(found)}"
    return UsdValidation.ValidationError(found.code, _KINDS[found.severity], sites, message)


def _register(kind: str, tasks: str, function: Any) -> None:
    """One validator: as the plug-in that `plugInfo.json` describes, or else by its metadata alone.

    A registry reads the metadata of plug-ins when it is made; what is known to it later must bring
    its own.
    """
    registry = UsdValidation.ValidationRegistry()
    name = f"{NAME}:{kind}"
    if name in {each.name for each in registry.GetAllValidatorMetadata()}:
        getattr(registry, f"RegisterPlugin{tasks}Validator")(name, function)
        return
    plugin = Plug.Registry().GetPluginWithName(NAME)
    described = plugin.metadata["Validators"]
    metadata = UsdValidation.ValidatorMetadata(
        name=name, plugin=plugin, keywords=described["keywords"], doc=described[kind]["doc"]
    )
    getattr(registry, f"Register{tasks}Validator")(metadata, function)


# USD keeps lambdas alive, and of other functions no more than weak references.
_register("BlendShapes", "Prim", lambda prim, *_: _of_prim(prim, UsdGeom.Mesh))
_register("ShapeWeights", "Prim", lambda prim, *_: _of_prim(prim, UsdSkel.Animation))
_register("Layouts", "Stage", _layouts)
