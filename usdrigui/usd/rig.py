"""From a stage to `Rig` records: every control, mesh, shape and joint of every SkelRoot.

The asset is only ever read.  What UsdSkel resolves (inherited bindings, joint orders, rest poses)
is asked of UsdSkel, so that a rig means here what it means in any other application.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from pxr import Gf, Sdf, Tf, Usd, UsdGeom, UsdSkel

from usdrigui.errors import Faults, Issue, RigUIError, issue, listed, meant, of_character, refuse
from usdrigui.model import (
    Body,
    Channel,
    Clip,
    Configured,
    Control,
    Findings,
    Floats,
    Glyph,
    Joint,
    LeftOff,
    Rig,
    RigMesh,
    SkelRoot,
)
from usdrigui.settings import ControlSettings, ReadSettings, RigSettings, Settings
from usdrigui.usd.binding import bound_in_vain
from usdrigui.usd.controls import (
    Draft,
    State,
    blend_shape_drafts,
    default_joint_drafts,
    ignored_motion,
    joint_drafts,
    joint_names,
    pose_drafts,
    settled,
    unknown_joints,
    unknown_names,
)
from usdrigui.usd.glyphs import read_glyphs
from usdrigui.usd.hidden import hidden_issues
from usdrigui.usd.mesh import outside_issues, read_meshes
from usdrigui.usd.poses import FrameNames, named_poses, read_frame_names
from usdrigui.usd.ranges import metres_per_unit, read_ranges
from usdrigui.usd.read_layout import switched_off
from usdrigui.usd.schema import SCOPE
from usdrigui.usd.shapes import Binding, Found, left_off_tokens
from usdrigui.usd.skeleton import (
    Armature,
    Frames,
    read_armatures,
    read_channels,
    read_clip,
    read_joints,
    read_still,
    weights_at,
)
from usdrigui.usd.stage import composition_issues, listening, open_stage, usd_message
from usdrigui.usd.variant_paths import with_sets
from usdrigui.usd.variants import variant_path

_BINDINGS = ("skel:blendShapes", "primvars:skel:jointIndices")
"""Attributes by which a mesh is moved."""
_JOINTS_TOLD = 12
"""Names of joints in one message."""
_REASONS_TOLD = 3
"""Reasons in one message."""
_ROOTS_TOLD = 3
"""SkelRoots in one message."""
_VARIANTS_TRIED = 64
"""Variants that are looked into for a character that the selected ones lack."""


def read_rigs(
    source: Path | Usd.Stage, settings: Settings, laid_out: Collection[str] | None = None
) -> tuple[Rig, ...]:
    """As `read_characters`; raises, all at once, what the configuration has wrong, too."""
    found = read_characters(source, settings.rig, laid_out)
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
    source: Path | Usd.Stage, settings: RigSettings, laid_out: Collection[str] | None = None
) -> Characters:
    """One `Rig` per SkelRoot of the asset that has controls, or the one that `settings.read` names.

    `laid_out`: the SkelRoots that have a layout, where nothing is to be written below them: only
    these are read, in instances too, and one without controls or meshes is none of the rigs.
    Raises LAYOUT_STALE where none of them is there.

    Collects what the configuration has wrong: CONFIG_* and GLYPH_*.  Raises RigUIError: FILE_*,
    LAYER_*, SKELROOT_*, CONTROLS_MISSING, INSTANCE or, where no character is left, the code of the
    first array that cannot be right.  What can be lived with and
    what became no control stand in `Rig.findings`; findings about the stage as a whole stand with
    the first rig.
    """
    faults = Faults()
    with listening() as messages:
        stage = (
            source if isinstance(source, Usd.Stage) else open_stage(source, settings.read.variants)
        )
        path = Path(stage.GetRootLayer().identifier) if isinstance(source, Usd.Stage) else source
        roots = _skel_roots(stage, settings.read.skel_root)
        issues = (*composition_issues(stage, roots), *outside_issues(stage))
        if not roots:
            raise refuse(
                "SKELROOT_MISSING",
                str(path),
                f"no prim on the stage is a SkelRoot{_in_variants(stage)}",
            )
        if laid_out is not None:
            roots = _with_layout(roots, laid_out, path)
        instances = laid_out is not None
        readings = [_guarded(root, settings, faults, instances=instances) for root in roots]
        glyphs = _guarded_glyphs(stage, path, settings.controls, settings.read.size_limit, faults)
    _check_names(readings, settings.controls, settings.joints, faults)
    rigs = tuple(
        replace(reading.rig, configured=replace(reading.rig.configured, glyphs=glyphs))
        for reading in readings
        if reading.rig.controls and reading.rig.body.meshes
    )
    lost = () if laid_out is None else _lost(stage, readings)
    if not (rigs or lost):
        faults.raise_all()
        raise _without_controls(stage, readings)
    if not rigs:
        return Characters((), faults, lost)
    spoken = tuple(issue("USD_DIAGNOSTIC", str(path), text) for text in messages)
    first = _with_issues(rigs[0], (*issues, *_unit_issues(stage), *spoken))
    return Characters((first, *rigs[1:]), faults, lost)


def _without_controls(stage: Usd.Stage, readings: list[_Reading]) -> RigUIError:
    """Why none of some characters has anything to control."""
    broken = [fault for reading in readings for fault in reading.faults]
    if broken:
        return broken[0]
    lost = [each for reading in readings for each in reading.rig.findings.left_off]
    reasons = tuple({each.reason for each in lost})
    vain = [
        each
        for reading in readings
        for each in reading.bound_in_vain
        if not each.message.endswith(reasons)
    ]
    off = "".join(_inactive_clause(stage, reading.rig.skel_root.path) for reading in readings)
    why = f"{_lost_clause(lost)}{_vain_clause(vain)}{off}" or _joints_clause(readings[0])
    meshes = any(reading.rig.body.meshes for reading in readings)
    what = "no blend shape, animated joint or named pose" if meshes else "no mesh to move"
    return refuse("CONTROLS_MISSING", readings[0].rig.skel_root.path, f"{what}{why}")


def _lost(stage: Usd.Stage, readings: list[_Reading]) -> tuple[Issue, ...]:
    """Why characters that are laid out have nothing to control."""
    found = []
    for reading in readings:
        root = reading.rig.skel_root.path
        if not reading.rig.body.meshes:
            what = f"none of its meshes is left{_inactive_clause(stage, root)}"
            found.append(issue("LAYOUT_MESH_GONE", root, what, root))
        elif not reading.rig.controls:
            found += of_character(root, _without_controls(stage, [reading]).issues)
    return tuple(found)


def without_layout(stage: Usd.Stage, laid_out: Collection[str], wanted: str) -> tuple[Issue, ...]:
    """LAYOUT_OFF or LAYOUT_NONE for each SkelRoot, or the one `wanted`, that something animates and
    that is not `laid_out`."""
    roots = [str(root.GetPath()) for root in _skel_roots(stage, wanted) if _is_animated(root)]
    off = {where: selected for selected, paths in switched_off(stage).items() for where in paths}
    return tuple(_bare(root, off) for root in roots if root not in laid_out)


def _bare(root: str, off: Mapping[str, str]) -> Issue:
    """That a character has no layout, or has one that is switched off on it or above it."""
    for where, selected in off.items():
        if f"{root}/".startswith(f"{where}/"):
            what = f"its layout is switched off, by rigUI = {selected} on {where}"
            return replace(issue("LAYOUT_OFF", root, what, root), severity="info")
    return issue("LAYOUT_NONE", root, "has no layout; other characters of the stage have one", root)


def _is_animated(root: Usd.Prim) -> bool:
    """Whether joints or blend shapes move a mesh below it; a prop without either is no
    character."""
    return any(
        attribute.HasAuthoredValue()
        for prim in Usd.PrimRange(root, Usd.TraverseInstanceProxies())
        if prim.IsA(UsdGeom.Mesh)
        for attribute in map(prim.GetAttribute, _BINDINGS)
    )


@dataclass(frozen=True)
class _Reading:
    """A rig and the names that the configuration may use for it."""

    rig: Rig
    unknown_controls: set[str]
    unknown_joints: set[str]
    bound_in_vain: tuple[Issue, ...]
    """Meshes with joint influences that no Skeleton moves although one is named."""
    faults: tuple[RigUIError, ...]
    """Why parts were left off."""


@dataclass(frozen=True)
class _Scene:
    """The content of one SkelRoot, before anything is called a control."""

    armatures: tuple[Armature, ...]
    joints: tuple[Joint, ...]
    channels: tuple[Channel, ...]
    meshes: tuple[RigMesh, ...]
    base_weights: Floats
    authored_weights: Floats
    clip: Clip | None
    """Motion, which gives ranges."""
    still: Clip | None
    """Where nothing moves."""
    names: FrameNames
    found: Found
    bound_in_vain: tuple[Issue, ...]


def _with_layout(
    roots: tuple[Usd.Prim, ...], laid_out: Collection[str], path: Path
) -> tuple[Usd.Prim, ...]:
    found = tuple(root for root in roots if str(root.GetPath()) in laid_out)
    if not found:
        raise refuse("LAYOUT_STALE", min(laid_out), f"{path} no longer has this character")
    return found


def _guarded(root: Usd.Prim, settings: RigSettings, faults: Faults, *, instances: bool) -> _Reading:
    """`_read`, with USD's own exceptions turned into RigUIError."""
    try:
        return _read(root, settings, faults, instances=instances)
    except Tf.ErrorException as error:
        raise refuse("USD_ERROR", str(root.GetPath()), usd_message(error)) from None


