"""Front, sides and pairs of characters whose surface does not tell them: robots, and rigs that rest in a pose."""

import re
from dataclasses import replace

import chain
import limbs
import numpy as np
import pytest
import rig_copies
from makers import changed

from usdrigui.character.deform import posed
from usdrigui.character.skinning import base_locals, in_skeleton_space
from usdrigui.layout.symmetry.sides_of_joints import legs_point, mirrored_joints
from usdrigui.model import MirrorPlane
from usdrigui.pipeline import stages
from usdrigui.settings import Settings

ACROSS = MirrorPlane(np.zeros(3), np.array([1.0, 0.0, 0.0]))


def robot(swapped=False):
    """Arms along x with joints named L and R, so unlike that the plane between front and back mirrors better; wheels
    before and behind make the profile its widest side."""
    at = {"hips": (0, 0, 0), "hips/chest": (0, 1, 0), "hips/front": (0, 0, 1.5), "hips/rear": (0, 0, -1.5)}
    for side, name in ((1, "R" if swapped else "L"), (-1, "L" if swapped else "R")):
        for k, x in enumerate((0.3, 0.7, 1.0)):
            drop = 0.02 * k if side > 0 else 0.0
            at["hips/chest/" + "/".join(f"arm{i}_{name}" for i in range(k + 1))] = (side * x, 1.0 - drop, 0)
    names = sorted(at, key=lambda path: (path.count("/"), path))
    made = limbs.skeleton_rig(names, np.array([at[name] for name in names], float))
    return limbs.with_default_controls(made)


def renamed(made, spelt):
    """The rig with each part of its joints' paths as `spelt` gives it, of the number of the joint and the part."""
    joints = (
        replace(joint, path="/".join(spelt(i, part) for part in joint.path.split("/")))
        for i, joint in enumerate(made.body.joints)
    )
    return changed(made, joints=tuple(joints))


def twins(face):
    names = face.rig.control_names
    return {name: names[twin] for name, twin in zip(names, face.symmetry.twins.tolist(), strict=True) if twin >= 0}


def test_a_robot_is_mirrored_between_the_joints_named_left_and_right():
    face = chain.face_of(robot())
    assert face.symmetry.plane.normal == pytest.approx([1.0, 0.0, 0.0], abs=0.05)
    assert face.views.ahead == pytest.approx([0.0, 0.0, 1.0], abs=0.05)
    assert twins(face)["arm0_L:rx"] == "arm0_R:rx"


@pytest.mark.parametrize(
    "spelt",
    [
        lambda i, name: f"{name}_{i:02d}",
        lambda _, name: re.sub(r"arm(\d)_(.)", r"rig_\2Arm\1", name).replace("_L", "_Left").replace("_R", "_Right"),
    ],
    ids=["counted by an exporter", "capitals part the words"],
)
def test_names_of_joints_tell_their_sides_however_they_are_spelt(spelt):
    face = chain.face_of(limbs.with_default_controls(renamed(robot(), spelt)))
    assert face.symmetry.plane.normal == pytest.approx([1.0, 0.0, 0.0], abs=0.05)


def test_the_names_tell_which_side_is_left_where_nothing_else_does():
    assert chain.face_of(robot(swapped=True)).views.ahead == pytest.approx([0.0, 0.0, -1.0], abs=0.05)


def with_sides(made):
    """The body whose arms and legs have sides in their names, with the controls of its joints."""
    sides = {"a": "l_arm", "b": "r_arm"}
    return limbs.with_default_controls(renamed(made, lambda _, part: sides.get(part[0], part[0]) + part[1:]))


@pytest.mark.parametrize("made", [lambda rig: rig, limbs.smiling])
def test_names_of_joints_tell_the_front_before_hair_behind_the_head(made):
    """Also where a blend shape moves skin that faces every way."""
    found = stages.character_of(made(with_sides(limbs.whole_body(ahead=-1.0))), Settings())
    assert found.symmetry.plane.normal == pytest.approx([1.0, 0.0, 0.0], abs=0.05)


def test_a_character_that_rests_in_a_pose_has_the_pairs_of_its_bind_pose():
    rig = limbs.whole_body()
    plain, posed = chain.face_of(rig), chain.face_of(limbs.anyhow(rig, 5))
    assert twins(plain)["a0:rx"] == "b0:rx"
    assert len(twins(posed)) >= 0.9 * len(twins(plain))


def test_a_joint_owns_in_a_pose_what_it_owns_at_the_bind_pose_and_the_middle_lies_where_it_lies_there():
    """In a pose an arm lies on a belly, and the middle of a twisted trunk is no plane."""
    rig = limbs.whole_body()
    plain, posed = (stages.character_of(each, Settings()) for each in (rig, limbs.anyhow(rig, 5)))
    assert posed.symmetry.apart == pytest.approx(plain.symmetry.apart, abs=1e-6)
    for one, other in zip(plain.trajectories.motions, posed.trajectories.motions, strict=True):
        assert np.interp(one.points, other.points, other.owned) == pytest.approx(one.owned, abs=1e-6)


