"""Finds what is to be published: the layout of every USD character in the context."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pyblish.api

from usdrigui.pipeline import default_output

_USD = (".usd", ".usda", ".usdc", ".usdz")
_CONTRIBUTION = {
    "contribution_enabled": True,
    "contribution_layer": "rig",
    "contribution_in_layer_order": 10,
    "contribution_apply_as_variant": False,
    "contribution_target_product": "usdAsset",
    "contribution_target_product_init": "asset",
}
"""What AYON's CollectUSDLayerContributions reads: a sublayer of the rig department's layer, above the rig itself."""


class CollectRigUI(pyblish.api.ContextPlugin):
    """One instance of the family ``rigui`` for each character.

    Characters are the files in ``context.data["rigUIAssets"]``, else in the environment variable
    USDRIGUI_PUBLISH (separated as paths are), and those that instances of the families ``rig`` and
    ``character`` name in ``data["usdFile"]``.  An instance may name its layer in ``data["rigUILayer"]``;
    otherwise it is ``CHAR.rigui.usda`` beside the character.
    """

    label = "Collect rig UI layouts"
    order = pyblish.api.CollectorOrder + 0.3  # before AYON collects USD contributions, at + 0.35
    hosts = ["*"]  # noqa: RUF012 (Pyblish's own way)

    def process(self, context: Any) -> None:
        """Make the instances."""
        listed = context.data.get("rigUIAssets") or os.environ.get("USDRIGUI_PUBLISH", "").split(os.pathsep)
        for path in filter(None, map(str, listed)):
            self._add(context, Path(path), {})
        for instance in list(context):
            families = {instance.data.get("family"), *instance.data.get("families", ())}
            path = instance.data.get("usdFile", "")
            if families & {"rig", "character"} and Path(path).suffix.lower() in _USD:
                self._add(context, Path(path), instance.data)

    def _add(self, context: Any, asset: Path, source: Any) -> None:
        name = f"{asset.stem}RigUI"
        instance = context.create_instance(name)
        shared = {key: source[key] for key in ("folderPath", "task", "stagingDir", "version") if key in source}
        instance.data.update(shared)
        instance.data.update(
            family="rigui",
            families=["rigui", "usd"],
            label=f"{asset.stem}: rig UI layout",
            productName=f"usd{name[0].upper()}{name[1:]}",
            rigUIAsset=str(asset),
            rigUILayer=str(source.get("rigUILayer") or default_output(asset)),
            publish_attributes={"CollectUSDLayerContributions": dict(_CONTRIBUTION)},
        )
        self.log.info("layout of %s", asset)
