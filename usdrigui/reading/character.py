"""From a stage to `Rig` records: every control, mesh, shape and joint of every SkelRoot.

The asset is only ever read.  What UsdSkel resolves (inherited bindings, joint orders, rest poses)
is asked of UsdSkel, so that a rig means here what it means in any other application.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from pxr import Gf, Sdf, Tf, Usd, UsdGeom, UsdRender, UsdSkel

from usdrigui.character import (
    Body,
    Channel,
    Clip,
    Floats,
    LeftOff,
    Rig,
)
from usdrigui.character.joint_tree import unit
from usdrigui.errors import Faults, Issue, issue, listed, of_character, refuse
from usdrigui.reading.blend_shape import Binding, Found, controls_of_tokens, left_off_tokens
from usdrigui.reading.clips import (
    MOST_FRAMES,
    Animated,
    read_clip,
    read_still,
    time_codes,
    weights_at,
)
from usdrigui.reading.control import (
    Draft,
    blend_shape_drafts,
    default_joint_drafts,
    has_limbs,
    ignored_motion,
    joint_drafts,
    pose_drafts,
    settled,
)
from usdrigui.reading.glyph import read_glyphs
from usdrigui.reading.mesh import drawable, hidden_issues, outside_issues, read_meshes
from usdrigui.reading.pose import FrameNames, named_poses, read_frame_names
from usdrigui.reading.range import read_ranges
from usdrigui.reading.refusal import (
    Reading,
    check_names,
    why_lost,
    without_controls,
)
from usdrigui.reading.skeleton import (
    Frames,
    bound_in_vain,
    read_armatures,
    read_channels,
    read_joints,
)
from usdrigui.settings import ReadSettings, Settings
from usdrigui.stages.opening import composition_issues, listening, open_stage, usd_message
from usdrigui.stages.variant_paths import with_sets
from usdrigui.stages.variants import variant_path


def read_rigs(source: Path | Usd.Stage, settings: Settings) -> tuple[Rig, ...]:
    """As `read_characters`; raises, all at once, what the configuration has wrong, too."""
    found = read_characters(source, settings)
    found.faults.raise_all()
    return found.rigs


@dataclass(frozen=True)
class Characters:
    """What `read_characters` finds."""

    rigs: tuple[Rig, ...]
    faults: Faults
    """What the configuration has wrong."""
    lost: tuple[Issue, ...]
    """Why characters that are laid out have nothing to control any more."""


def read_characters(
    source: Path | Usd.Stage, settings: Settings, laid_out: Collection[str] | None = None
) -> Characters:
    """One `Rig` per SkelRoot of the asset that has controls, or the one that `settings.read` names.

    `laid_out`: the SkelRoots that have a layout, where nothing is to be written below them: only
    these are read, in instances too, and one without controls or meshes is none of the rigs.
    Raises LAYOUT_STALE where none of them is there.

    Collects what the configuration has wrong: CONFIG_* and GLYPH_*.  Raises RigUIError: FILE_*,
    LAYER_*, SKELROOT_*, CONTROLS_MISSING, INSTANCE or, where no character is left, the code of the
    first array that cannot be right.  What can be lived with and
    what became no control stand in `Rig.left_off`; findings about the stage as a whole stand with
    the first rig.
    """
    faults = Faults()
    with listening() as messages:
        stage = (
            source if isinstance(source, Usd.Stage) else open_stage(source, settings.read.variants)
        )
        path = Path(stage.GetRootLayer().identifier) if isinstance(source, Usd.Stage) else source
        roots = skel_roots(stage, settings.read.skel_root)
        issues = (*composition_issues(stage, roots), *outside_issues(stage))
        if not roots:
            raise refuse("SKELROOT_MISSING", path, "no prim on the stage is a SkelRoot")
        if laid_out is not None:
            roots = tuple(root for root in roots if str(root.GetPath()) in laid_out)
            if not roots:
                raise refuse("LAYOUT_STALE", min(laid_out), f"{path} no longer has this character")
        instances = laid_out is not None
        readings = []
        for root in roots:
            with _usd_errors(str(root.GetPath())):
                readings.append(_read(root, settings, faults, instances=instances))
        with _usd_errors(str(path)):
            glyphs = read_glyphs(stage, path, settings, faults)
    check_names(readings, settings, faults)
    rigs = tuple(
        replace(reading.rig, glyphs=glyphs)
        for reading in readings
        if reading.rig.controls and reading.rig.body.meshes
    )
    lost = () if laid_out is None else why_lost(stage, readings)
    if not (rigs or lost):
        faults.raise_all()
        raise without_controls(stage, readings)
    if not rigs:
        return Characters((), faults, lost)
    spoken = tuple(issue("USD_DIAGNOSTIC", path, text) for text in messages)
    first = replace(rigs[0], issues=(*issues, *_unit_issues(stage), *spoken, *rigs[0].issues))
    return Characters((first, *rigs[1:]), faults, lost)


@contextmanager
def _usd_errors(path: str) -> Iterator[None]:
    """Turn USD's own exceptions into USD_ERROR."""
    try:
        yield
    except Tf.ErrorException as error:
        raise refuse("USD_ERROR", path, usd_message(error)) from None


