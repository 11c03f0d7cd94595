"""Our checks as rules of NVIDIA's asset validator (PyPI usd-validation-nvidia, or omniverse-asset-validator).

Importing this module registers them in the category "Usd:RigUI":

    import usdrigui.clients.asset_validator
    omni.asset_validator.ValidationEngine().validate("char.usda")
"""

from __future__ import annotations

from typing import Any

from omni.asset_validator import BaseRuleChecker, Suggestion, register_rule
from pxr import Usd, UsdGeom, UsdSkel

from usdrigui.errors import Issue, sentences
from usdrigui.usd import faults

CATEGORY = "Usd:RigUI"
_REPAIRABLE = ("TARGET_INVALID", "TOKEN_REPEATED", "TOKEN_ORDER")


@register_rule(CATEGORY)
class BlendShapeChecker(BaseRuleChecker):
    """Blend shapes are what UsdSkel can use: names and targets in pairs, arrays of the right length, finite numbers.

    Found besides: in-betweens without a weight of their own, names that stand twice, an order other than
    the animation's, and weights outside the limits that the animation states.  Pairs that UsdSkel ignores
    can be dropped, and the order changed, by the suggestion.
    """

    def CheckPrim(self, prim: Usd.Prim) -> None:  # noqa: N802 (the validator's own name)
        """Look at meshes and SkelAnimations."""
        if prim.IsA(UsdGeom.Mesh):
            for found in faults.mesh_faults(prim):
                fixable = found.code in _REPAIRABLE and faults.can_repair(prim)
                suggestion = Suggestion(_repair, "Drop unusable pairs, use the animation's order") if fixable else None
                _tell(self, found, prim, suggestion)
        elif prim.IsA(UsdSkel.Animation):
            for found in faults.animation_faults(prim):
                _tell(self, found, prim, None)


@register_rule(CATEGORY)
class RigUILayoutChecker(BaseRuleChecker):
    """Layouts of usdrigui fit the meshes on which they stand; `usdrigui process` makes them anew."""

    def CheckStage(self, usdStage: Usd.Stage) -> None:  # noqa: N802, N803 (the validator's own names)
        """Look at every layout of the stage."""
        for found in faults.layout_faults(usdStage):
            prim = usdStage.GetPrimAtPath(found.path) if found.path.startswith("/") else None
            _tell(self, found, prim or usdStage, None)


def _tell(rule: Any, found: Issue, at: Any, suggestion: Any) -> None:
    """One finding by its severity; the validator has no notes, so infos are warnings."""
    message = f"{found.code} {found.path}: {sentences(found)}"
    tell = rule._AddFailedCheck if found.severity == "error" else rule._AddWarning  # noqa: SLF001 (the way rules report)
    tell(message, at=at, suggestion=suggestion)


def _repair(_: Usd.Stage, prim: Usd.Prim) -> None:
    faults.repair(prim)
