"""Properties of prims: their applied schemas, attributes, relationships, and the influences of
their points."""

from __future__ import annotations

from pxr import Usd, UsdGeom

from .layout import LayoutError


def agree(prim, is_so, what):
    """Raise LayoutError unless what a prim says of something belongs together."""
    if not is_so:
        raise LayoutError(f"{prim.GetPath()} contradicts itself: {what}")


def applied(prim):
    """Names of the API schemas applied to a prim."""
    return [str(name) for name in prim.GetPrimTypeInfo().GetAppliedAPISchemas()]


def get(prim, name, fallback):
    """Authored value of an attribute, or the fallback."""
    attribute = prim.GetAttribute(name)
    value = attribute.Get() if attribute and attribute.HasAuthoredValue() else None
    return fallback if value is None else value


def targets(prim, name):
    """Targets of a relationship."""
    relationship = prim.GetRelationship(name)
    return relationship.GetTargets() if relationship else []


def floats(values):
    """Numbers as a tuple of Python floats."""
    return tuple(float(value) for value in values)


def points_of(prim):
    """Points of a mesh prim, at the earliest time where they have no default."""
    points = UsdGeom.Mesh(prim).GetPointsAttr()
    return points.Get() or points.Get(Usd.TimeCode.EarliestTime()) or ()


def carriers_of(prim, point):
    """Joints and weights of one point of a gprim, and the skeleton they belong to."""
    skeleton = targets(prim, "skel:skeleton")
    tokens = [str(joint) for joint in get(prim, "skel:joints", ())]
    primvars = UsdGeom.PrimvarsAPI(prim)
    indices, weights = (primvars.GetPrimvar(f"skel:joint{name}") for name in ("Indices", "Weights"))
    if not (skeleton and tokens and indices and weights):
        return (), str(skeleton[0]) if skeleton else ""
    width = max(1, indices.GetElementSize())
    rows = slice(width * point, width * (point + 1))
    pairs = zip(list(indices.Get() or ())[rows], list(weights.Get() or ())[rows], strict=True)
    return tuple((tokens[index], float(weight)) for index, weight in pairs if weight), str(
        skeleton[0]
    )
