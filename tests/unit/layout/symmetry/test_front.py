"""Which way a character looks: where its controls move it, each with one vote."""

from types import SimpleNamespace

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES

from usdrigui.layout.symmetry.front import front, three_quarter

MIRROR = np.array([1.0, 1.0, -1.0])


def with_hair(shapes):
    """The mask, and hair behind it: twice as large, facing back; `shapes` are given for the mask's points."""
    hair = 2.0 * POINTS * MIRROR - [0.0, 0.0, 0.1]
    behind = [[at + len(POINTS) for at in quad[::-1]] for quad in QUADS]
    both = {name: np.vstack([each, each if name.startswith("whole") else 0.0 * each]) for name, each in shapes.items()}
    return makers.rig(np.vstack([POINTS, hair]), [*QUADS, *behind], both)


@pytest.mark.parametrize("wholes", [0, 1, 4])
def test_controls_of_the_whole_head_do_not_outvote_the_face(wholes):
    local = {name: SHAPES[name] for name in ("smile_L", "smile_R", "chin")}
    rig = with_hair({**local, **{f"whole{k}": np.full_like(POINTS, 0.1 + 0.1 * k) for k in range(wholes)}})
    face = chain.face_of(rig)
    assert face.views.ahead == pytest.approx([0.0, 0.0, 1.0], abs=1e-6)
    assert front(rig.up, face.trajectories, np.zeros(3))[2] > 0.9


@pytest.mark.parametrize("matrix", [np.eye(3), np.diag([-1.0, 1, -1]), np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])])
def test_the_face_looks_where_it_moves(matrix):
    rig = makers.moved(makers.face(), matrix)
    face = chain.face_of(rig)
    assert front(rig.up, face.trajectories, face.symmetry.plane.normal) @ (matrix @ [0, 0, 1]) == pytest.approx(1.0)
    assert front(rig.up, face.trajectories, np.zeros(3)) @ (matrix @ [0, 0, 1]) == pytest.approx(1.0, abs=1e-3)


def test_the_other_views_look_from_40_degrees_to_either_side():
    left, right = three_quarter(np.array([0.0, 0, 1]), np.array([0.0, 1, 0]))
    turn = np.radians(40.0)
    assert left == pytest.approx([np.sin(turn), 0.0, np.cos(turn)])
    assert right == pytest.approx([-np.sin(turn), 0.0, np.cos(turn)])


def test_with_a_plane_of_known_sides_the_face_looks_where_its_left_is_on_the_left():
    up, still = np.array([0.0, 1.0, 0.0]), SimpleNamespace(motions=())
    assert front(up, still, np.array([3.0, 0, 0])) == pytest.approx([0, 0, 1])
    assert front(up, still, np.array([-2.0, 0, 0])) == pytest.approx([0, 0, -1])
    assert front(up, still, up) == pytest.approx(front(up, still, np.zeros(3))), "a plane that lies says nothing"
    assert abs(front(up, still, up) @ up) < 1e-12
