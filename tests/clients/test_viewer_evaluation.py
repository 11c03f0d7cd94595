"""The viewer's own evaluation of a character agrees with the library's, in a real browser."""

from __future__ import annotations

import laid_out
import makers
import numpy as np
import pytest
from browser_pages import Viewer
from skel_stages import character
from viewer_layouts import peak_layout

from usdrigui.deform import deform
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.settings import load
from usdrigui.usd.rig import read_rigs
from usdrigui.view.page import page_html

TOLERANCE = 6e-5
"""Of the diagonal: what 16-bit positions and offsets leave."""


@pytest.fixture(scope="module")
def rigs(tmp_path_factory):
    """A mask of blend shapes, and a stage with in-betweens, skins of every kind and two skeletons."""
    face = makers.face()
    path = tmp_path_factory.mktemp("stage") / "char.usda"
    character(path)
    skinned = read_rigs(path, load({"read": {"joints": "all"}}))[0]
    return {"mask": (face, peak_layout(face)), "skinned": (skinned, laid_out.layout_of(skinned, beside=("smile",)))}


@pytest.mark.parametrize("name", ["mask", "skinned"])
def test_points_handles_and_tracks_equal_the_library(browser, rigs, tmp_path, name):
    rig, layout = rigs[name]
    path = tmp_path / "page.html"
    path.write_text(page_html([(rig, layout)], name))
    viewer = Viewer(browser, path)
    poser = prepare(rig, layout)
    diagonal = float(np.linalg.norm(np.ptp(deform(rig), axis=0)))
    rng = np.random.default_rng(7)
    shown = np.concatenate([np.full(len(mesh.points), mesh.display.visible) for mesh in rig.body.meshes])
    for _ in range(4):
        values = laid_out.random_values(rig, rng)
        viewer.set(**{control.name: float(value) for control, value in zip(rig.controls, values, strict=True)})
        posed = evaluate(poser, values)
        points = np.array(viewer.page.evaluate("usdrigui.points()")).reshape(-1, 3)
        assert np.abs(points - posed.points)[shown].max() <= TOLERANCE * diagonal
        handles = np.array([each["world"] for each in viewer.page.evaluate("usdrigui.elements()")])
        assert np.abs(handles - [each.handle for each in posed.elements]).max() <= TOLERANCE * diagonal
        drawn = viewer.page.evaluate("usdrigui.app.view.overlay.drawn.map(({ element }) => element.tracks)")
        for tracks, each in zip(drawn, posed.elements, strict=True):
            for track, wanted in zip(tracks, each.tracks, strict=True):
                assert np.abs(np.array(track) - wanted).max() <= TOLERANCE * diagonal
    assert viewer.trouble == []
    viewer.close()
