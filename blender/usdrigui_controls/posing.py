"""Which controls belong together, and poses made of poses: the other side, a mirror's, between two
keys; numpy only, nothing of Blender.

The page has the same rules in viewer/src/keying.js and posing.js; tests/mirrored_poses.json holds
both to the same answers.
"""

from __future__ import annotations

from itertools import chain, permutations

import numpy as np


def element_of(layout):
    """The element of each control by name: the coarse one, where it has one of its own besides."""
    found = {}
    for element in layout.elements:
        for member in element.members:
            if element.name not in found.get(member.control, element).inner:
                found[member.control] = element
    return found


def opposites_of(layout):
    """Per control the other ends of its axes: one at most of a pair is away from its default."""
    found = {control.name: [] for control in layout.controls}
    for element in layout.elements:
        for one, other in chain.from_iterable(permutations(axis, 2) for axis in element.axes):
            found[element.members[one].control].append(element.members[other].control)
    return found


def twins_of(layout):
    """Of each control that has a counterpart on the other side, its name and whether it goes the
    other way; the other end of an axis is none."""
    opposites, found = opposites_of(layout), {}
    for element in layout.elements:
        other = layout.element(element.mirror)
        if other not in (None, element) and len(other.members) == len(element.members):
            for mine, theirs in zip(element.members, other.members, strict=True):
                if theirs.control not in opposites[mine.control]:
                    found[mine.control] = theirs.control, mine.reversed
    return found


def ranges_of(layout):
    """(minimum, value in the base pose, maximum) of each control."""
    return {each.name: (each.minimum, each.base, each.maximum) for each in layout.controls}


def mirrored(value, mine, theirs, other_way=False):
    """The value of a twin that is as far from the base pose towards its end, in its own range
    ``theirs``; within that."""
    (low, rest, high), (least, base, most) = mine, theirs
    rising = value >= rest
    end = high if rising else low
    share = (value - rest) / (end - rest) if end != rest else 0.0
    other = most if rising != other_way else least
    return np.clip(base + share * (other - base), least, most)


def with_partners(changed, layout):
    """Values with those of twin controls added; one that was itself dragged keeps its value."""
    found, ranges, twins = dict(changed), ranges_of(layout), twins_of(layout)
    for name, value in changed.items():
        twin, other_way = twins.get(name, (name, False))
        if twin not in changed:
            found[twin] = mirrored(value, ranges[name], ranges[twin], other_way)
    return found


def flipped(layout, values, crosses):
    """The pose seen in a mirror: values by name of all that changes; ``crosses(name)`` tells
    whether a control moves the face to one side."""
    ranges, twins, opposites = ranges_of(layout), sides_of(layout), opposites_of(layout)
    found = {}
    for name, (low, rest, high) in ranges.items():
        axis = [name, *opposites[name][:1]]
        moved = any(values[each] != ranges[each][1] for each in axis)
        if name not in twins and not (moved and crosses(name)):
            continue
        other = twins.get(name) or next(filter(crosses, axis[1:]), None)
        if other is not None:
            found[name] = mirrored(values[other], ranges[other], ranges[name])
        elif low < rest < high:
            found[name] = np.clip(2.0 * rest - values[name], low, high)
    return found


def mirrored_from(layout, values, side):
    """The pose with one ``side``'s values on the other, too: values by name of the other side."""
    ranges, elements = ranges_of(layout), element_of(layout)
    return {
        twin: mirrored(values[name], ranges[name], ranges[twin])
        for name, twin in sides_of(layout).items()
        if elements[name].side == side
    }


def sides_of(layout):
    """Twins that rise together."""
    return {name: twin for name, (twin, other_way) in twins_of(layout).items() if not other_way}
