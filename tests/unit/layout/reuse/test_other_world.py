"""A layout in the units and with the up axis of another version of its character."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest

from usdrigui.layout.reuse.other_world import in_world, turn_between, up_of
from usdrigui.model import LayoutPart

TURN = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From Y up to Z up."""
Y, Z = np.eye(3)[1:]


def laid_out(matrix, metres):
    """The face's layout in a world, its only part and every pin on record."""
    layout = chain.lay_out(makers.moved(makers.face(), matrix, (1.0, 2.0, 3.0) @ matrix.T)).layout
    part = LayoutPart("face", layout.frame.handle_width, layout.frame.view, "optimal", 0.0, 0.0)
    elements = tuple(replace(each, pinned_position=tuple(each.anchor.position)) for each in layout.elements)
    return replace(layout, elements=elements, frame=replace(layout.frame, parts=(part,)), metres_per_unit=metres)


def unmirrored(layout):
    plane = replace(layout.frame.plane, normal=np.zeros(3))
    return replace(layout, frame=replace(layout.frame, plane=plane))


def numbers(layout):
    """All that has a length or a direction."""
    frame, (part,) = layout.frame, layout.frame.parts
    found = [frame.view, frame.plane.normal, frame.plane.origin, frame.handle_width, part.handle_width, part.view]
    for each in layout.elements:
        found += [each.anchor.position, each.anchor.normal, each.pinned_position]
        found += [value for m in each.members for value in (m.track, m.arc_length, m.peak)]
    return np.concatenate([np.ravel(each) for each in found])


def test_a_layout_of_another_world_is_as_it_would_have_been_made_in_this_one():
    """Where it mirrors about no plane its elements of two sides tell its left, and where they do not, nothing turns."""
    before, after = laid_out(np.eye(3), 1.0), laid_out(100.0 * TURN, 0.01)
    for view in (lambda layout: layout, unmirrored):
        found = in_world(view(before), 0.01, Z)
        assert numbers(found) == pytest.approx(numbers(view(after)), rel=1e-5, abs=1e-4)
        assert in_world(found, 0.01, Z) is found
    assert in_world(before, 1.0, Z).frame.handle_width == before.frame.handle_width
    above = replace(before, frame=replace(before.frame, view=-before.frame.view))
    one_side = replace(unmirrored(before), elements=before.elements[:1])
    assert up_of(above) is up_of(one_side) is None
    assert turn_between(np.zeros(3), Z).tolist() == turn_between(Y, np.zeros(3)).tolist() == np.eye(3).tolist()
