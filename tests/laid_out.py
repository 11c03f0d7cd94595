"""Layouts without an optimiser: elements at points picked at random, and what UsdSkel makes of them."""

import operator
from dataclasses import fields, replace

import makers
import numpy as np
import pytest
from pxr import Sdf, Usd, UsdGeom, UsdSkel, Vt

from usdrigui.character import LeftOff
from usdrigui.character.deform import channel_state, deform, knots, posed, sweep
from usdrigui.layer.properties import element_name
from usdrigui.layer.read_layout import element_prims, points_by_role
from usdrigui.layer.write_layout import layer_for, stage_metadata
from usdrigui.model import Element, LayoutPart, Proof


def layout_of(rig, seed=0, groups=None, base_values=None, beside=(), adapt="deform", only=None):
    """One element per control (or per tuple of names in `groups`), anchored at a random point that it moves."""
    rng = np.random.default_rng(seed)
    values = rig.defaults if base_values is None else np.asarray(base_values, dtype=np.float64)
    base = posed(rig, values)
    index = rig.control_indices
    groups = [(name,) for name in (only or index)] if groups is None else groups
    width = 0.02 * extent(base.points)
    elements = []
    for names in groups:
        swept = [sweep(rig, base, index[name], knots(rig, index[name])) for name in names]
        point = _moving(rng, *swept[0])
        if point < 0:
            continue
        members = tuple(
            makers.member(rig.controls[index[name]], knots(rig, index[name]), base.points[point], point, *each)
            for name, each in zip(names, swept, strict=True)
        )
        elements.append(_element(rig, names, members, base.points[point], point, names[0] in beside, adapt))
    return replace(
        makers.layout(rig, *elements, base_values=values, drawn=makers.frame(width, normal=(1.0, 0.0, 0.0))),
        left_off=(LeftOff("nothing", "trajectories", "moves no point"),),
        proof=Proof(
            method="random",
            status="stopped",
            cost=-1.25,
            bound=-np.inf,
            above_unary_bound=0.5,
            weights=(("displacement_weight", 0.85),),
        ),
    )


def extent(points):
    """Diagonal of the box around points."""
    return float(np.linalg.norm(np.ptp(points, axis=0)))


def diagonal(rig):
    """Of the character's box, in the base pose."""
    return extent(deform(rig))


def on_face(layout):
    """Elements that are not on the board."""
    return [element for element in layout.elements if not element.anchor.on_board]


def random_values(rig, rng):
    low = np.array([control.minimum for control in rig.controls])
    high = np.array([control.maximum for control in rig.controls])
    return low + (high - low) * rng.random(len(low))


def _moving(rng, points, offsets):
    length = np.linalg.norm(offsets[-1] - offsets[0], axis=1) if len(points) else np.zeros(0)
    moving = points[length > 0.3 * length.max(initial=0.0)]
    return int(rng.choice(moving)) if len(moving) else -1


def _element(rig, names, members, position, point, beside, adapt):
    kind = "slider" if len(names) == 1 else "patch" if len(names) == 2 else "fan"
    category, reason = ("hidden", "inside the mouth") if beside else ("", "")
    return Element(
        name="_".join(names),
        kind=kind,
        members=members,
        anchor=makers.anchor(rig, point, position, on_board=beside),
        label=names[0].title(),
        side="left",
        adapt=adapt,
        category=category,
        reason=reason,
    )


def validation_errors(stage):
    """What USD's own validators find on a stage; skips the test where USD is too old to have them.

    Ours, which a test before may have registered for the whole process, find that layouts at random are no good ones.
    """
    validation = pytest.importorskip("pxr.UsdValidation", exc_type=ImportError)
    known = validation.ValidationRegistry().GetOrLoadAllValidators()
    validators = [each for each in known if not each.GetMetadata().name.startswith("usdrigui")]
    return [error.GetMessage() for error in validation.ValidationContext(validators).Validate(stage)]


# --- posing ------------------------------------------------------------------------------------------


def keyed(path, rig, poses):
    """Stage over the layer at `path` with pose k (controls,) keyed at time k."""
    top = Sdf.Layer.CreateAnonymous(".usda")
    top.subLayerPaths.append(path)
    stage = Usd.Stage.Open(top)
    for skeleton in rig.body.skeletons:
        if skeleton.animation:
            _key(stage, rig, skeleton, poses)
    stage.SetStartTimeCode(0)
    stage.SetEndTimeCode(len(poses) - 1)
    return stage


def parted(layout, widths, names):
    """The layout with parts whose handles have these widths, by name; `names` are those of its elements' parts."""
    parts = tuple(LayoutPart(name, width, layout.frame.view, "optimal", 0.0, 0.0) for name, width in widths.items())
    elements = tuple(replace(each, part=name) for each, name in zip(layout.elements, names, strict=False))
    return replace(layout, elements=elements, frame=replace(layout.frame, parts=parts))


