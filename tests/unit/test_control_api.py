"""What the layer says of a control's drive and of the ranges of weights, worked out by hand."""

from dataclasses import replace
from types import SimpleNamespace

import makers
import numpy as np
import pytest
from pxr import Sdf, Usd

from usdrigui.layer import control_api
from usdrigui.layer.control_api import _driven_joints
from usdrigui.layer.write_layout import author_variant


def turning(skeletons, rotations, translations, scales, extent=2.0):
    """A rig and a control of one joint in each of these skeletons; rows (joints, 3) at the value 1."""
    rest = np.eye(4)
    rest[3, 1] = -extent
    joints = tuple(SimpleNamespace(path=f"j{i}", skeleton=each, rest=rest) for i, each in enumerate(skeletons))
    body = SimpleNamespace(joints=joints, skeletons=tuple(SimpleNamespace(path=f"/S{i}") for i in range(2)))
    rows = [np.stack([0.0 * np.array(each), np.array(each)]) for each in (rotations, translations, scales)]
    return _driven_joints(body, SimpleNamespace(joints=np.arange(len(joints)), moves=np.stack(rows, axis=1)))


def test_joints_are_said_in_degrees_and_factors_and_noise_is_left_out():
    """Noise of a translation is measured by the longest bone, 2 long."""
    still = np.zeros((3, 3))
    turns, shifts, scales = still.copy(), still.copy(), still.copy()
    turns[0, 0], turns[1, 1], turns[2, 0] = np.pi / 2, 0.9e-6, 0.9e-6
    shifts[0, 1], shifts[1, 2] = 1.9e-6, 2.1e-6
    scales[1, 0] = 0.9e-6
    found = turning([0, 1, 0], turns, shifts, scales)
    assert found["joints"] == ["j0", "j1"]
    assert (found["skeleton"], found["jointSkeletons"]) == (["/S0", "/S1"], [0, 1])
    assert found["jointRotationVectors"] == pytest.approx(np.array([[0.0, 0, 0], [0, 0, 0], [90, 0, 0], [0, 0, 0]]))
    assert found["jointTranslations"].tolist() == [[0.0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 2.1e-6]]
    assert len(found["jointScaleFactors"]) == 0
    scales[1, 0] = np.log(2.0)
    found = turning([1, 1, 1], still, still, scales)
    assert found["jointScaleFactors"] == pytest.approx(np.array([[1.0, 1, 1], [2, 1, 1]]))
    assert (found["joints"], found["skeleton"], found["jointSkeletons"]) == (["j1"], ["/S1"], [])
    assert len(found["jointRotationVectors"]) == len(found["jointTranslations"]) == 0
    assert turning([0, 0, 0], still, still, still) == {}


@pytest.mark.skipif(not hasattr(Usd, "AttributeLimits"), reason="USD before 25.11 has no limits")
def test_ranges_are_said_where_usd_looks_for_them():
    """Inside the variant of the layout, as far as the SkelAnimation is below the SkelRoot."""
    rig = makers.face(9, 11, ranges={"chin": (-0.5, 2.0)})
    layer = Sdf.Layer.CreateAnonymous(".usda")
    root = author_variant(layer, rig.path)
    skeletons = tuple(SimpleNamespace(animation=each) for each in ("", f"{rig.path}/Anim", "/Anim"))
    channels = tuple(replace(each, animation=skeletons[1].animation) for each in rig.body.channels)
    control_api.author_limits(root, makers.changed(rig, channels=channels, skeletons=skeletons))
    said = layer.GetAttributeAtPath(f"{root.path}Anim.blendShapeWeights").GetInfo("limits")["soft"]
    at = [each.token for each in channels].index("chin")
    assert (said["minimum"][at], said["maximum"][at]) == (-0.5, 2.0)
    assert len(said["minimum"]) == len(channels)
    assert not layer.GetPrimAtPath("/Anim")
