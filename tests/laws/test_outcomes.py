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

from usdrigui import process
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


ASSETS = {
    "skinned": lambda folder: skinned_stages.character(folder / "char.usda", moved=True, reordered=True, meshes=2),
    "drawn": lambda folder: make_rig(0, folder / "char.usda", SMALL),
    "written": lambda folder: write_rig(0, folder),
    "sample": sample,
}


def shown(rig, layout):
    """A layout and what views show of it, at its base pose and half of the way to the end of every control."""
    half = [(control.default + control.maximum) / 2.0 for control in rig.controls]
    picture = scene(rig, layout, None, WANTED)
    page = zlib.decompress(pack([(rig, layout)], "Title"))
    return {
        "layout": layout,
        "picture": picture,
        "painted": painted(picture),
        "posed": scene(rig, layout, half, WANTED),
        "picker": picker.picker([(rig, layout)], labels=True),
        "dwpicker": json.loads(picker.to_dwpicker(picker.picker([(rig, layout)]), "name")),
        "page": json.loads(page[4 : 4 + int.from_bytes(page[:4], "little")]),
    }


def test_a_character_in_parts():
    rig = limbs.whole_body()
    assert figures.other_than_kept("parts", shown(rig, joined(chain.laid_parts(rig)))) == {}


@pytest.mark.parametrize("name", ASSETS)
def test_a_character(name, tmp_path):
    asset = ASSETS[name](tmp_path)
    layer = tmp_path / "char.rigui.usda"
    (character,) = process(asset, output=layer).characters
    stage = Usd.Stage.Open(str(layer))
    drawn = [prim for prim in stage.Traverse() if "/RigUI" in str(prim.GetPath())]
    outcome = {
        "rig": character.rig,
        "prims": [f"{prim.GetTypeName()} {prim.GetName()} {prim.GetAppliedSchemas()}" for prim in drawn],
        "layer": [{each.GetName(): each.Get() for each in prim.GetAuthoredAttributes()} for prim in drawn],
        **shown(character.rig, character.layout),
    }
    assert figures.other_than_kept(name, outcome) == {}
