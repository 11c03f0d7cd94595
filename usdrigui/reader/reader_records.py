"""What a reader is asked and what it answers: plain records that both sides of
`usdrigui.reader.reader_process` know."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import Any, Generic, Literal, TypeVar

from usdrigui.character import Record, Rig
from usdrigui.errors import Issue
from usdrigui.isolation.foreign_file import SourceFile
from usdrigui.model import Correction, ExistingPrim, Layout
from usdrigui.settings import Settings

Task = Literal[
    "rigs", "layouts", "composed", "clips", "faults", "layer", "variants", "bake", "told", "merged"
]

Result = TypeVar("Result")


class ReadResult(Record):
    """What an asset holds."""

    rigs: tuple[Rig, ...]
    metadata: Mapping[str, Any]
    """What a layer over the asset must repeat (`usdrigui.layer.write_layout.stage_metadata`),
    as JSON values."""
    sources: tuple[SourceFile, ...]
    """Every file that composed it, the asset first."""
    layouts: tuple[str, ...] = ()
    """Scopes of the layouts that its root layer authors itself."""
    below: str = ""
    """The asset that such a root layer sublayers; empty if it has none."""
    composed_from: Mapping[str, str] = field(default_factory=dict)
    """By SkelRoot, the file of the layout that another layer of it brings in."""
    switched_off: tuple[str, ...] = ()
    """SkelRoots with a layout that the variant selected leaves out."""
    variant_paths: Mapping[str, str] = field(default_factory=dict)
    """By SkelRoot, its path with all variants that are selected there and above."""
    without_layout: tuple[Issue, ...] = ()
    """LAYOUT_NONE or LAYOUT_OFF for each character of a stage that has layouts of others; these
    characters were not read."""
    lost: tuple[Issue, ...] = ()
    """Why characters of a stage that are laid out have nothing to control any more."""
    contradictions: tuple[Issue, ...] = ()
    """Contradictions in the layouts of the stage."""
    config_faults: tuple[Issue, ...] = ()
    """Errors of the configuration that only the asset shows."""
    corrections: tuple[Correction, ...] = ()
    """Those that the stage has."""

    def layout_inside(self, root: str) -> str:
        """Where the asset itself has a layout of a SkelRoot, as a predicate; empty if nowhere."""
        if root in self.composed_from:
            return f"brings in its layout from {self.composed_from[root]}"
        return "has its layout in the variant rigUI" if root in self.switched_off else ""


class LayoutsResult(Record):
    """What a layout layer holds."""

    layouts: tuple[Layout, ...]
    source: str
    """The asset it sublayers; empty if it has none."""
    sources: tuple[SourceFile, ...]
    prims: tuple[ExistingPrim, ...] = ()
    composed_from: Mapping[str, str] = field(default_factory=dict)
    """By SkelRoot, the file of the layout that another layer of it brings in."""
    ignored: tuple[Issue, ...] = ()
    """Opinions of the layer and its sublayers that say nothing."""
    corrections: tuple[Correction, ...] = ()
    """Those that the stage has."""


class FaultsResult(Record):
    """What is wrong with an asset's blend shapes and animation, all of it."""

    issues: tuple[Issue, ...]
    empty: bool
    """Whether the stage has no prim at all."""


class LayerResult(Record):
    """A layer as its file has it, before anything is composed."""

    sublayers: tuple[str, ...]
    """As authored."""
    needed: tuple[str, ...]
    """Every file that it, or what it brings along, names for composition; each need not be
    there."""
    ours: bool
    """Whether it is a layout layer that we wrote, not one that brings such a layer in."""
    variants: tuple[Mapping[str, str], ...] = ()
    """The asset's variants that hold its own layouts: a selection for each of them; empty
    where none names any."""
    corrections: tuple[Correction, ...] = ()
    """Those that it holds itself."""


class Request(Record):
    """What the reader is asked."""

    task: Task
    path: str
    settings: Settings
    texts: tuple[str, ...] = ()
    """What `usdrigui.layer.shared_animation.told` or `merged` are given."""

    @property
    def seconds(self) -> float:
        """Wall clock that the answer may take."""
        return self.settings.read.time_limit

    @property
    def memory(self) -> int:
        """MiB of private memory that it may take, beyond what USD itself does."""
        return self.settings.read.memory_limit


class Response(Record, Generic[Result]):
    """What the reader answers: what it was asked for, or a refusal with its exit code."""

    result: Result | None = None
    refusal: Issue | None = None
    exit_code: int = 0
    others: tuple[Issue, ...] = ()
    """What else is wrong, of the same kind."""
