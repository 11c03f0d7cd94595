"""Custom handles: curves and meshes from USD, fitted to their elements, in the layer, in pictures, in the page."""

from dataclasses import replace

import chain
import laid_out
import makers
import numpy as np
import pytest
import skinned_stages
from pxr import Sdf, Usd, UsdGeom
from scipy.interpolate import BSpline

from usdrigui.character import Glyph
from usdrigui.errors import RigUIError
from usdrigui.layer.read_layout import read_layout
from usdrigui.pose.evaluate import elements_at, evaluate, prepare
from usdrigui.reader.reader_process import read_layouts_isolated
from usdrigui.reading.character import read_rigs
from usdrigui.settings import ReadSettings, load
from usdrigui.view.body import shading
from usdrigui.view.flat import marks
from usdrigui.view.flat.pillow import painted
from usdrigui.view.flat.scene import Page, Panel

ARROW = """
def Mesh "Arrow" {
    point3f[] points = [(5, 7, -3), (4, 7, 0), (6, 7, 0)]
    int[] faceVertexCounts = [3]
    int[] faceVertexIndices = [0, 1, 2]
}
"""
"""It points to -Z: up, seen from above in a Y-up stage."""


def glyph_of(folder, text, name="Arrow", up="Y", **said):
    """Read one glyph beside a small character."""
    (folder / "glyphs.usda").write_text(f'#usda 1.0\n(\n upAxis = "{up}"\n)\n{text}')
    source = skinned_stages.character(folder / "char.usda")
    config = {"controls": {"chin": {"glyph": f"glyphs.usda</{name}>", **said}}}
    return read_rigs(source, load(config))[0].glyphs[f"glyphs.usda</{name}>"]


def curve(kind, points, counts=None, wrap="nonperiodic", basis="bezier"):
    listed = ", ".join(str(tuple(map(float, point))) for point in points)
    return f"""
def BasisCurves "Arrow" {{
    uniform token type = "{kind}"
    uniform token basis = "{basis}"
    uniform token wrap = "{wrap}"
    int[] curveVertexCounts = {counts or [len(points)]}
    point3f[] points = [{listed}]
}}
"""


# --- reading -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(("up", "seen"), [("Y", (1.0, -3.0, 2.0)), ("Z", (1.0, 2.0, 3.0))])
def test_right_up_and_towards_the_viewer_are_those_of_a_view_from_above(tmp_path, up, seen):
    """A line from (-1, -2, -3) to (1, 2, 3)."""
    glyph = glyph_of(tmp_path, curve("linear", [(-1, -2, -3), (1, 2, 3)]), up=up)
    assert glyph.points[1] * np.sqrt(14.0) == pytest.approx(seen)


def test_a_mesh_is_seen_from_above_centred_and_of_radius_one(tmp_path):
    glyph = glyph_of(tmp_path, ARROW)
    assert glyph.form == "mesh"
    assert np.allclose(glyph.points[0, :2] / glyph.points[0, 1], [0.0, 1.0])  # the tip is up
    assert np.linalg.norm(glyph.points, axis=1).max() == pytest.approx(1.0)
    assert np.allclose(glyph.points.min(axis=0) + glyph.points.max(axis=0), 0.0)
    assert (glyph.counts.tolist(), glyph.indices.tolist()) == ([3], [0, 1, 2])


def test_transforms_above_count_but_place_and_size_do_not(tmp_path):
    turned = 'def Xform "Set" { double3 xformOp:translate = (9, 9, 9)\n double xformOp:rotateY = 90\n'
    turned += "float3 xformOp:scale = (4, 4, 4)\n"
    turned += 'uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateY", "xformOp:scale"]\n'
    seen = glyph_of(tmp_path, turned + ARROW + "}", "Set/Arrow").points
    plain = glyph_of(tmp_path, ARROW).points
    assert np.allclose(seen, plain @ [[0.0, 1, 0], [-1, 0, 0], [0, 0, 1]], atol=1e-6)  # a quarter turn to the left


