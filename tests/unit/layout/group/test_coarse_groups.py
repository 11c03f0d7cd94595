"""Two levels: which elements are coarse, which are their members, and who is kept apart from whom."""

from dataclasses import replace
from itertools import combinations

import chain
import makers
import numpy as np
import pytest
from chain import by_name, lay_out, problem_of, settings
from laid_out import on_face
from makers import POINTS, QUADS

from usdrigui.character import Control, LeftOff
from usdrigui.errors import RigUIError
from usdrigui.layout.place.regions import joints_behind_shapes
from usdrigui.layout.review.difference import difference
from usdrigui.layout.review.review import review
from usdrigui.model.levels import inner_names, outer_first, shown, shown_of_all, states

FACE = makers.face()
JOYSTICK = settings(groups={"groups": {"mouth": ["pucker", "chin"]}}, levels={"groups": True})
ON_FACE = {"board_composite": False}
WINK = (LeftOff("wink", "read", "moves nothing"),)


def with_pose(name="grin", shapes=("smile_L", "smile_R", "pucker")):
    """The face with one more control, a pose that raises some of the shapes."""
    index = FACE.control_indices
    channels = [int(FACE.controls[index[each]].drive.channels[0]) for each in shapes]
    drive = makers.drive(channels)
    made = Control(name, name, "pose", name, 0.0, 0.0, 1.0, "default", drive)
    return replace(FACE, controls=(*FACE.controls, made))


@pytest.fixture(scope="module")
def grinning():
    levels = {"members": {"grin": ["smile_L", "smile_R", "pucker"]}}
    return lay_out(with_pose(), settings(levels=levels, candidates=ON_FACE))


def reviewed(line, layout):
    inputs = line.inputs
    return review(inputs.measured, inputs.candidates, layout)


def test_a_coarse_control_has_the_named_members_on_both_sides(grinning):
    assert by_name(grinning)["grin"].inner == ("pucker", "smile_L", "smile_R")
    assert inner_names(grinning.layout.elements) == {"pucker", "smile_L", "smile_R"}


def test_what_is_said_of_one_side_holds_for_the_other():
    line = lay_out(FACE, settings(levels={"members": {"smile_L": ["sneer_L"]}}))
    elements = by_name(line)
    assert elements["smile_L"].inner == ("sneer_L",)
    assert elements["smile_R"].inner == ("sneer_R",)


def test_poses_are_coarse_when_asked_for():
    line = lay_out(with_pose(), settings(levels={"poses": True}, candidates=ON_FACE))
    assert by_name(line)["grin"].inner == ("pucker", "smile_L", "smile_R")


def test_members_stand_where_they_would_alone_as_the_coarse_one_is_hidden_then():
    """The pose moves the mouth as its members do; seen together they have to make room for each other."""
    together = lay_out(with_pose(shapes=("pucker",)), settings(candidates=ON_FACE))
    levels = {"members": {"grin": ["pucker"]}}
    apart = lay_out(with_pose(shapes=("pucker",)), settings(levels=levels, candidates=ON_FACE))
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
    turns = np.linspace(0.0, 2.0 * np.pi, 60)
    more = {
        f"{'nose' if i % 2 else 'brow'}Part{i}": makers.bump(
            POINTS, (0.1 * np.sin(t), -0.45), (np.sin(t), np.cos(t), 0.4)
        )
        for i, t in enumerate(turns)
    }
    return makers.face_with(**more)


@pytest.mark.parametrize("asked", [True, False])
def test_a_crowded_face_has_the_rest_of_a_region_behind_one_element(asked):
    levels = {"crowds": asked}
    said = settings(levels=levels, candidates=ON_FACE, objective={"max_neighbours": 8.0})
    groups = problem_of(crowded_face(), said).inputs.placement.groups
    coarse = {group.name: group.inner for group in groups if group.inner}
    assert bool(coarse) is asked
    for name, inner in coarse.items():
        assert len({each[:4] for each in (name, *inner)}) == 1


@pytest.mark.parametrize(("way", "behind"), [((0.9, 0.2, 0.0), {"brow": {"eye"}}), ((0.0, 1.0, 0.0), {})])
def test_a_joint_that_does_what_shapes_do_stands_behind_them(way, behind):
    shapes = {"brow": makers.bump(POINTS, (0.0, 0.3), (1, 0, 0), 0.3), "eye": makers.bump(POINTS, (0.0, 0.3), way)}
    line = problem_of(makers.rig(POINTS, QUADS, shapes), settings(candidates=ON_FACE, symmetry={"enabled": False}))
    known = line.inputs.measured
    brow, eye = known.face.rig.controls
    rig = replace(known.face.rig, controls=(brow, replace(eye, kind="joint")))
    assert joints_behind_shapes(replace(known.face, rig=rig), known.similarity, line.groups) == behind


