"""How a confined reader answers what it is asked about a USD file: a program of
`usdrigui.isolation.reader`."""

from __future__ import annotations

import contextlib
import importlib
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from usdrigui.character import Performance, Rig
from usdrigui.errors import Issue, RigUIError, issue, raised_at, refuse
from usdrigui.isolation.foreign_file import SourceFile, check_unchanged, hashed
from usdrigui.reader.reader_records import (
    FaultsResult,
    LayerResult,
    LayoutsResult,
    Limits,
    ReadResult,
    Request,
    Response,
)
from usdrigui.settings import Settings

_OUT_OF_MEMORY = ("bad_alloc", "Cannot allocate memory", "Resource temporarily unavailable")
"""What USD's messages hold when an allocation or a thread was refused."""


QUESTION = Request


_NEEDED = (
    "usdrigui.layer.contradictions",
    "usdrigui.layer.read_layout",
    "usdrigui.layer.write_layout",
    "usdrigui.reader.existing_layouts",
    "usdrigui.reader.faults",
    "usdrigui.reading.character",
    "usdrigui.reading.clips",
)
"""Modules that the tasks import, and with them all that these do."""


def load() -> None:
    """Import what the tasks need before the reader is confined: none of it is the asset's doing."""
    for name in _NEEDED:
        importlib.import_module(name)


def answer(request: Request) -> Response:
    """Do what is asked; every exception becomes a refusal."""
    path, peak = Path(request.path), _peak()
    try:
        variants = request.settings.rig.read.variants
        if request.task == "composed":
            return _composed(path, request.settings)
        if request.task == "layouts":
            return Response(layouts=_layouts(path, variants))
        if request.task == "clips":
            return Response(performances=_performances(path))
        if request.task == "faults":
            return Response(faults=_faults(path, variants))
        if request.task == "variants":
            return Response(variants=_variants(path, variants))
        if request.task == "layer":
            return Response(layer=_layer(path))
        return Response(rigs=_rigs(path, request.settings))
    except RigUIError as error:
        return _refusal(
            _starved(request) if _is_memory(error.issue, _peak() - peak, request.limits) else error
        )
    except MemoryError:
        return _refusal(_starved(request))
    except Exception as error:
        return _refusal(_unexpected(error, request.path))


# --- the tasks ------------------------------------------------------------------------------------


def _rigs(path: Path, settings: Settings) -> ReadResult:
    from usdrigui.layer.read_layout import composed_layouts, own_layouts, roots_off, source_of
    from usdrigui.layer.write_layout import stage_metadata
    from usdrigui.reading.character import read_characters
    from usdrigui.stages.variants import variant_path

    with (
        _hashed_before(path, settings.rig.read.variants) as (before, diagnostics),
        _kept_stages() as stages,
    ):
        found = read_characters(path, settings.rig)
        rigs = _with_diagnostics(found.rigs, path, diagnostics)
        stage = _stage_of(path, stages)
        cameras = cameras_toward(stage, rigs, settings.layout.candidates.view)
        metadata = {
            key: _as_json(value) for key, value in stage_metadata(stage.GetRootLayer()).items()
        }
        layouts = own_layouts(stage)
        below = source_of(path) if layouts else ""
        sources = _sources(path, stages.GetAllStages(), before)
        paths = {
            rig.skel_root.path: variant_path(stage.GetPrimAtPath(rig.skel_root.path))
            for rig in rigs
        }
        return ReadResult(
            rigs,
            metadata,
            cameras,
            sources,
            layouts,
            below,
            composed_layouts(stage),
            roots_off(stage),
            paths,
            config_faults=_as_text(found.faults.issues),
        )


def _layouts(path: Path, variants: Mapping[str, str]) -> LayoutsResult:
    from usdrigui.layer.read_layout import layout_paths, with_corrections
    from usdrigui.stages.opening import open_stage
    from usdrigui.stages.variants import select_unselected

    with _hashed_before(path, variants) as (before, _), _kept_stages() as stages:
        stage = open_stage(path, variants)  # kept, so that what opens it next finds it so
        if not stage.GetRootLayer().subLayerPaths:
            select_unselected(stage, layout_paths(stage.GetRootLayer()))
        found = _layouts_in(path, stages, before)
        return replace(found, layouts=with_corrections(_stage_of(path, stages), found.layouts))


def _layouts_in(path: Path, stages: Any, before: Mapping[str, SourceFile]) -> LayoutsResult:
    from usdrigui.layer.read_layout import composed_layouts, read_layout, source_of
    from usdrigui.reader.existing_layouts import existing_prims

    layouts = read_layout(path)
    stage = _stage_of(path, stages)
    sources = _sources(path, stages.GetAllStages(), before)
    return LayoutsResult(
        layouts, source_of(path), sources, existing_prims(stage), composed_layouts(stage)
    )