def written(source, rig, layout, name="char.rigui.usda"):
    """The layer of one layout, saved over its source."""
    path = source.with_name(name)
    metadata = stage_metadata(Sdf.Layer.FindOrOpen(str(source)))
    layer_for([(rig, layout)], f"./{source.name}", metadata).Export(str(path))
    return Sdf.Layer.FindOrOpen(str(path))


def baked(layer, rig, poses):
    """`keyed`, and UsdSkel's deformation baked into points."""
    stage = keyed(layer.identifier, rig, poses)
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetPrimAtPath(rig.path)))
    return stage


def _key(stage, rig, skeleton, poses):
    index = rig.body.skeletons.index(skeleton)
    animation = UsdSkel.Animation.Define(stage, skeleton.animation)
    joints = [i for i, joint in enumerate(rig.body.joints) if joint.skeleton == index]
    channels = [i for i, channel in enumerate(rig.body.channels) if channel.animation == skeleton.animation]
    for attribute in animation.GetPrim().GetAttributes():
        attribute.Clear()
        attribute.Block()
    animation.CreateBlendShapesAttr([rig.body.channels[i].token for i in channels])
    animation.CreateJointsAttr([rig.body.joints[i].path for i in joints])
    for time, values in enumerate(poses):
        weights, local = channel_state(rig, values)
        animation.CreateBlendShapeWeightsAttr().Set(Vt.FloatArray.FromNumpy(weights[channels].astype(np.float32)), time)
        if joints:
            parts = UsdSkel.DecomposeTransforms(Vt.Matrix4dArray.FromNumpy(np.ascontiguousarray(local[joints])))
            for attribute, part in zip(
                (animation.CreateTranslationsAttr(), animation.CreateRotationsAttr(), animation.CreateScalesAttr()),
                parts,
                strict=True,
            ):
                attribute.Set(part, time)


def handle(stage, root, element, time):
    """(n, 3) the drawn handle of an element, in the space of the SkelRoot."""
    prim = element_prim(stage, root, element)
    return root_points(stage, str(prim.GetParent().GetPath()), root, time)[points_by_role(prim, "handle")]


def tracks(stage, root, element, time):
    """Per member (k, 3) the middle of its drawn track, in the space of the SkelRoot."""
    prim = element_prim(stage, root, element)
    subsets = [each.GetChild(prim.GetName()) for each in scope_of(stage, root).GetChildren()]
    subset = max((each for each in subsets if each), key=lambda each: len(points_by_role(each, "track", "area")))
    drawn = root_points(stage, str(subset.GetParent().GetPath()), root, time)[points_by_role(subset, "track", "area")]
    ends = np.cumsum([2 * len(member.values) - 1 for member in element.members])
    tracks = np.split(drawn[: ends[-1]], ends[:-1])
    return [0.5 * (each[::2] + np.concatenate([each[1::2], each[-1:]])) for each in tracks]


def element_prim(stage, root, element):
    return next(prim for prim in element_prims(scope_of(stage, root)) if element_name(prim) == element.name)


def scope_of(stage, root):
    return stage.GetPrimAtPath(root).GetChild("RigUI")


def root_points(stage, path, root, time):
    """(n, 3) points of a baked gprim in the space of the SkelRoot."""
    prim = stage.GetPrimAtPath(path)
    points = np.array(UsdGeom.PointBased(prim).GetPointsAttr().Get(time), dtype=np.float64)
    cache = UsdGeom.XformCache(time)
    matrix = (
        cache.GetLocalToWorldTransform(prim) * cache.GetLocalToWorldTransform(stage.GetPrimAtPath(root)).GetInverse()
    )
    full = np.array(matrix)
    return points @ full[:3, :3] + full[3, :3]


def close(first, second, where=""):
    """Records equal to the digits that a layer keeps; arrays, floats and tuples compared all the way down."""
    if isinstance(first, np.ndarray):
        assert first.shape == second.shape, where
        # Track points are stored together with offsets of their size, so compare against the largest.
        assert np.abs(first - second).max(initial=0.0) <= 1.5e-6 * max(1.0, np.abs(first).max(initial=0.0)), where
    elif isinstance(first, tuple):
        assert len(first) == len(second), where
        for i, pair in enumerate(zip(first, second, strict=True)):
            close(*pair, f"{where}[{i}]")
    elif hasattr(first, "__dataclass_fields__"):
        for each in filter(operator.attrgetter("compare"), fields(first)):
            close(getattr(first, each.name), getattr(second, each.name), f"{where}.{each.name}")
    elif isinstance(first, float):
        # 7 digits of the power of two above are kept (`author.settled`): half of the last one may be lost.
        assert first == pytest.approx(second, rel=1.5e-6, abs=1e-9), where
    else:
        assert first == second, where
