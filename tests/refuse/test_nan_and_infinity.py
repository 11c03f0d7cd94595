# ruff: noqa: E501  (pieces of text: one piece, one line)
"""NaN and infinity wherever a character can hold a number: refused by code and prim, or without any effect."""

from dataclasses import fields, is_dataclass

import minimal_assets
import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from pxr import Gf, Sdf
from test_values_of_any_type import CASES, SETTINGS, STOCK, check, end_of

from usdrigui.character.deform import deform
from usdrigui.errors import RigUIError
from usdrigui.reading.character import read_characters, read_rigs
from usdrigui.settings import Settings

BAD = (float("nan"), float("inf"), float("-inf"))


def spoilt(value, bad):
    """The value with its last number replaced; None where it has no number that can be NaN."""
    if isinstance(value, float):
        return bad
    if isinstance(value, (Gf.Quatf, Gf.Quatd, Gf.Quath)):
        return type(value)(bad, value.GetImaginary())
    if isinstance(value, Gf.Matrix4d):
        return Gf.Matrix4d(*[[*row] for row in (value[0], value[1], value[2], (*list(value[3])[:3], bad))])
    kind = type(value).__name__
    if kind.startswith("Vec") and not kind.endswith(("i", "Array")):
        return type(value)(*list(value)[:-1], bad)
    if kind.endswith("Array") and len(value):
        last = spoilt(value[len(value) - 1], bad)
        return None if last is None else type(value)([*list(value)[:-1], last])
    return None


def finite(record):
    """Whether no array and no number in the record is NaN or infinite."""
    if isinstance(record, np.ndarray):
        return record.dtype.kind != "f" or bool(np.isfinite(record).all())
    if is_dataclass(record):
        return all(finite(getattr(record, each.name)) for each in fields(record))
    if isinstance(record, (tuple, list)):
        return all(map(finite, record))
    if isinstance(record, dict):
        return all(map(finite, record.values()))
    return not isinstance(record, float) or bool(np.isfinite(record))


def spoilt_layers(name, path):
    """The character with one number of the property spoilt, once for each way and for the first time sample."""
    spec = STOCK[name].GetPropertyAtPath(path)
    if not isinstance(spec, Sdf.AttributeSpec):
        return
    times = STOCK[name].ListTimeSamplesForPath(path)
    for bad in BAD:
        copy = Sdf.Layer.CreateAnonymous(".usda")
        copy.TransferContent(STOCK[name])
        value = spoilt(copy.QueryTimeSample(path, times[-1]) if times else spec.default, bad)
        if value is None:
            return
        if times:
            copy.SetTimeSample(path, times[-1], value)
        else:
            copy.GetPropertyAtPath(path).default = value
        yield copy, bad


NUMERIC = [case for case in CASES if next(spoilt_layers(*case), None) is not None]


def test_there_are_numbers_to_spoil():
    names = {str(Sdf.Path(path).name) for _, path in NUMERIC}
    assert {
        "points",
        "offsets",
        "inbetweens:b0",
        "bindTransforms",
        "restTransforms",
        "rotations",
        "translations",
    } <= names
    assert {"scales", "blendShapeWeights", "primvars:skel:jointWeights", "primvars:skel:geomBindTransform"} <= names


def fault_of_configuration(target, told):
    """Code of what the reader finds in a prim that the configuration names, a glyph; it is refused with all the rest."""
    return next((each.code for each in read_characters(target, told).faults.issues), "")


@pytest.mark.parametrize(("name", "path"), NUMERIC, ids=[f"{name}-{path}" for name, path in NUMERIC])
def test_a_number_that_is_none(name, path, tmp_path):
    told = SETTINGS if name == "everything" else Settings()
    for layer, bad in spoilt_layers(name, path):
        target = tmp_path / "char.usda"
        layer.Export(str(target))
        end = end_of("rigs", target, told) or fault_of_configuration(target, told)
        assert end in ("", "NOT_FINITE", "SKELETON_INVALID"), f"{bad}: {end}"
        assert end or finite(read_rigs(target, told)), f"{bad} went through"
        check("faults", target, bad, told)