def test_a_left_handed_mesh_is_turned_over(tmp_path):
    text = ARROW.replace("point3f", 'uniform token orientation = "leftHanded"\n point3f')
    assert glyph_of(tmp_path, text).indices.tolist() == [2, 1, 0]


def test_faces_of_a_mirrored_glyph_look_up_all_the_same(tmp_path):
    mirror = '{\n double3 xformOp:scale = (-1, 1, 1)\n uniform token[] xformOpOrder = ["xformOp:scale"]'
    straight, mirrored = glyph_of(tmp_path, ARROW), glyph_of(tmp_path, ARROW.replace("{", mirror, 1))

    def up(glyph):
        a, b, c = glyph.points[glyph.indices]
        return np.sign(np.cross(b - a, c - a)[2])

    assert up(straight) == up(mirrored) != 0


def test_a_prim_of_the_asset_itself(tmp_path):
    source = skinned_stages.character(tmp_path / "char.usda")
    layer = Sdf.Layer.FindOrOpen(str(source))
    spec = Sdf.CreatePrimInLayer(layer, "/Glyphs/Ring")
    spec.specifier, spec.typeName = Sdf.SpecifierDef, "BasisCurves"
    stage = Usd.Stage.Open(layer)
    ring = UsdGeom.BasisCurves(stage.GetPrimAtPath("/Glyphs/Ring"))
    ring.CreateTypeAttr("linear")
    ring.CreateWrapAttr("periodic")
    ring.CreateCurveVertexCountsAttr([3])
    ring.CreatePointsAttr([(0, 0, 0), (1, 0, 0), (0, 0, 1)])
    stage.Save()
    (rig,) = read_rigs(source, load({"controls": {"chin": {"glyph": "/Glyphs/Ring"}}}))
    glyph = rig.glyphs["/Glyphs/Ring"]
    assert (glyph.form, glyph.counts.tolist()) == ("curve", [4])
    assert np.array_equal(glyph.points[0], glyph.points[3])


def de_casteljau(points, t):
    while len(points) > 1:
        points = (1 - t) * points[:-1] + t * points[1:]
    return points[0]


RNG = np.random.default_rng(3)
VERTICES = RNG.normal(size=(7, 3))
PINNED = np.array([2.0 * VERTICES[0] - VERTICES[1], *VERTICES, 2.0 * VERTICES[-1] - VERTICES[-2]])


def fitted(points):
    """As the reader fits points of a Y-up stage."""
    seen = np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1)
    seen = seen - 0.5 * (seen.min(axis=0) + seen.max(axis=0))
    return seen / np.linalg.norm(seen, axis=1).max()


@pytest.mark.parametrize(
    ("basis", "pieces"),
    [
        ("bezier", [VERTICES[:4], VERTICES[3:]]),
        (
            "catmullRom",
            [
                [b, b + (c - a) / 6, c + (b - d) / 6, c]
                for a, b, c, d in zip(PINNED, *(PINNED[k:] for k in (1, 2, 3)), strict=False)
            ],
        ),
    ],
)
def test_pinned_pieces_are_followed(tmp_path, basis, pieces):
    glyph = glyph_of(tmp_path, curve("cubic", VERTICES, wrap="pinned", basis=basis))
    true = [de_casteljau(np.array(each), t) for each in pieces for t in np.arange(6) / 6]
    assert np.abs(glyph.points - fitted(np.array([*true, VERTICES[-1]]))).max() < 1e-6


@pytest.mark.parametrize(
    ("wrap", "before", "after"),
    [
        ("nonperiodic", [], []),
        ("periodic", [], VERTICES[:3]),
        ("pinned", PINNED[:1], PINNED[-1:]),
    ],
)
def test_splines_are_followed(tmp_path, wrap, before, after):
    glyph = glyph_of(tmp_path, curve("cubic", VERTICES, wrap=wrap, basis="bspline"))
    through = np.array([*before, *VERTICES, *after])
    true = BSpline(np.arange(len(through) + 4) - 3.0, through, 3)(np.arange(6 * len(through) - 17) / 6)
    assert np.abs(glyph.points - fitted(true)).max() < 1e-6


