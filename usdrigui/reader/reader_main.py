"""How a confined reader answers what it is asked about a USD file: a program of
`usdrigui.isolation.reader`."""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from pxr import Ar, Sdf, Usd

from usdrigui.errors import Issue, RigUIError, issue, raised_at, refuse
from usdrigui.isolation.foreign_file import SourceFile, check_unchanged, hashed
from usdrigui.layer import shared_animation
from usdrigui.layer.baking import bake
from usdrigui.layer.contradictions import contradictions
from usdrigui.layer.corrections import own_corrections, read_corrections
from usdrigui.layer.ignored_opinions import ignored_opinions
from usdrigui.layer.read_layout import (
    composed_layouts,
    layout_paths,
    own_layouts,
    read_layout,
    source_of,
    switched_off,
    with_corrections,
)
from usdrigui.layer.write_layout import SIGNATURE, stage_metadata
from usdrigui.reader.existing_layouts import existing_prims, without_layout
from usdrigui.reader.faults import stage_faults
from usdrigui.reader.reader_records import (
    FaultsResult,
    LayerResult,
    LayoutsResult,
    ReadResult,
    Request,
    Response,
    Task,
)
from usdrigui.reading.character import Characters, read_characters
from usdrigui.reading.clips import read_performances
from usdrigui.settings import Settings
from usdrigui.stages.opening import check_archive, listening, open_layer, open_stage
from usdrigui.stages.variant_paths import asset_selections
from usdrigui.stages.variants import select_unselected, variant_path, variant_sets

_OUT_OF_MEMORY = ("bad_alloc", "Cannot allocate memory", "Resource temporarily unavailable")
"""What USD's messages hold when an allocation or a thread was refused."""


QUESTION = Request
Usd.SchemaRegistry()  # known before readers are forked, so that none spends its time on them


def answer(request: Request) -> Response[Any]:
    """Do what is asked; every exception becomes a refusal."""
    peak = _peak()
    try:
        found = _TASKS[request.task](Path(request.path), request.settings, *request.texts)
        return Response(found)
    except RigUIError as error:
        return _refusal(
            _starved(request) if _is_memory(error.issue, _peak() - peak, request.memory) else error
        )
    except MemoryError:
        return _refusal(_starved(request))
    except Exception as error:
        return _refusal(_unexpected(error, request.path))


# --- the tasks ------------------------------------------------------------------------------------


def _rigs(path: Path, settings: Settings) -> ReadResult:
    with _reading(path, settings) as asset:
        found = asset.with_diagnostics(read_characters(path, settings))
        result = read_result(asset.stage, found)
        below = source_of(path) if result.layouts else ""
        return replace(result, below=below, sources=asset.sources())


def _layouts(path: Path, settings: Settings) -> LayoutsResult:
    with _reading(path, settings) as asset:
        # Kept, so that what opens it next finds it so.
        stage = open_stage(path, settings.read.variants)
        if not stage.GetRootLayer().subLayerPaths:
            select_unselected(stage, layout_paths(stage.GetRootLayer()))
        found = _layouts_in(asset, carried=True)
        corrected = with_corrections(asset.stage, found.layouts)
        return replace(found, layouts=corrected)


def _layouts_in(asset: _Asset, *, carried: bool = False) -> LayoutsResult:
    layouts, stage = read_layout(asset.path, carried=carried), asset.stage
    sources = asset.sources()
    return LayoutsResult(
        layouts,
        source_of(asset.path),
        sources,
        existing_prims(stage),
        composed_layouts(stage),
        ignored_opinions(stage),
        read_corrections(stage),
    )


def _composed(path: Path, settings: Settings) -> tuple[LayoutsResult, ReadResult]:
    """The layouts of a stage and their characters as the stage composes them."""
    with _reading(path, settings) as asset:
        # Kept, so that what opens it next finds it so.
        open_stage(path, settings.read.variants)
        layouts = _layouts_in(asset)
        laid_out = {each.root for each in layouts.layouts}
        result = read_composed(asset.stage, settings, laid_out, asset.with_diagnostics)
        return layouts, replace(result, sources=asset.sources())


