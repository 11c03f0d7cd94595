"""Grouping, the problem's costs and geometry, and the elements on the face and beside it."""

from dataclasses import replace
from importlib.metadata import EntryPoint

import chain
import makers
import numpy as np
import pytest

from usdrigui.errors import RigUIError
from usdrigui.layout import extensions
from usdrigui.layout.fans import fan_order
from usdrigui.layout.groups import find_groups, suggested_groups
from usdrigui.layout.orbits import orbit_points
from usdrigui.layout.tracks import gains, resampled
from usdrigui.model import ExtraPairs
from usdrigui.overlap import own_costs, total_cost

POINTS, QUADS = makers.mask()
SHAPES = makers.face_shapes(POINTS)


def rig_with(**more):
    return makers.rig(POINTS, QUADS, {**SHAPES, **more})


def eye(centre, sign=1.0):
    """Four gaze controls about one eye."""
    ways = {"In": (-sign, 0, 0), "Out": (sign, 0, 0), "Up": (0, 1, 0), "Down": (0, -1, 0)}
    return {way: makers.bump(POINTS, centre, direction, 0.2, 0.06) for way, direction in ways.items()}


def gazing():
    eyes = {"L": eye((0.35, 0.3)), "R": eye((-0.35, 0.3), -1.0)}
    looks = {f"look{way}_{side}": offsets for side, ways in eyes.items() for way, offsets in ways.items()}
    return makers.rig(POINTS, QUADS, {**{k: v for k, v in SHAPES.items() if not k.startswith("blink")}, **looks})


def groups_of(rig, **parts):
    line = chain.posed(rig, chain.settings(**parts))
    names = [control.name for control in rig.controls]
    return {tuple(names[c] for c in group.controls): group for group in line.groups}, names


# --- groups ------------------------------------------------------------------------------------------


def test_pairs_are_folded_and_middle_controls_stand_alone():
    groups, names = groups_of(makers.face())
    assert [names[c] for c in groups["brow_L",].mirror] == ["brow_R"]
    assert ("brow_R",) not in groups
    assert groups["pucker",].mirror == ()
    unfolded, _ = groups_of(makers.face(), symmetry={"fold": False}, groups={"opposed": False})
    assert len(unfolded) == len(names)


def test_opposed_controls_become_one_slider_with_two_ends():
    groups, _ = groups_of(makers.face())
    jaw = groups["jawRight", "jawLeft"]
    assert (jaw.kind, jaw.opposed, jaw.mirror) == ("slider", ((0, 1),), ())
    apart, _ = groups_of(makers.face(), groups={"opposed": False})
    assert ("jawRight", "jawLeft") not in apart
    shy, _ = groups_of(makers.face(), groups={"opposed_cosine": -1.01})
    assert ("jawRight", "jawLeft") in shy, "twins have some leeway"


def test_the_opposite_of_like_amount_is_preferred():
    rig = rig_with(jawBit=-0.2 * SHAPES["jawLeft"])
    groups, _ = groups_of(rig, symmetry={"enabled": False})
    assert ("jawRight", "jawLeft") in groups or ("jawLeft", "jawRight") in groups


def test_two_crossing_axes_of_one_region_become_a_joystick():
    groups, names = groups_of(gazing())
    stick = groups["lookIn_L", "lookOut_L", "lookDown_L", "lookUp_L"]
    assert (stick.kind, stick.opposed) == ("patch", ((0, 1), (2, 3)))
    assert [names[c] for c in stick.mirror] == ["lookIn_R", "lookOut_R", "lookDown_R", "lookUp_R"]


def swinging(lesser=1.0):
    """Two controls of one region that go to both sides and cross."""
    shapes = {
        "across": makers.bump(POINTS, (0.0, 0.6), (1, 0, 0), 0.3, 0.1),
        "upright": makers.bump(POINTS, (0.0, 0.6), (0, 1, 0), 0.3, 0.1 * lesser),
    }
    return makers.rig(POINTS, QUADS, shapes, ranges=dict.fromkeys(shapes, (-1.0, 1.0, 0.0)))


def test_controls_that_swing_across_each_other_make_a_joystick_if_opposed_ones_may():
    assert ("across", "upright") in groups_of(swinging())[0]
    assert ("across", "upright") not in groups_of(swinging(), groups={"opposed": False})[0]


def test_a_far_lesser_axis_makes_no_joystick():
    assert ("across", "upright") in groups_of(swinging(0.2))[0]
    assert ("across", "upright") not in groups_of(swinging(0.05))[0]