def _guarded_glyphs(
    stage: Usd.Stage,
    path: Path,
    controls: Mapping[str, ControlSettings],
    size_limit: int,
    faults: Faults,
) -> dict[str, Glyph]:
    try:
        return read_glyphs(stage, path, controls, size_limit, faults)
    except Tf.ErrorException as error:
        raise refuse("USD_ERROR", str(path), usd_message(error)) from None


def _read(root: Usd.Prim, settings: RigSettings, faults: Faults, *, instances: bool) -> _Reading:
    if not instances and (root.IsInstance() or root.IsInstanceProxy()):
        reason = (
            f"is an instance: no layer can add prims below {root.GetPath()}{_others_clause(root)}"
        )
        raise refuse("INSTANCE", str(_instance(root).GetPath()), reason)
    scene = _scene(root, settings.read, instances=instances)
    drafts, left_off, issues = _drafts(root, scene, settings, faults)
    controls, excluded, unused = settled(drafts, settings.controls, faults)
    lost = (*left_off, *unused, *scene.names.left_off)
    path = with_sets(variant_path(root), settings.read.variants)
    found = (*scene.found.issues, *scene.names.issues, *issues)
    rig = Rig(
        skel_root=SkelRoot(
            path=str(root.GetPath()),
            variant_path=path,
            up=_up(root),
            metres_per_unit=metres_per_unit(root.GetStage().GetRootLayer()) or 0.01,
            clip=scene.clip or scene.still,
        ),
        body=Body(
            meshes=scene.meshes,
            skeletons=tuple(armature.record for armature in scene.armatures),
            joints=scene.joints,
            channels=scene.channels,
            base_weights=_rest_weights(scene, controls),
        ),
        controls=controls,
        findings=Findings(lost, of_character(path or str(root.GetPath()), found)),
        configured=Configured(excluded),
    )
    unknown = unknown_names(drafts, list(lost), settings.controls)
    joints = unknown_joints(scene.joints, settings.joints)
    return _Reading(rig, unknown, joints, scene.bound_in_vain, tuple(scene.found.faults))


