"""Whatever type an attribute has, reading ends with a result or a documented refusal, never with a mistake of ours.

Every property that a full character or a layout authors is replaced by one of another type, as text (where the
type may be one that USD does not know) and as a crate (where the value need not be of the type named beside it).
"""

import json
import tempfile
import zipfile
from pathlib import Path

import minimal_assets
import numpy as np
import pytest
import skel_stages
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, Vt
from skel_stages import SIDE, add_animation, add_even_skin, add_mesh, add_shape, add_skeleton, matrix, new_stage

from usdrigui.character import Performance
from usdrigui.cli import main
from usdrigui.errors import RigUIError, catalogue
from usdrigui.isolation import record_stream
from usdrigui.layer import author
from usdrigui.reader import faults, reader_main
from usdrigui.reader.reader_records import FaultsResult, LayoutsResult, ReadResult, Request, Response
from usdrigui.reading.clips import read_performances
from usdrigui.settings import Settings, load
from usdrigui.stages import schema

SETTINGS = load(
    {
        "candidates": {"view": "/Camera"},
        "controls": {"smile": {"glyph": "/Star"}, "frown": {"glyph": "/Plate"}},
        "read": {"pose_names": "poses"},
    }
)
KINDS = {"rigs": ReadResult, "layouts": LayoutsResult, "faults": FaultsResult, "clips": tuple[Performance, ...]}
TEXTS = (
    'tokel[] {n} = ["smile", "frown"]',
    "tokel {n} = (1, 2, 3)",
    'string {n} = "ab"',
    'token {n} = "ab"',
    "int {n} = 3",
    "bool {n} = 1",
    "matrix4d {n} = ((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1))",
    'token[] {n} = ["smile", "frown"]',
    'string[] {n} = ["smile", "frown"]',
    "asset[] {n} = [@a@]",
    "double3[] {n} = [(1, 2, 3)]",
    "int2[] {n} = [(0, 1), (2, 3)]",
    "uint64[] {n} = [18446744073709551615, 0]",
    "{t} {n} = None",
    'tokel[] {n}.timeSamples = {{ 0: ["a"], 10: ["b"] }}',
    'string {n}.timeSamples = {{ 0: "ab", 10: "cd" }}',
    "int[] {n}.timeSamples = {{ 0: [1], 10: [1, 2] }}",
    "rel {n} = </Camera>",
)
"""Declarations of a property named n, whose own type is t."""
VALUES = (
    "ab",
    0.5,
    True,
    Sdf.AssetPath("a"),
    Gf.Matrix4d(1),
    Vt.StringArray(["smile", "frown"]),
    Vt.Vec2fArray([(1, 2)]),
    Vt.QuatfArray([Gf.Quatf(1)]),
)
_MARK = 'custom string wrong_type = "here"'


# --- the characters ----------------------------------------------------------------------------------


def everything(path):
    """A character that has what is read of meshes, shapes, skins, skeletons and animation; a camera; two glyphs."""
    stage, root = new_stage(path)
    local = matrix(), matrix(translation=(0, 1, 0))
    add_skeleton(stage, "/Char/Skel", ("neck", "neck/jaw"), local, transform=matrix((0, 10, 0)))
    add_animation(
        stage,
        "/Char/Anim",
        "/Char/Skel",
        ("smile", "frown"),
        {0.0: (0, 0), 10.0: (1, 1)},
        ("neck", "neck/jaw"),
        {0.0: local, 10.0: (matrix((0, 40, 0)), local[1])},
    )
    _face(stage)
    weights = stage.GetPrimAtPath("/Char/Anim").GetAttribute("blendShapeWeights")
    weights.SetMetadata("limits", {"soft": {"minimum": Vt.FloatArray([0, 0]), "maximum": Vt.FloatArray([1, 1])}})
    _around(stage)
    UsdGeom.XformCommonAPI(UsdGeom.Camera.Define(stage, "/Camera")).SetTranslate((0, 0, 5))
    _glyphs(stage)
    UsdGeom.Xformable(root).AddTransformOp().Set(matrix((30, 10, 0), (-4, 0, 1)))
    stage.GetRootLayer().Save()
    return path


