"""Properties of a layout's prims in our schemas: values or fallbacks, and records made of them.

The schema plug-in need not be registered.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
from pxr import Sdf, Usd, Vt

from usdrigui.character import Indices
from usdrigui.errors import listed, refuse
from usdrigui.layer import author
from usdrigui.layer.rules import broken
from usdrigui.model import Anchor, Decision, Element, in_order
from usdrigui.stages import schema
from usdrigui.stages.arrays import value_at


def applied(prim: Usd.Prim) -> list[str]:
    """The API schemas that are applied to a prim, whether or not USD knows them."""
    return [*map(str, prim.GetPrimTypeInfo().GetAppliedAPISchemas())]


def has(prim: Usd.Prim, api: str) -> bool:
    """Whether a schema is applied."""
    return api in applied(prim)


def instances_applied(prim: Usd.Prim, api: str) -> list[str]:
    """Instance names of one of our schemas in the order in which they are applied."""
    prefix = f"{api}:"
    return [name.removeprefix(prefix) for name in applied(prim) if name.startswith(prefix)]


def value_of(prim: Usd.Prim, api: str, name: str, instance: str = "") -> Any:
    """Value of a property of one of our schemas, or its fallback, as Python and numpy have it:
    arrays of text are lists, vectors and arrays of numbers (n,) or (n, 3).  Of a relationship the
    paths of its targets.

    Raises LAYOUT_INVALID for a value of another type or outside the allowed ones.
    """
    declared = author.properties(api)[name]
    where = declared.name.replace("__INSTANCE_NAME__", instance)
    if not declared.type_name:
        relationship = prim.GetRelationship(where)
        return [*map(str, relationship.GetTargets())] if relationship else []
    attribute = prim.GetAttribute(where)
    value = attribute.Get() if attribute else None
    if value is None:
        return _plain(declared.fallback)
    # A crate may hold a value that is not of the type named beside it.
    kind = Sdf.ValueTypeNames.Find(declared.type_name)
    if attribute.GetTypeName() != kind or not isinstance(value, type(kind.defaultValue)):
        raise invalid(attribute, f"is {attribute.GetTypeName()}, not {declared.type_name}")
    if declared.allowed:
        words = [value] if isinstance(value, str) else value
        unknown = [word for word in words if word not in declared.allowed]
        if unknown:
            raise invalid(attribute, f"is {unknown[0]!r}, not one of {', '.join(declared.allowed)}")
    return _plain(value)


def _plain(value: Any) -> Any:
    """A value of USD without its own kinds of arrays, numbers in double precision."""
    if value is None or isinstance(value, (str, int, float)):
        return value
    if isinstance(value, (Vt.TokenArray, Vt.StringArray)):
        return list(value)
    return np.array(value, dtype=np.int64 if isinstance(value, Vt.IntArray) else np.float64)


def refuse_broken(
    prim: Usd.Prim, api: str, instance: str = "", *, free: Collection[str] = ()
) -> None:
    """Raise LAYOUT_INVALID for the first property of a schema on a prim that has another type, an
    unknown word, or breaks a rule of its documentation (`usdrigui.layer.rules`), unless its full
    name is one of `free`."""
    sibling = partial(value_of, prim, api, instance=instance)
    for name, declared in author.properties(api).items():
        value = sibling(name)
        where = declared.name.replace("__INSTANCE_NAME__", instance)
        held = declared.rules and value is not None and where not in free
        numbers = value if declared.type_name else np.zeros(len(value))
        for clause in broken(declared.rules, numbers, sibling) if held else ():
            missing = where not in prim.GetAuthoredPropertyNames()
            what = "is missing" if missing else clause
            raise refuse("LAYOUT_INVALID", f"{prim.GetPath()}.{where}", what)


def invalid(where: Usd.Object, message: str) -> Exception:
    """LAYOUT_INVALID at a prim or an attribute."""
    return refuse("LAYOUT_INVALID", where.GetPath(), message)


def control_instances(prim: Usd.Prim) -> list[str]:
    """Instance names of an element's controls, in its order.  Raises LAYOUT_INVALID for none, and
    for a list of others than are applied."""
    known = instances_applied(prim, schema.CONTROL)
    instances: list[str] = value_of(prim, schema.ELEMENT, "controls") or known
    if not known or sorted(instances) != sorted(known):
        what = f"lists {listed(instances) or 'none'}, but applies {listed(known) or 'no control'}"
        raise invalid(prim, what)
    return instances


def element_names(prim: Usd.Prim, relationship: str) -> tuple[str, ...]:
    """Names of the elements that a relationship of an element targets."""
    stage = prim.GetStage()
    return tuple(
        element_name(stage.GetPrimAtPath(each))
        for each in value_of(prim, schema.ELEMENT, relationship)
    )


def element_name(prim: Usd.Prim) -> str:
    """Name of the element at a prim; empty where there is none, or an inactive one."""
    if not prim or not prim.IsActive():
        return ""
    return str(value_of(prim, schema.ELEMENT, "name") or prim.GetName())


# --- records --------------------------------------------------------------------------------------


def read_anchor(prim: Usd.Prim) -> Anchor:
    """Where an element holds on; raises LAYOUT_INVALID."""
    get = partial(value_of, prim, schema.ANCHOR)
    on_face = get("prim")
    return Anchor(
        mesh=next(iter(on_face or get("carrier")), ""),
        point=get("pointIndex"),
        point_count=get("pointCount"),
        topology_hash=get("topologyHash"),
        position=get("position"),
        normal=get("normal"),
        on_board=not on_face,
    )


_DECIDED: Mapping[Decision, frozenset[str]] = {
    "anchor": frozenset({"rigUI:anchor:prim", "rigUI:anchor:pointIndex"}),
    "place": frozenset({"rigUI:anchor:carrier"}),
    "grouping": frozenset({"rigUI:element:controls", "rigUI:element:elementType"}),
}
"""Properties that hold the decisions of a layout."""


def corrected(element: Element, prim: Usd.Prim) -> Element:
    """The element with the opinions of layers stronger than the defining one as decisions of a
    person.

    Such a layer need not give its anchor's position; it is then lost, should the mesh get other
    points.
    """
    authored = _authored_above(prim)
    found = {decision for decision, names in _DECIDED.items() if authored & names}
    if not found or "rigUI:element:pinned" in authored:
        return element
    position = element.pinned_position
    if "anchor" in found:
        known = "rigUI:anchor:position" in authored
        x, y, z = element.anchor.position.tolist() if known else (np.nan,) * 3
        position = (x, y, z)
    pinned = in_order(found | {*element.pinned})
    return replace(element, pinned=pinned, pinned_position=position)


def chosen_point(prim: Usd.Prim) -> set[str]:
    """The name of the point of an element's anchor where a stronger layer chooses it, which may be
    beyond those of the mesh."""
    return _authored_above(prim) & {"rigUI:anchor:pointIndex"}


def _authored_above(prim: Usd.Prim) -> set[str]:
    """Properties of which a layer stronger than the one that defines the prim has an opinion."""
    stack = prim.GetPrimStack()
    defining = next(
        (number for number, spec in enumerate(stack) if spec.specifier == Sdf.SpecifierDef),
        len(stack),
    )
    # Views of Sdf iterate over specs, not over names.
    views = [spec.properties for spec in stack[:defining]]
    return {str(each) for view in views for each in view.keys()}  # noqa: SIM118


def check_elements(scope: Usd.Prim, elements: tuple[Element, ...]) -> None:
    """Refuse elements that contradict each other with LAYOUT_INVALID."""
    names = sorted(element.name for element in elements)
    coarse = {element.name for element in elements if element.inner}
    faults = [f"two elements are called {one!r}" for one, next_ in pairwise(names) if one == next_]
    for element in elements:
        for name in element.inner:
            if name not in names or name in coarse:
                what = "is coarse itself" if name in coarse else "is not an element of the layout"
                faults.append(f"{name!r}, a member of {element.name!r}, {what}")
    if faults:
        raise invalid(scope, faults[0])


# --- arrays of USD's own schemas ------------------------------------------------------------------


def integers_of(attribute: Usd.Attribute) -> Indices:
    """(n,) what an array of USD's own schemas holds; empty for any other type."""
    values = value_at(attribute, Usd.TimeCode.Default())
    return np.array(values if isinstance(values, Vt.IntArray) else (), dtype=np.int64)
