"""A layout rated by the objective."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest

from usdrigui.layout.review.review import review


def test_the_nearest_handle_is_named_with_its_distance_in_handle_widths():
    """Also where handles of another part stand on the same places."""
    line = chain.lay_out(makers.face())
    known = line.inputs.measured
    asked = replace(known.requests, neighbours=line.layout.elements)
    rated = review(replace(known, requests=asked), line.candidates, line.layout).elements
    seen = line.face.drawing_axes.T
    places = {each.name: each.anchor.position @ seen for each in line.layout.elements if not each.anchor.on_board}
    assert {each.element for each in rated} == set(places)
    for each in rated:
        apart = {name: np.linalg.norm(places[each.element] - at) for name, at in places.items() if name != each.element}
        assert each.distance * line.layout.frame.handle_width == pytest.approx(min(apart.values()))
        assert apart[each.nearest] == pytest.approx(min(apart.values()))
