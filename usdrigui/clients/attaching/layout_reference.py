"""A layout as a reference of its asset, in the variant ``rigUI = ui``: a shot that does not select
that opens no file of it.

No payload, which does the same: a payload of the SkelRoot would hide the whole character from those
who load none.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from pxr import Sdf

from usdrigui.errors import refuse
from usdrigui.layer.write_layout import author_variant
from usdrigui.stages import schema
from usdrigui.stages.opening import spec_paths
from usdrigui.stages.variant_paths import asset_selections


@dataclass(frozen=True)
class ReferenceOf:
    """A reference in the variant ``rigUI = ui`` of a SkelRoot."""

    root: str
    path: str
    """As it stands in the asset's root layer."""


def references_of(asset: Sdf.Layer, leads: Callable[[str], bool]) -> tuple[ReferenceOf, ...]:
    """The references in variants ``rigUI = ui`` of a layer whose asset path `leads` to a layout."""
    return tuple(
        ReferenceOf(str(path.StripAllVariantSelections()), each.assetPath)
        for path in spec_paths(asset)
        if path.IsPrimVariantSelectionPath()
        and path.GetVariantSelection() == (schema.VARIANTS, schema.WITH)
        for each in asset.GetPrimAtPath(path).referenceList.GetAddedOrExplicitItems()
        if leads(each.assetPath)
    )


def check_reachable(layer: Path, opened: Sdf.Layer, variant_path: str, root: str) -> None:
    """Refuse with ATTACH_OUTSIDE a layout that a reference of its SkelRoot would bring in without
    the prims and variants that it refers to."""
    above = Sdf.Path(variant_path or root)
    if asset_selections(str(above.GetPrimPath().GetParentPath())):
        raise refuse("ATTACH_OUTSIDE", layer, f"is authored in a variant above {root}")

    for path in spec_paths(opened, root):
        if path.IsTargetPath() and not path.targetPath.HasPrefix(Sdf.Path(root)):
            raise refuse("ATTACH_OUTSIDE", layer, f"refers to {path.targetPath}")


# --- of specs -------------------------------------------------------------------------------------


def add(asset: Sdf.Layer, references: Sequence[ReferenceOf]) -> None:
    """Author the references, with the variants that hold them, ``none`` selected."""
    for reference in references:
        variant = author_variant(asset, reference.root)
        variant.referenceList.Prepend(Sdf.Reference(reference.path, reference.root))
        asset.GetPrimAtPath(reference.root).variantSelections[schema.VARIANTS] = schema.WITHOUT


def remove(asset: Sdf.Layer, references: Sequence[ReferenceOf]) -> None:
    """Take the references out, with the variants and the overs that are empty then."""
    for each in references:
        prim = asset.GetPrimAtPath(each.root)
        variants = prim.variantSets[schema.VARIANTS].variants
        listed = variants[schema.WITH].primSpec.referenceList
        for item in listed.GetAddedOrExplicitItems():
            if item.assetPath == each.path:
                listed.RemoveItemEdits(item)
        if all(_empty(variant.primSpec) for variant in variants):
            del prim.variantSets[schema.VARIANTS]
            prim.variantSetNameList.RemoveItemEdits(schema.VARIANTS)
            del prim.variantSelections[schema.VARIANTS]
        while prim.path != Sdf.Path.absoluteRootPath and _empty(prim):
            parent = asset.GetPrimAtPath(prim.path.GetParentPath())
            del parent.nameChildren[prim.name]
            prim = parent


def _empty(prim: Sdf.PrimSpec) -> bool:
    return bool(prim.specifier == Sdf.SpecifierOver and prim.isInert)
