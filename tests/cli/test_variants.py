"""Assets as studios build them: a layout for every level of detail, in its variant, and what commands make of it."""

import json

import numpy as np
import pytest
import studio_assets
from pxr import Sdf, Usd

import usdrigui
from usdrigui.cli import main
from usdrigui.layer.read_layout import layout_paths, read_layout
from usdrigui.pipeline import check
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load

LAYER = "char.rigui.usda"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    folder = tmp_path_factory.mktemp("studio")
    asset = studio_assets.asset(folder)
    assert main(["process", str(asset), "--each-variant", "LOD", "-q", "--report", str(folder / "report.json")]) == 0
    return folder


@pytest.fixture
def folder(folder, monkeypatch):
    monkeypatch.chdir(folder)
    return folder


def selected(path, **variants):
    stage = Usd.Stage.Open(str(path))
    stage.SetEditTarget(stage.GetSessionLayer())
    for name, variant in variants.items():
        stage.GetPrimAtPath("/Char").GetVariantSet(name).SetVariantSelection(variant)
    return stage


def layouts(path):
    """By level, the one layout that its variant brings."""
    return {level: read_layout(selected(path, LOD=level))[0] for level in studio_assets.LEVELS}


def test_the_selected_level_brings_its_own_layout(made):
    """Each anchor is a point of that level's mesh; a level without shapes brings none, and the asset is untouched."""
    for level, (columns, rows) in studio_assets.LEVELS.items():
        stage = selected(made / LAYER, LOD=level)
        (layout,) = read_layout(stage)
        assert {each.anchor.point_count for each in layout.elements} == {columns * rows}
        limits = stage.GetAttributeAtPath("/Char/Anim.blendShapeWeights").GetMetadata("limits")
        assert limits is None or len(limits["soft"]["maximum"]) == 12
    assert not selected(made / LAYER, LOD="box").GetPrimAtPath("/Char/RigUI")
    own = Sdf.Layer.FindOrOpen(str(made / LAYER))
    assert "LOD" not in own.GetPrimAtPath("/Char").variantSelections


def test_levels_agree(made):
    """The same elements of the same controls, each within a face's edge of where it is on the first level."""
    first, *others = layouts(made / LAYER).values()
    places = {each.name: (each.controls, each.anchor.position) for each in first.elements}
    for other in others:
        assert {each.name: each.controls for each in other.elements} == {n: c for n, (c, _) in places.items()}
        for each in other.elements:
            assert np.linalg.norm(each.anchor.position - places[each.name][1]) < 0.14, (
                other.variant_path,
                each.name,
            )


def test_the_report_tells_the_variants(made):
    report = json.loads((made / "report.json").read_text())
    characters = report["characters"]
    assert [each["variant_path"] for each in characters] == [f"/Char{{LOD={each}}}" for each in ("high", "low", "mid")]
    assert list(characters[1]["matchings"]) == ["/Char{LOD=high}"], "the level that is selected comes first"
    assert [each["path"] for each in report["issues"] if each["code"] == "VARIANT_LEFT_OFF"] == ["{LOD=box}"]


COMMANDS = [
    ("check", LAYER, "--each-variant", "LOD", "--strict"),
    ("check", LAYER, "--variant", "LOD=low", "--strict"),
    ("picture", LAYER, "--variant", "LOD=low", "-o", "low.png"),
    ("view", LAYER, "--variant", "LOD=mid", "--html", "mid.html"),
    ("picker", LAYER, "--variant", "LOD=mid", "--svg", "mid.svg"),
    ("inspect", "char.usda", "--variant", "LOD:low", "--variant", "costume=mask"),
    ("diff", LAYER, LAYER, "--each-variant", "LOD", "--strict"),
    ("openjd", "char.usda", "--each-variant", "LOD", "-o", "job.json"),
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda each: each[0])
def test_every_command_takes_variants(folder, command):
    assert main([*command]) == 0
    if command[0] == "openjd":
        assert "--each-variant" in (folder / "job.json").read_text()


def test_check_looks_at_each(folder):
    """What is wrong with one level alone is found in it."""
    stage = Usd.Stage.Open(LAYER)
    edited = Sdf.Layer.FindOrOpen(str(folder / "char_low.usda"))
    points = edited.GetAttributeAtPath("/Char/Geo/face.points")
    points.default = [(x, y + 0.3, z) for x, y, z in points.default]
    edited.Save()
    del stage
    found = check(folder / LAYER, load({"read": {"each_variant": ["LOD"]}}))
    assert dict(found.characters).keys() == {"/Char{LOD=high}", "/Char{LOD=mid}", "/Char{LOD=low}"}
    assert {each.code for each in check(folder / LAYER, load()).issues} <= {"LAYOUT_UNCLEAR"}
    low = dict(found.characters)["/Char{LOD=low}"]
    assert any(each.code == "LAYOUT_STALE" or each.severity != "info" for each in low.issues)


