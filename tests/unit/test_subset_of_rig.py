"""A rig cut down to some points: the same motion, and nothing kept that does not move them."""

import laid_out
import numpy as np
import pytest
from skel_stages import character

from usdrigui.character.deform import deform
from usdrigui.character.subset import subset
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load


@pytest.fixture(scope="module")
def rig(tmp_path_factory):
    """Shapes, skins of every kind and two skeletons."""
    path = tmp_path_factory.mktemp("stage") / "char.usda"
    character(path)
    return read_rigs(path, load({"read": {"joints": "all"}}))[0]


def test_the_points_move_as_in_the_whole_rig(rig):
    rng = np.random.default_rng(5)
    for _ in range(6):
        points = rng.choice(int(rig.body.starts[-1]), 5)
        small, rows = subset(rig, points)
        values = laid_out.random_values(rig, rng)
        assert deform(small, values)[rows] == pytest.approx(deform(rig, values)[points], abs=1e-12)


def test_what_does_not_touch_the_points_is_gone(rig):
    counts = []
    for start in rig.body.starts[:-1]:
        small, _ = subset(rig, np.array([start]))
        channels = {shape.channel for mesh in small.body.meshes for shape in mesh.shapes}
        for control in small.controls:
            assert set(control.drive.channels.tolist()) <= channels
            assert all(0 <= joint < len(small.body.joints) for joint in control.drive.joints)
        for index, joint in enumerate(small.body.joints):
            assert joint.parent < index
        assert [control.name for control in small.controls] == [control.name for control in rig.controls]
        counts.append(len(small.body.joints))
    assert min(counts) < len(rig.body.joints)