def _read(root: Usd.Prim, settings: Settings, faults: Faults, *, instances: bool) -> Reading:
    if not instances and (root.IsInstance() or root.IsInstanceProxy()):
        instance = root
        while not instance.IsInstance():
            instance = instance.GetParent()
        reason = f"is an instance: no layer can add prims below {root.GetPath()}"
        raise refuse("INSTANCE", instance.GetPath(), reason)
    stage, read = root.GetStage(), settings.read
    bound = _bound(root, read.time, read.pose_names, drawable(root))
    animated, found = bound.animated, bound.found
    body, rate = animated.body, stage.GetTimeCodesPerSecond()
    if not instances:
        # No layer can override a Skeleton or an animation there; of meshes none needs to.
        for record in body.skeletons:
            for path in filter(None, (record.path, record.animation)):
                if stage.GetPrimAtPath(path).IsInstanceProxy():
                    raise refuse(
                        "INSTANCE", path, "moves the character and lies inside an instance"
                    )
    vain = bound_in_vain(stage, (mesh.path for mesh in body.meshes), bound.bindings)
    found.issues.extend((*vain, *hidden_issues(stage, body.meshes)))
    clip = read_clip(animated, rate, found.issues)
    drafts, lost = _drafts(root, bound, clip, settings, faults)
    controls, excluded, unused = settled(drafts, settings.controls, faults)
    lost += [*unused, *bound.names.left_off]
    weights = body.base_weights.copy()
    for control in controls:
        if control.kind == "blendShape":
            weights[control.drive.channels] = control.default  # A part of the base pose.
    path = with_sets(variant_path(root), read.variants)
    caches = map(UsdGeom.XformCache, _codes(root.GetStage()))
    placed = np.nan_to_num([cache.GetLocalToWorldTransform(root) for cache in caches])
    rig = Rig(
        path=str(root.GetPath()),
        variant_path=path,
        up=_up(root),
        metres_per_unit=metres_per_unit(stage.GetRootLayer()) or 0.01,
        clip=clip or read_still(animated, rate),
        time_codes=time_codes(stage),
        body=replace(body, base_weights=weights),
        controls=controls,
        left_off=tuple(lost),
        issues=of_character(path or str(root.GetPath()), tuple(found.issues)),
        excluded=excluded,
        camera=_camera(root, settings.candidates.view),
        to_world=placed if np.ptp(placed, axis=0).any() else placed[:1],
        shot_camera=_shot_camera(root.GetStage(), placed),
    )
    known = {draft.name for draft in drafts} | {dropped.control for dropped in lost}
    return Reading(rig, frozenset(known), vain, tuple(found.faults))


