"""The layer that schemas/CONTRACT.md writes out is a layout without faults."""

import re
import shutil
from pathlib import Path

import pytest

from usdrigui.pipeline import check
from usdrigui.settings import Settings

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "schemas" / "CONTRACT.md").read_text(encoding="utf-8")
EXAMPLE, PINNED = re.findall(r"```usda\n(.*?)```", PAGE, re.DOTALL)
AT = "uniform token familyName"


@pytest.fixture
def folder(tmp_path):
    for name in ("char.usda", "char_geometry.usda"):
        shutil.copy(ROOT / "sample_assets" / name, tmp_path)
    return tmp_path


def checked(folder, text):
    layer = folder / "hand.usda"
    layer.write_text(text, encoding="utf-8")
    return check(layer, Settings())


@pytest.mark.parametrize("text", [EXAMPLE, EXAMPLE.replace(AT, PINNED + AT)], ids=["least", "pinned"])
def test_the_example_of_the_contract_has_no_faults(folder, text):
    review = checked(folder, text)
    assert [each for each in review.issues if each.code != "LAYOUT_CONTROL_NEW"] == []
    ((_, found),) = review.characters
    assert [each.element for each in found.elements] == ["jawOpen"]
