"""USD's and NVIDIA's validators find no more on a layout than on the character below it."""

from collections import Counter

import laid_out
import pytest
import real_rigs
from folders import SAMPLE
from pxr import Usd

from usdrigui import pipeline
from usdrigui.settings import load

SMALL = ("facecap_blender", "godette", "mh_poseunits", "openusd_blendshapes")
"""Rigs that NVIDIA's validator sees through in seconds."""
RIGS = [
    SAMPLE,
    *(
        pytest.param(path.resolve(), marks=pytest.mark.real)
        for path in sorted(real_rigs.ASSETS.glob("*.usd[ac]"))
        if path.stem in SMALL
    ),
]
SETTINGS = load({"solve": {"work_limit": real_rigs.WORK}})


def of_usd(path):
    """Name and message of what USD's validators find."""
    return Counter(laid_out.validation_errors(Usd.Stage.Open(str(path))))


def of_nvidia(path):
    """Rule, place and message of what NVIDIA's validator finds."""
    validator = pytest.importorskip("omni.asset_validator", reason="usd-validation-nvidia is not installed")
    issues = validator.ValidationEngine().validate(str(path)).issues()
    return Counter((each.rule.__name__, f"{_place(each.at)} {each.message}") for each in issues)


def _place(at):
    """Prim of a finding; the file's name is another in a layout and its source."""
    return getattr(at, "path", None) or getattr(getattr(at, "prim_id", None), "path", "")


@pytest.fixture(scope="module", params=RIGS, ids=lambda path: path.stem)
def layout(request, tmp_path_factory):
    """A character and its layout as text, of which validators ask more than of a crate."""
    source = request.param
    target = tmp_path_factory.mktemp(source.stem) / "layout.usda"
    pipeline.process(source, SETTINGS, output=target)
    return source, target


@pytest.mark.parametrize("find", [of_usd, of_nvidia])
def test_a_layout_adds_no_finding(layout, find):
    source, target = layout
    # NVIDIA's looks at each variant by itself, and finds the faults of the character once for each.
    assert set(find(target)) - set(find(source)) == set()
