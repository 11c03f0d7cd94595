"""From a stage to `layout.Layout`, by the contract of the layer and nothing else.

Uses the USD that Blender brings along; the schema plug-in need not be registered.  What a layer
does not say takes the schema's fallback.
"""

from __future__ import annotations

import re

import numpy as np
from pxr import Gf, Usd, UsdGeom, UsdSkel

from .joints import beside_parents
from .layout import (
    Control,
    Element,
    JointDrive,
    JointRest,
    Layout,
    LayoutError,
    Member,
    MeshRest,
    ShapeDrive,
    SkeletonRest,
    frozen,
)
from .properties import (
    agree,
    applied,
    carriers,
    get,
    inherited,
    instances,
    named,
    points_of,
    targets,
)

_LATER = re.compile(r"(RigUI\w+API)_")
"""The schemas that are understood are those whose names end without a number."""


def read_layouts(stage):
    """All layouts of a stage, one per character.  Raises LayoutError for what cannot be
    understood."""
    return tuple(_layout(scope) for scope in _scopes(stage))


def _scopes(stage):
    walk = iter(Usd.PrimRange(stage.GetPseudoRoot(), Usd.PrimAllPrimsPredicate))
    for prim in walk:
        if any(name.startswith("RigUILayoutAPI") for name in applied(prim)):
            walk.PruneChildren()
            if prim.IsActive() and prim.GetParent().IsDefined():
                yield prim


def _layout(scope):
    for prim in Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate):
        for name in applied(prim):
            later = _LATER.match(name)
            if later:
                raise LayoutError(f"{prim.GetPath()} keeps {name}, a later version than {later[1]}")
    names = get(scope, "rigUI:layout:baseControls", ())
    values = get(scope, "rigUI:layout:baseValues", ())
    agree(scope, len(values) in (0, len(names)), "values of the base pose")
    base, root = dict(zip(names, values or [0.0] * len(names), strict=True)), scope.GetParent()
    width = get(scope, "rigUI:layout:handleWidth", 0.0)
    widths = {
        named(scope, "part", each): get(scope, f"rigUI:part:{each}:handleWidth", 0.0)
        for each in instances(scope, "RigUIPartAPI")
    }
    controls, elements = {}, []
    for prim in _elements(scope):
        mine = {each: _control(prim, each, base) for each in _controls_of(prim)}
        for control in mine.values():
            controls.setdefault(control.name, control)
        part = get(prim.GetParent(), "rigUI:drawing:part", "")
        elements.append(_element(prim, mine, widths.get(part) or width))
    return Layout(
        root=str(root.GetPath()),
        normal=get(scope, "rigUI:layout:planeNormal", (0.0, 0.0, 0.0)),
        controls=tuple(controls.values()),
        elements=tuple(elements),
        meshes=_meshes(root, scope),
        skeletons=tuple(
            _skeleton(prim, root) for prim in Usd.PrimRange(root) if prim.IsA(UsdSkel.Skeleton)
        ),
    )


def _elements(scope):
    """The elements that the layout lists, in that order, and then the others below it."""
    listed = map(scope.GetStage().GetPrimAtPath, targets(scope, "rigUI:layout:elements"))
    walk = Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate)
    found = dict.fromkeys([*filter(None, listed), *walk])
    return [prim for prim in found if "RigUIElementAPI" in applied(prim) and prim.IsActive()]


def _controls_of(prim):
    known = instances(prim, "RigUIControlAPI")
    listed = [*get(prim, "rigUI:element:controls", ())] or known
    agree(prim, listed and {*listed} <= {*known}, "its controls")
    return listed


# --- controls -------------------------------------------------------------------------------------


def _reader(prim, instance):
    """``get`` of the properties of one control."""
    return lambda name, fallback: get(prim, f"rigUI:control:{instance}:{name}", fallback)


def _control(prim, instance, base):
    of = _reader(prim, instance)
    name, keys, default = named(prim, "control", instance), of("keys", ()), of("default", 0.0)
    tokens, weights = of("blendShapes", ()), of("blendShapeWeights", ())
    agree(prim, not keys or len(weights) == len(keys) * len(tokens), "weights of shapes")
    return Control(
        name=name,
        label=of("label", "") or name,
        minimum=of("minimum", 0.0),
        default=default,
        maximum=of("maximum", 1.0),
        base=base.get(name, default),
        keys=keys,
        shapes=tuple(
            ShapeDrive(token, weights[i :: len(tokens)] if keys else ())
            for i, token in enumerate(tokens)
        ),
        joints=_joints(prim, instance, of, len(keys)),
        attribute=f"{prim.GetPath()}.rigUI:control:{instance}:value",
    )


