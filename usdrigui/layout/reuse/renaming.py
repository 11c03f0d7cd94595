"""A layout whose controls have other names by now."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from usdrigui.layout.names import BETWEEN
from usdrigui.model import Element, Layout


def with_names(layout: Layout, names: Mapping[str, str]) -> Layout:
    """The layout with the new names of its controls by the old ones, and of the elements that are
    called after them."""
    elements = {each.name: _name(each, names) for each in layout.elements}
    return with_element_names(layout, elements, names)


def with_element_names(
    layout: Layout, elements: Mapping[str, str], names: Mapping[str, str] = MappingProxyType({})
) -> Layout:
    """The layout with new names of its elements, and of its controls, by the old ones."""
    return replace(
        layout, elements=tuple(_renamed(each, names, elements) for each in layout.elements)
    )


def _name(element: Element, names: Mapping[str, str]) -> str:
    controls = [member.control for member in element.members]
    between = next((each for each in BETWEEN if element.name == each.join(controls)), None)
    return (
        element.name
        if between is None
        else between.join(names.get(control, control) for control in controls)
    )


def _renamed(element: Element, names: Mapping[str, str], elements: Mapping[str, str]) -> Element:
    members = (
        replace(each, control=names.get(each.control, each.control)) for each in element.members
    )
    return replace(
        element,
        name=elements[element.name],
        members=tuple(members),
        mirror=elements.get(element.mirror, element.mirror),
        inner=tuple(elements.get(name, name) for name in element.inner),
    )
