"""The tracks and the handle of an element, and where its mesh hangs."""

from __future__ import annotations

import math

from pxr import UsdGeom

from .properties import agree, carriers_of, floats, get


def track(prim, instance):
    """Points and values along the track of one control, in the base pose."""
    control = f"rigUI:control:{instance}"
    points = tuple(floats(point) for point in get(prim, f"{control}:trackPoints", ()))
    return points, floats(get(prim, f"{control}:trackValues", ()))


def carriers(prim):
    """Joints and weights that carry the element, and their skeleton: those of the first point of
    its handle."""
    if not prim.IsA(UsdGeom.Subset):
        return (), ""
    mesh, faces = prim.GetParent(), sorted(get(prim, "indices", ()))
    indices, counts = (list(get(mesh, f"faceVertex{each}", ())) for each in ("Indices", "Counts"))
    agree(prim, not faces or 0 <= faces[0] <= faces[-1] < len(counts), "faces of its mesh")
    agree(mesh, sum(counts) == len(indices), "corners of faces")
    primvar = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("rigUI:role")
    # ComputeFlattened knows no indexed tokens in the USD of Blender 4.5 and 5.0.
    said = list(primvar.Get() or ()) if primvar else []
    roles = [said[index] for index in primvar.GetIndices()] if primvar.IsIndexed() else said
    roles *= len(counts) if len(roles) == 1 else 1
    handle = next((face for face in faces if roles[face : face + 1] == ["handle"]), None)
    return ((), "") if handle is None else carriers_of(mesh, indices[sum(counts[:handle])])


def part_of(prim):
    """The part of the character to which an element belongs; empty where it is one part."""
    return str(get(prim.GetParent(), "rigUI:drawing:part", ""))


def opposed(prim, instances):
    """(negative, positive) positions of the members of signed axes."""
    named = [str(get(prim, f"rigUI:control:{instance}:opposes", "")) for instance in instances]
    agree(prim, {*named} <= {"", *instances}, "controls that it opposes")
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
