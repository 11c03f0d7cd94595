"""Faults of blend shapes and layouts on a stage, one by one: for validators, which must see all of
them.

The reader stops at the first array that cannot be right; here every prim is looked at, by the same
checks and with the same codes.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np
from pxr import Sdf, Tf, Usd, UsdGeom, UsdSkel

from usdrigui.errors import NO_LAYOUT, Issue, RigUIError, issue
from usdrigui.model import Floats
from usdrigui.usd.arrays import (
    check_range,
    floats,
    integers,
    tokens,
    value_at,
    vector_count,
    vectors,
)
from usdrigui.usd.contradictions import contradictions
from usdrigui.usd.mesh import topology_hash
from usdrigui.usd.read_layout import read_layout
from usdrigui.usd.shapes import shape_tokens
from usdrigui.usd.skeleton import repeated


def stage_faults(stage: Usd.Stage) -> tuple[Issue, ...]:
    """Everything that is wrong with the blend shapes of a stage and with the layouts on it."""
    found: list[Issue] = []
    for prim in stage.Traverse(Usd.TraverseInstanceProxies()):
        if prim.IsA(UsdGeom.Mesh):
            found += mesh_faults(prim)
        elif prim.IsA(UsdSkel.Animation):
            found += animation_faults(prim)
    return (*found, *layout_faults(stage))


def mesh_faults(prim: Usd.Prim) -> tuple[Issue, ...]:
    """ARRAY_TYPE, TARGETS_LENGTH, TARGET_INVALID, TOKEN_REPEATED, TOKEN_ORDER, and the faults of
    each shape."""
    found: list[Issue] = []
    with _collecting(found):
        names, targets = pairs_of(prim)
        if names or targets:
            found += _pair_faults(prim, names, targets)
    return tuple(found)


def animation_faults(prim: Usd.Prim) -> tuple[Issue, ...]:
    """ANIMATION_LENGTH, ARRAY_TYPE, NOT_FINITE and WEIGHTS_BEYOND_LIMITS of the weights of a
    SkelAnimation."""
    animation, path = UsdSkel.Animation(prim), str(prim.GetPath())
    faults: list[Issue] = []
    with _collecting(faults):
        names = tokens(animation.GetBlendShapesAttr().Get(), path, "blendShapes")
        faults += _sample_faults(animation.GetBlendShapeWeightsAttr(), names, path)
    found: dict[tuple[str, str], Issue] = {}
    for each in faults:
        found.setdefault((each.code, each.message.partition(" at ")[0]), each)
    return tuple(found.values())


def layout_faults(stage: Usd.Stage) -> tuple[Issue, ...]:
    """LAYOUT_MESH_GONE of every mesh, LAYOUT_TOPOLOGY and LAYOUT_INVALID of every element, or why
    the layouts cannot be read; none without layout."""
    try:
        layouts = read_layout(stage)
    except RigUIError as error:
        return () if error.issue.code in NO_LAYOUT else (error.issue,)
    found: list[Issue] = []
    hashes: dict[str, str] = {}
    for layout in layouts:
        for element in layout.elements:
            anchor = element.anchor
            if anchor.mesh not in hashes:
                hashes[anchor.mesh] = ""
                with _collecting(found):
                    hashes[anchor.mesh] = _topology(
                        stage.GetPrimAtPath(anchor.mesh) if anchor.mesh else None
                    )
            if not hashes[anchor.mesh]:
                found.append(layout.mesh_gone(anchor.mesh))
            elif change := anchor.mesh_change(hashes[anchor.mesh]):
                found.append(issue("LAYOUT_TOPOLOGY", element.name, change, layout.character.root))
    return tuple(dict.fromkeys((*found, *contradictions(stage))))


# --- the pairs of names and targets, and how to repair them ---------------------------------------


def pairs_of(prim: Usd.Prim) -> tuple[list[str], list[Sdf.Path]]:
    """Names and targets of the blend shapes of a mesh; raises ARRAY_TYPE."""
    return list(shape_tokens(prim)), UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().GetTargets()


def is_shape(prim: Usd.Prim) -> bool:
    """Whether a target is one that UsdSkel would use."""
    return bool(prim) and prim.IsActive() and prim.IsA(UsdSkel.BlendShape)


def can_repair(prim: Usd.Prim) -> bool:
    """Whether `repair` knows what was meant: there is one target for each name."""
    try:
        names, targets = pairs_of(prim)
    except RigUIError:
        return False
    return len(names) == len(targets) and not prim.IsInstanceProxy()


def repair(prim: Usd.Prim) -> None:
    """Drop the pairs that UsdSkel ignores and put the rest into the animation's order; nothing
    moves otherwise.

    Authors skel:blendShapes and skel:blendShapeTargets in the stage's edit target.
    """
    # Of a name that is listed twice UsdSkel takes the last.
    kept = dict(zip(*pairs_of(prim), strict=True))
    kept = {
        token: target
        for token, target in kept.items()
        if is_shape(prim.GetStage().GetPrimAtPath(target))
    }
    place = {token: index for index, token in enumerate(_animated(prim))}
    order = sorted(kept, key=lambda token: place.get(token, len(place)))
    api = UsdSkel.BindingAPI(prim)
    api.GetBlendShapesAttr().Set(order)
    api.GetBlendShapeTargetsRel().SetTargets([kept[token] for token in order])


# --- one mesh and its shapes ----------------------------------------------------------------------


def _pair_faults(prim: Usd.Prim, names: list[str], targets: list[Sdf.Path]) -> Iterator[Issue]:
    """What is wrong with the names and targets of a mesh, and with the shapes; raises ARRAY_TYPE
    for its points."""
    path = str(prim.GetPath())
    if len(names) != len(targets):
        counts = f"{len(names)} skel:blendShapes but {len(targets)} skel:blendShapeTargets"
        yield issue("TARGETS_LENGTH", path, counts)
        return
    yield from repeated(names, path, "skel:blendShapes")
    count = vector_count(
        value_at(UsdGeom.Mesh(prim).GetPointsAttr(), Usd.TimeCode.Default()), path, "points"
    )
    for name, target in zip(names, targets, strict=True):
        shape = prim.GetStage().GetPrimAtPath(target)
        if is_shape(shape):
            yield from _shape_faults(shape, count)
        else:
            yield issue("TARGET_INVALID", str(target), f"is the target of {name!r} of {path}")
    yield from _order_faults(prim, names)


def _shape_faults(shape: Usd.Prim, points: int) -> Iterator[Issue]:
    """What is wrong with one BlendShape of a mesh of so many points."""
    path = str(shape.GetPath())
    faults: list[Issue] = []
    with _collecting(faults):
        indices = integers(shape.GetAttribute("pointIndices").Get(), path, "pointIndices")
        check_range(indices, points, path, "pointIndices")
        expected = len(indices) or points
        arrays = [
            ("offsets", shape.GetAttribute("offsets").Get()),
            *_inbetween_arrays(shape, faults),
        ]
        for name, values in arrays:
            with _collecting(faults):
                offsets = vectors(values, path, name)
                if len(offsets) not in (0, expected):
                    faults.append(
                        issue("OFFSETS_LENGTH", path, f"{len(offsets)} {name} for {expected}")
                    )
    yield from faults


def _inbetween_arrays(shape: Usd.Prim, faults: list[Issue]) -> list[tuple[str, Any]]:
    """Name and offsets of the in-betweens; what is wrong with their weights goes to `faults`."""
    taken, arrays = {0.0, 1.0}, []
    for each in UsdSkel.BlendShape(shape).GetInbetweens():
        weight, name = each.GetWeight(), each.GetAttr().GetName()
        if (
            weight is None
            or not np.isfinite(weight)
            or any(abs(weight - other) < 1e-6 for other in taken)
        ):
            faults.append(
                issue("INBETWEEN_INVALID", str(shape.GetPath()), f"{name} has weight {weight}")
            )
            continue
        taken.add(float(weight))
        arrays.append((name, each.GetOffsets()))
    return arrays


@contextlib.contextmanager
def _collecting(found: list[Issue]) -> Iterator[None]:
    """Keep what the checks of the reader refuse."""
    try:
        yield
    except RigUIError as error:
        found.append(error.issue)


# --- order and ranges -----------------------------------------------------------------------------


def _animated(prim: Usd.Prim) -> list[str]:
    """The blend shapes that the animation of a mesh's Skeleton lists; none without."""
    skeleton = UsdSkel.BindingAPI(prim).GetInheritedSkeleton()
    source = (
        UsdSkel.BindingAPI(skeleton.GetPrim()).GetInheritedAnimationSource() if skeleton else None
    )
    animation = UsdSkel.Animation(source) if source else None
    if not animation:
        return []
    with contextlib.suppress(
        RigUIError
    ):  # Faults of the animation are recorded with the animation.
        return list(
            tokens(animation.GetBlendShapesAttr().Get(), str(animation.GetPath()), "blendShapes")
        )
    return []


