"""Colours of a face: as USD says them, and found by layout and form where it says nothing."""

import numpy as np
import pytest
from folders import SAMPLE
from makers import changed
from PIL import Image
from pxr import Gf, Sdf, Usd, UsdGeom, UsdShade, Vt
from viewer_layouts import peak_layout

from usdrigui.character import Topology
from usdrigui.character.deform import deform
from usdrigui.character.rays import make_caster
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings
from usdrigui.stages.colours import colours_and_images
from usdrigui.view.body import complexion, shading
from usdrigui.view.directions import camera_rows

RED, BLUE = (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)
COUNTS, INDICES = np.array([4, 4]), np.array([0, 1, 4, 3, 1, 2, 5, 4])
HALVES = [RED, RED, BLUE, RED, RED, BLUE]
"""Two quads side by side: the left one's points and those of the right one's far edge."""


@pytest.fixture
def quads():
    stage = Usd.Stage.CreateInMemory()
    mesh = UsdGeom.Mesh.Define(stage, "/Mesh")
    mesh.CreatePointsAttr([(x, y, 0) for y in (0, 1) for x in (0, 1, 2)])
    mesh.CreateFaceVertexCountsAttr(COUNTS.tolist())
    mesh.CreateFaceVertexIndicesAttr(INDICES.tolist())
    return stage


def looks_of(stage):
    topology = Topology(COUNTS, INDICES, False, "")
    return colours_and_images(stage.GetPrimAtPath("/Mesh"), 6, topology, Usd.TimeCode.Default())


def colours_of(stage):
    return looks_of(stage)[0]


def material(stage, name, context="", **inputs):
    made = UsdShade.Material.Define(stage, f"/{name}")
    shader = UsdShade.Shader.Define(stage, f"/{name}/surface")
    shader.CreateIdAttr("UsdPreviewSurface")
    for key, value in inputs.items():
        shader.CreateInput(key, Sdf.ValueTypeNames.Color3f).Set(Gf.Vec3f(*value))
    made.CreateSurfaceOutput(context).ConnectToSource(shader.ConnectableAPI(), "surface")
    return made, shader


MIDDLE = (0.5, 0.0, 0.5)
BY_FACE = [RED, MIDDLE, BLUE] * 2


@pytest.mark.parametrize(
    ("interpolation", "values", "expected"),
    [
        ("constant", [RED], [RED] * 6),
        ("vertex", HALVES, HALVES),
        ("varying", HALVES, HALVES),
        ("uniform", [RED, BLUE], BY_FACE),
        ("faceVarying", [RED] * 4 + [BLUE] * 4, BY_FACE),
        ("vertex", [RED, BLUE], None),
        ("constant", [], None),
        ("vertex", [(np.nan, 0, 0)] * 6, None),
    ],
)
@pytest.mark.parametrize("indexed", [False, True])
def test_display_colours_of_every_interpolation(quads, interpolation, values, expected, indexed):
    primvar = UsdGeom.Mesh.Get(quads, "/Mesh").CreateDisplayColorPrimvar(interpolation)
    primvar.Set(Vt.Vec3fArray(values))
    if indexed:
        primvar.SetIndices(Vt.IntArray(range(len(values))))
    found = colours_of(quads)
    assert (found is None) if expected is None else np.array_equal(found, expected)


def test_a_materials_base_colour_goes_before_the_display_colour_and_a_subsets_before_the_meshs(quads):
    mesh = UsdGeom.Mesh.Get(quads, "/Mesh")
    mesh.CreateDisplayColorPrimvar("constant").Set([(0, 1, 0)])
    whole, _ = material(quads, "whole", diffuseColor=RED)
    UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(whole)
    assert np.array_equal(colours_of(quads), [RED] * 6)
    part, surface = material(quads, "part", "mtlx", base_color=RED)
    tint = part.CreateInput("tint", Sdf.ValueTypeNames.Color3f)
    tint.Set(BLUE)
    surface.GetInput("base_color").ConnectToSource(tint)
    subset = UsdShade.MaterialBindingAPI(mesh.GetPrim()).CreateMaterialBindSubset("part", Vt.IntArray([1]))
    UsdShade.MaterialBindingAPI.Apply(subset.GetPrim()).Bind(part)
    assert np.array_equal(colours_of(quads), BY_FACE)
    other, _ = material(quads, "other", somethingElse=RED)
    UsdShade.MaterialBindingAPI(mesh.GetPrim()).Bind(other)
    subset.GetIndicesAttr().Set([])
    assert colours_of(quads).tolist() == [[0, 1, 0]] * 6, "a shader that says no colour leaves the displayColor"