@pytest.mark.parametrize(("turned", "shared"), [((0, 0), True), ((0, 1), False)])
def test_joints_make_a_joystick_of_one_joint_only(turned, shared):
    line = chain.posed(swinging(), chain.settings())
    controls = tuple(
        replace(each, kind="joint", drive=replace(each.drive, joints=np.array([joint])))
        for each, joint in zip(line.context.rig.controls, turned, strict=True)
    )
    context = replace(line.context, rig=replace(line.context.rig, controls=controls))
    assert any(len(group.controls) == 2 for group in find_groups(context, line.candidates)) == shared


def test_an_axis_takes_a_crossing_single_control():
    shapes = {name: offsets for name, offsets in SHAPES.items() if name != "chin"}
    shapes["jawOpen"] = makers.bump(POINTS, (0.0, -0.7), (0, -1, 0), 0.45, 0.3)
    groups, _ = groups_of(makers.rig(POINTS, QUADS, shapes))
    stick = groups["jawRight", "jawLeft", "jawOpen"]
    assert (stick.kind, stick.opposed) == ("patch", ((0, 1),))


def test_patches_and_fans_by_the_jaccard_index():
    third = makers.bump(POINTS, (0.0, -0.45), (0.0, 1.0, 0.0), 0.3, 0.1)
    rig = rig_with(lipUp=third, lipOut=makers.bump(POINTS, (0.0, -0.45), (0.0, 1.0, 0.5), 0.3, 0.1))
    off = {"opposed": False}
    assert not any(len(key) > 1 for key in groups_of(rig, groups=off)[0])
    pairs = [key for key in groups_of(rig, groups={**off, "patches": True})[0] if len(key) > 1]
    assert all(len(key) == 2 for key in pairs)
    assert len(pairs) >= 1
    fans, _ = groups_of(rig, groups={**off, "patches": True, "fan_size": 3, "jaccard_min": 0.5})
    fan = next(group for key, group in fans.items() if set(key) == {"pucker", "lipUp", "lipOut"})
    assert fan.kind == "fan"
    line = chain.posed(rig, chain.settings(groups=off))
    assert any(set(names) <= {"pucker", "lipUp", "lipOut"} for names in suggested_groups(line.context, line.candidates))
    assert not any(len(k) > 1 for k in groups_of(rig, groups={**off, "patches": True, "jaccard_min": 1.0})[0])


def test_the_users_groups_are_kept_and_their_image_is_made():
    said = {"groups": {"mouth": ("smile_L", "sneer_L"), "middle": ("pucker", "chin")}}
    rig = rig_with()
    rig = makers.rig(POINTS, QUADS, {**SHAPES, "chin": 0.5 * SHAPES["pucker"] + SHAPES["chin"]})
    line = chain.posed(rig, chain.settings(groups=said, candidates={"peak_share": 0.05, "prune_at": 0.1}))
    found = {group.name: group for group in line.groups}
    assert found["mouth"].reason == "grouped by the configuration"
    assert [rig.controls[c].name for c in found["mouth"].mirror] == []
    assert "smile_R" in found
    assert found["middle"].kind == "patch"


@pytest.mark.parametrize(
    ("groups", "code"),
    [
        ({"a": ("pucker", "nobody")}, "CONFIG_UNKNOWN_CONTROL"),
        ({"a": ("pucker",)}, "CONFIG_VALUE"),
        ({"a": ("pucker", "pucker")}, "CONFIG_VALUE"),
        ({"a": ("pucker", "chin"), "b": ("chin", "brow_L")}, "CONFIG_VALUE"),
    ],
)
def test_wrong_groups_are_refused(groups, code):
    with pytest.raises(RigUIError) as refused:
        groups_of(makers.face(), groups={"groups": groups})
    assert refused.value.issue.code == code


def test_fans_are_ordered_by_angle():
    normal = np.array([0.0, 0.0, 1.0])
    angles = np.radians([200.0, 10.0, 100.0, 60.0])
    tangents = np.stack([np.cos(angles), np.sin(angles), np.full(4, 0.7)], axis=1)
    order = fan_order(tangents, normal)
    assert order == (1, 3, 2, 0)


# --- tracks ------------------------------------------------------------------------------------------


