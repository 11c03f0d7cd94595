"""A control stands where its motion is large and its own, not where it does most of what another one does."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, SHAPES

NOSTRIL = (0.12, 0.05)


def height_of(name, line):
    (element,) = (each for each in line.layout.elements if name in each.controls)
    return element.anchor.position[1]


def wing(lift):
    """A motion of the nostril that also lifts the brow by `lift` of its own control's motion."""
    own = makers.bump(POINTS, NOSTRIL, (0.3, 1, 0), 0.2, 0.08)
    return makers.face_with(one=own + lift * SHAPES["brow_L"])


@pytest.mark.parametrize(("weight", "low"), [(0.0, 0.4), (0.3, -0.2)])
def test_a_control_that_lifts_the_brow_more_than_the_nose_stands_by_the_nose(weight, low):
    settings = chain.settings(objective={"distinctive_weight": weight}, candidates={"board_composite": False})
    stands = height_of("one", chain.solved(chain.problem_of(wing(0.95), settings), settings.solve))
    assert low <= stands <= low + 0.4


def test_a_motion_of_which_nothing_or_everything_is_common_costs_nothing_more():
    settings = chain.settings(candidates={"board_composite": False})
    face = chain.face_of(makers.face_with(one=0.5 * SHAPES["brow_L"]), settings)
    index = face.rig.control_indices
    for name in ("one", "brow_L", "chin"):
        assert face.trajectories.motion_of(index[name]).common.max() < 0.05, name
    lifted = chain.face_of(wing(1.0), settings)
    motion = lifted.trajectories.motion_of(index["one"])
    shares, points = motion.common, motion.points
    assert shares[np.argmin(np.linalg.norm(lifted.trajectories.surface.points[points, :2] - [0.35, 0.6], axis=1))] > 0.5


def test_no_control_explains_another_by_going_far_beyond_its_own_range():
    settings = chain.settings(candidates={"board_composite": False})
    face = chain.face_of(makers.face_with(tiny=0.1 * SHAPES["smile_L"]), settings)
    index = face.rig.control_indices["smile_L"]
    assert face.trajectories.motion_of(index).common.max() < 0.25
