"""A symmetric control with two lobes gets a handle on each, both of one value."""

from dataclasses import replace

import chain
import limbs
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES

from usdrigui.character import Skin

NAMED = (("eyeBlink", 0.3, 0.35), ("browOuterUp", 0.45, 0.5), ("mouthSmile", 0.25, -0.45), ("noseSneer", 0.15, 0.0))
SIDED = (("L", 1.0), ("R", -1.0))
SIDES = {f"{a}_{s}": makers.bump(POINTS, (x * w, y), (0, 1, 0.2), 0.15) for a, x, y in NAMED for s, w in SIDED}


def elements_of(control, x, beside=(), **settings):
    lobes = sum(makers.bump(POINTS, (side * x, -0.1), (side * x, 0.0, 1.0), 0.2, 0.1) for side in (-1, 1))
    made = makers.face_with(**{control: lobes})
    line = chain.lay_out(makers.changed(made, meshes=(*made.body.meshes, *beside)), chain.settings(**settings))
    return [each for each in line.layout.elements if control in each.controls]


@pytest.mark.parametrize(("x", "count"), [(0.45, 2), (0.3, 2), (0.1275, 2), (0.12, 1), (0.05, 1)])
def test_two_lobes_off_the_plane_have_a_handle_each_and_one_lobe_stands_in_the_middle(x, count):
    found = elements_of("puff", x)
    assert len(found) == count
    assert len(elements_of("target", x)) == min(count, 1 + (x > 0.2)), "nearly in the middle, under no name"
    if count == 2:
        left, right = found
        assert left.mirror == right.name
        assert right.mirror == left.name
        assert left.anchor.position[0] == pytest.approx(-right.anchor.position[0], abs=1e-6)


def test_a_lobe_that_no_view_sees_has_no_handle():
    right = [quad for quad in QUADS if POINTS[quad, 0].max() <= 0.0]
    (found,) = elements_of("puff", 0.45, [makers.mesh(1.03 * POINTS, right, path="/Root/mask")])
    assert found.anchor.position[0] > 0.3


@pytest.mark.parametrize(("setting", "x", "count"), [("never", 0.45, 1), ("always", 0.2, 2)])
def test_the_configuration_has_the_last_word(setting, x, count):
    assert len(elements_of("puff", x, symmetry={"double_middle": setting})) == count


def test_a_double_element_without_room_on_the_face_stands_on_the_board_once():
    found = elements_of("puff", 0.45, objective={"handle_size": 0.9, "handle_size_min": 0.9})
    assert [each.anchor.on_board for each in found] == [True]


@pytest.mark.parametrize(("name", "count"), [("mouth_depression", 2), ("mouthPucker", 1)])
def test_a_name_that_tells_the_region_alone_leaves_it_to_the_motion_whether_it_has_lobes(name, count):
    """Both keep about .6 of their peak in the middle."""
    lobes = sum(makers.bump(POINTS, (w * 0.185, -0.45), (w * 0.1, 0.0, 1.0), 0.28, 0.1) for _, w in SIDED)
    line = chain.problem_of(makers.rig(POINTS, QUADS, SIDES | {"jawOpen": SHAPES["chin"], name: lobes}))
    control = line.face.rig.control_indices[name]
    group = next(each for each in line.groups if control in each.controls)
    assert line.face.expected[control] is not None
    assert len(group.copies) == count


def test_a_control_that_is_expected_on_the_sides_alone_has_no_handle_on_one_of_them():
    """A clench that moves the whole jaw, the chin a little more."""
    jaw = makers.bump(POINTS, (0.0, -0.6), (0, -0.3, 1.0), 1.2, 0.1)
    line = chain.lay_out(makers.rig(POINTS, QUADS, SIDES | {"jawOpen": SHAPES["chin"], "jawClench": jaw}))
    found = [each for each in line.layout.elements if any(m.control == "jawClench" for m in each.members)]
    across = [round(each.anchor.position[0], 3) for each in found]
    assert min(across) < 0.0 < max(across)


def test_the_joint_of_both_lids_has_a_handle_on_each():
    """Of two joints the second holds what lies at the eyes."""
    lids = sum(makers.bump(POINTS, (side * 0.35, 0.35), (0, 0, 1.0), 0.15)[:, 2] for side in (-1, 1))[:, None]
    lids = np.minimum(lids / lids.max(), 1.0)
    skin = Skin(np.tile([0, 1], (len(POINTS), 1)), np.hstack([1.0 - lids, lids]), "classicLinear", np.eye(4), False)
    rig = limbs.chain_rig(2)
    rig = makers.changed(rig, meshes=(makers.mesh(POINTS, QUADS, skin=skin),))
    line = chain.lay_out(replace(rig, controls=tuple(c for c in rig.controls if c.name == "j1:rx")))
    across = sorted(round(each.anchor.position[0], 3) for each in line.layout.elements)
    assert len(across) == 2
    assert across[0] == -across[1] < -0.2
