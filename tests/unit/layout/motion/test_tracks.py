"""Tracks: resampled, and enlarged where they are too short."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS

from usdrigui.layout.motion.tracks import magnification, resampled


def test_tracks_are_sampled_at_equal_steps_of_arc_length():
    line = np.array([[[0.0, 0, 0], [1, 0, 0], [1, 3, 0]]])
    assert np.allclose(resampled(line, 5)[0], [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 2, 0], [1, 3, 0]])
    assert np.allclose(resampled(np.zeros((1, 3, 3)), 4), 0.0)


@pytest.mark.parametrize(("size", "enlarged"), [(0.3, "to one and a half handle widths"), (0.01, "three times")])
def test_short_tracks_are_enlarged_and_the_magnification_recorded(size, enlarged):
    line = chain.lay_out(makers.face_with(tiny=size * makers.bump(POINTS, (0.5, 0.0), (0, 1, 0), 0.2)))
    tiny = chain.by_name(line)["tiny"].members[0]
    drawn = np.linalg.norm(tiny.track[-1] - tiny.track[0])
    least = 1.5 * line.layout.frame.handle_width
    assert drawn == pytest.approx(3.0 * tiny.arc_length if enlarged == "three times" else least, rel=1e-6)
    assert tiny.magnification * tiny.arc_length == pytest.approx(drawn, rel=1e-6)


def test_lengths_of_zero_are_not_enlarged():
    assert magnification(np.array([0.5, 2.0, 0.0, 0.1]), 1.0).tolist() == [2.0, 1.0, 1.0, 3.0]
