"""Partial layouts: anchors that are fixed."""

import chain
import makers
import pytest

from usdrigui.errors import RigUIError


def test_fixed_anchors_stay_and_unfold_their_pair():
    controls = {"brow_L": {"anchor": "/Root/mesh#914"}, "brow_R": {"follow_twin": False}}
    line = chain.lay_out(makers.face(), chain.settings(controls=controls))
    elements = chain.by_name(line)
    assert elements["brow_L"].anchor.point == 914
    assert elements["brow_R"].anchor.point != line.face.symmetry.partner[914]


POINTS, QUADS = makers.mask()


SHAPES = makers.face_shapes(POINTS)


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
    controls = [control.name for control in line.face.rig.controls]
    categories = {controls[c]: group.category for group in line.groups for c in (*group.controls, *group.mirror)}
    assert categories[one] == "requested"
    assert not categories[other]