def test_a_file_that_is_no_usd_holds_no_glyph(tmp_path):
    with pytest.raises(RigUIError, match="FILE_NOT_USD"):
        glyph_of(tmp_path, "def Mesh")


# --- fitting -----------------------------------------------------------------------------------------

FLAG = Glyph("flag", "mesh", np.array([[0.0, 1, 0], [-0.6, 0, 0], [0.8, -0.6, 0]]), np.array([3]), np.array([0, 1, 2]))


def laid(**controls):
    said = chain.settings(controls={name: {"glyph": "flag", **more} for name, more in controls.items()})
    return chain.lay_out(makers.changed(makers.face(), glyphs={"flag": FLAG}), said)


@pytest.fixture(scope="module")
def line():
    return laid(smile_L={}, smile_R={}, chin={"glyph_size": 3.0}, pucker={"glyph_size": 0.0})


def test_a_glyph_changes_nothing_but_the_shape(line):
    plain, own = chain.by_name(chain.lay_out(makers.face())), chain.by_name(line)
    assert plain.keys() == own.keys()
    for name, element in own.items():
        assert element.anchor.point == plain[name].anchor.point
        for with_glyph, without in zip(element.members, plain[name].members, strict=True):
            assert np.array_equal(with_glyph.track, without.track)
            assert np.array_equal(with_glyph.values, without.values)
    assert {name for name, element in own.items() if element.glyph} == {"smile_L", "smile_R", "chin", "pucker"}


def test_sizes_follow_handle_or_track(line):
    elements, width = chain.by_name(line), line.layout.frame.handle_width
    across = {n: 2.0 * np.linalg.norm(elements[n].glyph.points, axis=1).max() for n in ("smile_L", "chin", "pucker")}
    track = elements["pucker"].members[0].track
    assert across["smile_L"] == pytest.approx(width)
    assert across["chin"] == pytest.approx(3.0 * width)
    assert across["pucker"] == pytest.approx(np.linalg.norm(np.diff(track, axis=0), axis=1).sum())


def test_a_glyph_lies_upright_in_the_skin(line):
    element = chain.by_name(line)["smile_L"]
    normal, points = element.anchor.normal, element.glyph.points
    assert np.abs(points @ normal).max() < 1e-9 * line.layout.frame.handle_width
    assert points[0] @ [0.0, 1.0, 0.0] > 0.0  # its tip is up
    outwards = np.cross(points[1] - points[0], points[2] - points[0])
    assert outwards @ normal > 0.0


def test_the_elements_of_a_pair_are_mirror_images(line):
    left, right = (chain.by_name(line)[name] for name in ("smile_L", "smile_R"))
    assert np.allclose(
        right.glyph.points, left.glyph.points * [-1.0, 1.0, 1.0], atol=0.01 * line.layout.frame.handle_width
    )
    first, second, third = right.glyph.points[right.glyph.indices]
    assert np.cross(second - first, third - first) @ right.anchor.normal > 0.0


# --- drawn -------------------------------------------------------------------------------------------

WAVE = Glyph(
    "wave", "curve", np.array([[-1.0, 0, 0], [0, 0.5, 0.2], [1, 0, 0], [0, 0, 0], [0, 1, 0]]),
    np.array([3, 2]), np.arange(5),
)  # fmt: skip


def with_glyphs(layout):
    width = layout.frame.handle_width
    made = [replace(glyph, points=width * glyph.points) for glyph in (FLAG, WAVE)]
    elements = tuple(replace(each, glyph=made[i % 2]) for i, each in enumerate(layout.elements))
    return replace(layout, elements=elements)


