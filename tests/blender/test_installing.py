"""The archive through Blender's own installers, and what lasts in a saved file."""

import subprocess
from pathlib import Path

import blender_characters as characters
import numpy as np
import pytest

from usdrigui.clients.blender_extension import write_extension


@pytest.fixture
def archive(tmp_path):
    write_extension(tmp_path / "usdrigui_controls.zip")
    return str(tmp_path / "usdrigui_controls.zip")


def test_an_import_ends_well_with_and_without_usd_in_python(run_inside, bpy_python, tmp_path):
    layer, _, _ = characters.sample(tmp_path)
    found = run_inside([bpy_python], "enabled_import", layer=str(layer))
    assert found["objects"] > 5
    assert found["layouts"] == found["usd"]
    assert ("without USD" in str(found["refused"])) != found["usd"]
    if found["usd"]:
        assert found["hidden"]


def test_the_platforms_own_check_finds_nothing(bpy_python, archive):
    (check,) = (
        Path(bpy_python).parents[1].glob("lib/python*/site-packages/bpy/*/scripts/addons_core/bl_pkg/cli/*_ext.py")
    )
    done = subprocess.run([bpy_python, str(check), "validate", archive], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert "ERROR" not in done.stdout


def test_install_import_key_save_and_load(run_inside, usd_python, archive, tmp_path):
    layer, _, source = characters.sample(tmp_path)
    home = {"BLENDER_USER_RESOURCES": str(tmp_path / "home")}
    found = run_inside([usd_python], "installed", home, archive=archive, layer=str(layer), source=str(source))
    assert found["keyed"] == pytest.approx(np.array([[0.25, 2.5], [0.75, 7.5]]), abs=1e-4)
    assert found["flipped"] == pytest.approx([0.0, 0.5])
    assert found["rest"] < 1e-4
    assert found["loaded"] == 11
    no_layout, other_points, copied = found["refused"].tolist()
    assert "choose the .rigui.usda" in no_layout
    assert "lay the copy out by itself first" in copied
    assert "lay it out again" in other_points
