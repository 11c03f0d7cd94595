"""The Blender extension as far as it goes without Blender: its archive, its mathematics, its reading of layers."""

import importlib
import json
import re
import sys
import zipfile
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import laid_out
import numpy as np
import pytest
import skinned_stages
from pxr import Sdf, Usd

import usdrigui
from usdrigui.clients import blender_extension
from usdrigui.errors import RigUIError
from usdrigui.layer.read_layout import read_layout
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

ROOMS = ("layout", "reading", "screen", "tracking", "joints", "posing")


@pytest.fixture(scope="module")
def extension(tmp_path_factory):
    """The rooms of the built extension that need no Blender, by name."""
    folder = tmp_path_factory.mktemp("built")
    blender_extension.write_extension(folder / "one.zip")
    zipfile.ZipFile(folder / "one.zip").extractall(folder)
    sys.path.insert(0, str(folder))
    yield {room: importlib.import_module(f"usdrigui_controls.{room}") for room in ROOMS}
    sys.path.remove(str(folder))
    for name in [name for name in sys.modules if name.startswith("usdrigui_controls")]:
        del sys.modules[name]


@pytest.fixture(scope="module")
def laid(tmp_path_factory):
    source = skinned_stages.character(tmp_path_factory.mktemp("char") / "char.usda", moved=True, meshes=2)
    (rig,) = read_rigs(source, Settings())
    layout = laid_out.layout_of(rig, beside=("chin",), groups=[("brow_L", "smile_L"), ("chin",), ("jaw:open",)])
    layout = replace(
        layout,
        elements=(
            replace(layout.elements[0], opposed=((1, 0),)),
            *layout.elements[1:],
        ),
    )
    target = source.with_name("char.rigui.usda")
    laid_out.written(source, rig, layout)
    return rig, layout, target


# --- the archive --------------------------------------------------------------------------------------


def test_the_archive_is_the_same_every_time_and_whole(tmp_path):
    for name in ("one.zip", "two.zip"):
        blender_extension.write_extension(tmp_path / name)
    assert (tmp_path / "one.zip").read_bytes() == (tmp_path / "two.zip").read_bytes()
    names = zipfile.ZipFile(tmp_path / "one.zip").namelist()
    assert {"usdrigui_controls/__init__.py", "usdrigui_controls/blender_manifest.toml"} <= {*names}


def test_it_brings_nothing_of_ours_and_says_one_version():
    files = blender_extension.extension_files()
    for name, content in files.items():
        if name.endswith(".whl"):
            continue
        imported = re.findall(r"^\s*(?:from|import) (\w+)", content.decode(), re.MULTILINE)
        assert not {"usdrigui", "scipy", "highspy", "msgspec", "networkx"} & set(imported), name
    manifest = files["blender_manifest.toml"].decode()
    assert re.search(r'^version = "([\d.]+)"', manifest, re.MULTILINE)[1] == usdrigui.__version__


@pytest.mark.parametrize("name", blender_extension._SHARED)
def test_the_rules_it_shares_are_our_own_files(name):
    shared = blender_extension.extension_files()[f"maths/{Path(name).name}"]
    assert shared == (Path(usdrigui.__file__).parent / name).read_bytes()


# --- mathematics --------------------------------------------------------------------------------------


def front(extension):
    """A view along -z without perspective: one unit is ten pixels."""
    matrix = np.diag([0.05, 1.0 / 15.0, -0.01, 1.0])
    return extension["screen"].Screen(matrix, 400.0, 300.0, np.array([0.0, 0.0, 1.0]), False)


def test_pixels_and_their_world_vectors(extension):
    screen = front(extension)
    assert screen.project([[0, 0, 0], [1, 2, 3]]) == pytest.approx(np.array([[200, 150], [210, 130]]))
    right, up = screen.axes_at(np.array([1.0, 2.0, 3.0]))
    assert right == pytest.approx([0.1, 0, 0])
    assert up == pytest.approx([0, 0.1, 0])


def test_points_behind_the_viewer_are_nowhere(extension):
    matrix = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, -1, -0.2], [0, 0, -1, 0]], dtype=np.float64)
    screen = extension["screen"].Screen(matrix, 100, 100, np.zeros(3), True)
    assert np.isfinite(screen.project([[0, 0, -1]])).all()
    assert np.isnan(screen.project([[0, 0, 1]])).all()


