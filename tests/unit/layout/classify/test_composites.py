"""Composites: controls that repeat others."""

from dataclasses import replace
from types import SimpleNamespace

import chain
import makers
import numpy as np
import pytest

from usdrigui.layout.classify import classification
from usdrigui.layout.classify.basis import Basis, Explanation
from usdrigui.layout.classify.composites import _composite, _contained, _costs, _distant, _Spreads, composites
from usdrigui.layout.motion.similarity import DisplacementFields

POINTS, QUADS = makers.mask()


SHAPES = makers.face_shapes(POINTS)


def test_repetitions_mixtures_and_spreads_are_composites():
    smile = SHAPES["smile_L"] + SHAPES["smile_R"]
    brow = SHAPES["brow_L"] + SHAPES["brow_R"]
    rig = makers.face_with(
        smile_50=0.5 * SHAPES["pucker"], both=smile, emotion=0.6 * brow + 0.8 * SHAPES["pucker"] + SHAPES["chin"] * 0.5
    )
    found = chain.chosen(rig)
    assert "pucker" in found("smile_50").off_face_reason
    assert found("smile_50").category == "composite"
    assert found("both").category == "composite"
    assert found("emotion").category == "composite"
    assert not any(found(name).category == "composite" for name in SHAPES)
    assert chain.chosen(rig, candidates={"board_composite": False})("both").category != "composite"
    assert chain.chosen(rig, controls={"both": {"place": "face"}})("both").category != "composite"


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


@pytest.mark.parametrize("first", [0, 1])
def test_of_controls_under_names_of_two_conventions_those_of_the_fuller_one_stay(first):
    said = {"Jaw_Open": "jawOpen", "Mouth_Pucker": "mouthPucker", "Nose_Sneer_L": "noseSneerLeft", "Cheek_Puff": ""}
    shapes = {
        name: makers.bump(POINTS, (0.0, y), (0, 1, 0.2), 0.2)
        for name, y in zip(said, (-0.9, -0.5, 0.0, 0.4), strict=True)
    }
    copies = {said[name]: shape for name, shape in shapes.items() if said[name]}
    both = [shapes, copies] if first else [copies, shapes]
    found = chain.chosen(makers.rig(POINTS, QUADS, both[0] | both[1]))
    assert [name for name in (*said, *copies) if found(name).category == ""] == list(said)


def test_a_control_alone_is_no_composite():
    found = chain.chosen(makers.rig(POINTS, QUADS, {"pucker": SHAPES["pucker"]}))("pucker")
    assert (found.category, found.off_face_reason) == ("", "")


def test_a_part_that_stands_twice_is_one_part():
    lesser, whole = (makers.bump(POINTS, (0.0, 0.8), (0, 1, 0.2), radius) for radius in (0.28, 0.3))
    aside = np.linalg.norm(whole, axis=1)[:, None] * [0.25, 0.0, 0.0]
    found = chain.chosen(makers.face_with(raise_a=lesser, raise_b=lesser, swerving=whole + aside))
    assert found("swerving").category != "composite"


def test_flattened_in_betweens_are_steps_of_their_control():
    off_the_line = 0.5 * SHAPES["pucker"] + 0.3 * np.linalg.norm(SHAPES["pucker"], axis=1)[:, None] * [0.0, 1.0, 0.0]
    found = chain.chosen(makers.face_with(pucker_50=off_the_line, other=off_the_line * 1.1))
    assert found("pucker_50").category == "composite"
    assert "pucker" in found("pucker_50").off_face_reason
    assert found("other").category != "composite"


def test_an_emotion_with_a_shape_of_its_own_is_still_a_spread():
    own = makers.bump(POINTS, (0.0, 0.1), (0, 0, 1), 0.5, 0.08)
    brow, smile = SHAPES["brow_L"] + SHAPES["brow_R"], SHAPES["smile_L"] + SHAPES["smile_R"]
    measured = chain.measured(makers.face_with(emotion=brow + smile + own))
    face = measured.face
    coverage = np.array([each.coverage for each in measured.classification])
    found = composites(face, measured.similarity, coverage)
    assert [face.rig.controls[face.trajectories.motions[i].control].name for i in found] == ["emotion"]
    assert next(iter(found.values())).kind == "spread"


def test_an_explanation_that_fails_costs_the_words_alone(monkeypatch):
    rig = makers.face_with(both=SHAPES["smile_L"] + SHAPES["smile_R"])
    sound = chain.measured(rig).classification
    monkeypatch.setattr(classification, "explanation", lambda *_: [][1])
    spoilt = chain.measured(rig).classification
    (index,) = (i for i, each in enumerate(spoilt) if each.issues)
    assert replace(spoilt[index], off_face_reason=sound[index].off_face_reason, issues=()) == sound[index]
    assert [each for i, each in enumerate(spoilt) if i != index] == [each for i, each in enumerate(sound) if i != index]
    assert spoilt[index].off_face_reason == "repeats other controls"
    assert (spoilt[index].issues[0].code, spoilt[index].issues[0].path) == ("EXPLANATION_FAILED", "both")
    monkeypatch.setattr(classification, "explanation", lambda *_: (_ for _ in ()).throw(KeyboardInterrupt))
    with pytest.raises(KeyboardInterrupt):
        chain.measured(rig)