def _faults(path: Path, settings: Settings) -> FaultsResult:
    stage = open_stage(path, settings.read.variants)
    is_empty = not stage.GetPseudoRoot().GetAllChildren()
    return FaultsResult(stage_faults(stage), is_empty)


def _layer(path: Path, _: Settings) -> LayerResult:
    needed: dict[str, str] = {}

    def follow(layer: Sdf.Layer, folder: Path) -> None:
        """Note the files that a layer names, and those that these name, as far as they are
        there."""
        for each in sorted(layer.GetCompositionAssetDependencies()):
            found = folder / each
            real = os.path.realpath(found)
            if real not in needed:
                needed[real] = str(found)
                if found.is_file():
                    follow(open_layer(found), found.parent)

    layer = open_layer(path)
    follow(layer, path.parent)
    scopes = dict.fromkeys(map(str, layout_paths(layer)))
    chosen = {tuple(sorted(asset_selections(each).items())): None for each in scopes}
    variants = tuple(map(dict, chosen)) if any(chosen) else ()
    return LayerResult(
        tuple(layer.subLayerPaths),
        tuple(needed.values()),
        SIGNATURE in layer.customLayerData,
        variants,
        own_corrections(layer),
    )


_TASKS: Mapping[Task, Callable[..., Any]] = {
    "rigs": _rigs,
    "layouts": _layouts,
    "composed": _composed,
    "clips": lambda path, _: read_performances(path),
    "bake": lambda path, settings: str(
        bake(open_stage(path, settings.read.variants), settings.read).ExportToString()
    ),
    "faults": _faults,
    "layer": _layer,
    "variants": lambda path, settings: variant_sets(open_stage(path, settings.read.variants)),
    "told": lambda path, _, *texts: shared_animation.told(path, *texts),
    "merged": lambda path, _, *texts: shared_animation.merged(path, *texts),
}


# --- what is read ---------------------------------------------------------------------------------


def read_composed(
    stage: Usd.Stage,
    settings: Settings,
    laid_out: Collection[str],
    told: Callable[[Characters], Characters] = lambda found: found,
) -> ReadResult:
    """The characters `laid_out`, SkelRoots that have a layout, and what it says of them; they play
    what the values of its controls say.  `told` adds to the characters."""
    found = told(read_characters(stage, settings, laid_out))
    against = contradictions(stage, settings.read, rigs=found.rigs)
    if _plays_values(stage, settings):
        found = told(read_characters(stage, settings, laid_out))
    return replace(
        read_result(stage, found),
        without_layout=without_layout(stage, laid_out, settings.read.skel_root),
        contradictions=against,
    )


def _plays_values(stage: Usd.Stage, settings: Settings) -> bool:
    """Let the stage play the values of its controls, by its session layer; false where it has none
    that can be baked."""
    try:
        layer = bake(stage, settings.read)
    except RigUIError:
        return False  # A check says why.
    layer.timeCodesPerSecond = stage.GetTimeCodesPerSecond()  # Else USD scales its times.
    stage.GetSessionLayer().subLayerPaths.append(layer.identifier)
    return True


def read_result(stage: Usd.Stage, found: Characters) -> ReadResult:
    """What a stage holds besides its characters `found`."""
    layer = stage.GetRootLayer()
    return ReadResult(
        found.rigs,
        json.loads(json.dumps(stage_metadata(layer), default=_as_json)),
        (),
        own_layouts(stage),
        composed_from=composed_layouts(stage),
        switched_off=tuple(switched_off(stage)),
        variant_paths={
            path: variant_path(stage.GetPrimAtPath(path))
            for path in (rig.path for rig in found.rigs)
        },
        lost=found.lost,
        config_faults=found.faults.issues,
        corrections=read_corrections(stage),
    )


