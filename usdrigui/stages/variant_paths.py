"""Paths that hold selections of variants, ``/Char{LOD=low}Head``, and refusals of sets that no
stage has."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping

from usdrigui.errors import RigUIError, meant, refuse
from usdrigui.stages import schema

_SELECTION = re.compile(r"\{([^={}]+)=([^{}]*)\}")


def asset_selections(path: str) -> dict[str, str]:
    """The variants that a path holds selections of, by the names of their sets; not that of our own
    set."""
    return {name: variant for name, variant in _SELECTION.findall(path) if name != schema.VARIANTS}


def unknown_set(name: str, sets: Mapping[str, Collection[str]]) -> RigUIError:
    """VARIANT_UNKNOWN for a set that is none of the `sets` of a stage."""
    known = f"the sets are: {', '.join(sets)}" if sets else "the stage has no variant set"
    return refuse(
        "VARIANT_UNKNOWN", name, f"no prim has this variant set; {known}{meant(name, sets)}"
    )


def with_sets(path: str, names: Collection[str]) -> str:
    """The path with the selections of those sets alone; empty where it has none of them."""
    kept = _SELECTION.sub(lambda found: found[0] if found[1] in names else "", path)
    return kept if "{" in kept else ""
