"""Direct manipulation: what is pulled arrives, what is pinned stays, and nothing leaves its range."""

from __future__ import annotations

from dataclasses import replace

import laid_out
import makers
import numpy as np
import pytest
import skinned_stages
from scipy.optimize import lsq_linear

from usdrigui.deform import deform
from usdrigui.errors import RigUIError
from usdrigui.pose.direct import Feel, grab, ranked, solve, twins_of
from usdrigui.pose.reach import longest_paths
from usdrigui.settings import Settings
from usdrigui.usd.rig import read_rigs


@pytest.fixture(scope="module")
def rig():
    return makers.face()


def nearest(rig, x, y):
    """The point of the mask nearest to (x, y) in the plane."""
    points = rig.meshes[0].points
    return int(np.argmin(np.linalg.norm(points[:, :2] - [x, y], axis=1)))


def index(rig, name):
    return [control.name for control in rig.controls].index(name)


SMILE = (0.3, -0.45)
FIRM = Feel(stay=1e-4)


def test_a_pull_along_a_control_sets_it(rig):
    point = nearest(rig, *SMILE)
    wanted = np.zeros(len(rig.controls))
    wanted[index(rig, "smile_L")] = 0.6
    answer = solve(grab(rig, np.zeros(len(wanted)), [point], feel=FIRM), deform(rig, wanted)[[point]])
    assert answer.values[index(rig, "smile_L")] == pytest.approx(0.6, abs=0.01)
    assert answer.changed[0] == index(rig, "smile_L")
    assert answer.reached[0] == pytest.approx(deform(rig, answer.values)[point], abs=1e-7)


def test_the_answer_minimises_the_formula_of_the_docstring(rig):
    points = [nearest(rig, 0.1, -0.5), nearest(rig, 0.25, -0.6)]
    feel = Feel(stay=0.05, elsewhere=2.0, locality=0.05, depth=0.3, pin=0.5)
    peaks = longest_paths(rig)
    start = np.full(len(rig.controls), 0.2)
    grip = grab(rig, start, points[:1], points[1:], peaks=peaks, feel=feel)
    goal = grip.positions[:1] + np.array([[0.05, 0.08, 0.1]])
    toward = np.array([0.0, 0.6, 0.8])
    answer = solve(grip, goal, toward)
    ahead = np.eye(3) - 0.7 * np.outer(toward, toward)
    length = max(np.linalg.norm(column(rig, start, j)[points[0]]) for j in range(len(rig.controls)))
    taking_part = [
        j for j in range(len(rig.controls)) if np.linalg.norm(column(rig, start, j)[points[0]]) >= 0.05 * length
    ]
    rows, cost = [], []
    for j in taking_part:
        moves = column(rig, start, j)
        share = np.linalg.norm(moves[points[0]]) / peaks[j]
        cost.append(0.05 * (1 + 2.0 * (1 - share) ** 2))
        rows.append(np.concatenate([ahead @ moves[points[0]], np.sqrt(0.5) * ahead @ moves[points[1]]]) / length)
    wanted = np.concatenate([ahead @ (goal - grip.positions[:1])[0], np.zeros(3)]) / length
    whole = np.vstack([np.array(rows).T, np.diag(np.sqrt(cost))])
    known = lsq_linear(whole, np.r_[wanted, np.zeros(len(cost))], (-0.2, 0.8), method="bvls", tol=1e-14)
    expected = start.copy()
    expected[taking_part] += known.x
    assert len(taking_part) > 3
    assert answer.values == pytest.approx(expected, abs=1e-5)


def column(rig, start, j):
    """(n, 3) displacement of every point when control j crosses its range from `start`."""
    low, high = np.array(start), np.array(start)
    low[j], high[j] = rig.controls[j].minimum, rig.controls[j].maximum
    return deform(rig, high) - deform(rig, low)


def test_no_value_leaves_its_range_however_far_the_pull(rig):
    point = nearest(rig, *SMILE)
    for direction in np.eye(3):
        for sign in (-5.0, 5.0):
            grip = grab(rig, np.zeros(len(rig.controls)), [point], feel=FIRM)
            values = solve(grip, grip.positions + sign * direction).values
            assert (values >= 0.0).all()
            assert (values <= 1.0).all()


def test_a_value_already_outside_its_range_may_stay_but_not_go_further(rig):
    point, smile = nearest(rig, *SMILE), index(rig, "smile_L")
    start = np.zeros(len(rig.controls))
    start[smile] = 1.5
    grip = grab(rig, start, [point], feel=FIRM)
    along = column(rig, start, smile)[point]
    assert solve(grip, grip.positions + along).values[smile] == pytest.approx(1.5)
    assert solve(grip, grip.positions - along).values[smile] == pytest.approx(0.5, abs=0.02)


