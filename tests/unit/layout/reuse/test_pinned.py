"""Decisions of a person hold: through versions of a rig, on the other side, and against the opinion of `check`."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from laid_out_again import lay_out

from usdrigui.layout.review.review import review
from usdrigui.settings import load

ANCHOR = "/Root/mesh#914"
DECISIONS = {
    "controls": {"brow_L": {"anchor": ANCHOR}, "sneer_R": {"place": "board"}, "jawRight": {"anchor": "/Root/mesh#218"}},
    "groups": {"groups": {"mouth": ["pucker", "chin"]}},
    "solve": {"gap": 1e-2},
}
"""Of an anchor and with it its twin's, of a place and with it its twin's, of a grouping."""


@pytest.fixture(scope="module")
def decided():
    return lay_out(makers.face(), load(DECISIONS))[2]


def pinned(layout):
    return {each.name: each.pinned for each in layout.elements if each.pinned}


def place(layout, control):
    (element,) = [each for each in layout.elements if control in each.controls and not each.inner]
    return None if element.anchor.on_board else element.anchor.position


def test_decisions_of_the_configuration_are_recorded_with_their_places(decided):
    found = pinned(decided)
    assert found["brow_L"] == found["brow_R"] == ("anchor",)
    assert found["sneer_R"] == ("place",)
    assert next(kinds for name, kinds in found.items() if "pucker" in name or name == "mouth") == ("grouping",)
    left = next(each for each in decided.elements if each.name == "brow_L")
    assert np.allclose(left.pinned_position, left.anchor.position, atol=1e-6)


def another_mesh(columns, rows):
    """The same face on other points."""
    points, quads = makers.mask(columns, rows)
    return makers.rig(points, quads, makers.face_shapes(points))


def test_one_side_moves_the_other_unless_that_is_left_to_itself():
    face = makers.face()
    for follow, same in ((True, True), (False, False)):
        controls = {"brow_L": {"anchor": ANCHOR}, "brow_R": {"follow_twin": follow}}
        inputs, _, layout = lay_out(face, load({"controls": controls}))
        right = next(each for each in layout.elements if each.name == "brow_R")
        assert (right.anchor.point == int(inputs.face.symmetry.partner[914])) is same
        assert (right.pinned == ("anchor",)) is same


def test_a_pin_that_is_in_the_way_of_another_is_given_up_with_a_warning_and_not_the_run(decided):
    """Two pins on one spot, as two people may leave them."""
    left = next(each for each in decided.elements if each.name == "brow_L")
    elements = tuple(
        replace(each, anchor=left.anchor, pinned=("anchor",)) if each.name == "blink_L" else each
        for each in decided.elements
    )
    face = makers.face()
    inputs, _, layout = lay_out(face, previous={face.path: replace(decided, elements=elements)})
    lost = {each.path for each in inputs.issues if each.code == "PIN_LOST"}
    assert len(lost) == 1
    assert lost <= {"brow_L", "blink_L"}
    assert {member.control for each in layout.elements for member in each.members} >= {"brow_L", "blink_L"}


@pytest.mark.parametrize("known", [True, False])
def test_a_pin_far_from_all_that_its_control_moves_says_so(decided, known):
    away = (9.0, 9.0, 9.0) if known else (np.nan,) * 3
    elements = tuple(replace(each, pinned_position=away) for each in decided.elements)
    rig = another_mesh(45, 51)
    inputs, _, _ = lay_out(rig, previous={rig.path: replace(decided, elements=elements)})
    assert {each.code for each in inputs.issues if each.code.startswith("PIN_")} == {
        "PIN_CARRIED" if known else "PIN_LOST"
    }


def test_check_does_not_argue_with_what_is_pinned():
    line = chain.lay_out(makers.face(), chain.settings(controls={"brow_L": {"anchor": ANCHOR}}))
    rated = chain.problem_of(makers.face()).inputs
    free = replace(
        line.layout,
        elements=tuple(replace(each, pinned=()) for each in line.layout.elements),
    )
    for layout, argued in ((free, True), (line.layout, False)):
        found = review(rated.measured, rated.candidates, layout)
        named = {each.path for each in found.issues if each.code == "LAYOUT_BETTER_PLACE"}
        assert bool(named & {"brow_L", "brow_R"}) is argued