def _order_faults(prim: Usd.Prim, names: list[str]) -> Iterator[Issue]:
    """UsdSkel maps by name; exporters and engines that map by index need the same order."""
    animated = _animated(prim)
    if sorted(animated) == sorted(names) and animated != names:
        first = next(a for a, b in zip(names, animated, strict=True) if a != b)
        yield issue("TOKEN_ORDER", str(prim.GetPath()), f"the first at another index is {first!r}")


def _limits(attribute: Usd.Attribute, count: int) -> Floats | None:
    """(count, 2) hard limits of the weights, else soft ones; None where there are none, or not as
    many."""
    try:
        limits = attribute.GetMetadata("limits")
    except (Tf.ErrorException, RuntimeError):
        return None
    limits = getattr(limits, "value", limits)
    for kind in ("hard", "soft"):
        entry = limits.get(kind) if isinstance(limits, Mapping) else None
        if isinstance(entry, Mapping) and {"minimum", "maximum"} <= set(entry):
            try:
                ends = [
                    np.broadcast_to(np.asarray(entry[end], float), count)
                    for end in ("minimum", "maximum")
                ]
            except (TypeError, ValueError):
                return None
            return np.stack(ends, axis=1)
    return None


def _sample_faults(attribute: Usd.Attribute, names: tuple[str, ...], path: str) -> Iterator[Issue]:
    """What is wrong with the weights at each time at which they are authored; raises ARRAY_TYPE."""
    limits = _limits(attribute, len(names))
    for code in (Usd.TimeCode.Default(), *map(Usd.TimeCode, attribute.GetTimeSamples())):
        values = floats(attribute.Get(code), path, "blendShapeWeights")
        if len(values):
            yield from _weight_faults(values.astype(np.float64), names, limits, path, code)


