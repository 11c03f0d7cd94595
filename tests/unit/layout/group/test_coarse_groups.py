"""Two levels: which elements are coarse, which are their members, and who is kept apart from whom."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from chain import by_name, lay_out, problem_of, settings
from laid_out import on_face

from usdrigui.character import Control
from usdrigui.errors import RigUIError
from usdrigui.layout.review.difference import difference
from usdrigui.layout.review.review import review
from usdrigui.model.levels import inner_names, outer_first, shown, shown_of_all, states

FACE = makers.face()


def with_pose(name="grin", shapes=("smile_L", "smile_R", "pucker")):
    """The face with one more control, a pose that raises some of the shapes."""
    index = {control.name: i for i, control in enumerate(FACE.controls)}
    channels = [int(FACE.controls[index[each]].drive.channels[0]) for each in shapes]
    drive = makers.drive(channels)
    made = Control(name, name, "pose", name, 0.0, 0.0, 1.0, "default", drive)
    return replace(FACE, controls=(*FACE.controls, made))


def mouth(**more):
    return settings(
        levels={"members": {"grin": ["smile_L", "smile_R", "pucker"]}}, candidates={"board_composite": False}, **more
    )


def reviewed(line, layout):
    inputs = line.inputs
    return review(inputs.measured, inputs.candidates, layout)


def test_a_coarse_control_has_the_named_members_on_both_sides():
    line = lay_out(with_pose(), mouth())
    assert by_name(line)["grin"].inner == ("pucker", "smile_L", "smile_R")
    assert inner_names(line.layout.elements) == {"pucker", "smile_L", "smile_R"}


def test_what_is_said_of_one_side_holds_for_the_other():
    line = lay_out(FACE, settings(levels={"members": {"smile_L": ["sneer_L"]}}))
    elements = by_name(line)
    assert elements["smile_L"].inner == ("sneer_L",)
    assert elements["smile_R"].inner == ("sneer_R",)


def test_poses_are_coarse_when_asked_for():
    line = lay_out(with_pose(), settings(levels={"poses": True}, candidates={"board_composite": False}))
    assert by_name(line)["grin"].inner == ("pucker", "smile_L", "smile_R")


def test_members_stand_where_they_would_alone_as_the_coarse_one_is_hidden_then():
    """The pose moves the mouth as its members do; seen together they have to make room for each other."""
    together = lay_out(with_pose(shapes=("pucker",)), settings(candidates={"board_composite": False}))
    levels = {"members": {"grin": ["pucker"]}}
    apart = lay_out(with_pose(shapes=("pucker",)), settings(levels=levels, candidates={"board_composite": False}))
    alone = lay_out(FACE)
    assert by_name(apart)["pucker"].anchor.point == by_name(alone)["pucker"].anchor.point
    assert by_name(apart)["grin"].anchor.point == by_name(alone)["pucker"].anchor.point
    assert by_name(together)["grin"].anchor.point != by_name(together)["pucker"].anchor.point
    assert apart.assignment.cost < together.assignment.cost


def test_members_of_two_coarse_controls_need_not_make_room_for_each_other():
    levels = {"members": {"smile_L": ["sneer_L"], "chin": ["pucker"]}}
    seen = states(lay_out(FACE, settings(levels=levels)).layout.elements)
    assert not seen["pucker"] & seen["sneer_L"]
    assert seen["pucker"] & seen["smile_L"]


def crowded_face():
    """The face with 60 more controls around the mouth that names call brows and noses in turn."""
    points, quads = makers.mask()
    turns = np.linspace(0.0, 2.0 * np.pi, 60)
    more = {
        f"{'nose' if i % 2 else 'brow'}Part{i}": makers.bump(
            points, (0.1 * np.sin(t), -0.45), (np.sin(t), np.cos(t), 0.4)
        )
        for i, t in enumerate(turns)
    }
    return makers.rig(points, quads, makers.face_shapes(points) | more)


@pytest.mark.parametrize("asked", [True, False])
def test_a_crowded_face_has_the_rest_of_a_region_behind_one_element(asked):
    levels = {"crowds": asked}
    said = settings(levels=levels, candidates={"board_composite": False}, objective={"max_neighbours": 8.0})
    groups = problem_of(crowded_face(), said).inputs.placement.groups
    coarse = {group.name: group.inner for group in groups if group.inner}
    assert bool(coarse) is asked
    for name, inner in coarse.items():
        assert len({each[:4] for each in (name, *inner)}) == 1


def test_a_pose_is_no_member_of_itself_in_a_group_with_what_it_sets():
    levels, kept = {"poses": True}, {"board_composite": False}
    groups = {"groups": {"both": ["grin", "pucker"]}}
    line = lay_out(with_pose(), settings(levels=levels, candidates=kept, groups=groups))
    assert by_name(line)["both"].inner == ("smile_L", "smile_R")


def test_members_of_one_coarse_control_are_kept_apart():
    line = lay_out(with_pose(), mouth())
    width = line.layout.frame.handle_width
    placed = on_face(line.layout)
    seen = states(placed)
    for a in placed:
        for b in placed:
            if a is not b and seen[a.name] & seen[b.name]:
                assert np.linalg.norm(a.anchor.position - b.anchor.position) >= width


def test_joysticks_are_opened_into_their_axes():
    groups = {"groups": {"mouth": ["pucker", "chin"]}}
    line = lay_out(FACE, settings(groups=groups, levels={"groups": True}))
    elements = by_name(line)
    assert elements["mouth"].inner == ("chin", "pucker")
    assert elements["mouth"].kind == "patch"
    assert {elements[name].kind for name in ("chin", "pucker")} == {"slider"}
    # Each axis has its own best place, which the two together do not.
    assert elements["pucker"].anchor.point == by_name(lay_out(FACE))["pucker"].anchor.point


def test_what_is_shown_when_something_is_opened():
    layout = lay_out(FACE, settings(levels={"members": {"smile_L": ["sneer_L"]}})).layout
    first = {element.name for element in shown(layout).elements}
    opened = {element.name for element in shown_of_all([layout], ["smile_L"])[0].elements}
    assert first - opened == {"smile_L", "smile_R"}
    assert opened - first == {"sneer_L", "sneer_R"}
    assert {e.name for e in shown_of_all([layout], (), everything=True)[0].elements} == opened
    with pytest.raises(RigUIError, match="CONFIG_VALUE"):
        shown_of_all([layout], ["sneer_L"])


# --- over the life of a rig --------------------------------------------------------------------------


def joystick(**more):
    return settings(groups={"groups": {"mouth": ["pucker", "chin"]}}, levels={"groups": True}, **more)


def anchors(layout):
    return {element.name: element.anchor.point for element in layout.elements}


def test_a_layout_with_levels_is_sound():
    line = lay_out(with_pose(), mouth())
    assert reviewed(line, line.layout).issues == ()


def test_two_handles_on_one_spot_are_a_fault_only_where_both_are_visible():
    line = lay_out(with_pose(), mouth())
    elements = by_name(line)

    def faults(first, second):
        moved = replace(elements[first], anchor=elements[second].anchor)
        spoiled = tuple(moved if each.name == first else each for each in line.layout.elements)
        found = reviewed(line, replace(line.layout, elements=spoiled)).issues
        return {each.code for each in found}

    assert "LAYOUT_HANDLES_COLLIDE" in faults("pucker", "smile_L")
    assert "LAYOUT_HANDLES_COLLIDE" not in faults("pucker", "grin")


def test_a_layout_with_levels_can_be_fixed_and_kept():
    first = lay_out(FACE, joystick()).layout
    assert anchors(lay_out(FACE, joystick(), fixed=first).layout) == anchors(first)
    kept = lay_out(FACE, joystick(), prior=chain.prior(first, FACE, 0.2)).layout
    assert anchors(kept) == anchors(first)
    assert not difference(first, kept).changes


def test_the_first_level_comes_first():
    layout = lay_out(FACE, joystick()).layout
    names = [element.name for element in outer_first(layout.elements)]
    assert set(names[-2:]) == {"chin", "pucker"}


# --- refusals ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("members", "code"),
    [
        ({"nobody": ["pucker"]}, "CONFIG_UNKNOWN_CONTROL"),
        ({"pucker": ["nobody"]}, "CONFIG_UNKNOWN_CONTROL"),
        ({"pucker": ["pucker"]}, "CONFIG_VALUE"),
        ({"pucker": ["chin"], "chin": ["smile_L"]}, "CONFIG_VALUE"),
        ({"pucker": []}, "CONFIG_VALUE"),
    ],
)
def test_levels_that_make_no_sense_are_refused(members, code):
    with pytest.raises(RigUIError, match=code):
        problem_of(FACE, settings(levels={"members": members}))


def test_derived_members_give_way_to_configured_ones():
    chosen = settings(levels={"poses": True, "members": {"grin": ["pucker"]}}, candidates={"board_composite": False})
    assert by_name(lay_out(with_pose(), chosen))["grin"].inner == ("pucker",)
