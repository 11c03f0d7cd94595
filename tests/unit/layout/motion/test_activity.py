"""What animation tells of controls: use, and what moves together, on clips whose answer is known."""

from dataclasses import replace

import limbs
import makers
import numpy as np
import pytest

from usdrigui.character import Joint, Performance, rotation
from usdrigui.errors import RigUIError
from usdrigui.layout.motion.activity import (
    Activity,
    activity,
    importances,
    with_importances,
)
from usdrigui.settings import ControlSettings

FACE = makers.face()
TWINS = np.append(np.arange(8) ^ 1, [-1] * 4)
RAMP = np.array([0.0, 0.5, 1.0, 0.5, 0.0, 0.0, 0.0, 0.0])
LATER = RAMP[::-1]


def clip(**weights):
    table = np.stack([*weights.values()], axis=1)
    rotations = np.zeros((len(table), 0, 3, 3))
    return Performance("clip.usda", "/Anim", np.arange(len(table)), tuple(weights), table, (), rotations)


def column(done, name):
    return done.controls.index(name)


def test_activity_is_the_share_of_the_way_from_the_default():
    done = activity(FACE, [clip(chin=2.0 * RAMP, pucker=0.5 * RAMP)])
    assert done.amounts[:, column(done, "chin")] == pytest.approx(np.minimum(2.0 * RAMP, 1.0))
    assert done.use[column(done, "pucker")] == pytest.approx(0.5 * RAMP.mean())
    assert done.use[column(done, "smile_L")] == 0.0


def test_importance_goes_with_use():
    done = activity(FACE, [clip(chin=RAMP, pucker=0.5 * RAMP)])
    found = importances(done, TWINS, 0.5)
    mean = 1.5 / (len(FACE.controls) - len(makers.LEFT_BUMPS))  # of what pairs and single controls do
    assert found["smile_L"] == found["smile_R"] == 0.5
    assert found["pucker"] == round(1.0 + 0.5 * (0.5 / mean - 1.0), 2)
    assert found["chin"] == 2.5  # more than four times the mean
    assert set(importances(done, TWINS, 0.0).values()) == {1.0}


def test_a_pair_matters_as_one():
    found = importances(activity(FACE, [clip(smile_L=RAMP)]), TWINS, 0.5)
    assert found["smile_L"] == found["smile_R"] > 1.0


def test_what_the_configuration_says_is_stronger():
    overrides = [ControlSettings(importance=3.0 if each.name == "chin" else None) for each in FACE.controls]
    found = with_importances(FACE.controls, overrides, {"chin": 0.5, "pucker": 1.5})
    names = FACE.control_names
    assert found[names.index("chin")].importance == 3.0
    assert found[names.index("pucker")] == ControlSettings(importance=1.5)


def test_several_clips_are_one_after_the_other():
    one, two = clip(chin=RAMP), clip(chin=LATER, pucker=LATER)
    done = activity(FACE, [one, two])
    assert len(done.amounts) == 16
    assert done.clips == ("clip.usda/Anim", "clip.usda/Anim")
    assert done.amounts[:8, column(done, "pucker")].max() == 0.0


def test_animations_of_somebody_else_are_refused_and_strays_are_reported():
    with pytest.raises(RigUIError, match="CLIP_FOREIGN"):
        activity(FACE, [clip(wing=RAMP)])
    with pytest.raises(RigUIError, match="CLIP_FOREIGN"):
        activity(FACE, [clip(chin=0.0 * RAMP)])
    (told,) = activity(FACE, [clip(wing=RAMP, chin=RAMP)]).issues
    assert (told.code, told.severity) == ("CLIP_UNKNOWN_CONTROL", "warning")
    assert "wing" in told.message


def test_what_a_joint_does_counts_about_the_axis_of_its_control():
    turns = np.radians([[-6.0, 0, 8], [60, 0, -80]])[:, None]
    control = replace(
        FACE.controls[0], kind="joint", minimum=-10, maximum=100, drive=makers.drive((), (-10, 100), None, (0,), turns)
    )
    rig = makers.changed(FACE, controls=(control,), joints=(Joint("Root/elbow", 0, -1, *[np.eye(4)] * 3),))
    frames = rotation.rotations(np.radians([[0, 0, 0], [30, 0, -40]]))[:, None]
    clip = Performance("clip.usda", "/Anim", np.arange(2.0), (), np.zeros((2, 0)), ("elbow",), frames)
    assert activity(rig, [clip]).amounts[:, 0] == pytest.approx([0.0, 0.5])


def done_of(**amounts):
    """What animations make some controls do; a control of nan is a pose."""
    return Activity(tuple(amounts), np.stack([*amounts.values()], axis=1), (), ())


def test_of_pairs_the_mean_counts_and_poses_are_left_out():
    a = np.array([1.0, 0.5, 0.0])
    done = done_of(a_L=a, pose=np.full(3, np.nan), a_R=0.0 * a, b=0.5 * a)
    assert importances(done, np.array([2, -1, 0, -1]), 1.0) == {"a_L": 1.0, "a_R": 1.0, "b": 1.0}
    assert importances(done, np.full(4, -1), 1.0) == {"a_L": 2.0, "a_R": 0.0, "b": 1.0}


def test_strays_are_told_by_name_up_to_three():
    names = ("wing", "tail", "horn", "fin")
    for count, listed in ((3, "horn, tail and wing"), (4, "fin, horn, tail and 1 more")):
        (told,) = activity(FACE, [clip(chin=RAMP, **dict.fromkeys(names[:count], RAMP))]).issues
        assert f"{count} of them: {listed}" in told.message


def test_activity_is_of_the_longer_way_and_there_is_none_of_poses():
    rig = makers.face(ranges={"chin": (-2.0, 1.0)})
    pose = replace(rig.controls[0], name="grin", kind="pose")
    done = activity(replace(rig, controls=(*rig.controls, pose)), [clip(chin=-2.0 * RAMP, brow_L=RAMP)])
    assert done.amounts[:, column(done, "chin")] == pytest.approx(RAMP)
    assert np.isnan(done.amounts[:, -1]).all()


@pytest.mark.parametrize(
    ("joints", "known"), [(("j0/j1",), 0), (("other/j1",), 0), (("other/j1", "j0/j1"), 1), (("a/j1", "b/j1"), None)]
)
def test_joints_are_known_by_their_paths_and_else_by_their_names(joints, known):
    """From the base pose, in degrees."""
    rig, turn = limbs.resting(limbs.chain_rig(), {"j1": (0.0, 0.3, 0.0)}), np.zeros((len(RAMP), len(joints), 3))
    turn[:, known or 0, 2] = np.radians(15.0 * RAMP)
    rotations = rotation.rotations(turn) @ rotation.rotation_part(rig.body.joints[1].base)
    moving = replace(clip(chin=RAMP), joints=joints, rotations=rotations)
    if known is None:
        with pytest.raises(RigUIError, match="CLIP_FOREIGN"):
            activity(rig, [moving])
        return
    done = activity(rig, [moving])
    assert done.amounts[:, column(done, "j1:rz")] == pytest.approx(0.5 * RAMP, abs=1e-6)
    assert done.use.sum() == pytest.approx(0.5 * RAMP.mean(), abs=1e-6)