def test_locked_controls_and_those_without_effect_do_not_change(rig):
    point, smile = nearest(rig, *SMILE), index(rig, "smile_L")
    start = np.full(len(rig.controls), 0.3)
    grip = grab(rig, start, [point], locked={smile}, feel=FIRM)
    values = solve(grip, grip.positions + np.array([[0.1, 0.1, 0.0]])).values
    assert values[smile] == 0.3
    assert values[index(rig, "brow_R")] == 0.3
    assert (values != start).any()


def test_a_point_that_nothing_moves_stays(rig):
    point = nearest(rig, -0.8, 1.0)
    grip = grab(rig, np.zeros(len(rig.controls)), [point])
    answer = solve(grip, grip.positions + 1.0)
    assert grip.length == 0.0
    assert len(ranked(grip)) == 0
    assert (answer.values == 0.0).all()
    assert answer.reached == pytest.approx(grip.positions)


def test_dragging_back_undoes(rig):
    point = nearest(rig, *SMILE)
    start = np.random.default_rng(3).random(len(rig.controls))
    grip = grab(rig, start, [point])
    solve(grip, grip.positions + np.array([[0.2, 0.1, 0.0]]))
    assert solve(grip, grip.positions).values == pytest.approx(start, abs=1e-12)


def test_pins_hold(rig):
    pulled, pin = nearest(rig, 0.0, -0.45), nearest(rig, 0.0, -0.62)
    start = np.zeros(len(rig.controls))
    goal = rig.meshes[0].points[[pulled]] + np.array([[0.0, 0.0, 0.1]])
    free = solve(grab(rig, start, [pulled], feel=FIRM), goal)
    held = solve(grab(rig, start, [pulled], [pin], feel=Feel(stay=1e-4, pin=10.0)), goal)
    before = rig.meshes[0].points[pin]
    loose = np.linalg.norm(deform(rig, free.values)[pin] - before)
    assert np.linalg.norm(deform(rig, held.values)[pin] - before) < 0.5 * loose
    assert held.reached[1] == pytest.approx(deform(rig, held.values)[pin])


def test_only_controls_that_matter_at_the_pulled_point_take_part(rig):
    point = nearest(rig, *SMILE)
    strict = grab(rig, np.zeros(len(rig.controls)), [point], feel=Feel(locality=0.5))
    loose = grab(rig, np.zeros(len(rig.controls)), [point], feel=Feel(locality=0.0))
    assert set(strict.controls) < set(loose.controls)
    assert index(rig, "smile_L") in strict.controls
    assert ranked(loose)[0] == index(rig, "smile_L")
    assert (np.diff(loose.reach[ranked(loose)]) <= 0).all()


def test_controls_whose_effect_is_elsewhere_are_dearer(rig):
    point = nearest(rig, 0.08, -0.68)
    start = np.zeros(len(rig.controls))
    peaks = longest_paths(rig)
    both = [grab(rig, start, [point], peaks=each, feel=Feel(locality=0.0)) for each in (None, peaks)]
    assert both[0].cost == pytest.approx(np.full(len(both[0].cost), 0.01))
    share = both[1].reach[both[1].controls] / peaks[both[1].controls]
    assert (np.argsort(both[1].cost) == np.argsort(-share)).all()


def test_the_direction_to_the_viewer_counts_less(rig):
    point = nearest(rig, 0.0, -0.45)
    grip = grab(rig, np.zeros(len(rig.controls)), [point], feel=Feel(depth=0.0))
    goal = grip.positions + np.array([[0.0, 0.0, 0.1]])
    assert np.abs(solve(grip, goal).values).max() > 0.5
    assert np.abs(solve(grip, goal, np.array([0.0, 0.0, 1.0])).values).max() < 1e-9


def test_symmetric_mode_moves_twins_alike(rig):
    names = [control.name for control in rig.controls]
    twins = np.arange(len(names))
    for name in names:
        if name.endswith("_L"):
            left, right = index(rig, name), index(rig, name[:-1] + "R")
            twins[[left, right]] = right, left
    start = np.zeros(len(names))
    start[index(rig, "smile_R")] = 0.7
    point = nearest(rig, *SMILE)
    grip = grab(rig, start, [point], twins=twins, feel=FIRM)
    values = solve(grip, grip.positions + np.array([[0.5, 0.5, -0.1]])).values
    # Both move by the same amount, until the first of them meets its bound.
    assert values[index(rig, "smile_R")] == pytest.approx(1.0)
    assert values[index(rig, "smile_L")] == pytest.approx(0.3)
    locked = grab(rig, start, [point], twins=twins, locked={index(rig, "smile_R")}, feel=FIRM)
    assert solve(locked, locked.positions + 0.5).values[index(rig, "smile_L")] == 0.0


