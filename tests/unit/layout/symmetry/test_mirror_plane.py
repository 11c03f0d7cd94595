"""The mirror plane, partner points and twins, on faces whose symmetry is known by construction."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES

from usdrigui.conventions.sides import has_side, hints_at_twin
from usdrigui.errors import RigUIError
from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.layout.symmetry.base_pose import symmetry_at_pose
from usdrigui.layout.symmetry.twins import configured_twins
from usdrigui.settings import ControlSettings, Settings

ROTATION = makers.rotation(11)


def symmetry_of(rig, settings=None):
    settings = settings or Settings()
    found = trajectories(rig, settings.trajectories)
    return symmetry_at_pose(rig, found, None, settings)


def apart(rig, symmetry):
    """Distance of each point's partner from its exact mirror image."""
    points = rig.body.meshes[0].points
    return np.linalg.norm(symmetry.plane.reflected(points) - points[symmetry.partner], axis=1)


def names(rig, symmetry=None):
    controls, symmetry = rig.control_names, symmetry or symmetry_of(rig)
    return {name: controls[twin] if twin >= 0 else "" for name, twin in zip(controls, symmetry.twins, strict=True)}


@pytest.mark.parametrize(
    ("matrix", "offset"),
    [
        (np.eye(3), (0, 0, 0)),
        (100.0 * ROTATION, (500.0, 900.0, -700.0)),
        (np.diag([1.0, 1.0, 0.0]), (0, 0, 0)),
    ],
    ids=["as-made", "rotated-and-large", "a-flat-sheet"],
)
def test_the_plane_is_found_wherever_the_face_stands(matrix, offset):
    rig = makers.moved(makers.face(), matrix, offset)
    symmetry = symmetry_of(rig)
    scale = np.linalg.norm(matrix[0])
    left = matrix @ [1.0, 0.0, 0.0] / scale
    assert symmetry.plane.normal @ left == pytest.approx(1.0, abs=1e-9)
    assert abs(symmetry.plane.distance(np.asarray(offset, dtype=float))) < 1e-6 * scale
    assert np.array_equal(symmetry.partner[symmetry.partner], np.arange(len(symmetry.partner)))
    assert apart(rig, symmetry).max() < 1e-5 * scale


@pytest.mark.parametrize("up", [0, 1])
def test_the_up_axis_decides_where_the_surface_leaves_it_open(up):
    points, quads = makers.mask(17, 21)
    alike = makers.rig(points, quads, {"pout": makers.bump(points, (0, 0), (0, 0, 1), 0.6)}, up=np.eye(3)[up])
    assert abs(symmetry_of(alike).plane.normal[1 - up]) == pytest.approx(1.0, abs=1e-9)


def test_hair_on_one_side_does_not_tilt_the_plane():
    hair = np.random.default_rng(2).uniform([0.9, 0.5, -1.0], [1.6, 1.8, 0.0], size=(150, 3))
    faces = QUADS + (len(POINTS) + np.arange(150).reshape(-1, 3)).tolist()
    shapes = {name: np.vstack([each, np.zeros_like(hair)]) for name, each in SHAPES.items()}
    shapes["hair"] = np.vstack([np.zeros_like(POINTS), np.full_like(hair, 0.1)])
    rig = makers.rig(np.vstack([POINTS, hair]), faces, shapes)
    symmetry = symmetry_of(rig)
    assert symmetry.plane.normal @ [1.0, 0.0, 0.0] == pytest.approx(1.0, abs=1e-9)
    assert (apart(rig, symmetry)[: len(POINTS)] < 1e-6).all()


def test_lips_that_touch_find_the_partner_that_moves_alike():
    points, quads = makers.mask(17, 21)
    shapes = {
        "up_L": makers.bump(points, (0.3, 0), (0, 1, 0), 0.5),
        "up_R": makers.bump(points, (-0.3, 0), (0, 1, 0), 0.5),
    }
    doubled = np.vstack([points, points])
    second = [[i + len(points) for i in face] for face in quads]
    moving = {name: np.vstack([each, -each]) for name, each in shapes.items()}
    symmetry = symmetry_of(makers.rig(doubled, quads + second, moving))
    moved = np.abs(moving["up_L"]).sum(axis=1) > 1e-3
    upper = np.flatnonzero(moved[: len(points)])
    lower = upper + len(points)
    assert (symmetry.partner[upper] < len(points)).all()
    assert (symmetry.partner[lower] >= len(points)).all()


