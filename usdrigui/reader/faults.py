"""Faults of blend shapes and layouts on a stage, one by one: for validators, which must see all of
them.

The reader stops at the first array that cannot be right; here every prim is looked at, by the same
checks and with the same codes.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from functools import partial
from itertools import chain

from pxr import Sdf, Usd, UsdGeom, UsdSkel

from usdrigui.character import Floats
from usdrigui.errors import NO_LAYOUT, Issue, RigUIError, issue
from usdrigui.layer.contradictions import contradictions
from usdrigui.layer.corrections import read_corrections
from usdrigui.layer.read_layout import read_layout
from usdrigui.reading.blend_shape import is_shape, names_and_targets, shape_arrays
from usdrigui.reading.clips import checked_weights
from usdrigui.reading.range import limit_entries, limit_table
from usdrigui.reading.skeleton import repeated
from usdrigui.settings import ReadSettings
from usdrigui.stages.arrays import tokens, value_at, vector_count, vectors


def stage_faults(stage: Usd.Stage) -> tuple[Issue, ...]:
    """Everything that is wrong with the blend shapes of a stage and with the layouts on it."""
    found = map(prim_faults, stage.Traverse(Usd.TraverseInstanceProxies()))
    return (*chain.from_iterable(found), *layout_faults(stage))


def prim_faults(prim: Usd.Prim) -> tuple[Issue, ...]:
    """What is wrong with the blend shapes of a mesh, or with the weights of a SkelAnimation."""
    if prim.IsA(UsdGeom.Mesh):
        return _mesh_faults(prim)
    return _animation_faults(prim) if prim.IsA(UsdSkel.Animation) else ()


def _mesh_faults(prim: Usd.Prim) -> tuple[Issue, ...]:
    """ARRAY_TYPE, NOT_FINITE, TARGETS_LENGTH, TARGET_INVALID, TOKEN_REPEATED, and the faults of
    each shape."""
    found: list[Issue] = []
    with _collecting(found):
        names, targets = names_and_targets(prim)
        if names:
            found += _pair_faults(prim, names, targets)
    return tuple(found)


def _animation_faults(prim: Usd.Prim) -> tuple[Issue, ...]:
    """ANIMATION_LENGTH, ARRAY_TYPE, NOT_FINITE and WEIGHTS_BEYOND_LIMITS of the weights of a
    SkelAnimation, each at the first of the times at which it is so."""
    animation, path = UsdSkel.Animation(prim), prim.GetPath()
    attribute, faults = animation.GetBlendShapeWeightsAttr(), list[Issue]()
    with _collecting(faults):
        names = tokens(animation.GetBlendShapesAttr().Get(), path, "blendShapes")
        entries = limit_entries(attribute)
        entry = entries.get("hard", entries.get("soft"))
        limits = None if entry is None else limit_table(entry, len(names))
        for code in (Usd.TimeCode.Default(), *map(Usd.TimeCode, attribute.GetTimeSamples())):
            with _collecting(faults):
                values = checked_weights(animation, path, len(names), code)
                if limits is not None and len(values):
                    faults += _beyond([*zip(names, values, limits, strict=True)], path, code)
    found: dict[tuple[str, str], Issue] = {}
    for each in faults:
        found.setdefault((each.code, each.message.partition(" at ")[0]), each)
    return tuple(found.values())


def layout_faults(stage: Usd.Stage) -> tuple[Issue, ...]:
    """LAYOUT_MESH_GONE of every mesh, LAYOUT_TOPOLOGY and LAYOUT_INVALID of every element and of
    corrections, or why the layouts cannot be read; none without layout."""
    try:
        layouts = read_layout(stage)
    except RigUIError as error:
        return () if error.issue.code in NO_LAYOUT else (error.issue,)
    found: list[Issue] = []
    with _collecting(found):
        read_corrections(stage)
    return tuple(dict.fromkeys((*found, *contradictions(stage, ReadSettings(), layouts))))


# --- one mesh and its shapes ----------------------------------------------------------------------


def _pair_faults(
    prim: Usd.Prim, names: tuple[str, ...], targets: list[Sdf.Path]
) -> Iterator[Issue]:
    """What is wrong with the names and targets of a mesh, and with the shapes; raises ARRAY_TYPE
    for its points."""
    path, faults = prim.GetPath(), list[Issue]()
    yield from repeated(names, path, "skel:blendShapes")
    points = value_at(UsdGeom.Mesh(prim).GetPointsAttr(), Usd.TimeCode.Default())
    count = vector_count(points, path, "points")
    with _collecting(faults):
        vectors(points, path, "points")
    for name, target in zip(names, targets, strict=True):
        shape = prim.GetStage().GetPrimAtPath(target)
        if not is_shape(shape):
            faults.append(issue("TARGET_INVALID", target, f"is the target of {name!r} of {path}"))
            continue
        with _collecting(faults):
            shape_arrays(shape, count, faults, partial(_collecting, faults))
    yield from faults


@contextlib.contextmanager
def _collecting(found: list[Issue]) -> Iterator[None]:
    """Keep what the checks of the reader refuse."""
    try:
        yield
    except RigUIError as error:
        found.append(error.issue)


# --- ranges ---------------------------------------------------------------------------------------


def _beyond(
    weights: Sequence[tuple[str, float, Floats]], path: object, code: Usd.TimeCode
) -> Iterator[Issue]:
    """Which of some weights, each with its name and limits (2,), are outside of these."""
    when = "the default time" if code.IsDefault() else f"time {code.GetValue():g}"
    for name, value, (low, high) in weights:
        slack = 1e-5 * max(1.0, abs(low), abs(high))
        if not low - slack <= value <= high + slack:
            what = f"{name!r} has weights outside {low:g} to {high:g}, {value:g} at {when}"
            yield issue("WEIGHTS_BEYOND_LIMITS", path, what)
