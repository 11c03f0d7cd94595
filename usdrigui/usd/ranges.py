"""The range of weights of each blend shape, and its source."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from pxr import Sdf, Tf, Usd, UsdSkel, Vt

from usdrigui.errors import Issue, issue
from usdrigui.model import Channel, Clip, Floats, RigMesh
from usdrigui.settings import ControlSettings
from usdrigui.usd.skeleton import Armature

Source = Literal["config", "limits", "animation", "inbetweens", "metadata", "default"]

SNAP = 0.01
"""An animation that leaves [0, 1] by no more than this is noise or overshoot, not a range."""


@dataclass(frozen=True)
class Range:
    """Between which values a control moves, where it rests, and where that comes from."""

    minimum: float
    default: float
    maximum: float
    source: Source


Pairs = list[list[float]]


@dataclass(frozen=True)
class Authored:
    """Ranges found in the asset, [minimum, maximum] per channel; NaN where nothing is authored."""

    limits: Pairs
    """`limits` metadata."""
    metadata: Pairs
    """``ranges`` in customData or customLayerData."""
    inbetweens: Pairs
    """Least and greatest weight of a shape."""
    animation: Pairs
    """Least and greatest animated weight."""


def read_ranges(
    root: Usd.Prim,
    armatures: tuple[Armature, ...],
    channels: tuple[Channel, ...],
    meshes: tuple[RigMesh, ...],
    weights: Floats,
    clip: Clip | None,
) -> tuple[Authored, tuple[Issue, ...]]:
    """The ranges in the asset; `weights` (channels,) are the SkelAnimation's default
    values."""
    issues: list[Issue] = []
    limits = _limits(armatures, channels, issues)
    metadata = _metadata(root, channels, issues)
    between = [[0.0, 1.0] for _ in channels]
    for mesh in meshes:
        for shape in mesh.binding.shapes:
            if len(shape.weights) > 1:
                low, high = between[shape.channel]
                between[shape.channel] = [
                    min(low, float(shape.weights[0])),
                    max(high, float(shape.weights[-1])),
                ]
    animated = weights[None] if clip is None else np.concatenate([weights[None], clip.weights])
    extent = np.stack([animated.min(axis=0), animated.max(axis=0)], axis=1)
    return Authored(limits.tolist(), metadata.tolist(), between, extent.tolist()), tuple(issues)


def blend_shape_range(
    channel: int, authored: Authored, override: ControlSettings, rest: float
) -> Range:
    """The range of a blend-shape weight whose weight in the base pose is `rest`.

    The first that speaks wins: configuration, `limits` metadata, then everything else together.
    Those only ever widen [0, 1] (or the range in the custom data): an animation that happens to
    open the jaw by a third does not limit it to a third.
    """
    found = _authored_range(channel, authored)
    if override.minimum is None and override.maximum is None and override.default is None:
        return Range(min(found[0], rest), rest, max(found[1], rest), found[2])
    minimum = found[0] if override.minimum is None else override.minimum
    maximum = found[1] if override.maximum is None else override.maximum
    default = min(max(rest, minimum), maximum) if override.default is None else override.default
    return Range(minimum, default, maximum, "config")


def custom_data(root: Usd.Prim, key: str) -> Any:
    """A value from the SkelRoot's customData or else a layer's customLayerData; JSON text is
    parsed."""
    places: Iterator[Mapping[str, Any]] = iter(
        [
            root.GetCustomData(),
            *(layer.customLayerData for layer in root.GetStage().GetLayerStack(False)),
        ]
    )
    value = next((place[key] for place in places if key in place), None)
    if isinstance(value, str):
        try:
            return json.loads(value)
        except (ValueError, RecursionError):
            return None
    return value


def _authored_range(channel: int, authored: Authored) -> tuple[float, float, Source]:
    low, high = authored.limits[channel]
    if not math.isnan(low):
        return low, high, "limits"
    source: Source = "metadata"
    low, high = authored.metadata[channel]
    if math.isnan(low):
        low, high, source = 0.0, 1.0, "default"
    others: tuple[tuple[Pairs, Source], ...] = (
        (authored.inbetweens, "inbetweens"),
        (authored.animation, "animation"),
    )
    for table, name in others:
        least, greatest = table[channel]
        if least < low - SNAP:
            low, source = least, name
        if greatest > high + SNAP:
            high, source = greatest, name
    return low, high, source


def _limits(
    armatures: tuple[Armature, ...], channels: tuple[Channel, ...], issues: list[Issue]
) -> Floats:
    """(channels, 2) from the `limits` metadata of blendShapeWeights (USD 25.11), soft before
    hard."""
    found = np.full((len(channels), 2), np.nan)
    tables: dict[str, Floats | None] = {}
    for armature in armatures:
        if armature.record.animation not in tables:
            tables[armature.record.animation] = _limit_table(armature, issues)
    for row, channel in enumerate(channels):
        table = tables.get(channel.animation)
        if table is not None and 0 <= channel.index < len(table):
            found[row] = table[channel.index]
    return found


def _limit_table(armature: Armature, issues: list[Issue]) -> Floats | None:
    if armature.animation is None:
        return None
    attribute = UsdSkel.Animation(armature.animation.GetPrim()).GetBlendShapeWeightsAttr()
    try:
        limits = attribute.GetMetadata("limits")
    except (Tf.ErrorException, RuntimeError):
        return None
    # Before 25.11 USD does not know the field and hands it over wrapped.
    limits = getattr(limits, "value", limits)
    if not isinstance(limits, Mapping):
        return None
    for kind in ("soft", "hard"):
        entry = limits.get(kind)
        if isinstance(entry, Mapping) and "minimum" in entry and "maximum" in entry:
            named = _tokens_of(entry, armature)
            found = _checked(entry, len(named), str(attribute.GetPath()), issues)
            if found is None or named is armature.tokens:
                return found
            return _by_token(found, named, armature.tokens)
    return None


def _tokens_of(entry: Mapping[str, Any], armature: Armature) -> Sequence[str]:
    """The blend shapes of which limits speak.

    A shot that adds shapes makes the list longer than the limits of the asset below it, which are
    then those of the strongest list of their length.
    """
    assert armature.animation is not None
    count = np.size(entry["minimum"])
    if count in (1, len(armature.tokens)):
        return armature.tokens
    attribute = UsdSkel.Animation(armature.animation.GetPrim()).GetBlendShapesAttr()
    lists = [spec.default for spec in attribute.GetPropertyStack()]
    known = (each for each in lists if isinstance(each, Vt.TokenArray) and len(each) == count)
    return list(next(known, armature.tokens))


def _by_token(table: Floats, named: Sequence[str], tokens: Sequence[str]) -> Floats:
    """(tokens, 2) the rows of `table` by their names; NaN for the others."""
    rows = dict(zip(named, table, strict=True))
    return np.array([rows.get(token, (np.nan, np.nan)) for token in tokens]).reshape(-1, 2)


def _checked(entry: Mapping[str, Any], count: int, path: str, issues: list[Issue]) -> Floats | None:
    try:
        ends = [
            np.broadcast_to(np.asarray(entry[end], dtype=np.float64), count)
            for end in ("minimum", "maximum")
        ]
    except (TypeError, ValueError):
        issues.append(issue("RANGE_INVALID", path, f"limits must hold {count} numbers each"))
        return None
    table = np.stack(ends, axis=1)
    bad = ~(np.isfinite(table).all(axis=1) & (table[:, 0] < table[:, 1]))
    if bad.any():
        issues.append(
            issue("RANGE_INVALID", path, f"limits of {np.count_nonzero(bad)} blend shapes")
        )
        table[bad] = np.nan
    return table


def _metadata(root: Usd.Prim, channels: tuple[Channel, ...], issues: list[Issue]) -> Floats:
    """(channels, 2) from ``ranges``: a dictionary, or JSON text of one, of token to [minimum,
    maximum]."""
    found = np.full((len(channels), 2), np.nan)
    ranges = custom_data(root, "ranges")
    if not isinstance(ranges, Mapping):
        return found
    for row, channel in enumerate(channels):
        if channel.token in ranges:
            pair = _pair(ranges[channel.token])
            if pair is None:
                issues.append(
                    issue("RANGE_INVALID", str(root.GetPath()), f"ranges of {channel.token!r}")
                )
            else:
                found[row] = pair
    return found


def _pair(value: Any) -> tuple[float, float] | None:
    try:
        low, high = (float(each) for each in value)
    except (TypeError, ValueError, OverflowError):
        return None
    return (low, high) if np.isfinite([low, high]).all() and low < high else None


def metres_per_unit(layer: Sdf.Layer) -> float | None:
    """metersPerUnit of the root layer, 0.01 if unauthored, None if unusable.

    Read from the layer, as the UsdGeom function raises where it was authored as float.
    """
    if not layer.pseudoRoot.HasInfo("metersPerUnit"):
        return 0.01
    try:
        value = float(layer.pseudoRoot.GetInfo("metersPerUnit"))
    except (TypeError, ValueError):
        return None
    return value if np.isfinite(value) and value > 0.0 else None