def placed(extension, at, normal=(0, 0, 1), value=0.0):
    at, normal = np.array(at, dtype=np.float64), np.array(normal, dtype=np.float64)
    return extension["tracking"].Placed((np.array([at, np.add(at, (2.0, 0, 0))]),), (), at, normal, 1.0, (value,))


def test_the_nearest_handle_that_faces_the_viewer_is_picked(extension):
    screen, pick = front(extension), extension["screen"].pick
    shown = [placed(extension, (0, 0, 0)), placed(extension, (1, 0, 0)), placed(extension, (0.8, 0, 0), (0, 0, -1))]
    assert pick(screen, shown, np.array([203.0, 150.0]), [3.0] * 3) == 0
    assert pick(screen, shown, np.array([206.5, 150.0]), [3.0] * 3) == 1
    assert pick(screen, shown, np.array([230.0, 150.0]), [3.0] * 3) == -1
    assert pick(screen, shown, np.array([230.0, 150.0]), [3.0, 40.0, 3.0]) == 1
    assert pick(screen, [], np.array([0.0, 0.0]), []) == -1


def slider(extension, low=0.0, high=1.0):
    return extension["tracking"].Drawing(
        SimpleNamespace(axes=((0,),)),
        values=(np.array([low, high]),),
        tracks=(np.array([[0.0, 0, 0], [2.0, 0, 0]]),),
        area=np.zeros((0, 3)),
        base=np.array([low]),
        ranges=np.array([[low, low, high]]),
    )


def test_a_grab_follows_the_pointer_from_where_it_took_hold(extension):
    def grab(at):
        return extension["screen"].Grab(front(extension), slider(extension), placed(extension, (0, 0, 0), value=at))

    held = grab(0.0)
    assert held.to((10.0, 0.0)) == pytest.approx([0.5])
    assert held.to((30.0, 0.0)) == pytest.approx([1.0])
    assert grab(0.5).to((1.0, 0.0)) == pytest.approx([0.55])


def test_a_face_is_mirrored_and_flipped_as_on_the_page(extension):
    face = json.loads(Path(__file__).parents[1].joinpath("mirrored_poses.json").read_text())
    made = SimpleNamespace
    for each in face["elements"]:
        each["members"] = [made(control=name, reversed=i in each["reversed"]) for i, name in enumerate(each["members"])]
    elements = [made(**each) for each in face["elements"]]
    layout = made(
        controls=[made(**each, base=each["rest"]) for each in face["controls"]],
        elements=elements,
        element=lambda name: next((each for each in elements if each.name == name), None),
    )
    posing = extension["posing"]
    for pose in face["poses"]:
        values = {each.name: pose["values"].get(each.name, each.base) for each in layout.controls}
        given = {side: posing.mirrored_from(layout, values, side) for side in ("left", "right")}
        given["flipped"] = posing.flipped(layout, values, face["crosses"].__contains__)
        for name, found in given.items():
            assert {**values, **found} == pytest.approx({**values, **pose[name]}), name
    assert posing.with_partners({"eyeLeft": 20.0, "smileLeft": 0.2}, layout) == pytest.approx(
        {"eyeLeft": 20.0, "eyeRight": -20.0, "smileLeft": 0.2, "smileRight": 0.4}
    )


def test_joint_moves_survive_the_way_through_a_bone(extension):
    rng = np.random.default_rng(8)
    rotations = importlib.import_module("usdrigui_controls.maths.rotation").rotations
    for _ in range(20):
        bind, rest = np.eye(4), np.eye(4)
        bind[:3, :3], bind[3, :3] = rotations(rng.normal(size=3)), rng.normal(size=3)
        rest[:3, :3], rest[3, :3] = np.diag(rng.uniform(0.5, 2, 3)) @ rotations(rng.normal(size=3)), rng.normal(size=3)
        frame = extension["joints"].JointFrame(bind, rest)
        move = rng.normal(size=(3, 3)) * 0.6
        assert frame.move(*frame.basis(move)) == pytest.approx(move, abs=1e-9)


