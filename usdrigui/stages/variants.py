"""Variants: a stage with others selected than it selects itself, and the variant in which a layout
stands."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from pxr import Sdf, Usd

from usdrigui.errors import meant, refuse
from usdrigui.stages.variant_paths import unknown_set


def select(stage: Usd.Stage, wanted: Mapping[str, str]) -> None:
    """Select variants by the names of their sets, in the session layer, wherever a prim has that
    set and variant.

    Raises VARIANT_UNKNOWN for what no prim has.
    """
    if not wanted:
        return
    done: set[tuple[Sdf.Path, str]] = set()
    with Usd.EditContext(stage, stage.GetSessionLayer()):
        while more := [
            each for each in _having(stage, wanted) if each not in done
        ]:  # a variant can bring in sets
            for path, name in more:
                stage.GetPrimAtPath(path).GetVariantSet(name).SetVariantSelection(wanted[name])
            done.update(more)
    for name in wanted.keys() - {name for _, name in done}:
        raise _unknown(stage, name, wanted[name])


def select_unselected(stage: Usd.Stage, within: Iterable[Sdf.Path]) -> None:
    """Of the sets for which nothing is selected, take the first variant on one of the paths
    `within`.

    For a layer that stands alone (``--bare``): only the asset selects a variant.
    """
    with Usd.EditContext(stage, stage.GetSessionLayer()):
        for path in (
            each
            for place in within
            for each in place.GetPrefixes()
            if each.IsPrimVariantSelectionPath()
        ):
            name, variant = path.GetVariantSelection()
            prim = stage.GetPrimAtPath(path.StripAllVariantSelections())
            if prim and not prim.GetVariantSets().GetVariantSelection(name):
                prim.GetVariantSets().SetSelection(name, variant)


def variant_sets(stage: Usd.Stage) -> dict[str, tuple[str, ...]]:
    """The variants of every set on the stage, by the name of the set: the one that is selected
    first, as that is what others are like; those of prims that share a name together."""
    found: dict[str, dict[str, None]] = {}
    for prim in _prims(stage):
        for name in prim.GetVariantSets().GetNames():
            own = prim.GetVariantSet(name)
            there = own.GetVariantNames()
            first = [each for each in there if each == own.GetVariantSelection()]
            found.setdefault(name, {}).update(dict.fromkeys([*first, *there]))
    return {name: tuple(variants) for name, variants in found.items()}


def variant_path(prim: Usd.Prim) -> str:
    """The path of a prim with all selections at it and above:
    ``/Char{LOD=low}{costume=plain}Head``."""
    path = Sdf.Path.absoluteRootPath
    for each in prim.GetPath().GetPrefixes():
        path = path.AppendChild(each.name)
        sets = prim.GetStage().GetPrimAtPath(each).GetVariantSets()
        for name in sets.GetNames():
            if sets.GetVariantSelection(name):
                path = path.AppendVariantSelection(name, sets.GetVariantSelection(name))
    return str(path)


def _having(stage: Usd.Stage, wanted: Mapping[str, str]) -> Iterator[tuple[Sdf.Path, str]]:
    for prim in _prims(stage):
        sets = prim.GetVariantSets()
        for name in wanted.keys() & set(sets.GetNames()):
            if wanted[name] in sets.GetVariantSet(name).GetVariantNames():
                yield prim.GetPath(), name


def _prims(stage: Usd.Stage) -> Usd.PrimRange:
    return Usd.PrimRange.Stage(stage, Usd.PrimAllPrimsPredicate)


def _unknown(stage: Usd.Stage, name: str, variant: str) -> Exception:
    sets = variant_sets(stage)
    if name not in sets:
        return unknown_set(name, sets)
    known = f"it has {', '.join(sets[name])}{meant(variant, sets[name])}"
    return refuse(
        "VARIANT_UNKNOWN", name, f"no prim has the variant {variant!r} in this set; {known}"
    )
