"""The board."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, SHAPES

from usdrigui.character import Joint, Skeleton, Skin
from usdrigui.layout.board.board import _right_end
from usdrigui.layout.board.board_place import carrier_of


def test_the_board_is_tidy_and_outside_the_silhouette():
    # As in many languages, what is left comes after what is right by the names.
    more = {f"copy{9 - i}": 0.3 * each for i, each in enumerate(list(SHAPES.values())[:8])}
    line = chain.lay_out(makers.face_with(whole=np.full_like(POINTS, 0.2), **more))
    board = [element for element in line.layout.elements if element.anchor.on_board]
    assert {element.category for element in board} == {"global", "composite"}
    spots = np.array([element.anchor.position for element in board])
    width = line.layout.frame.handle_width
    tracks = np.concatenate([m.track for e in board for m in e.members])
    assert tracks[:, 0].min() > POINTS[:, 0].max() + width
    assert chain.least_apart(board) >= 1.6 * width
    assert np.ptp(spots[:, 2]) < 1e-9
    for element in board:
        assert element.reason
        for member in element.members:
            drawn = np.linalg.norm(np.diff(member.track, axis=0), axis=1).sum()
            assert drawn == pytest.approx(member.magnification * member.arc_length, rel=1e-6)
    ends = [_right_end(makers.changed(board[0], label=text), np.eye(3), width) for text in ("a", "a longer one")]
    assert ends[0] < ends[1], "the next column begins beyond the label"
    pairs = [element for element in board if element.mirror]
    for element in pairs:
        other = next(each for each in board if each.name == element.mirror)
        assert element.anchor.position[1] == pytest.approx(other.anchor.position[1])
        assert element.side == ("right", "left")[int(element.name[-1]) % 2]


def test_what_the_configuration_sends_beside_stands_under_a_heading_of_its_own():
    line = chain.lay_out(
        makers.face_with(whole=np.full_like(POINTS, 0.2)),
        chain.settings(controls={"chin": {"place": "board"}, "whole": {"place": "board"}}),
    )
    families = {name: element.category for name, element in chain.by_name(line).items() if element.anchor.on_board}
    assert families == {"chin": "requested", "whole": "global"}
    assert "decided" in chain.by_name(line)["chin"].reason
    heights = {name: chain.by_name(line)[name].anchor.position[1] for name in families}
    # A heading stands between them: a row of 2.4 widths for it and one for the element.
    assert heights["whole"] - heights["chin"] == pytest.approx(4.8 * line.layout.frame.handle_width)


def test_a_fan_on_the_board_spreads_over_the_half_circle():
    names = ["chin", "pucker", "smile_L", "brow_L"]
    said = {"controls": {name: {"place": "board"} for name in names}, "groups": {"groups": {"fan": names}}}
    fan = chain.by_name(chain.lay_out(makers.face(), chain.settings(**said)))["fan"]
    assert fan.kind == "fan"
    x, y, _ = np.array([member.track[-1] - member.track[0] for member in fan.members]).T
    assert np.degrees(np.arctan2(y, x)) == pytest.approx([0.0, 45.0, 90.0, 135.0], abs=0.1)


def test_a_crowded_face_sends_the_least_displaced_controls_to_the_board():
    crowd = {
        f"c{i}": makers.bump(POINTS, (0.0, -0.2), (np.sin(i), np.cos(i), 0.3), 0.05, 0.02 + 0.01 * i) for i in range(8)
    }
    rig = makers.face_with(**crowd)
    line = chain.lay_out(rig, chain.settings(groups={"opposed": False}, candidates={"board_composite": False}))
    board = [element for element in line.layout.elements if element.anchor.on_board]
    assert board
    assert {element.category for element in board} == {"crowded"}
    assert all(element.reason for element in board)
    peaks = {rig.controls[m.control].name: m.arc_length.max() for m in line.face.trajectories.motions}
    left = [peaks[m.control] for e in board for m in e.members]
    stayed = [peaks[m.control] for e in line.layout.elements if not e.anchor.on_board for m in e.members]
    assert np.mean(left) < np.mean(stayed)
    assert all(member.control.startswith("c") for element in board for member in element.members)


def test_the_board_hangs_on_the_joint_that_holds_the_face():
    rig = makers.face_with(whole=np.full_like(POINTS, 0.2))
    head = (POINTS[:, 1] > -0.9).astype(float)
    skin = Skin(
        np.tile([0, 1], (len(POINTS), 1)), np.stack([1.0 - head, head], axis=1), "classicLinear", np.eye(4), False
    )
    joints = tuple(
        Joint(name, 0, parent, np.eye(4), np.eye(4), np.eye(4)) for name, parent in (("neck", -1), ("neck/head", 0))
    )
    mesh = makers.changed(rig.body.meshes[0], skin=skin)
    rig = makers.changed(rig, meshes=(mesh,), joints=joints, skeletons=(Skeleton("/Root/skel", "", np.eye(4)),))
    line = chain.lay_out(rig)
    whole = chain.by_name(line)["whole"]
    assert head[whole.anchor.point] == 1.0


def test_a_handle_on_the_board_hangs_where_the_animation_of_its_control_can_slide_it():
    """Exporters give a mouth a Skeleton and a SkelAnimation of its own: the weights of another do not reach a mesh."""
    meshes = [makers.mesh(np.eye(3), [[0, 1, 2]], [makers.shape(i, np.ones((3, 3)))]) for i in range(2)]
    rig = makers.rig_of_meshes(meshes, ["chin", "viseme_a"])
    channels = tuple(makers.changed(each, animation=each.token) for each in rig.body.channels)
    skeletons = tuple(Skeleton("/Skel", each.token, np.eye(4)) for each in channels)
    rig = makers.changed(rig, channels=channels, skeletons=skeletons)
    assert [carrier_of(rig, [i], np.array([5, 0, 4])) for i in range(2)] == [0, 5]
