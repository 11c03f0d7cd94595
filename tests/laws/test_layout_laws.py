"""What must not change a layout: where the character stands, how large it is, how it is numbered."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES

ROTATION = makers.rotation(3)
Y_TO_Z = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])
MIRROR = np.diag([-1.0, 1.0, 1.0])


@pytest.fixture(scope="module")
def plain():
    return chain.lay_out(makers.face())


def anchors(line):
    """Anchor point of every element on the face, by the controls it holds."""
    return {element.controls: element.anchor.point for element in line.layout.elements if not element.anchor.on_board}


def test_the_face_is_laid_out_at_all(plain):
    assert plain.assignment.status == "optimal"
    assert len(anchors(plain)) == len(plain.layout.elements) == 11


@pytest.mark.parametrize(
    ("matrix", "offset"),
    [
        (100.0 * np.eye(3), np.zeros(3)),
        (0.01 * np.eye(3), np.zeros(3)),
        (ROTATION, np.array([10.0, -4.0, 3.0])),
        (Y_TO_Z, np.zeros(3)),
        (100.0 * Y_TO_Z, np.array([500.0, 0.0, 2.0])),
    ],
    ids=["times-100", "times-0.01", "rotated-and-moved", "z-up", "z-up-times-100"],
)
def test_size_and_place_change_nothing(plain, matrix, offset):
    moved = chain.lay_out(makers.moved(makers.face(), matrix, offset))
    assert anchors(moved) == anchors(plain)
    scale = np.linalg.norm(matrix[0])
    assert moved.layout.frame.handle_width == pytest.approx(scale * plain.layout.frame.handle_width, rel=1e-5)
    assert moved.assignment.cost == pytest.approx(plain.assignment.cost, rel=1e-5)


def test_the_order_of_points_changes_nothing(plain):
    rig = makers.face()
    order = np.random.default_rng(5).permutation(len(rig.body.meshes[0].points))
    shuffled = chain.lay_out(makers.shuffled(rig, order))
    assert {key: int(order[point]) for key, point in anchors(shuffled).items()} == anchors(plain)


def test_the_order_of_controls_changes_nothing(plain):
    rig = makers.face()
    order = np.random.default_rng(7).permutation(len(rig.controls))
    reordered = chain.lay_out(replace(rig, controls=tuple(rig.controls[i] for i in order)))
    assert anchors(reordered) == anchors(plain)
    assert [e.name for e in reordered.layout.elements] == [e.name for e in plain.layout.elements]


def test_a_mirrored_character_gets_the_mirrored_layout(plain):
    mirrored = chain.lay_out(makers.moved(makers.face(), MIRROR))
    partner = plain.face.symmetry.partner
    there, here = anchors(mirrored), anchors(plain)
    # In the mirror "brow_L" sits on the other side, so the same point must carry it or its image.
    assert there.keys() == here.keys()
    same = there == here
    image = there == {key: int(partner[point]) for key, point in here.items()}
    assert same or image


def puffing():
    """The face with a control that puffs both cheeks: symmetric, and nothing of it on the plane."""
    puff = sum(makers.bump(POINTS, (x, -0.1), (x, 0.0, 1.0), 0.2, 0.1) for x in (-0.45, 0.45))
    return makers.face_with(puff=puff)


@pytest.mark.parametrize("matrix", [np.eye(3), MIRROR, 100.0 * ROTATION], ids=["plain", "mirrored", "turned"])
@pytest.mark.parametrize("seed", [0, 1])
def test_a_symmetric_element_off_the_plane_takes_the_left_of_its_two_places(matrix, seed):
    rig = puffing()
    order = np.random.default_rng(seed).permutation(len(rig.body.meshes[0].points))
    settings = chain.settings(symmetry={"double_middle": "never"})
    line = chain.lay_out(makers.moved(makers.shuffled(rig, order), matrix), settings)
    puff = chain.by_name(line)["puff"]
    # Its place as seen from the character: the same point, or in the mirror that point's image.
    back = np.linalg.inv(matrix) @ puff.anchor.position
    left = line.face.symmetry.plane.normal
    assert puff.anchor.position @ left - line.face.symmetry.plane.origin @ left > 0.3
    plain = chain.by_name(chain.lay_out(rig, settings))["puff"].anchor.position
    assert back == pytest.approx(plain * ([-1.0, 1.0, 1.0] if matrix is MIRROR else [1.0, 1.0, 1.0]), abs=1e-5)


def test_two_runs_give_the_same_bytes(plain):
    assert repr(chain.lay_out(makers.face()).layout.elements) == repr(plain.layout.elements)


def test_displacement_alone_takes_every_peak():
    alone = chain.settings(
        objective={"displacement_weight": 1.0, "separation": False},
        candidates={"occlusion_weight": 0.0, "occlusion": False},
        symmetry={"plane_weight": 0.0},
        groups={"opposed": False},
    )
    shapes = {name: offsets for name, offsets in SHAPES.items() if not name.startswith("jaw")}
    # Without the jaw's twins: both peak at one point of the mirror plane, and a point holds one element.
    line = chain.lay_out(makers.rig(POINTS, QUADS, shapes), alone)
    peaks = {
        line.face.rig.controls[motion.control].name: motion.arc_length.max()
        for motion in line.face.trajectories.motions
    }
    members = [member for element in line.layout.elements for member in element.members]
    assert {member.control for member in members} == set(shapes)
    assert not any(element.anchor.on_board for element in line.layout.elements)
    for member in members:
        assert member.arc_length == pytest.approx(peaks[member.control], rel=1e-6)


def test_pairs_mirror_exactly_where_the_mesh_does(plain):
    elements = chain.by_name(plain)
    pairs = [(e, elements[e.mirror]) for e in elements.values() if e.mirror]
    assert len(pairs) == 8
    for one, other in pairs:
        image = one.anchor.position * [-1.0, 1.0, 1.0]
        assert np.abs(image - other.anchor.position).max() < 1e-5
        for a, b in zip(one.members, other.members, strict=True):
            assert np.abs(a.track * [-1.0, 1.0, 1.0] - b.track).max() < 1e-5


def test_no_two_handles_are_nearer_than_a_handle(plain):
    assert chain.least_apart(plain.layout.elements) >= plain.layout.frame.handle_width


def test_more_weight_on_overlap_never_brings_handles_nearer():
    apart = []
    for weight in (0.99, 0.85, 0.5, 0.2):
        free = chain.settings(
            objective={
                "displacement_weight": weight,
                "separation": False,
                "off_face_allowed": False,
                "handle_size": 0.2,
                "overlap_sharpness": 2.0,
            }
        )
        apart.append(chain.least_apart(chain.lay_out(makers.face(), free).layout.elements))
    assert np.all(np.diff(apart) >= -1e-9)
    assert apart[-1] > 1.1 * apart[0]