@pytest.mark.parametrize("turns", [{"a0": (0, 0, 1.2), "b0": (0, 0, 1.2)}, {"s": (0, 0, 0.4)}])
def test_a_body_in_a_pose_has_the_pairs_and_sides_of_its_bind_pose(turns):
    """One arm up and one down, a trunk that leans: also where no name tells a side."""
    bound, posed = (
        {
            member.control: each.side
            for part in chain.laid_parts(rig)
            for each in part.layout.elements
            if each.mirror
            for member in each.members
        }
        for rig in (limbs.whole_body(), limbs.resting(limbs.whole_body(), turns))
    )
    assert posed.items() <= bound.items()
    assert len(posed) >= 42


def test_joints_mirror_as_a_tree_whatever_their_names_say():
    """No joint of the spine is the image of another, nor a hand that of a shoulder where arms are counted apart."""
    rig = limbs.whole_body()
    names = [joint.name for joint in rig.body.joints]
    known = {
        name: names[image]
        for name, image in zip(names, map(mirrored_joints(rig.body, ACROSS).get, range(99)), strict=False)
        if image is not None
    }
    assert known["a0"] == "b0"
    assert known["h"] == "h"
    assert known.keys() == set(names)
    counts = {"a0": "L1", "a1": "L0", "b0": "R0", "b1": "R1"}
    counted = renamed(rig, lambda _, part: counts.get(part, f"j{names.index(part)}"))
    assert mirrored_joints(counted.body, ACROSS) == mirrored_joints(rig.body, ACROSS)


def test_controls_of_unpaired_joints_are_no_twins_however_alike_they_move():
    """Two joints of a spine at nearly one place turn alike."""
    rig = limbs.with_default_controls(limbs.whole_body())
    face = chain.face_of(rig)
    images = mirrored_joints(rig.body, face.symmetry.plane)
    of = [int(control.drive.joints[0]) for control in rig.controls]
    pairs = [(of[i], of[twin]) for i, twin in enumerate(face.symmetry.twins.tolist()) if twin >= 0]
    assert pairs
    assert all(images[a] == b for a, b in pairs)


@pytest.mark.parametrize("world", ["on its back", "on its belly", "on a side", "nodding"])
def test_a_body_that_lies_is_up_where_its_legs_are_not(world):
    body, rotation = limbs.whole_body(), rig_copies.WORLDS[world](np.random.default_rng(3))
    up = rotation @ body.up if world.startswith("on ") else body.up
    assert np.allclose(stages.character_of(rig_copies.turned(body, rotation), Settings()).rig.up, up)


def test_arms_that_are_spread_do_not_tell_which_way_is_up():
    assert not legs_point(robot().body, ACROSS).any()


def test_arms_that_hang_beside_a_trunk_without_legs_are_no_legs():
    at = {"h": (0, 0, 0), "h/s": (0, 1, 0), "h/s/e": (0, 1.5, 0)}
    for side, name in ((1, "a"), (-1, "b")):
        limbs.hang(at, "h/s", name, [(0.3 * side, 1.2 - 0.5 * k, 0.6 * k) for k in range(3)])
    made = limbs.skeleton_rig(*limbs.by_depth(at))
    assert not legs_point(made.body, ACROSS).any()
    assert legs_point(limbs.whole_body().body, ACROSS) == pytest.approx([0.0, -1.0, 0.0])


def modelled(rig):
    """A character bound, as it is modelled, in the pose in which this one rests."""
    world = in_skeleton_space(rig.body.joints, base_locals(rig.body.joints))
    joints = tuple(replace(joint, bind=at) for joint, at in zip(rig.body.joints, world, strict=True))
    (mesh,), points = rig.body.meshes, posed(rig, None).points
    return changed(rig, joints=joints, meshes=(changed(mesh, points=points),))


@pytest.mark.parametrize("turn", [(0.0, 0.0, 0.2), (0.0, 0.6, 0.0)])
@pytest.mark.parametrize("mirrors", [True, False])
def test_an_arm_in_a_pose_loses_no_handle_and_no_mirror_that_the_bind_pose_shows(turn, mirrors):
    rests = limbs.resting(with_sides(limbs.whole_body()), {"l_arm0": turn})
    parts = chain.laid_parts(rests if mirrors else modelled(rests))
    elements = {each.name: each for part in parts for each in part.layout.elements}
    aside = {name for name, each in elements.items() if each.anchor.on_board}
    assert aside == {"l_arm2:rx", "r_arm2:rx"}, "too crowded, as it is upright"
    assert (elements["l_arm0:ry_l_arm0:rz"].mirror == "r_arm0:ry_r_arm0:rz") == mirrors
