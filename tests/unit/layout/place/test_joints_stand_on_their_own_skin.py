"""Laws: the control of a joint stands on the skin that the joint owns, between it and the next joint."""

from dataclasses import replace

import chain
import limbs
import numpy as np
import pytest
import rig_copies
from makers import changed

from usdrigui.character import Joint
from usdrigui.layout.motion.owned_skin import BoundSkin, owned_skin


def candidates(rig, **parts):
    """Height of every candidate of each control."""
    found = chain.with_candidates(rig, chain.settings(**parts))
    base = found.face.surface.points
    return {c.name: base[chain.set_of(found, c.name).points] for c in rig.controls}


@pytest.mark.parametrize("bones", [2, 4])
def test_the_control_of_a_joint_stands_along_its_own_bone(bones):
    for name, points in candidates(limbs.chain_rig(bones)).items():
        joint = int(name[1])
        assert np.ptp([joint, joint + 1, *points[:, 1]]) == 1.0, name


def test_skin_just_at_a_limit_is_owned_alike_in_a_tilted_world():
    """Points at every tenth of a bone."""
    rig = limbs.chain_rig(3)
    (mesh,) = rig.body.meshes
    rig = changed(rig, meshes=(changed(mesh, points=0.8 * mesh.points),))
    tilted = rig_copies.turned(rig, rig_copies.WORLDS["tilted"](np.random.default_rng(0)))
    assert np.allclose(*(owned_skin(BoundSkin(each), rig.controls[0]) for each in (rig, tilted)))


@pytest.mark.parametrize("late", [0.8, -0.6])
def test_skin_by_another_bone_counts_less_than_how_firmly_it_is_held(late):
    """Most of the skin of each joint lies by the bone of the next one, or of the one before it."""
    found = candidates(limbs.chain_rig(4, late=late))
    middle = (1, 2) if late > 0.0 else (1, 2, 3)  # before the first bone there is none
    for joint in middle:
        for axis in "xyz":
            assert np.ptp([joint, joint + 1, *found[f"j{joint}:r{axis}"][:, 1]]) <= 1.05, (joint, axis)


def test_a_joint_whose_skin_hangs_on_a_twist_joint_stands_along_its_own_bone():
    """The next joint has skin of its own, which moves further."""
    rig = limbs.chain_rig(3)
    world, local = rig.body.joints[1].bind.copy(), np.eye(4)
    world[3, 1] += 0.4
    local[3, 1] = 0.4
    twist, (mesh,) = Joint("j0/j1/t", 0, 1, world, local, local), rig.body.meshes
    skin = replace(mesh.skin, joints=np.where(mesh.skin.joints == 1, 3, mesh.skin.joints))
    rig = changed(rig, joints=(*rig.body.joints, twist), meshes=(changed(mesh, skin=skin),))
    found = candidates(rig)
    for axis in "xyz":
        assert np.ptp([1, 2, *found[f"j1:r{axis}"][:, 1]]) == 1.0, axis


def test_near_asks_before_pruning_does():
    """Skin of the first bone near its joint hardly moves: pruning would leave none of it."""
    near = {"near": "/Root/mesh#12", "within": 0.1}
    rig = limbs.chain_rig(3)
    found, points = candidates(rig, controls={"j0:rz": near, "j0:rx": near}), rig.body.meshes[0].points
    for name in ("j0:rz", "j0:rx"):
        apart = np.linalg.norm(found[name] - points[12], axis=1)
        assert apart.max() <= 0.1 * np.ptp(points[:, 1]), name


def test_the_spine_does_not_leave_the_character_for_what_it_carries():
    found = chain.measured(limbs.chain_rig(4))
    assert [each.category for each in found.classification] == [""] * 12


def test_a_joint_that_is_its_own_mirror_image_stands_on_the_plane():
    """The sides of a trunk, wider than deep, move twice as far when it twists as its belly does."""
    rig = limbs.chain_rig(4)
    points = rig.body.meshes[0].points * [2.0, 1.0, 1.0]
    wide = replace(rig.body.meshes[0], points=points * np.where(points[:, 2:] < 0.0, [1.0, 1.0, 0.8], 1.0))
    line = chain.lay_out(changed(rig, meshes=(wide,)))
    symmetry, anchors = line.face.symmetry, [each.anchor.point for each in line.layout.elements]
    assert symmetry.twins.tolist() == list(range(len(rig.controls)))
    assert min(anchors) >= 0
    apart = (line.face.surface.points[anchors] - symmetry.plane.origin) @ symmetry.plane.normal
    assert np.abs(apart).max() <= 0.5 * line.face.handle_width


def test_a_helper_at_the_origin_is_no_end_of_a_bone():
    """Importers leave joints without skin at the origin; a line to there runs along the whole trunk."""
    rig = limbs.chain_rig(5)
    away = np.linalg.inv(rig.body.joints[4].bind)
    helper = Joint(f"{rig.body.joints[4].path}/h", 0, 4, np.eye(4), away, away)
    plain, helped = candidates(rig), candidates(changed(rig, joints=(*rig.body.joints, helper)))
    for name, points in plain.items():
        np.testing.assert_array_equal(helped[name], points, name)
