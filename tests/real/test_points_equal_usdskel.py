"""Points of every control of every real rig equal UsdSkel's, at the knots and between them."""

import numpy as np
import pytest
from folders import ASSETS
from laid_out import extent
from usdskel_oracle import Oracle

from usdrigui.character.deform import channel_state, deform, knots, posed, sweep
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings, load

RIGS = sorted(ASSETS.glob("*.usd*"))

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not RIGS, reason=f"no real rigs in {ASSETS}"),
]


@pytest.mark.parametrize("path", RIGS, ids=lambda path: path.stem)
def test_every_control_equals_usdskel(path):
    for rig in read_rigs(path, Settings()):
        oracle, base = Oracle(path, rig), posed(rig)
        diagonal = extent(base.points)
        rest = rig.defaults
        assert np.abs(base.points - oracle.deformed(*channel_state(rig, None))).max() < 1e-5 * diagonal
        for index, control in enumerate(rig.controls):
            at = _between(knots(rig, index))
            points, offsets = sweep(rig, base, index, at)
            for row, value in enumerate(at):
                values = rest.copy()
                values[index] = value
                ours = base.points.copy()
                ours[points] += offsets[row]
                expected = oracle.deformed(*channel_state(rig, values))
                assert np.abs(ours - expected).max() < 1e-5 * diagonal, (control.name, value)


@pytest.mark.parametrize("path", RIGS, ids=lambda path: path.stem)
def test_random_poses_equal_usdskel(path):
    rng = np.random.default_rng(0)
    for rig in read_rigs(path, Settings()):
        oracle = Oracle(path, rig)
        diagonal = extent(deform(rig))
        for _ in range(3):
            values = np.array([rng.uniform(control.minimum, control.maximum) for control in rig.controls])
            expected = oracle.deformed(*channel_state(rig, values))
            assert np.abs(deform(rig, values) - expected).max() < 1e-5 * diagonal


def _between(at):
    """The knots, a place between each two, and no knot twice."""
    return np.sort(np.concatenate([at, at[:-1] + 0.37 * np.diff(at)]))


@pytest.mark.parametrize("path", RIGS, ids=lambda path: path.stem)
def test_joint_rotations_equal_usdskel(path):
    """Every seventh joint axis, as if the configuration asked for all joints."""
    for rig in read_rigs(path, load({"read": {"joints": "all"}})):
        joints = [i for i, control in enumerate(rig.controls) if control.kind == "joint"][::7]
        oracle, base = Oracle(path, rig), posed(rig)
        diagonal = extent(base.points)
        for index in joints:
            values = rig.defaults
            values[index] = 0.8 * rig.controls[index].maximum
            points, offsets = sweep(rig, base, index, values[index])
            ours = base.points.copy()
            ours[points] += offsets[0]
            expected = oracle.deformed(*channel_state(rig, values))
            assert np.abs(ours - expected).max() < 1e-5 * diagonal, rig.controls[index].name
