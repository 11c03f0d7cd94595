"""usdrigui.layer.skin_binding: which joints carry what, worked out by hand on small skeletons."""

from dataclasses import replace

import makers
import numpy as np
import pytest
from makers import layout

from usdrigui.character import Control, Joint, Skeleton, Skin
from usdrigui.errors import RigUIError
from usdrigui.layer.skin_binding import PointShape, SkinBinding
from usdrigui.model import Element, Member

PARENTS = [-1, 0, 1, 1, -1]
"""Hips, head, jaw and eye below the head, and a prop with a root of its own."""
HIPS, HEAD, JAW, EYE, PROP = range(5)


def joint(index, parent, offset=(0.0, 1.0, 0.0)):
    matrix = np.eye(4)
    matrix[3, :3] = offset
    bind = np.eye(4)
    step = index
    while step >= 0:
        bind[3, :3] += offset
        step = PARENTS[step]
    return Joint(f"j{index}", 0, parent, bind, matrix, matrix)


def turning(name, joints, angle=0.5):
    """A control that turns joints about x."""
    turns = np.zeros((2, len(joints), 3))
    turns[1, :, 0] = angle
    drive = makers.drive(joints=joints, turns=turns)
    return Control(name, name, "joint", name, 0.0, 0.0, 1.0, "default", drive)


def rig(weights, to_root=None, controls=None, **skin):
    """The mask with every point skinned to `weights` {joint: weight}."""
    face = makers.face(9, 11)
    count = len(face.body.meshes[0].points)
    joints = np.tile(list(weights), (count, 1))
    shares = np.tile([*map(float, weights.values())], (count, 1))
    bound = Skin(joints, shares, "classicLinear", np.eye(4), False)
    skeleton = Skeleton("/Root/Skel", "/Root/anim", np.eye(4) if to_root is None else to_root)
    return makers.changed(
        face,
        meshes=(makers.changed(face.body.meshes[0], skin=replace(bound, **skin)),),
        skeletons=(skeleton,),
        joints=tuple(joint(i, parent) for i, parent in enumerate(PARENTS)),
        controls=face.controls if controls is None else controls,
    )


def element(names, point=60, adapt="deform", beside=False):
    members = tuple(Member(name, np.array([0.0, 1.0]), np.array([[0.0, 0, 0], [0, 1, 0]]), 1.0, 1.0) for name in names)
    return Element(
        name="e",
        kind="slider",
        members=members,
        anchor=makers.anchor(makers.face(9, 11), point, np.zeros(3), on_board=beside),
        label="e",
        side="none",
        adapt=adapt,
    )


def test_a_shape_bends_at_its_in_betweens_and_goes_on_beyond():
    shape = PointShape(0, np.array([-0.5, 0.5, 1.0]), np.array([[-1.0, 0, 0], [0, 1, 0], [0, 3, 0]]))
    wanted = {0.0: (0, 0, 0), 0.25: (0, 0.5, 0), 0.75: (0, 2, 0), 1.5: (0, 5, 0), -0.25: (-0.5, 0, 0), -1: (-2, 0, 0)}
    for weight, offset in wanted.items():
        assert np.allclose(shape.at(weight), offset), weight


def test_a_skeleton_that_collapses_space_is_refused():
    made = rig({HEAD: 1.0}, np.diag([1.0, 1, 0, 1]))
    with pytest.raises(RigUIError, match="SKELETON_INVALID"):
        SkinBinding(made, layout(made, element(["chin"])))


def test_the_board_hangs_on_what_none_of_its_controls_turns():
    made = rig({JAW: 1.0}, controls=(turning("nod", [HEAD]), turning("chew", [JAW]), turning("walk", [HIPS])))
    nod, chew = (replace(element([name], beside=True), name=name) for name in ("nod", "chew"))
    skin = SkinBinding(made, layout(made, nod, chew))
    assert [skin.at_anchor(each).track.joints.tolist() for each in (nod, chew)] == [[HIPS], [HIPS]]
    alone = SkinBinding(made, layout(made, chew))
    assert alone.at_anchor(chew).track.joints.tolist() == [HEAD]
