"""Skeletons and joints of one SkelRoot, and why UsdSkel moves a mesh by none although one is named
for it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel

from usdrigui.character import Channel, Floats, Joint, Skeleton
from usdrigui.character.skinning import under_parents
from usdrigui.errors import Issue, issue, refuse
from usdrigui.stages.arrays import quaternions, tokens, vector_count


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


class Frames:
    """Transforms relative to the SkelRoot at one time code; for the default time, at the
    earliest."""

    def __init__(self, root: Usd.Prim, time: Usd.TimeCode) -> None:
        self.time = time
        # Exporters often write transforms as samples only, which the default time does not see.
        self._cache = UsdGeom.XformCache(Usd.TimeCode.EarliestTime() if time.IsDefault() else time)
        self._world_to_root = self._cache.GetLocalToWorldTransform(root).GetInverse()

    def to_root(self, prim: Usd.Prim) -> Floats:
        """(4, 4) transform from the prim's space to root space."""
        found = np.array(
            self._cache.GetLocalToWorldTransform(prim) * self._world_to_root, dtype=np.float64
        )
        if not np.isfinite(found).all():
            raise refuse("NOT_FINITE", prim.GetPath(), "its transform holds NaN or infinity")
        return found

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
    # UsdSkel has no query for joints out of order.
    parents = np.array(query.GetTopology().GetParentIndices(), dtype=np.int64)
    bind = _matrices(
        query.GetJointWorldBindTransforms() if query.HasBindPose() else None, len(names)
    )
    if bind is None:
        raise refuse("SKELETON_INVALID", path, f"needs {len(names)} bindTransforms, one per joint")
    if not np.isfinite(bind).all() or (np.abs(np.linalg.det(bind)) < 1e-30).any():
        raise refuse("SKELETON_INVALID", path, "a bind transform cannot be inverted")
    rest = _matrices(query.ComputeJointLocalTransforms(Usd.TimeCode.Default(), True), len(names))
    if rest is None or not query.HasRestPose():
        rest = under_parents(bind, parents)
        issues.append(issue("REST_MISSING", path, f"{len(names)} joints"))
    base = rest if time is None else locals_at(armature, time, rest)
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


def repeated(names: Sequence[str], path: object, name: str) -> list[Issue]:
    """One issue for each token that a list names more than once."""
    return [
        issue("TOKEN_REPEATED", path, f"{name} lists {token!r} {count} times")
        for token, count in Counter(names).items()
        if count > 1
    ]


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
    shapes = tuple(map(str, animation.GetBlendShapeOrder())) if animation else ()
    to_root = frames.to_root(prim)
    if np.linalg.matrix_rank(to_root) < 4:
        what = "its transform, or that of a prim above it, collapses space (is a scale 0?)"
        raise refuse("SKELETON_INVALID", path, what)
    record = Skeleton(
        path, str(_in_instance(animated.GetPath(), prim)) if animated else "", to_root
    )
    names = tuple(map(str, query.GetJointOrder()))
    for twice in repeated(names, path, "joints"):
        raise refuse("SKELETON_INVALID", path, twice.message)
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


def _matrices(values: object, count: int) -> Floats | None:
    """(count, 4, 4), or None if there are not as many."""
    if values is None:
        return None
    matrices = np.array(values, dtype=np.float64).reshape(-1, 4, 4)
    return matrices if len(matrices) == count else None


def locals_at(armature: Armature, time: float, rest: Floats) -> Floats:
    """(joints, 4, 4) local transforms of the animation, rest transforms where it has none."""
    values = armature.query.ComputeJointLocalTransforms(Usd.TimeCode(time), False)
    matrices = _matrices(values, len(rest))
    return rest if matrices is None else matrices


# --- bound in vain --------------------------------------------------------------------------------
#
# UsdSkel ignores a binding without a message, and the repairs differ: applying a schema, giving a
# prim a type, or correcting a path.  Here the walk of `UsdSkel.Cache.Populate` is retraced to name
# the cause.


_SKELETON = "skel:skeleton"
_API = "SkelBindingAPI"
_INFLUENCES = "joint influences"


def why_unbound(prim: Usd.Prim) -> str:
    """What keeps the Skeleton that is named for a prim from it; empty where none is named.

    Only for prims below a SkelRoot that UsdSkel has bound to nothing.
    """
    chain = _up_to_skel_root(prim)
    named = [each for each in chain if each.GetRelationship(_SKELETON).HasAuthoredTargets()]
    if not named:
        return ""
    chosen = next((each for each in named if each.HasAPI(UsdSkel.BindingAPI)), None)
    if chosen is None:
        faults = [
            f"{_SKELETON} is authored on {named[0].GetPath()}, but {_API} is not applied there:"
            " apply it"
        ]
    else:
        faults = [_without_skeleton(chosen)]
    faults.append(_cut_off(chain[1:]))
    return "; ".join(filter(None, faults))


def bound_in_vain(
    stage: Usd.Stage, meshes: Iterable[str], bound: Container[Sdf.Path]
) -> tuple[Issue, ...]:
    """One for each of `meshes` that has joint influences and a Skeleton named, but none in `bound`.

    Meshes with blend shapes are left to `read_shapes`, which reports the same of them.
    """
    found = []
    for path in meshes:
        prim = stage.GetPrimAtPath(path)
        alone = prim.GetPath() not in bound and deforming(prim) == [_INFLUENCES]
        if alone and (why := why_unbound(prim)):
            found.append(issue("MESH_UNBOUND", path, f"has {_INFLUENCES}; {why}"))
    return tuple(found)


def deforming(prim: Usd.Prim) -> list[str]:
    """What would deform a mesh below a SkelRoot."""
    shapes = UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().HasAuthoredTargets()
    # Not asked of the API, whose primvars are invalid objects where it is not applied.
    indices = prim.GetAttribute("primvars:skel:jointIndices")
    joints = bool(indices) and indices.HasAuthoredValue()
    return ["blend shapes"] * shapes + [_INFLUENCES] * joints


def _up_to_skel_root(prim: Usd.Prim) -> list[Usd.Prim]:
    """The prim and those above it, the SkelRoot last: UsdSkel looks at nothing above that."""
    chain = [prim]
    while chain[-1].GetParent() and not chain[-1].IsA(UsdSkel.Root):
        chain.append(chain[-1].GetParent())
    return chain


def _without_skeleton(prim: Usd.Prim) -> str:
    """What is wrong with a binding that UsdSkel reads; empty if it leads to a Skeleton."""
    targets = prim.GetRelationship(_SKELETON).GetTargets()
    if not targets:
        return f"{_SKELETON} of {prim.GetPath()} has no target"
    skeleton = prim.GetStage().GetPrimAtPath(targets[0])
    if skeleton and skeleton.IsActive() and skeleton.IsA(UsdSkel.Skeleton):
        return ""
    return (
        f"{_SKELETON} of {prim.GetPath()} leads to {targets[0]}, which is not an active Skeleton:"
        " correct it"
    )


def _cut_off(above: list[Usd.Prim]) -> str:
    """Which of the prims above one, nearest first, UsdSkel does not look below; empty if none."""
    for prim in reversed(above):
        path, kind = prim.GetPath(), prim.GetTypeName()
        if not prim.IsA(UsdGeom.Imageable):
            what = f"is a {kind}, which is not imageable" if kind else "has no type"
            return f"{path} {what}, so that UsdSkel ignores all prims below it: make it an Xform"
        if prim.IsA(UsdGeom.PointBased):
            return (
                f"{path} is a {kind} itself, so that UsdSkel ignores all prims below it: move the"
                " mesh out"
            )
    return ""
