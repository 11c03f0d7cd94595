"""What a place costs: of a group the worst member counts, of a middle element the way to the plane."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS

from usdrigui.layout.place.labels import labels_of
from usdrigui.model import CandidateSet
from usdrigui.overlap import own_costs
from usdrigui.settings import Settings

PLAIN = {"occlusion_weight": 0.0, "board_global": False, "board_composite": False}


@pytest.mark.parametrize(("weight", "on_plane"), [(0.1, True), (0.0, False)])
def test_a_middle_element_stands_on_the_plane_by_its_weight(weight, on_plane):
    """It moves a little more at both sides than on the plane."""
    both = sum(makers.bump(POINTS, (side * 0.3, -0.4), (0, 1, 0), 0.2, 0.10) for side in (-1.0, 1.0))
    shape = both + makers.bump(POINTS, (0.0, -0.4), (0, 1, 0), 0.2, 0.09)
    rig = makers.face_with(press=shape)
    line = chain.lay_out(rig, chain.settings(candidates=PLAIN, symmetry={"plane_weight": weight}))
    anchor = chain.by_name(line)["press"].anchor
    assert not anchor.on_board
    assert (abs(anchor.position[0]) < 1e-6) == on_plane


def test_costs_are_displacement_terms_and_own_overlap_of_both_copies():
    flat = chain.settings(
        candidates={"occlusion_weight": 0.0}, objective={"relative_displacement": 0.0}, groups={"opposed": False}
    )
    line = chain.problem_of(makers.face(), flat)
    index = [variable.name for variable in line.problem.variables].index("brow_L")
    variable, choice = line.problem.variables[index], line.choices[index]
    left, right = map(line.face.trajectories.motion_of, (0, 1))
    arc = left.arc_length[np.searchsorted(left.points, choice.anchors[:, 0])]
    arc = arc + right.arc_length[np.searchsorted(right.points, choice.anchors[:, 1])]
    own = own_costs(variable.samples, variable.handles, line.problem.overlap, line.problem.separation)
    expected = -0.85 * arc / line.face.trajectories.typical_length + own
    assert np.allclose(variable.cost, expected, rtol=1e-6)
    assert variable.off_face_cost == pytest.approx(2.0 * Settings().objective.off_face_penalty)


def test_a_group_counts_its_worst_member():
    both = chain.settings(
        candidates={"occlusion_weight": 0.0},
        symmetry={"plane_weight": 0.0},
        objective={"relative_displacement": 0.0, "distinctive_weight": 0.0},
    )
    line = chain.problem_of(makers.face(), both)
    (variable,) = (each for each in line.problem.variables if each.name == "jawRight_jawLeft")
    motions = [m for m in line.face.trajectories.motions if line.face.rig.controls[m.control].name.startswith("jaw")]
    arcs = np.stack([m.arc_length[np.searchsorted(m.points, variable.points)] for m in motions])
    worst = -0.85 * arcs.min(axis=0) / line.face.trajectories.typical_length
    left = line.face.surface.points[variable.points][:, 0] >= 0.0  # the other side pays to break the tie
    assert np.allclose(variable.cost[left], worst[left], rtol=1e-6)
    assert variable.samples.shape[2] == 10


CHEEKS = makers.bump(POINTS, (0.45, 0.0), (0, 0, 1), 0.2) + makers.bump(POINTS, (-0.45, 0.0), (0, 0, 1), 0.2)


def test_elements_without_candidates_on_the_plane_are_not_driven_off_the_face():
    line = chain.lay_out(makers.face_with(cheeks=CHEEKS))
    assert not chain.by_name(line)["cheeks"].anchor.on_board
    chin = chain.by_name(line)["chin"]
    assert abs(chin.anchor.position[0]) < 1e-6
    assert chin.side == "middle"


def test_a_middle_control_may_be_doubled():
    line = chain.lay_out(makers.face_with(cheeks=CHEEKS), chain.settings(symmetry={"double_middle": "always"}))
    elements = chain.by_name(line)
    one, other = elements["cheeks"], elements["cheeks_mirror"]
    assert one.anchor.position[0] == pytest.approx(-other.anchor.position[0], abs=1e-6)
    assert one.mirror == "cheeks_mirror"


def test_a_copy_of_a_doubled_control_stands_where_it_is_seen():
    """The highlight of one eye had its handle behind a plate that covers part of that eye."""
    line = chain.problem_of(makers.face_with(cheeks=CHEEKS), chain.settings(symmetry={"double_middle": "always"}))
    known = line.inputs.measured
    index = [group.name for group in line.groups].index("cheeks")
    motion = known.face.trajectories.motions[-1]
    seen = known.face.surface.points[:, 0] < 0.45
    face = replace(known.face, views=replace(known.face.views, visible=seen[None]))
    places = CandidateSet(motion, *[motion.points[seen[motion.points]]] * 2)
    anchors = labels_of(replace(known, face=face), {motion.control: places}, line.groups, index)[0].anchors
    assert anchors.size
    assert seen[anchors].all()


def test_the_paper_preset_takes_the_constants_literally():
    from usdrigui.character.surface import mean_edge_length, mesh_triangles
    from usdrigui.settings import load

    line = chain.problem_of(makers.face(), load(preset="paper"))
    places = line.face.surface.places
    edge = mean_edge_length(POINTS, mesh_triangles(line.face.rig.body.meshes), places)
    overlap = line.problem.overlap
    assert overlap.radius == pytest.approx(edge)
    assert (overlap.sharpness, overlap.maximum) == (2.0, 5.0)
    assert np.isinf(overlap.cutoff_distance)
    assert line.problem.separation < 1e-6
    assert all(np.isinf(variable.off_face_cost) for variable in line.problem.variables)
    large = chain.problem_of(makers.moved(makers.face(), 10.0 * np.eye(3)), load(preset="paper"))
    assert large.problem.overlap.sharpness == 2.0, "scene units: the paper's constants do not scale"


def test_a_flat_layout_spaces_and_measures_what_the_viewer_sees():
    out = makers.bump(POINTS, (0.2, -0.2), (0, 0, 1), 0.2, 0.1)
    up = makers.bump(POINTS, (0.2, -0.2), (0, 1, 0), 0.2, 0.1)
    flat = chain.settings(candidates={"space": "view", "view": "front", "occlusion_weight": 0.0})
    line = chain.problem_of(makers.face_with(out=out, up=up), flat)
    costs = {variable.name: variable.cost.min(initial=np.inf) for variable in line.problem.variables}
    assert costs["up"] < -0.5
    assert costs["out"] > -0.01 or "out" not in costs
    for variable in line.problem.variables:
        assert variable.samples.shape[-1] == variable.handles.shape[-1] == 2
    assert chain.lay_out(makers.face_with(up=up), flat).layout.frame.space == "view"


def test_a_control_kept_on_the_face_cannot_leave_it():
    line = chain.problem_of(makers.face(), chain.settings(controls={"chin": {"place": "face"}}))
    beside = {variable.name: variable.off_face_cost for variable in line.problem.variables}
    assert np.isinf(beside["chin"])
    assert np.isfinite(beside["pucker"])


@pytest.mark.parametrize("conventions", [True, False])
def test_controls_whose_names_say_what_they_do_leave_a_crowd_last(conventions):
    needed = {"jawOpen": True, "viseme_aa": True, "cheekPuff": True, "noseThick": False, "sculpt": False}
    shapes = {name: makers.bump(POINTS, (0.0, 0.4 * i - 0.8), (0, 1, 0.2)) for i, name in enumerate(needed)}
    asked = chain.settings(candidates={**PLAIN, "conventions": conventions})
    problem = chain.problem_of(makers.rig(POINTS, QUADS, shapes), asked).problem
    least = asked.objective.off_face_penalty + max(-each.cost.min() for each in problem.variables)
    assert {each.name: each.off_face_cost > least for each in problem.variables} == {
        name: conventions and need for name, need in needed.items()
    }


@pytest.mark.parametrize(("width", "stands"), [(0.04, True), (0.075, False)])
def test_copies_of_a_control_stand_where_it_keeps_a_third_of_its_peak_or_nowhere(width, stands):
    """Points .05 from the plane keep .77 of the peak, those .1 from it .27."""
    press = makers.bump(POINTS, (0.0, -0.4), (0, 1, 0), 0.144, 0.10)
    line = chain.problem_of(
        makers.face_with(press=press),
        chain.settings(symmetry={"double_middle": "always"}, objective={"handle_size": width, "max_neighbours": 0.0}),
    )
    (variable,) = (each for each in line.problem.variables if each.name == "press")
    assert bool(len(variable.points)) is stands


@pytest.mark.parametrize(("name", "stands"), [("jawOpen", True), ("swelling", False)])
def test_what_a_face_needs_is_not_bound_to_one_spot(name, stands):
    """Coarse meshes: another control takes the only point that moves by half of the peak."""
    apart = np.linalg.norm(POINTS[:, :2] - [0.0, -0.5], axis=1)
    spot = int(np.argmin(apart))
    amount = np.where(apart < 0.02, 0.1, np.where(apart < 0.08, 0.04, 0.0))
    shapes = {name: amount[:, None] * [0.0, -1.0, 0.2], "fixed": makers.bump(POINTS, (0.0, -0.5), (0, 0, 1))}
    settings = chain.settings(controls={"fixed": {"anchor": f"/Root/mesh#{spot}"}})
    elements = chain.by_name(chain.lay_out(makers.rig(POINTS, QUADS, shapes), settings))
    assert elements[name].anchor.on_board != stands
