"""A canonical face laid over a character by its motions alone."""

from dataclasses import replace

import chain
import limbs
import makers
import numpy as np
import pytest
import rig_copies
from makers import POINTS, QUADS

from usdrigui.conventions import meanings
from usdrigui.layout.canonical_face import Expectation, expectations

PLACES = {
    "eyeBlink": (0.5, 0.0), "browOuterUp": (0.75, 0.25), "mouthSmile": (0.42, -1.0), "noseSneer": (0.24, -0.55),
    "cheekSquint": (0.6, -0.35),
}  # fmt: skip
SCALE, HEIGHT = 0.6, 0.35
SIDES = (("L", 1.0), ("R", -1.0)), (("R", 1.0), ("L", -1.0))
"""As they are called, and swapped."""


def at(x, y):
    return makers.bump(POINTS, (SCALE * x, HEIGHT + SCALE * y), (0.1, 0.3, 1.0), 0.12, 0.05)


def shapes(swapped=False):
    found = {f"{name}_{side}": at(sign * x, y) for name, (x, y) in PLACES.items() for side, sign in SIDES[swapped]}
    return found | {"jawOpen": at(0.0, -1.5)}


def expected(shapes, **settings):
    rig = makers.rig(POINTS, QUADS, shapes)
    face = chain.face_of(rig, chain.settings(**settings))
    names = rig.control_names
    return face, dict(
        zip(names, expectations(face.trajectories, face.symmetry, face.views, meanings(names)), strict=True)
    )


@pytest.mark.parametrize("swapped", [False, True], ids=["as-named", "sides-swapped"])
def test_controls_are_expected_where_they_act_on_whichever_side_their_names_put_them(swapped):
    face, found = expected(shapes(swapped))
    for motion in face.trajectories.motions:
        peak = face.surface.points[[motion.points[np.argmax(motion.arc_length)]]]
        assert found[face.control_name(motion.control)].distance(peak)[0] < 0.2


UNITS = {"eyeBlink": 43, "browOuterUp": 2, "mouthSmile": 12, "noseSneer": 9, "cheekSquint": 6, "jawOpen": 26}


def test_numbers_are_action_units_only_where_most_of_them_act_where_these_do():
    """The tools' counted names are no units, with a gap after a target that was deleted neither."""
    units = {f"{name[-1] if '_' in name else ''}{UNITS[name.split('_')[0]]}": each for name, each in shapes().items()}
    assert set(meant(units)) == {*units}
    for prefix in ("Key ", "target", "shape_0"):
        counted = {f"{prefix}{i + (i > 4)}": each for i, each in enumerate(shapes().values(), 1)}
        assert not meant(counted)


def test_words_that_mostly_stand_elsewhere_than_they_act_mean_nothing():
    names = list(shapes())
    assert meant(dict(zip(names, [shapes()[name] for name in names[5:] + names[:5]], strict=True))) == []


def test_words_of_what_is_high_that_move_what_is_low_mean_nothing():
    turned = {f"{name}_{side}": at(sign * x, -1.25 - y) for name, (x, y) in PLACES.items() for side, sign in SIDES[0]}
    assert meant(turned) == []


def test_what_moves_both_sides_alike_is_not_the_control_of_one():
    assert "browUp_L" not in meant(shapes() | {"browUp_L": at(0.5, 0.28) + at(-0.5, 0.28)})


def meant(shapes):
    """The names that are read, as the motions bear them out."""
    rig = makers.rig(POINTS, QUADS, shapes)
    face = chain.face_of(rig)
    return [face.control_name(i) for i, meaning in enumerate(face.meanings) if meaning is not None]


def test_the_brow_is_expected_above_its_eye_however_long_the_muzzle_and_high_the_ears():
    low = {name: at(x, y - 1.0) for name, (x, y) in (("jawOpen", (0.0, -1.5)), ("mouthSmile_L", (0.42, -1.0)))}
    ears = {f"browUp_{side}": at(sign * 0.5, 0.28) + at(sign * 0.5, 1.3) for side, sign in SIDES[0]}
    _, found = expected({**shapes(), **low, **ears})
    above = np.array([[SCALE * 0.5, HEIGHT + SCALE * 0.28, 0.0]])
    assert found["browUp_L"].distance(above)[0] < 0.15


def test_names_are_believed_of_a_face_whose_ears_swing_with_its_brows_and_its_smile():
    swinging = shapes() | {
        f"{name}_{side}": at(sign * x, y) + 2.5 * at(sign * 0.5, 1.05)
        for name, (x, y) in PLACES.items() if name != "eyeBlink" for side, sign in SIDES[0]
    }  # fmt: skip
    assert meant(swinging) == [*swinging]
    smile = chain.set_of(chain.with_candidates(makers.rig(POINTS, QUADS, swinging)), "mouthSmile_L")
    assert max(POINTS[smile.points, 1]) < 0.0


def test_numbers_that_count_joints_are_no_action_units():
    counted, _ = rig_copies.renamed(limbs.whole_body(), rig_copies.numbers())
    assert {*chain.face_of(counted).meanings} == {None}


def test_one_control_in_the_wrong_place_does_not_move_the_others():
    odd = shapes() | {f"noseSneer_{side}": at(sign * 0.3, 0.6) for side, sign in SIDES[0]}
    _, found = expected(odd)
    assert found["mouthSmile_L"].distance(np.array([[SCALE * 0.42, HEIGHT - SCALE, 0.0]]))[0] < 0.3
    brow = np.array([[SCALE * 0.3, HEIGHT + 0.6 * SCALE, 0.0]])
    assert found["noseSneer_L"].distance(brow)[0] > 0.8


def test_lashes_with_controls_of_their_own_do_not_say_where_the_mouth_is():
    faint = {
        f"{mesh}_{name}": 0.02 * at(0.5 if name.endswith("_L") else -0.5, 0.1)
        for mesh in ("lashes", "shell")
        for name in shapes()
    }
    _, found = expected(shapes() | faint)
    assert found["mouthSmile_L"].distance(np.array([[SCALE * 0.42, HEIGHT - SCALE, 0.0]]))[0] < 0.2


def test_a_control_stands_where_it_is_expected_though_it_peaks_elsewhere():
    lifted = {f"noseSneer_{s}": at(sign * 0.24, -0.55) + 1.5 * at(sign * 0.2, 0.3) for s, sign in SIDES[0]}
    line = chain.with_candidates(makers.rig(POINTS, QUADS, shapes() | lifted))
    assert (POINTS[chain.set_of(line, "noseSneer_L").points][:, 1] < HEIGHT).all()


def test_names_that_say_too_little_expect_nothing():
    _, found = expected({"a": at(0.5, 0.0), "b": at(-0.5, 0.0), "jawOpen": at(0.0, -1.5)})
    assert set(found.values()) == {None}


def test_what_opens_the_jaw_is_known_by_its_motion_where_others_have_names():
    named = shapes()
    del named["jawOpen"]
    named["target7"] = makers.bump(POINTS, (0.0, -0.55), (0.0, -1.0, 0.2))
    assert "target7" in meant(named)


def test_the_mirrored_place_is_as_good_where_both_sides_are_expected():
    points = np.array([[2.0, 0, 0], [-2.0, 0, 0], [-3.0, 0.5, 0]])
    both = Expectation(np.eye(3)[:2], np.zeros(3), np.array([2.0, 1.0]), np.array([1.0, 0.5]), True, 1.0)
    assert both.distance(points) == pytest.approx([0.5, 0.5, 0.5])
    assert replace(both, both_sides=False).distance(points) == pytest.approx([0.5, np.hypot(2, 0.5), 2.5])