def _face(stage):
    mesh = add_mesh(stage, "/Char/Face", "/Char/Skel")
    rng = np.random.default_rng(3)
    for token, indices in (("smile", range(4)), ("frown", None)):
        count = SIDE**2 if indices is None else len(indices)
        between = {0.5: rng.normal(size=(count, 3))}
        add_shape(mesh, token, rng.normal(size=(count, 3)), indices, between)
    joints = ["neck", "neck/jaw"]
    add_even_skin(mesh, 2, matrix(), "dualQuaternion", joints)
    mesh.CreateSubdivisionSchemeAttr("none")
    mesh.CreateOrientationAttr("leftHanded")
    mesh.CreateVisibilityAttr("inherited")
    mesh.CreatePurposeAttr("default")
    mesh.CreateExtentAttr([(0, 0, 0), (1, 1, 1)])
    UsdGeom.XformCommonAPI(mesh).SetTranslate((0, 0, 1))
    UsdGeom.XformCommonAPI(mesh).SetRotate((0, 0, 1))
    for kind in ("face", "point"):
        UsdGeom.Subset.CreateGeomSubset(mesh, kind, kind, [0, 1, 2], "parts")


def _around(stage):
    """Prims that have shapes without being able to show them."""
    for prim in (UsdGeom.Points.Define(stage, "/Char/Dots"), UsdGeom.Mesh.Define(stage, "/Char/Empty")):
        binding = UsdSkel.BindingAPI.Apply(prim.GetPrim())
        binding.CreateSkeletonRel().SetTargets(["/Char/Skel"])
        binding.CreateBlendShapesAttr(["smile"])
        binding.CreateBlendShapeTargetsRel().SetTargets(["/Char/Face/s_smile"])


def _glyphs(stage):
    corners = [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)]
    star, plate = UsdGeom.BasisCurves.Define(stage, "/Star"), UsdGeom.Mesh.Define(stage, "/Plate")
    star.CreatePointsAttr(corners)
    star.CreateCurveVertexCountsAttr([4])
    for attribute, value in (("Type", "cubic"), ("Basis", "bezier"), ("Wrap", "nonperiodic")):
        getattr(star, f"Create{attribute}Attr")(value)
    plate.CreatePointsAttr(corners)
    plate.CreateFaceVertexCountsAttr([4])
    plate.CreateFaceVertexIndicesAttr([0, 1, 2, 3])
    plate.CreateOrientationAttr("leftHanded")


def _stock():
    """Layers of the characters by name."""
    with tempfile.TemporaryDirectory() as folder:
        paths = {"everything": everything(Path(folder) / "everything.usda")}
        paths["character"] = skel_stages.character(Path(folder) / "character.usda")
        return {name: Sdf.Layer.OpenAsAnonymous(str(path)) for name, path in paths.items()}


def properties_of(layer):
    """Paths of the properties that a layer authors, in order."""
    found = []
    layer.Traverse(Sdf.Path.absoluteRootPath, lambda path: found.append(path) if path.IsPropertyPath() else None)
    return sorted(found)


def _cases():
    """Stock and property: the first of each name on each type of prim."""
    first = {}
    for name, layer in STOCK.items():
        for path in properties_of(layer):
            kind = layer.GetPrimAtPath(path.GetPrimPath()).typeName
            first.setdefault((kind, str(path.name)), (name, str(path)))
    return list(first.values())


STOCK = _stock()
CASES = _cases()


# --- replacing ---------------------------------------------------------------------------------------


def as_text(layer, path, declaration):
    """The layer as text with a property declared otherwise; its metadata stays."""
    copy = Sdf.Layer.CreateAnonymous(".usda")
    copy.TransferContent(layer)
    spec, prim = copy.GetPropertyAtPath(path), copy.GetPrimAtPath(Sdf.Path(path).GetPrimPath())
    own = isinstance(spec, Sdf.AttributeSpec)
    line = declaration.format(n=spec.name, t=spec.typeName if own else "token[]")
    keys = [key for key in ("elementSize", "interpolation") if own and spec.HasInfo(key)]
    if keys and not line.startswith("rel"):
        line += "(\n" + "\n".join(f"{key} = {json.dumps(spec.GetInfo(key))}" for key in keys) + "\n)"
    prim.RemoveProperty(spec)
    mark = Sdf.AttributeSpec(prim, "wrong_type", Sdf.ValueTypeNames.String)
    mark.custom, mark.default = True, "here"
    text = copy.ExportToString()
    assert text.count(_MARK) == 1
    return text.replace(_MARK, line)


