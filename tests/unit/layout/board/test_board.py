"""The board."""

from dataclasses import replace
from types import SimpleNamespace

import chain
import makers
import numpy as np
import pytest

from usdrigui.layout.board.board import _directions, _right_end
from usdrigui.layout.board.board_place import face_middle

POINTS, QUADS = makers.mask()


SHAPES = makers.face_shapes(POINTS)


def test_the_board_is_tidy_and_outside_the_silhouette():
    more = {f"copy{i}": 0.3 * each for i, each in enumerate(list(SHAPES.values())[:8])}
    line = chain.lay_out(makers.face_with(whole=np.full_like(POINTS, 0.2), **more))
    board = [element for element in line.layout.elements if element.anchor.on_board]
    assert {element.category for element in board} == {"global", "composite"}
    spots = np.array([element.anchor.position for element in board])
    width = line.layout.handle_width
    tracks = np.concatenate([m.track for e in board for m in e.members])
    assert tracks[:, 0].min() > POINTS[:, 0].max() + width
    apart = np.linalg.norm(spots[:, None] - spots[None], axis=2) + 9e9 * np.eye(len(spots))
    assert apart.min() >= 1.6 * width
    assert np.ptp(spots[:, 2]) < 1e-9
    for element in board:
        assert element.reason
        for member in element.members:
            drawn = np.linalg.norm(np.diff(member.track, axis=0), axis=1).sum()
            assert drawn == pytest.approx(member.magnification * member.arc_length, rel=1e-6)
    pairs = [element for element in board if element.mirror]
    for element in pairs:
        other = next(each for each in board if each.name == element.mirror)
        assert element.anchor.position[1] == pytest.approx(other.anchor.position[1])


def test_what_the_configuration_sends_beside_stands_under_a_heading_of_its_own():
    line = chain.lay_out(
        makers.face_with(whole=np.full_like(POINTS, 0.2)),
        chain.settings(controls={"chin": {"place": "board"}, "whole": {"place": "board"}}),
    )
    families = {name: element.category for name, element in chain.by_name(line).items() if element.anchor.on_board}
    assert families == {"chin": "requested", "whole": "global"}
    assert "configuration" in chain.by_name(line)["chin"].reason
    heights = {name: chain.by_name(line)[name].anchor.position[1] for name in families}
    # A heading stands between them: a row of 2.4 widths for it and one for the element.
    assert heights["whole"] - heights["chin"] == pytest.approx(4.8 * line.layout.handle_width)


def test_a_crowded_face_sends_the_least_displaced_controls_to_the_board():
    crowd = {
        f"c{i}": makers.bump(POINTS, (0.0, -0.2), (np.sin(i), np.cos(i), 0.3), 0.05, 0.02 + 0.01 * i) for i in range(8)
    }
    rig = makers.rig(POINTS, QUADS, {**SHAPES, **crowd})
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
    from usdrigui.model import Joint, Skeleton, Skin

    rig = makers.face_with(whole=np.full_like(POINTS, 0.2))
    head = (POINTS[:, 1] > -0.9).astype(float)
    skin = Skin(
        np.tile([0, 1], (len(POINTS), 1)), np.stack([1.0 - head, head], axis=1), "classicLinear", np.eye(4), False
    )
    joints = tuple(
        Joint(name, 0, parent, np.eye(4), np.eye(4), np.eye(4)) for name, parent in (("neck", -1), ("neck/head", 0))
    )
    mesh = replace(rig.meshes[0], skin=skin)
    rig = replace(rig, meshes=(mesh,), joints=joints, skeletons=(Skeleton("/Root/skel", "", np.eye(4)),))
    line = chain.lay_out(rig)
    whole = chain.by_name(line)["whole"]
    assert head[whole.anchor.point] == 1.0


def test_opposed_members_run_to_opposite_sides_of_the_board():
    pairs = SimpleNamespace(controls=range(4), axes=((0, 1), (2, 3)))
    right, up = np.eye(3)[:2]
    assert _directions(pairs, np.eye(3)[:2]) == pytest.approx(np.array([-right, right, -up, up]))


def test_another_column_begins_two_handle_widths_right_of_track_and_label():
    """A track to 3, two handle widths of a half each, and letters, each less than a handle wide."""
    tracks = SimpleNamespace(track=np.array([[0.0, 0, 0], [3, 0, 0]])), SimpleNamespace(track=np.zeros((2, 3)))
    ends = [_right_end(SimpleNamespace(members=tracks, label=label), np.eye(3)[:2], 0.5) for label in ("", "abcd")]
    assert ends[0] == pytest.approx(4.0)
    assert 0.25 * 4 < ends[1] - ends[0] < 0.5 * 4


def test_the_middle_of_the_face_is_half_way_between_the_ends_of_what_moves_notably():
    points = np.array([[0.0, 0, 0], [1, 5, 1], [4, 2, 0], [90, 90, 90]])
    motion = SimpleNamespace(points=np.arange(4), arc_length=np.array([1.0, 0.5, 0.9, 0.4]))
    moving, flat = (
        SimpleNamespace(surface=SimpleNamespace(points=points), motions=[motion]),
        SimpleNamespace(normal=np.zeros(3)),
    )
    assert face_middle(moving, flat).tolist() == [2.0, 2.5, 0.5]
    mirrored = SimpleNamespace(normal=np.array([1.0, 0.0, 0.0]), origin=np.array([1.0, 7.0, 7.0]))
    assert face_middle(moving, mirrored).tolist() == [1.0, 2.5, 0.5]
