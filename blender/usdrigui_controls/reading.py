"""From a stage to `layout.Layout`, by the contract of the layer and nothing else.

Uses the USD that Blender brings along; the schema plug-in need not be registered.  What a layer does not
say takes the schema's fallback.
"""

from __future__ import annotations

from pxr import Usd, UsdGeom, UsdSkel

from .layout import (
    Area,
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

VERSION = 1
"""The latest version of the contract that is understood."""


def read_layouts(stage):
    """All layouts of a stage, one per character.  Raises LayoutError for what cannot be understood."""
    return tuple(_layout(scope) for scope in _scopes(stage))


def _scopes(stage):
    walk = iter(Usd.PrimRange(stage.GetPseudoRoot(), Usd.PrimAllPrimsPredicate))
    for prim in walk:
        if "RigUILayoutAPI" in _applied(prim):
            walk.PruneChildren()
            if prim.IsActive() and prim.GetParent().IsDefined():
                yield prim


def _layout(scope):
    version = _get(scope, "rigUI:layout:version", VERSION)
    if version > VERSION:
        raise LayoutError(f"{scope.GetPath()} keeps version {version} of the contract; this add-on knows {VERSION}")
    names, values = (_get(scope, f"rigUI:layout:{name}", ()) for name in ("baseControls", "baseValues"))
    if len(names) != len(values):
        raise LayoutError(f"{scope.GetPath()} names {len(names)} controls and {len(values)} values of the base pose")
    base = dict(zip((str(name) for name in names), values, strict=True))
    root = scope.GetParent()
    controls, elements = {}, []
    for prim in scope.GetAllChildren():
        if "RigUIElementAPI" in _applied(prim) and prim.IsActive():
            instances = _instances(prim)
            for instance in instances:
                control = _control(prim, instance, base)
                controls[control.name] = control
            elements.append(_element(prim, instances))
    skeletons = [_skeleton(prim, root) for prim in Usd.PrimRange(root) if prim.IsA(UsdSkel.Skeleton)]
    return Layout(
        root=str(root.GetPath()),
        handle_width=_get(scope, "rigUI:layout:handleWidth", 0.0) or _drawn_width(scope),
        controls=tuple(controls.values()),
        elements=tuple(elements),
        meshes=_meshes(root, scope),
        skeletons=tuple(skeletons),
    )


# --- controls ----------------------------------------------------------------------------------------


def _control(prim, instance, base):
    def get(name, fallback):
        return _get(prim, f"rigUI:control:{instance}:{name}", fallback)

    name = str(get("name", "")) or instance
    keys = _floats(get("keys", ()))
    default = get("default", 0.0)
    return Control(
        name=name,
        label=str(get("label", "")) or name,
        kind=str(get("kind", "blendShape")),
        minimum=get("minimum", 0.0),
        default=default,
        maximum=get("maximum", 1.0),
        base=float(base.get(name, default)),
        keys=keys,
        shapes=_shapes(get, keys, name),
        joints=_joints(prim, instance, get, keys),
    )


def _shapes(get, keys, name):
    tokens = [str(token) for token in get("blendShapes", ())]
    weights = _floats(get("blendShapeWeights", ()))
    if len(weights) != len(keys) * len(tokens) and keys:
        raise LayoutError(f"the control {name} has {len(weights)} weights for {len(keys)} keys")
    columns = [weights[i :: len(tokens)] if keys else () for i in range(len(tokens))]
    return tuple(ShapeDrive(token, column) for token, column in zip(tokens, columns, strict=True))


def _joints(prim, instance, get, keys):
    joints = [str(joint) for joint in get("joints", ())]
    skeletons = [str(path) for path in _targets(prim, f"rigUI:control:{instance}:skeleton")]
    which = list(get("jointSkeletons", ())) or [0] * len(joints)
    tables = [_table(get(name, ()), len(keys), len(joints)) for name in _TABLES]
    return tuple(
        JointDrive(skeletons[which[j]], joint, *(table[j] for table in tables)) for j, joint in enumerate(joints)
    )


_TABLES = ("jointRotations", "jointTranslations", "jointScales")


def _table(flat, keys, joints):
    """Per joint, one vector per key; zeros where the layer says nothing."""
    rows = [_floats(vector) for vector in flat] or [(0.0, 0.0, 0.0)] * (keys * joints)
    if len(rows) != keys * joints:
        raise LayoutError(f"{len(rows)} joint vectors for {keys} keys of {joints} joints")
    return [tuple(rows[j::joints]) for j in range(joints)]


# --- elements ----------------------------------------------------------------------------------------


def _element(prim, instances):
    children = prim.GetAllChildren()
    drawn = [child for child in children if "RigUITrackAPI" in _applied(child)]
    tracks = [_track_of(prim, drawn, instance, len(instances)) for instance in instances]
    on_face = _targets(prim, "rigUI:anchor:prim")
    handles = [child for child in children if "RigUIHandleAPI" in _applied(child)]
    adapt = _get(handles[0], "rigUI:handle:adapt", "deform") if handles else "deform"
    mirror = _targets(prim, "rigUI:element:mirror")
    carriers, skeleton = _carriers(tracks[0])
    name = _name(prim)
    return Element(
        name=name,
        label=prim.GetMetadata("displayName") or name,
        kind=str(_get(prim, "rigUI:element:elementType", "slider")),
        members=tuple(_member(prim, track, each) for track, each in zip(tracks, instances, strict=True)),
        areas=tuple(_area(child) for child in drawn if child.IsA(UsdGeom.Mesh)),
        mesh=str(on_face[0]) if on_face else "",
        point=_get(prim, "rigUI:anchor:pointIndex", -1),
        position=_floats(_get(prim, "rigUI:anchor:position", (0.0, 0.0, 0.0))),
        normal=_floats(_get(prim, "rigUI:anchor:normal", (0.0, 0.0, 0.0))),
        follows=bool(on_face) and adapt != "static",
        carriers=carriers,
        skeleton=skeleton,
        side=str(_get(prim, "rigUI:element:side", "none")),
        mirror=_name(prim.GetStage().GetPrimAtPath(mirror[0])) if mirror else "",
        reversed=tuple(int(i) for i in _get(prim, "rigUI:element:reversed", ())),
        inner=tuple(_name(prim.GetStage().GetPrimAtPath(path)) for path in _targets(prim, "rigUI:element:members")),
        family=str(_get(prim, "rigUI:element:family", "")),
        reason=str(_get(prim, "rigUI:element:reason", "")),
        axes=_axes(prim, len(instances)),
    )


def _axes(prim, count):
    """Positions of each axis: opposed pairs, negative end first, and all others alone."""
    opposed = [(int(a), int(b)) for a, b in _get(prim, "rigUI:element:opposed", ())]
    ends = [end for pair in opposed for end in pair]
    if len(set(ends)) < len(ends) or not set(ends) <= set(range(count)):
        raise LayoutError(f"{prim.GetPath()} opposes {opposed} of {count} controls")
    return tuple(sorted([*opposed, *((i,) for i in range(count) if i not in ends)], key=min))


def _name(prim):
    return (str(_get(prim, "rigUI:element:name", "")) or prim.GetName()) if prim else ""


def _instances(prim):
    applied = [name.split(":", 1)[1] for name in _applied(prim) if name.startswith("RigUIControlAPI:")]
    listed = [str(name) for name in _get(prim, "rigUI:element:controls", ())] or applied
    if not listed or set(listed) - set(applied):
        raise LayoutError(f"{prim.GetPath()} lists controls that it does not apply")
    return listed


def _track_of(prim, drawn, instance, count):
    for target in _targets(prim, f"rigUI:control:{instance}:track"):
        return prim.GetStage().GetPrimAtPath(target)
    for track in drawn:
        shown = [str(name) for name in _get(track, "rigUI:track:controls", ())]
        if shown == [instance] or (not shown and count == 1):
            return track
    raise LayoutError(f"{prim.GetPath()} has no track for {instance}")


def _member(prim, track, instance):
    points = _base_points(track)
    control = f"rigUI:control:{instance}"
    values = _floats(_get(track, "rigUI:track:weights", ()))
    if not values:
        low, high = _get(prim, f"{control}:minimum", 0.0), _get(prim, f"{control}:maximum", 1.0)
        values = tuple(low + (high - low) * i / (len(points) - 1) for i in range(len(points)))
    if len(values) != len(points) or len(points) < 2:
        raise LayoutError(f"{track.GetPath()} has {len(points)} points and {len(values)} values")
    name = str(_get(prim, f"{control}:name", "")) or instance
    return Member(name, values, points, _get(prim, f"{control}:gain", 1.0))


def _base_points(prim):
    points = _get(prim, "rigUI:track:basePoints", ()) or _get(prim, "points", ())
    return tuple(_floats(point) for point in points)


def _area(prim):
    triangles, start = [], 0
    indices = _get(prim, "faceVertexIndices", ())
    for count in _get(prim, "faceVertexCounts", ()):
        corner = [int(index) for index in indices[start : start + count]]
        triangles += [(corner[0], corner[i], corner[i + 1]) for i in range(1, count - 1)]
        start += count
    return Area(_base_points(prim), tuple(triangles))


def _carriers(track):
    """Joints and weights of a track's first point, and the skeleton they belong to."""
    skeleton = _targets(track, "skel:skeleton")
    tokens = [str(joint) for joint in _get(track, "skel:joints", ())]
    primvars = UsdGeom.PrimvarsAPI(track)
    indices, weights = (primvars.GetPrimvar(f"skel:joint{name}") for name in ("Indices", "Weights"))
    if not (skeleton and tokens and indices and weights):
        return (), str(skeleton[0]) if skeleton else ""
    width = max(1, indices.GetElementSize())
    pairs = zip(list(indices.Get() or ())[:width], list(weights.Get() or ())[:width], strict=True)
    return tuple((tokens[index], float(weight)) for index, weight in pairs if weight), str(skeleton[0])


def _drawn_width(scope):
    for prim in Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate):
        extent = _get(prim, "extent", ()) if "RigUIHandleAPI" in _applied(prim) else ()
        if len(extent) == 2:
            return max(extent[1][axis] - extent[0][axis] for axis in range(3))
    raise LayoutError(f"{scope.GetPath()} does not say how wide its handles are")