def test_a_shapeless_lump_has_no_plane():
    random = np.random.default_rng(4)
    points = random.normal(size=(300, 3)) * [1.0, 2.0, 3.0]
    rig = makers.rig(points, np.arange(300).reshape(-1, 3).tolist(), {"a": random.normal(size=(300, 3))})
    symmetry = symmetry_of(rig)
    assert not symmetry.plane.normal.any()
    assert (symmetry.partner == -1).all()
    assert symmetry.twins.tolist() == [-1]


def test_twins_come_from_geometry_and_directions_are_twins_too():
    rig = makers.face()
    symmetry = symmetry_of(rig)
    found = names(rig, symmetry)
    assert found["brow_L"] == "brow_R"
    assert found["jawLeft"] == "jawRight"
    assert found["pucker"] == "pucker"
    assert set(symmetry.sources) == {"geometry"}


def test_twins_need_no_names():
    shapes = {f"{i:02d}": each for i, each in enumerate(SHAPES.values())}
    found = names(makers.rig(POINTS, QUADS, shapes))
    assert found["00"] == "01"
    assert found["08"] == "08"


def test_pairs_are_matched_all_at_once():
    # In the image plane of the left ones: a goes with both, best with the right one that b needs.
    angles = {"a": 0.0, "b": 60.0, "c": -26.0, "d": 23.0}
    shapes = {}
    for name, angle in angles.items():
        side = 1.0 if name in "ab" else -1.0
        toward = side * np.cos(np.radians(angle)), np.sin(np.radians(angle)), 0.0
        shapes[f"{name}{name}"] = makers.bump(POINTS, (side * 0.45, 0.0), toward, 0.2)
    rig = makers.face_with(**shapes)
    found = names(rig)
    assert (found["aa"], found["bb"]) == ("cc", "dd")


def test_a_control_that_swings_both_ways_is_symmetric():
    shapes = {
        "swing": makers.bump(POINTS, (0, -0.7), (1, 0, 0), 0.45, 0.15),
        "pucker": makers.bump(POINTS, (0, 0), (0, 0, 1)),
    }
    one_way, both = (makers.rig(POINTS, QUADS, shapes, ranges={"swing": (low, 1.0)}) for low in (0.0, -1.0))
    assert names(one_way)["swing"] == ""
    assert names(both)["swing"] == "swing"


@pytest.mark.parametrize("noise", [-1e-7, 1e-7])
def test_noise_of_single_precision_decides_no_twin(noise):
    """Forth and back across the plane by two, ahead by one: it agrees with its mirror image by 3/5, the least."""
    shapes = {
        "swing": makers.bump(POINTS, (0, -0.7), (2.0 + noise, 0, 1), 0.45, 0.15),
        "pucker": makers.bump(POINTS, (0, 0), (0, 0, 1)),
    }
    rig = makers.rig(POINTS, QUADS, shapes, ranges={"swing": (-1.0, 1.0)})
    assert names(rig)["swing"] == "swing"


def eyes(low):
    """Two eyes that both look to the character's left as their control rises, and a mouth."""
    shapes = {f"yaw_{side}": makers.bump(POINTS, (x, 0.3), (1, 0, 0), 0.2) for side, x in (("L", 0.35), ("R", -0.35))}
    shapes["mid"] = makers.bump(POINTS, (0, -0.5), (0, 0, 1))
    return makers.rig(POINTS, QUADS, shapes, ranges={"yaw_L": (low, 1.0), "yaw_R": (low, 1.0)})


def test_twins_of_opposite_sign_are_found_where_both_go_both_ways():
    symmetry = symmetry_of(eyes(-1.0))
    assert names(eyes(-1.0), symmetry) == {"yaw_L": "yaw_R", "yaw_R": "yaw_L", "mid": "mid"}
    assert symmetry.reversed.tolist() == [True, True, False]
    assert names(eyes(0.0))["yaw_L"] == ""
    assert not symmetry_of(makers.face()).reversed.any()


