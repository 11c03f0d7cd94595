"""`inspect --animation` and `process --animation`: what is told, what can be pasted, what it changes."""

import numpy as np
import pytest
import shot_stages
import skinned_stages
from commands import run
from pxr import Gf, Usd, UsdSkel, Vt

RAMP = np.array([0.0, 0.25, 0.5, 0.75, 1.0, 0.5, 0.0, 0.0, 0.0, 0.0])
LATER = RAMP[::-1]
MOVES = {"chin": RAMP, "jaw:open": RAMP, "brow_L": LATER, "brow_R": LATER, "pucker": LATER, "smile_L": 0.1 * RAMP}


def performed(path, moves, turn=None):
    """A file with one SkelAnimation; `turn` (frames,) degrees about x of the jaw."""
    stage = shot_stages.take(path, moves)
    if turn is not None:
        animation = UsdSkel.Animation(stage.GetPrimAtPath("/Take"))
        animation.CreateJointsAttr(["Hips/Head/Jaw"])
        for time, angle in enumerate(turn):
            rotation = Gf.Rotation((1, 0, 0), float(angle)).GetQuat()
            animation.CreateRotationsAttr().Set(Vt.QuatfArray([Gf.Quatf(rotation)]), time)
        stage.GetRootLayer().Save()
    return path


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    made = tmp_path_factory.mktemp("animated")
    skinned_stages.character(made / "char.usda")
    performed(made / "take.usda", MOVES)
    return made


def test_the_use_of_controls_is_reported(folder, capsys):
    told = run(capsys, "inspect", folder / "char.usda", "--animation", folder / "take.usda")
    found = told["characters"][0]["animation"]
    assert found["clips"] == ["take.usda/Take"]
    assert found["frames"] == 10
    use = {each["control"]: each for each in found["controls"]}
    assert use["chin"]["use"] == pytest.approx(0.3)
    assert use["chin"]["active"] == pytest.approx(0.5)
    assert use["smile_R"]["active"] == 0.0


def test_process_takes_the_importance_that_inspect_prints(folder, tmp_path, capsys):
    """Given the animation, or the lines pasted from it: the same layout."""
    told = run(capsys, "inspect", folder / "char.usda", "--animation", folder / "take.usda")
    text = told["characters"][0]["animation"]["configuration"]
    pasted = tmp_path / "importance.toml"
    pasted.write_text(text[text.index("[controls.") :])
    one, two = tmp_path / "one.rigui.usda", tmp_path / "two.rigui.usda"
    run(capsys, "process", folder / "char.usda", "--animation", folder / "take.usda", "-o", one)
    run(capsys, "process", folder / "char.usda", "--config", pasted, "-o", two)
    assert one.read_bytes() == two.read_bytes()
    plain = run(capsys, "process", folder / "char.usda", "--dry-run")
    heeded = run(capsys, "process", folder / "char.usda", "--dry-run", "--animation", folder / "take.usda")
    assert heeded["characters"][0]["solution"]["cost"] != plain["characters"][0]["solution"]["cost"]
    none = ("--set", "animation.weight=0")
    unweighted = run(capsys, "process", folder / "char.usda", "--dry-run", "--animation", folder / "take.usda", *none)
    assert unweighted["characters"][0]["solution"]["cost"] == plain["characters"][0]["solution"]["cost"]


def test_turning_joints_count_too(tmp_path, capsys):
    take = performed(tmp_path / "jaw.usda", {"chin": RAMP}, turn=20.0 * RAMP)
    asset = skinned_stages.character(tmp_path / "hinged.usda", animated_joints=("Hips/Head/Jaw",))
    told = run(capsys, "inspect", asset, "--animation", take)
    use = {each["control"]: each["use"] for each in told["characters"][0]["animation"]["controls"]}
    assert use["Jaw:rx"] > 0.1


def test_the_assets_own_animation_will_do(tmp_path, capsys):
    asset = skinned_stages.character(tmp_path / "char.usda")
    stage = Usd.Stage.Open(str(asset))
    skinned_stages.keyed(stage, {time: {"chin": value} for time, value in enumerate(RAMP.tolist())})
    stage.GetRootLayer().Save()
    told = run(capsys, "inspect", asset, "--animation", asset)
    (first, *_) = told["characters"][0]["animation"]["controls"]
    assert first["control"] == "chin"


# --- refusals ----------------------------------------------------------------------------------------