# --- the character -----------------------------------------------------------------------------------


def _meshes(root, scope):
    cache = UsdGeom.XformCache()
    found = []
    for prim in Usd.PrimRange(root, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)):
        if prim.IsA(UsdGeom.Mesh) and not prim.GetPath().HasPrefix(scope.GetPath()):
            points = UsdGeom.Mesh(prim).GetPointsAttr()
            value = points.Get() or points.Get(Usd.TimeCode.EarliestTime()) or ()
            found.append(MeshRest(str(prim.GetPath()), len(value), _rows(_to_root(prim, root, cache))))
    return tuple(found)


def _to_root(prim, root, cache):
    """Mesh space to root space: through the skeleton where the mesh is skinned, else as it stands."""
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
        raise LayoutError(f"{prim.GetPath()} has {len(bind)} bind transforms for {len(order)} joints")
    joints = []
    for i, path in enumerate(order):
        parent = path.rpartition("/")[0]
        local = bind[i] * bind[order.index(parent)].GetInverse() if parent in order else bind[i]
        joints.append(JointRest(path, _rows(local), _rows(rest[i] if len(rest) == len(order) else local)))
    return SkeletonRest(str(prim.GetPath()), _rows(_relative(prim, root, UsdGeom.XformCache())), tuple(joints))


# --- properties --------------------------------------------------------------------------------------


def _applied(prim):
    return [str(name) for name in prim.GetPrimTypeInfo().GetAppliedAPISchemas()]


def _get(prim, name, fallback):
    attribute = prim.GetAttribute(name)
    value = attribute.Get() if attribute and attribute.HasAuthoredValue() else None
    return fallback if value is None else value


def _targets(prim, name):
    relationship = prim.GetRelationship(name)
    return relationship.GetTargets() if relationship else []


def _floats(values):
    return tuple(float(value) for value in values)


def _rows(matrix):
    return tuple(tuple(float(matrix[i][j]) for j in range(4)) for i in range(4))
