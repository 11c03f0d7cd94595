"""Which elements of a layout are visible together: coarse ones first, their members on demand, by
the rule of `usdrigui.model.visible`."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from usdrigui.errors import refuse
from usdrigui.model.layout import Element, Layout
from usdrigui.model.visible import is_visible, opened_with


def inner_names(elements: Iterable[Element]) -> frozenset[str]:
    """Names of the elements that are members of a coarse one, and so on the second level."""
    return frozenset(name for element in elements for name in element.inner)


def outer_first(elements: Sequence[Element]) -> tuple[Element, ...]:
    """The elements of the first level, then those of the second, each in their order."""
    inner = inner_names(elements)
    return tuple(sorted(elements, key=lambda element: element.name in inner))


def with_levels(elements: Sequence[Element]) -> Iterator[tuple[Element, bool]]:
    """Those of `outer_first`, each with whether one before it has a control of it."""
    held = frozenset[str]()
    for element in outer_first(elements):
        yield element, not held.isdisjoint(element.controls)
        held |= element.controls


def states(elements: Sequence[Element]) -> Mapping[str, frozenset[int]]:
    """`states_of` elements."""
    mirrors = {each.name: each.mirror for each in elements}
    return states_of(mirrors, _members(elements), mirrors)


def states_of(
    names: Iterable[str], members: Mapping[str, tuple[str, ...]], mirrors: Mapping[str, str]
) -> Mapping[str, frozenset[int]]:
    """By name, the states in which an element is visible: 0 with nothing opened, k with the k-th
    coarse one opened; `members` are those of each coarse one, `mirrors` what opens with it."""
    opened = [opened_with(each, mirrors.get(each, ""), members) for each in ("", *members)]
    return {
        name: frozenset(k for k, some in enumerate(opened) if is_visible(name, members, some))
        for name in names
    }


def shown(layout: Layout) -> Layout:
    """The layout with nothing opened."""
    return _visible(layout, ())


def shown_of_all(
    layouts: Sequence[Layout], opened: Iterable[str], *, everything: bool = False
) -> tuple[Layout, ...]:
    """The layouts with their visible elements only, when the coarse elements named are opened, or
    all of them.

    Raises CONFIG_VALUE for a name that no coarse element of any bears.
    """
    coarse = {e.name for layout in layouts for e in layout.elements if e.inner}
    names = coarse if everything else set(opened)
    for name in sorted(names - coarse):
        known = ", ".join(sorted(coarse)) or "none"
        raise refuse(
            "CONFIG_VALUE", "--open", f"{name!r} is not a coarse element; there are {known}"
        )
    return tuple(_visible(layout, names) for layout in layouts)


def _visible(layout: Layout, names: Collection[str]) -> Layout:
    members = _members(layout.elements)
    opened = _opened([e for e in layout.elements if e.inner and e.name in names], members)
    seen = tuple(e for e in layout.elements if is_visible(e.name, members, opened))
    return replace(layout, elements=seen)


def _members(elements: Iterable[Element]) -> Mapping[str, tuple[str, ...]]:
    """Names of the members of each coarse element."""
    return {element.name: element.inner for element in elements if element.inner}


def _opened(coarse: Iterable[Element], members: Mapping[str, tuple[str, ...]]) -> frozenset[str]:
    """What opens with some coarse elements: they and their mirrors."""
    pairs = (opened_with(each.name, each.mirror, members) for each in coarse)
    return frozenset().union(*pairs)
