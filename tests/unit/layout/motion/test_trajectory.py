"""Trajectories: what moves, how far, and what is said about controls that hardly do."""

from dataclasses import replace

import makers
import numpy as np
import pytest

from usdrigui.character import Joint, Skeleton
from usdrigui.layout.motion.coverage import coverage_of_smaller
from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.model import Motion
from usdrigui.settings import TrajectorySettings

POINTS, QUADS = makers.mask(9, 11)
DENSE = TrajectorySettings()


def one(shape, **keywords):
    return makers.rig(POINTS, QUADS, {"one": shape}, **keywords)


def test_a_straight_shape_is_its_offset_and_only_moving_points_are_held():
    offsets = makers.bump(POINTS, (0.0, 0.0), (0, 0, 1), 0.5)
    found = trajectories(one(offsets), DENSE)
    motion = found.motions[0]
    assert motion.values.tolist() == [0.0, 1.0]
    assert len(motion.points) < len(POINTS)
    assert np.allclose(motion.offsets[1], offsets[motion.points], atol=1e-7)
    assert np.allclose(motion.arc_length, np.linalg.norm(offsets[motion.points], axis=1), rtol=1e-5)


def test_an_in_between_bends_the_path_and_counts_in_the_arc_length():
    side = makers.bump(POINTS, (0.0, 0.0), (1, 0, 0), 0.5)
    found = trajectories(one({0.5: side, 1.0: np.zeros_like(side)}), DENSE)
    motion = found.motions[0]
    assert motion.values.tolist() == [0.0, 0.5, 1.0]
    assert np.allclose(motion.offsets[-1], 0.0)
    assert motion.arc_length.max() == pytest.approx(0.2, rel=1e-4)


def test_a_signed_range_has_the_rest_in_the_middle():
    found = trajectories(one(makers.bump(POINTS, (0, 0), (0, 1, 0)), ranges={"one": (-1.0, 2.0)}), DENSE)
    motion = found.motions[0]
    assert motion.values.tolist() == [-1.0, 0.0, 2.0]
    assert not motion.offsets[1].any()
    assert motion.arc_length.max() == pytest.approx(0.3, rel=1e-4)


def test_the_base_pose_moves_the_start_of_the_path_and_not_its_length():
    shapes = {"a": makers.bump(POINTS, (0, 0), (0, 0, 1)), "b": makers.bump(POINTS, (0, 0), (1, 0, 0))}
    rig = makers.rig(POINTS, QUADS, shapes)
    rest, posed = trajectories(rig, DENSE), trajectories(rig, DENSE, np.array([0.25, 0.0]))
    assert np.allclose(posed.surface.points, POINTS + 0.25 * shapes["a"], atol=1e-6)
    first = posed.motions[0]
    assert first.values.tolist() == [0.0, 0.25, 1.0]
    assert not first.offsets[1].any()
    assert np.allclose(first.arc_length, rest.motions[0].arc_length, rtol=1e-4)
    assert np.allclose(posed.surface.points[first.points] + first.offsets[0], POINTS[first.points], atol=1e-6)


def test_an_empty_control_is_left_off_with_the_reason():
    rig = makers.rig(POINTS, QUADS, {"empty": np.zeros_like(POINTS), "full": makers.bump(POINTS, (0, 0), (0, 0, 1))})
    found = trajectories(rig, DENSE)
    assert [(each.control, each.stage) for each in found.left_off] == [("empty", "trajectories")]
    assert [motion.control for motion in found.motions] == [1]


def test_tiny_controls_stay_and_are_named():
    shape = makers.bump(POINTS, (0, 0.3), (0, 0, 1), 0.6)
    found = trajectories(makers.rig(POINTS, QUADS, {"big": shape, "again": shape, "tiny": 0.001 * shape}), DENSE)
    assert len(found.motions) == 3
    assert [(each.code, each.path) for each in found.issues] == [("CONTROL_TINY", "tiny")]


def test_noise_does_not_move_points_unless_asked():
    noise = np.random.default_rng(0).normal(scale=1e-6, size=POINTS.shape)
    rig = one(makers.bump(POINTS, (0, 0), (0, 0, 1), 0.3) + noise)
    assert len(trajectories(rig, DENSE).motions[0].points) < len(POINTS)
    assert len(trajectories(rig, TrajectorySettings(noise=0.0)).motions[0].points) == len(POINTS)


def test_a_drift_of_the_head_and_noise_are_not_what_a_shape_moves():
    """Shapes from a solver that was not held to the head move every point a little."""
    points, quads = makers.mask()
    shape = makers.bump(points, (0.3, 0.4), (0, 1, 0), 0.3)
    noise = np.random.default_rng(0).normal(scale=1e-3, size=points.shape)
    drift = makers.shape(0, shape + noise + [0.0, 0.006, 0.008])
    eyes = makers.mesh(points + np.array([0.0, 0.0, 5.0]), quads, [makers.shape(1, shape)], path="/Root/eyes")
    rig = makers.rig_of_meshes([makers.mesh(points, quads, [drift]), eyes], ["one", "eye"])
    drifting = trajectories(rig, DENSE).motions[0]
    assert len(set(drifting.points) - set(np.flatnonzero(np.linalg.norm(shape, axis=1)))) < 3
    assert drifting.arc_length.max() > 0.1
    carried = trajectories(makers.rig(points, quads, {"one": shape * 0.0 + [0.0, 0.1, 0.0]}), DENSE).motions[0]
    assert len(carried.points) == len(points)


