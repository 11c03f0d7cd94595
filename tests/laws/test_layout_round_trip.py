"""read(write(layout)) == layout to single precision, whatever names and numbers it holds."""

import itertools
import string
from dataclasses import replace

import laid_out
import makers
import numpy as np
from hypothesis import HealthCheck, given, settings, strategies as st
from pxr import Sdf

from usdrigui.character import LeftOff
from usdrigui.layer.read_layout import read_layout
from usdrigui.layer.write_layout import layer_bytes, layer_for
from usdrigui.model import LayoutPart, main_part

FACE = makers.face(9, 11)
PRINTED = st.text(st.characters(exclude_categories=("Cs", "Cc")), max_size=12)
NAMES = st.one_of(st.text(string.ascii_letters + ":.-_ 0'\"\\@é口", min_size=1, max_size=8), PRINTED.filter(bool))
NUMBERS = st.floats(-1e6, 1e6, width=32)
VECTORS = st.tuples(NUMBERS, NUMBERS, NUMBERS).map(np.array)
DIRECTIONS = VECTORS.filter(lambda each: np.linalg.norm(each) > 1e-3).map(lambda each: each / np.linalg.norm(each))


@st.composite
def layouts(draw):
    """A rig of twelve controls with odd names, and a layout of some of them with odd numbers."""
    names = draw(st.lists(NAMES, min_size=12, max_size=12, unique=True))
    rig = replace(
        FACE, controls=tuple(replace(each, name=name) for each, name in zip(FACE.controls, names, strict=True))
    )
    counts = draw(st.lists(st.integers(1, 3), max_size=4))
    starts = np.cumsum([0, *counts])
    groups = [tuple(names[a:b]) for a, b in itertools.pairwise(starts)]
    layout = laid_out.layout_of(rig, seed=draw(st.integers(0, 99)), groups=groups)
    elements = tuple(draw(changed(each)) for each in layout.elements)
    elements = tuple(
        replace(
            each,
            mirror=draw(st.sampled_from(["", *(other.name for other in elements)])),
        )
        for each in elements
    )
    own = tuple(draw(st.lists(parts(), max_size=3, unique_by=lambda each: each.name)))
    widths = {each.name: each.handle_width for each in own}  # The frame's is that of the main part.
    return rig, replace(
        layout,
        elements=elements,
        left_off=tuple(
            LeftOff(*row) for row in draw(st.lists(st.tuples(NAMES, st.sampled_from(["read", "solve"]), PRINTED)))
        ),
        frame=replace(
            layout.frame,
            handle_width=widths[main_part(list(widths))] if own else draw(st.floats(1e-3, 1e3)),
            space=draw(st.sampled_from(["object", "view"])),
            view=draw(DIRECTIONS),
            parts=own,
            plane=replace(layout.frame.plane, normal=draw(DIRECTIONS)),
        ),
        proof=replace(
            layout.proof,
            cost=draw(st.floats(allow_nan=False, allow_infinity=False)),
            bound=draw(st.floats(allow_nan=False)),
            status=draw(st.sampled_from(["optimal", "stopped"])),
            weights=tuple(draw(st.lists(st.tuples(NAMES, st.floats(-9, 9)), max_size=3))),
        ),
    )


@st.composite
def parts(draw):
    # Kept are 7 digits of the largest number of an array.
    width, cost, bound = draw(st.floats(4.0, 9.0)), draw(st.floats(-9, 9)), draw(st.floats(-9, 9))
    view = np.eye(3)[draw(st.integers(0, 2))]
    return LayoutPart(draw(NAMES), width, view, draw(st.sampled_from(["optimal", "stopped"])), cost, bound)


@st.composite
def changed(draw, element):
    members = tuple(
        replace(
            each,
            track=each.track + draw(VECTORS),
            arc_length=draw(st.floats(0, 9)),
            magnification=draw(st.floats(1, 9)),
            peak=draw(st.floats(0, 9)),
        )
        for each in element.members
    )
    label, reason, category = draw(NAMES), draw(PRINTED), draw(st.sampled_from(["", "global", "crowded"]))
    part = draw(st.sampled_from(["", "face", "tail"]))
    return replace(
        element,
        anchor=replace(element.anchor, position=draw(VECTORS), normal=draw(DIRECTIONS), on_board=draw(st.booleans())),
        members=members,
        kind=draw(st.sampled_from(["slider", "patch", "fan"])),
        opposed=draw(st.sampled_from([(), ((0, len(members) - 1),)])) if len(members) > 1 else (),
        label=label,
        side=draw(st.sampled_from(["left", "right", "middle", "none"])),
        adapt=draw(st.sampled_from(["deform", "static"])),
        reason=reason,
        category=category,
        part=part,
        pinned=draw(st.sampled_from([(), ("anchor",), ("place", "grouping")])),
        pinned_position=draw(st.sampled_from([(0.0, 0.0, 0.0), (1.5, -2.25, 0.125)])),
    )


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(layouts())
def test_any_layout_comes_back(made):
    rig, layout = made
    text = layer_bytes(layer_for([(rig, layout)], "", {}), ".usda").decode()
    layer = Sdf.Layer.CreateAnonymous(".usda")
    assert layer.ImportFromString(text)
    (back,) = read_layout(layer)
    laid_out.close(layout, back)
    assert layer_bytes(layer_for([(rig, layout)], "", {}), ".usda").decode() == text
