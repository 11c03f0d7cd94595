"""Skeletons, joints and authored animation of one SkelRoot."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel

from usdrigui.errors import Issue, RigUIError, issue, refuse
from usdrigui.model import Body, Channel, Clip, Floats, Joint, Skeleton
from usdrigui.usd.arrays import floats, quaternions, tokens, vector_count

_CLIP_BYTES = 128 * 1024 * 1024
"""Memory that a clip may take."""


@dataclass(frozen=True)
class Armature:
    """One Skeleton with its USD queries and its place among the joints of the rig."""

    record: Skeleton
    query: UsdSkel.SkeletonQuery
    animation: UsdSkel.AnimQuery | None
    joint_names: tuple[str, ...]
    index: int
    """Index of the Skeleton in `Body.skeletons`."""
    first: int
    """Index of its first joint in `Body.joints`."""
    tokens: tuple[str, ...]
    """Blend shapes that the animation lists."""

    @property
    def times(self) -> set[float]:
        """Time codes at which the animation is authored."""
        if self.animation is None:
            return set()
        return {
            *self.animation.GetBlendShapeWeightTimeSamples(),
            *self.animation.GetJointTransformTimeSamples(),
        }


@dataclass(frozen=True)
class State:
    """Everything a pose can set: (..., channels) weights and (..., joints, 4, 4) local
    transforms."""

    weights: Floats
    locals: Floats


@dataclass(frozen=True)
class Animated:
    """What poses a character, and whom to ask for its poses."""

    armatures: tuple[Armature, ...]
    body: Body

    @cached_property
    def base(self) -> State:
        """The base pose."""
        local = np.array([joint.base for joint in self.body.joints]).reshape(-1, 4, 4)
        return State(self.body.base_weights, local)

    def state(self, time: float, armatures: tuple[Armature, ...] = ()) -> State:
        """The animation of `armatures`, all if none are given, at a time code; the rest stays in
        the base pose.

        Raises ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE for weights.
        """
        weights, local = self.base.weights.copy(), self.base.locals.copy()
        authored = weights_at(self.armatures, self.body.channels, time)
        for armature in armatures or self.armatures:
            part = slice(armature.first, armature.first + len(armature.joint_names))
            rest = np.array([joint.rest for joint in self.body.joints[part]]).reshape(-1, 4, 4)
            local[part] = _locals_at(armature, time, rest)
            for index, channel in enumerate(self.body.channels):
                if channel.index >= 0 and channel.animation == armature.record.animation:
                    weights[index] = authored[index]
        return State(weights, local)


class Frames:
    """Transforms relative to the SkelRoot at one time code; for the default time, at the
    earliest."""

    def __init__(self, root: Usd.Prim, time: Usd.TimeCode) -> None:
        self.time = time
        # Exporters often write transforms as samples only, which the default time does not see.
        self._cache = UsdGeom.XformCache(Usd.TimeCode.EarliestTime() if time.IsDefault() else time)
        self._root = root
        self._world_to_root = self._cache.GetLocalToWorldTransform(root).GetInverse()

    def to_root(self, prim: Usd.Prim) -> Floats:
        """(4, 4) transform from the prim's space to root space."""
        found = np.array(
            self._cache.GetLocalToWorldTransform(prim) * self._world_to_root, dtype=np.float64
        )
        if not np.isfinite(found).all():
            raise refuse("NOT_FINITE", str(prim.GetPath()), "its transform holds NaN or infinity")
        return found

    def collapsing(self, prim: Usd.Prim) -> Usd.Prim | None:
        """The uppermost prim whose own transform cannot be inverted, of those between the prim's
        space and root space.

        None where each of them can by itself.
        """
        for end in (self._root, prim):
            chain = [end]
            while chain[-1].GetParent() and not self._cache.GetLocalTransformation(chain[-1])[1]:
                chain.append(chain[-1].GetParent())
            for each in reversed(chain):
                own = np.array(self._cache.GetLocalTransformation(each)[0], dtype=np.float64)
                if np.linalg.matrix_rank(own) < 4:
                    return each
        return None

    def direction(self, world: Gf.Vec3d) -> Floats:
        """(3,) unit vector in root space of a world direction."""
        return np.array(self._world_to_root.TransformDir(world).GetNormalized(), dtype=np.float64)


def read_armatures(
    skeletons: list[UsdSkel.Skeleton], cache: UsdSkel.Cache, frames: Frames
) -> tuple[Armature, ...]:
    """The bound Skeletons, in the order given, with their joints numbered through.

    Raises SKELETON_INVALID, ANIMATION_LENGTH and ARRAY_TYPE.
    """
    found: list[Armature] = []
    first = 0
    for index, skeleton in enumerate(skeletons):
        found.append(_armature(skeleton, cache, frames, index, first))
        first += len(found[-1].joint_names)
    return tuple(found)