def test_a_bare_layer_is_attached_and_detached(folder):
    """The asset itself then brings each level's layout, and is laid out again in place."""
    before = (folder / "char.usda").read_bytes()
    (folder / "char.rigui.toml").write_text('[read]\neach_variant = ["LOD"]\n')  # as the option says it
    assert main(["process", "char.usda", "--bare", "-o", "ui.usda", "-q"]) == 0
    assert main(["attach", "char.usda", "ui.usda"]) == 0
    assert {each.variant_path for each in layouts(folder / "char.usda").values()} == {
        f"/Char{{LOD={each}}}" for each in studio_assets.LEVELS
    }
    assert main(["check", "char.usda", "--strict", "-q"]) == 0
    assert main(["detach", "char.usda", "ui.usda"]) == 0
    assert (folder / "char.usda").read_bytes() == before


def test_the_layout_of_a_variant_is_attached_whichever_the_asset_selects(folder):
    """Of one level after the other, the second selected by hand; each brings its own."""
    before = (folder / "char.usda").read_bytes()
    for level, options in (("low", ()), ("mid", ("--variant", "LOD=mid"))):
        assert main(["process", "char.usda", "--bare", "--variant", f"LOD={level}", "-o", f"{level}.usda", "-q"]) == 0
        assert main(["attach", "char.usda", f"{level}.usda", *options]) == 0
        assert main(["check", "char.usda", "--variant", f"LOD={level}", "--strict", "-q"]) == 0
        (layout,) = read_layout(selected(folder / "char.usda", LOD=level))
        assert layout.variant_path == f"/Char{{LOD={level}}}"
    for level in ("low", "mid"):
        assert main(["detach", "char.usda", f"{level}.usda"]) == 0
    assert (folder / "char.usda").read_bytes() == before


def test_what_is_processed_again_keeps_every_level(folder):
    again = ["process", "char.usda", "--each-variant", "LOD", "--previous", LAYER, "-o", "again.usda", "-q"]
    assert main(again) == 0
    first, second = (layout_paths(Sdf.Layer.FindOrOpen(str(folder / each))) for each in (LAYER, "again.usda"))
    assert len(first) == 3
    assert first == second
    assert main(["diff", LAYER, "again.usda", "--each-variant", "LOD", "--strict"]) == 0


def test_a_layout_of_level_and_costume(folder):
    """A set that is selected, and not walked through, stands in the path too."""
    command = ["process", "char.usda", "--each-variant", "LOD", "--variant", "costume=mask", "-o", "both.usda", "-q"]
    assert main(command) == 0
    assert read_layout(selected(folder / "both.usda", costume="mask", LOD="mid"))
    assert not selected(folder / "both.usda", LOD="mid").GetPrimAtPath("/Char/RigUI")


def test_a_shot_of_three(folder):
    """Levels that the shot selects, each with its layout; what it adds stands in the variants of its characters."""
    shot = studio_assets.shot(folder / "shot.usda", f"./{LAYER}")
    assert main(["check", "shot.usda", "--strict", "-q"]) == 0
    found = {each.root: each.variant_path for each in read_layout(Usd.Stage.Open(str(shot)))}
    assert found == {"/Shot/hero": "/Shot/hero{LOD=high}", "/Shot/friend": "/Shot/friend{LOD=low}"} | {
        "/Shot/crowd": "/Shot/crowd{LOD=high}"
    }
    studio_assets.add_shape(shot, "/Shot/friend")
    assert main(["process", "shot.usda", "--base", LAYER, "-q"]) == 0
    added = Sdf.Layer.FindOrOpen(str(folder / "shot.rigui.usda"))
    assert [*map(str, layout_paths(added))] == ["/Shot/friend{LOD=low}{rigUI=ui}RigUI"]
    assert main(["check", "shot.rigui.usda", "-q"]) == 0


def test_an_open_stage_is_laid_out_by_variant(folder):
    stage = Usd.Stage.Open(str(folder / "char.usda"))
    report = usdrigui.process(stage, load({"read": {"each_variant": ["LOD"]}}))
    assert len(layout_paths(report.layer)) == 3
    assert stage.GetPrimAtPath("/Char").GetVariantSet("LOD").GetVariantSelection() == "high"


def test_rigid_parts_that_are_instances_are_read(made):
    (rig,) = read_rigs(made / "char.usda", load())
    assert {mesh.path for mesh in rig.body.meshes} >= {"/Char/Eyes/L/ball", "/Char/Eyes/R/ball"}
    (proxy,) = (mesh for mesh in rig.body.meshes if mesh.path == "/Char/Proxy")
    assert not proxy.visible