def _composed(path: Path, settings: Settings) -> Response:
    """The layouts of a stage and their characters as the stage composes them."""
    from usdrigui.layer.contradictions import contradictions
    from usdrigui.layer.read_layout import listed_controls
    from usdrigui.reader.existing_layouts import without_layout
    from usdrigui.reading.character import read_characters
    from usdrigui.stages.opening import open_stage

    read = settings.rig.read
    with (
        _hashed_before(path, read.variants) as (before, diagnostics),
        _kept_stages() as stages,
    ):
        open_stage(path, read.variants)  # kept, so that what opens it next finds it so
        found = _layouts_in(path, stages, before)
        laid_out = {each.character.root for each in found.layouts}
        some = read_characters(path, settings.rig, laid_out)
        rigs = _with_diagnostics(some.rigs, path, diagnostics)
        stage = _stage_of(path, stages)
        cameras = cameras_toward(stage, rigs, settings.layout.candidates.view)
        sources = _sources(path, stages.GetAllStages(), before)
        bare = without_layout(stage, laid_out, read.skel_root)
        result = ReadResult(
            rigs,
            {},
            cameras,
            sources,
            without_layout=_as_text(bare),
            lost=_as_text(some.lost),
            contradictions=_as_text(contradictions(stage)),
            listed=listed_controls(stage),
            config_faults=_as_text(some.faults.issues),
        )
        return Response(rigs=result, layouts=found)


def _performances(path: Path) -> tuple[Performance, ...]:
    from usdrigui.reading.clips import read_performances

    return read_performances(path)


def _variants(path: Path, variants: Mapping[str, str]) -> Mapping[str, tuple[str, ...]]:
    from usdrigui.stages.opening import open_stage
    from usdrigui.stages.variants import variant_sets

    return variant_sets(open_stage(path, variants))


def _faults(path: Path, variants: Mapping[str, str]) -> FaultsResult:
    from usdrigui.reader.faults import stage_faults
    from usdrigui.stages.opening import open_stage

    stage = open_stage(path, variants)
    return FaultsResult(stage_faults(stage), not stage.GetPseudoRoot().GetAllChildren())


def _layer(path: Path) -> LayerResult:
    from usdrigui.layer.read_layout import layout_paths
    from usdrigui.layer.write_layout import SIGNATURE
    from usdrigui.stages.opening import open_layer
    from usdrigui.stages.variant_paths import asset_selections

    needed: dict[str, str] = {}

    def follow(layer: Any, folder: Path) -> None:
        """Note the files that a layer names, and those that these name, as far as they are
        there."""
        for each in sorted(layer.GetCompositionAssetDependencies()):
            found = folder / each
            if os.path.realpath(found) not in needed:
                needed[os.path.realpath(found)] = str(found)
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
    )


@contextlib.contextmanager
def _kept_stages() -> Iterator[Any]:
    """A cache that keeps every stage opened meanwhile, to be asked for the files it used."""
    from pxr import Usd

    cache = Usd.StageCache()
    with Usd.StageCacheContext(cache):
        yield cache


def _stage_of(path: Path, stages: Any) -> Any:
    """The stage of the asset itself, where others were opened beside it."""
    own, found = os.path.realpath(path), stages.GetAllStages()
    return next(
        (each for each in found if os.path.realpath(each.GetRootLayer().realPath) == own), found[0]
    )


@contextlib.contextmanager
def _hashed_before(
    path: Path, variants: Mapping[str, str]
) -> Iterator[tuple[Mapping[str, SourceFile], Sequence[str]]]:
    """The files that compose an asset of several, by path, as they were before anything is read for
    good.

    Only composition finds these files, so they are composed, let go, and hashed.  An asset
    of one file was hashed by the parent: its layer is kept for the reading, which will not hear
    the issues of USD while it parses the file; that comes second.
    """
    from usdrigui.stages.opening import listening, open_stage

    with listening() as diagnostics:
        stage = open_stage(path, variants)
    names = _files(path, (stage,)) if _depends(stage) else ()
    if names:
        del stage
    yield {each.path: each for each in map(hashed, names)}, diagnostics


def _with_diagnostics(
    rigs: tuple[Rig, ...], path: Path, diagnostics: Iterable[str]
) -> tuple[Rig, ...]:
    """The rigs, the first of which has the issues of USD before they were read, too."""
    issues = [issue("USD_DIAGNOSTIC", str(path), text) for text in diagnostics]
    if not rigs:
        return rigs
    new = tuple(each for each in issues if each not in rigs[0].findings.issues)
    findings = replace(rigs[0].findings, issues=(*rigs[0].findings.issues, *new))
    return (replace(rigs[0], findings=findings), *rigs[1:])