def test_tracks_are_sampled_at_equal_steps_of_arc_length():
    line = np.array([[[0.0, 0, 0], [1, 0, 0], [1, 3, 0]]])
    assert np.allclose(resampled(line, 5)[0], [[0, 0, 0], [1, 0, 0], [1, 1, 0], [1, 2, 0], [1, 3, 0]])
    assert np.allclose(resampled(np.zeros((1, 3, 3)), 4), 0.0)


def test_short_tracks_are_enlarged_and_the_gain_recorded():
    assert gains(np.array([0.5, 2.0, 0.0]), 1.0).tolist() == [2.0, 1.0, 1.0]
    line = chain.lay_out(rig_with(tiny=0.01 * makers.bump(POINTS, (0.5, 0.0), (0, 0, 1), 0.2)))
    tiny = next(m for e in line.layout.elements for m in e.members if m.control == "tiny")
    drawn = np.linalg.norm(tiny.track[-1] - tiny.track[0])
    assert drawn == pytest.approx(1.5 * line.layout.handle_width, rel=1e-6)
    assert tiny.gain * tiny.arc_length == pytest.approx(drawn, rel=1e-6)


# --- the problem -------------------------------------------------------------------------------------


def test_costs_are_displacement_terms_and_own_overlap_of_both_copies():
    flat = chain.settings(
        candidates={"occlusion_price": 0.0}, objective={"relative_displacement": 0.0}, groups={"opposed": False}
    )
    line = chain.posed(makers.face(), flat)
    index = [variable.name for variable in line.problem.variables].index("brow_L")
    variable, choice = line.problem.variables[index], line.choices[index]
    left, right = (next(m for m in line.context.trajectories.motions if m.control == c) for c in (0, 1))
    arc = left.arc_length[np.searchsorted(left.points, choice.anchors[:, 0])]
    arc = arc + right.arc_length[np.searchsorted(right.points, choice.anchors[:, 1])]
    own = own_costs(variable.samples, variable.handles, line.problem.overlap, line.problem.separation)
    expected = -0.85 * arc / line.context.trajectories.typical_length + own
    assert np.allclose(variable.cost, expected, rtol=1e-6)
    assert variable.beside == pytest.approx(0.6)


def test_a_group_counts_its_worst_member():
    both = chain.settings(
        candidates={"occlusion_price": 0.0}, symmetry={"plane_price": 0.0}, objective={"relative_displacement": 0.0}
    )
    line = chain.posed(makers.face(), both)
    index = [variable.name for variable in line.problem.variables].index("jawRight_jawLeft")
    variable = line.problem.variables[index]
    motions = [
        m for m in line.context.trajectories.motions if line.context.rig.controls[m.control].name.startswith("jaw")
    ]
    arcs = np.stack([m.arc_length[np.searchsorted(m.points, variable.points)] for m in motions])
    worst = -0.85 * arcs.min(axis=0) / line.context.trajectories.typical_length
    left = line.context.trajectories.base[variable.points][:, 0] >= 0.0  # the other side pays to break the tie
    assert np.allclose(variable.cost[left], worst[left], rtol=1e-6)
    assert variable.samples.shape[2] == 10


def test_elements_without_candidates_on_the_plane_are_not_driven_off_the_face():
    cheeks = makers.bump(POINTS, (0.45, 0.0), (0, 0, 1), 0.2) + makers.bump(POINTS, (-0.45, 0.0), (0, 0, 1), 0.2)
    line = chain.lay_out(rig_with(cheeks=cheeks))
    assert not chain.by_name(line)["cheeks"].anchor.beside
    chin = chain.by_name(line)["chin"]
    assert abs(chin.anchor.position[0]) < 1e-6
    assert chin.side == "middle"


def test_a_middle_control_may_be_doubled():
    cheeks = makers.bump(POINTS, (0.45, 0.0), (0, 0, 1), 0.2) + makers.bump(POINTS, (-0.45, 0.0), (0, 0, 1), 0.2)
    line = chain.lay_out(rig_with(cheeks=cheeks), chain.settings(symmetry={"double_middle": True}))
    elements = chain.by_name(line)
    one, other = elements["cheeks"], elements["cheeks_mirror"]
    assert one.anchor.position[0] == pytest.approx(-other.anchor.position[0], abs=1e-6)
    assert one.mirror == "cheeks_mirror"


