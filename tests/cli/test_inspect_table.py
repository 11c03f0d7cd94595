"""The table of `usdrigui inspect`: shares that are small are not told as nothing."""

import json

import pytest
import skinned_stages

from usdrigui.cli import main
from usdrigui.terminal import _percent


@pytest.mark.parametrize(
    ("share", "text"),
    [(0.0, "0 %"), (1e-9, "<1 %"), (0.0049, "<1 %"), (0.0051, "1 %"), (1.0, "100 %"), (float("nan"), "-")],
)
def test_small_shares_are_not_nothing(share, text):
    assert _percent(share) == text


def test_every_visible_control_covers_something(tmp_path, capsys):
    character = skinned_stages.character(tmp_path / "char.usda")
    assert main(["inspect", str(character), "--json"]) == 0
    (only,) = json.loads(capsys.readouterr().out)["characters"]
    shares = {row["control"]: row["coverage"] for row in only["controls"]}
    assert min(shares.values()) > 0.0
    assert shares["brow_L"] == pytest.approx(shares["brow_R"], rel=0.2)
    assert main(["inspect", str(character)]) == 0
    table = capsys.readouterr().out
    assert f"{100 * shares['brow_L']:.0f} %" in table


def test_what_the_configuration_sends_beside_is_said(tmp_path, capsys):
    character = skinned_stages.character(tmp_path / "char.usda")
    character.with_suffix(".rigui.toml").write_text('[controls.chin]\nplace = "beside"\n')
    assert main(["inspect", str(character), "--json"]) == 0
    (only,) = json.loads(capsys.readouterr().out)["characters"]
    flags = {row["control"]: row["flags"] for row in only["controls"]}
    assert "beside by request" in flags["chin"]
    assert "global" not in flags["chin"]
