"""Partial layouts: anchors that are fixed."""

from types import SimpleNamespace

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, SHAPES

from usdrigui.errors import RigUIError
from usdrigui.layout.group.own_places import has_own_place
from usdrigui.layout.reuse.prior_layout import Place, PriorLayout
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import MirrorPlane
from usdrigui.settings import ControlSettings


@pytest.mark.parametrize(
    ("said", "mirrored"),
    [
        ({"brow_L": {"anchor": "/Root/mesh#914"}}, True),
        ({"brow_L": {"anchor": "/Root/mesh#914"}, "brow_R": {"place": "face"}}, False),
        ({"brow_L": {"anchor": "/Root/mesh#914"}, "brow_R": {"follow_twin": False}}, False),
        ({"brow_L": {"anchor": "/Root/mesh#914", "twin": "none"}}, False),
    ],
)
def test_fixed_anchors_stay_and_fix_the_twin_unless_set_otherwise(said, mirrored):
    line = chain.lay_out(makers.face(), chain.settings(controls=said))
    elements = chain.by_name(line)
    assert elements["brow_L"].anchor.point == 914
    partner = np.argmin(np.linalg.norm(POINTS - POINTS[914] * [-1, 1, 1], axis=1))
    assert (elements["brow_R"].anchor.point == partner) == mirrored


def test_a_place_near_which_one_twin_stays_is_mirrored_for_the_other():
    place = int(np.argmin(np.linalg.norm(POINTS[:, :2] - [-0.2, 0.45], axis=1)))
    near = {"near": f"/Root/mesh#{place}", "within": 0.05}
    elements = chain.by_name(chain.lay_out(makers.face(), chain.settings(controls={"brow_R": near})))
    for name, side in (("brow_R", -1), ("brow_L", 1)):
        assert np.linalg.norm(elements[name].anchor.position[:2] - [side * 0.2, 0.45]) < 0.12, name


def test_a_fixed_anchor_is_the_only_candidate():
    found = chain.chosen(makers.face(), controls={"chin": {"anchor": "/Root/mesh#20"}})("chin")
    assert found.points.tolist() == [20]
    for anchor in ("/Root/mesh", "/Root/mesh#x", "/Root/mesh#99999", "/other#1"):
        with pytest.raises(RigUIError):
            chain.chosen(makers.face(), controls={"chin": {"anchor": anchor}})


def test_what_is_said_of_one_twin_holds_for_it_and_for_it_alone():
    names = [name for name in SHAPES if name.endswith(("_R", "Right"))]
    one = next(name for name in names if name.replace("_R", "_L").replace("Right", "Left") in SHAPES)
    other = one.replace("_R", "_L").replace("Right", "Left")
    line = chain.problem_of(makers.face_with(), chain.settings(controls={one: {"place": "board"}}))
    controls = line.face.rig.control_names
    categories = {controls[c]: group.category for group in line.groups for c in (*group.controls, *group.mirror)}
    assert categories[one] == "requested"
    assert not categories[other]


@pytest.mark.parametrize(
    ("apart", "boards", "own"),
    [
        (0.5, (False, False), False),
        (0.75, (False, False), True),
        (0.0, (True, False), True),
        (0.75, (True, True), False),
    ],
)
def test_twins_whose_places_were_mirror_images_within_half_a_handle_are_one_decision(apart, boards, own):
    symmetry = SimpleNamespace(twins=[1, 0], plane=MirrorPlane(np.zeros(3), np.array([1.0, 0.0, 0.0])))
    face = SimpleNamespace(symmetry=symmetry, handle_width=1.0)
    positions = np.array([2.0, 0, 0]), np.array([-2.0, apart, 0])
    places = {i: Place(-1, position, boards[i]) for i, position in enumerate(positions)}
    asked = (ControlSettings(), ControlSettings())
    assert has_own_place(face, Requests(asked, asked, prior=PriorLayout(places=places)), 0) is own
