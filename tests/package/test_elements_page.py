"""docs/internals/elements.md and its pictures: of an age with the script that makes them, and small."""

import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest
import scripts
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]
POINTS = range(1, 13)


@pytest.fixture(scope="module")
def pictures():
    with scripts.loaded(ROOT / "docs" / "pictures.py") as module:
        yield module


def test_page_and_pictures_are_there(pictures):
    assert pictures.amiss() == []
    assert sum(each.stat().st_size for each in pictures.FOLDER.iterdir()) < 2_000_000


def test_what_is_amiss_is_reported(pictures, monkeypatch):
    monkeypatch.setattr(pictures, "SCENES", pictures.SCENES[1:])
    assert len(pictures.amiss()) == 2


def test_every_kind_has_a_picture(pictures):
    shown = {int(scene.heading.split(" ")[0]) for scene in pictures.SCENES}
    assert shown == set(POINTS)
    names = [scene.name for scene in pictures.SCENES]
    assert len(set(names)) == len(names)
    for scene in pictures.SCENES:
        for panel in scene.panels:
            assert tomllib.loads(panel.config) or not panel.config


@pytest.mark.parametrize("name", ["orbit", "locality"])
def test_the_script_draws_what_the_page_shows(pictures, tmp_path, name):
    """Once more, within what compression and another ray caster change."""
    scene = next(each for each in pictures.SCENES if each.name == name)
    before = list(sys.path)
    try:
        drawn = pictures.drawn(scene, pictures.prepared(tmp_path))
    finally:
        sys.path[:] = before
    kept = Image.open(pictures.FOLDER / f"{name}.jpg").convert("RGB")
    assert drawn.size == kept.size
    apart = np.abs(np.asarray(drawn, dtype=np.int64) - np.asarray(kept, dtype=np.int64)).max(axis=2)
    assert np.mean(apart > 40) < 0.004
