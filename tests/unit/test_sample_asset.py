"""The embedded sample is what its script makes, and holds every feature it promises."""

from __future__ import annotations

import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest
from folders import ROOT
from pxr import Usd

SAMPLES = ROOT / "sample_assets"
ENTRY = SAMPLES / "char.usda"
FILES = ("char.usda", "char_geometry.usda")


@cache
def stage() -> Usd.Stage:
    return Usd.Stage.Open(str(ENTRY))


# --- the files ---------------------------------------------------------------------------------------


def test_script_makes_the_committed_bytes(tmp_path: Path) -> None:
    subprocess.run([sys.executable, SAMPLES / "make_char.py", tmp_path], check=True, timeout=120, capture_output=True)
    for name in FILES:
        assert (tmp_path / name).read_bytes() == (SAMPLES / name).read_bytes(), (
            f"{name}: run sample_assets/make_char.py"
        )


def test_stays_small() -> None:
    assert sum((SAMPLES / name).stat().st_size for name in FILES) < 1_500_000


def test_it_may_be_passed_on() -> None:
    assert stage().GetRootLayer().customLayerData["licence"] == "Apache-2.0"


def test_validators_find_no_error() -> None:
    validation = pytest.importorskip("pxr.UsdValidation")
    registry = validation.ValidationRegistry()
    found = validation.ValidationContext(registry.GetOrLoadAllValidators()).Validate(stage())
    assert [each.GetMessage() for each in found] == []