def _depends(stage: Any) -> bool:
    return any(layer.GetCompositionAssetDependencies() for layer in stage.GetUsedLayers())


def _sources(
    path: Path, stages: Iterable[Any], before: Mapping[str, SourceFile]
) -> tuple[SourceFile, ...]:
    """Every file behind the layers of the stages: the asset first, the others by path; packages are
    checked.

    Raises RigUIError SOURCE_CHANGED where one is not what it was `before` it was read.
    """
    from usdrigui.stages.opening import check_archive

    check_unchanged(before.values())
    found = tuple(before.get(each) or hashed(each) for each in _files(path, stages))
    for each in found[1:]:
        if each.path.lower().endswith(".usdz"):
            check_archive(Path(each.path))
    return found


def _files(path: Path, stages: Iterable[Any]) -> tuple[str, ...]:
    """Real paths of the files behind the layers of the stages, the asset first."""
    from pxr import Ar

    used = {layer.realPath for stage in stages for layer in stage.GetUsedLayers() if layer.realPath}
    files = {
        Ar.SplitPackageRelativePathOuter(each)[0] if Ar.IsPackageRelativePath(each) else each
        for each in used
    }
    own = os.path.realpath(path)
    others = sorted({os.path.realpath(each) for each in files} - {own})
    return (own, *(each for each in others if os.path.isfile(each)))  # noqa: PTH113


def cameras_toward(stage: Any, rigs: Iterable[Any], view: str) -> dict[str, Any]:
    """Direction to the viewer of the camera that `view` names, in the space of each SkelRoot."""
    import numpy as np
    from pxr import Gf, Sdf, UsdGeom

    if not (view.startswith("/") and Sdf.Path.IsValidPathString(view)[0]):
        return {}
    camera = UsdGeom.Camera.Get(stage, view)
    if not camera:
        return {}
    cache = UsdGeom.XformCache()
    # A camera looks down its own -Z axis.
    toward = cache.GetLocalToWorldTransform(camera.GetPrim()).TransformDir(Gf.Vec3d(0, 0, 1))
    found = {}
    for rig in rigs:
        to_root = cache.GetLocalToWorldTransform(
            stage.GetPrimAtPath(rig.skel_root.path)
        ).GetInverse()
        found[rig.skel_root.path] = np.array(to_root.TransformDir(toward), dtype=np.float64)
    return found


def _as_json(value: Any) -> Any:
    """Metadata as JSON values: dictionaries, lists, strings, numbers, truth values."""
    if isinstance(value, dict):
        return {str(key): _as_json(item) for key, item in value.items()}
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    if hasattr(value, "__iter__"):
        return [_as_json(item) for item in value]
    return str(value)


# --- failures -------------------------------------------------------------------------------------


def _refusal(error: RigUIError) -> Response:
    first, *others = _as_text(error.issues)
    return Response(refusal=first, exit_code=int(error.exit_code), others=tuple(others))


def _as_text(issues: Iterable[Issue]) -> tuple[Issue, ...]:
    """The issues in letters that a response can hold."""
    return tuple(
        replace(each, path=_text(each.path), message=_text(each.message)) for each in issues
    )


def _text(value: object) -> str:
    return str(value).encode(errors="replace").decode(errors="replace")


def _starved(request: Request) -> RigUIError:
    limit = f"needs more than {request.limits.memory} MiB to be read"
    return refuse("SOURCE_MEMORY_LIMIT", request.path, limit)


def _is_memory(found: Issue, grown: int, limits: Limits) -> bool:
    """Whether USD's issues of the asset are really about the limit: it catches failed allocations
    itself."""
    if found.code not in ("FILE_NOT_USD", "LAYER_UNREADABLE", "LAYER_MISSING", "USD_ERROR"):
        return False
    return any(message in found.message for message in _OUT_OF_MEMORY) or grown > 0.7 * (
        limits.memory << 20
    )


def _unexpected(error: Exception, path: str) -> RigUIError:
    """USD's own exceptions blame the asset; all others are ours."""
    kind = type(error)
    if kind.__module__.partition(".")[0] in ("pxr", "Boost") or isinstance(
        error, UnicodeDecodeError
    ):
        return refuse("USD_ERROR", path, f"USD raised {kind.__name__} while it was read")
    return refuse("BUG", path, f"{kind.__name__}: {_text(error)}{raised_at(error)}")


def _peak() -> int:
    """Bytes of address space used at most so far; 0 if the system does not report them."""
    try:
        lines = Path("/proc/self/status").read_text().splitlines()
    except OSError:
        return 0
    return next((int(line.split()[1]) << 10 for line in lines if line.startswith("VmPeak:")), 0)
