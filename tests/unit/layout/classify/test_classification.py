"""Which controls do not stand on the face."""

from dataclasses import replace

import chain
import limbs
import makers
import numpy as np
import pytest
from makers import POINTS, SHAPES

HALF = np.where(POINTS[:, 1:2] < 0.35, [[0.0, 0.0, 0.1]], 0.0)
"""What a control of the lower half moves."""


@pytest.mark.parametrize(
    "whole",
    [np.full_like(POINTS, 0.2), 0.3 * POINTS, POINTS * [0.3, 0.0, 0.1]],
    ids=["translation", "scale", "identity"],
)
def test_whole_head_controls_are_global(whole):
    rig = makers.face_with(whole=whole)
    found = chain.chosen(rig)
    assert found("whole").category == "global"
    assert "whole" in found("whole").off_face_reason
    assert not any(found(name).category == "global" for name in SHAPES)
    assert chain.chosen(rig, candidates={"board_global": False})("whole").category != "global"
    assert chain.chosen(rig, controls={"whole": {"place": "face"}})("whole").category != "global"


def test_controls_of_hidden_things_are_hidden():
    found = chain.chosen(makers.face_with_teeth(name="inside"))
    assert found("inside").category == "hidden"
    assert found("chin").category != "hidden"
    kept = chain.chosen(makers.face_with_teeth(name="inside"), candidates={"board_hidden": False})("inside")
    assert kept.category != "hidden"
    assert (kept.points >= len(POINTS)).any()


def test_all_of_a_family_stands_under_its_heading_whatever_else_speaks_against_a_member():
    found = chain.chosen(makers.face_with_teeth())("teeth")
    assert (found.category, found.off_face_reason) == ("interior", "moves the inside of the mouth")


@pytest.mark.parametrize(
    ("name", "skin_moves", "stands"),
    [("inside", 0.7, True), ("inside", 0.5, False), ("nose", 0.5, False), ("jawOpen", 0.1, True)],
)
def test_a_control_that_keeps_too_little_in_sight_stands_there_only_by_a_distinctive_name(name, skin_moves, stands):
    found = chain.chosen(makers.face_with_teeth(skin_moves, name=name))(name)
    assert (found.category == "") == stands
    assert (
        stands
        or found.off_face_reason == f"no visible place keeps more than {skin_moves / 3**0.5:.0%} of its displacement"
    )
    assert (
        chain.chosen(makers.face_with_teeth(skin_moves, name=name), candidates={"least_kept": 0.0})(name).category == ""
    )


def test_coverage_is_the_share_of_the_face_for_small_controls_too():
    found = chain.chosen(makers.face_with(whole=np.full_like(POINTS, 0.2)))
    assert found("whole").coverage == pytest.approx(1.0)
    assert 0.0 < found("sneer_L").coverage < found("brow_L").coverage < 0.5
    assert found("sneer_L").coverage == pytest.approx(found("sneer_R").coverage, rel=0.05)


@pytest.mark.parametrize(("name", "category"), [("half", "global"), ("head", "global"), ("jawOpen", "")])
def test_a_jaw_may_move_all_that_smaller_controls_move(name, category):
    """So it does where the mouth alone is animated."""
    assert chain.chosen(makers.face_with(**{name: HALF}))(name).category == category


def test_a_joint_that_holds_most_of_a_robot_is_not_a_control_of_it_as_a_whole():
    names, places = ["h", *(f"h/k{i}" for i in range(5))], np.array([(4 * i, 0, 0) for i in range(6)], float)
    robot = limbs.with_default_controls(limbs.skeleton_rig(names, places, list(range(6)), size=[2, 1, 1, 1, 1, 1]))
    assert not any(each.category for each in chain.measured(robot).classification)


def test_excluding_a_control_calls_no_other_one_global():
    """A control that moves the lower half is large beside small ones, unless the other half has its own."""
    upper = {f"up{i}": makers.bump(POINTS, (x, 0.75), (0, 0, 1), 0.45) for i, x in enumerate((-0.4, 0.0, 0.4))}
    whole = makers.face_with(half=HALF, **upper)
    without = [control for control in whole.controls if not control.name.startswith("up")]
    left_out = tuple(control for control in whole.controls if control.name.startswith("up"))
    gone = replace(whole, controls=tuple(without))
    assert chain.chosen(whole)("half").category != "global"
    assert chain.chosen(gone)("half").category == "global"
    excluded = makers.changed(gone, excluded=left_out)
    assert chain.chosen(excluded)("half").category != "global"
    assert chain.chosen(excluded)("half").coverage == pytest.approx(chain.chosen(whole)("half").coverage)
    names = excluded.control_names
    face = chain.face_of(excluded)
    assert len(face.trajectories.excluded) == 3
    assert {names[motion.control] for motion in face.trajectories.motions} == set(names)


def test_a_renamed_control_is_known_by_both_names():
    for said in ({"chin": {"place": "board"}}, {"old": {"rename": "chin", "place": "board"}}):
        assert chain.chosen(makers.face(), controls=said)("chin").category == "requested"
