"""What motions say about which control is which, worked out by hand."""

import numpy as np
import pytest

from usdrigui.layout.reuse import motion_evidence as evidence
from usdrigui.layout.reuse.motion_evidence import Agreement


def agreement(*pairs):
    """Of controls with themselves, each of (cosine, length)."""
    cosine, length = (np.diag([float(pair[i]) for pair in pairs]) for i in (0, 1))
    return Agreement(cosine, length, np.ones(cosine.shape, dtype=bool))


def test_what_two_makers_fields_say():
    """Parallel ones 1.8 + 12 x .4, and for what was sculpted anew 1.5 less; opposite ones no less than -4."""
    found = Agreement(np.array([[1.0, 1.0, -1.0]]), np.array([[0.0, 2.0, 0.0]]), np.ones((1, 3), dtype=bool))
    odds = found.evidence([])[0]
    assert odds[0] == pytest.approx(np.logaddexp(6.6, 5.1))
    assert odds[1] == pytest.approx(np.logaddexp(5.6, 4.1))
    assert odds[2] == -4.0
    assert Agreement(found.cosine, found.length, found.moving & [True, False, True]).evidence([])[0, 1] == 0.0


def test_copies_that_agree_say_more_and_lose_more_by_their_length():
    """Off by .1 instead of .4: (.4 / .1)^.7 times as steep; twice as even: a length costs twice as much."""
    found = agreement(*[(0.9, 0.25)] * 4)
    slope = 12.0 * 4.0**0.7
    close = 1.8 + 1.6 * np.log(4.0) - 1.0 * 0.25
    assert found.evidence([(i, i) for i in range(4)])[0, 0] == pytest.approx(np.logaddexp(close, 12 * 0.3 + 0.175))
    assert found.evidence([(i, i) for i in range(4)])[0, 1] == pytest.approx(
        max(np.logaddexp(close + 0.25 - 0.9 * slope, 12 * -0.6 + 0.3), -4.0)
    )


def at_one_point(other):
    return evidence._at_one_point(np.array([0.0, 2.0, 0.0]), np.array([other], dtype=float))[0]


def test_at_one_place_agreement_to_the_last_digit_says_most():
    assert at_one_point((0, 2, 0)) == pytest.approx(5.0 * 0.4 + 1.5 * np.log(0.3 / 0.01))
    assert at_one_point((0, 4, 0)) == pytest.approx(2.0 - 0.5 * np.log(2.0)), "half as far is not close"
    assert at_one_point((0, 2.5, 0)) == pytest.approx(2.0 - 0.5 * np.log(1.25) + 1.5 * np.log(0.3 / 0.21))
    assert at_one_point((0, -2, 0)) == -4.0
    assert at_one_point((2, 0, 0)) == pytest.approx(-3.0)
    assert at_one_point((0, 0, 0)) == 0.0
