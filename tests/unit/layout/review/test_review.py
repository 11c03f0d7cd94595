"""A layout rated by the objective."""

import chain
import makers
import numpy as np
import pytest

from usdrigui.layout.review.review import review


def test_the_nearest_handle_is_named_with_its_distance_in_handle_widths():
    line = chain.lay_out(makers.face())
    inputs = line.inputs
    rated = review(inputs.measured, line.candidates, line.layout).elements
    seen = line.face.drawing_axes.T
    places = {each.name: each.anchor.position @ seen for each in line.layout.elements if not each.anchor.on_board}
    assert {each.element for each in rated} == set(places)
    for each in rated:
        apart = {name: np.linalg.norm(places[each.element] - at) for name, at in places.items() if name != each.element}
        assert each.distance * line.layout.frame.handle_width == pytest.approx(min(apart.values()))
        assert apart[each.nearest] == pytest.approx(min(apart.values()))