def test_a_pose_is_no_member_of_itself_in_a_group_with_what_it_sets():
    levels = {"poses": True}
    groups = {"groups": {"both": ["grin", "pucker"]}}
    line = lay_out(with_pose(), settings(levels=levels, candidates=ON_FACE, groups=groups))
    assert by_name(line)["both"].inner == ("smile_L", "smile_R")


def test_members_of_one_coarse_control_are_kept_apart(grinning):
    width = grinning.layout.frame.handle_width
    placed = on_face(grinning.layout)
    seen = states(placed)
    for a, b in combinations(placed, 2):
        if seen[a.name] & seen[b.name]:
            assert np.linalg.norm(a.anchor.position - b.anchor.position) >= width


def test_joysticks_are_opened_into_their_axes():
    elements = by_name(lay_out(FACE, JOYSTICK))
    assert elements["mouth"].inner == ("chin", "pucker")
    assert elements["mouth"].kind == "patch"
    assert {elements[name].kind for name in ("chin", "pucker")} == {"slider"}
    # Each axis has its own best place, which the two together do not.
    assert elements["pucker"].anchor.point == by_name(lay_out(FACE))["pucker"].anchor.point


def test_pairs_are_opened_on_both_sides_and_what_is_on_the_board_is_not():
    lids = {"lid": ["brow_L", "blink_L"], "lidR": ["brow_R", "blink_R"]}
    groups = {"groups": {**lids, "mouth": ["pucker", "chin"]}}
    board = {name: {"place": "board"} for name in groups["groups"]["mouth"]}
    elements = by_name(lay_out(FACE, settings(groups=groups, levels={"groups": True}, controls=board)))
    assert {name: set(elements[name].inner) for name in lids} == {name: set(names) for name, names in lids.items()}
    assert (elements["brow_L"].mirror, elements["blink_R"].mirror) == ("brow_R", "blink_L")
    assert elements["mouth"].inner == ()


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


def anchors(layout):
    return {element.name: element.anchor.point for element in layout.elements}


def test_a_layout_with_levels_is_sound(grinning):
    assert reviewed(grinning, grinning.layout).issues == ()


def test_two_handles_on_one_spot_are_a_fault_only_where_both_are_visible(grinning):
    elements = by_name(grinning)

    def faults(first, second):
        moved = replace(elements[first], anchor=elements[second].anchor)
        spoiled = tuple(moved if each.name == first else each for each in grinning.layout.elements)
        found = reviewed(grinning, replace(grinning.layout, elements=spoiled)).issues
        return {each.code for each in found}

    assert "LAYOUT_HANDLES_COLLIDE" in faults("pucker", "smile_L")
    assert "LAYOUT_HANDLES_COLLIDE" not in faults("pucker", "grin")


def test_a_layout_with_levels_can_be_fixed_and_kept():
    first = lay_out(FACE, JOYSTICK).layout
    assert anchors(lay_out(FACE, JOYSTICK, fixed=first).layout) == anchors(first)
    kept = lay_out(FACE, JOYSTICK, prior=chain.prior(first, FACE, 0.2)).layout
    assert anchors(kept) == anchors(first)
    assert not difference(first, kept).changes


def test_the_first_level_comes_first():
    layout = lay_out(FACE, JOYSTICK).layout
    names = [element.name for element in outer_first(layout.elements)]
    assert set(names[-2:]) == {"chin", "pucker"}


# --- refusals ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("members", "inner"),
    [
        ({"grin": ["pucker"]}, {"grin": ("mouth",), "mouth": ()}),
        ({"mouth": ["brow_L", "wink"]}, {"mouth": ("brow_L", "brow_R"), "grin": ("smile_L", "smile_R")}),
    ],
)
def test_derived_members_give_way_to_configured_ones(members, inner):
    levels = {"poses": True, "groups": True, "members": members}
    groups = {"groups": {"mouth": ["pucker", "chin"]}}
    chosen = settings(levels=levels, candidates=ON_FACE, groups=groups)
    elements = by_name(lay_out(replace(with_pose(), left_off=WINK), chosen))
    assert {name: elements[name].inner for name in inner} == inner
