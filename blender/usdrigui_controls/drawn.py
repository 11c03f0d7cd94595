"""What an element says of its tracks and its handle, and where its mesh hangs: in the format that
is written today."""

from __future__ import annotations

import math

from pxr import Usd, UsdGeom

from .layout import LayoutError
from .properties import applied, carriers_of, floats, get


def track(prim, instance, _count):
    """Points and values along the track of one control, in the base pose."""
    control = f"rigUI:control:{instance}"
    points = tuple(floats(point) for point in get(prim, f"{control}:trackPoints", ()))
    return points, floats(get(prim, f"{control}:trackValues", ()))


def carriers(prim, _instances):
    """Joints and weights that carry the element, and their skeleton."""
    corners = _corners(prim)
    return carriers_of(prim.GetParent(), corners[0][0]) if corners else ((), "")


def areas(prim, tracks):
    """Points and triangles of the areas between tracks, which are the last faces.

    Their corners are ends of tracks, or where a track begins; the drawn tracks tell which, as they
    lie at rest.
    """
    count = get(prim, "rigUI:handle:faceCount", 0)
    corners = _corners(prim)[count:]
    split = sum(len(points) - 1 for points in tracks)
    places = [each for points in tracks for each in _spike(points)]
    drawn = get(prim.GetParent(), "points", ())
    spikes = sorted({point for face in corners[:split] for point in face})
    found = []
    for face in corners[split:]:
        nearest = [_nearest(drawn, spikes, corner) for corner in face]
        polygon = tuple(places[spikes.index(point)] for point in nearest)
        found.append((polygon, tuple((0, i, i + 1) for i in range(1, len(polygon) - 1))))
    return tuple(found)


def _nearest(drawn, points, corner):
    return min(points, key=lambda point: (drawn[point] - drawn[corner]).GetLength())


def _spike(points):
    """Where the drawn points of a track are: two at each of its points, one at the last."""
    return [*(each for point in points[:-1] for each in (point, point)), points[-1]]


def _corners(prim):
    """The points around each face of an element."""
    if not prim.IsA(UsdGeom.Subset):
        return []
    mesh, starts = prim.GetParent(), [0]
    indices, counts = get(mesh, "faceVertexIndices", ()), get(mesh, "faceVertexCounts", ())
    for count in counts:
        starts.append(starts[-1] + count)
    faces = get(prim, "indices", ())
    if any(not 0 <= face < len(counts) for face in faces) or starts[-1] != len(indices):
        raise LayoutError(f"{prim.GetPath()} has faces that its mesh has not")
    return [[int(point) for point in indices[starts[face] : starts[face + 1]]] for face in faces]


def adapt(prim):
    """Whether the element deforms or is static."""
    return get(prim, "rigUI:handle:adapt", "deform")


def category(prim):
    """The heading under which an element stands beside the character."""
    return str(get(prim, "rigUI:element:category", ""))


def reason(prim):
    """Why the element stands where it does, for people."""
    return prim.GetDocumentation() if prim.HasAuthoredDocumentation() else ""


def opposed(prim, instances):
    """(negative, positive) positions of the members of signed axes."""
    named = [str(get(prim, f"rigUI:control:{instance}:opposes", "")) for instance in instances]
    if any(each and each not in instances for each in named):
        raise LayoutError(f"{prim.GetPath()} opposes {named} of {instances}")
    return [(instances.index(each), i) for i, each in enumerate(named) if each]


def reversed_members(prim, instances):
    """Positions of the members that mirror their counterparts with the opposite sign."""
    told = (get(prim, f"rigUI:control:{instance}:mirrorReversed", False) for instance in instances)
    return tuple(i for i, each in enumerate(told) if each)


def joint_table(of, name):
    """Rotation vectors in radians, translations, or logarithms of scale factors: one vector per key
    and joint."""
    if name == "Rotation":
        return [tuple(math.radians(each) for each in row) for row in of("jointRotationVectors", ())]
    if name == "Scale":
        return [tuple(math.log(each) for each in row) for row in of("jointScaleFactors", ())]
    return [floats(row) for row in of("jointTranslations", ())]


def drawn_width(scope):
    """Width of the first handle that is drawn."""
    for prim in Usd.PrimRange(scope, Usd.PrimAllPrimsPredicate):
        faces = (
            _corners(prim)[: get(prim, "rigUI:handle:faceCount", 0)]
            if "RigUIElementAPI" in applied(prim)
            else ()
        )
        points = [get(prim.GetParent(), "points", ())[point] for face in faces for point in face]
        if points:
            return max(
                max(point[axis] for point in points) - min(point[axis] for point in points)
                for axis in range(3)
            )
    raise LayoutError(f"{scope.GetPath()} does not say how wide its handles are")
