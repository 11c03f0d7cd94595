"""usdrigui.layer.drawn: areas, handles and value-showing sliders, worked out by hand."""

from dataclasses import replace

import makers
import numpy as np
import pytest
from makers import frame, layout

from usdrigui.layer.drawn import drawn_parts
from usdrigui.layer.skin_binding import SkinBinding
from usdrigui.model import Element, LayoutPart, Member

NAMES = ["brow_L", "chin", "smile_L", "pucker", "jawLeft"]
ORIGIN = np.array([0.1, 0.2, 0.5])


def member(name, end, values=(0.0, 1.0)):
    values = np.array(values)
    return Member(name, values, ORIGIN + values[:, None] * np.array(end, dtype=np.float64), 1.0, 1.0)


def element(members, kind="fan", beside=False, normal=(0.0, 0.0, 1.0), opposed=()):
    return Element(
        name="e",
        kind=kind,
        members=tuple(members),
        opposed=opposed,
        anchor=makers.anchor(FACE, 50, ORIGIN, normal, beside),
        label="e",
        side="none",
    )


FACE, SEEN = makers.face(9, 11), frame(0.1)


def drawn(each, seen=SEEN, rig=FACE):
    """The handle, and the tracks with the areas, of an element on a face."""
    return drawn_parts(SkinBinding(rig, layout(rig, each)), each, seen)


def around(*degrees):
    """Members of a fan whose tracks leave the anchor at these angles."""
    turns = np.radians(degrees)
    return [
        member(name, (np.cos(turn), np.sin(turn), 0)) for name, turn in zip(NAMES[: len(turns)], turns, strict=True)
    ]


@pytest.mark.parametrize(
    ("degrees", "areas"),
    [
        ((0, 90), [3]),
        ((90, 0), [3]),
        ((0, 270), [3]),
        ((0, 90, 180, 270), [4]),
        ((10, 130, 250), [3]),
        ((0, 180), []),
        ((0, 1), []),
        ((0, 180, 90), [4]),
        ((0, 60, 120), [4]),
    ],
)
def test_areas_face_along_the_normal_between_the_ends_of_tracks(degrees, areas):
    fan = element(around(*degrees))
    _, tracks = drawn(fan)
    assert tracks.faces.counts[len(degrees) :].tolist() == areas
    assert tracks.areas == len(areas)
    ends = np.array([ORIGIN, *(each.track[-1] for each in fan.members)])
    for corners in np.split(tracks.faces.indices, np.cumsum(tracks.faces.counts)[:-1])[len(degrees) :]:
        points = tracks.points[corners]
        assert np.cross(points[1] - points[0], points[2] - points[0])[2] > 0.0
        assert all(1e-3 < np.linalg.norm(ends - point, axis=1).min() < 0.06 for point in points)
    assert len(np.unique(tracks.faces.indices)) == len(tracks.points)
    assert tracks.faces.counts.sum() == len(tracks.points), "no point is shared: the mesh is a manifold"


def test_two_tracks_through_the_handle_span_an_area_between_their_four_ends():
    ways = [member(name, way, (-1.0, 0.0, 1.0)) for name, way in (("chin", (1, 0, 0)), ("pucker", (0, 1, 0)))]
    stick = element(ways, "patch")
    _, tracks = drawn(stick)
    assert tracks.faces.counts[-1] == 4


def arc(name, turn, count=33):
    """A member whose track goes round a circle of radius 1, for `turn` degrees."""
    turns = np.radians(np.linspace(0.0, turn, count))
    way = np.stack([np.sin(turns), 1.0 - np.cos(turns), np.zeros(count)], axis=1)
    return replace(member(name, (1, 0, 0)), values=np.linspace(0.0, 1.0, count), track=ORIGIN + way)


def test_a_track_is_a_ribbon_that_ends_in_a_point():
    slider = element([arc("chin", 90.0)], "slider")
    _, tracks = drawn(slider)
    assert tracks.areas == 0
    assert tracks.faces.counts.tolist() == [4, 3]
    middle = 0.5 * (tracks.points[:-1:2] + tracks.points[1::2])
    assert np.allclose(middle, slider.members[0].track[[0, 16]])
    assert np.allclose(tracks.points[-1], slider.members[0].track[-1])
    assert np.allclose(np.linalg.norm(tracks.points[:-1:2] - tracks.points[1::2], axis=1), 0.22 * 0.1, atol=1e-5)
    corners = tracks.points[tracks.faces.indices.reshape(-1)[:4]]
    assert np.cross(corners[1] - corners[0], corners[2] - corners[0])[2] > 0.0


