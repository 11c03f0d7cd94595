"""Stages that are open already: read in this process, as they are, unsaved edits and all.

Whoever has opened a stage has parsed its files, so that nothing is left that a reader of its own
could die of.
"""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING

from pxr import Sdf, Usd

from usdrigui.layer.read_layout import read_layout
from usdrigui.model import Layout
from usdrigui.reader.reader_main import read_composed, read_result
from usdrigui.reader.reader_records import ReadResult
from usdrigui.reading.character import read_characters
from usdrigui.settings import Settings
from usdrigui.stages.variants import select, variant_sets

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping


def read_open_rigs(source: Usd.Stage | Sdf.Layer, settings: Settings) -> ReadResult:
    """What an open stage or layer holds; raises as `usdrigui.reading.character.read_rigs`."""
    stage = _copy(source, settings.read.variants)
    return read_result(stage, read_characters(stage, settings))


def read_open_layouts(
    source: Usd.Stage | Sdf.Layer, settings: Settings
) -> tuple[tuple[Layout, ...], ReadResult]:
    """The layouts on an open stage and their characters.

    Raises LAYOUT_MISSING, LAYOUT_STALE and as `read_open_rigs`.
    """
    stage = _copy(source, settings.read.variants)
    layouts = read_layout(stage)
    laid_out = {each.root for each in layouts}
    return layouts, read_composed(stage, settings, laid_out)


def read_open_variants(
    source: Usd.Stage | Sdf.Layer, variants: Mapping[str, str]
) -> dict[str, tuple[str, ...]]:
    """The variants of every set on an open stage or layer; raises VARIANT_UNKNOWN."""
    return variant_sets(_copy(source, variants))


def _copy(source: Usd.Stage | Sdf.Layer, variants: Mapping[str, str]) -> Usd.Stage:
    """The same layers composed once more as they are on the caller's stage, whatever is tried on
    it: with what is muted, loaded, masked and edited in its session layer."""
    session = Sdf.Layer.CreateAnonymous()
    if isinstance(source, Sdf.Layer):
        stage = Usd.Stage.Open(source, session)
    else:
        edited = source.GetSessionLayer()
        if edited is not None and edited.identifier not in source.GetMutedLayers():
            _bring_in(session, edited, source.GetTimeCodesPerSecond())
        with _variant_fallbacks(source):
            stage = Usd.Stage.OpenMasked(
                source.GetRootLayer(),
                session,
                source.GetPathResolverContext(),
                source.GetPopulationMask(),
                Usd.Stage.LoadNone,
            )
        stage.MuteAndUnmuteLayers(source.GetMutedLayers(), [])
        stage.SetLoadRules(source.GetLoadRules())
        stage.SetInterpolationType(source.GetInterpolationType())
    select(stage, variants)
    return stage


def _bring_in(session: Sdf.Layer, edited: Sdf.Layer, rate: float) -> None:
    """Put the session layer of a stage of so many time codes per second below that of its copy,
    where its relative paths hold and it can be muted; stage metadata counts in the upper one
    alone."""
    for key in edited.pseudoRoot.ListInfoKeys():
        if key not in ("subLayers", "subLayerOffsets"):
            session.pseudoRoot.SetInfo(key, edited.pseudoRoot.GetInfo(key))
    session.subLayerPaths.append(edited.identifier)
    # Its times are the stage's, which USD scales in a sublayer that does not say so.
    session.subLayerOffsets[0] = Sdf.LayerOffset(scale=edited.timeCodesPerSecond / rate)


@contextlib.contextmanager
def _variant_fallbacks(source: Usd.Stage) -> Iterator[None]:
    """The variants that the stage has where none is authored: fallbacks belong to the process, and
    a stage keeps those of the time when it was opened."""
    before = Usd.Stage.GetGlobalVariantFallbacks()
    fallbacks: dict[str, list[str]] = {}
    for prim in Usd.PrimRange.Stage(source, Usd.TraverseInstanceProxies()):
        sets = prim.GetVariantSets()
        for name in sets.GetNames():
            chosen = sets.GetVariantSet(name)
            if chosen.GetVariantSelection() and not chosen.HasAuthoredVariantSelection():
                fallbacks[name] = [chosen.GetVariantSelection()]
    Usd.Stage.SetGlobalVariantFallbacks(fallbacks)
    try:
        yield
    finally:
        Usd.Stage.SetGlobalVariantFallbacks(before)