# --- reading ------------------------------------------------------------------------------------------


def test_a_layer_is_read_as_our_own_reader_does_and_survives_json(extension, laid):
    rig, layout, layer = laid
    (found,) = extension["reading"].read_layouts(Usd.Stage.Open(str(layer)))
    assert found == extension["layout"].from_json(extension["layout"].to_json(found))
    assert found.root == layout.root
    assert [each.width for each in found.elements] == pytest.approx([layout.frame.handle_width] * len(found.elements))
    assert [each.name for each in found.elements] == [each.name for each in layout.elements]
    for mine, theirs in zip(found.elements, layout.elements, strict=True):
        assert mine.axes == theirs.axes
        assert (mine.point, bool(mine.mesh)) == (theirs.anchor.point, not theirs.anchor.on_board)
        for one, other in zip(mine.members, theirs.members, strict=True):
            assert one.control == other.control
            assert one.values == pytest.approx(other.values)
            assert np.array(one.track) == pytest.approx(other.track, abs=1e-5)
    assert {mesh.path: mesh.points for mesh in found.meshes} == {
        mesh.path: len(mesh.points) for mesh in rig.body.meshes
    }


def test_handles_are_as_wide_as_those_of_their_part(extension, laid):
    rig, layout, source = laid
    names = ("face", *["hands"] * (len(layout.elements) - 1))
    parted = laid_out.parted(layout, {"face": 0.02, "hands": 0.3}, names)
    target = source.with_name("parts.rigui.usda")
    laid_out.written(source.with_name("char.usda"), rig, parted, target.name)
    stage = Usd.Stage.Open(str(target))
    (found,) = extension["reading"].read_layouts(stage)
    assert {each.name: each.width for each in found.elements} == pytest.approx(
        {each.name: 0.02 if each.part == "face" else 0.3 for each in parted.elements}
    )


def test_base_values_that_lack_controls_are_refused(extension, laid):
    stage = Usd.Stage.Open(str(laid[2]))
    stage.SetEditTarget(stage.GetSessionLayer())
    scope = stage.GetPrimAtPath(f"{laid[1].root}/RigUI")
    scope.CreateAttribute("rigUI:layout:baseValues", Sdf.ValueTypeNames.DoubleArray).Set([1.0])
    with pytest.raises(extension["layout"].LayoutError, match="values of the base pose"):
        extension["reading"].read_layouts(stage)


@pytest.mark.parametrize("family", ["RigUILayout", "RigUIElement", "RigUIControl"])
def test_a_later_version_of_any_schema_is_refused(extension, laid, family):
    later = laid[2].with_name("later.usda")
    later.write_text(laid[2].read_text().replace(f"{family}API", f"{family}API_1"))
    with pytest.raises(extension["layout"].LayoutError, match="later version"):
        extension["reading"].read_layouts(Usd.Stage.Open(str(later)))


@pytest.mark.parametrize("opposes", [("smile_L", "brow_L"), ("brow_L", ""), ("chin", "")])
def test_both_readers_refuse_axes_that_share_an_end_or_have_none(extension, laid, opposes):
    stage = Usd.Stage.Open(str(laid[2]))
    stage.SetEditTarget(stage.GetSessionLayer())
    prim = laid_out.element_prim(stage, laid[1].root, laid[1].elements[0])
    for control, other in zip(("brow_L", "smile_L"), opposes, strict=True):
        prim.CreateAttribute(f"rigUI:control:{control}:opposes", Sdf.ValueTypeNames.Token).Set(other)
    with pytest.raises(extension["layout"].LayoutError, match="opposes"):
        extension["reading"].read_layouts(stage)
    with pytest.raises(RigUIError, match="LAYOUT_INVALID"):
        read_layout(stage)


def test_text_that_is_no_layout_is_refused(extension):
    for text in ("", "{}", "[1]", '{"root": 1}'):
        with pytest.raises(extension["layout"].LayoutError):
            extension["layout"].from_json(text)


def test_a_stage_without_layout_has_none(extension):
    assert extension["reading"].read_layouts(Usd.Stage.CreateInMemory()) == ()
