"""Every variant of the sets that the settings name, each as settings of its own."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import TypeVar

from usdrigui.errors import NO_LAYOUT, Issue, RigUIError, issue
from usdrigui.settings import Settings
from usdrigui.settings.parts import ReadSettings
from usdrigui.stages.variant_paths import unknown_set

T = TypeVar("T")

_PLAIN = ("SKELROOT_MISSING", "CONTROLS_MISSING", *NO_LAYOUT, "VARIANT_UNKNOWN")
"""What a variant without a character, or without a layout, is refused for; combinations need not
all be there."""


def in_each_variant(
    settings: Settings,
    read: Callable[[], Mapping[str, tuple[str, ...]]],
    act: Callable[[Settings], T],
) -> tuple[list[T], tuple[Issue, ...]]:
    """What is found in each variant, and that the others are left off, as they have no character or
    no layout; `read` is asked for the variants by the name of their set, if there are to be any.

    Raises what `act` raises for another reason, or everywhere, and as `each_variant`.
    """
    found: list[T] = []
    plain, refusals, sets = [], [], read() if settings.read.each_variant else {}
    for chosen in each_variant(settings, sets):
        try:
            found.append(act(chosen))
        except RigUIError as error:
            plain.append(left_off(error, chosen.read))
            refusals.append(error)
    if not found:
        raise refusals[0]
    return found, tuple(plain)


def each_variant(settings: Settings, sets: Mapping[str, tuple[str, ...]]) -> Iterator[Settings]:
    """The settings with each combination of variants of `read.each_variant` selected; as they are
    without any.

    `sets`: all variants by the name of their set.  Raises VARIANT_UNKNOWN for a set that is not
    there.
    """
    read = settings.read
    for name in read.each_variant:
        if name not in sets:
            raise unknown_set(name, sets)
    choices = [
        sets[name] if name not in read.variants else (read.variants[name],)
        for name in read.each_variant
    ]
    for chosen in itertools.product(*choices):
        yield selecting(
            settings, {**read.variants, **dict(zip(read.each_variant, chosen, strict=True))}
        )


def selecting(settings: Settings, variants: Mapping[str, str]) -> Settings:
    """The settings with these variants selected, by the names of their sets."""
    return replace(settings, read=replace(settings.read, variants=variants))


def left_off(error: RigUIError, settings: ReadSettings) -> Issue:
    """That the variant selected is left off, as it has no character; raises the error again where
    it is another."""
    if not settings.each_variant or error.issue.code not in _PLAIN:
        raise error
    return issue(
        "VARIANT_LEFT_OFF",
        selection(settings.variants),
        f"{error.issue.code}: {error.issue.message}",
    )


def selection(variants: Mapping[str, str]) -> str:
    """The variants that are selected, as USD writes them: ``{LOD=low}``."""
    return "".join(f"{{{name}={variant}}}" for name, variant in variants.items())
