"""The tracks and the handle of an element, and where its mesh hangs."""

from __future__ import annotations

import math

from pxr import UsdGeom

from .layout import LayoutError
from .properties import carriers_of, floats, get


def track(prim, instance):
    """Points and values along the track of one control, in the base pose."""
    control = f"rigUI:control:{instance}"
    points = tuple(floats(point) for point in get(prim, f"{control}:trackPoints", ()))
    return points, floats(get(prim, f"{control}:trackValues", ()))


def carriers(prim):
    """Joints and weights that carry the element, and their skeleton."""
    corners = _corners(prim, ("handle",))
    return carriers_of(prim.GetParent(), corners[0][0]) if corners else ((), "")


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
    # ComputeFlattened knows no indexed tokens in the USD of Blender 4.5 and 5.0.
    said = list(primvar.Get() or ()) if primvar else []
    drawn = (
        [said[index] for index in primvar.GetIndices()] if said and primvar.IsIndexed() else said
    )
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