UV = [(0.25, 0.5), (0.25, 0.5), (0.75, 0.5)] * 2


@pytest.fixture
def textured(tmp_path):
    Image.fromarray(np.array([[[255, 0, 0], [0, 0, 255]]], dtype=np.uint8)).save(tmp_path / "skin.png")
    stage = Usd.Stage.CreateNew(str(tmp_path / "asset.usda"))
    mesh = UsdGeom.Mesh.Define(stage, "/Mesh")
    UsdGeom.PrimvarsAPI(mesh).CreatePrimvar("uv", Sdf.ValueTypeNames.TexCoord2fArray, "vertex").Set(UV)
    made, surface = material(stage, "skin", diffuseColor=RED)
    texture, reader = (UsdShade.Shader.Define(stage, f"/skin/{name}") for name in ("texture", "reader"))
    reader.CreateInput("varname", Sdf.ValueTypeNames.Token).Set("uv")
    texture.CreateIdAttr("UsdUVTexture")
    texture.CreateInput("file", Sdf.ValueTypeNames.Asset).Set("./skin.png")
    texture.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(reader.ConnectableAPI(), "result")
    surface.GetInput("diffuseColor").ConnectToSource(texture.ConnectableAPI(), "rgb")
    UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(made)
    return stage, surface, texture


def test_a_small_texture_is_read_at_the_points(textured, tmp_path):
    stage, surface, texture = textured
    assert np.array_equal(colours_of(stage), HALVES)
    Image.new("RGBA", (5000, 500), (0, 255, 0, 9)).save(tmp_path / "card.png")
    texture.GetInput("file").Set("./card.png")
    opacity = surface.CreateInput("opacity", Sdf.ValueTypeNames.Float)
    for given, alpha in ((surface, 255), (texture, 9)):
        opacity.ConnectToSource(given.ConnectableAPI(), "a")
        _, seen = looks_of(stage)
        assert [image.shape for image in seen.images] == [(102, 1024, 4)], "scaled down to what a page has room for"
        assert seen.images[0][0, 0].tolist() == [0, 255, 0, alpha], "what opacity cuts out"
        assert seen.uv.tolist() == [list(UV[point]) for point in INDICES]


def test_of_a_texture_in_tiles_a_face_has_the_one_that_its_middle_lies_on(textured, tmp_path):
    stage, _, texture = textured
    for tile, colour in ((1002, RED), (1011, BLUE)):
        Image.new("RGB", (1, 1), tuple(int(255 * part) for part in colour)).save(tmp_path / f"skin.{tile}.png")
    texture.GetInput("file").Set("./skin.<UDIM>.png")
    primvar = UsdGeom.PrimvarsAPI(stage.GetPrimAtPath("/Mesh")).GetPrimvar("uv")
    primvar.SetInterpolation("faceVarying")
    primvar.Set([(1, 0), (2, 0), (2, 1), (1, 1), (0, 1), (1, 1), (1, 2), (0, 2)])
    colours, seen = looks_of(stage)
    assert np.array_equal(colours, BY_FACE)
    assert seen.image.tolist() == [0, 1]
    (tmp_path / "skin.1002.png").unlink()
    assert looks_of(stage)[1].image.tolist() == [-1, 0], "a tile without a file has no image"


def test_a_transform_of_texture_coordinates_scales_turns_and_moves_them(textured):
    stage, _, texture = textured
    place = UsdShade.Shader.Define(stage, "/skin/place")
    for name, kind, value in (
        ("scale", "Float2", (2, 3)),
        ("rotation", "Float", 90),
        ("translation", "Float2", (4, 5)),
    ):
        place.CreateInput(name, getattr(Sdf.ValueTypeNames, kind)).Set(value)
    reader = UsdShade.Shader.Get(stage, "/skin/reader")
    place.CreateInput("in", Sdf.ValueTypeNames.Float2).ConnectToSource(reader.ConnectableAPI(), "result")
    texture.GetInput("st").ConnectToSource(place.ConnectableAPI(), "result")
    u, v = np.transpose([UV[point] for point in INDICES])
    assert np.allclose(looks_of(stage)[1].uv, np.transpose([4 - 3 * v, 5 + 2 * u]))


