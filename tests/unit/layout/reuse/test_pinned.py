"""Decisions of a person hold: through versions of a rig, on the other side, and against the opinion of `check`."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from laid_out_again import lay_out

from usdrigui.errors import RigUIError, refuse
from usdrigui.layout.reuse.pinned import Pin, Pins, pins_of, pins_of_corrections
from usdrigui.layout.reuse.renaming import with_names
from usdrigui.layout.review.review import review
from usdrigui.model import Correction
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


def test_what_a_person_decided_is_carried_but_for_what_is_gone_or_said_anew(decided):
    now = chain.today(makers.face())
    found = pins_of(with_names(decided, {"pucker": "gone", "brow_L": "lost"}), now, ())
    assert sorted(each.path for each in found.issues) == ["gone", "lost"]
    pins = {pin.controls: (pin.place, pin.decisions) for pin in found.pins if not pin.anchor}
    assert pins == {("chin",): ("", ("grouping",)), ("sneer_R",): ("board", ("place",))}
    assert {pin.controls for pin in found.pins if pin.anchor} == {("brow_R",), ("jawRight", "jawLeft")}
    kept = replace(decided, elements=tuple(replace(each, pinned=("place",)) for each in decided.elements))
    assert {pin.place for pin in pins_of(kept, now, ()).pins if pin.controls == ("brow_L",)} == {"face"}
    for place, left in (("", True), ("free", False)):
        rest = pins_of(decided, now, [Correction("/Root", "brow_L", place)]).pins
        assert sum("brow" in pin.element for pin in rest) == 2 * left


def test_a_corrected_place_is_found_in_any_units_and_with_any_axis_up():
    now, width = chain.today(makers.face()), 0.1
    x, y, z = now.points[914].tolist()

    def pin(place="point", control="brow_L", **said):
        found = pins_of_corrections([Correction("/Root", control, place, **said)], now, width)
        return found.pins[0] if found.pins else None, [each.code for each in found.issues]

    assert [pin(place)[0] and pin(place)[0].place for place in ("free", "face", "board")] == [None, "face", "board"]
    there = {"position": (100.0 * x, -100.0 * z, 100.0 * y), "up": (0.0, 0.0, 1.0), "unit": 0.01}
    for said in ({"position": (x, y, z)}, there):
        found, issues = pin(**said)
        assert (found.anchor, found.decisions, issues) == (ANCHOR, ("anchor",), [])
        assert found.position == pytest.approx((x, y, z))
    assert [pin(position=(x, y, z + share * width))[1] for share in (0.4, 0.9)] == [[], ["PIN_CARRIED"]]
    assert pin(position=(np.nan,) * 3) == pin(control="nobody") == (None, ["PIN_LOST"])
    halfway = tuple(now.points[914:916].mean(axis=0))
    for point in (914, 915):
        assert pin(position=halfway, mesh="/Root/mesh", point=point)[0].anchor == f"/Root/mesh#{point}"


def test_of_pins_in_the_way_of_each_other_those_on_record_go_first_and_then_the_fewest():
    every = (Pin(name, (name[0],), (), "/mesh#1", recorded=name != "a") for name in ("a", "b1", "b2", "c"))
    pins, error = Pins(tuple(every)), refuse("FIXED_IMPOSSIBLE", "a", "in the way")
    for groups, lost in (("a", "b"), ["b1", "b2"]), (("b", "c"), ["c"]), (("d", "c"), ["c"]), (("ab",), ["b2"]):
        rest = pins.without(error, [*map(frozenset, groups)])
        assert [each.element for each in rest.pins if not each.anchor] == [each.path for each in rest.issues] == lost
    with pytest.raises(RigUIError, match="in the way"):
        pins.without(error, [frozenset("d")])


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
    assert layout.controls >= {"brow_L", "blink_L"}


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
