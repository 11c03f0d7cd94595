"""What motions say about which control is which, worked out by hand."""

import numpy as np
import pytest

from usdrigui.layout.reuse import motion_evidence as evidence
from usdrigui.layout.reuse.motion_evidence import Agreement


def test_what_fields_say():
    """12 for each unit of the cosine over .45, half of the logarithm of lengths less; opposite ones no less than -4."""
    cosine, length = np.array([[1.0, 1.0, -1.0, 0.99]]), np.array([[0.0, 2.0, 0.0, 0.0]])
    found = Agreement(cosine, length, np.ones((1, 4), dtype=bool))
    odds = found.evidence(12.0, 0.45)[0]
    assert odds[0] == pytest.approx(6.6 + 1.5 * np.log(0.3 / 0.01)), "copies"
    assert odds[1] == pytest.approx(5.6), "a seventh as far is not close"
    assert odds[2] == -4.0
    assert odds[3] == pytest.approx(6.48 + 1.5 * np.log(0.3 / (np.sqrt(0.02) + 0.01)))
    assert Agreement(cosine, length, found.moving & False).evidence(12.0, 0.45)[0].tolist() == [0.0] * 4


def at_one_point(other):
    found = evidence._agreement(np.array([[0.0, 2.0, 0.0]]), np.array([other], dtype=float))
    return found.evidence(5.0, 0.6)[0, 0]


def test_at_one_place_agreement_to_the_last_digit_says_most():
    assert at_one_point((0, 2, 0)) == pytest.approx(5.0 * 0.4 + 1.5 * np.log(0.3 / 0.01))
    assert at_one_point((0, 4, 0)) == pytest.approx(2.0 - 0.5 * np.log(2.0)), "half as far is not close"
    assert at_one_point((0, 2.5, 0)) == pytest.approx(2.0 - 0.5 * np.log(1.25) + 1.5 * np.log(0.3 / 0.21))
    assert at_one_point((0, -2, 0)) == -4.0
    assert at_one_point((2, 0, 0)) == pytest.approx(-3.0)
    assert at_one_point((0, 0, 0)) == 0.0
