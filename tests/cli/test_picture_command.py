"""`usdrigui picture`: a still of a layer, or the character's animation under it."""

import io

import numpy as np
import pytest
import skinned_stages
from PIL import Image
from pxr import Usd, UsdSkel

from usdrigui.cli import main


@pytest.fixture(scope="module")
def layer(tmp_path_factory):
    path = tmp_path_factory.mktemp("film") / "char.usda"
    character = skinned_stages.character(path, animated_joints=("Hips/Head/Jaw",))
    stage = Usd.Stage.Open(str(character))
    animation = next(UsdSkel.Animation(prim) for prim in stage.Traverse() if prim.IsA(UsdSkel.Animation))
    weights = animation.GetBlendShapeWeightsAttr()
    count = len(animation.GetBlendShapesAttr().Get())
    for time in (1.0, 5.0, 9.0):
        weights.Set([time / 9.0] * count, time)
    stage.GetRootLayer().Save()
    assert main(["process", str(character), "--quiet", "--set", "controls.chin.place=board"]) == 0
    return character.with_name("char.rigui.usda")


def test_a_film_moves_and_is_the_same_every_time(layer, tmp_path):
    films = [tmp_path / "one.gif", tmp_path / "two.gif"]
    for film in films:
        assert main(["picture", str(layer), "-o", str(film), "--frames", "3"]) == 0
    assert films[0].read_bytes() == films[1].read_bytes()
    picture = Image.open(io.BytesIO(films[0].read_bytes()))
    assert picture.n_frames == 3
    first = np.asarray(picture.convert("RGB"), dtype=int)
    picture.seek(2)
    assert np.abs(np.asarray(picture.convert("RGB"), dtype=int) - first).max() > 60


def test_no_animation_is_refused(tmp_path, capsys):
    character = skinned_stages.character(tmp_path / "char.usda")
    stage = Usd.Stage.Open(str(character))
    for prim in stage.Traverse():
        for attribute in prim.GetAttributes() if prim.IsA(UsdSkel.Animation) else ():
            held = attribute.Get(0.0)
            attribute.Clear()
            if held is not None:
                attribute.Set(held)
    stage.GetRootLayer().Save()
    assert main(["process", str(character), "--quiet", "--set", "controls.chin.place=board"]) == 0
    assert main(["picture", str(character.with_name("char.rigui.usda")), "-o", str(tmp_path / "no.gif")]) == 1
    assert "ANIMATION_MISSING" in capsys.readouterr().err
    assert not (tmp_path / "no.gif").exists()