def test_the_paper_preset_takes_the_constants_literally():
    from usdrigui.settings import load
    from usdrigui.surface import mean_edge_length, mesh_triangles

    line = chain.posed(makers.face(), load(preset="paper"))
    edge = mean_edge_length(POINTS, mesh_triangles(line.context.rig.meshes))
    overlap = line.problem.overlap
    assert overlap.radius == pytest.approx(edge)
    assert (overlap.sharpness, overlap.maximum) == (2.0, 5.0)
    assert np.isinf(overlap.reach)
    assert line.problem.separation < 1e-6
    assert all(np.isinf(variable.beside) for variable in line.problem.variables)
    large = chain.posed(makers.moved(makers.face(), 10.0 * np.eye(3)), load(preset="paper"))
    assert large.problem.overlap.sharpness == 2.0, "scene units: the paper's constants do not scale"


def test_a_flat_layout_spaces_and_measures_what_the_viewer_sees():
    out = makers.bump(POINTS, (0.2, -0.2), (0, 0, 1), 0.2, 0.1)
    up = makers.bump(POINTS, (0.2, -0.2), (0, 1, 0), 0.2, 0.1)
    flat = chain.settings(candidates={"space": "view", "view": "front", "occlusion_price": 0.0})
    line = chain.posed(rig_with(out=out, up=up), flat)
    costs = {variable.name: variable.cost.min(initial=np.inf) for variable in line.problem.variables}
    assert costs["up"] < -0.5
    assert costs["out"] > -0.01 or "out" not in costs
    for variable in line.problem.variables:
        for flat_part in (variable.samples[..., 2], variable.handles[..., 2]):
            assert flat_part.size == 0 or np.ptp(flat_part) < 1e-9
    assert chain.lay_out(rig_with(up=up), flat).layout.space == "view"


def test_fixed_anchors_stay_and_unfold_their_pair():
    line = chain.lay_out(makers.face(), chain.settings(controls={"brow_L": {"anchor": "/Root/mesh#914"}}))
    elements = chain.by_name(line)
    assert elements["brow_L"].anchor.point == 914
    assert elements["brow_R"].anchor.point != line.context.symmetry.partner[914]


def test_a_control_kept_on_the_face_cannot_leave_it():
    line = chain.posed(makers.face(), chain.settings(controls={"chin": {"place": "face"}}))
    beside = {variable.name: variable.beside for variable in line.problem.variables}
    assert np.isinf(beside["chin"])
    assert np.isfinite(beside["pucker"])


# --- orbits ------------------------------------------------------------------------------------------


def star(arms=5):
    """A disc with one bump in each of `arms` directions."""
    angles = np.arange(60) * 2.0 * np.pi / 60
    rings = np.linspace(0.1, 1.0, 10)
    points = np.array([[r * np.cos(a), r * np.sin(a), 0.0] for r in rings for a in angles])
    faces = [
        [r * 60 + i, r * 60 + (i + 1) % 60, (r + 1) * 60 + (i + 1) % 60, (r + 1) * 60 + i]
        for r in range(9)
        for i in range(60)
    ]
    turns = 2.0 * np.pi * np.arange(arms) / arms
    shapes = {
        f"arm{k}": makers.bump(points, (0.6 * np.cos(a), 0.6 * np.sin(a)), (0, 0, 1), 0.3) for k, a in enumerate(turns)
    }
    return makers.rig(points, faces, shapes)


@pytest.mark.parametrize("arms", [2, 3, 5])
def test_an_orbit_is_laid_out_once_and_all_its_copies_count(arms):
    rig = star(arms)
    orbit = {"orbit": tuple(f"arm{k}" for k in range(arms))}
    said = chain.settings(controls={"arm0": orbit}, candidates={"occlusion": False})
    if arms == 2:
        rig = replace(rig, up=np.array([0.0, 0.0, 1.0]))
    line = chain.lay_out(rig, said)
    assert len(line.problem.variables) == 1
    assert line.problem.variables[0].handles.shape[1] == arms
    anchors = np.stack([chain.by_name(line)[f"arm{k}"].anchor.position for k in range(arms)])
    assert np.allclose(np.linalg.norm(anchors, axis=1), np.linalg.norm(anchors[0]))
    angle = 2.0 * np.pi / arms
    turn = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    assert np.allclose(anchors[0] @ turn, anchors[1], atol=1e-6)
    assert (orbit_points(line.context, tuple(range(arms)), np.arange(60)) >= 0).all()


@pytest.mark.parametrize("orbit", [("arm0",), ("arm0", "nobody"), ("arm0", "arm0")])
def test_wrong_orbits_are_refused(orbit):
    with pytest.raises(RigUIError):
        chain.posed(star(3), chain.settings(controls={"arm0": {"orbit": orbit}}))


# --- terms of other packages --------------------------------------------------------------------------


