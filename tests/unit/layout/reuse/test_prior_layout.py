"""Layouts that follow earlier ones: fixed anchors, stability against a previous layout."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from makers import POINTS

from usdrigui.errors import RigUIError
from usdrigui.layout.reuse.prior_layout import (
    NO_PRIOR,
    KeptGroup,
    Place,
    PriorLayout,
    joined,
    kept_groups,
    leaving_penalties,
)
from usdrigui.layout.review.difference import difference
from usdrigui.settings import ControlSettings, Settings, SymmetrySettings


def lay_out(rig, settings=None, prior=NO_PRIOR, fixed=None):
    return chain.lay_out(rig, settings, prior=prior, fixed=fixed)


def anchors(layout):
    return {
        member.control: "board" if element.anchor.on_board else element.anchor.point
        for element in layout.elements
        for member in element.members
    }


def partners(layout):
    return {element.controls for element in layout.elements}


@pytest.fixture(scope="module")
def face():
    return makers.face()


@pytest.fixture(scope="module")
def before(face):
    return chain.lay_out(face)


def without(rig, *names):
    return replace(rig, controls=tuple(control for control in rig.controls if control.name not in names))


def edited(layout, **new):
    """The layout with other values of fields of some elements, by name."""
    return replace(layout, elements=tuple(replace(each, **new.get(each.name, {})) for each in layout.elements))


def beside(layout, name):
    """The layout with an element on the board."""
    (anchor,) = (each.anchor for each in layout.elements if each.name == name)
    return edited(layout, **{name: {"anchor": replace(anchor, on_board=True)}})


def at_another_place(line, name, column=0):
    """The layout with one element moved to some other point that its control moves, beyond the candidates."""
    element = chain.by_name(line)[name]
    motion = line.face.trajectories.motion_of(line.face.rig.control_indices[element.members[0].control])
    reach = np.linalg.norm(line.face.surface.points[motion.points] - element.anchor.position, axis=1)
    point = int(motion.points[np.argsort(reach)[len(reach) // 2 + column]])
    anchor = replace(element.anchor, point=point, position=np.array(line.face.surface.points[point]))
    return edited(line.layout, **{name: {"anchor": anchor}}), point


# --- fixed -------------------------------------------------------------------------------------------


def test_a_fixed_layout_comes_back_to_the_point_and_in_its_pairs(face, before):
    again = lay_out(face, fixed=before.layout)
    assert anchors(again.layout) == anchors(before.layout)
    assert partners(again.layout) == partners(before.layout)
    mirrors = {element.name: element.mirror for element in before.layout.elements}
    assert {element.name: element.mirror for element in again.layout.elements} == mirrors


def test_a_doubled_element_keeps_both_of_its_handles_and_pays_nothing(face):
    twice = Settings(symmetry=SymmetrySettings(double_middle="always"))
    doubled = lay_out(face, twice)
    assert any(name.endswith("_mirror") for name in chain.by_name(doubled))
    prior = chain.prior(doubled.layout, face, 50.0)
    for again in (lay_out(face, prior=prior), lay_out(face, fixed=doubled.layout)):
        assert set(chain.by_name(again)) == set(chain.by_name(doubled))
        assert anchors(again.layout) == anchors(doubled.layout)
        assert again.assignment.cost < 0.0


def test_a_group_on_the_board_stays_together_whatever_takes_its_controls_off_the_face():
    """Only a group one of whose controls is on the face again and the other is not is parted."""
    lifted, board = makers.face_with(headUp=np.tile((0.0, 0.3, 0.0), (len(POINTS), 1))), ControlSettings(place="board")
    settings = Settings(controls={"chin": board})
    names = lifted.control_names
    together = KeptGroup("head", (names.index("headUp"), names.index("chin")), ())
    both = frozenset(("headUp", "chin"))
    for asked in (settings, Settings()):
        found = lay_out(lifted, asked, PriorLayout((together,)))
        assert (both in partners(found.layout)) == (asked is settings)


def test_the_rest_is_optimal_given_what_is_fixed(face, before):
    layout, point = at_another_place(before, "pucker")
    partial = replace(layout, elements=tuple(each for each in layout.elements if each.name == "pucker"))
    line = lay_out(face, fixed=partial)
    assert anchors(line.layout)["pucker"] == point
    assert line.assignment.status == "optimal"
    assert line.assignment.cost - line.assignment.bound <= 1e-9 * abs(line.assignment.cost) + 1e-12
    # What the fixed handle is in the way of has moved aside; everything else solves the remaining problem.
    (fixed,) = [i for i, variable in enumerate(line.problem.variables) if variable.name == "pucker"]
    assert len(line.problem.variables[fixed].points) == 1
    assert np.isinf(line.problem.variables[fixed].off_face_cost)


def test_fixing_beside_keeps_a_control_off_the_face(face, before):
    assert anchors(lay_out(face, fixed=beside(before.layout, "chin")).layout)["chin"] == "board"


def test_the_configuration_is_stronger_than_the_fixed_layer(face, before):
    settings = chain.settings(controls={"chin": {"anchor": "/Root/mesh#20"}})
    found = anchors(lay_out(face, settings, fixed=before.layout).layout)
    assert found["chin"] == 20
    assert found["pucker"] == anchors(before.layout)["pucker"]


def test_fixing_one_member_fixes_its_group(face):
    settings = chain.settings(
        groups={"groups": {"jaw": ["jawLeft", "jawRight"]}}, controls={"jawLeft": {"anchor": "/Root/mesh#181"}}
    )
    found = anchors(chain.lay_out(face, settings).layout)
    assert found["jawLeft"] == found["jawRight"] == 181


@pytest.mark.parametrize(
    ("controls", "groups", "told"),
    [
        ({"chin": 16}, {}, None),
        ({"chin": 1300}, {}, "does not move"),
        ({"pucker": 382, "smile_L": 382}, {}, "least distance"),
        ({"jawLeft": 181, "jawRight": 182}, {"jaw": ["jawLeft", "jawRight"]}, "and at"),
        ({"pucker": 379}, {"odd": ["pucker", "brow_L"]}, "does not move"),
    ],
)
def test_impossible_requests_are_refused_with_the_reason(face, controls, groups, told):
    said = {name: {"anchor": f"/Root/mesh#{point}"} for name, point in controls.items()}
    settings = chain.settings(controls=said, groups={"groups": groups})
    if told is None:
        chain.problem_of(face, settings)
        return
    with pytest.raises(RigUIError, match=told) as refused:
        chain.problem_of(face, settings)
    assert refused.value.issue.code == "FIXED_IMPOSSIBLE"


def test_a_layer_fixed_on_other_points_is_refused(face, before):
    other = makers.face(columns=31)
    with pytest.raises(RigUIError, match="other points or faces"):
        chain.problem_of(other, fixed=before.layout)
    with pytest.raises(RigUIError, match="CONFIG_UNKNOWN_CONTROL"):
        chain.problem_of(without(face, "chin"), fixed=before.layout)


# --- the layout before -------------------------------------------------------------------------------


def test_nothing_moves_when_nothing_changed(face, before):
    again = lay_out(face, prior=chain.prior(before.layout, face, 0.1))
    assert anchors(again.layout) == anchors(before.layout)
    assert difference(before.layout, again.layout).changes == ()


def test_a_place_is_kept_until_leaving_it_saves_more_than_the_penalty(face, before):
    layout, point = at_another_place(before, "chin")
    cheap = lay_out(face, prior=chain.prior(layout, face, 1e-4))
    dear = lay_out(face, prior=chain.prior(layout, face, 5.0))
    assert anchors(cheap.layout)["chin"] == anchors(before.layout)["chin"]
    assert anchors(dear.layout)["chin"] == point
    (change,) = [each for each in difference(layout, cheap.layout).changes if each.control == "chin"]
    assert change.kind == "moved"
    assert change.distance > 0.0


def test_where_no_point_is_left_all_within_a_handle_of_the_nearest_may_be_taken(face, before):
    layout, _ = at_another_place(before, "chin")
    chin, prior = face.control_indices["chin"], chain.prior(layout, face, 5.0)
    off = prior.places[chin].position + 0.3 * before.face.handle_width * np.eye(3)[0]
    places = {**prior.places, chin: replace(prior.places[chin], position=off)}
    line = chain.problem_of(face, prior=replace(prior, places=places))
    found = line.candidates.sets[chin]
    motion = found.motion
    apart = np.linalg.norm(line.face.surface.points[motion.points] - off, axis=1)
    near = motion.points[apart <= 1.3 * line.face.handle_width]
    assert len(near) > 1
    assert set(near) <= set(found.points)


def test_a_control_sent_to_the_board_stays_there_at_the_penalty(face, before):
    layout = beside(before.layout, "chin")
    assert anchors(lay_out(face, prior=chain.prior(layout, face, 5.0)).layout)["chin"] == "board"
    assert anchors(lay_out(face, prior=chain.prior(layout, face, 1e-3)).layout)["chin"] != "board"


def test_an_edit_on_one_side_unfolds_the_pair(face, before):
    layout, point = at_another_place(before, "brow_L")
    again = lay_out(face, prior=chain.prior(layout, face, 5.0))
    assert anchors(again.layout)["brow_L"] == point
    assert anchors(again.layout)["brow_R"] == anchors(before.layout)["brow_R"]


def test_groups_stay_and_new_controls_do_not_join_old_ones(face):
    apart = chain.lay_out(face, chain.settings(groups={"opposed": False}))
    again = lay_out(face, prior=chain.prior(apart.layout, face, 0.1))
    assert frozenset(["jawLeft"]) in partners(again.layout)
    merged = lay_out(face)
    assert frozenset(["jawLeft", "jawRight"]) in partners(merged.layout)
    kept = lay_out(face, chain.settings(groups={"opposed": False}), chain.prior(merged.layout, face, 0.1))
    assert frozenset(["jawLeft", "jawRight"]) in partners(kept.layout)
    (jaw,) = [element for element in kept.layout.elements if len(element.members) > 1]
    assert jaw.opposed == ((0, 1),)


def test_every_move_between_two_layouts_has_a_reason(before):
    elsewhere, _ = at_another_place(before, "chin")
    weights = dict(before.layout.proof.weights) | {"objective.displacement_weight": 0.5}
    chin = chain.by_name(before)["chin"]
    half = replace(chin.members[0], peak=0.5 * chin.members[0].peak)
    told = {
        "it moves its farthest point 0.50 times as far as before": edited(before.layout, chin={"members": (half,)}),
        "no reason recorded": before.layout,
        "made with other settings: objective.displacement_weight": replace(
            before.layout,
            proof=replace(before.layout.proof, weights=tuple(weights.items())),
        ),
    }
    for reason, after in told.items():
        changes = difference(elsewhere, after).changes
        assert changes
        assert all(any(reason in clause for clause in change.why) for change in changes)


@pytest.mark.parametrize("pinned_before", [(), ("anchor",)])
def test_of_a_swap_the_control_that_a_person_anchored_is_the_cause(before, pinned_before):
    chin, pucker = (chain.by_name(before)[name].anchor for name in ("chin", "pucker"))
    swapped = edited(before.layout, chin={"anchor": pucker, "pinned": ("anchor",)}, pucker={"anchor": chin})
    found = difference(edited(before.layout, chin={"pinned": pinned_before}), swapped)
    assert {change.control: change.why for change in found.changes} == {
        "chin": ("its anchor, or its twin's, was decided by a person",),
        "pucker": ("its place is taken by chin, whose anchor was decided by a person",),
    }


def test_what_became_of_a_control_is_told_with_the_reason(before):
    width, chin = before.layout.frame.handle_width, chain.by_name(before)["chin"]
    anchor, (member,) = chin.anchor, chin.members
    board = {"anchor": replace(anchor, on_board=True), "reason": "too crowded"}
    far = replace(anchor, position=anchor.position + 2.0 * width * np.eye(3)[2])
    new_mesh = {"topology_hash": "another", "point_count": 7}
    moved = {"anchor": replace(anchor, point=anchor.point + 1)}
    wide, person, unknown = replace(member, values=2.0 * member.values), {"pinned": ("place",)}, "no reason recorded"
    for one, other, kind, why in (
        ({}, board, "board", "too crowded"),
        (board, {}, "to the face", unknown),
        (board, board | {"anchor": replace(far, on_board=True)}, None, ""),
        ({}, {"anchor": replace(far, **new_mesh)}, "moved", "other points or faces: 1353 points then, 7 now"),
        ({}, {"anchor": replace(far, mesh="/Root/other", **new_mesh)}, "moved", unknown),
        ({}, {"anchor": replace(anchor, **new_mesh)}, None, ""),
        ({}, moved | person, "moved", "on the face or on the board was decided by a person"),
        (person, moved | person, "moved", unknown),
        ({}, moved | {"members": (wide,)}, "moved", "its range is 0 to 2 now, 0 to 1 before"),
    ):
        found = difference(edited(before.layout, chin=one), edited(before.layout, chin=other)).changes
        assert [(each.control, each.kind) for each in found] == ([("chin", kind)] if kind else [])
        assert all(len(each.why) == 1 and why in each.why[0] for each in found)
        assert all(each.distance in (0.0, 2.0) or board in (one, other) for each in found)


def test_a_group_that_lost_a_member_is_its_survivors(face, before):
    smaller = without(face, "jawRight")
    again = lay_out(smaller, prior=chain.prior(before.layout, smaller, 0.1))
    assert frozenset(["jawLeft"]) in partners(again.layout)
    assert anchors(again.layout)["jawLeft"] == anchors(before.layout)["jawLeft"]
    found = difference(before.layout, again.layout)
    assert [(change.control, change.kind) for change in found.changes] == [("jawRight", "removed")]


def test_of_two_prior_layouts_the_first_holds(face, before):
    first = PriorLayout(kept_groups(replace(before.layout, elements=before.layout.elements[:2]).elements, face))
    both = joined(first, chain.prior(before.layout, face, 0.3))
    assert both.penalty == 0.3
    assert both.groups[: len(first.groups)] == first.groups
    members = [control for group in both.groups for control in group.controls]
    assert len(members) == len(set(members)) == len(face.controls)


def test_leaving_a_place_costs_by_the_distance_or_everywhere_alike():
    base = np.array([[0.0, 0, 0], [1.0, 0, 0], [2.0, 0, 0], [9.0, 0, 0]])
    here = Place(1, np.array([0.5, 0.0, 0.0]), on_board=False)
    board = replace(here, on_board=True)
    some = np.array([1, 2, 3])

    def costs(places, cutoff, controls=(0,), anchors=some, width=0.5):
        prior = PriorLayout(places=places, penalty=2.0, cutoff_distance=cutoff)
        return leaving_penalties(prior, controls, anchors, base, width).tolist()

    assert costs({0: here}, 0.0) == [0.0, 8.0, 512.0], "by the square beyond a handle's width"
    assert costs({0: here}, 0.0, width=4.0) == [0.0, 2.0, 8.0]
    assert costs({0: replace(here, point=7)}, 0.0) == [0.0, 8.0, 512.0], "the nearest stands for a point that is gone"
    assert costs({0: here}, 4.0) == [0.0, 1.0, 2.0], "the whole penalty at two units, counted from the nearest"
    assert costs({0: board}, 4.0) == [2.0, 2.0, 2.0]
    assert costs({5: here}, 4.0) == [0.0, 0.0, 0.0]
    other = replace(here, position=np.array([9.0, 0, 0]), point=3)
    assert costs({0: here, 1: other}, 4.0, (0, 1)) == [2.0, 2.0, 2.0]
    assert costs({0: here}, 4.0, anchors=some[:0]) == []