@pytest.mark.parametrize(
    ("kind", "name", "value"),
    [
        ("asset", "/skin/texture.inputs:file", "./asset.usda"),
        ("asset", "/skin/texture.inputs:file", "./large.png"),
        ("asset", "/skin/texture.inputs:file", "./none.png"),
        ("string", "/skin/texture.inputs:file", "./skin.png"),
        ("float2[]", "/Mesh.primvars:uv", [(np.nan, 0.5)] * 6),
        ("float3[]", "/Mesh.primvars:uv", [(0.5, 0.5, 0.0)] * 6),
        ("int2[]", "/Mesh.primvars:uv", [(0, 0)] * 6),
        ("token", "/skin/reader.inputs:varname", ""),
        ("color3f", "/skin/surface.inputs:diffuseColor", (np.nan, 0.0, 0.0)),
        ("float", "/skin/surface.inputs:diffuseColor", 0.5),
        ("token[]", "/skin/surface.inputs:diffuseColor", ["r", "g", "b"]),
    ],
)
def test_what_says_no_colour_gives_none(textured, tmp_path, kind, name, value):
    stage = textured[0]
    Image.new("1", (4097, 4096)).save(tmp_path / "large.png")
    prim, _, name = name.partition(".")
    stage.GetPrimAtPath(prim).RemoveProperty(name)
    attribute = stage.GetPrimAtPath(prim).CreateAttribute(name, Sdf.ValueTypeNames.Find(kind))
    attribute.Set(value)
    attribute.SetMetadata("interpolation", "vertex")
    assert colours_of(stage) is None


# --- found by layout and form ------------------------------------------------------------------------


@pytest.fixture(scope="module")
def sample():
    (rig,) = read_rigs(SAMPLE, Settings())
    return rig


def bare(rig):
    """The sample without a word about colour: neither values nor names that tell."""
    meshes = [changed(mesh, colours=None, path=f"/Char/part{i}") for i, mesh in enumerate(rig.body.meshes)]
    return changed(rig, meshes=tuple(meshes))


def test_colours_of_the_asset_are_taken_as_they_are(sample):
    found = complexion.complexion(sample, peak_layout(sample))
    assert np.array_equal(found.colours, np.concatenate([mesh.colours for mesh in sample.body.meshes]))
    assert not found.clear.any()
    assert (found.gaze > 2.0).all()


def test_form_finds_the_pupils_and_the_lips_that_colours_say(sample):
    """On the sample without its colours: its own tell where the pupils, the whites and the lips are."""
    plain = bare(sample)
    found = complexion.complexion(plain, peak_layout(plain))
    told = np.concatenate([mesh.colours for mesh in sample.body.meshes])
    names = np.repeat([mesh.path.rsplit("/", 1)[-1] for mesh in sample.body.meshes], np.diff(sample.body.starts))
    eyes, head = np.char.startswith(names, "Eye"), names == "Head"
    assert (np.abs(found.gaze[eyes]) <= 2.0).all()
    assert (found.gaze[~eyes] > 2.0).all()
    away = np.linalg.norm(found.gaze, axis=1)
    black, white = eyes & (told.max(axis=1) < 0.1), eyes & (told.min(axis=1) > 0.85)
    assert away[black].max() < away[white].min()
    redness = found.colours[:, 0] / found.colours[:, 1]
    lips = head & (told[:, 0] / told[:, 1] > 1.9)
    painted = head & (redness > 1.25 * redness[head].min())
    assert np.count_nonzero(painted & lips) > 0.5 * np.count_nonzero(painted)