def _scene(root: Usd.Prim, settings: ReadSettings, *, instances: bool) -> _Scene:
    cache = UsdSkel.Cache()
    everything = Usd.TraverseInstanceProxies()
    skel_root = UsdSkel.Root(root)
    cache.Populate(skel_root, everything)
    bindings = [
        each for each in cache.ComputeSkelBindings(skel_root, everything) if _belongs(each, root)
    ]
    time = settings.time
    frames = Frames(root, Usd.TimeCode.Default() if time is None else Usd.TimeCode(time))
    armatures = read_armatures([each.GetSkeleton() for each in bindings], cache, frames)
    names = read_frame_names(root, armatures, settings.pose_names)
    if time is None and names.frames:
        time = names.frames[0].time  # The asset itself names the frame of its rest pose.
    found = Found()
    joints = _joints(armatures, time, found)
    channels, notes = read_channels(armatures)
    found.issues.extend(notes)
    found.tokens.update({(each.token, each.animation): i for i, each in enumerate(channels)})
    bound = _bound(bindings, armatures)
    if not instances:
        _refuse_instances(armatures, root.GetStage())
    meshes = read_meshes(root, bound, frames, found)
    vain = bound_in_vain(root.GetStage(), (mesh.path for mesh in meshes), bound)
    found.issues.extend((*vain, *hidden_issues(root.GetStage(), meshes, frames.time)))
    channels = _with_unanimated(root, channels, found)
    rate = root.GetStage().GetTimeCodesPerSecond()
    clip, notes = read_clip(armatures, joints, channels, rate)
    still = read_still(armatures, joints, channels, rate) if clip is None else None
    found.issues.extend(notes)
    authored = weights_at(armatures, channels, None)
    base = np.zeros(len(channels)) if time is None else weights_at(armatures, channels, time)
    return _Scene(
        armatures, joints, channels, meshes, base, authored, clip, still, names, found, vain
    )


