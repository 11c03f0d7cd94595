"""Composites: controls that repeat others."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES


@pytest.mark.parametrize("noise", [0.0, 1e-3])
def test_of_many_copies_one_stays_and_the_others_repeat_it(noise):
    random = np.random.default_rng(1)
    raised = makers.bump(POINTS, (0.0, 0.8), (0, 1, 0.2), 0.3)
    copies = {f"copy_{i:02d}": raised + noise * raised * random.normal(size=raised.shape) for i in range(12)}
    found = chain.chosen(makers.face_with(**copies))
    said = [found(name) for name in copies]
    assert sum(each.category != "composite" for each in said) == 1
    assert all(
        each.off_face_reason.startswith("does the same as copy_") for each in said if each.category == "composite"
    )


def test_a_control_alone_is_no_composite():
    found = chain.chosen(makers.rig(POINTS, QUADS, {"pucker": SHAPES["pucker"]}))("pucker")
    assert (found.category, found.off_face_reason) == ("", "")


def test_composites_say_of_what_they_consist_and_their_chains_end_at_atoms():
    smiles, chin = SHAPES["smile_L"] + SHAPES["smile_R"], SHAPES["chin"]
    visemes = {"viseme_aa": 0.8 * chin, "viseme_O": chin + 0.5 * SHAPES["pucker"], "viseme_I": 0.5 * smiles}
    inputs = chain.problem_of(makers.face_with(both=2.0 * smiles, pucker_50=0.5 * SHAPES["pucker"], **visemes)).inputs
    told = inputs.explained_by
    assert told["both"] == pytest.approx({"smile_L": 2.0, "smile_R": 2.0}, rel=1e-2)
    assert told["viseme_O"] == pytest.approx({"chin": 1.0, "pucker": 0.5}, rel=1e-2)
    assert told["viseme_aa"] == pytest.approx({"chin": 0.8}, rel=1e-2)
    assert {part for parts in told.values() for part in parts} <= set(SHAPES)


@pytest.mark.parametrize(
    ("name", "stays"),
    [
        ("mouthLowerDown", False),
        ("mouthLowerDown_M", True),
        ("mouthPucker", True),
        ("cheekPuff", True),
        ("mouthSmile", False),
    ],
)
def test_of_copies_for_both_sides_those_stay_that_a_face_needs_or_that_act_on_both_by_name(name, stays):
    sides = {
        f"{name.removesuffix('_M')}_{s}": makers.bump(POINTS, (x, -0.5), (0, -1, 0), 0.3)
        for s, x in (("L", 0.1), ("R", -0.1))
    }
    found = chain.chosen(makers.face_with(**sides, **{name: sum(sides.values())}))
    assert (found(name).category == "") == stays
