"""Blender's own evaluated meshes under the extension's controls, against UsdSkel."""

import blender_characters as characters
import laid_out
import numpy as np
import pytest
from folders import SAMPLE
from real_rigs import ASSETS

from usdrigui.pose.evaluate import elements_at, prepare

CLOSE = 1e-5
"""Of the diagonal of the character."""


def poses_of(rig, count=2):
    """The base pose, every third control at its end, and random poses."""
    rng = np.random.default_rng(5)
    every = rig.defaults
    single = []
    for j in range(0, len(rig.controls), max(1, len(rig.controls) // 4)):
        one = every.copy()
        one[j] = rig.controls[j].maximum if j % 2 else rig.controls[j].minimum or rig.controls[j].maximum
        single.append(one)
    return [every, *single, *(laid_out.random_values(rig, rng) for _ in range(count))]


def checked(run_inside, python, layer, source, rig, layout):
    poses = poses_of(rig)
    names = rig.control_names
    laid = layout.controls
    for pose in poses:
        for j, name in enumerate(names):
            pose[j] = pose[j] if name in laid else rig.controls[j].default
    asked = [{name: value for name, value in zip(names, pose, strict=True) if name in laid} for pose in poses]
    found = run_inside([python], "pose_points", layer=str(layer), poses=asked)
    place = characters.to_world(source, rig)
    size = characters.diagonal(map(place, characters.usdskel_points(source, rig, poses[0]).values()))
    worst = {"points": 0.0, "values": 0.0, "handles": 0.0, "tracks": 0.0}
    poser = prepare(rig, layout)
    for number, pose in enumerate(poses):
        expected = characters.usdskel_points(source, rig, pose)
        for i, path in enumerate(found["meshes"]):
            gap = np.abs(found[f"mesh{number}_{i}"] - place(expected[str(path)])).max()
            worst["points"] = max(worst["points"], gap / size)
        gap = np.abs(found[f"values{number}"] - np.array([*asked[number].values()])).max()
        worst["values"] = max(worst["values"], gap)
        for element, each in zip(layout.elements, elements_at(poser, pose), strict=True):
            gap = np.abs(found[f"handle{number}_{element.name}"] - place(each.handle)).max()
            if all(member.magnification == 1.0 for member in element.members):
                worst["handles"] = max(worst["handles"], gap / size)
            for k, track in enumerate(each.tracks):
                gap = np.abs(found[f"track{number}_{element.name}_{k}"] - place(track)).max()
                worst["tracks"] = max(worst["tracks"], gap / size)
    values = worst.pop("values")
    assert all(each < CLOSE for each in worst.values()), worst
    return values


KINDS = {
    "linear": {"moved": True},
    "hinged": {"hinged": True},
    "reordered": {"reordered": True, "meshes": 2},
    "left_handed": {"left_handed": True},
}


@pytest.mark.parametrize("kind", KINDS)
def test_points_handles_and_tracks_of_small_characters(run_inside, usd_python, tmp_path, kind):
    layer, rig, layout = characters.skinned(tmp_path, kind, **KINDS[kind])
    assert checked(run_inside, usd_python, layer, tmp_path / f"{kind}.usda", rig, layout) < 1e-4


def test_points_of_the_sample(run_inside, usd_python, tmp_path):
    source = tmp_path / "char.usda"
    for name in ("char.usda", "char_geometry.usda"):
        (tmp_path / name).write_bytes((SAMPLE.parent / name).read_bytes())
    layer, rig, layout = characters.written(source)
    checked(run_inside, usd_python, layer, source, rig, layout)


@pytest.mark.real
@pytest.mark.parametrize("name", ["ict_face57.usdc", "rpm_xr.usdc"])
def test_points_of_real_rigs(run_inside, usd_python, tmp_path, name):
    if not (ASSETS / name).is_file():
        pytest.skip(f"needs ../shared/assets/{name}")
    source = tmp_path / name
    source.write_bytes((ASSETS / name).read_bytes())
    layer, rig, layout = characters.written(source)
    checked(run_inside, usd_python, layer, source, rig, layout)
