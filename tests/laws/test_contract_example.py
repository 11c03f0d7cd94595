"""The layer that schemas/CONTRACT.md writes out is a layout without faults, and what is left out of
it, or put wrong, is told."""

import re
import shutil
from pathlib import Path

import pytest
from pxr import Usd

from usdrigui.pipeline import check, load_layer
from usdrigui.pose.evaluate import prepare
from usdrigui.reader.faults import layout_faults
from usdrigui.settings import Settings

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "schemas" / "CONTRACT.md").read_text(encoding="utf-8")
EXAMPLE, PINNED = re.findall(r"```usda\n(.*?)```", PAGE, re.DOTALL)
AT, SKELETON = "uniform token familyName", "rel skel:skeleton"
LISTED = 'uniform token[] rigUI:layout:baseControls = [{}]\nuniform token purpose = "guide"'
SHAPES = 'rigUI:control:jawOpen:blendShapes = ["jawOpen"]'
JOINTS = "uniform token[] rigUI:control:jawOpen:joints"


@pytest.fixture
def layer(tmp_path):
    for name in ("char.usda", "char_geometry.usda"):
        shutil.copy(ROOT / "sample_assets" / name, tmp_path)
    return tmp_path / "hand.usda"


@pytest.mark.parametrize("text", [EXAMPLE, EXAMPLE.replace(AT, PINNED + AT)], ids=["least", "pinned"])
def test_the_example_of_the_contract_has_no_faults(layer, text):
    layer.write_text(text, encoding="utf-8")
    review = check(layer, Settings())
    (unlisted,) = review.issues  # once, not once for every control
    assert (unlisted.code, unlisted.path) == ("LAYOUT_CONTROL_NEW", "/Char")
    ((_, found),) = review.characters
    assert [each.element for each in found.elements] == ["jawOpen"]
    ((rig, layout),) = load_layer(layer, Settings()).characters
    assert prepare(rig, layout).rows.tolist() == [0]  # a viewer shows it


def test_controls_that_a_layout_lists_are_not_news(layer):
    layer.write_text(EXAMPLE, encoding="utf-8")
    ((rig, _),) = load_layer(layer, Settings()).characters
    names = ", ".join(f'"{each.name}"' for each in rig.controls[:-1])
    layer.write_text(EXAMPLE.replace('uniform token purpose = "guide"', LISTED.format(names)), encoding="utf-8")
    assert [each.path for each in check(layer, Settings()).issues] == [rig.controls[-1].name]


def test_values_of_the_base_pose_are_those_of_the_names_beside_them(layer):
    layer.write_text(EXAMPLE, encoding="utf-8")
    ((rig, _),) = load_layer(layer, Settings()).characters
    names = rig.control_names
    listed = LISTED.format(", ".join(f'"{name}"' for name in reversed(names)))
    values = f"double[] rigUI:layout:baseValues = {list(reversed(range(len(names))))}"
    text = EXAMPLE.replace('uniform token purpose = "guide"', f"{values}\n{listed}")
    layer.write_text(text, encoding="utf-8")
    ((_, layout),) = load_layer(layer, Settings()).characters
    assert layout.base_values.tolist() == list(range(len(names)))


@pytest.mark.parametrize(
    ("old", "new", "severity", "told"),
    [
        (r".*rigUI:role.*\n", "", "error", "no face has the role 'handle'"),
        (r'\["handle"\]', '["handle", "track"]', "error", "has 2 roles for 1 faces"),
        (
            r'token\[\] primvars:rigUI:role = \["handle"\]',
            "int[] primvars:rigUI:role = [1]",
            "error",
            "is int[], not token[]",
        ),
        (r"int\[\] indices = \[0\]", "int[] indices = [1]", "error", "its faces are not those of its mesh"),
        (r".*familyName.*\n", "", "warning", "familyName"),
        (r".*anchor:position.*\n", "", "error", "its handle is 12.5 from rigUI:anchor:position"),
        (
            r"(trackPoints = )\[\(0, -10.0787, 7.4466\)",
            r"\1[(0, -10.0787, 9.9)",
            "error",
            "its anchor is up to 2.45 from",
        ),
        (r".*control:jawOpen:blendShapes.*\n", "", "error", "the control drives nothing"),
        (re.escape(SHAPES), SHAPES.replace("jawOpen", "nosuch").replace(":nosuch:", ":jawOpen:"), "error", "'nosuch'"),
        (re.escape(SHAPES), f'{SHAPES}\n{JOINTS} = ["Head"]', "error", "keys are missing"),
        (r'"RigUIDrawingAPI", ', "", "error", "RigUIDrawingAPI is missing"),
    ],
)
def test_what_a_layer_by_hand_gets_wrong_is_reported_at_its_prim(layer, old, new, severity, told):
    text, count = re.subn(old, new, EXAMPLE, count=1)
    assert count
    layer.write_text(text, encoding="utf-8")
    found = layout_faults(Usd.Stage.Open(str(layer)))
    (fault,) = [each for each in found if told in each.message or told in each.path]
    assert fault.code in ("LAYOUT_INVALID", "LAYOUT_TRACK", "LAYOUT_DRAWN")
    assert fault.severity == severity
    assert fault.path.startswith("/Char/RigUI/Controls")
    assert fault.repair
