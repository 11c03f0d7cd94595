"""The layer is a function of the asset and the settings: of no clock, seed, locale, place or number of processors."""

import os
import time

import numpy as np
import pytest
import skinned_stages
from programs import ran
from skel_stages import character

DISPATCHED = np.show_config(mode="dicts")["SIMD Extensions"].get("found", [])
"""What numpy uses of this processor beyond what it needs of any."""

WORLDS = {
    "one thread, hash seed 1, Kathmandu": {
        "PXR_WORK_THREAD_LIMIT": "1",
        "OMP_NUM_THREADS": "1",
        "OPENBLAS_NUM_THREADS": "1",
        "PYTHONHASHSEED": "1",
        "TZ": "Asia/Kathmandu",
    },
    "two threads, hash seed 4242, a C locale": {
        "PXR_WORK_THREAD_LIMIT": "2",
        "OMP_NUM_THREADS": "2",
        "OPENBLAS_NUM_THREADS": "2",
        "PYTHONHASHSEED": "4242",
        "LC_ALL": "C",
        "PYTHONUTF8": "0",
        "PYTHONCOERCECLOCALE": "0",
    },
    # Kernels of other processors: the last bits of matrix products differ (benchmarks/processors.py has more).
    "a usual processor": {"OPENBLAS_CORETYPE": "Haswell"},
    "an old processor": {"OPENBLAS_CORETYPE": "Nehalem", "NPY_DISABLE_CPU_FEATURES": ",".join(DISPATCHED)},
    "decimal commas, no home": {"LC_ALL": "de_DE.UTF-8", "HOME": "/nonexistent", "TMPDIR": ".", "PYTHONHASHSEED": "7"},
}


pytestmark = pytest.mark.slow


def layer(asset, world=None, cwd=None, arguments=()):
    target = asset.with_name("char.rigui.usda")
    target.unlink(missing_ok=True)
    command = ("-m", "usdrigui", "process", os.path.relpath(asset, cwd or "."), "--quiet", *arguments)
    done = ran(*command, env={**os.environ, "PYTHONHASHSEED": "0", **(world or {})}, cwd=cwd)
    assert done.returncode == 0, done.stderr
    return target.read_bytes()


@pytest.fixture(scope="module")
def reference(tmp_path_factory):
    asset = character(tmp_path_factory.mktemp("here") / "char.usda")
    return asset, layer(asset)


@pytest.mark.parametrize("world", WORLDS)
def test_in_every_world(reference, world):
    asset, expected = reference
    assert layer(asset, WORLDS[world], asset.parent) == expected


def test_where_a_control_agrees_with_its_mirror_image_just_as_much_as_asked(tmp_path):
    asset = skinned_stages.character(tmp_path / "char.usda", moved=True)
    assert layer(asset, WORLDS["a usual processor"]) == layer(asset, WORLDS["an old processor"])


def test_in_every_place(reference, tmp_path):
    asset, expected = reference
    copy = tmp_path / "ein anderer Ort" / asset.name
    copy.parent.mkdir()
    copy.write_bytes(asset.read_bytes())
    assert layer(copy, cwd="/") == expected


def test_it_names_no_place_and_no_day(reference):
    asset, content = reference
    text = content.decode()
    assert str(asset.parent) not in text
    assert os.path.realpath(asset.parent) not in text
    assert "@./char.usda@" in text
    for trace in ("anon:", "0x", "/tmp", "/home", time.strftime("%Y-")):
        assert trace not in text