def _drafts(
    root: Usd.Prim, scene: _Scene, settings: RigSettings, faults: Faults
) -> tuple[list[Draft], list[LeftOff], tuple[Issue, ...]]:
    """Every control that the asset could have, what is left off, and what is odd about the
    ranges."""
    used = {shape.channel for mesh in scene.meshes for shape in mesh.binding.shapes}
    authored, issues = read_ranges(
        root, scene.armatures, scene.channels, scene.meshes, scene.authored_weights, scene.clip
    )
    drafts = blend_shape_drafts(
        scene.channels, used, authored, scene.base_weights, settings.controls
    )
    drafts += joint_drafts(
        scene.joints, scene.clip, bool(scene.names.frames), settings.read, settings.joints
    )
    if settings.read.joints != "none" and not scene.names.frames:
        issues += ignored_motion(str(root.GetPath()), scene.joints, scene.clip)
    base = State(
        scene.base_weights, np.array([joint.base for joint in scene.joints]).reshape(-1, 4, 4)
    )
    poses = named_poses(
        scene.names.frames,
        scene.armatures,
        scene.joints,
        scene.channels,
        base,
        settings.poses,
        faults,
    )
    more, left_off = pose_drafts(poses, base, {draft.name for draft in drafts})
    lost = [*left_off_tokens(scene.found, used), *left_off]
    if not (drafts or more or lost or scene.found.faults) and settings.read.joints == "auto":
        drafts = default_joint_drafts(scene.joints, scene.meshes, len(scene.channels))
    return drafts + more, lost, issues


def _joints(armatures: tuple[Armature, ...], time: float | None, found: Found) -> tuple[Joint, ...]:
    joints: list[Joint] = []
    for armature in armatures:
        some, issues = read_joints(armature, time)
        joints.extend(some)
        found.issues.extend(issues)
    return tuple(joints)


def _refuse_instances(armatures: tuple[Armature, ...], stage: Usd.Stage) -> None:
    """Raise INSTANCE for a skeleton or an animation that no layer can override; of meshes
    none needs to."""
    for path in (
        path for each in armatures for path in (each.record.path, each.record.animation) if path
    ):
        if stage.GetPrimAtPath(path).IsInstanceProxy():
            raise refuse("INSTANCE", path, "moves the character and lies inside an instance")