@dataclass(frozen=True)
class _Asset:
    """A file that is being read."""

    path: Path
    before: Mapping[str, SourceFile]
    """The files that compose it, by path, as they were before anything was read for good; none for
    an asset of one file, which the parent hashed."""
    diagnostics: Sequence[str]
    """What USD said as it parsed them."""
    opened: Usd.StageCache
    """Every stage that is opened meanwhile."""

    @property
    def stage(self) -> Usd.Stage:
        """That of the asset itself, where others were opened beside it."""
        own, found = os.path.realpath(self.path), self.opened.GetAllStages()
        return next(
            (each for each in found if os.path.realpath(each.GetRootLayer().realPath) == own),
            found[0],
        )

    def sources(self) -> tuple[SourceFile, ...]:
        """Every file that composed what was read, the asset first, all unchanged since.

        Raises SOURCE_CHANGED, and FILE_CORRUPT for a package that is damaged.
        """
        check_unchanged(self.before.values())
        files = _files(self.path, self.opened.GetAllStages())
        found = tuple(self.before.get(each) or hashed(each) for each in files)
        for each in found[1:]:
            if each.path.lower().endswith(".usdz"):
                check_archive(Path(each.path))
        return found

    def with_diagnostics(self, found: Characters) -> Characters:
        """The characters, the first of which has the issues of USD before they were read, too."""
        if not found.rigs:
            return found
        first, *others = found.rigs
        issues = dict.fromkeys(first.issues)
        issues |= {issue("USD_DIAGNOSTIC", self.path, each): None for each in self.diagnostics}
        return replace(found, rigs=(replace(first, issues=tuple(issues)), *others))


@contextlib.contextmanager
def _reading(path: Path, settings: Settings) -> Iterator[_Asset]:
    """A file, of which every stage is kept.

    Only composition finds the files of an asset, so they are composed, let go, and hashed.  The
    layer of an asset of one file is kept for the reading, which will not hear the issues of USD
    while it parses the file; that comes second.
    """
    with listening() as diagnostics:
        stage = open_stage(path, settings.read.variants)
    names: tuple[str, ...] = ()
    if any(layer.GetCompositionAssetDependencies() for layer in stage.GetUsedLayers()):
        names = _files(path, (stage,))
        del stage
    before = {each.path: each for each in map(hashed, names)}
    with Usd.StageCacheContext(opened := Usd.StageCache()):
        yield _Asset(path, before, diagnostics, opened)


def _files(path: Path, stages: Iterable[Usd.Stage]) -> tuple[str, ...]:
    """Real paths of the files behind the layers of the stages, the asset first."""
    used = {layer.realPath for stage in stages for layer in stage.GetUsedLayers() if layer.realPath}
    files = {
        Ar.SplitPackageRelativePathOuter(each)[0] if Ar.IsPackageRelativePath(each) else each
        for each in used
    }
    own = os.path.realpath(path)
    others = sorted({os.path.realpath(each) for each in files} - {own})
    return (own, *(each for each in others if os.path.isfile(each)))  # noqa: PTH113


def _as_json(value: Any) -> list[Any] | str:
    """Metadata that JSON does not know: arrays, vectors and matrices as lists, others as text."""
    return list(value) if hasattr(value, "__iter__") else str(value)


# --- failures -------------------------------------------------------------------------------------


def _refusal(error: RigUIError) -> Response[Any]:
    return Response(None, error.issue, int(error.exit_code), error.others)


def _starved(request: Request) -> RigUIError:
    limit = f"needs more than {request.memory} MiB to be read"
    return refuse("SOURCE_MEMORY_LIMIT", request.path, limit)


def _is_memory(found: Issue, grown: int, memory: int) -> bool:
    """Whether USD's issues of the asset are really about the limit: it catches failed allocations
    itself."""
    if found.code not in ("FILE_NOT_USD", "LAYER_UNREADABLE", "LAYER_MISSING", "USD_ERROR"):
        return False
    return any(message in found.message for message in _OUT_OF_MEMORY) or grown > 0.7 * (
        memory << 20
    )


def _unexpected(error: Exception, path: str) -> RigUIError:
    """USD's own exceptions blame the asset; all others are ours."""
    kind = type(error)
    if kind.__module__.partition(".")[0] in ("pxr", "Boost") or isinstance(
        error, UnicodeDecodeError
    ):
        return refuse("USD_ERROR", path, f"USD raised {kind.__name__} while it was read")
    return refuse("BUG", path, f"{kind.__name__}: {error}{raised_at(error)}")


def _peak() -> int:
    """Bytes of address space used at most so far; 0 if the system does not report them."""
    try:
        lines = Path("/proc/self/status").read_text().splitlines()
    except OSError:
        return 0
    return next((int(line.split()[1]) << 10 for line in lines if line.startswith("VmPeak:")), 0)
