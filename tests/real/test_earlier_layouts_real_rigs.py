"""Layouts over the life of real rigs: fixed, kept, and carried to a head of other topology."""

from collections import Counter
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from laid_out_again import lay_out, read
from rig_copies import decimated
from scipy.spatial.distance import cdist

from usdrigui.layout.review.difference import difference
from usdrigui.settings import load

SAMPLE = Path(__file__).parents[2] / "sample_assets" / "char.usda"
pytestmark = pytest.mark.real


def anchors(layout):
    return {e.name: (e.anchor.mesh, e.anchor.point, e.anchor.on_board) for e in layout.elements}


@pytest.mark.parametrize("name", ["godette.usdc", "mh_expr34.usdc", "openusd_blendshapes.usda"])
def test_fixed_anchors_are_kept_exactly_and_the_rest_is_optimal_given_them(name):
    rig = read(name)
    _, _, first = lay_out(rig)
    half = replace(first, elements=first.elements[::2])
    proven = load({"solve": {"gap": 1e-4}})
    _, found, made = lay_out(rig, proven, fixed={rig.path: half})
    for element in half.elements:
        # A control with a lobe on each side has two elements.
        holding = [e for e in made.elements if element.members[0].control in e.controls]
        now = min(holding, key=lambda e: e.anchor.point != element.anchor.point)
        assert now.controls == element.controls
        assert now.anchor.on_board == element.anchor.on_board
        if not element.anchor.on_board:
            assert (now.anchor.mesh, now.anchor.point) == (element.anchor.mesh, element.anchor.point)
    assert found.status == "optimal"
    assert found.gap <= 1e-4


@pytest.mark.parametrize("name", ["char.usda", "facecap_blender.usdc"])
def test_with_fewer_points_nobody_moves_further_than_the_mesh_forces(name):
    """A handle's width at most beyond the nearest of its candidates that no other handle has.

    But for a control with a handle on each side: these two stay mirror images of each other.
    """
    rig = read(SAMPLE if name == SAMPLE.name else name)
    _, _, before = lay_out(rig)
    inputs, _, after = lay_out(decimated(rig, 0.45), previous={rig.path: before})
    found, width = inputs.face.trajectories, before.frame.handle_width
    points, name = found.surface.points, inputs.face.control_name
    allowed = {
        name(control): points[each.anchors[:, copy]]
        for each in inputs.placement.choices
        for copy, controls in enumerate(each.controls)
        for control in controls
    }
    held = [(element, control) for element in before.elements for control in element.controls]
    once = Counter(control for _, control in held)
    for element, control in ((e, c) for e, c in held if not e.anchor.on_board and once[c] == 1):
        on_face = [e for e in after.elements if not e.anchor.on_board]
        others = [e.anchor.position for e in on_face if control not in e.controls]
        free = allowed[control][cdist(allowed[control], others).min(axis=1) >= width]
        now = [e.anchor.position for e in on_face if control in e.controls]
        apart, nearest = (cdist([element.anchor.position], some).min() for some in (now, free))
        assert apart <= nearest + width, control


def test_removing_and_adding_five_moves_fewer_than_one_in_twenty():
    rig = read("vitruvian.usdc", load({"read": {"joints": "none"}}))
    quick = load({"solve": {"gap": 1e-2, "work_limit": 3_000_000}})
    names = np.random.default_rng(5).permutation(rig.control_names)
    coming, going = set(names[:5]), set(names[5:10])

    def without(gone):
        return replace(rig, controls=tuple(control for control in rig.controls if control.name not in gone))

    _, _, before = lay_out(without(coming), quick)
    _, _, after = lay_out(without(going), quick, previous={rig.path: before})
    found = difference(before, after)
    told = {kind: {c.control for c in found.changes if c.kind == kind} for kind in ("added", "removed")}
    laid = {m.control for layout in (before, after) for e in layout.elements for m in e.members}
    assert told == {"added": coming & laid, "removed": going & laid}
    assert len(found.displaced) < found.shared / 20
