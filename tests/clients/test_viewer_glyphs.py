"""Custom handles in the viewer: where the library has them, and drawn."""

from dataclasses import replace

import laid_out
import numpy as np
from skel_stages import character

from usdrigui.character import Glyph
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load
from usdrigui.view.web.page import page_html

FLAG = np.array([[0.0, 1, 0], [-0.6, 0, 0.3], [0.8, -0.6, 0]])
TOLERANCE = 6e-5
"""Of the diagonal: what 16-bit positions and offsets leave."""


def test_glyphs_stand_where_the_library_has_them(opened, tmp_path):
    source = character(tmp_path / "char.usda")
    (rig, *_) = read_rigs(source, load({"read": {"joints": "all"}}))
    layout = laid_out.layout_of(rig, beside=("smile",))
    glyph = Glyph("flag", "mesh", 2.0 * layout.frame.handle_width * FLAG, np.array([3]), np.arange(3))
    line = replace(glyph, form="curve")
    elements = [replace(each, glyph=line if i % 2 else glyph) for i, each in enumerate(layout.elements)]
    layout = replace(layout, elements=tuple(elements))
    page = tmp_path / "page.html"
    page.write_text(page_html([(rig, layout)], "glyphs"))
    viewer = opened(page)
    poser, rng = prepare(rig, layout), np.random.default_rng(5)
    diagonal = laid_out.diagonal(rig)
    for _ in range(3):
        values = laid_out.random_values(rig, rng)
        viewer.set(**{control.name: float(value) for control, value in zip(rig.controls, values, strict=True)})
        outlines = viewer.page.evaluate("usdrigui.app.session.elements.list.map((each) => each.outline)")
        for outline, at in zip(outlines, evaluate(poser, values).elements, strict=True):
            assert np.abs(np.array(outline) - at.glyph).max() <= TOLERANCE * diagonal
