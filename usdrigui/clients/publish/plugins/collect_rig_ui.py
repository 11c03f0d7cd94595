"""Finds what is to be published: the layout of every USD character in the context."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pyblish.api

from usdrigui.clients.publish import hook
from usdrigui.pipeline import default_output

_USD = (".usd", ".usda", ".usdc", ".usdz")
_CONTRIBUTION: dict[str, Any] = {
    "contribution_enabled": True,
    "contribution_target_product": "usdAsset",
    "contribution_target_product_init": "asset",
    "contribution_layer": "rig",
    "contribution_in_layer_order": 0,
    "contribution_apply_as_variant": False,
    "contribution_variant_set_name": "{layer}",
    "contribution_variant": "{variant}",
    "contribution_variant_is_default": False,
}
"""Every attribute that AYON's collector of USD contributions reads: a sublayer of the asset's rig
layer."""
_SHARED = ("folderPath", "task", "variant", "stagingDir", "version", "followWorkfileVersion")


class CollectRigUI(pyblish.api.ContextPlugin):
    """One instance of the family ``rigui`` for each character.

    Characters are the files in ``context.data["rigUIAssets"]``, else in the environment variable
    USDRIGUI_PUBLISH (separated as paths are), and those that instances of the families ``rig`` and
    ``character`` name in ``data["usdFile"]``.  An instance may name its layer in
    ``data["rigUILayer"]``; otherwise it is ``CHAR.rigui.usda`` beside the character.

    Under AYON the layout contributes to USD as its rig does, one step stronger: with the rig's own
    attributes where it has any, else as a sublayer of the ``rig`` layer of ``usdAsset``.
    """

    label = "Collect rig UI layouts"
    order = pyblish.api.CollectorOrder + 0.3  # before AYON collects USD contributions, at + 0.35
    hosts = ["*"]  # noqa: RUF012 (Pyblish's own way)

    def process(self, context: Any) -> None:
        """Make the instances."""
        listed = context.data.get("rigUIAssets") or os.environ.get("USDRIGUI_PUBLISH", "").split(
            os.pathsep
        )
        for path in filter(None, map(str, listed)):
            self._add(context, Path(path), {})
        for instance in list(context):
            families = {instance.data.get("family"), *instance.data.get("families", ())}
            path = instance.data.get("usdFile", "")
            if families & {"rig", "character"} and Path(path).suffix.lower() in _USD:
                self._add(context, Path(path), instance.data)

    def _add(self, context: Any, asset: Path, source: Any) -> None:
        product = source.get("productName") or f"usd{asset.stem[:1].upper()}{asset.stem[1:]}"
        instance = context.create_instance(f"{product}RigUI")
        # AYON requires a folder, a product and a variant of each instance; a listed asset goes to
        # the context's folder.
        found = {key: context.data[key] for key in ("folderPath", "task") if key in context.data}
        found |= {key: source[key] for key in _SHARED if key in source}
        instance.data.update({"variant": asset.stem, **found})
        instance.data.update(
            family="rigui",
            families=["rigui", "usd"],
            label=f"{asset.stem}: rig UI layout",
            productName=instance.name,
            productType="usd",
            productBaseType="usd",
            rigUIAsset=str(asset),
            rigUILayer=str(source.get("rigUILayer") or default_output(asset)),
            publish_attributes={hook.COLLECTOR: _contribution(source)},
        )
        self.log.info("layout of %s", asset)


def _contribution(source: Any) -> dict[str, Any]:
    """As the rig contributes, in a layer or variant of the same name, and stronger than it."""
    attributes = _CONTRIBUTION | dict(source.get("publish_attributes", {}).get(hook.COLLECTOR, {}))
    return attributes | {
        "contribution_in_layer_order": attributes["contribution_in_layer_order"] + 1,
        "contribution_variant_is_default": False,
    }
