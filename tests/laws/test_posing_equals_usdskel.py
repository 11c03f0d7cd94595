"""A layout posed without USD stands where UsdSkel puts the written layer's gprims."""

from dataclasses import replace

import laid_out
import numpy as np
import pytest
import skinned_stages
from laid_out import written
from scipy.spatial.distance import cdist

from usdrigui.pose.evaluate import evaluate, prepare

pytestmark = pytest.mark.usefixtures("every_point_drawn")
KINDS = {
    "linear": {},
    "dual quaternion": {"method": "dualQuaternion"},
    "without skin": {"skinned": False},
    "transforms everywhere": {"moved": True, "reordered": True, "meshes": 2},
    "joint controls": {"animated_joints": ("Hips", "Hips/Head", "Hips/Head/Jaw")},
}
HAIR = 0.3
"""Of a handle's width: as far as a drawn track may be from where it would be if it followed everything exactly."""
CLOSE = 1e-5


@pytest.mark.parametrize("kind", KINDS)
def test_meshes_handles_and_tracks(tmp_path, kind):
    source, rig = skinned_stages.read(tmp_path, **KINDS[kind])
    layout = laid_out.layout_of(rig, seed=6)
    rng = np.random.default_rng(7)
    poses = [laid_out.random_values(rig, rng) for _ in range(3)]
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    poser = prepare(rig, layout)
    shapes = {control.name for control in rig.controls if control.kind == "blendShape"}
    followed = 0
    for time, values in enumerate(poses):
        ours = evaluate(poser, values)
        diagonal = laid_out.extent(ours.points)
        theirs = [laid_out.root_points(stage, mesh.path, rig.path, time) for mesh in rig.body.meshes]
        assert np.abs(ours.points - np.concatenate(theirs)).max() < CLOSE * diagonal
        for element, at in zip(layout.elements, ours.elements, strict=True):
            centre = laid_out.handle(stage, rig.path, element, time)[0]
            assert np.abs(at.handle - centre).max() < CLOSE * diagonal, element.name
            # Where joints are the element's own controls a gprim can only hang on the joints above.
            if element.members[0].control in shapes:
                (track,) = laid_out.tracks(stage, rig.path, element, time)
                assert np.abs(at.tracks[0] - track).max() < HAIR * layout.frame.handle_width, element.name
                followed += 1
    assert followed >= 3 * len(shapes) - 3


@pytest.mark.parametrize("kind", ["linear", "dual quaternion", "joint controls"])
def test_static_elements_and_those_beside_the_face(tmp_path, kind):
    source, rig = skinned_stages.read(tmp_path, **KINDS[kind])
    shapes = [control.name for control in rig.controls if control.kind == "blendShape"]
    values = laid_out.random_values(rig, np.random.default_rng(8))
    for number, given in enumerate(({"adapt": "static"}, {"beside": shapes})):
        layout = laid_out.layout_of(rig, seed=2, only=shapes, **given)
        stage = laid_out.baked(written(source, rig, layout, f"layout{number}.usda"), rig, [values])
        ours = evaluate(prepare(rig, layout), values)
        diagonal = laid_out.extent(ours.points)
        for element, at in zip(layout.elements, ours.elements, strict=True):
            centre = laid_out.handle(stage, rig.path, element, 0)[0]
            (track,) = laid_out.tracks(stage, rig.path, element, 0)
            assert np.abs(at.tracks[0] - track).max() < CLOSE * diagonal, (given, element.name)
            assert np.abs(at.handle - centre).max() < CLOSE * diagonal, (given, element.name)


def test_a_board_with_joint_controls_stays_in_one_piece_in_plain_usd(tmp_path):
    source, rig = skinned_stages.read(tmp_path, **KINDS["joint controls"])
    everything = rig.control_names
    layout = on_one_board(laid_out.layout_of(rig, seed=2, beside=everything))
    poses = [layout.base_values, laid_out.random_values(rig, np.random.default_rng(8))]
    stage = laid_out.baked(written(source, rig, layout), rig, poses)
    ends = [
        np.array([laid_out.tracks(stage, rig.path, element, time)[0][0] for element in layout.elements])
        for time in range(len(poses))
    ]
    ours = np.array([at.tracks[0][0] for at in evaluate(prepare(rig, layout), poses[1]).elements])
    assert len(ours) > 3
    apart, theirs, before = (cdist(each, each) for each in (ours, ends[1], ends[0]))
    assert theirs == pytest.approx(before, rel=1e-4, abs=1e-4)
    assert apart == pytest.approx(before, rel=1e-4, abs=1e-4)


def on_one_board(layout):
    """The layout with all elements carried by the first one's point, where its board is."""
    first = layout.elements[0].anchor
    carried = [
        replace(
            each, anchor=replace(each.anchor, mesh=first.mesh, point=first.point, topology_hash=first.topology_hash)
        )
        for each in layout.elements
    ]
    return replace(layout, elements=tuple(carried))
