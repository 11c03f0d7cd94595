"""The tracks and the handle of an element, and where its mesh hangs."""

from __future__ import annotations

import itertools
import math

from pxr import UsdGeom

from .layout import LayoutError
from .properties import carriers_of, floats, get

_INSET = 0.05
"""Of the way from a corner of an area to its middle: so far areas stay away from the tracks."""


def track(prim, instance):
    """Points and values along the track of one control, in the base pose."""
    control = f"rigUI:control:{instance}"
    points = tuple(floats(point) for point in get(prim, f"{control}:trackPoints", ()))
    return points, floats(get(prim, f"{control}:trackValues", ()))


def carriers(prim):
    """Joints and weights that carry the element, and their skeleton."""
    corners = _corners(prim, ("handle",))
    return carriers_of(prim.GetParent(), corners[0][0]) if corners else ((), "")


def areas(prim, tracks):
    """Points and triangles of the areas between tracks, which are the last faces.

    Their corners stand in from ends of tracks, or from where the handle is on one.  The drawn
    tracks, which may have fewer points than the tracks, tell how far along that is.
    """
    faces = _corners(prim, ("track", "area"))
    points = get(prim.GetParent(), "points", ())
    lines, polygons = _drawn_tracks(faces, len(tracks), points)
    found = []
    for face in polygons:
        corners = [points[corner] for corner in face]
        middle = sum(corners[1:], corners[0]) / len(corners)
        ends = [middle + (corner - middle) / (1.0 - _INSET) for corner in corners]
        polygon = tuple(_on_a_track(lines, tracks, end) for end in ends)
        found.append((polygon, tuple((0, i, i + 1) for i in range(1, len(polygon) - 1))))
    return tuple(found)


def _drawn_tracks(faces, count, points):
    """The middle line of each drawn track, a strip of quads that ends in a triangle; and the faces
    that follow."""
    lines, strip = [], []
    for position, face in enumerate(faces):
        if len(lines) == count:
            return lines, faces[position:]
        strip += face
        if len(face) == 3:
            found = [points[each] for each in sorted(set(strip))]
            pairs = zip(found[:-1:2], found[1::2], strict=False)
            lines.append([*((left + right) / 2 for left, right in pairs), found[-1]])
            strip = []
    return lines, []


def _on_a_track(lines, tracks, place):
    """The point of the tracks, in the base pose, that is where a place is on the drawn ones."""
    found = []
    for number, line in enumerate(lines):
        for piece, (start, end) in enumerate(itertools.pairwise(line)):
            along, squared = end - start, (end - start) * (end - start)
            share = min(max((place - start) * along / squared, 0.0), 1.0) if squared else 0.0
            away = (start + share * along - place).GetLength()
            before = sum((b - a).GetLength() for a, b in itertools.pairwise(line[: piece + 1]))
            found.append((away, number, before + share * along.GetLength()))
    _, number, way = min(found)
    whole = sum((b - a).GetLength() for a, b in itertools.pairwise(lines[number]))
    return _at(tracks[number], way / whole if whole else 0.0)


def _at(points, share):
    """Where a line is after a share of its length."""
    lengths = [math.dist(a, b) for a, b in itertools.pairwise(points)]
    left = share * sum(lengths)
    for a, b, length in zip(points[:-1], points[1:], lengths, strict=True):
        if left <= length:
            part = left / length if length else 0.0
            return tuple((1.0 - part) * p + part * q for p, q in zip(a, b, strict=True))
        left -= length
    return points[-1]


def _corners(prim, roles):
    """The points around each face of an element that is drawn for one of these roles."""
    if not prim.IsA(UsdGeom.Subset):
        return []
    mesh, starts = prim.GetParent(), [0]
    indices, counts = get(mesh, "faceVertexIndices", ()), get(mesh, "faceVertexCounts", ())
    for count in counts:
        starts.append(starts[-1] + count)
    faces = get(prim, "indices", ())
    if any(not 0 <= face < len(counts) for face in faces) or starts[-1] != len(indices):
        raise LayoutError(f"{prim.GetPath()} has faces that its mesh has not")
    primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("rigUI:role")
    drawn = list(primvar.ComputeFlattened() or () if primvar else ())
    drawn *= len(counts) if len(drawn) == 1 else 1
    if len(drawn) != len(counts):
        return []
    chosen = [face for face in sorted(faces) if drawn[face] in roles]
    return [[int(point) for point in indices[starts[face] : starts[face + 1]]] for face in chosen]


def adapt(prim):
    """Whether the element deforms or is static."""
    return get(prim, "rigUI:handle:adapt", "deform")


def part_of(prim):
    """The part of the character to which an element belongs; empty where it is one part."""
    return str(get(prim.GetParent(), "rigUI:drawing:part", ""))


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
    flags = (get(prim, f"rigUI:control:{instance}:mirrorReversed", False) for instance in instances)
    return tuple(i for i, each in enumerate(flags) if each)


def joint_table(of, name):
    """Rotation vectors in radians, translations, or logarithms of scale factors: one vector per key
    and joint."""
    if name == "Rotation":
        return [tuple(math.radians(each) for each in row) for row in of("jointRotationVectors", ())]
    if name == "Scale":
        return [tuple(math.log(each) for each in row) for row in of("jointScaleFactors", ())]
    return [floats(row) for row in of("jointTranslations", ())]
