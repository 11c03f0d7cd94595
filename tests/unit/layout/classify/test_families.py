"""Families stand together: all of them on the face or none."""

import chain
import makers
import numpy as np
from makers import POINTS, QUADS, SHAPES

from usdrigui.conventions import meanings
from usdrigui.layout.classify.families import find_families


def categories(shapes):
    found = chain.measured(makers.rig(POINTS, QUADS, shapes))
    rig, motions = found.face.rig, found.face.trajectories.motions
    return {rig.controls[m.control].name: c for m, c in zip(motions, found.classification, strict=True)}


def visemes():
    """Five mouth shapes: three that the face's other controls make, two of their own."""
    mouth, smile = SHAPES["pucker"], SHAPES["smile_L"] + SHAPES["smile_R"]
    own = [makers.bump(POINTS, (x, -0.55), (0.3, 1, 0), 0.2, 0.05) for x in (-0.1, 0.1)]
    made = [mouth + smile, mouth + 0.5 * SHAPES["chin"], smile + SHAPES["chin"]]
    return dict(zip(("viseme_aa", "viseme_E", "viseme_ih", "viseme_oh", "viseme_ou"), made + own, strict=True))


def test_visemes_leave_the_face_together_where_others_make_them():
    found = categories(SHAPES | visemes())
    assert {found[name].category for name in visemes()} == {"viseme"}
    assert all("visemes are grouped on the board" in found[name].off_face_reason for name in visemes())
    assert all(not found[name].category for name in SHAPES)


def test_visemes_stay_together_where_they_are_the_only_controls_of_the_mouth():
    upper = {name: shape for name, shape in SHAPES.items() if name.startswith(("brow", "sneer"))}
    found = categories(upper | visemes())
    assert {found[name].category for name in visemes()} == {""}


def moods():
    """Angry moves most of the face, the others some; brows and mouth have moods of their own."""
    brow, mouth = SHAPES["brow_L"] + SHAPES["brow_R"], SHAPES["pucker"] + SHAPES["chin"]
    parts = {"Fcl_BRW_Joy": brow, "Fcl_MTH_Joy": mouth, "Fcl_MTH_Fun": SHAPES["smile_L"] + SHAPES["smile_R"]}
    whole = {"Fcl_ALL_Angry": brow + mouth, "Fcl_ALL_Joy": mouth, "Fcl_ALL_Fun": 0.5 * brow + mouth}
    return parts, whole


def test_moods_of_the_whole_face_leave_it_together_where_moods_of_its_parts_make_them():
    parts, whole = moods()
    found = categories(parts | whole)
    assert {found[name].category for name in whole} == {"emotion"}
    assert not any(found[name].category for name in parts)


def test_one_wide_mood_does_not_leave_the_others_on_the_face():
    own = [makers.bump(POINTS, (x, y), (0.3, 1, 0), 0.2, 0.05) for x, y in ((0, -0.6), (0, 0.2), (0, 0.7))]
    whole = dict(zip(("Joy", "Sorrow", "Angry"), own, strict=True))
    found = categories(SHAPES | whole | {"Angry": np.full_like(POINTS, 0.05) + own[2] * [1, 0.2, 0]})
    assert len({found[name].category for name in whole}) == 1


def test_a_product_of_two_names_is_a_combination():
    both = makers.bump(POINTS, (0.1, -0.5), (0, 0.2, 1), 0.15, 0.04)
    found = categories(SHAPES | {"chin_pucker": both, "chin_other": -both})
    assert found["chin_pucker"].category == "combination"
    assert found["chin_other"].category != "combination"


def test_products_of_sided_names_share_the_side_and_may_be_glued():
    names = ["facs_bs_jawOpen", "facs_bs_browDown_L", "facs_bs_eyeBlink_L", "facs_bs_browInnerUp", "facs_bs_mouthLeft"]
    products = ["facs_cbs_browDown_eyeBlink_L", "facs_cbs_jawOpenEyeBlink_L", "facs_cbs_jawOpen_mouthLeft"]
    every = [*names, *products, "facs_bs_mouthOpen"]
    for lost in ([], names[:1]):  # one that was left off is none of the controls, and was combined all the same
        known = [each for each in every if each not in lost]
        found = find_families(known, meanings(known), np.eye(len(known)), lost)
        assert [[known[i] for i in each.members] for each in found] == [products]
