"""A rig cut down to some points: the same motion, and no point but these."""

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
    for mesh, start in zip(rig.body.meshes, rig.body.starts[:-1], strict=True):
        (small,) = subset(rig, np.array([start]))[0].body.meshes
        assert (small.path, len(small.points)) == (mesh.path, 1)
        assert not len(small.topology.face_indices)
        assert all(shape.points.tolist() == [0] for shape in small.shapes)
