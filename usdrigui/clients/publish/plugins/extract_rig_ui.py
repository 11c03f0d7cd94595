"""Adds the layout to what is published."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import pyblish.api

from usdrigui.clients.publish import hook


class ExtractRigUI(pyblish.api.InstancePlugin):
    """The layout as a representation: a bare copy of the layer, staged, so that it can lie over any
    rig layer.

    The representation is called ``usd``, as AYON's USD contributions look for that name.
    """

    label = "Extract rig UI layout"
    order = pyblish.api.ExtractorOrder
    families = ["rigui"]  # noqa: RUF012 (Pyblish's own way)

    def process(self, instance: Any) -> None:
        """Stage the file and name it."""
        folder = instance.data.get("stagingDir") or tempfile.mkdtemp(prefix="rigui-")
        instance.data["stagingDir"] = str(folder)
        staged = hook.stage(Path(instance.data["rigUILayer"]), Path(folder))
        representation = {
            "name": "usd",
            "ext": staged.suffix.removeprefix("."),
            "files": staged.name,
            "stagingDir": str(folder),
        }
        instance.data.setdefault("representations", []).append(representation)
        self.log.info("staged %s", staged)
