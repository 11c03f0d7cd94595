"""`usdrigui.character.deform` gives UsdSkel's points on a stage that has everything."""

from dataclasses import replace

import numpy as np
import pytest
from laid_out import diagonal, random_values
from skel_stages import character
from usdskel_oracle import baked

from usdrigui.character.deform import channel_state, deform, knots, posed, sweep
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load

CONFIG = {
    "poses": {
        "shout": {"frame": 10.0},
        "story": {"clip": [0.0, 10.0]},
        "grin": {"weights": {"smile": 0.8, "blink": -0.2}},
    },
    "joints": {"neck/jaw/lip": {"axes": ["x", "z"], "minimum": -50.0, "maximum": 70.0}},
    "read": {"joints": "all"},
}


@pytest.fixture(scope="module")
def stage_path(tmp_path_factory):
    return character(tmp_path_factory.mktemp("stage") / "char.usda")


@pytest.fixture(scope="module")
def rig(stage_path):
    (rig,) = read_rigs(stage_path, load(CONFIG))
    return rig


def test_the_stage_has_every_kind_of_control(rig):
    assert {control.kind for control in rig.controls} == {"blendShape", "joint", "pose"}
    assert {mesh.skin.method for mesh in rig.body.meshes if mesh.skin} == {
        "classicLinear",
        "dualQuaternion",
    }


@pytest.mark.parametrize("share", [0.0, 0.3, 0.77, 1.0])
def test_every_control_equals_usdskel(rig, stage_path, share):
    for index, control in enumerate(rig.controls):
        values = rig.defaults
        values[index] = control.minimum + share * (control.maximum - control.minimum)
        expected = baked(stage_path, rig, *channel_state(rig, values))
        assert np.abs(deform(rig, values) - expected).max() < 1e-6 * diagonal(rig), control.name


def test_random_poses_equal_usdskel(rig, stage_path):
    rng = np.random.default_rng(5)
    for _ in range(8):
        values = random_values(rig, rng)
        expected = baked(stage_path, rig, *channel_state(rig, values))
        assert np.abs(deform(rig, values) - expected).max() < 1e-6 * diagonal(rig)


@pytest.mark.parametrize("elsewhere", [False, True])
def test_sweep_equals_deform(rig, elsewhere):
    """A sweep from any pose gives the differences of single evaluations, and all points that move."""
    rng = np.random.default_rng(1)
    start = rig.defaults
    if elsewhere:
        start = random_values(rig, rng)
    base = posed(rig, start)
    for index, control in enumerate(rig.controls):
        at = np.linspace(control.minimum, control.maximum, 4)
        # A sweep puts the control at its values in a pose where it was at its default.
        start_here = start.copy()
        start_here[index] = control.default
        base = posed(rig, start_here)
        points, offsets = sweep(rig, base, index, at)
        for row, value in enumerate(at):
            values = start_here.copy()
            values[index] = value
            expected = deform(rig, values) - base.points
            moved = np.zeros_like(expected)
            moved[points] = offsets[row]
            assert np.abs(moved - expected).max() < 1e-6 * diagonal(rig), control.name


def test_knots_make_exact_polylines(rig):
    """Between neighbouring knots a blend-shape control moves every point along a straight line."""
    base = posed(rig)
    for index, control in enumerate(rig.controls):
        if control.kind != "blendShape":
            continue
        at = knots(rig, index)
        assert at[0] == control.minimum
        assert at[-1] == control.maximum
        assert control.default in at
        inner = (at[:-1] * 2 + at[1:]) / 3
        _, ends = sweep(rig, base, index, at)
        _, middle = sweep(rig, base, index, inner)
        assert np.abs(middle - (ends[:-1] * 2 + ends[1:]) / 3).max() < 1e-6 * diagonal(rig)


def test_knots_of_the_jaw_are_its_shapes(rig):
    jaw = rig.control_indices["jaw"]
    assert knots(rig, jaw).tolist() == [-0.5, 0.0, 0.5, 1.0, 1.5]


def test_a_layer_tells_knots_apart(rig):
    """A shape that bends next to the base pose."""
    near = replace(rig, body=replace(rig.body, base_weights=rig.body.base_weights + 0.25 - 1e-9))
    assert all(np.diff(knots(near, index)).min() > 1e-7 for index in range(len(rig.controls)))


def test_a_pose_with_inbetweens_has_their_knots(rig):
    """At value v the pose `shout` sets smile to -0.7 v and blink to v; blink bends at 0.25."""
    shout = rig.control_indices["shout"]
    assert np.isclose(knots(rig, shout), 0.25).any()
