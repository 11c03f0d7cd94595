"""Paths that hold selections of variants, ``/Char{LOD=low}Head``, as text: what needs no USD."""

from __future__ import annotations

import re
from collections.abc import Collection

from usdrigui.usd import schema

_SELECTION = re.compile(r"\{([^={}]+)=([^{}]*)\}")


def asset_selections(path: str) -> dict[str, str]:
    """The variants that a path holds selections of, by the names of their sets; not that of our own set."""
    return {name: variant for name, variant in _SELECTION.findall(path) if name != schema.VARIANTS}


def with_sets(path: str, names: Collection[str]) -> str:
    """The path with the selections of those sets alone; empty where it has none of them."""
    kept = _SELECTION.sub(lambda found: found[0] if found[1] in names else "", path)
    return kept if "{" in kept else ""
