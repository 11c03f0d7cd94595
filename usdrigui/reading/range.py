"""The range of weights of each blend shape, and its source."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from pxr import Tf, Usd, UsdSkel, Vt

from usdrigui.character import Clip, Floats
from usdrigui.errors import Issue, issue
from usdrigui.reading.clips import Animated, weights_at
from usdrigui.reading.skeleton import Armature

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


def read_ranges(
    root: Usd.Prim, animated: Animated, clip: Clip | None, issues: list[Issue]
) -> list[Range]:
    """The range of each channel about its weight in the base pose.

    `limits` metadata win.  Everything else only ever widens [0, 1] or the range in the custom
    data: an animation that happens to open the jaw by a third does not limit it to a third.
    """
    channels, base = animated.body.channels, animated.base.weights.tolist()
    limits = {each.record.animation: limits_of(each, issues) for each in animated.armatures}
    custom = _custom_ranges(root, {channel.token for channel in channels}, issues)
    between, reached = _inbetween_ends(animated), _animated_ends(animated, clip)
    ranges = []
    for index, (channel, rest) in enumerate(zip(channels, base, strict=True)):
        low, high = custom.get(channel.token, (0.0, 1.0))
        source: Source = "metadata" if channel.token in custom else "default"
        low, high, source = _widened(low, high, source, between[index], "inbetweens")
        low, high, source = _widened(low, high, source, reached[index], "animation")
        limit = limits.get(channel.animation, {}).get(channel.token)
        if limit is not None:
            low, high, source = *limit, "limits"
        ranges.append(Range(min(low, rest), rest, max(high, rest), source))
    return ranges


def _widened(
    low: float, high: float, source: Source, ends: Sequence[float], evidence: Source
) -> tuple[float, float, Source]:
    """A range with the `ends` that something reaches outside of it."""
    if ends[0] < low - SNAP:
        low, source = ends[0], evidence
    if ends[1] > high + SNAP:
        high, source = ends[1], evidence
    return low, high, source


def _inbetween_ends(animated: Animated) -> list[list[float]]:
    """Least and greatest weight of the shapes of each channel that have in-betweens."""
    ends = [[0.0, 1.0] for _ in animated.body.channels]
    for mesh in animated.body.meshes:
        for shape in mesh.shapes:
            if len(shape.weights) > 1:
                known = [*ends[shape.channel], *shape.weights.tolist()]
                ends[shape.channel] = [min(known), max(known)]
    return ends


def _animated_ends(animated: Animated, clip: Clip | None) -> list[list[float]]:
    """Least and greatest animated weight of each channel, default values included."""
    weights = weights_at(animated.armatures, animated.body.channels, None)[None]
    if clip is not None:
        weights = np.concatenate([weights, clip.weights])
    ends: list[list[float]] = np.stack([weights.min(axis=0), weights.max(axis=0)], axis=1).tolist()
    return ends


# --- limits metadata ------------------------------------------------------------------------------


def limit_entries(attribute: Usd.Attribute) -> dict[str, Mapping[str, Any]]:
    """The entries of `limits` metadata (USD 25.11) that have a minimum and a maximum, by kind:
    ``soft`` and ``hard``."""
    try:
        limits = attribute.GetMetadata("limits")
    except (Tf.ErrorException, RuntimeError):
        return {}
    # Before 25.11 USD does not know the field and hands it over wrapped.
    limits = getattr(limits, "value", limits)
    return {
        kind: entry
        for kind, entry in (limits.items() if isinstance(limits, Mapping) else ())
        if isinstance(entry, Mapping) and {"minimum", "maximum"} <= set(entry)
    }


def limit_table(entry: Mapping[str, Any], count: int) -> Floats | None:
    """(count, 2) minima and maxima of an entry; None where it does not hold as many numbers."""
    try:
        ends = [
            np.broadcast_to(np.asarray(entry[end], dtype=np.float64), count)
            for end in ("minimum", "maximum")
        ]
    except (TypeError, ValueError):
        return None
    return np.stack(ends, axis=1)


def limits_of(armature: Armature, issues: list[Issue]) -> dict[str, tuple[float, float]]:
    """Limits of the weights of an animation by token, soft before hard."""
    if armature.animation is None:
        return {}
    animation = UsdSkel.Animation(armature.animation.GetPrim())
    path = str(animation.GetBlendShapeWeightsAttr().GetPath())
    entries = limit_entries(animation.GetBlendShapeWeightsAttr())
    entry = entries.get("soft", entries.get("hard"))
    if entry is None:
        return {}
    names = _limited(entry, armature.tokens, animation.GetBlendShapesAttr())
    table = limit_table(entry, len(names))
    if table is None:
        issues.append(issue("RANGE_INVALID", path, f"limits must hold {len(names)} numbers each"))
        return {}
    valid = np.isfinite(table).all(axis=1) & (table[:, 0] < table[:, 1])
    if not valid.all():
        what = f"limits of {np.count_nonzero(~valid)} blend shapes"
        issues.append(issue("RANGE_INVALID", path, what))
    return {
        name: (low, high)
        for name, (low, high), is_valid in zip(names, table.tolist(), valid, strict=True)
        if is_valid
    }


def _limited(
    entry: Mapping[str, Any], tokens: Sequence[str], attribute: Usd.Attribute
) -> Sequence[str]:
    """The blend shapes of which limits speak.

    A shot that adds shapes makes the list longer than the limits of the asset below it, which are
    then those of the strongest list of their length.
    """
    count = np.size(entry["minimum"])
    if count in (1, len(tokens)):
        return tokens
    lists = [spec.default for spec in attribute.GetPropertyStack()]
    known = (each for each in lists if isinstance(each, Vt.TokenArray) and len(each) == count)
    return list(next(known, tokens))


# --- custom data ----------------------------------------------------------------------------------


def custom_data(root: Usd.Prim, key: str) -> Any:
    """A value from the SkelRoot's customData or else a layer's customLayerData; JSON text is
    parsed."""
    layers = root.GetStage().GetLayerStack(False)
    places = (root.GetCustomData(), *(layer.customLayerData for layer in layers))
    value = next((place[key] for place in places if key in place), None)
    if isinstance(value, str):
        try:
            return json.loads(value)
        except (ValueError, RecursionError):
            return None
    return value


def _custom_ranges(
    root: Usd.Prim, tokens: set[str], issues: list[Issue]
) -> dict[str, tuple[float, float]]:
    """What ``ranges`` says of `tokens`: a dictionary, or JSON text of one, of token to [minimum,
    maximum]."""
    ranges = custom_data(root, "ranges")
    named = tokens.intersection(ranges) if isinstance(ranges, Mapping) else ()
    pairs = {token: _pair(ranges[token]) for token in sorted(named)}
    path = str(root.GetPath())
    issues += [
        issue("RANGE_INVALID", path, f"ranges of {token!r}")
        for token, pair in pairs.items()
        if pair is None
    ]
    return {token: pair for token, pair in pairs.items() if pair is not None}


def _pair(value: Any) -> tuple[float, float] | None:
    try:
        low, high = map(float, value)
    except (TypeError, ValueError, OverflowError):
        return None
    return (low, high) if np.isfinite([low, high]).all() and low < high else None
