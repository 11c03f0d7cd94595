"""The animation home: what the scene does to a character, as a layer over the paths of its source.

Weights and joints are sampled from the scene as Blender evaluates it, drivers, constraints and the
animation of other tools included, and hold only what differs from the source at rest.
"""

from __future__ import annotations

import os
from pathlib import Path

import bpy
import numpy as np
from bpy_extras.io_utils import ExportHelper

from .character import SOURCE, Character, at_frames, check_meshes, holders, is_single_joint
from .environment import in_one_line
from .importing import need_usd
from .inbetweens import tokens_of
from .joints import beside_parents
from .layout import LayoutError
from .matching import blender_name, scene_of

_SAME = 1e-7
"""Weights, and parts of transforms in proportion to their size, that are no further apart are the
same."""
_NOISE = 4e-6
"""A joint is so near to its rest by the single precision of Blender's chains alone."""


class SaveAnimation(bpy.types.Operator, ExportHelper):
    """Write the animation of the characters with controls as a USD layer over their own files."""

    bl_idname = "usdrigui.save_animation"
    bl_label = "Save USD Animation"
    bl_options = {"REGISTER"}

    filename_ext = ".usda"
    filter_glob: bpy.props.StringProperty(default="*.usda;*.usdc;*.usd", options={"HIDDEN"})
    steps: bpy.props.IntProperty(
        name="Samples per Frame",
        default=1,
        min=1,
        max=16,
        description="Samples between frames, for motion blur; USD is linear between samples",
    )
    with_values: bpy.props.BoolProperty(
        name="Values of Controls",
        description="Key rigUI:control:NAME:value too, for applications that key attributes",
    )

    def invoke(self, context, event):
        """Offer a name beside the character's layer."""
        held = holders()
        if held and not self.filepath:
            stem = Path(bpy.data.filepath).stem or "shot"
            self.filepath = str(Path(held[0][SOURCE]).parent / f"{stem}.anim.usda")
        return ExportHelper.invoke(self, context, event)

    @in_one_line
    def execute(self, context):
        """Play the scene once and write the layer."""
        target = Path(bpy.path.abspath(self.filepath))
        scene = context.scene
        save_animation(scene, target, self.steps, self.with_values)
        self.report({"INFO"}, f"{self.filepath}: frames {scene.frame_start} to {scene.frame_end}")
        return {"FINISHED"}


def save_animation(scene, target, steps, with_values):
    """Write the layer, with the values of the controls if these are asked for.

    It sublayers the layer of each character's layout, which sublayers the character.  Raises
    LayoutError without characters, where two are one in their source, a source is gone, or the file
    cannot be written.
    """
    need_usd()
    from pxr import Sdf, Tf, Usd

    characters = {
        (each.holder[SOURCE], each.layout.root): each for each in map(Character, holders())
    }
    if not characters:
        raise LayoutError("no character of this scene has controls: lay one out, or load a layout")
    if len(characters) < len(holders()):
        raise LayoutError(
            "a character and its copy have one layout: lay the copy out by itself first"
        )
    sources = list(dict.fromkeys(source for source, _ in characters))
    for source in sources:
        if not Path(source).is_file():
            raise LayoutError(f"the layout {source} is gone: load or lay it out again")
        if Path(source).resolve() == target.resolve():
            raise LayoutError(f"{target.name} is the layout itself: choose another name")
    layer = Sdf.Layer.CreateAnonymous(target.suffix)
    layer.subLayerPaths[:] = sources
    source = Sdf.Layer.FindOrOpen(sources[0])
    for name in ("metersPerUnit", "upAxis", "defaultPrim"):
        if source.pseudoRoot.HasInfo(name):
            layer.pseudoRoot.SetInfo(name, source.pseudoRoot.GetInfo(name))
    layer.framesPerSecond = layer.timeCodesPerSecond = scene.render.fps / scene.render.fps_base
    stage, parts = Usd.Stage.Open(layer), []
    for character in characters.values():
        check_meshes(character.layout, character.meshes)
        parts += _parts_of(character, stage)
        if with_values:
            parts.append(_Values(character, stage))
    first, last = scene.frame_start, scene.frame_end
    frames = [first + i / steps for i in range((last - first) * steps + 1)]
    seen = at_frames(frames, lambda: [part.look() for part in parts])
    for part, looks in zip(parts, zip(*seen.values(), strict=True), strict=True):
        part.write(frames, looks)
    stage.SetStartTimeCode(first)
    stage.SetEndTimeCode(last)
    written = Sdf.Layer.CreateAnonymous(target.suffix)
    written.TransferContent(layer)
    written.subLayerPaths[:] = [_relative(source, target) for source in sources]
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        written.Export(str(target))
    except (OSError, Tf.ErrorException) as error:
        raise LayoutError(f"{target} cannot be written: choose another place") from error