def test_elements_of_reversed_twins_mirror_each_other_and_say_so():
    line = chain.lay_out(eyes(-1.0))
    left, right = (chain.by_name(line)[name] for name in ("yaw_L", "yaw_R"))
    assert (left.mirror, right.mirror) == ("yaw_R", "yaw_L")
    assert (left.reversed, right.reversed) == ((0,), (0,))
    assert np.abs(left.anchor.position * [-1.0, 1.0, 1.0] - right.anchor.position).max() < 1e-6
    assert np.abs(left.members[0].track * [-1.0, 1.0, 1.0] - right.members[0].track[::-1]).max() < 1e-5
    forced = chain.lay_out(eyes(-1.0), chain.settings(controls={"yaw_L": {"twin": "none"}}))
    assert chain.by_name(forced)["yaw_L"].reversed == ()


def test_left_and_right_shapes_may_differ_and_weak_ones_need_the_name():
    left = makers.bump(POINTS, (0.35, 0.5), (0, 1, 0), 0.3)
    right = makers.bump(POINTS, (-0.35, 0.5), (0, 1, 0), 0.3) * 0.7
    other = makers.bump(POINTS, (-0.5, 0.6), (0.8, 1, 0), 0.3) * 0.5
    shapes = {"a_L": left, "a_R": right, "mid": makers.bump(POINTS, (0, -0.5), (0, 0, 1))}
    rig = makers.rig(POINTS, QUADS, shapes)
    assert names(rig)["a_L"] == "a_R"
    shapes["a_R"] = other
    named = makers.rig(POINTS, QUADS, shapes)
    found = symmetry_of(named)
    assert names(named, found)["a_L"] == "a_R"
    assert found.sources[0] == "name"
    nameless = makers.rig(POINTS, QUADS, {"p": left, "q": other, "mid": shapes["mid"]})
    assert names(nameless)["p"] == ""


def test_the_configuration_has_the_last_word():
    rig = makers.face()
    said = {"brow_L": {"twin": "none"}, "pucker": {"twin": "chin"}, "jawLeft": {"twin": "self"}}
    symmetry = symmetry_of(rig, chain.settings(controls=said))
    found = names(rig, symmetry)
    assert found["brow_L"] == ""
    assert found["pucker"] == "chin"
    assert found["chin"] == "pucker"
    assert found["jawLeft"] == "jawLeft"
    assert symmetry.sources[rig.control_indices["chin"]] == "config"
    with pytest.raises(RigUIError, match="CONFIG_UNKNOWN_CONTROL"):
        symmetry_of(rig, chain.settings(controls={"pucker": {"twin": "nobody"}}))


def test_symmetry_can_be_switched_off():
    symmetry = symmetry_of(makers.face(), chain.settings(symmetry={"enabled": False}))
    assert not symmetry.plane.normal.any()
    assert (symmetry.twins == -1).all()


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("browDown_L", "browDown_R"),
        ("viseme_AA_L", "viseme_AA_R"),
        ("eye-left-slit", "eye-right-slit"),
        ("l-brow", "r-brow"),
        ("Look_In_Left", "Look_In_Right"),
        ("face.Lsmile", "face.Rsmile"),
        ("mouthLeft", "mouthRight"),
        ("brow_lf", "brow_rt"),
        ("mouth_LT", "mouth_RT"),
        ("mouth_LB", "mouth_RB"),
        ("mouthsmileleft", "mouthsmileright"),
    ],
)
def test_names_hint_at_twins(one, other):
    assert hints_at_twin(one, other)
    assert hints_at_twin(other, one)


def test_names_without_sides_hint_at_nothing():
    # Of no word of it; behind viseme the letter is the sound.
    assert not has_side("mouthRollLower.bright.viseme_L")
    for pair in (
        "jawOpen jawOpen",
        "browDown_L browUp_R",
        "mouthRoll mouthRolr",
        "viseme_L viseme_R",
    ):
        assert not hints_at_twin(*pair.split())


def test_a_twin_that_one_control_names_is_the_twin_of_both_the_first_control_too():
    rig = makers.face()
    first, second, *_ = rig.control_names
    assert configured_twins(rig, {second: ControlSettings(twin=first)}) == {0: 1, 1: 0}
    assert configured_twins(rig, {first: ControlSettings(twin="none")}) == {0: -1}
