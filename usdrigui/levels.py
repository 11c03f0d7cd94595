"""Which elements of a layout are visible together: coarse ones first, their members on demand, by
the rule of `usdrigui.visible`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from usdrigui.errors import refuse
from usdrigui.model import Element, Layout
from usdrigui.visible import is_visible, opened_with


def inner_names(elements: Iterable[Element]) -> frozenset[str]:
    """Names of the elements that are members of a coarse one, and so on the second level."""
    return frozenset(name for element in elements for name in element.look.inner)


def outer_first(elements: Iterable[Element]) -> tuple[Element, ...]:
    """The elements of the first level, then those of the second, each in their order."""
    found = tuple(elements)
    inner = inner_names(found)
    return tuple(sorted(found, key=lambda element: element.name in inner))


def states(elements: Iterable[Element]) -> Mapping[str, frozenset[int]]:
    """By name, the states in which an element is visible: 0 with nothing opened, k with the k-th
    coarse one opened, and the last with all of them."""
    found = tuple(elements)
    members = members_of(found)
    opened = [
        opened_with(each.name, each.manipulator.mirror, members)
        for each in found
        if each.look.inner
    ]
    return {
        element.name: frozenset(
            state
            for state, names in enumerate([frozenset(), *opened, frozenset().union(*opened)])
            if is_visible(element.name, members, names)
        )
        for element in found
    }


def shown(layout: Layout, opened: Iterable[str] = (), *, everything: bool = False) -> Layout:
    """The layout with its visible elements only, when the coarse elements named are opened, or all
    of them.

    Raises CONFIG_VALUE for a name that no coarse element bears.
    """
    coarse = {element.name: element for element in layout.elements if element.look.inner}
    names = set(coarse) if everything else set(opened)
    for name in sorted(names):
        if name not in coarse:
            known = ", ".join(sorted(coarse)) or "none"
            raise refuse(
                "CONFIG_VALUE", "--open", f"{name!r} is not a coarse element; there are {known}"
            )
    members = members_of(layout.elements)
    wide = frozenset().union(
        *(opened_with(each, coarse[each].manipulator.mirror, members) for each in names)
    )
    return replace(
        layout,
        elements=tuple(each for each in layout.elements if is_visible(each.name, members, wide)),
    )


def members_of(elements: Iterable[Element]) -> Mapping[str, frozenset[str]]:
    """Names of the members of each coarse element."""
    return {
        element.name: frozenset(element.look.inner) for element in elements if element.look.inner
    }


def shown_of_all(
    layouts: Iterable[Layout], opened: Iterable[str], *, everything: bool = False
) -> tuple[Layout, ...]:
    """`shown` for several characters, each name being that of a coarse element of one of them at
    least."""
    found, names = tuple(layouts), set(opened)
    coarse = [
        names & {element.name for element in layout.elements if element.look.inner}
        for layout in found
    ]
    for name in sorted(names.difference(*coarse)):
        shown(found[0], [name])
    return tuple(
        shown(each, own, everything=everything) for each, own in zip(found, coarse, strict=True)
    )