def _relative(source, target):
    try:
        return f"./{Path(os.path.relpath(source, target.parent)).as_posix()}"
    except ValueError:  # on another drive
        return Path(source).as_posix()


def _parts_of(character, stage):
    """What looks at one character at every frame and writes what it saw, parents before
    children."""
    return [
        *(_Skeleton(character, stage, *each) for each in _skinned(character, stage).items()),
        *(_Place(stage, *each) for each in sorted(_places(character, stage).items())),
    ]


def _skinned(character, stage):
    """The meshes that each skeleton deforms, if any: prim paths by prim path."""
    from pxr import UsdSkel

    found = {path: [] for path in character.armatures}
    for path in character.meshes:
        skeleton = UsdSkel.BindingAPI(stage.GetPrimAtPath(path)).GetInheritedSkeleton()
        if skeleton:
            found.setdefault(str(skeleton.GetPath()), []).append(path)
    return found


def _places(character, stage):
    """The object of each prim that has its transform: as Blender exports it the one above a mesh or
    a skeleton, and those above that; else the prim itself, unless it is skinned."""
    from .properties import inherited

    found = {}
    for path, thing in character.objects.items():
        prim = stage.GetPrimAtPath(path)
        above = prim.GetParent()
        if not blender_name(above) and inherited(prim, "skel:jointIndices") is None:
            found[path] = thing
        while thing is not None and blender_name(above):
            found[str(above.GetPath())] = thing
            above, thing = above.GetParent(), thing.parent
    return found


class _Skeleton:
    """The weights and the joints that one SkelAnimation holds."""

    def __init__(self, character, stage, path, meshes):
        from pxr import UsdSkel

        self.stage, self.armature = stage, character.armatures.get(path)
        self.prim = stage.GetPrimAtPath(path)
        self.keys = {
            token: key
            for mesh in meshes
            for token in tokens_of(stage.GetPrimAtPath(mesh))
            if (key := character.shape_key(mesh, token))
        }
        joints = [
            each
            for skeleton in character.layout.skeletons
            if self.armature and skeleton.path == path
            for each in skeleton.joints
        ]
        self.joints = [joint.path for joint in joints]
        self.parents = list(UsdSkel.Topology(self.joints).GetParentIndices())
        self.rest = np.reshape([joint.rest for joint in joints], (-1, 4, 4))
        names = [character.bone_name(path, joint) for joint in self.joints]
        binds = UsdSkel.Skeleton(self.prim).GetBindTransformsAttr().Get() or ()
        self.bones = [self._bone(*each) for each in zip(names, binds, strict=False)]

    def _bone(self, name, bind):
        """The bone, and the bind transform seen from where it rests; None without a bone."""
        bone = self.armature.pose.bones.get(name)
        return bone and (bone, np.array(bind) @ np.linalg.inv(np.array(bone.bone.matrix_local)).T)

    def look(self):
        """Weights and local transforms, as Blender has evaluated them."""
        weights = [0.0 if key.mute else key.value for key in self.keys.values()]
        placed = [np.eye(4)]  # where joints without a parent, -1, find it at the end
        for rest, above, bone in zip(self.rest, self.parents, self.bones, strict=True):
            placed.insert(
                -1, bone[1] @ np.array(bone[0].matrix).T if bone else rest @ placed[above]
            )
        return weights, beside_parents(placed[:-1], self.parents)

    def write(self, frames, seen):
        """Write the weights that are ever away from 0 and the joints that ever leave their rest."""
        from pxr import UsdSkel, Vt

        weights, locals_ = map(np.array, zip(*seen, strict=True))
        moving = np.flatnonzero(np.abs(weights).max(axis=0, initial=0.0) > _SAME)
        away = np.abs(locals_ - self.rest).max(axis=(0, 2, 3))
        size = np.maximum(np.abs(self.rest).max(axis=(1, 2)), 1.0)
        joints = np.flatnonzero(away > _NOISE * size)
        own = UsdSkel.BindingAPI(self.prim).GetInheritedAnimationSource()
        if not (len(moving) or len(joints) or own):
            return
        animation = self._animation(own)
        animation.CreateBlendShapesAttr([list(self.keys)[i] for i in moving])
        _sample(animation.CreateBlendShapeWeightsAttr(), frames, weights[:, moving].tolist())
        if len(joints) or own:
            animation.CreateJointsAttr([self.joints[i] for i in joints])
            rows = (np.ascontiguousarray(each[joints]).reshape(-1, 16) for each in locals_)
            parts = [UsdSkel.DecomposeTransforms(Vt.Matrix4dArray.FromNumpy(row)) for row in rows]
            attributes = (
                animation.CreateTranslationsAttr(),
                animation.CreateRotationsAttr(),
                animation.CreateScalesAttr(),
            )
            for attribute, values in zip(attributes, zip(*parts, strict=True), strict=True):
                _sample(attribute, frames, values)

    def _animation(self, own):
        """The SkelAnimation to write: the source's own, or a new one below the skeleton."""
        from pxr import UsdSkel

        if own:
            return UsdSkel.Animation(self.stage.OverridePrim(own.GetPath()))
        path = self.prim.GetPath().AppendChild("usdrigui_animation")
        binding = UsdSkel.BindingAPI.Apply(self.prim)
        binding.CreateAnimationSourceRel().SetTargets([path])
        return UsdSkel.Animation.Define(self.stage, path)


