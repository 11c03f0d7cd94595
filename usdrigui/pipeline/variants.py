"""Every variant of the sets that the settings name, each as settings of its own."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import replace

from usdrigui.errors import Issue, RigUIError, issue, meant, refuse
from usdrigui.settings import Settings

_PLAIN = ("SKELROOT_MISSING", "CONTROLS_MISSING", "LAYOUT_MISSING", "VARIANT_UNKNOWN")
"""What a variant without a character, or without a layout, is refused for; combinations need not all be there."""


def each_variant(settings: Settings, sets: Mapping[str, tuple[str, ...]]) -> Iterator[Settings]:
    """The settings with each combination of variants of `read.each_variant` selected; as they are without any.

    `sets`: all variants by the name of their set.  Raises VARIANT_UNKNOWN for a set that is not there.
    """
    read = settings.read
    for name in read.each_variant:
        if name not in sets:
            known = f"the sets are: {', '.join(sets)}" if sets else "the stage has no variant set"
            raise refuse("VARIANT_UNKNOWN", name, f"no prim has this variant set; {known}{meant(name, sets)}")
    choices = [sets[name] if name not in read.variants else (read.variants[name],) for name in read.each_variant]
    for chosen in itertools.product(*choices):
        variants = {**read.variants, **dict(zip(read.each_variant, chosen, strict=True))}
        yield replace(settings, read=replace(read, variants=variants))


def left_off(error: RigUIError, settings: Settings) -> Issue:
    """That the variant selected is left off, as it has no character; raises the error again where it is another."""
    if not settings.read.each_variant or error.issue.code not in _PLAIN:
        raise error
    return issue("VARIANT_LEFT_OFF", selection(settings), f"{error.issue.code}: {error.issue.message}")


def selection(settings: Settings) -> str:
    """The variants that are selected, as USD writes them: ``{LOD=low}``."""
    return "".join(f"{{{name}={variant}}}" for name, variant in settings.read.variants.items())
