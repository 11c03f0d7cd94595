"""Stops the publish of a layout that is missing, stale or invalid."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pyblish.api

from usdrigui.clients.publish import hook
from usdrigui.clients.publish.framework import (
    OptionalPyblishPluginMixin,
    PublishValidationError,
    RepairAction,
)
from usdrigui.errors import by_cause, sentences


class ValidateRigUI(pyblish.api.InstancePlugin, OptionalPyblishPluginMixin):
    """The layout fits the present character, and every handle can be distinguished and grabbed.

    Runs `usdrigui check`.  The repair action lays the character out again; hand-made changes of the
    layer are lost by it, so look at `usdrigui check` first where there are any.
    """

    label = "Rig UI layout fits its rig"
    order = pyblish.api.ValidatorOrder
    families = ["rigui"]  # noqa: RUF012 (Pyblish's own way)
    actions = [RepairAction]  # noqa: RUF012
    optional = True

    def process(self, instance: Any) -> None:
        """Raise what is found, a line for each cause; nothing where the publisher has switched the
        check off."""
        if not self.is_active(instance.data):
            return
        asset, layer = Path(instance.data["rigUIAsset"]), Path(instance.data["rigUILayer"])
        found = hook.judge(asset, layer, hook.root_of(instance.data))
        causes = by_cause(found)
        for each in causes:
            self.log.error("%s %s: %s", each.code, each.where, sentences(each))
        if causes:
            first = f"{causes[0].code} {causes[0].where}: {causes[0].message}"
            raise PublishValidationError(
                first, title=hook.TITLE, description=hook.described(asset, found)
            )

    @classmethod
    def repair(cls, instance: Any) -> None:
        """Lay the character out again."""
        outcome = hook.repair(Path(instance.data["rigUIAsset"]), Path(instance.data["rigUILayer"]))
        cls.log.info("%s %s", outcome, instance.data["rigUILayer"])
