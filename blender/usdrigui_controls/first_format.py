"""The same in the first format, where tracks and handles are prims below the element's."""

from __future__ import annotations

from pxr import Usd, UsdGeom

from .layout import LayoutError
from .properties import applied, carriers_of, floats, get, targets


def track(prim, instance, count):
    """Points and values along the track of one control, in the base pose."""
    drawn = _track_of(prim, instance, count)
    return _base_points(drawn), floats(get(drawn, "rigUI:track:weights", ()))


def carriers(prim, instances):
    """Joints and weights that carry the element, and their skeleton."""
    return carriers_of(_track_of(prim, instances[0], len(instances)), 0)


def areas(prim, _points):
    """Points and triangles of each area."""
    return tuple(
        (_base_points(child), _triangles(child))
        for child in _tracks(prim)
        if child.IsA(UsdGeom.Mesh)
    )


def _triangles(prim):
    triangles, start = [], 0
    indices = get(prim, "faceVertexIndices", ())
    for count in get(prim, "faceVertexCounts", ()):
        corner = [int(index) for index in indices[start : start + count]]
        triangles += [(corner[0], corner[i], corner[i + 1]) for i in range(1, count - 1)]
        start += count
    return tuple(triangles)


def adapt(prim):
    """Whether the element deforms or is static."""
    handles = [child for child in prim.GetAllChildren() if "RigUIHandleAPI" in applied(child)]
    return get(handles[0], "rigUI:handle:adapt", "deform") if handles else "deform"


def part_of(prim):
    """The part of the character to which an element belongs; empty where it is one part."""
    return str(get(prim, "rigUI:element:part", ""))


def category(prim):
    """The heading under which an element stands beside the character."""
    return str(get(prim, "rigUI:element:family", ""))


def reason(prim):
    """Why the element stands where it does, for people."""
    return str(get(prim, "rigUI:element:reason", ""))


def opposed(prim, _instances):
    """(negative, positive) positions of the members of signed axes."""
    return [(int(a), int(b)) for a, b in get(prim, "rigUI:element:opposed", ())]


def reversed_members(prim, _instances):
    """Positions of the members that mirror their counterparts with the opposite sign."""
    return tuple(int(i) for i in get(prim, "rigUI:element:reversed", ()))


def joint_table(of, name):
    """Rotation vectors in radians, translations, or logarithms of scale factors: one vector per key
    and joint."""
    return [floats(row) for row in of(f"joint{name}s", ())]


def drawn_width(scope):
    """Width of the first handle that is drawn."""
    for prim in Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate):
        extent = get(prim, "extent", ()) if "RigUIHandleAPI" in applied(prim) else ()
        if len(extent) == 2:
            return max(extent[1][axis] - extent[0][axis] for axis in range(3))
    raise LayoutError(f"{scope.GetPath()} does not say how wide its handles are")


def _tracks(prim):
    return [child for child in prim.GetAllChildren() if "RigUITrackAPI" in applied(child)]


def _track_of(prim, instance, count):
    for target in targets(prim, f"rigUI:control:{instance}:track"):
        return prim.GetStage().GetPrimAtPath(target)
    for each in _tracks(prim):
        shown = [str(name) for name in get(each, "rigUI:track:controls", ())]
        if shown == [instance] or (not shown and count == 1):
            return each
    raise LayoutError(f"{prim.GetPath()} has no track for {instance}")


def _base_points(prim):
    points = get(prim, "rigUI:track:basePoints", ()) or get(prim, "points", ())
    return tuple(floats(point) for point in points)
