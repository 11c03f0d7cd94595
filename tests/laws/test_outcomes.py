"""What comes out for some characters, in figures (tests/figures.py): rig, layout, layer, pictures, picker and page."""

from __future__ import annotations

import json
import zlib

import chain
import figures
import limbs
import pytest
import skinned_stages
from pxr import Usd
from valid_rigs import SMALL, make_rig
from written_rigs import write_rig

from usdrigui import check, load_settings, process
from usdrigui.cli import main
from usdrigui.clients import picker
from usdrigui.pipeline.joining import joined
from usdrigui.view.flat.pillow import painted
from usdrigui.view.picture import Wanted, scene
from usdrigui.view.web.packing import pack

WANTED = Wanted(size=(480, 320), labels=True)


def sample(folder):
    main(["sample", str(folder)])
    return folder / "char.usda"


def skinned(folder):
    return skinned_stages.character(folder / "char.usda", moved=True, reordered=True, meshes=2)


ASKED = {
    "controls": {
        "chin": {"glyph": "/World/Char/face0"},
        "half": {"place": "board"},
        "brow_L": {"near": "/World/Char/face0#40"},
    },
    "groups": {"groups": {"mouth": ["smile_L", "sneer_L"], "middle": ["pucker", "jaw:open"]}},
    "joints": {"Hips/Head/Jaw": {"axes": ["x", "y"], "minimum": -20, "maximum": 20}},
    "levels": {"groups": True, "poses": True},
    "parts": {"controls": {"brow_R": "muzzle"}},
    "poses": {"grin": {"weights": {"smile_L": 1.0, "smile_R": 0.5}}},
    "read": {"pose": {"brow_L": 0.5}},
}
CASES = {
    "skinned": (skinned, load_settings()),
    "asked": (skinned, load_settings(ASKED)),
    "printed": (skinned, load_settings(preset="paper")),
    "drawn": (lambda folder: make_rig(0, folder / "char.usda", SMALL), load_settings()),
    "written": (lambda folder: write_rig(0, folder), load_settings()),
    "sample": (sample, load_settings()),
}
"""Makers of assets, and settings."""


def shown(rig, layout):
    """What views show of a layout, at its base pose and at half of the largest value of every control."""
    half = [0.5 * control.maximum for control in rig.controls]
    picture = scene(rig, layout, None, WANTED)
    page = zlib.decompress(pack([(rig, layout)], "Title"))
    return {
        "picture": picture,
        "painted": painted(picture),
        "posed": scene(rig, layout, half, WANTED),
        "picker": picker.picker([(rig, layout)], labels=True),
        "dwpicker": json.loads(picker.to_dwpicker(picker.picker([(rig, layout)]), "name")),
        "page": json.loads(page[4 : 4 + int.from_bytes(page[:4], "little")]),
    }


def test_a_character_in_parts():
    rig = limbs.whole_body()
    layout = joined(chain.laid_parts(rig))
    assert figures.other_than_kept("parts", {"layout": layout, **shown(rig, layout)}) == {}


@pytest.mark.parametrize("name", CASES)
def test_a_character(name, tmp_path):
    make, settings = CASES[name]
    layer = tmp_path / "char.rigui.usda"
    (character,) = process(make(tmp_path), settings, output=layer).characters
    stage = Usd.Stage.Open(str(layer))
    drawn = [prim for prim in stage.Traverse() if "/RigUI" in str(prim.GetPath())]
    outcome = {
        "character": character,
        "review": check(layer).characters,
        "prims": [f"{prim.GetTypeName()} {prim.GetName()}" for prim in drawn],
        "layer": [{each.GetName(): each.Get() for each in prim.GetAuthoredAttributes()} for prim in drawn],
        **shown(character.rig, character.layout),
    }
    assert figures.other_than_kept(name, outcome) == {}


def test_characters_beside_an_earlier_layout(tmp_path):
    asset, layer = sample(tmp_path), tmp_path / "char.rigui.usda"
    process(asset, load_settings({"objective": {"handle_size": 0.08}}), output=layer)
    heeding = (asset, "previous"), (asset.with_name("hero.usda"), "like")
    made = [process(each, dry_run=True, **{option: layer}).characters for each, option in heeding]
    assert figures.other_than_kept("earlier", made) == {}
