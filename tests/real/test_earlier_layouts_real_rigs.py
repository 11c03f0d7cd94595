"""Layouts over the life of real rigs: fixed, kept, and carried to a head of other topology."""

from dataclasses import replace

import numpy as np
import pytest
from laid_out_again import lay_out, read
from rig_copies import box_of, other_head, renamed, reordered, resculpted, reshaped, spelt_otherwise

from usdrigui.layout.reuse.partial_layout import place_of
from usdrigui.layout.review.difference import cost_savings, difference
from usdrigui.settings import load

pytestmark = pytest.mark.real


def anchors(layout):
    return {e.name: (e.anchor.mesh, e.anchor.point, e.anchor.on_board) for e in layout.elements}


@pytest.mark.parametrize("name", ["godette.usdc", "mh_expr34.usdc", "openusd_blendshapes.usda"])
def test_fixed_anchors_are_kept_exactly_and_the_rest_is_optimal_given_them(name):
    rig = read(name)
    _, _, first = lay_out(rig)
    half = replace(first, elements=first.elements[::2])
    proven = load({"solve": {"gap": 1e-4}})
    _, found, made = lay_out(rig, proven, fixed={rig.skel_root.path: half})
    for element in half.elements:
        # A control with a lobe on each side has two elements.
        holding = [e for e in made.elements if element.manipulator.members[0].control in e.manipulator.controls]
        now = min(holding, key=lambda e: e.anchor.point != element.anchor.point)
        assert {m.control for m in now.manipulator.members} == {m.control for m in element.manipulator.members}
        assert now.anchor.on_board == element.anchor.on_board
        if not element.anchor.on_board:
            assert (now.anchor.mesh, now.anchor.point) == (element.anchor.mesh, element.anchor.point)
    assert found.status == "optimal"
    assert found.gap <= 1e-4


def test_removing_and_adding_five_moves_fewer_than_one_in_twenty():
    rig = read("vitruvian.usdc")
    quick = load({"solve": {"gap": 1e-2, "work_limit": 3_000_000}})
    names = np.random.default_rng(5).permutation([control.name for control in rig.controls])
    coming, going = set(names[:5]), set(names[5:10])

    def without(gone):
        return replace(rig, controls=tuple(control for control in rig.controls if control.name not in gone))

    _, _, before = lay_out(without(coming), quick)
    _, _, after = lay_out(without(going), quick, previous={rig.skel_root.path: before})
    found = difference(before, after)
    told = {kind: {c.control for c in found.changes if c.kind == kind} for kind in ("added", "removed")}
    laid = {m.control for layout in (before, after) for e in layout.elements for m in e.manipulator.members}
    assert told == {"added": coming & laid, "removed": going & laid}
    assert len(found.displaced) < found.shared / 20


def test_nine_in_ten_controls_stand_within_two_handle_widths_on_a_head_of_other_topology():
    rig = read("ict_face57.usdc")
    ready, _, theirs = lay_out(rig)
    box = box_of(rig)
    other = other_head(rig, 110, box)
    assert sum(len(mesh.points) for mesh in other.body.meshes) < 0.7 * sum(len(mesh.points) for mesh in rig.body.meshes)
    context, _, ours = lay_out(other, like=((rig, theirs),))
    now = {member.control: element.anchor for element in ours.elements for member in element.manipulator.members}
    # Meshes without skin or transform: root space is their own.
    assert all(
        np.allclose(ready.face.trajectories.surface.points[s : s + len(m.points)], m.points, atol=1e-4)
        for s, m in zip(rig.body.starts, rig.body.meshes, strict=False)
    )
    apart = []
    for element in theirs.elements:
        for member in element.manipulator.members:
            anchor = now[member.control]
            if element.anchor.on_board:
                apart.append(0.0 if anchor.on_board else np.inf)
            else:
                place = reshaped(element.anchor.position[None], box)[0]
                off = np.linalg.norm(anchor.position - place) / context.face.handle_width
                apart.append(np.inf if anchor.on_board else off)
    assert np.mean(np.array(apart) <= 2.0) >= 0.9


@pytest.mark.slow
def test_five_decisions_stand_through_ten_versions_of_a_real_rig():
    """Three anchors far from where they would be, a place, a grouping; every run knows the layout before it alone."""
    rig = read("facecap_blender.usdc")
    quick = load({"solve": {"gap": 1e-2, "work_limit": 100_000}})
    inputs, _, _ = lay_out(rig, quick)
    chosen = {"browOuterUp_L": 40, "mouthSmile_L": 25, "noseSneer_R": 15}
    anchors = {name: place_of(rig.body, _another_point(inputs, name, rank)) for name, rank in chosen.items()}
    controls = {**{name: {"anchor": where} for name, where in anchors.items()}, "cheekPuff": {"place": "board"}}
    groups = {"groups": {"shrug": ["mouthShrugUpper", "mouthShrugLower"]}}
    asked = load({"solve": {"gap": 1e-2, "work_limit": 100_000}, "controls": controls, "groups": groups})
    _, _, first = lay_out(rig, asked)
    respelt, names = renamed(rig, spelt_otherwise)
    same = {name: name for name in names}
    some = replace(rig, controls=tuple(each for each in rig.controls if "Blink" not in each.name))
    versions = [
        *((each, same) for each in (some, rig, resculpted(rig, 1), reordered(rig, 2), reordered(rig, 3))),
        *((resculpted(rig, 4), same), (respelt, names), (reordered(respelt, 5), names), (rig, same), (some, same)),
    ]
    places = {each.name: each.anchor.position for each in first.elements}
    before = first
    for version, now in versions:
        inputs, found, layout = lay_out(version, quick, previous={rig.skel_root.path: before})
        at = {member.control: each.anchor for each in layout.elements for member in each.manipulator.members}
        for name in chosen:
            apart = np.linalg.norm(at[now[name]].position - places[name])
            assert apart <= 0.5 * inputs.face.handle_width, name
        assert at[now["cheekPuff"]].on_board
        assert {now["mouthShrugUpper"], now["mouthShrugLower"]} in [
            set(each.manipulator.controls) for each in layout.elements
        ]
        saved = cost_savings(inputs.measured, inputs.placement, found.labels)
        told = difference(before, layout, saved, inputs.character.references.matchings["previous"])
        assert not [change for change in told.displaced if not change.why]
        before = layout


def _another_point(inputs, name, rank):
    """The point that a control moves `rank`-th most."""
    controls = [control.name for control in inputs.face.rig.controls]
    motion = inputs.face.trajectories.motion_of(controls.index(name))
    return int(motion.points[np.argsort(-motion.arc_length, kind="stable")[min(rank, len(motion.points) - 1)]])
