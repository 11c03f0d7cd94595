"""Our checks as rules of NVIDIA's asset validator (PyPI usd-validation-nvidia).

The validator finds them by the entry point of this distribution, in the category "Usd:RigUI".
Where Python does not know what is installed (a package that was only put on the path), importing
this module registers them.
"""

from __future__ import annotations

from typing import Any

from pxr import Usd
from usd_validation_nvidia import BaseRuleChecker, register_rule

from usdrigui.errors import Issue, sentences
from usdrigui.reader import faults

CATEGORY = "Usd:RigUI"


@register_rule(CATEGORY)
class BlendShapeChecker(BaseRuleChecker):
    """Blend shapes are what UsdSkel can use: names and targets in pairs, arrays of the right
    length, finite numbers.

    Found besides: in-betweens without a weight of their own, names that are listed twice, and
    weights outside the limits of the animation.
    """

    def CheckPrim(self, prim: Usd.Prim) -> None:  # noqa: N802 (the validator's own name)
        """Look at meshes and SkelAnimations."""
        for found in faults.prim_faults(prim):
            _tell(self, found, prim)


@register_rule(CATEGORY)
class RigUILayoutChecker(BaseRuleChecker):
    """Layouts of usdrigui fit the meshes that they are anchored to; `usdrigui process` makes them
    anew."""

    # The names are the validator's.
    def CheckStage(self, usdStage: Usd.Stage) -> None:  # noqa: N802, N803
        """Look at every layout of the stage."""
        for found in faults.layout_faults(usdStage):
            prim = usdStage.GetPrimAtPath(found.path) if found.path.startswith("/") else None
            _tell(self, found, prim or usdStage)


class Rules:
    """What the entry point names: the import of this module has registered the rules already."""

    def on_startup(self) -> None:
        """Called by the validator when it starts."""

    def on_shutdown(self) -> None:
        """Called by the validator when it ends; rules go with its registry."""


def _tell(rule: Any, found: Issue, at: Any) -> None:
    """One finding by its severity; the validator has no notes, so infos are warnings."""
    message = f"{found.code} {found.where}: {sentences(found)}"
    # Rules report in this way.
    tell = rule._AddFailedCheck if found.severity == "error" else rule._AddWarning  # noqa: SLF001
    tell(message, at=at)