def _joints(prim, instance, of, count):
    joints = of("joints", ())
    skeletons = [str(path) for path in targets(prim, f"rigUI:control:{instance}:skeleton")]
    which = of("jointSkeletons", ()) or (0,) * len(joints)
    moves = np.zeros((3, count, len(joints), 3))
    for i, name in enumerate(("RotationVectors", "Translations", "ScaleFactors")):
        table = np.array(of(f"joint{name}", ()), dtype=np.float64)
        agree(prim, table.size in (0, moves[i].size), "vectors of joints")
        if table.size:
            moves[i] = (np.radians, np.asarray, np.log)[i](table).reshape(moves[i].shape)
    return tuple(
        JointDrive((skeletons[which[j]], joint), frozen(moves[:, :, j].swapaxes(0, 1).tolist()))
        for j, joint in enumerate(joints)
    )


# --- elements -------------------------------------------------------------------------------------


def _element(prim, mine, width):
    def others(name):
        paths = targets(prim, f"rigUI:element:{name}")
        return tuple(map(_name, map(prim.GetStage().GetPrimAtPath, paths)))

    mesh = "".join(map(str, targets(prim, "rigUI:anchor:prim")[:1]))
    held, skeleton = carriers(prim)
    return Element(
        name=_name(prim),
        label=prim.GetMetadata("displayName") or prim.GetName(),
        kind=get(prim, "rigUI:element:elementType", "slider"),
        members=tuple(_member(prim, *each) for each in mine.items()),
        mesh=mesh,
        point=get(prim, "rigUI:anchor:pointIndex", -1),
        position=get(prim, "rigUI:anchor:position", (0.0, 0.0, 0.0)),
        normal=get(prim, "rigUI:anchor:normal", (0.0, 0.0, 0.0)),
        follows=bool(mesh) and get(prim, "rigUI:handle:adapt", "deform") != "static",
        carriers=held,
        skeleton=skeleton,
        side=get(prim, "rigUI:element:side", "none"),
        mirror="".join(others("mirror")[:1]),
        inner=others("members"),
        reason=prim.GetDocumentation() if prim.HasAuthoredDocumentation() else "",
        axes=_axes(prim, [*mine]),
        width=width,
    )


def _axes(prim, mine):
    """Positions of each axis: opposed pairs, negative end first, and all others alone."""
    said = [get(prim, f"rigUI:control:{each}:opposes", "") for each in mine]
    agree(prim, {*said} <= {"", *mine}, "controls that it opposes")
    opposed = [(mine.index(each), i) for i, each in enumerate(said) if each]
    ends = {end: pair for pair in opposed for end in pair}
    agree(prim, len(ends) == 2 * len(opposed), "controls that it opposes")
    return tuple(sorted({ends.get(i, (i,)) for i in range(len(mine))}, key=min))


def _name(prim):
    return prim and (get(prim, "rigUI:element:name", "") or prim.GetName())


def _member(prim, instance, control):
    of = _reader(prim, instance)
    points = tuple(map(tuple, of("trackPoints", ())))
    steps = np.linspace(control.minimum, control.maximum, len(points)).tolist()
    values = of("trackValues", ()) or tuple(steps)
    agree(prim, len(values) == len(points) > 1, "points and values of a track")
    return Member(
        control.name, values, points, of("magnification", 1.0), of("mirrorReversed", False)
    )


# --- the character --------------------------------------------------------------------------------


def _meshes(root, scope):
    cache = UsdGeom.XformCache()
    walk = Usd.PrimRange(root, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate))
    return tuple(
        MeshRest(str(prim.GetPath()), len(points_of(prim)), _rows(_to_root(prim, root, cache)))
        for prim in walk
        if prim.IsA(UsdGeom.Mesh) and not prim.GetPath().HasPrefix(scope.GetPath())
    )


def _to_root(prim, root, cache):
    """Mesh space to root space: through the skeleton where the mesh is skinned, else as it
    stands."""
    skeleton = UsdSkel.BindingAPI(prim).GetInheritedSkeleton()
    if skeleton and inherited(prim, "skel:jointIndices") is not None:
        bind = inherited(prim, "skel:geomBindTransform") or Gf.Matrix4d(1.0)
        return bind * _relative(skeleton.GetPrim(), root, cache)
    return _relative(prim, root, cache)


def _relative(prim, root, cache):
    return cache.GetLocalToWorldTransform(prim) * cache.GetLocalToWorldTransform(root).GetInverse()


def _skeleton(prim, root):
    skeleton = UsdSkel.Skeleton(prim)
    order = skeleton.GetJointsAttr().Get() or ()
    bind = skeleton.GetBindTransformsAttr().Get() or ()
    agree(prim, len(bind) == len(order), "bind transforms of its joints")
    local = beside_parents(bind, UsdSkel.Topology(order).GetParentIndices())
    rest = skeleton.GetRestTransformsAttr().Get() or ()
    rest = rest if len(rest) == len(order) else local
    joints = [
        JointRest(path, *map(_rows, each)) for path, *each in zip(order, local, rest, strict=True)
    ]
    to_root = _rows(_relative(prim, root, UsdGeom.XformCache()))
    return SkeletonRest(str(prim.GetPath()), to_root, tuple(joints))


def _rows(matrix):
    return frozen(np.array(matrix).tolist())
