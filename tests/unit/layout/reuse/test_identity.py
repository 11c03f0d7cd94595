"""Which control is which: names, motions, and how sure a match is."""

import tomllib
from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from chain import with_motions
from makers import POINTS, QUADS, SHAPES
from rig_copies import numbers, renamed, spelt_otherwise

from usdrigui.layout.reuse import name_evidence
from usdrigui.layout.reuse.identity import match_layout, match_rigs, matching_issues, names_draft
from usdrigui.layout.reuse.renaming import with_names
from usdrigui.layout.review.difference import difference
from usdrigui.model import SURE, Match


@pytest.fixture(scope="module")
def face():
    return makers.face()


@pytest.fixture(scope="module")
def line(face):
    return chain.lay_out(face)


def respelt(layout, names):
    """The layout as one that succeeds it has it when some controls have other names."""
    matches = tuple(Match(before, after, 1.0, "motion") for before, after in names.items())
    new = with_names(layout, names)
    return replace(new, matches=matches)


def matched(before, after, names=None):
    return match_rigs(with_motions(before), with_motions(after), names)


@pytest.mark.parametrize("name", [spelt_otherwise, numbers()])
def test_renamed_controls_are_recognised_in_rigs_and_layouts(face, line, name):
    copy, names = renamed(face, name)
    assert matched(face, copy).names == names
    assert match_layout(line.layout, *with_motions(copy)).names == names


def test_a_control_that_keeps_its_name_is_the_same_one_whatever_it_does(face, line):
    names = face.control_names
    turned = replace(
        face, controls=tuple(replace(c, name=n) for c, n in zip(face.controls, names[1:] + names[:1], strict=True))
    )
    assert match_layout(line.layout, *with_motions(turned)).names == {name: name for name in names}


def test_twins_that_do_the_same_are_told_apart_by_names_and_else_not_at_all():
    """Two copies of one shape: names decide, and without names neither match is sure."""
    double = makers.face_with(smile_L_copy=SHAPES["smile_L"])
    found = matched(double, double)
    assert all(each.before == each.after for each in found.matches)
    silent, _ = renamed(double, numbers())
    unsure = {each.before: each.confidence for each in matched(double, silent).unsure}
    assert unsure.keys() >= {"smile_L", "smile_L_copy"}
    assert max(unsure[name] for name in ("smile_L", "smile_L_copy")) <= 0.6


def test_what_has_no_counterpart_is_left_on_either_side(face):
    ears = {"ears": makers.bump(POINTS, (0.7, 0.2), (1.0, 0.0, 0.0), 0.1)}
    other = makers.rig(POINTS, QUADS, {**{n: o for n, o in SHAPES.items() if n != "chin"}, **ears})
    found = matched(face, other)
    assert (found.left_before, found.left_after) == (("chin",), ("ears",))


def test_the_configuration_decides_first(face):
    chosen = {"chin": "pucker", "pucker": ""}
    found = matched(face, face, chosen)
    assert found.names["chin"] == "pucker"
    assert "pucker" not in found.names
    assert "pucker" in found.left_before


def test_the_draft_of_names_is_a_configuration(face):
    copy, names = renamed(face, spelt_otherwise)
    text = names_draft(matched(face, copy))
    assert tomllib.loads(text)["like"]["names"] == names


def test_unsure_matches_stand_in_the_draft_as_comments_only(face):
    copy, _ = renamed(face, numbers())
    found = matched(face, copy)
    doubted = replace(found, matches=tuple(replace(each, confidence=SURE - 0.1) for each in found.matches))
    assert tomllib.loads(names_draft(doubted))["like"]["names"] == {}
    assert {each.code for each in matching_issues("previous", doubted)} == {"CONTROL_UNSURE"}
    assert {each.code for each in matching_issues("previous", found)} == {"CONTROL_RENAMED"}
    assert not list(matching_issues("like", doubted))
    barely = replace(found.matches[0], confidence=SURE - 0.001)
    assert (barely.sure, replace(barely, confidence=SURE).sure) == ("89% sure", "90% sure")


def test_the_draft_names_the_controls_of_this_character_that_have_no_counterpart(face):
    left = replace(matched(face, face), left_after=("ear.wiggle",))
    assert '#   "ear.wiggle"' in names_draft(left).splitlines()


def test_a_renamed_control_is_neither_lost_nor_new(line):
    names = {"smile_L": "grin.left", "jawLeft": "jaw_to_the_left"}
    found = difference(line.layout, respelt(line.layout, names))
    assert {(each.was, each.control, each.kind) for each in found.changes} == {
        (was, now, "renamed") for was, now in names.items()
    }
    assert not found.displaced
    assert found.renamed == 2


def test_a_control_with_two_handles_counts_once(line):
    """And why it moved is told where a decision of a person no longer holds."""
    first, second, *_ = (each for each in line.layout.elements if not each.anchor.on_board)
    copy = replace(second, name="copy", members=first.members)
    pair = [replace(each, pinned=("anchor",)) for each in (first, copy)]
    before = replace(line.layout, elements=(*pair, *line.layout.elements[1:]))
    moved = [replace(each, anchor=replace(each.anchor, point=each.anchor.point + 1), pinned=()) for each in pair]
    found = difference(before, replace(before, elements=(*moved, *line.layout.elements[1:])))
    assert (found.changed, len(found.displaced), found.shared) == (1, 2, len(before.controls))
    assert all("no longer the one that a person had decided" in each.why[-1] for each in found.displaced)


def test_elements_of_a_layout_take_the_new_names_where_they_refer_to_each_other(line):
    both = with_names(line.layout, {"smile_L": "a", "smile_R": "b"})
    elements = {each.name: each for each in both.elements}
    assert (elements["a"].mirror, elements["b"].mirror) == ("b", "a")
    assert np.array_equal(elements["a"].anchor.position, chain.by_name(line)["smile_L"].anchor.position)


def test_a_doubled_element_is_the_same_whichever_side_comes_first(line):
    left, right = (chain.by_name(line)[name] for name in ("smile_L", "smile_R"))
    others = tuple(each for each in line.layout.elements if each not in (left, right))
    both = [replace(each, name=f"both{n}", members=left.members) for n, each in enumerate((left, right))]
    layouts = [replace(line.layout, elements=(*others, *pair)) for pair in (both, both[::-1])]
    assert not difference(*layouts).changes


@pytest.mark.parametrize(
    ("name", "counterpart", "others"),
    [
        ("browDown_L", "Eyebrows_Lower_Left", ["Eyebrows_Frown_Left"]),
        ("mouthUpperUp_R", "Lips_Up_Raised_Right", ["Lips_Up_Raised_M"]),
        ("mouthShrugLower", "Chin_Raised", ["Lips_Dn_Raised", "Lips_Push_Up"]),
        ("PupilDilate_L", "Pupil_Dilation_Left", ["Pupil_Constriction_Left"]),
    ],
)
def test_other_words_for_one_thing_and_one_action_unit_speak_for_a_pair(name, counterpart, others):
    found = name_evidence.name_evidence([name, "jawOpen"], [counterpart, *others, "Jaw_Lower"])[0]
    assert found[0] > max(found[1:]) + 0.5
