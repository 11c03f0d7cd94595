"""Properties of prims: their applied schemas, attributes, relationships, and what a layout has
under one name."""

from __future__ import annotations

from pxr import Usd, UsdGeom, UsdSkel

from .layout import LayoutError


def agree(prim, is_so, what):
    """Raise LayoutError unless what a prim says of something belongs together."""
    if not is_so:
        raise LayoutError(f"{prim.GetPath()} contradicts itself: {what}")


def applied(prim):
    """Names of the API schemas applied to a prim."""
    return prim.GetPrimTypeInfo().GetAppliedAPISchemas()


def get(prim, name, fallback):
    """Authored value of an attribute, of the type of the fallback; or the fallback."""
    attribute = prim.GetAttribute(name)
    value = attribute.Get() if attribute and attribute.HasAuthoredValue() else None
    return fallback if value is None else type(fallback)(value)


def inherited(prim, name):
    """Value of a primvar of a prim or of one above; None where there is none."""
    return UsdGeom.PrimvarsAPI(prim).FindPrimvarWithInheritance(name).Get()


def targets(prim, name):
    """Targets of a relationship."""
    relationship = prim.GetRelationship(name)
    return relationship.GetTargets() if relationship else []


def named(prim, kind, instance):
    """The true name of a control or a part, where it is no identifier."""
    return get(prim, f"rigUI:{kind}:{instance}:name", "") or instance


def instances(prim, api):
    """Instance names of a schema in the order in which they are applied."""
    return [name.split(":", 1)[1] for name in applied(prim) if name.startswith(f"{api}:")]


def points_of(prim):
    """Points of a mesh prim, at the earliest time where they have no default."""
    points = UsdGeom.Mesh(prim).GetPointsAttr()
    return points.Get() or points.Get(Usd.TimeCode.EarliestTime()) or ()


def carriers(prim):
    """Joints and weights that carry an element as a whole, and their skeleton: those of the first
    point that draws it."""
    mesh, faces = prim.GetParent(), get(prim, "indices", ())
    indices, counts = (get(mesh, f"faceVertex{each}", ()) for each in ("Indices", "Counts"))
    agree(prim, all(0 <= face < len(counts) for face in faces), "faces of its mesh")
    agree(mesh, sum(counts) == len(indices), "corners of faces")
    skeleton = "".join(map(str, targets(mesh, "skel:skeleton")[:1]))
    if not faces or not skeleton:
        return (), skeleton
    point, tokens = indices[sum(counts[: min(faces)])], get(mesh, "skel:joints", ())
    binding = UsdSkel.BindingAPI(mesh)
    named_by = binding.GetJointIndicesPrimvar(), binding.GetJointWeightsPrimvar()
    width = named_by[0].GetElementSize()
    rows = (list(each.Get() or ())[point * width :][:width] for each in named_by)
    pairs = zip(*rows, strict=True)
    return tuple((tokens[index], weight) for index, weight in pairs if weight), skeleton