def as_crate(layer, path, value, target):
    """Write the layer with a value of an attribute that is not of the attribute's type."""
    copy = Sdf.Layer.CreateAnonymous(".usdc")
    copy.TransferContent(layer)
    copy.GetPropertyAtPath(path).SetInfo("default", value)
    copy.Export(str(target))


def variants(layer, path, folder, texts=TEXTS, values=VALUES):
    """Files with a property of other types, one after the other; what is wrong with each."""
    for number, declaration in enumerate(texts):
        target = folder / f"{number}.usda"
        target.write_text(as_text(layer, path, declaration))
        yield target, declaration
    if isinstance(layer.GetPropertyAtPath(path), Sdf.AttributeSpec):
        for number, value in enumerate(values):
            target = folder / f"{number}.usdc"
            as_crate(layer, path, value, target)
            yield target, f"crate with {value!r}"


def refusal_of(task, path, settings=SETTINGS):
    """The refusal, or None for a result; the response can be handed over."""
    response = reader_main.answer(Request(task, str(path), settings))
    record_stream.decode(b"".join(record_stream.encode(response)), Response[KINDS[task]])
    return response.refusal


def end_of(task, path, settings=SETTINGS):
    """The code of the refusal, empty for a result."""
    refusal = refusal_of(task, path, settings)
    return refusal.code if refusal is not None else ""


def check(task, path, what, settings=SETTINGS):
    refusal = refusal_of(task, path, settings)
    assert refusal is None or refusal.code in set(catalogue()) - {"BUG"}, f"{task}: {what}: {refusal}"


# --- characters --------------------------------------------------------------------------------------


@pytest.mark.parametrize("task", ["rigs", "faults", "clips"])
def test_the_characters_are_sound(task, tmp_path):
    everything(tmp_path / "char.usda")
    assert end_of(task, tmp_path / "char.usda") == ""


@pytest.mark.parametrize(("name", "path"), CASES, ids=[f"{name}-{path}" for name, path in CASES])
def test_a_property_of_another_type(name, path, tmp_path):
    layer = STOCK[name]
    kind = layer.GetPrimAtPath(Sdf.Path(path).GetPrimPath()).typeName
    tasks = ["rigs", *(["faults"] if kind in ("Mesh", "BlendShape", "SkelAnimation") else [])]
    tasks += ["clips"] if kind == "SkelAnimation" else []
    settings = SETTINGS if name == "everything" else Settings()
    # Of every second declaration, the others of the next property.
    first = CASES.index((name, path)) % 2
    for target, what in variants(layer, path, tmp_path, TEXTS[first::2], VALUES[first::2]):
        for task in tasks:
            check(task, target, what, settings)


@pytest.mark.parametrize(
    ("path", "task", "end"),
    [
        ("/Char/Face.skel:blendShapes", "rigs", ""),
        ("/Char/Dots.skel:blendShapes", "rigs", ""),
        ("/Char/Face/s_smile.pointIndices", "rigs", ""),
        ("/Char/Face/face.indices", "rigs", ""),
        ("/Char/Anim.joints", "rigs", "ARRAY_TYPE"),
        ("/Char/Anim.rotations", "rigs", "ARRAY_TYPE"),
        ("/Char/Anim.joints", "clips", "ARRAY_TYPE"),
        ("/Char/Anim.blendShapes", "clips", "ARRAY_TYPE"),
    ],
)
@pytest.mark.parametrize("declaration", ['tokel[] {n} = ["smile"]', 'token {n} = "ab"', "bool {n} = 1"])
def test_the_code(path, task, end, declaration, tmp_path):
    target = tmp_path / "char.usda"
    target.write_text(as_text(STOCK["everything"], path, declaration))
    assert end_of(task, target) == end


def test_faults_name_the_prim_and_go_on(tmp_path):
    """A validator sees what else is wrong as well."""
    path = tmp_path / "char.usda"
    text = as_text(STOCK["everything"], "/Char/Face.skel:blendShapes", 'tokel[] {n} = ["a"]')
    path.write_text(text.replace('token[] blendShapes = ["smile", "frown"]', 'string blendShapes = "smile"'))
    stage = Usd.Stage.Open(str(path))
    found = {(each.code, each.path) for each in faults.stage_faults(stage)}
    assert {("ARRAY_TYPE", "/Char/Face"), ("ARRAY_TYPE", "/Char/Anim")} <= found


