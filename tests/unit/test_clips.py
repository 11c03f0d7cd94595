"""What is sampled of the animations of a file."""

from types import SimpleNamespace

import numpy as np
import pytest
import skel_stages
from pxr import Usd, UsdSkel

from usdrigui.reading import clips
from usdrigui.reading.clips import read_performances


@pytest.mark.parametrize(
    ("times", "frames"),
    [((1, 3, 24), np.arange(1, 25)), ((0, 0.5), (0, 0.5)), ((0, 10.5), np.linspace(0, 10.5, 11))],
    ids=["uneven", "short", "not whole"],
)
def test_an_animation_is_sampled_about_each_frame_from_its_first_to_its_last(tmp_path, times, frames):
    path = tmp_path / "clip.usda"
    stage, _ = skel_stages.new_stage(path)
    animation = UsdSkel.Animation.Define(stage, "/Char/Anim")
    animation.CreateBlendShapesAttr(["smile"])
    weights = animation.CreateBlendShapeWeightsAttr()
    for time in times:
        weights.Set([float(time)], Usd.TimeCode(time))
    stage.GetRootLayer().Save()
    (found,) = read_performances(path)
    assert found.times == pytest.approx(frames)
    assert found.weights[:, 0] == pytest.approx(frames), "linear in between"


@pytest.mark.parametrize("length", [0.0, 1e-3, 1.0, 2.0])
def test_a_rotation_of_any_length_turns_alike_and_one_of_none_not_at_all(length):
    quarter = length * np.array([[[np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)]]])
    turned = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]) if length else np.eye(3)
    found = clips._turns(quarter)[0, 0]
    assert np.allclose(found, turned, atol=1e-6) or np.allclose(found, turned.T, atol=1e-6)


@pytest.mark.parametrize(("most", "kept"), [(4, [0, 3, 6, 9]), (2, [0, 9]), (1, [0, 9]), (10, list(range(10)))])
def test_of_a_long_animation_as_many_frames_are_kept_as_memory_allows_from_the_first_to_the_last(
    monkeypatch, most, kept
):
    """A frame of two joints and three weights takes 280 bytes."""
    monkeypatch.setattr(clips, "_CLIP_BYTES", 281 * most)
    monkeypatch.setattr(clips, "_sampled", lambda _animated, times, _rate: times)
    record, issues = SimpleNamespace(animation="/Anim"), []
    armatures = [SimpleNamespace(times=range(first, 10, 2), record=record) for first in (0, 1)]
    body = SimpleNamespace(joints=(None,) * 2, channels=(None,) * 3)
    assert clips.read_clip(SimpleNamespace(armatures=armatures, body=body), 24.0, issues) == kept
    assert [each.code for each in issues] == ["CLIP_THINNED"] * (most < 10)
    still = SimpleNamespace(armatures=[SimpleNamespace(times=(5.0,))], body=body)
    assert clips.read_clip(still, 24.0, issues) is None