def _weight_faults(
    values: Floats, names: tuple[str, ...], limits: Floats | None, path: str, code: Usd.TimeCode
) -> Iterator[Issue]:
    when = "" if code.IsDefault() else f" at time {code.GetValue():g}"
    if len(values) != len(names):
        yield issue(
            "ANIMATION_LENGTH",
            path,
            f"{len(names)} blendShapes but {len(values)} blendShapeWeights{when}",
        )
        return
    bad = ~np.isfinite(values)
    for index in np.flatnonzero(bad)[:1]:
        yield issue("NOT_FINITE", path, f"the weight of {names[index]!r}{when}")
    if limits is not None:
        slack = 1e-5 * np.maximum(1.0, np.abs(limits).max(axis=1))
        beyond = (values < limits[:, 0] - slack) | (values > limits[:, 1] + slack)
        for index in np.flatnonzero(beyond & ~bad):
            low, high = limits[index]
            what = f"{names[index]!r} has weights outside {low:g} to {high:g}, {values[index]:g}"
            yield issue(
                "WEIGHTS_BEYOND_LIMITS",
                path,
                f"{what}{when}" if when else f"{what} at the default time",
            )


def _topology(prim: Usd.Prim | None) -> str:
    """Hash of a mesh as it is; empty for anything else.  Raises ARRAY_TYPE."""
    if not prim or not prim.IsActive() or not prim.IsA(UsdGeom.Mesh):
        return ""
    mesh, path, time = UsdGeom.Mesh(prim), str(prim.GetPath()), Usd.TimeCode.Default()
    points = vector_count(value_at(mesh.GetPointsAttr(), time), path, "points")
    counts, indices = (
        integers(value_at(attribute, time), path, attribute.GetName())
        for attribute in (mesh.GetFaceVertexCountsAttr(), mesh.GetFaceVertexIndicesAttr())
    )
    return topology_hash(points, counts, indices)