def test_composites_say_of_what_they_consist_and_their_chains_end_at_atoms():
    smiles, chin = SHAPES["smile_L"] + SHAPES["smile_R"], SHAPES["chin"]
    visemes = {"viseme_aa": 0.8 * chin, "viseme_O": chin + 0.5 * SHAPES["pucker"], "viseme_I": 0.5 * smiles}
    inputs = chain.problem_of(makers.face_with(both=2.0 * smiles, pucker_50=0.5 * SHAPES["pucker"], **visemes)).inputs
    told = {name: dict(parts) for name, parts in inputs.explained_by.items()}
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
        ("mouthSmile", True),
    ],
)
def test_of_copies_for_both_sides_those_stay_that_a_face_needs_or_that_act_on_both_by_name(name, stays):
    sides = {
        f"{name.removesuffix('_M')}_{s}": makers.bump(POINTS, (x, -0.5), (0, -1, 0), 0.3)
        for s, x in (("L", 0.1), ("R", -0.1))
    }
    found = chain.chosen(makers.face_with(**sides, **{name: sum(sides.values())}))
    assert (found(name).category == "") == stays


@pytest.mark.parametrize(("far", "found"), [([(0, 1)], ()), ([(0, 1), (0, 2)], (0, 2)), ([], ())])
def test_a_spread_moves_two_distant_pairs_and_is_told_by_the_one_most_like_it(far, found):
    apart = np.zeros((4, 4), dtype=bool)
    apart[tuple(np.array(far, dtype=int).reshape(-1, 2).T)] = True
    cosine = np.array([[1.0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0.5, 0.2, 0.4, 1]])
    evidence = SimpleNamespace(contains=np.ones((4, 4), bool), size=[1, 1, 1, 3], far=apart, cosine=cosine)
    atoms = np.array([True, True, True, False])
    assert _Spreads.distant_pair(evidence, 3, atoms) == found


def test_what_it_costs_that_a_control_is_no_sum_of_others():
    """One for a name that says nothing and what it covers, .2 less with a twin; two more for both sides of what has
    sides, three more in a family; whatever its importance below nothing where the name says all."""
    smile = SimpleNamespace(name="smile", is_central=False, is_core=False, importance=0.7)
    meant = [SimpleNamespace(action=smile, side=side, middle=False) for side in ("left", "right", "")]
    costs = _costs(
        ["smileL", "smileR", "smile", "a", "bL", "bR", "viseme"],
        [*meant, None, None, None, None],
        np.array([1, 0, 2, -1, 5, 4, 6]),
        np.array([0.1, 0.1, 0.2, 0.25, 0.0, 0.0, 0.0]),
        [SimpleNamespace(members=[6])],
    )
    assert costs.tolist() == [-0.7, -0.7, 3.2, 1.25, 0.8, 0.8, 4.0]


def contained(one, other):
    """Whether a control that does `one` contains one that does `other`, at two places of area 1 and 2."""
    vectors = np.array([one, other], dtype=np.float32)
    fields = DisplacementFields(np.arange(2), vectors, np.array([1.0, 2.0]))
    return bool(_contained(fields, vectors.any(axis=2))[0, 1])


def test_a_control_contains_what_goes_its_way_where_that_acts_and_by_a_quarter_of_it():
    there, still = (5.0, 0, 0), (0, 0, 0)
    assert contained([(3.1, 4, 0), (0, 99, 0)], [there, still])
    assert not contained([(3, 4, 0), still], [there, still]), "a cosine of .6 is not more"
    assert contained([(1.3, 0, 0), still], [there, still])
    assert not contained([(1.25, 0, 0), still], [there, still]), "a quarter is not more"
    assert not contained([still, (1, 0, 0)], [there, still])
    assert not contained([(1, 0, 0), (1, 0, 0)], [still, still])
    assert contained([(1, 0, 0), (2, 0, 0)], [(1, 0, 0), (1, 0, 0)])


def test_distant_parts_are_three_tenths_of_the_face_apart_in_height():
    vectors = np.zeros((3, 3, 3), dtype=np.float32)
    vectors[[0, 1, 2], [0, 1, 2], 0] = 1.0
    surface = SimpleNamespace(points=np.array([[0.0, 0, 0], [0, 0.61, 0], [9, 0.6, 9]]), face_size=2.0)
    alike = SimpleNamespace(fields=DisplacementFields(np.arange(3), vectors, np.ones(3)), shared=np.eye(3))
    found = _distant(surface, alike, np.array([0.0, 1, 0]))
    assert found.tolist() == [[False, True, False], [True, False, False], [False, False, False]]
    alike.shared = np.full((3, 3), 0.05)
    assert not _distant(surface, alike, np.array([0.0, 1, 0])).any(), "they share a place"


def test_a_repetition_and_a_mixture_say_how_far_in_ranges_of_the_others():
    """Motions as far as 2, 4 and 1; shares of norms become shares of ranges."""
    norm = np.array([2.0, 4.0, 1.0])
    explanations = (
        Explanation(np.array([1]), np.array([0.8]), 1.0), None, Explanation(np.array([1, 0]), np.array([0.9, 0.5]), 1.0)
    )  # fmt: skip
    basis = Basis(np.array([False, True, False]), explanations)
    one, mixed = (_composite(i, basis, norm) for i in (0, 2))
    assert (one.kind, one.parts, one.amount, one.explained_by) == ("repetition", (1,), 0.5, ((1, 0.4),))
    assert (mixed.kind, mixed.parts, mixed.amount) == ("mixture", (1, 0), 1.0)
    assert mixed.explained_by == ((1, 0.225), (0, 0.25))
    assert _composite(1, basis, norm).parts == ()