def read_joints(
    armatures: tuple[Armature, ...], time: float | None, issues: list[Issue]
) -> tuple[Joint, ...]:
    """Joints of all Skeletons, based on the rest pose or, if `time` is given, on the animation
    there.

    Raises SKELETON_INVALID and NOT_FINITE.
    """
    return tuple(
        joint
        for armature in armatures
        if armature.joint_names
        for joint in _joints(armature, time, issues)
    )


def _joints(armature: Armature, time: float | None, issues: list[Issue]) -> list[Joint]:
    names, query, path = armature.joint_names, armature.query, armature.record.path
    parents = _parents(query, path)
    bind = _matrices(
        query.GetJointWorldBindTransforms() if query.HasBindPose() else None, len(names)
    )
    if bind is None:
        raise refuse("SKELETON_INVALID", path, f"needs {len(names)} bindTransforms, one per joint")
    if not np.isfinite(bind).all() or (np.abs(np.linalg.det(bind)) < 1e-30).any():
        raise refuse("SKELETON_INVALID", path, "a bind transform cannot be inverted")
    rest = _matrices(query.ComputeJointLocalTransforms(Usd.TimeCode.Default(), True), len(names))
    if rest is None or not query.HasRestPose():
        rest = bind.copy()
        inner = np.flatnonzero(parents >= 0)
        rest[inner] = bind[inner] @ np.linalg.inv(bind[parents[inner]])
        issues.append(issue("REST_MISSING", path, f"{len(names)} joints"))
    base = rest if time is None else _locals_at(armature, time, rest)
    if not (np.isfinite(rest).all() and np.isfinite(base).all()):
        raise refuse("NOT_FINITE", path, "a joint transform holds NaN or infinity")
    above = np.where(parents >= 0, parents + armature.first, -1).tolist()
    return [
        Joint(name, armature.index, above[i], bind[i], rest[i], base[i])
        for i, name in enumerate(names)
    ]


def read_channels(armatures: tuple[Armature, ...], issues: list[Issue]) -> tuple[Channel, ...]:
    """All blend-shape weights of all animations, each animation once."""
    channels: list[Channel] = []
    for path, listed in {each.record.animation: each.tokens for each in armatures}.items():
        place = {token: i for i, token in enumerate(listed)}
        channels.extend(Channel(token, path, i) for token, i in place.items())
        issues.extend(repeated(listed, path, "blendShapes"))
    return tuple(channels)


def repeated(names: Sequence[str], path: str, name: str) -> list[Issue]:
    """One issue for each token that a list names more than once."""
    return [
        issue("TOKEN_REPEATED", path, f"{name} lists {token!r} {count} times")
        for token, count in Counter(names).items()
        if count > 1
    ]