def _belongs(binding: UsdSkel.Binding, root: Usd.Prim) -> bool:
    """Whether it moves anything of this SkelRoot, not only of one nested in it."""
    return any(
        UsdSkel.Root.Find(query.GetPrim()).GetPrim() == root
        for query in binding.GetSkinningTargets()
    )


def _bound(
    bindings: list[UsdSkel.Binding], armatures: tuple[Armature, ...]
) -> dict[Sdf.Path, Binding]:
    return {
        query.GetPrim().GetPath(): Binding(armature, query)
        for binding, armature in zip(bindings, armatures, strict=True)
        for query in binding.GetSkinningTargets()
    }


def _with_unanimated(
    root: Usd.Prim, channels: tuple[Channel, ...], found: Found
) -> tuple[Channel, ...]:
    """The channels with those added that meshes name but no animation lists."""
    more = [token for (token, animation), index in found.tokens.items() if index >= len(channels)]
    if more:
        listed = ", ".join(more[:3]) + (" and more" if len(more) > 3 else "")
        found.issues.append(
            issue("TOKEN_NOT_ANIMATED", str(root.GetPath()), f"{len(more)} of them: {listed}")
        )
    return (*channels, *(Channel(token, "", -1) for token in more))


def _rest_weights(scene: _Scene, controls: tuple[Control, ...]) -> Floats:
    """(channels,) weights of the base pose; the default of a control is part of it."""
    weights = scene.base_weights.copy()
    for control in controls:
        if control.kind == "blendShape":
            weights[control.drive.channels] = control.default
    return weights


def _skel_roots(stage: Usd.Stage, wanted: str) -> tuple[Usd.Prim, ...]:
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


def _in_variants(stage: Usd.Stage) -> str:
    """A clause with the variants that would bring in a SkelRoot, each being selected by itself;
    empty without."""
    places = [
        (prim.GetPath(), name, variant)
        for prim in stage.Traverse()
        for name in prim.GetVariantSets().GetNames()
        for variant in prim.GetVariantSet(name).GetVariantNames()
        if variant != prim.GetVariantSet(name).GetVariantSelection()
    ]
    found = []
    with Usd.EditContext(stage, stage.GetSessionLayer()):
        for path, name, variant in places[:_VARIANTS_TRIED]:
            stage.GetPrimAtPath(path).GetVariantSet(name).SetVariantSelection(variant)
            below = Usd.PrimRange(stage.GetPrimAtPath(path), Usd.TraverseInstanceProxies())
            if any(prim.IsA(UsdSkel.Root) for prim in below):
                found.append(f"{variant!r} of the variant set {name!r} of {path}")
            stage.GetPrimAtPath(path).GetVariantSet(name).ClearVariantSelection()
    return (
        f"; there is one in {', '.join(found[:3])}{' and more' if len(found) > 3 else ''}"
        if found
        else ""
    )


def _instance(prim: Usd.Prim) -> Usd.Prim:
    """The instance that a prim is or lies in."""
    while not prim.IsInstance() and prim.GetParent():
        prim = prim.GetParent()
    return prim


def _others_clause(instance: Usd.Prim) -> str:
    """A clause with the SkelRoots beside one in an instance that are in none; empty if there are no
    such."""
    roots = _skel_roots(instance.GetStage(), "")
    free = [
        str(each.GetPath())
        for each in roots
        if not each.IsInstance() and not each.IsInstanceProxy()
    ]
    if not free:
        return ""
    return (
        "; in no instance:"
        f" {', '.join(free[:_ROOTS_TOLD])}{' and more' if len(free) > _ROOTS_TOLD else ''}"
    )


def _up(root: Usd.Prim) -> Floats:
    vertical = (
        Gf.Vec3d(0, 0, 1)
        if UsdGeom.GetStageUpAxis(root.GetStage()) == UsdGeom.Tokens.z
        else Gf.Vec3d(0, 1, 0)
    )
    return Frames(root, Usd.TimeCode.Default()).direction(vertical)


