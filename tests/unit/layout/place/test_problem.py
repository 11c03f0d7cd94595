"""What it costs that an element leaves the face."""

from types import SimpleNamespace

import numpy as np
import pytest

from usdrigui.layout.place.problem import off_face_cost
from usdrigui.settings import ControlSettings, ObjectiveSettings


@pytest.mark.parametrize(
    ("needed", "stood", "copies", "joints", "cost"),
    [
        ((), False, 1, False, 6.0),
        ((), False, 2, False, 12.0),
        ((0,), False, 2, False, 22.0),
        ((0, 1), True, 1, False, 0.0),
        ((), True, 2, False, 0.0),
        ((), False, 1, True, 16.0),
    ],
)
def test_each_control_of_each_copy_that_leaves_the_face_costs_and_more_if_it_is_needed_there(
    needed, stood, copies, joints, cost
):
    """Two controls at 3 each, and 5 for one that is needed, as the joints of a body are; none leaves where the board
    had them before."""
    action = [SimpleNamespace(action=SimpleNamespace(vague=i not in needed)) for i in (0, 1)]
    requests = SimpleNamespace(
        overrides=[ControlSettings(), ControlSettings()],
        prior=SimpleNamespace(stood_on_board=lambda _: stood),
    )
    motion = SimpleNamespace(of_joint=joints)
    trajectories = SimpleNamespace(motion_of=lambda _: motion)
    face = SimpleNamespace(meanings=action, behind=joints, trajectories=trajectories)
    group = SimpleNamespace(controls=(0, 1), copies=((0, 1),) * copies)
    settings = ObjectiveSettings(off_face_penalty=3.0)
    assert off_face_cost(face, group, requests, settings) == pytest.approx(cost)
    for asked in (ControlSettings(place="face"), ControlSettings(place="proxy"), ControlSettings(anchor="/M#1")):
        requests.overrides[1] = asked
        assert off_face_cost(face, group, requests, settings) == np.inf
    requests.overrides[1] = ControlSettings()
    assert off_face_cost(face, group, requests, ObjectiveSettings(off_face_allowed=False)) == np.inf