@pytest.mark.parametrize(
    "times", [("inf", "0"), ("-inf", "inf"), ("nan", "0"), ("nan", "nan"), ("-1e308", "1e308"), ("0", "1e308")]
)
@pytest.mark.parametrize("task", ["rigs", "faults", "clips"])
def test_time_samples_beyond_all_measure(times, task, tmp_path):
    path = tmp_path / "char.usda"
    first, last = times
    declaration = f"float[] {{n}}.timeSamples = {{{{ {first}: [0, 1], {last}: [1, 0] }}}}"
    path.write_text(as_text(STOCK["everything"], "/Char/Anim.blendShapeWeights", declaration))
    check(task, path, declaration)


# --- metadata ----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "field",
    [
        'upAxis = "Q"',
        'upAxis = "Z"',
        "metersPerUnit = 0",
        "metersPerUnit = inf",
        "metersPerUnit = nan",
        'metersPerUnit = "far"',
        "timeCodesPerSecond = 0",
        "timeCodesPerSecond = nan",
        'customLayerData = { string poses = "%s" }' % ("[" * 30_000),
        'customLayerData = { string poses = "{\\"a\\": 1%s, \\"b\\": NaN}" }' % ("0" * 400),
        'customLayerData = { string ranges = "{\\"smile\\": [0, 1%s]}" }' % ("0" * 400),
        *(f"customLayerData = {{ {each} }}" for kind in ("poses", "ranges") for each in [
            f"asset {kind} = @a@", f"matrix4d {kind} = ((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1))", f"bool {kind} = 1",
            f"quatd {kind} = (1, 0, 0, 0)", f"timecode {kind} = 1", f"double[] {kind} = [1]", f"asset[] {kind} = [@a@]",
            f"dictionary {kind} = {{ asset smile = @a@ }}", f"dictionary {kind} = {{ string smile = \"ab\" }}",
        ]),
    ],
    ids=lambda field: field[:60],
)  # fmt: skip
def test_metadata_of_the_layer(field, tmp_path):
    path = tmp_path / "char.usda"
    head, _, rest = STOCK["everything"].ExportToString().partition("(\n")
    path.write_text(f"{head}(\n{field}\n{rest}")
    check("rigs", path, field)


@pytest.mark.parametrize(
    "limits",
    [
        "dictionary soft = { string minimum = \"a\"\nbool maximum = 1 }",
        "dictionary soft = { token[] minimum = [\"a\", \"b\"]\nasset maximum = @a@ }",
        "dictionary soft = { double3[] minimum = [(1, 2, 3)]\ndouble2 maximum = (1, 2) }",
        "dictionary soft = { dictionary minimum = {}\ndouble maximum = 1 }",
        "double soft = 1",
        "string[] hard = [\"a\"]",
    ],
)  # fmt: skip
@pytest.mark.parametrize("task", ["rigs", "faults"])
def test_limits_of_another_type(limits, task, tmp_path):
    path = tmp_path / "char.usda"
    declaration = "float[] {n} = [0, 1] (\nlimits = {{\n" + limits.replace("{", "{{").replace("}", "}}") + "\n}}\n)"
    path.write_text(as_text(STOCK["everything"], "/Char/Anim.blendShapeWeights", declaration))
    check(task, path, limits)


@pytest.mark.parametrize("path", ["/Char/Face.primvars:skel:jointIndices", "/Char/Face.primvars:skel:jointWeights"])
@pytest.mark.parametrize(
    "field",
    [
        "elementSize = 0",
        "elementSize = -1",
        "elementSize = 2147483647",
        "elementSize = 1",
        'elementSize = "two"',
        'interpolation = "constant"',
        'interpolation = "nonsense"',
        "interpolation = 3",
    ],
)
def test_metadata_of_influences(path, field, tmp_path):
    target = tmp_path / "char.usda"
    name = path.rpartition(".")[2]
    kind = "int" if name.endswith("Indices") else "float"
    declaration = f"{kind}[] {name} = [0, 1] (\n{field}\n)"
    copy = Sdf.Layer.CreateAnonymous(".usda")
    copy.TransferContent(STOCK["everything"])
    for key in ("elementSize", "interpolation"):
        copy.GetPropertyAtPath(path).ClearInfo(key)
    target.write_text(as_text(copy, path, declaration.replace("{", "{{").replace("}", "}}")))
    check("rigs", target, field)


