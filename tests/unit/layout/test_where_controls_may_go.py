"""Visibility, pruning, and which controls belong beside the face."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest

from usdrigui.errors import RigUIError
from usdrigui.layout.candidates import candidates
from usdrigui.layout.composites import composites
from usdrigui.layout.facing import front
from usdrigui.layout.visibility import find_views, mostly_hidden, screen

POINTS, QUADS = makers.mask()
SHAPES = makers.face_shapes(POINTS)
TEETH = np.array([[-0.3, -0.6, 0.2], [0.3, -0.6, 0.2], [0.3, -0.3, 0.2], [-0.3, -0.3, 0.2]])


def rig_with(**more):
    return makers.rig(POINTS, QUADS, {**SHAPES, **more})


def rig_with_teeth(skin_moves=0.0, visible=True):
    """The face with teeth behind it, and a control that moves the teeth, and the skin by `skin_moves`."""
    names = [*SHAPES, "teeth"]
    face = [makers.shape(i, offsets) for i, offsets in enumerate(SHAPES.values())]
    face.append(makers.shape(len(SHAPES), skin_moves * SHAPES["pucker"]))
    meshes = [
        makers.mesh(POINTS, QUADS, face),
        makers.mesh(
            TEETH,
            [[0, 1, 2, 3]],
            [makers.shape(len(SHAPES), np.full((4, 3), 0.1))],
            path="/Root/teeth",
            visible=visible,
        ),
    ]
    return makers.rig_of_meshes(meshes, names)


def chosen(rig, **parts):
    context = chain.context_of(rig, chain.settings(**parts))
    line = chain.Line(context, candidates(context), None, None, None)
    return lambda name: chain.set_of(line, name)


# --- views -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("matrix", [np.eye(3), np.diag([-1.0, 1, -1]), np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])])
def test_the_face_looks_where_it_moves(matrix):
    rig = makers.moved(makers.face(), matrix)
    context = chain.context_of(rig)
    assert front(rig, context.trajectories, context.symmetry.normal) @ (matrix @ [0, 0, 1]) == pytest.approx(1.0)
    assert front(rig, context.trajectories, np.zeros(3)) @ (matrix @ [0, 0, 1]) == pytest.approx(1.0, abs=1e-3)


def test_views_are_named_or_angles_or_a_camera():
    context = chain.context_of(makers.face())

    def directions(view, camera=None):
        return find_views(context.rig, context.trajectories, context.symmetry, view, True, camera).directions

    assert len(directions("")) == 3
    assert np.allclose(directions("front"), [[0, 0, 1]])
    assert np.allclose(directions("side"), [[1, 0, 0]])
    assert np.allclose(directions("90,0"), directions("side"))
    assert np.allclose(directions("0,90"), [[0, 1, 0]])
    assert np.allclose(directions("/cam", np.array([0.0, 0.0, 5.0])), [[0, 0, 1]])
    for view in ("nowhere", "1,2,3", "/cam"):
        with pytest.raises(RigUIError) as refused:
            directions(view)
        assert refused.value.issue.code == "CONFIG_VALUE"


def test_the_screen_is_upright_even_from_above():
    context = chain.context_of(makers.face())
    for view, right, up in (("front", [1, 0, 0], [0, 1, 0]), ("0,90", [1, 0, 0], [0, 0, -1])):
        views = find_views(context.rig, context.trajectories, context.symmetry, view)
        assert np.allclose(screen(views), [right, up], atol=1e-6)


def test_what_lies_behind_the_face_is_not_seen_unless_occlusion_is_off():
    context = chain.context_of(rig_with_teeth())
    assert not context.views.anywhere[-4:].any()
    assert context.views.anywhere[: len(POINTS)].mean() > 0.8
    without = chain.context_of(rig_with_teeth(), chain.settings(candidates={"occlusion": False}))
    assert without.views.anywhere.all()
    hidden = chain.context_of(rig_with_teeth(visible=False), chain.settings(candidates={"occlusion": False}))
    assert not hidden.views.anywhere[-4:].any()


def test_tracks_inside_the_model_are_hidden_and_shallow_ones_are_not():
    context = chain.context_of(makers.face())
    point = np.argmin(np.linalg.norm(POINTS[:, :2], axis=1))
    steps = np.linspace(0.0, 1.0, 5)[:, None] * context.trajectories.normals[point]
    deep, out, shallow = (POINTS[point] + length * steps for length in (-0.3, 0.3, -0.01))
    normals = np.repeat(context.trajectories.normals[[point]], 3, axis=0)
    found = mostly_hidden(context.views, np.stack([deep, out, shallow]), normals, depth=0.02)
    assert found.tolist() == [True, False, False]


# --- pruning -----------------------------------------------------------------------------------------


def test_pruning_keeps_what_moves_more_than_the_mean_and_half_the_peak():
    context = chain.context_of(makers.face())
    line = chain.Line(context, candidates(context), None, None, None)
    motion = context.trajectories.motions[0]
    kept = chain.set_of(line, "brow_L").points
    arc = dict(zip(motion.points.tolist(), motion.arc_length.tolist(), strict=True))
    least = max(motion.arc_length.mean(), 0.5 * motion.arc_length.max())
    assert all(arc[point] >= least for point in kept.tolist())
    assert motion.points[np.argmax(motion.arc_length)] in kept


def test_pruning_follows_its_settings():
    def size(**parts):
        return len(chosen(makers.face(), candidates=parts)("brow_L").points)

    assert size(peak_share=0.9) < size() < size(peak_share=0.0, prune_at=0.5)


def test_split_points_give_one_candidate_per_place():
    seam = np.flatnonzero(np.isclose(POINTS[:, 0], 0.0))
    doubled = np.vstack([POINTS, POINTS[seam]])
    shapes = {name: np.vstack([each, each[seam]]) for name, each in SHAPES.items()}
    found = chosen(makers.rig(doubled, QUADS, shapes))("pucker")
    assert (found.points < len(POINTS)).all()


def test_a_control_that_peaks_inside_stands_on_the_skin_it_moves():
    found = chosen(rig_with_teeth(skin_moves=0.5))("teeth")
    assert not found.hidden
    assert (found.points < len(POINTS)).all()


def test_only_what_can_be_seen_from_the_view_is_a_candidate():
    front_only = chosen(makers.face(), candidates={"view": "90,0"})("smile_R")
    assert front_only.hidden
    assert not chosen(makers.face(), candidates={"view": "-90,0"})("smile_R").hidden


# --- beside the face ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "whole",
    [np.full_like(POINTS, 0.2), 0.3 * POINTS, POINTS * [0.3, 0.0, 0.1]],
    ids=["translation", "scale", "identity"],
)
def test_whole_head_controls_are_global(whole):
    rig = rig_with(whole=whole)
    found = chosen(rig)
    assert found("whole").globally
    assert "whole" in found("whole").reason
    assert not any(found(name).globally for name in SHAPES)
    assert not chosen(rig, candidates={"beside_global": False})("whole").globally
    assert not chosen(rig, controls={"whole": {"place": "face"}})("whole").globally


def test_whole_head_controls_may_peak_off_the_face():
    """Identity shapes move the shoulders or the back of the head several times as far as the face."""
    rim = np.abs(POINTS[:, 0]) > 0.7
    assert not any(np.any(each[rim]) for each in SHAPES.values()), "no other control moves the rim"
    spot = np.linalg.norm(POINTS[:, :2] - [0.35, 0.55], axis=1) < 0.1
    even = np.where(spot[:, None], 1.6, 1.0) * np.full_like(POINTS, 0.05)
    assert chosen(rig_with(whole=np.where(rim[:, None], 5.0 * even, even)))("whole").globally
    assert not chosen(rig_with(whole=np.where(rim[:, None], 30.0 * even, even)))("whole").globally


def test_controls_of_hidden_things_are_hidden():
    found = chosen(rig_with_teeth())
    assert found("teeth").hidden
    assert not found("chin").hidden
    kept = chosen(rig_with_teeth(), candidates={"beside_hidden": False})("teeth")
    assert not kept.hidden
    assert (kept.points >= len(POINTS)).any()


def test_a_hidden_control_may_stand_at_a_visible_proxy():
    found = chosen(rig_with_teeth(), controls={"teeth": {"place": "proxy"}})("teeth")
    assert not found.hidden
    assert (found.points < len(POINTS)).all()
    assert (found.sources >= len(POINTS)).all()
    near = np.linalg.norm(POINTS[found.points] - TEETH.mean(axis=0), axis=1)
    assert near.max() < 0.8


def test_parts_that_vanish_are_global():
    hair = np.array([[0.9, 1.0, 0.3], [1.2, 1.0, 0.3], [1.2, 1.3, 0.3], [0.9, 1.3, 0.3]])
    points, quads = np.vstack([POINTS, hair]), [*QUADS, [len(POINTS) + i for i in range(4)]]
    still = {name: np.vstack([each, np.zeros((4, 3))]) for name, each in SHAPES.items()}

    def hides(offsets):
        shapes = {**still, "hide": np.vstack([np.zeros_like(POINTS), offsets])}
        return chosen(makers.rig(points, quads, shapes))("hide")

    collapsed, sunk, swung = (
        hides(hair.mean(axis=0) - hair),
        hides(np.tile([-1.0, -1.1, -0.2], (4, 1))),
        hides(np.tile([0.0, 0.4, 0.0], (4, 1))),
    )
    assert collapsed.globally
    assert "disappear" in collapsed.reason
    assert sunk.globally
    assert not swung.globally


def test_repetitions_mixtures_and_spreads_are_composites():
    smile = SHAPES["smile_L"] + SHAPES["smile_R"]
    brow = SHAPES["brow_L"] + SHAPES["brow_R"]
    rig = rig_with(
        smile_50=0.5 * SHAPES["pucker"], both=smile, emotion=0.6 * brow + 0.8 * SHAPES["pucker"] + SHAPES["chin"] * 0.5
    )
    found = chosen(rig)
    assert "pucker" in found("smile_50").reason
    assert found("smile_50").composite
    assert found("both").composite
    assert found("emotion").composite
    assert not any(found(name).composite for name in SHAPES)
    assert not chosen(rig, candidates={"beside_composite": False})("both").composite
    assert not chosen(rig, controls={"both": {"place": "face"}})("both").composite


@pytest.mark.parametrize("noise", [0.0, 1e-3])
def test_of_many_copies_one_stays_and_the_others_repeat_it(noise):
    random = np.random.default_rng(1)
    raised = makers.bump(POINTS, (0.0, 0.8), (0, 1, 0.2), 0.3)
    copies = {f"copy_{i:02d}": raised + noise * raised * random.normal(size=raised.shape) for i in range(12)}
    found = chosen(rig_with(**copies))
    said = [found(name) for name in copies]
    assert sum(not each.composite for each in said) == 1
    assert all(each.reason.startswith("does the same as copy_") for each in said if each.composite)


def test_a_control_alone_is_no_composite():
    found = chosen(makers.rig(POINTS, QUADS, {"pucker": SHAPES["pucker"]}))("pucker")
    assert (found.composite, found.reason) == (False, "")


def test_a_part_that_stands_twice_is_one_part():
    lesser, whole = (makers.bump(POINTS, (0.0, 0.8), (0, 1, 0.2), radius) for radius in (0.28, 0.3))
    aside = np.linalg.norm(whole, axis=1)[:, None] * [0.25, 0.0, 0.0]
    found = chosen(rig_with(raise_a=lesser, raise_b=lesser, swerving=whole + aside))
    assert not found("swerving").composite


def test_flattened_in_betweens_are_steps_of_their_control():
    off_the_line = 0.5 * SHAPES["pucker"] + 0.3 * np.linalg.norm(SHAPES["pucker"], axis=1)[:, None] * [0.0, 1.0, 0.0]
    found = chosen(rig_with(pucker_50=off_the_line, other=off_the_line * 1.1))
    assert found("pucker_50").composite
    assert "pucker" in found("pucker_50").reason
    assert not found("other").composite


def test_an_emotion_with_a_shape_of_its_own_is_still_a_spread():
    own = makers.bump(POINTS, (0.0, 0.1), (0, 0, 1), 0.5, 0.08)
    brow, smile = SHAPES["brow_L"] + SHAPES["brow_R"], SHAPES["smile_L"] + SHAPES["smile_R"]
    context = chain.context_of(rig_with(emotion=brow + smile + own))
    found = composites(context)
    assert [context.rig.controls[context.trajectories.motions[i].control].name for i in found] == ["emotion"]
    assert "distant" in next(iter(found.values()))


# --- the configuration ------------------------------------------------------------------------------


def test_coverage_is_the_share_of_the_face_for_small_controls_too():
    found = chosen(rig_with(whole=np.full_like(POINTS, 0.2)))
    assert found("whole").coverage == pytest.approx(1.0)
    assert 0.0 < found("sneer_L").coverage < found("brow_L").coverage < 0.5
    assert found("sneer_L").coverage == pytest.approx(found("sneer_R").coverage, rel=0.05)


def test_excluding_a_control_calls_no_other_one_global():
    """A control that moves the lower half is large beside small ones, unless the other half has its own."""
    half = np.where(POINTS[:, 1:2] < 0.35, [[0.0, 0.0, 0.1]], 0.0)
    upper = {f"up{i}": makers.bump(POINTS, (x, 0.75), (0, 0, 1), 0.45) for i, x in enumerate((-0.4, 0.0, 0.4))}
    whole = rig_with(half=half, **upper)
    without = [control for control in whole.controls if not control.name.startswith("up")]
    left_out = tuple(control for control in whole.controls if control.name.startswith("up"))
    gone = replace(whole, controls=tuple(without))
    assert not chosen(whole)("half").globally
    assert chosen(gone)("half").globally
    excluded = replace(gone, excluded=left_out)
    assert not chosen(excluded)("half").globally
    assert chosen(excluded)("half").coverage == pytest.approx(chosen(whole)("half").coverage)
    names = [control.name for control in excluded.controls]
    context = chain.context_of(excluded)
    assert len(context.trajectories.excluded) == 3
    assert {names[motion.control] for motion in context.trajectories.motions} == set(names)


def test_place_beside_and_exclude():
    rig = makers.face()
    assert chosen(rig, controls={"chin": {"place": "beside"}})("chin").requested
    context = chain.context_of(rig, chain.settings(controls={"chin": {"exclude": True}}))
    assert [each.control for each in candidates(context).left_off] == ["chin"]


def test_a_renamed_control_is_known_by_both_names():
    assert chosen(makers.face(), controls={"old": {"rename": "chin", "place": "beside"}})("chin").requested


@pytest.mark.parametrize("near", ["/Root/mesh.point[700]", "/Root/mesh.point[0]"])
def test_locality_keeps_candidates_near_or_takes_the_nearest(near):
    point = int(near.split("[")[1][:-1])
    found = chosen(makers.face(), controls={"jawLeft": {"near": near, "within": 0.1}})("jawLeft")
    free = chosen(makers.face())("jawLeft")
    apart = np.linalg.norm(POINTS[free.points] - POINTS[point], axis=1)
    assert 1 <= len(found.points) < len(free.points)
    assert np.linalg.norm(POINTS[found.points] - POINTS[point], axis=1).min() == pytest.approx(apart.min())


@pytest.mark.parametrize("near", ["joint:nobody", "/no/mesh", "/Root/mesh.point[99999]"])
def test_locality_refuses_what_is_not_there(near):
    with pytest.raises(RigUIError) as refused:
        chosen(makers.face(), controls={"chin": {"near": near}})
    assert refused.value.issue.code == "CONFIG_VALUE"


def test_a_fixed_anchor_is_the_only_candidate():
    found = chosen(makers.face(), controls={"chin": {"anchor": "/Root/mesh#20"}})("chin")
    assert found.points.tolist() == [20]
    for anchor in ("/Root/mesh", "/Root/mesh#x", "/Root/mesh#99999", "/other#1"):
        with pytest.raises(RigUIError):
            chosen(makers.face(), controls={"chin": {"anchor": anchor}})


def test_a_copy_of_the_face_that_is_not_shown_hides_nothing():
    shapes = [makers.shape(i, offsets) for i, offsets in enumerate(SHAPES.values())]
    shown = makers.mesh(POINTS, QUADS, shapes)
    unseen = makers.mesh(POINTS, QUADS, shapes, path="/Root/proxy", visible=False)
    alone = chain.posed(makers.rig_of_meshes([shown], list(SHAPES)))
    doubled = chain.posed(makers.rig_of_meshes([unseen, shown], list(SHAPES)))
    assert [each.hidden for each in doubled.candidates.sets] == [each.hidden for each in alone.candidates.sets]
    for with_copy, without in zip(doubled.candidates.sets, alone.candidates.sets, strict=True):
        assert (with_copy.points - len(POINTS)).tolist() == without.points.tolist()


def test_what_is_said_of_one_twin_holds_for_it_and_for_it_alone():
    names = [name for name in SHAPES if name.endswith(("_R", "Right"))]
    one = next(name for name in names if name.replace("_R", "_L").replace("Right", "Left") in SHAPES)
    other = one.replace("_R", "_L").replace("Right", "Left")
    line = chain.posed(rig_with(), chain.settings(controls={one: {"place": "beside"}}))
    controls = [control.name for control in line.context.rig.controls]
    beside = {controls[c]: group.beside for group in line.groups for c in (*group.controls, *group.mirror)}
    assert beside[one]
    assert not beside[other]
