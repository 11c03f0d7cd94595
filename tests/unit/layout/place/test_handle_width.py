"""How wide handles are: by the face, by the crowd, and never by the mesh."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS

from usdrigui.layout.place.handle_width import around

STEP = 0.04 / 32
"""Between the widths that are tried, in face sizes."""
ROTATION = makers.rotation(8)


def crowd(count, points=POINTS, quads=QUADS):
    """The face with `count` more controls around the mouth, of about the same places and all directions."""
    turns = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    more = {
        f"c{i}": makers.bump(points, (0.1 * np.sin(5 * t), -0.45 + 0.1 * np.cos(3 * t)), (np.sin(t), np.cos(t), 0.4))
        for i, t in enumerate(turns)
    }
    return makers.rig(points, quads, makers.face_shapes(points) | more)


def width(rig, **objective):
    """In face sizes; nothing goes on the board for what it repeats."""
    said = chain.settings(objective=objective, candidates={"board_composite": False}, levels={"crowds": False})
    face = chain.face_of(rig, said)
    return face.handle_width / face.surface.face_size


def test_a_face_with_room_has_handles_of_the_size_asked_for():
    assert width(makers.face()) == 0.02
    assert width(makers.face(), handle_size=0.03) == 0.03


def test_the_more_controls_want_the_same_places_the_smaller_their_handles():
    widths = [width(crowd(count), handle_size=0.04, handle_size_min=0.001) for count in (0, 20, 40, 80)]
    assert widths[0] == 0.04
    assert np.all(np.diff(widths) < -0.002)


def test_controls_far_apart_do_not_crowd_each_other():
    spots = [(x, y) for x in (-0.6, -0.3, 0.0, 0.3, 0.6) for y in np.linspace(-0.8, 0.8, 9)]
    spread = {f"s{i}": makers.bump(POINTS, spot, (0, 0, 1), 0.12) for i, spot in enumerate(spots)}
    assert width(makers.rig(POINTS, QUADS, spread)) == 0.02


def test_handles_never_shrink_below_the_least_nor_grow_above_the_largest():
    assert width(crowd(120), handle_size=0.04, handle_size_min=0.035) == pytest.approx(0.035)
    assert width(crowd(120), handle_size=0.03, handle_size_min=0.2) == 0.03
    assert width(crowd(120), handle_size=0.04, max_neighbours=0.0) == 0.04


def test_a_crowd_of_what_stands_beside_the_face_does_not_count():
    rig = crowd(80)
    beside = {f"c{i}": {"place": "board"} for i in range(80)}
    said = chain.settings(controls=beside, objective={"handle_size": 0.04, "handle_size_min": 0.001})
    face = chain.face_of(rig, said)
    assert face.handle_width == 0.04 * face.surface.face_size


def test_the_width_does_not_know_how_finely_the_mesh_is_divided():
    coarse = width(crowd(80), handle_size=0.04, handle_size_min=0.001)
    fine = width(crowd(80, *makers.mask(65, 81)), handle_size=0.04, handle_size_min=0.001)
    # Points crowded along the middle have no more say than the others.
    points, quads = makers.mask(65, 81)
    across = (np.linspace(-0.8, 0.8, 65) ** 3 / 0.64)[None, :].repeat(81, axis=0).ravel()
    depth = 0.7 * np.sqrt(np.maximum(0.0, 1.0 - (across / 0.95) ** 2 - (points[:, 1] / 1.25) ** 2))
    uneven = width(
        crowd(80, np.stack([across, points[:, 1], depth], axis=1), quads), handle_size=0.04, handle_size_min=0.001
    )
    assert coarse < 0.035
    assert fine == pytest.approx(coarse, abs=1.01 * STEP)
    assert uneven == pytest.approx(coarse, abs=1.01 * STEP)


@pytest.mark.parametrize("matrix", [100.0 * np.eye(3), 0.01 * ROTATION])
def test_the_width_turns_and_grows_with_the_character(matrix):
    rig, said = crowd(80), chain.settings(objective={"handle_size": 0.04, "handle_size_min": 0.001})
    plain, moved = chain.face_of(rig, said), chain.face_of(makers.moved(rig, matrix, (3.0, 1.0, 2.0)), said)
    assert plain.handle_width < 0.035 * plain.trajectories.surface.face_size
    step = STEP * plain.trajectories.surface.face_size
    assert moved.handle_width / np.linalg.norm(matrix[0]) == pytest.approx(plain.handle_width, abs=1.01 * step)


def test_what_is_around_is_counted_by_hand():
    line = np.array([[0.0, 0, 0], [1, 0, 0], [5, 0, 0]])
    # Two controls in the first place and one in each other: 2.5 within a unit of each of the four on average.
    assert np.allclose(around(line, np.array([2.0, 1.0, 1.0]), np.array([0.5, 2.5, 12.0])), [6 / 4, 10 / 4, 4.0])


def test_the_papers_preset_keeps_the_size():
    from usdrigui.settings import load

    assert chain.face_of(crowd(80), load(preset="paper")).handle_width == pytest.approx(
        0.02 * chain.face_of(crowd(80)).trajectories.surface.face_size
    )