@pytest.mark.parametrize(("turn", "width", "pieces"), [(0.1, 0.1, 1), (90, 2.0, 1), (90, 0.1, 2), (360, 0.1, 4)])
def test_a_drawn_track_has_as_many_points_as_its_bends_need(turn, width, pieces):
    """For a handle of that width, or for the length of the track: a wide handle covers a short arc."""
    slider = element([arc("chin", turn)], "slider")
    _, tracks = drawn(slider, frame(width))
    assert len(tracks.faces.counts) == pieces


@pytest.mark.parametrize("turn", [30.0, 60.0])
def test_a_drawn_track_of_a_short_turn_is_straight_and_runs_in_the_middle_of_it(turn):
    """As far from the ends of the arch as from its crown, so that a handle is nowhere far beside it."""
    slider = element([arc("chin", turn)], "slider")
    _, tracks = drawn(slider, frame(0.01))
    track, radius = slider.members[0].track, 1.0
    assert tracks.faces.counts.tolist() == [3]
    begin, end = 0.5 * (tracks.points[0] + tracks.points[1]), tracks.points[2]
    height = radius * (1.0 - np.cos(np.radians(0.5 * turn)))
    assert np.linalg.norm(begin - track[0]) == pytest.approx(0.5 * height, rel=0.05)
    assert np.linalg.norm(end - track[-1]) == pytest.approx(0.5 * height, rel=0.05)
    assert np.linalg.norm(0.5 * (begin + end) - track[16]) == pytest.approx(0.5 * height, rel=0.1)


@pytest.mark.parametrize(("out", "lifted"), [((1, -1, 0), True), ((-1, 1, 0), False)])
def test_a_track_that_bulges_out_of_the_skin_does_not_cut_into_it(out, lifted):
    normal = np.array(out) / np.sqrt(2.0)
    slider = element([arc("chin", 90.0)], "slider", normal=normal)
    _, tracks = drawn(slider)
    lift = tracks.points[-1] - slider.members[0].track[-1]
    assert np.allclose(lift, (lift @ normal) * normal, atol=1e-6)
    assert (lift @ normal > 0.05) == lifted
    assert lift @ normal > -1e-6


@pytest.mark.parametrize("direction", [(0, 0, 1), (0, 0, 0)])
def test_a_track_that_leaves_the_skin_or_stands_still_is_drawn_all_the_same(direction):
    slider = element([member("chin", direction)], "slider")
    _, tracks = drawn(slider)
    assert np.isfinite(tracks.points).all()
    assert np.linalg.norm(tracks.points[0] - tracks.points[1]) == pytest.approx(0.22 * 0.1)


@pytest.mark.parametrize(("second", "moved"), [(1.0, [0]), (0.5, [])])
def test_a_handle_on_the_board_slides_where_several_weights_are_alike(second, moved):
    rig = makers.face(9, 11)
    mixed = replace(rig.controls[0], name="mix", drive=makers.drive((0, 1), weights=[[0, 0], [1, second]]))
    rig = replace(rig, controls=(*rig.controls, mixed))
    slider = element([member("mix", (1, 0, 0))], "slider", beside=True)
    handle = drawn(slider, rig=rig)[0]
    assert [shape.channel for shape in handle.shapes] == moved
    assert np.allclose(handle.points[0], ORIGIN)


def test_a_handle_is_written_as_finely_as_it_is_small():
    """A mesh that stands far away makes the character large, and no handle coarse."""
    rig = makers.face(9, 11)
    far = replace(rig.body.meshes[0], path="/Root/far", points=1e4 * rig.body.meshes[0].points)
    rig = replace(rig, body=replace(rig.body, meshes=(*rig.body.meshes, far)))
    slider = element([member("chin", (0.3, 0.1, 0))], "slider")
    handle, _ = drawn(slider, rig=rig)
    assert np.abs(handle.points[0] - rig.body.meshes[0].points[50]).max() < 1e-4 * 0.1


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_handle_of_either_hand_is_turned_to_where_its_own_side_is_seen_from(side):
    normal = np.array([0.6 * side, 0.0, 0.8])
    slider = element([member("chin", (0, 0.1, 0))], "slider", normal=normal)
    hands = LayoutPart("", 0.1, np.array([1.0, 0.0, 0.0]), "optimal", 0.0, 0.0)
    handle, _ = drawn(slider, replace(frame(0.1, normal=(1, 0, 0)), parts=(hands,)))
    leant = handle.points[1] - handle.points[0]
    assert side * leant[0] > 0.5 * np.linalg.norm(leant)