def _unit_issues(stage: Usd.Stage) -> tuple[Issue, ...]:
    layer = stage.GetRootLayer()
    value = (
        layer.pseudoRoot.GetInfo("metersPerUnit")
        if layer.pseudoRoot.HasInfo("metersPerUnit")
        else None
    )
    if metres_per_unit(layer) is None:
        return (
            issue("UNITS_TYPE", layer.identifier, f"metersPerUnit is {value!r}; 0.01 is taken"),
        )
    return ()


def _check_names(
    readings: list[_Reading], controls: Iterable[str], joints: Iterable[str], faults: Faults
) -> None:
    """Collect CONFIG_UNKNOWN_CONTROL for names in the configuration that no rig knows."""
    for name in controls:
        if all(name in reading.unknown_controls for reading in readings):
            hint = meant(
                name, (control.name for reading in readings for control in reading.rig.controls)
            )
            what = f"no rig of the asset has this control{hint}"
            with faults.collected():
                raise refuse("CONFIG_UNKNOWN_CONTROL", f'controls."{name}"', what)
    for name in joints:
        if all(name in reading.unknown_joints for reading in readings):
            hint = meant(
                name,
                (
                    each
                    for reading in readings
                    for each in _names_of_joints(reading.rig.body.joints)
                ),
            )
            known = hint or "".join(map(_joints_clause, readings))
            with faults.collected():
                raise refuse(
                    "CONFIG_UNKNOWN_CONTROL",
                    f'joints."{name}"',
                    f"no rig of the asset has this joint{known}",
                )


def _names_of_joints(joints: tuple[Joint, ...]) -> list[str]:
    """What the configuration may call them: by their last names as well as by their paths."""
    return [*joint_names(joints), *(joint.path for joint in joints)]


def _joints_clause(reading: _Reading) -> str:
    """A clause with the names of the first joints of a rig, empty if it has none."""
    names = joint_names(reading.rig.body.joints)
    more = f" and {len(names) - _JOINTS_TOLD} more" if len(names) > _JOINTS_TOLD else ""
    return (
        f"; {reading.rig.skel_root.path} has the joints {', '.join(names[:_JOINTS_TOLD])}{more}"
        if names
        else ""
    )


def _lost_clause(lost: list[LeftOff]) -> str:
    """A clause with the reasons for which everything was left off, and how many controls share
    each; empty if none."""
    if not lost:
        return ""
    names: dict[str, list[str]] = {}
    for each in lost:
        names.setdefault(each.reason, []).append(each.control)
    reasons = [
        f"{same[0]}{f' and {len(same) - 1} more' if len(same) > 1 else ''} ({reason})"
        for reason, same in list(names.items())[:_REASONS_TOLD]
    ]
    more = len(names) - len(reasons)
    return f"; left off: {', '.join(reasons)}{f' and {more} more reasons' if more else ''}"


def _inactive_clause(stage: Usd.Stage, root: str) -> str:
    """A clause with the prims below a SkelRoot that are not active; empty if none."""
    walk = Usd.PrimRange(stage.GetPrimAtPath(root), Usd.PrimAllPrimsPredicate)
    off = [str(prim.GetPath()) for prim in walk if not prim.IsActive() and prim.GetName() != SCOPE]
    return f"; not active: {listed(off)}" if off else ""


def _vain_clause(vain: list[Issue]) -> str:
    """A clause with the first mesh that is bound in vain, and how many are; empty if none."""
    if not vain:
        return ""
    more = f" (and {len(vain) - 1} more meshes)" if len(vain) > 1 else ""
    return f"; {vain[0].path}{more} {vain[0].message}"


def _with_issues(rig: Rig, more: tuple[Issue, ...]) -> Rig:
    found = rig.findings
    return replace(rig, findings=replace(found, issues=(*more, *found.issues)))
