"""What motions say about which control is which, worked out by hand."""

import numpy as np
import pytest

from usdrigui.layout.reuse import motion_evidence as evidence
from usdrigui.layout.reuse.motion_evidence import Agreement


def test_what_fields_say():
    """12 for each unit of the cosine over .45, more for what is closer than its own length; at least -2.5."""
    cosine, ratio = np.array([[1.0, 1.0, -1.0, 0.99]]), np.array([[1.0, 0.125, 1.0, 1.0]])
    found = Agreement(cosine, ratio, np.ones((1, 4), dtype=bool))
    odds = found.of_fields[0]
    assert odds[0] == pytest.approx(6.6 - np.log(1e-3)), "copies"
    assert odds[1] == pytest.approx(6.6 - np.log(0.876)), "an eighth as far is hardly close"
    assert odds[2] == -2.5
    assert odds[3] == pytest.approx(6.48 - np.log(np.sqrt(0.02) + 1e-3))
    assert Agreement(cosine, ratio, found.moving & False).of_fields.tolist() == [[0.0] * 4]


def at_one_point(other):
    found = evidence._agreement(np.array([[0.0, 2.0, 0.0]]), np.array([other], dtype=float))
    return found.at_a_point[0, 0]


def test_at_one_place_only_agreement_says_anything():
    assert at_one_point((0, 2, 0)) == pytest.approx(-np.log(1e-3))
    assert at_one_point((0, 4, 0)) == pytest.approx(-np.log(0.501)), "half as far is hardly close"
    assert at_one_point((0, -2, 0)) == pytest.approx(-np.log(2.001))
    assert at_one_point((2, 0, 0)) == pytest.approx(-np.log(np.sqrt(2.0) + 1e-3))
    assert at_one_point((0, 0, 0)) == 0.0