def test_twins_are_read_from_the_layout(rig):
    layout = laid_out.layout_of(rig, only=["smile_L", "smile_R", "chin"])
    elements = {each.name: each for each in layout.elements}
    mirrored = [
        replace(each, mirror={"smile_L": "smile_R", "smile_R": "smile_L"}.get(each.name, ""))
        for each in elements.values()
    ]
    twins = twins_of(rig, replace(layout, elements=tuple(mirrored)))
    assert twins[index(rig, "smile_L")] == index(rig, "smile_R")
    assert twins[index(rig, "smile_R")] == index(rig, "smile_L")
    assert twins[index(rig, "chin")] == index(rig, "chin")


@pytest.mark.parametrize("scale", [1e-3, 1e3])
def test_scene_units_do_not_matter(rig, scale):
    large = makers.moved(rig, scale * np.eye(3))
    point = nearest(rig, *SMILE)
    answers = []
    for each, unit in ((rig, 1.0), (large, scale)):
        grip = grab(each, np.zeros(len(rig.controls)), [point])
        answers.append(solve(grip, grip.positions + unit * np.array([[0.05, 0.08, 0.0]])).values)
    assert answers[0] == pytest.approx(answers[1], abs=1e-4)


def test_inbetweens_are_followed_round_their_corner():
    points, quads = makers.mask()
    first = makers.bump(points, (0.0, 0.0), (1.0, 0.0, 0.0))
    second = first + makers.bump(points, (0.0, 0.0), (0.0, 1.0, 0.0))
    rig = makers.rig(points, quads, {"bent": {0.5: first, 1.0: second}})
    point = int(np.argmin(np.linalg.norm(points[:, :2], axis=1)))
    for value in (0.3, 0.8):
        goal = deform(rig, [value])[[point]]
        assert solve(grab(rig, [0.0], [point], feel=FIRM), goal).values == pytest.approx([value], abs=0.02)


def test_inbetweens_are_followed_from_a_pose_in_which_they_are_set():
    points, quads = makers.mask()
    first = makers.bump(points, (0.0, 0.0), (1.0, 0.0, 0.0))
    second = first + makers.bump(points, (0.0, 0.0), (0.0, 1.0, 0.0))
    rig = makers.rig(points, quads, {"bent": {0.5: first, 1.0: second}, "other": first})
    point = int(np.argmin(np.linalg.norm(points[:, :2], axis=1)))
    for start, value in ((0.8, 0.3), (0.3, 0.8)):
        goal = deform(rig, [value, 0.0])[[point]]
        grip = grab(rig, [start, 0.0], [point], locked={1}, feel=FIRM)
        assert solve(grip, goal).values == pytest.approx([value, 0.0], abs=0.02)
        assert solve(grip, goal).reached == pytest.approx(deform(rig, solve(grip, goal).values)[[point]], abs=1e-7)


def test_joints_and_shapes_arrive_together(tmp_path):
    source = skinned_stages.character(tmp_path / "char.usda", animated_joints=("Hips/Head", "Hips/Head/Jaw"))
    (rig,) = read_rigs(source, Settings())
    rng = np.random.default_rng(4)
    base = laid_out.defaults(rig)
    wanted = base + 0.7 * (laid_out.random_values(rig, rng) - base)
    there = deform(rig, wanted)
    away = np.linalg.norm(there - deform(rig, base), axis=1)
    point = int(np.argsort(away)[-40])
    grip = grab(rig, base, [point], feel=FIRM)
    assert not grip.additive
    answer = solve(grip, there[[point]])
    assert np.linalg.norm(deform(rig, answer.values)[point] - there[point]) < 0.05 * away[point]
    assert answer.reached[0] == pytest.approx(deform(rig, answer.values)[point], abs=1e-6)


def test_longest_paths_are_those_of_the_peak_points(rig):
    peaks = longest_paths(rig)
    for j in range(len(rig.controls)):
        expected = np.linalg.norm(column(rig, np.zeros(len(peaks)), j), axis=1).max()
        assert peaks[j] == pytest.approx(expected, rel=1e-5)


def test_refuses_what_cannot_be_grabbed_or_reached(rig):
    rest = np.zeros(len(rig.controls))
    with pytest.raises(RigUIError, match="POSE_POINT"):
        grab(rig, rest, [10**6])
    with pytest.raises(RigUIError, match="POSE_POINT"):
        grab(rig, rest, [])
    with pytest.raises(RigUIError, match="POSE_POINT"):
        grab(rig, rest, [3], [-1])
    with pytest.raises(RigUIError, match="POSE_VALUE"):
        grab(rig, rest[:-1], [3])
    with pytest.raises(RigUIError, match="POSE_VALUE"):
        grab(rig, np.full(len(rest), np.nan), [3])
    grip = grab(rig, rest, [3])
    with pytest.raises(RigUIError, match="POSE_VALUE"):
        solve(grip, np.zeros((2, 3)))
    with pytest.raises(RigUIError, match="POSE_VALUE"):
        solve(grip, np.full((1, 3), np.nan))
