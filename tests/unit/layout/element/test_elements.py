"""Elements: members, tracks, base pose."""

import chain
import makers
import numpy as np
from makers import POINTS, SHAPES


def test_every_control_has_exactly_one_member():
    line = chain.lay_out(makers.face_with(whole=np.full_like(POINTS, 0.2), empty=np.zeros_like(POINTS)))
    members = [member.control for element in line.layout.elements for member in element.members]
    assert sorted(members) == sorted({*SHAPES, "whole"})
    assert [each.control for each in line.layout.left_off] == ["empty"]


def test_tracks_pass_through_the_anchor_at_the_base_value():
    line = chain.lay_out(makers.face(ranges={"pucker": (-0.5, 1.0)}))
    for element in line.layout.elements:
        for member in element.members:
            at = member.track[np.argmin(np.abs(member.values))]
            assert np.allclose(at, element.anchor.position, atol=1e-6)


def test_proxies_draw_the_hidden_trajectory_at_the_visible_anchor():
    line = chain.lay_out(makers.face_with_teeth(), chain.settings(controls={"teeth": {"place": "proxy"}}))
    element = chain.by_name(line)["teeth"]
    assert element.anchor.mesh == "/Root/mesh"
    assert np.allclose(element.members[0].track[1] - element.members[0].track[0], 0.1, atol=1e-6)


def test_the_base_pose_moves_anchors_and_is_recorded():
    values = np.zeros(12)
    values[8] = 1.0
    line = chain.lay_out(makers.face(), base_values=values)
    pucker = chain.by_name(line)["pucker"]
    moved = POINTS[pucker.anchor.point] + SHAPES["pucker"][pucker.anchor.point]
    assert np.allclose(pucker.anchor.position, moved, atol=1e-6)
    assert line.layout.base_values[8] == 1.0
    assert np.allclose(pucker.members[0].track[-1], moved, atol=1e-6)


def test_the_reason_of_a_mirror_copy_names_the_controls_of_its_own_side():
    more = {f"again_{side}": 0.5 * SHAPES[f"smile_{side}"] for side in "LR"}
    layout = chain.by_name(chain.lay_out(makers.face_with(**more)))
    for side in "LR":
        assert layout[f"again_{side}"].reason == f"does the same as smile_{side}, 50% as far"