class KeepLow:
    """A term as another package would write it: lower is better, and chin and pucker avoid each other."""

    @staticmethod
    def linear(context, motion, points):
        del motion
        heights = context.trajectories.base[points] @ context.rig.up
        return 5.0 * (heights - heights.min())

    @staticmethod
    def pairs(context, problem, choices):
        del context, choices
        names = [variable.name for variable in problem.variables]
        a, b = sorted((names.index("chin"), names.index("pucker")))
        first, second = (len(problem.variables[i].points) for i in (a, b))
        grid = np.indices((first, second)).reshape(2, -1)
        yield ExtraPairs(a, b, grid[0], grid[1], np.full(first * second, 0.25))


class Wrong:
    @staticmethod
    def linear(context, motion, points):
        del context, motion
        return -np.ones(len(points))


@pytest.fixture
def installed(monkeypatch):
    found = [EntryPoint("low", f"{__name__}:KeepLow", extensions.GROUP), EntryPoint("wrong", "x:y", extensions.GROUP)]
    loads = {"low": KeepLow, "wrong": Wrong}
    monkeypatch.setattr(extensions, "entry_points", lambda group: [e for e in found if e.group == group])
    monkeypatch.setattr(EntryPoint, "load", lambda self: loads[self.name])


@pytest.mark.usefixtures("installed")
def test_terms_of_other_packages_act_when_named():
    plain = chain.posed(makers.face())
    line = chain.posed(makers.face(), chain.settings(objective={"terms": ("low",)}))
    low, free = (next(v for v in each.problem.variables if v.name == "brow_L") for each in (line, plain))
    raised = low.cost - free.cost
    heights = POINTS[low.points, 1]
    # Both copies count.
    assert np.allclose(raised, 10.0 * (heights - heights.min()), atol=1e-5)
    assert plain.problem.extra == ()
    labels = np.zeros(len(line.problem.variables), dtype=int)
    without = replace(line.problem, extra=())
    assert total_cost(line.problem, labels) == pytest.approx(total_cost(without, labels) + 0.25)


@pytest.mark.usefixtures("installed")
@pytest.mark.parametrize(("term", "code"), [("wrong", "TERM_INVALID"), ("absent", "CONFIG_VALUE")])
def test_wrong_terms_are_refused(term, code):
    with pytest.raises(RigUIError) as refused:
        chain.posed(makers.face(), chain.settings(objective={"terms": (term,)}))
    assert refused.value.issue.code == code


# --- elements ----------------------------------------------------------------------------------------


def test_every_control_has_exactly_one_member():
    line = chain.lay_out(rig_with(whole=np.full_like(POINTS, 0.2), empty=np.zeros_like(POINTS)))
    members = [member.control for element in line.layout.elements for member in element.members]
    assert sorted(members) == sorted({*SHAPES, "whole"})
    assert [each.control for each in line.layout.left_off] == ["empty"]


def test_tracks_pass_through_the_anchor_at_the_base_value():
    line = chain.lay_out(makers.face(ranges={"pucker": (-0.5, 1.0)}))
    for element in line.layout.elements:
        for member in element.members:
            at = member.track[np.argmin(np.abs(member.values))]
            assert np.allclose(at, element.anchor.position, atol=1e-6)


def test_the_board_is_tidy_and_outside_the_silhouette():
    more = {f"copy{i}": 0.3 * each for i, each in enumerate(list(SHAPES.values())[:8])}
    line = chain.lay_out(rig_with(whole=np.full_like(POINTS, 0.2), **more))
    board = [element for element in line.layout.elements if element.anchor.beside]
    assert {element.family for element in board} == {"global", "composite"}
    spots = np.array([element.anchor.position for element in board])
    width = line.layout.handle_width
    tracks = np.concatenate([m.track for e in board for m in e.members])
    assert tracks[:, 0].min() > POINTS[:, 0].max() + width
    apart = np.linalg.norm(spots[:, None] - spots[None], axis=2) + 9e9 * np.eye(len(spots))
    assert apart.min() >= 1.6 * width
    assert np.ptp(spots[:, 2]) < 1e-9
    for element in board:
        assert element.reason
        for member in element.members:
            drawn = np.linalg.norm(np.diff(member.track, axis=0), axis=1).sum()
            assert drawn == pytest.approx(member.gain * member.arc_length, rel=1e-6)
    pairs = [element for element in board if element.mirror]
    for element in pairs:
        other = next(each for each in board if each.name == element.mirror)
        assert element.anchor.position[1] == pytest.approx(other.anchor.position[1])