@pytest.mark.parametrize("bad", ["nan", "inf", "-inf", "1e39"])
@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("[(0,0,1), (0,0,0.5)]", "[(0,0,1), (0,0,0.5)]\nuniform vector3f[] inbetweens:a = [(0,0,1), (0,0,1)] (weight = BAD)"),
        ("[0, 0]", "[0, 0] (limits = {{ dictionary hard = {{ float[] minimum = [BAD, 0]; float[] maximum = [1, BAD] }} }})"),
        ('upAxis = "Y"', 'upAxis = "Y"\ncustomLayerData = {{ dictionary ranges = {{ double[] smile = [BAD, 1] }} }}'),
        ("metersPerUnit = 0.01", "metersPerUnit = BAD"),
    ],
    ids=["in-between", "limits", "ranges", "metersPerUnit"],
)  # fmt: skip
def test_metadata_that_is_no_number(old, new, bad, tmp_path):
    path = minimal_assets.character(tmp_path)
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new.replace("{{", "{").replace("}}", "}").replace("BAD", bad), 1))
    (rig,) = read_rigs(path, Settings())
    assert finite(rig)
    assert {each.code for each in rig.issues} <= {"INBETWEEN_INVALID", "RANGE_INVALID", "UNITS_TYPE"}


# --- whatever stage ----------------------------------------------------------------------------------

NUMBERS = st.sampled_from(["0", "1", "-1", "0.5", "3", "1e30", "-2e-30", "nan", "inf", "-inf"])
VECTORS = st.tuples(NUMBERS, NUMBERS, NUMBERS).map(lambda row: f"({', '.join(row)})")
INDICES = st.integers(-2, 9).map(str)
NAMES = st.sampled_from(["smile", "frown", "neck", "neck/jaw", "", "a b", "ä"]).map(lambda name: f'"{name}"')
PATHS = st.sampled_from(["Char", "Char/Face", "Char/Face/smile", "Char/Face/frown", "Char/Skel", "Char/Anim", "No"])


def lists(of, *, unique=False):
    return st.lists(of, max_size=7, unique=unique).map(lambda items: f"[{', '.join(items)}]")


RELATIONS = lists(PATHS.map(lambda path: f"</{path}>"), unique=True)
PIECES = {
    "[(0,0,0), (2,0,0), (2,3,0), (0,3,0), (4,0,0), (4,3,0)]": lists(VECTORS),
    "[4, 4]": lists(INDICES),
    "[0, 1, 2, 3, 1, 4, 5, 2]": lists(INDICES),
    "[(0,0,1), (0,0,0.5)]": lists(VECTORS),
    "pointIndices = [0, 1]": lists(INDICES).map("pointIndices = {}".format),
    "[(0,0,0), (0,0,0), (0,0,0), (0,0,0), (0,0,0.3), (0,0,1)]": lists(VECTORS),
    "blendShapeWeights = [0, 0]": lists(NUMBERS).map("blendShapeWeights = {}".format),
    '["neck", "neck/jaw"]': lists(NAMES),
    'token[] blendShapes = ["smile", "frown"]': lists(NAMES).map("token[] blendShapes = {}".format),
    'token[] skel:blendShapes = ["smile", "frown"]': lists(NAMES).map("token[] skel:blendShapes = {}".format),
    "[</Char/Face/smile>, </Char/Face/frown>]": RELATIONS,
    "rel skel:skeleton = </Char/Skel>": RELATIONS.map("rel skel:skeleton = {}".format),
    "rel skel:animationSource = </Char/Anim>": RELATIONS.map("rel skel:animationSource = {}".format),
    "[0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]": lists(INDICES),
    "[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0]": lists(NUMBERS),
    "elementSize = 2": st.integers(-1, 3).map("elementSize = {}".format),
    '"vertex"': st.sampled_from(['"constant"', '"uniform"', '"faceVarying"']),
    "((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1))": NUMBERS.map("((1,0,0,0),(0,{},0,0),(0,0,1,0),(0,0,0,1))".format),
    'def SkelRoot "Char"': st.sampled_from(['class SkelRoot "Char"', 'def Xform "Char"', 'over "Char"']),
}
"""Pieces of the smallest character, and what may stand in their place."""


@st.composite
def stages(draw):
    """The smallest character with up to three of its arrays, relationships and types drawn anew."""
    text = minimal_assets.TEXT
    for old in draw(st.lists(st.sampled_from(sorted(PIECES)), min_size=1, max_size=3, unique=True)):
        assert old in text
        text = text.replace(old, draw(PIECES[old]), draw(st.integers(1, 2)))
    return text


@settings(max_examples=250, deadline=None)
@given(stages())
def test_any_stage_is_refused_or_read_into_finite_records(tmp_path_factory, text):
    path = tmp_path_factory.mktemp("any") / "char.usda"
    path.write_text(text)
    check("faults", path, text, Settings())
    end = end_of("rigs", path, Settings())
    assert end != "BUG"
    if end:
        with pytest.raises(RigUIError, match=end) as caught:
            read_rigs(path, Settings())
        assert caught.value.issue.message
        return
    rigs = read_rigs(path, Settings())
    assert finite(rigs)
    for rig in rigs:
        points = deform(rig, [control.maximum for control in rig.controls])
        assert points.shape == (sum(len(mesh.points) for mesh in rig.body.meshes), 3)