def test_a_turning_joint_is_sampled_to_the_tolerance():
    rig = jointed(np.radians(90.0))
    coarse = trajectories(rig, TrajectorySettings(tolerance=1e-2)).motions[0]
    fine = trajectories(rig, TrajectorySettings(tolerance=1e-4)).motions[0]
    assert len(coarse.values) < len(fine.values) <= 33
    radius = np.linalg.norm(rig.body.meshes[0].points[fine.points][:, [1, 2]], axis=1)
    assert np.allclose(fine.arc_length, radius * np.pi / 2, rtol=1e-3)


def test_sizes_follow_the_local_controls_and_scale_with_the_character():
    rig = makers.face()
    found = trajectories(rig, DENSE)
    whole = makers.rig(
        rig.body.meshes[0].points, QUADS_FULL, {**makers.face_shapes(rig.body.meshes[0].points), "head": HEAD}
    )
    with_head = trajectories(whole, DENSE)
    assert with_head.surface.face_size == pytest.approx(found.surface.face_size, rel=1e-6)
    assert with_head.typical_length == pytest.approx(found.typical_length, rel=1e-6)
    large = trajectories(makers.moved(rig, 100.0 * np.eye(3)), DENSE)
    assert large.surface.face_size == pytest.approx(100.0 * found.surface.face_size, rel=1e-5)
    assert large.typical_length == pytest.approx(100.0 * found.typical_length, rel=1e-5)


@pytest.mark.parametrize("kind", ["translation", "scaling", "identity"])
def test_controls_of_the_whole_head_cover_it_and_no_other_does(kind):
    points, quads = makers.mask()
    whole = {
        "translation": np.full_like(points, 0.2),
        "scaling": 0.3 * points,
        "identity": points * [0.3, 0.0, 0.1],
    }[kind]
    rig = makers.rig(points, quads, {**makers.face_shapes(points), "whole": whole})
    share = coverage_of_smaller(trajectories(rig, DENSE).motions, np.ones(len(points)))
    assert share[-1] > 0.6
    assert share[:-1].max() < 0.6
    small = trajectories(makers.moved(rig, 1e-3 * np.eye(3)), DENSE)
    assert coverage_of_smaller(small.motions, np.ones(len(points))) == pytest.approx(share)


def jointed(angle):
    """The mask on one joint at the origin that turns about x."""
    drive = makers.drive(joints=[0], turns=[[[0.0, 0.0, 0.0]], [[angle, 0.0, 0.0]]])
    control = replace(makers.control("jaw:rx", 0), kind="joint", drive=drive)
    mesh = makers.mesh(POINTS, QUADS, skin=makers.skin(len(POINTS)))
    joint = Joint("jaw", 0, -1, np.eye(4), np.eye(4), np.eye(4))
    skeleton = Skeleton("/Root/skel", "", np.eye(4))
    return makers.changed(makers.rig_of_meshes([mesh], []), joints=(joint,), skeletons=(skeleton,), controls=(control,))


FULL, QUADS_FULL = makers.mask()
HEAD = np.full_like(FULL, 0.4)


def test_faces_wound_inward_are_noticed_and_turned():
    angles = np.linspace(0.0, 2.0 * np.pi, 13)[:-1]
    points = np.array([[np.cos(a), y, np.sin(a)] for y in (-1.0, 1.0) for a in angles])
    sides = [[i, 12 + i, 12 + (i + 1) % 12, (i + 1) % 12] for i in range(12)]
    faces = [*sides, list(range(12)), list(range(23, 11, -1))]
    shapes = {"a": makers.bump(points, (0.0, 1.0), (0, 1, 0), 1.5)}
    inside_out = [face[::-1] for face in faces]
    # What no control moves encloses more.
    backdrop = makers.mesh(2.0 * points, inside_out, path="/Root/backdrop")
    right = trajectories(makers.rig_of_meshes([*makers.rig(points, faces, shapes).body.meshes, backdrop], ["a"]), DENSE)
    wrong = trajectories(makers.rig(points, inside_out, shapes), DENSE)
    for found in (right, wrong):
        assert (np.einsum("ni,ni->n", found.surface.normals[: len(points)], points) > 0.0).all()
    assert [each.code for each in wrong.issues] == ["NORMALS_INWARD"]
    assert not right.issues


def motions_of(*lengths):
    """Motions that move every point by these lengths."""
    still = np.array([0.0, 1.0]), np.zeros((2, 4, 3), np.float32)
    return [Motion(i, np.arange(4), *still, np.array(each, dtype=float)) for i, each in enumerate(lengths)]


@pytest.mark.parametrize(("beyond", "covered"), [(1.0, 0.5), (4.0, 0.5), (4.1, 0.0)])
def test_what_moves_more_beyond_the_face_is_measured_on_it_if_that_is_a_quarter_of_the_peak(beyond, covered):
    motions = motions_of([1, 1, 0, 0], [0, 0, 1, 0], [1, 0.25, 0.2, beyond])
    assert coverage_of_smaller(motions, np.array([1.0, 1.0, 2.0, 8.0]))[2] == pytest.approx(covered)


def test_it_takes_more_than_two_and_a_half_times_the_usual_area_to_cover_a_face():
    motions = motions_of([1, 1, 0, 0], [0, 0, 1, 0], [1, 1, 1, 1])
    assert coverage_of_smaller(motions, np.array([1.0, 1.0, 2.0, 1.0]))[2] == 0.0
    assert coverage_of_smaller(motions, np.array([1.0, 1.0, 2.0, 1.1]))[2] == 1.0