def read_clip(animated: Animated, rate: float, issues: list[Issue]) -> Clip | None:
    """The authored animation, or None where nothing has more than one time sample.

    Raises ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE.
    """
    armatures, body = animated.armatures, animated.body
    times = sorted({time for armature in armatures for time in armature.times})
    if len(times) < 2:
        return None
    most = max(2, _CLIP_BYTES // (128 * len(body.joints) + 8 * len(body.channels) + 1))
    if len(times) > most:
        path, what = armatures[0].record.animation, f"{most} of {len(times)} frames kept"
        issues.append(issue("CLIP_THINNED", path, what))
        times = [times[i] for i in np.linspace(0, len(times) - 1, most).round().astype(int)]
    return _sampled(animated, times, rate)


def read_still(animated: Animated, rate: float) -> Clip | None:
    """The one frame that USD evaluates where nothing moves; None where it cannot be shown."""
    time = min((time for armature in animated.armatures for time in armature.times), default=0.0)
    try:
        return _sampled(animated, [time], rate)
    except RigUIError:
        return None


def _sampled(animated: Animated, times: list[float], rate: float) -> Clip:
    """Weights and joints at each of `times`, which USD holds before the first and after the
    last."""
    states = [animated.state(time) for time in times]
    local = np.stack([state.locals for state in states])
    if not np.isfinite(local).all():
        raise refuse(
            "NOT_FINITE",
            animated.armatures[0].record.animation,
            "the animation holds NaN or infinity",
        )
    weights = np.stack([state.weights for state in states])
    return Clip(np.array(times, dtype=np.float64), weights, local, rate)


def weights_at(
    armatures: tuple[Armature, ...], channels: tuple[Channel, ...], time: float | None
) -> Floats:
    """(channels,) authored weights at a time code; None for the default value.

    Raises ANIMATION_LENGTH, ARRAY_TYPE and NOT_FINITE.
    """
    tables = {armature.record.animation: _weights(armature, time) for armature in armatures}
    values = [
        (
            tables[each.animation][each.index]
            if each.index >= 0 and len(tables[each.animation])
            else 0.0
        )
        for each in channels
    ]
    return np.array(values, dtype=np.float64)


def _weights(armature: Armature, time: float | None) -> Floats:
    """Weights of the animation's tokens; empty where none are authored."""
    if armature.animation is None or not armature.tokens:
        return np.zeros(0)
    code = Usd.TimeCode.Default() if time is None else Usd.TimeCode(time)
    path, animation = armature.record.animation, UsdSkel.Animation(armature.animation.GetPrim())
    authored = floats(animation.GetBlendShapeWeightsAttr().Get(code), path, "blendShapeWeights")
    if not len(authored):
        return np.zeros(0)
    if len(authored) != len(armature.tokens):
        raise refuse(
            "ANIMATION_LENGTH",
            path,
            f"{len(armature.tokens)} blendShapes but {len(authored)} blendShapeWeights"
            + ("" if time is None else f" at time {time:g}"),
        )
    values = np.asarray(authored, dtype=np.float64)
    if not np.isfinite(values).all():
        raise refuse("NOT_FINITE", path, "blendShapeWeights holds NaN or infinity")
    return values


def _in_instance(path: Sdf.Path, beside: Usd.Prim) -> Sdf.Path:
    """The path in the instance that the prim `beside` lies in, of one that UsdSkel gives in the
    prototype."""
    if not beside.IsInstanceProxy():
        return path
    shared = beside.GetPrimInPrototype()
    while not shared.IsPrototype():
        beside, shared = beside.GetParent(), shared.GetParent()
    return path.ReplacePrefix(shared.GetPath(), beside.GetPath())


def _armature(
    skeleton: UsdSkel.Skeleton, cache: UsdSkel.Cache, frames: Frames, index: int, first: int
) -> Armature:
    prim = skeleton.GetPrim()
    path = str(prim.GetPath())
    query = cache.GetSkelQuery(skeleton)
    if not query:
        raise refuse(
            "SKELETON_INVALID", path, "UsdSkel cannot use it; are the joint paths valid and unique?"
        )
    animation = query.GetAnimQuery()
    animated = animation.GetPrim() if animation else None
    shapes = tuple(str(token) for token in animation.GetBlendShapeOrder()) if animation else ()
    to_root = frames.to_root(prim)
    if np.linalg.matrix_rank(to_root) < 4:
        culprit = frames.collapsing(prim) or prim
        reason = "its transform collapses space (is a scale 0?)"
        below = "" if culprit == prim else f", and with it that of the Skeleton {path}"
        raise refuse("SKELETON_INVALID", str(culprit.GetPath()), f"{reason}{below}")
    record = Skeleton(
        path, str(_in_instance(animated.GetPath(), prim)) if animated else "", to_root
    )
    names = tuple(str(name) for name in query.GetJointOrder())
    if animation:
        _check_joint_values(UsdSkel.Animation(animated))
    return Armature(record, query, animation or None, names, index, first, shapes)


def _check_joint_values(animation: UsdSkel.Animation) -> None:
    """As many rotations, translations and scales as joints, wherever any are authored; raises also
    ARRAY_TYPE."""
    path, first = str(animation.GetPath()), Usd.TimeCode.EarliestTime()
    joints = tokens(animation.GetJointsAttr().Get(), path, "joints")
    if not joints:
        return
    counts = {
        "translations": vector_count(
            animation.GetTranslationsAttr().Get(first), path, "translations"
        ),
        "rotations": len(quaternions(animation.GetRotationsAttr().Get(first), path, "rotations")),
        "scales": vector_count(animation.GetScalesAttr().Get(first), path, "scales"),
    }
    for name, count in counts.items():
        if count not in (0, len(joints)):
            raise refuse("ANIMATION_LENGTH", path, f"{len(joints)} joints but {count} {name}")


def _parents(query: UsdSkel.SkeletonQuery, path: str) -> np.ndarray:
    topology = query.GetTopology()
    valid, reason = topology.Validate()
    if not valid:
        raise refuse("SKELETON_INVALID", path, str(reason))
    return np.array(topology.GetParentIndices(), dtype=np.int64)


def _matrices(values: object, count: int) -> Floats | None:
    """(count, 4, 4), or None if there are not as many."""
    if values is None:
        return None
    matrices = np.array(values, dtype=np.float64).reshape(-1, 4, 4)
    return matrices if len(matrices) == count else None


def _locals_at(armature: Armature, time: float, rest: Floats) -> Floats:
    """(joints, 4, 4) local transforms of the animation, rest transforms where it has none."""
    values = armature.query.ComputeJointLocalTransforms(Usd.TimeCode(time), False)
    matrices = _matrices(values, len(rest))
    return rest if matrices is None else matrices