def read_animated(root: Usd.Prim, settings: ReadSettings, meshes: Sequence[Usd.Prim]) -> Animated:
    """Some of the meshes below a SkelRoot, those that draw a layout too, and what moves them;
    meshes whose arrays contradict each other are left off."""
    return _bound(root, settings.time, settings.pose_names, meshes).animated


@dataclass(frozen=True)
class _Bound:
    """Meshes of one SkelRoot and what poses them."""

    animated: Animated
    names: FrameNames
    found: Found
    bindings: Mapping[Sdf.Path, Binding]


def _bound(
    root: Usd.Prim, time: float | None, pose_names: str, prims: Iterable[Usd.Prim]
) -> _Bound:
    found = Found()
    frames = Frames(root, Usd.TimeCode.Default() if time is None else Usd.TimeCode(time))
    cache, everything = UsdSkel.Cache(), Usd.TraverseInstanceProxies()
    cache.Populate(UsdSkel.Root(root), everything)
    skeletons = [
        binding
        for binding in cache.ComputeSkelBindings(UsdSkel.Root(root), everything)
        # It moves something of this SkelRoot, not only of one nested in it.
        if any(
            UsdSkel.Root.Find(query.GetPrim()).GetPrim() == root
            for query in binding.GetSkinningTargets()
        )
    ]
    armatures = read_armatures([binding.GetSkeleton() for binding in skeletons], cache, frames)
    names = read_frame_names(root, armatures, pose_names, found.issues)
    if time is None and names.frames:
        time = names.frames[0].time  # The asset itself names the frame of its rest pose.
    joints = read_joints(armatures, time, found.issues)
    channels = read_channels(armatures, found.issues)
    found.tokens.update({(each.token, each.animation): i for i, each in enumerate(channels)})
    bindings = {
        query.GetPrim().GetPath(): Binding(armature, query)
        for binding, armature in zip(skeletons, armatures, strict=True)
        for query in binding.GetSkinningTargets()
    }
    meshes = read_meshes(prims, bindings, frames, found)
    channels = _with_unanimated(root, channels, found)
    records = tuple(armature.record for armature in armatures)
    weights = np.zeros(len(channels)) if time is None else weights_at(armatures, channels, time)
    body = Body(meshes, records, joints, channels, weights)
    return _Bound(Animated(armatures, body), names, found, bindings)


def _drafts(
    root: Usd.Prim, bound: _Bound, clip: Clip | None, settings: Settings, faults: Faults
) -> tuple[list[Draft], list[LeftOff]]:
    """Every control that the asset could have, and what is left off; the motion of a `clip` gives
    ranges."""
    animated, found, read = bound.animated, bound.found, settings.read
    body, named = animated.body, bool(bound.names.frames)
    ranges = read_ranges(root, animated, clip, found.issues)
    drafts = blend_shape_drafts(body, ranges, controls_of_tokens(found))
    by_place = read.joints == "auto" and has_limbs(body)
    which = "none" if by_place or (named and read.joints == "auto") else read.joints
    drafts += joint_drafts(body.joints, clip, which, settings)
    if read.joints != "none" and not named:
        found.issues += ignored_motion(str(root.GetPath()), body.joints, clip)
    poses = named_poses(bound.names.frames, animated, settings.poses, faults)
    more, still = pose_drafts(poses, animated.base, {draft.name for draft in drafts})
    lost = [*left_off_tokens(found, body), *still]
    if by_place or (read.joints == "auto" and not (drafts or more or lost or found.faults)):
        posed = {joint for pose in more for joint in pose.drive_over(pose.range).joints.tolist()}
        drafts += default_joint_drafts(body, clip, posed, settings.joints)
    return drafts + more, lost


def _with_unanimated(
    root: Usd.Prim, channels: tuple[Channel, ...], found: Found
) -> tuple[Channel, ...]:
    """The channels with those added that meshes name but no animation lists."""
    more = [token for (token, animation), index in found.tokens.items() if index >= len(channels)]
    if more:
        what = f"{len(more)} of them: {listed(more)}"
        found.issues.append(issue("TOKEN_NOT_ANIMATED", root.GetPath(), what))
    return (*channels, *(Channel(token, "", -1) for token in more))


