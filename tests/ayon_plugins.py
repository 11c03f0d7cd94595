"""Plug-ins that read publish instances as those of ayon-core 1.9 do: the same keys, without defaults where it has none.

Order and keys are those of CollectUSDLayerContributions, CollectAnatomyInstanceData and the USD extractors;
the server, the anatomy and the layers that they write are left out.
"""

import pyblish.api

CONTRIBUTION = {
    "contribution_enabled": True,
    "contribution_layer": "rig",
    "contribution_target_product": "usdAsset",
    "contribution_target_product_init": "asset",
    "contribution_in_layer_order": 0,
    "contribution_apply_as_variant": False,
    "contribution_variant_set_name": "{layer}",
    "contribution_variant": "{variant}",
    "contribution_variant_is_default": False,
}
"""What the collector's attribute definitions give every instance of the family `usd`."""
_LAYERS = {"asset": {"model": 100, "look": 200, "rig": 300}, "shot": {"layout": 200}}


def created(product, base_type):
    """Data of an instance as AYON's creators and its CollectFromCreateContext leave it."""
    return {
        "publish": True,
        "name": product,
        "label": product,
        "folderPath": "/assets/hero",
        "task": "rigging",
        "variant": "Main",
        "productName": product,
        "productType": base_type,
        "productBaseType": base_type,
        "family": base_type,
        "families": [base_type, "usd"],
        "representations": [{"name": "usd", "ext": "usd", "files": f"{product}.usd", "stagingDir": "."}],
    }


class CollectUSDLayerContributions(pyblish.api.InstancePlugin):
    order = pyblish.api.CollectorOrder + 0.35
    families = ["usd"]  # noqa: RUF012 (Pyblish's own way)

    def process(self, instance):
        said = dict(instance.data.get("publish_attributes", {}).get(type(self).__name__, {}))
        if not said.get("contribution_enabled"):
            return
        known = {**instance.data, "layer": said["contribution_layer"]}
        names = [said[f"contribution_{key}"].format(**known) for key in ("variant_set_name", "variant")]
        as_variant = said["contribution_apply_as_variant"]
        if as_variant:
            assert said["contribution_variant_is_default"] in (True, False)
        layer = f"{said['contribution_target_product']}_{said['contribution_layer']}"
        target = self._instance(instance, layer)
        target.data["usd_layer_order"] = _LAYERS[said["contribution_target_product_init"]][said["contribution_layer"]]
        target.data["usd_contributions"].append(
            {
                "instance": instance,
                "product": instance.data["productName"],
                "order": said.get("contribution_in_layer_order", 0),
                "variant": tuple(names) if as_variant else None,
            }
        )

    def _instance(self, source, product):
        for each in source.context:
            if (each.data.get("folderPath"), each.data.get("productName")) == (source.data["folderPath"], product):
                return each
        made = source.context.create_instance(product)
        made.data.update(created(product, "usd"), folderPath=source.data["folderPath"], usd_contributions=[])
        made.data["publish_attributes"] = {}
        return made


class CollectAnatomyInstanceData(pyblish.api.ContextPlugin):
    order = pyblish.api.CollectorOrder + 0.49

    def process(self, context):
        for instance in context:
            data = instance.data
            product = {"name": data["productName"], "type": data["productType"]}
            data["version"] = data.get("version") or 1
            data["anatomyData"] = {"folder": data["folderPath"], "product": product, "label": data["name"]}


class ExtractUSDLayerContribution(pyblish.api.InstancePlugin):
    order = pyblish.api.ExtractorOrder + 0.45

    def process(self, instance):
        for contribution in instance.data.get("usd_contributions", []):
            source = contribution["instance"].data
            assert "usd" in {each["name"] for each in source["representations"]}
            product = source["anatomyData"]["product"]["name"]
            # The path is formed before the file is there: the extension is taken to be the representation's name.
            contribution["path"] = f"{product}_v{source['version']:03d}.usd"
            (extension,) = {each["ext"] for each in source["representations"] if each["name"] == "usd"}
            assert contribution["path"].endswith(f".{extension}"), "the layer would refer to a file that is not there"


PLUGINS = (CollectUSDLayerContributions, CollectAnatomyInstanceData, ExtractUSDLayerContribution)