class _Place:
    """Where an object stands."""

    def __init__(self, stage, path, thing):
        self.prim, self.thing = stage.GetPrimAtPath(path), thing
        self.to_stage = np.linalg.inv(scene_of(stage))

    def look(self):
        """Its transform in the stage's world, for row vectors."""
        return np.array(self.thing.matrix_world).T @ self.to_stage

    def write(self, frames, seen):
        """A transform for the prim, where the object stands elsewhere than the prim does."""
        from pxr import Gf, UsdGeom

        cache, wanted, away = UsdGeom.XformCache(), [], 0.0
        for frame, world in zip(frames, seen, strict=True):
            cache.SetTime(frame)
            above = np.array(cache.GetParentToWorldTransform(self.prim))
            here = np.array(cache.GetLocalToWorldTransform(self.prim))
            wanted.append(Gf.Matrix4d((world @ np.linalg.inv(above)).tolist()))
            away = max(away, np.abs(world - here).max() / np.abs(here).max())
        if away > 1e-5:
            _sample(UsdGeom.Xformable(self.prim).MakeMatrixXform().GetAttr(), frames, wanted)


class _Values:
    """The controls of a character as attributes: those whose value the shape keys and bones tell.
    Of a pose they do not."""

    def __init__(self, character, stage):
        self.character = character
        self.told = [
            (control, prim)
            for control in character.layout.controls
            if (control.plain or is_single_joint(control))
            and (prim := stage.GetPrimAtPath(control.attribute.partition(".")[0]))
        ]

    def look(self):
        """The value of every control."""
        values = self.character.values()
        return [values[control.name] for control, _ in self.told]

    def write(self, frames, seen):
        """Write those that are ever away from their default."""
        from pxr import Sdf

        for (control, prim), values in zip(self.told, zip(*seen, strict=True), strict=True):
            if np.abs(np.array(values) - control.default).max() > _SAME:
                name = control.attribute.partition(".")[2]
                made = prim.CreateAttribute(name, Sdf.ValueTypeNames.Double, custom=False)
                _sample(made, frames, values)


def _sample(attribute, frames, values):
    """Samples of an attribute where it changes; one default where nothing does."""
    from pxr import UsdUtils

    writer = UsdUtils.SparseAttrValueWriter(attribute, values[0])
    for frame, value in zip(frames, values, strict=True):
        writer.SetTimeSample(value, frame)