def test_what_the_configuration_sends_beside_stands_under_a_heading_of_its_own():
    line = chain.lay_out(
        rig_with(whole=np.full_like(POINTS, 0.2)),
        chain.settings(controls={"chin": {"place": "beside"}, "whole": {"place": "beside"}}),
    )
    families = {name: element.family for name, element in chain.by_name(line).items() if element.anchor.beside}
    assert families == {"chin": "requested", "whole": "global"}
    assert "configuration" in chain.by_name(line)["chin"].reason
    heights = {name: chain.by_name(line)[name].anchor.position[1] for name in families}
    # A heading stands between them: a row of 2.4 widths for it and one for the element.
    assert heights["whole"] - heights["chin"] == pytest.approx(4.8 * line.layout.handle_width)


def test_a_crowded_face_sends_the_least_telling_controls_to_the_board():
    crowd = {
        f"c{i}": makers.bump(POINTS, (0.0, -0.2), (np.sin(i), np.cos(i), 0.3), 0.05, 0.02 + 0.01 * i) for i in range(8)
    }
    rig = makers.rig(POINTS, QUADS, {**SHAPES, **crowd})
    line = chain.lay_out(rig, chain.settings(groups={"opposed": False}, candidates={"beside_composite": False}))
    board = [element for element in line.layout.elements if element.anchor.beside]
    assert board
    assert {element.family for element in board} == {"crowded"}
    assert all(element.reason for element in board)
    peaks = {rig.controls[m.control].name: m.arc_length.max() for m in line.context.trajectories.motions}
    left = [peaks[m.control] for e in board for m in e.members]
    stayed = [peaks[m.control] for e in line.layout.elements if not e.anchor.beside for m in e.members]
    assert np.mean(left) < np.mean(stayed)
    assert all(member.control.startswith("c") for element in board for member in element.members)


def test_the_board_hangs_on_the_joint_that_holds_the_face():
    from usdrigui.model import Joint, Skeleton, Skin

    rig = rig_with(whole=np.full_like(POINTS, 0.2))
    head = (POINTS[:, 1] > -0.9).astype(float)
    skin = Skin(
        np.tile([0, 1], (len(POINTS), 1)), np.stack([1.0 - head, head], axis=1), "classicLinear", np.eye(4), False
    )
    joints = tuple(
        Joint(name, 0, parent, np.eye(4), np.eye(4), np.eye(4)) for name, parent in (("neck", -1), ("neck/head", 0))
    )
    mesh = replace(rig.meshes[0], skin=skin)
    rig = replace(rig, meshes=(mesh,), joints=joints, skeletons=(Skeleton("/Root/skel", "", np.eye(4)),))
    line = chain.lay_out(rig)
    whole = chain.by_name(line)["whole"]
    assert head[whole.anchor.point] == 1.0


def test_proxies_draw_the_hidden_trajectory_at_the_visible_anchor():
    teeth = np.array([[-0.3, -0.6, 0.2], [0.3, -0.6, 0.2], [0.3, -0.3, 0.2], [-0.3, -0.3, 0.2]])
    face = [makers.shape(i, offsets) for i, offsets in enumerate(SHAPES.values())]
    meshes = [
        makers.mesh(POINTS, QUADS, face),
        makers.mesh(teeth, [[0, 1, 2, 3]], [makers.shape(len(SHAPES), np.full((4, 3), 0.1))], path="/Root/teeth"),
    ]
    rig = makers.rig_of_meshes(meshes, [*SHAPES, "teeth"])
    line = chain.lay_out(rig, chain.settings(controls={"teeth": {"place": "proxy"}}))
    element = chain.by_name(line)["teeth"]
    assert element.anchor.mesh == "/Root/mesh"
    assert np.allclose(element.members[0].track[1] - element.members[0].track[0], 0.1, atol=1e-6)


def test_the_base_pose_moves_anchors_and_is_recorded():
    values = np.zeros(12)
    values[8] = 1.0
    line = chain.lay_out(makers.face(), base_values=values)
    pucker = chain.by_name(line)["pucker"]
    moved = POINTS[pucker.anchor.point] + SHAPES["pucker"][pucker.anchor.point]
    assert np.allclose(pucker.anchor.position, moved, atol=1e-6)
    assert line.layout.base_values[8] == 1.0
    assert np.allclose(pucker.members[0].track[-1], moved, atol=1e-6)
