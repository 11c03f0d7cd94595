"""The page's own evaluation of a character agrees with the library's."""

from __future__ import annotations

import base64

import laid_out
import makers
import numpy as np
import pytest
from page_in_node import placed_by_the_page
from skel_stages import character
from viewer_layouts import peak_layout

from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load
from usdrigui.view.web.packing import pack

TOLERANCE = 6e-5
"""Of the diagonal: what 16-bit positions and offsets leave."""


@pytest.fixture(scope="module")
def rigs(tmp_path_factory):
    """A mask of blend shapes, and a stage with in-betweens, skins of every kind and two skeletons."""
    face = makers.face()
    path = tmp_path_factory.mktemp("stage") / "char.usda"
    character(path)
    skinned = read_rigs(path, load({"read": {"joints": "all"}}))[0]
    joints = [each.name for each in skinned.controls if len(each.drive.joints)]
    return {
        "mask": (face, peak_layout(face)),
        "skinned": (skinned, laid_out.layout_of(skinned, beside=("smile",))),
        "joints on the board": (skinned, laid_out.layout_of(skinned, beside=joints[::2])),
        "static": (skinned, laid_out.layout_of(skinned, beside=joints[:2], adapt="static")),
    }


def test_points_handles_and_tracks_equal_the_library(rigs):
    rng = np.random.default_rng(7)
    poses = {name: [laid_out.random_values(rig, rng) for _ in range(4)] for name, (rig, _) in rigs.items()}
    cases = [
        {
            "scene": base64.b64encode(pack([each], name)).decode(),
            "poses": [values.tolist() for values in poses[name]],
        }
        for name, each in rigs.items()
    ]
    for (name, (rig, layout)), found in zip(rigs.items(), placed_by_the_page(cases), strict=True):
        poser = prepare(rig, layout)
        close = TOLERANCE * float(np.linalg.norm(np.ptp(laid_out.posed(rig).points, axis=0)))
        shown = np.concatenate([np.full(len(mesh.points), mesh.display.visible) for mesh in rig.body.meshes])
        for values, page in zip(poses[name], found["posed"], strict=True):
            ours = evaluate(poser, values)
            points = np.array(page["points"]).reshape(-1, 3)
            assert np.abs(points - ours.points)[shown].max() <= close, name
            for element, there, here in zip(layout.elements, page["elements"], ours.elements, strict=True):
                assert np.abs(there["handle"] - here.handle).max() <= close, (name, element.name)
                for track, wanted in zip(there["tracks"], here.tracks, strict=True):
                    assert np.abs(np.array(track) - wanted).max() <= close, (name, element.name)
