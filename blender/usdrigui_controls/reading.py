"""From a stage to `layout.Layout`, by the contract of the layer and nothing else.

Uses the USD that Blender brings along; the schema plug-in need not be registered.  What a layer
does not say takes the schema's fallback.
"""

from __future__ import annotations

from pxr import Usd, UsdGeom, UsdSkel

from . import drawn
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
)
from .properties import agree, applied, floats, get, points_of, targets

FAMILIES = {
    f"RigUI{each}API"
    for each in ("Layout", "Part", "Drawing", "Element", "Anchor", "Handle", "Control")
}
"""The schemas of a layout, in the versions that are understood: those without a number."""


def read_layouts(stage):
    """All layouts of a stage, one per character.  Raises LayoutError for what cannot be
    understood."""
    return tuple(_layout(scope) for scope in _scopes(stage))


def _scopes(stage):
    walk = iter(Usd.PrimRange(stage.GetPseudoRoot(), Usd.PrimAllPrimsPredicate))
    for prim in walk:
        if any(name.partition("_")[0] == "RigUILayoutAPI" for name in applied(prim)):
            walk.PruneChildren()
            if prim.IsActive() and prim.GetParent().IsDefined():
                yield prim


def _layout(scope):
    for prim in Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate):
        for name in applied(prim):
            family, _, version = name.partition(":")[0].partition("_")
            if family in FAMILIES and version:
                raise LayoutError(f"{prim.GetPath()} keeps {name}, a later version than {family}")
    names, values = (
        get(scope, f"rigUI:layout:{name}", ()) for name in ("baseControls", "baseValues")
    )
    agree(scope, len(values) in (0, len(names)), "values of the base pose")
    base = dict(zip((str(name) for name in names), values or [0.0] * len(names), strict=True))
    root = scope.GetParent()
    widths = _part_widths(scope)
    controls, elements = {}, []
    for prim in _elements(scope):
        instances = _instances(prim)
        for instance in instances:
            control = _control(prim, instance, base)
            controls[control.name] = control
        elements.append(_element(prim, instances, widths.get(drawn.part_of(prim), 0.0)))
    skeletons = [
        _skeleton(prim, root) for prim in Usd.PrimRange(root) if prim.IsA(UsdSkel.Skeleton)
    ]
    return Layout(
        root=str(root.GetPath()),
        handle_width=get(scope, "rigUI:layout:handleWidth", 0.0),
        controls=tuple(controls.values()),
        elements=tuple(elements),
        meshes=_meshes(root, scope),
        skeletons=tuple(skeletons),
    )


def _part_widths(scope):
    """Handle width of each part of a character that is laid out in several."""
    return {
        _named(scope, "part", each): get(scope, f"rigUI:part:{each}:handleWidth", 0.0)
        for each in _applied_instances(scope, "RigUIPartAPI")
    }


def _elements(scope):
    """The elements that the layout lists, in that order, and then the others below it."""
    listed = [
        scope.GetStage().GetPrimAtPath(path) for path in targets(scope, "rigUI:layout:elements")
    ]
    walk = Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate)
    found = dict.fromkeys([*(prim for prim in listed if prim), *walk])
    return [prim for prim in found if "RigUIElementAPI" in applied(prim) and prim.IsActive()]


def attributes_of(stage, root):
    """By the name of each control of a character, the prim and the name of the attribute that holds
    its value."""
    scopes = [each for each in _scopes(stage) if str(each.GetParent().GetPath()) == root]
    return {
        _named(prim, "control", instance): (prim, f"rigUI:control:{instance}:value")
        for scope in scopes
        for prim in reversed(_elements(scope))
        for instance in _instances(prim)
    }


# --- controls -------------------------------------------------------------------------------------


def _control(prim, instance, base):
    def of(name, fallback):
        return get(prim, f"rigUI:control:{instance}:{name}", fallback)

    name = str(of("name", "")) or instance
    keys = floats(of("keys", ()))
    default = of("default", 0.0)
    return Control(
        name=name,
        label=str(of("label", "")) or name,
        minimum=of("minimum", 0.0),
        default=default,
        maximum=of("maximum", 1.0),
        base=float(base.get(name, default)),
        keys=keys,
        shapes=_shapes(prim, of, keys),
        joints=_joints(prim, instance, of, keys),
    )


def _shapes(prim, of, keys):
    tokens = [str(token) for token in of("blendShapes", ())]
    weights = floats(of("blendShapeWeights", ()))
    agree(prim, not keys or len(weights) == len(keys) * len(tokens), "weights of shapes")
    columns = [weights[i :: len(tokens)] if keys else () for i in range(len(tokens))]
    return tuple(ShapeDrive(token, column) for token, column in zip(tokens, columns, strict=True))


def _joints(prim, instance, of, keys):
    joints = [str(joint) for joint in of("joints", ())]
    skeletons = [str(path) for path in targets(prim, f"rigUI:control:{instance}:skeleton")]
    which = list(of("jointSkeletons", ())) or [0] * len(joints)
    tables = [
        _table(prim, drawn.joint_table(of, name), (len(keys), len(joints)))
        for name in ("Rotation", "Translation", "Scale")
    ]
    return tuple(
        JointDrive(skeletons[which[j]], joint, *(table[j] for table in tables))
        for j, joint in enumerate(joints)
    )


def _table(prim, rows, shape):
    """Per joint, one vector per key; zeros where the layer has none."""
    keys, joints = shape
    rows = rows or [(0.0, 0.0, 0.0)] * (keys * joints)
    agree(prim, len(rows) == keys * joints, "vectors of joints")
    return [tuple(rows[j::joints]) for j in range(joints)]