@pytest.mark.parametrize("kind", [{}, {"method": "dualQuaternion", "moved": True}, {"skinned": False}])
@pytest.mark.parametrize("adapt", ["deform", "static"])
def test_glyphs_follow_the_face_wherever_usdskel_takes_it(tmp_path, kind, adapt):
    source = skinned_stages.character(tmp_path / "char.usda", animated_joints=("Hips/Head",), **kind)
    (rig,) = read_rigs(source, load({}))
    layout = with_glyphs(laid_out.layout_of(rig, beside=("brow_L",), adapt=adapt, only=["brow_L", "chin", "half"]))
    rng = np.random.default_rng(4)
    # What a single weight drives; a still handle shows nothing else, and shapes bend what joints only turn.
    poses = [rig.defaults, laid_out.random_values(rig, rng)]
    stage = laid_out.baked(laid_out.written(source, rig, layout), rig, poses)
    poser, size = prepare(rig, layout), laid_out.diagonal(rig)
    for time, values in enumerate(poses):
        for element, at in zip(layout.elements, evaluate(poser, values).elements, strict=True):
            drawn = laid_out.handle(stage, rig.path, element, time)
            if element.glyph.form == "curve":
                drawn = 0.5 * (drawn[::2] + drawn[1::2])
            assert np.abs(drawn - at.glyph).max() < 1e-5 * size, (element.name, time)


def test_glyphs_come_back_from_the_layer(tmp_path):
    source = skinned_stages.character(tmp_path / "char.usda")
    (rig,) = read_rigs(source, load({}))
    layout = with_glyphs(laid_out.layout_of(rig, beside=("brow_L",)))
    layer = laid_out.written(source, rig, layout)
    assert not laid_out.validation_errors(Usd.Stage.Open(layer))
    (back,) = read_layouts_isolated(tmp_path / "char.rigui.usda", ReadSettings()).layouts
    for one, other in zip(layout.elements, back.elements, strict=True):
        assert (one.glyph.name, one.glyph.form) == (other.glyph.name, other.glyph.form)
        assert np.allclose(one.glyph.points, other.glyph.points, atol=1e-6)
        assert np.array_equal(one.glyph.counts, other.glyph.counts)
        assert np.array_equal(one.glyph.indices, other.glyph.indices)


@pytest.mark.parametrize(
    ("old", "new"),
    [("glyphIndices = [0, 1, 2]", "glyphIndices = [0, 1, 3]"), ("Counts = [3, 2]", "Counts = [3, 3]")],
)
def test_a_glyph_that_its_handle_contradicts_is_refused(tmp_path, old, new):
    source = skinned_stages.character(tmp_path / "char.usda")
    (rig,) = read_rigs(source, load({}))
    text = laid_out.written(source, rig, with_glyphs(laid_out.layout_of(rig))).ExportToString()
    assert old in text
    broken = tmp_path / "broken.usda"
    broken.write_text(text.replace(old, new))
    with pytest.raises(RigUIError, match="LAYOUT_INVALID"):
        read_layout(broken)


def test_pictures_show_the_glyph_where_it_is():
    rig = makers.face()
    layout = laid_out.layout_of(rig, only=["chin"])
    camera = shading.Camera(np.eye(3), np.zeros(3), 100.0, 300, 300)
    for glyph in (FLAG, WAVE):
        element = replace(layout.elements[0], glyph=replace(glyph, points=0.4 * glyph.points))
        own = replace(layout, elements=(element,))
        (at,) = elements_at(prepare(rig, own), own.base_values)
        mark = marks.mark(element, at, camera, 0.06)
        page = Page((300, 300), (Panel((0, 0), (300, 300), None, (mark,)),))
        drawn = np.asarray(painted(page)).min(axis=2) < 200
        enlarged = max(1.0, 3.2 / (50.0 * layout.frame.handle_width))
        centre = camera.project(at.handle)[:2]
        tip = centre + enlarged * (camera.project(at.glyph[2])[:2] - centre)
        x, y = (0.9 * tip + 0.1 * centre).astype(int)
        assert drawn[y - 2 : y + 3, x - 2 : x + 3].any()
        assert np.linalg.norm(tip - centre) > 20.0
