"""Locality: near something, or at a proxy."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS

from usdrigui.errors import RigUIError


def test_a_hidden_control_may_stand_at_a_visible_proxy():
    found = chain.chosen(makers.face_with_teeth(), controls={"teeth": {"place": "proxy"}})("teeth")
    assert found.category != "hidden"
    assert (found.points < len(POINTS)).all()
    assert (found.sources >= len(POINTS)).all()
    assert np.linalg.norm(POINTS[found.points] - makers.TEETH.mean(axis=0), axis=1).max() < 0.8


@pytest.mark.parametrize("near", ["/Root/mesh#700", "/Root/mesh#0"])
def test_locality_keeps_candidates_near_or_takes_the_nearest(near):
    point = int(near.split("#")[1])
    line = chain.with_candidates(makers.face(), chain.settings(controls={"jawLeft": {"near": near, "within": 0.1}}))
    found, free = chain.set_of(line, "jawLeft"), chain.chosen(makers.face())("jawLeft")
    moved = found.motion.points
    seen = moved[line.face.views.anywhere[moved]]
    apart = np.linalg.norm(POINTS - POINTS[point], axis=1)
    assert 1 <= len(found.points) < len(free.points)
    assert apart[found.points].min() <= 1.09 * apart[seen].min(), "the nearest along the surface"


@pytest.mark.parametrize("near", ["joint:nobody", "/no/mesh", "/Root/mesh#99999"])
def test_locality_refuses_what_is_not_there(near):
    with pytest.raises(RigUIError, match="CONFIG_VALUE"):
        chain.chosen(makers.face(), controls={"chin": {"near": near}})