# --- elements -------------------------------------------------------------------------------------


def _element(prim, instances, width):
    on_face = targets(prim, "rigUI:anchor:prim")
    mirror = targets(prim, "rigUI:element:mirror")
    tracks = [drawn.track(prim, instance) for instance in instances]
    carriers, skeleton = drawn.carriers(prim)
    members = [
        _member(prim, instance, *track) for instance, track in zip(instances, tracks, strict=True)
    ]
    name = _name(prim)
    return Element(
        name=name,
        label=prim.GetMetadata("displayName") or prim.GetName(),
        kind=str(get(prim, "rigUI:element:elementType", "slider")),
        members=tuple(members),
        mesh=str(on_face[0]) if on_face else "",
        point=get(prim, "rigUI:anchor:pointIndex", -1),
        position=floats(get(prim, "rigUI:anchor:position", (0.0, 0.0, 0.0))),
        normal=floats(get(prim, "rigUI:anchor:normal", (0.0, 0.0, 0.0))),
        follows=bool(on_face) and get(prim, "rigUI:handle:adapt", "deform") != "static",
        carriers=carriers,
        skeleton=skeleton,
        side=str(get(prim, "rigUI:element:side", "none")),
        mirror=_name(prim.GetStage().GetPrimAtPath(mirror[0])) if mirror else "",
        reversed=drawn.reversed_members(prim, instances),
        inner=tuple(
            _name(prim.GetStage().GetPrimAtPath(path))
            for path in targets(prim, "rigUI:element:members")
        ),
        reason=prim.GetDocumentation() if prim.HasAuthoredDocumentation() else "",
        axes=_axes(prim, drawn.opposed(prim, instances), len(instances)),
        width=width,
    )


def _axes(prim, opposed, count):
    """Positions of each axis: opposed pairs, negative end first, and all others alone."""
    ends = [end for pair in opposed for end in pair]
    agree(prim, len(set(ends)) == len(ends), "controls that it opposes")
    return tuple(sorted([*opposed, *((i,) for i in range(count) if i not in ends)], key=min))


def _name(prim):
    return (str(get(prim, "rigUI:element:name", "")) or prim.GetName()) if prim else ""


def _applied_instances(prim, api):
    return [name.split(":", 1)[1] for name in applied(prim) if name.startswith(f"{api}:")]


def _named(prim, kind, instance):
    """The true name of a control or a part, where it is no identifier."""
    return str(get(prim, f"rigUI:{kind}:{instance}:name", "")) or instance


def _instances(prim):
    known = _applied_instances(prim, "RigUIControlAPI")
    listed = [str(name) for name in get(prim, "rigUI:element:controls", ())] or known
    agree(prim, listed and set(listed) <= set(known), "its controls")
    return listed


def _member(prim, instance, points, values):
    control = f"rigUI:control:{instance}"
    if not values:
        low, high = get(prim, f"{control}:minimum", 0.0), get(prim, f"{control}:maximum", 1.0)
        values = tuple(low + (high - low) * i / max(len(points) - 1, 1) for i in range(len(points)))
    agree(prim, len(values) == len(points) > 1, "points and values of a track")
    name = _named(prim, "control", instance)
    return Member(name, values, points, get(prim, f"{control}:magnification", 1.0))


# --- the character --------------------------------------------------------------------------------


def _meshes(root, scope):
    cache = UsdGeom.XformCache()
    found = []
    for prim in Usd.PrimRange(root, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)):
        if prim.IsA(UsdGeom.Mesh) and not prim.GetPath().HasPrefix(scope.GetPath()):
            to_root = _rows(_to_root(prim, root, cache))
            found.append(MeshRest(str(prim.GetPath()), len(points_of(prim)), to_root))
    return tuple(found)


def _to_root(prim, root, cache):
    """Mesh space to root space: through the skeleton where the mesh is skinned, else as it
    stands."""
    binding = UsdSkel.BindingAPI(prim)
    skeleton = binding.GetInheritedSkeleton()
    inherited = UsdGeom.PrimvarsAPI(prim).FindPrimvarWithInheritance("skel:jointIndices")
    if skeleton and inherited and inherited.HasAuthoredValue():
        bind = UsdGeom.PrimvarsAPI(prim).FindPrimvarWithInheritance("skel:geomBindTransform").Get()
        placed = _relative(skeleton.GetPrim(), root, cache)
        return bind * placed if bind is not None else placed
    return _relative(prim, root, cache)


def _relative(prim, root, cache):
    return cache.GetLocalToWorldTransform(prim) * cache.GetLocalToWorldTransform(root).GetInverse()


def _skeleton(prim, root):
    skeleton = UsdSkel.Skeleton(prim)
    order = [str(joint) for joint in skeleton.GetJointsAttr().Get() or ()]
    bind = list(skeleton.GetBindTransformsAttr().Get() or ())
    rest = list(skeleton.GetRestTransformsAttr().Get() or ())
    if len(bind) != len(order):
        raise LayoutError(
            f"{prim.GetPath()} has {len(bind)} bind transforms for {len(order)} joints"
        )
    joints = []
    for i, path in enumerate(order):
        parent = path.rpartition("/")[0]
        local = bind[i] * bind[order.index(parent)].GetInverse() if parent in order else bind[i]
        joints.append(
            JointRest(path, _rows(local), _rows(rest[i] if len(rest) == len(order) else local))
        )
    return SkeletonRest(
        str(prim.GetPath()), _rows(_relative(prim, root, UsdGeom.XformCache())), tuple(joints)
    )


def _rows(matrix):
    return tuple(tuple(float(matrix[i][j]) for j in range(4)) for i in range(4))