def skel_roots(stage: Usd.Stage, wanted: str = "") -> tuple[Usd.Prim, ...]:
    """The SkelRoots of a stage, or the one `wanted`; raises SKELROOT_UNKNOWN where it is none."""
    roots = tuple(
        prim
        for prim in Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies())
        if prim.IsA(UsdSkel.Root)
    )
    if not wanted:
        return roots
    chosen = tuple(root for root in roots if str(root.GetPath()) == wanted)
    if not chosen:
        known = ", ".join(str(root.GetPath()) for root in roots) or "none"
        raise refuse("SKELROOT_UNKNOWN", wanted, f"the SkelRoots are: {known}")
    return chosen


def _up(root: Usd.Prim) -> Floats:
    is_z = UsdGeom.GetStageUpAxis(root.GetStage()) == UsdGeom.Tokens.z
    vertical = Gf.Vec3d(0, 0, 1) if is_z else Gf.Vec3d(0, 1, 0)
    return Frames(root, Usd.TimeCode.Default()).direction(vertical)


def _camera(root: Usd.Prim, view: str) -> Floats | None:
    """(3,) unit direction to the viewer of the camera that `view` names, if it names one; raises
    NOT_FINITE."""
    is_path = view.startswith("/") and Sdf.Path.IsValidPathString(view)[0]
    camera = UsdGeom.Camera.Get(root.GetStage(), view) if is_path else None
    if not camera:
        return None
    # A camera looks down its own -Z axis.
    return unit(Frames(root, Usd.TimeCode.Default()).to_root(camera.GetPrim())[2, :3])


def _codes(stage: Usd.Stage) -> Floats:
    """The time codes of a shot."""
    first, last, _ = time_codes(stage) or (0.0, 0.0, 0.0)
    return np.arange(first, last + 1.0)[:MOST_FRAMES]


def _shot_camera(stage: Usd.Stage, placed: Floats) -> Floats | None:
    """`Rig.shot_camera` of a character that is `placed` in the world (frames, 4, 4): the camera of
    the render settings of the stage, else its only one; None without one that sees in
    perspective."""
    settings = UsdRender.Settings.GetStageRenderSettings(stage)
    named = settings.GetCameraRel().GetForwardedTargets() if settings else []
    prims = [stage.GetPrimAtPath(path) for path in named] or stage.Traverse()
    cameras = [UsdGeom.Camera(prim) for prim in prims if prim and prim.IsA(UsdGeom.Camera)]
    if len(cameras) != 1 or cameras[0].GetProjectionAttr().Get() != UsdGeom.Tokens.perspective:
        return None
    rows = []
    for code, to_world in zip(_codes(stage), placed, strict=True):
        seen = cameras[0].GetCamera(code).frustum
        seen.Transform(Gf.Matrix4d(to_world).GetInverse())
        rows.append(np.append(np.array(seen.ComputeViewInverse())[:, :3], seen.window.max))
    return np.array(rows) if np.isfinite(rows).all() else None


def metres_per_unit(layer: Sdf.Layer) -> float | None:
    """metersPerUnit of a layer, 0.01 if unauthored, None if unusable.

    Read from the layer, as the UsdGeom function raises where it was authored as float.
    """
    info = layer.pseudoRoot
    try:
        value = float(info.GetInfo("metersPerUnit")) if info.HasInfo("metersPerUnit") else 0.01
    except (TypeError, ValueError):
        return None
    return value if math.isfinite(value) and value > 0.0 else None


def _unit_issues(stage: Usd.Stage) -> tuple[Issue, ...]:
    if metres_per_unit(stage.GetRootLayer()) is not None:
        return ()
    layer = stage.GetRootLayer()
    what = f"metersPerUnit is {layer.pseudoRoot.GetInfo('metersPerUnit')!r}; 0.01 is taken"
    return (issue("UNITS_TYPE", layer.identifier, what),)