# --- layouts -----------------------------------------------------------------------------------------


_DECLARED = sorted({each.name for api in schema.APIS for each in author.properties(api).values()})
_DRAWN = ("points", "extent", "skel:blendShapes", "skel:blendShapeTargets", "curveVertexCounts", "faceVertexCounts")
_SOME = tuple(each for each in TEXTS if each.partition(" ")[0] in ("tokel[]", "string", "int", "double3[]", "rel"))


@pytest.fixture(scope="module")
def layout(tmp_path_factory):
    """The layer of the smallest character, every property of our schemas said."""
    path = minimal_assets.character(tmp_path_factory.mktemp("layout"))
    assert main(["process", str(path), "--quiet"]) == 0
    written = path.with_name("char.rigui.usda")
    layer = Sdf.Layer.OpenAsAnonymous(str(written))
    layer.subLayerPaths = [str(path)]
    correction = Sdf.CreatePrimInLayer(layer, f"/{layer.defaultPrim}/{schema.CORRECTIONS}/smile")
    correction.SetInfo("apiSchemas", Sdf.TokenListOp.CreateExplicit([schema.CORRECTION]))
    scope = layer.GetPrimAtPath(next(_holders(layer, schema.LAYOUT))[0])
    author.apply(scope, [schema.LAYOUT, f"{schema.PART}:face"])
    author.declare(scope, schema.PART, {"handleWidth": 1.0}, "face")
    for api in schema.APIS:
        _complete(layer, api)
    layer.Export(str(written))
    assert end_of("layouts", written, Settings()) == ""
    return layer


_WITHIN = {schema.ANCHOR: schema.ELEMENT, schema.HANDLE: schema.ELEMENT}
"""Schemas that are built into another one, which is what a layer applies."""


def _complete(layer, api):
    """Say on the first prim that has one of our schemas what its writer left to the fallbacks."""
    path, instance = next(_holders(layer, _WITHIN.get(api, api)))
    for declared in author.properties(api).values():
        name = declared.name.replace("__INSTANCE_NAME__", instance)
        spec = layer.GetPrimAtPath(path)
        if name not in spec.properties and declared.type_name:
            author.put(spec, name, declared.type_name, declared.fallback, uniform=True)
        elif name not in spec.properties:
            Sdf.RelationshipSpec(spec, name, custom=False)


def _holders(layer, api):
    stage = Usd.Stage.Open(layer)
    for prim in stage.TraverseAll():
        for name in prim.GetPrimTypeInfo().GetAppliedAPISchemas():
            if name.partition(":")[0] == api:
                # The layout is in a variant, whose selection is part of the path in the layer.
                path = next(spec.path for spec in prim.GetPrimStack() if spec.layer == layer)
                yield path, name.partition(":")[2]


@pytest.mark.parametrize("name", [*_DECLARED, *_DRAWN])
def test_a_property_of_a_layout_of_another_type(name, layout, tmp_path):
    head, mark, tail = name.partition("__INSTANCE_NAME__")
    paths = [
        each
        for each in properties_of(layout)
        if (each.name == name if not mark else each.name.startswith(head) and each.name.endswith(tail))
    ]
    if name == "curveVertexCounts" and not paths:
        pytest.skip("no handle is drawn as a curve")
    for target, what in variants(layout, paths[0], tmp_path, _SOME, VALUES[::3]):
        check("layouts", target, what, Settings())


# --- archives ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("error", [RecursionError, OverflowError, UnicodeDecodeError, MemoryError])
def test_whatever_zipfile_raises(error, tmp_path, monkeypatch):
    def fail(*_):
        raise error("utf-8", b"a", 0, 1, "is bad") if error is UnicodeDecodeError else error("so it is")

    path = tmp_path / "char.usdz"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("char.usda", STOCK["everything"].ExportToString())
    monkeypatch.setattr(zipfile.ZipFile, "testzip", fail)
    assert end_of("rigs", path) == ("SOURCE_MEMORY_LIMIT" if error is MemoryError else "FILE_CORRUPT")


def test_a_refusal_says_which_attribute(tmp_path):
    path = tmp_path / "char.usda"
    path.write_text(as_text(STOCK["everything"], "/Char/Anim.joints", "int[] {n} = [1]"))
    with pytest.raises(RigUIError, match="ARRAY_TYPE /Char/Anim: joints does not hold tokens"):
        read_performances(path)
