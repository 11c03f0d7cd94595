"""Stages that are open already: read in this process, as they are, unsaved edits and all.

Whoever has opened a stage has parsed its files, so that nothing is left that a reader of its own
could die of.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from pxr import Sdf, Usd

from usdrigui.model import Layout
from usdrigui.reading.character import read_characters
from usdrigui.settings import Settings
from usdrigui.stages.variants import select, variant_sets
from usdrigui.usd.contradictions import contradictions
from usdrigui.usd.existing_layouts import without_layout
from usdrigui.usd.read_layout import composed_layouts, listed_controls, own_layouts, read_layout
from usdrigui.usd.reader_main import cameras_toward
from usdrigui.usd.reader_records import ReadResult

if TYPE_CHECKING:
    from collections.abc import Collection, Mapping


def read_open_rigs(source: Usd.Stage | Sdf.Layer, settings: Settings) -> ReadResult:
    """What an open stage or layer holds; raises as `usdrigui.reading.character.read_rigs`."""
    stage = _copy(source, settings.rig.read.variants)
    return _result(stage, settings, own_layouts(stage), None)


def read_open_layouts(
    source: Usd.Stage | Sdf.Layer, settings: Settings
) -> tuple[tuple[Layout, ...], ReadResult]:
    """The layouts on an open stage and their characters.

    Raises LAYOUT_MISSING, LAYOUT_STALE and as `read_open_rigs`.
    """
    stage = _copy(source, settings.rig.read.variants)
    layouts = read_layout(stage)
    return layouts, _result(stage, settings, (), {each.character.root for each in layouts})


def _result(
    stage: Usd.Stage, settings: Settings, layouts: tuple[str, ...], laid_out: Collection[str] | None
) -> ReadResult:
    from usdrigui.usd.layer import stage_metadata

    found = read_characters(stage, settings.rig, laid_out)
    cameras = cameras_toward(stage, found.rigs, settings.layout.candidates.view)
    return ReadResult(
        found.rigs,
        stage_metadata(stage.GetRootLayer()),
        cameras,
        (),
        layouts,
        "",
        composed_layouts(stage),
        without_layout=()
        if laid_out is None
        else without_layout(stage, laid_out, settings.rig.read.skel_root),
        lost=found.lost,
        contradictions=() if laid_out is None else contradictions(stage),
        listed={} if laid_out is None else listed_controls(stage),
        config_faults=found.faults.issues,
    )


def read_open_variants(
    source: Usd.Stage | Sdf.Layer, variants: Mapping[str, str]
) -> dict[str, tuple[str, ...]]:
    """The variants of every set on an open stage or layer; raises VARIANT_UNKNOWN."""
    return variant_sets(_copy(source, variants))


def _copy(source: Usd.Stage | Sdf.Layer, variants: Mapping[str, str]) -> Usd.Stage:
    """The same layers composed once more: whatever is tried on that stage, the caller's is left
    alone."""
    session = Sdf.Layer.CreateAnonymous()
    if isinstance(source, Sdf.Layer):
        stage = Usd.Stage.Open(source, session)
    else:
        session.TransferContent(source.GetSessionLayer())
        stage = Usd.Stage.Open(source.GetRootLayer(), session, source.GetPathResolverContext())
    select(stage, variants)
    return stage