@pytest.mark.parametrize(("inner", "before"), [(1.4, True), (1.1, True), (0.3, False)])
def test_what_covers_the_pupil_is_clear_or_bears_it(sample, inner, before):
    """A cap before the eye; off to the side of the pupil it is left as it is, like a lid."""
    plain = bare(sample)
    eye = next(
        mesh for mesh, told in zip(plain.body.meshes, sample.body.meshes, strict=True) if told.path.endswith("EyeLeft")
    )
    faces = np.split(eye.topology.face_indices, np.cumsum(eye.topology.face_counts)[:-1])
    front = [face for face in faces if (eye.points[face, 2] > inner).all()]
    beside = [face for face in front if (eye.points[face, 0] > 0.5).all()]
    cap = front if before else beside
    shell = changed(
        eye,
        path="/Char/shell",
        points=eye.points * 1.05,
        face_counts=np.array([*map(len, cap)]),
        face_indices=np.concatenate(cap),
        shapes=(),
    )
    rig = changed(plain, meshes=(*plain.body.meshes, shell))
    found = complexion.complexion(rig, peak_layout(rig))
    on_cap = slice(rig.body.starts[-2], None)
    assert (found.clear | (np.abs(found.gaze) <= 2.0).all(axis=1))[on_cap].any() == before
    assert not found.clear[: rig.body.starts[-2]].any()


def test_an_eye_is_black_then_coloured_then_white():
    away = np.array([0.0, 0.9 * shading.PUPIL, 0.5 * (shading.PUPIL + shading.IRIS), 1.1 * shading.IRIS, 1.0, 2.0])
    black, pupil, iris, white, edge, back = shading.eye_colours(np.stack([0.0 * away, away], axis=1)).sum(axis=1)
    assert black == pupil < iris < white == edge == back


def test_what_is_outside_is_open_to_the_light_and_what_is_inside_is_dark():
    """A closed box inside another, as the inside of a mouth is."""
    corners = np.array([[2.0 * (i >> axis & 1) - 1.0 for axis in range(3)] for i in range(8)])
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    triangles = np.array([face[:3] for face in faces] + [[face[0], *face[2:]] for face in faces])
    points, both = np.concatenate([corners, 0.5 * corners]), np.concatenate([triangles, triangles + 8])
    subject = shading.Subject(points, both, np.sign(points), 0.0 * points, points, make_caster(points[both]))
    open_, shut = np.split(shading.openness(subject), 2)
    assert open_.min() > 0.95
    assert shut.max() < 0.2
    look = shading.Complexion(np.ones((2, 3)), np.full((2, 2), 9.0), np.zeros(2, bool), np.array([1.0, 0.16]))
    assert look.shaded[0].tolist() == [1.0] * 3
    assert look.shaded[1, 0] > look.shaded[1, 1] == look.shaded[1, 2] > 0.05, "red goes last"


# --- real rigs ---------------------------------------------------------------------------------------

GAZES = {
    "facecap_blender": 2,
    "godette": 2,
    "hand_webxr": 0,
    "ict_face57": 2,
    "ict_parts17": 2,
    "mh_expr34": 0,
    "mh_poseunits": 2,
    "rocketbox_male17": 2,
    "rpm_xr": 2,
    "vitruvian": 2,
    "weboji_tiger": 2,
}
"""Eyes of each rig that can have a pupil."""


@pytest.mark.real
@pytest.mark.parametrize("name", GAZES)
def test_elements_are_on_skin_and_eyes_have_pupils(name):
    """Nine in ten points that controls of the face move most are of a colour that says what they are."""
    import real_rigs

    line = real_rigs.line_of(name)
    rig, layout = line.face.rig, line.layout
    found = complexion.complexion(rig, layout)
    points = [real_rigs.point_of(line, element) for element in real_rigs.on_face(line)]
    is_trim = (found.colours[points] == complexion._TRIM).all(axis=1) & (found.gaze[points, 0] > 2.0)
    assert is_trim.mean() <= 0.1
    across = camera_rows(layout, rig.up)[0]
    at = deform(rig, layout.base_values) @ across
    on_eye = np.linalg.norm(found.gaze, axis=1) < 1.2 * shading.IRIS
    middle = layout.frame.plane.origin @ across
    assert sum((on_eye & side).any() for side in (at > middle, at < middle)) == GAZES[name]
