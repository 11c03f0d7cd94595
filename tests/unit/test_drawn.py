"""usdrigui.usd.drawn: areas, handles and value-showing sliders, worked out by hand."""

from __future__ import annotations

from dataclasses import replace

import makers
import numpy as np
import pytest

from usdrigui.model import Anchor, Element, Layout, Member
from usdrigui.usd import drawn
from usdrigui.usd.carry import Carriage
from usdrigui.usd.drawn import drawn_parts

NAMES = ["brow_L", "chin", "smile_L", "pucker", "jawLeft"]
ORIGIN = np.array([0.1, 0.2, 0.5])


def member(name, end, values=(0.0, 1.0)):
    values = np.array(values)
    return Member(name, values, ORIGIN + values[:, None] * np.array(end, dtype=np.float64), 1.0, 1.0)


def element(members, kind="fan", beside=False, normal=(0.0, 0.0, 1.0)):
    anchor = Anchor("/Root/mesh", 50, 99, "", ORIGIN, np.array(normal), beside)
    return Element("e", "e", kind, tuple(members), (), anchor, "none", "", "", "")


def layout(rig, *elements):
    return Layout(
        rig.root, elements, (), 0.1, "object", np.array([0.0, 0, 1]), np.zeros(3), np.zeros(3),
        np.zeros(len(rig.controls)), "", "stopped", 0.0, 0.0, 0.0,
    )  # fmt: skip


def around(*degrees):
    """Members of a fan whose tracks leave the anchor at these angles."""
    turns = np.radians(degrees)
    return [
        member(name, (np.cos(turn), np.sin(turn), 0)) for name, turn in zip(NAMES[: len(turns)], turns, strict=True)
    ]


@pytest.mark.parametrize(
    ("degrees", "pairs"),
    [
        ((0, 90), {(0, 1)}),
        ((90, 0), {(1, 0)}),
        ((0, 270), {(1, 0)}),
        ((0, 180), set()),
        ((0, 1), set()),
        ((0, 90, 180, 270), {(0, 1), (1, 2), (2, 3), (3, 0)}),
        ((0, 180, 90), {(0, 2), (2, 1)}),
        ((0, 60, 120), {(0, 1), (1, 2)}),
        ((10, 130, 250), {(0, 1), (1, 2), (2, 0)}),
    ],
)
def test_areas_lie_between_neighbours_at_most_half_a_turn_apart(degrees, pairs):
    assert set(drawn._neighbours(element(around(*degrees)))) == pairs


def test_the_two_ends_of_an_axis_span_no_area_however_bent_it_is():
    stick = replace(element(around(0, 174, 85, 267)), opposed=((0, 1), (2, 3)))
    assert set(drawn._neighbours(stick)) == {(0, 2), (2, 1), (1, 3), (3, 0)}
    assert drawn._neighbours(replace(element(around(0, 174)), kind="patch", opposed=((1, 0),))) == []


@pytest.mark.parametrize("degrees", [(0, 90), (90, 0), (0, 90, 180, 270)])
def test_areas_face_along_the_normal_and_know_their_values(degrees):
    rig = makers.face(9, 11)
    fan = element(around(*degrees))
    area = next(part for part in drawn_parts(Carriage(rig, layout(rig, fan)), fan, 0.1) if part.role == "area")
    corners = area.points[area.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0])
    assert (normals[:, 2] > 0.0).all()
    ends = np.array([each.track[-1] - ORIGIN for each in fan.members])
    assert np.allclose(area.base_points, ORIGIN + area.values @ ends)


def test_long_tracks_make_areas_of_bounded_size():
    rig = makers.face(9, 11)
    values = np.linspace(0.0, 1.0, 33)
    fan = element([member("chin", (1, 0, 0), values), member("pucker", (0, 1, 0), values)], "patch")
    track, _, area, _ = drawn_parts(Carriage(rig, layout(rig, fan)), fan, 0.1)
    assert (len(track.points), len(area.points), len(area.faces)) == (33, 49, 36)
    assert {0.0, 1.0} <= set(area.values[:, 0])


def test_sliders_have_no_area():
    rig = makers.face(9, 11)
    slider = element(around(0, 90), "slider")
    parts = drawn_parts(Carriage(rig, layout(rig, slider)), slider, 0.1)
    assert [part.role for part in parts] == ["track", "track", "handle"]


@pytest.mark.parametrize(
    ("keys", "weights", "base"),
    [
        ((0.0, 1.0), (0.0, 1.0), 0.0),
        ((0.0, 1.0), (0.0, -2.0), 0.0),
        ((-1.0, 0.0, 1.0), (-0.5, 0.0, 1.0), 0.25),
        ((0.0, 1.0), (0.0, 0.5), 0.5),
    ],
)
def test_beside_the_face_the_handle_stands_on_its_track_at_every_weight(keys, weights, base):
    rig = makers.face(9, 11)
    channel = [each.token for each in rig.channels].index("chin")
    driven = makers.drive((channel,), keys, np.array(weights)[:, None])
    controls = tuple(
        replace(control, drive=driven, minimum=keys[0], maximum=keys[-1]) if control.name == "chin" else control
        for control in rig.controls
    )
    rig = replace(rig, controls=controls)
    slider = element([member("chin", (0.3, 0.1, 0), keys)], "slider", beside=True)
    place = ORIGIN + base * np.array([0.3, 0.1, 0])
    slider = replace(slider, anchor=replace(slider.anchor, position=place))
    values = np.array([base if control.name == "chin" else 0.0 for control in controls])
    carriage = Carriage(rig, replace(layout(rig, slider), base_values=values))
    handle = drawn_parts(carriage, slider, 0.1)[-1]
    (shape,) = handle.shapes
    assert shape.channel == channel
    assert 1.0 in shape.weights
    assert 0.0 not in shape.weights
    for value in np.linspace(keys[0], keys[-1], 7):
        centre = handle.points.mean(axis=0) + shape.at(float(np.interp(value, keys, weights)))[0]
        assert np.allclose(centre, ORIGIN + value * np.array([0.3, 0.1, 0]), atol=1e-9), value


def test_controls_of_several_weights_leave_the_handle_of_a_board_alone():
    rig = makers.face(9, 11)
    mixed = replace(rig.controls[0], name="mix", drive=makers.drive((0, 1)))
    rig = replace(rig, controls=(*rig.controls, mixed))
    slider = element([member("mix", (1, 0, 0))], "slider", beside=True)
    handle = drawn_parts(Carriage(rig, layout(rig, slider)), slider, 0.1)[-1]
    assert handle.shapes == ()
    assert np.allclose(handle.points.mean(axis=0), ORIGIN)


def test_the_ball_is_round_centred_and_closed():
    points, faces = drawn._ball()
    assert np.allclose(np.linalg.norm(points, axis=1), 1.0)
    assert np.allclose(points.mean(axis=0), 0.0)
    edges = {(face[i], face[(i + 1) % 3]) for face in faces.tolist() for i in range(3)}
    assert len(points) - len(edges) // 2 + len(faces) == 2
    assert all((b, a) in edges for a, b in edges)
