"""Views, and what they see."""

from dataclasses import replace

import chain
import limbs
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES

from usdrigui.errors import RigUIError
from usdrigui.layout.visibility import clear_handles, find_views, mostly_hidden
from usdrigui.settings import CandidateSettings


def test_views_are_named_or_angles_or_a_camera():
    face = chain.face_of(makers.face())

    def directions(view, camera=None):
        rig = replace(face.rig, camera=camera)
        return find_views(rig, face.trajectories, face.symmetry.plane, CandidateSettings(view=view)).directions

    assert len(directions("")) == 3
    assert np.allclose(directions("front"), [[0, 0, 1]])
    assert np.allclose(directions("side"), [[1, 0, 0]])
    assert np.allclose(directions("90,0"), directions("side"))
    assert np.allclose(directions("0,90"), [[0, 1, 0]])
    assert np.allclose(directions("/cam", np.array([0.0, 0.0, 1.0])), [[0, 0, 1]])
    for view in ("nowhere", "1,2,3"):
        with pytest.raises(RigUIError, match="CONFIG_VALUE"):
            directions(view)


def test_the_screen_is_upright_even_from_above():
    face = chain.face_of(makers.face())
    for view, right, up in (("front", [1, 0, 0], [0, 1, 0]), ("0,90", [1, 0, 0], [0, 0, -1])):
        views = find_views(face.rig, face.trajectories, face.symmetry.plane, CandidateSettings(view=view))
        assert np.allclose(views.screen, [right, up], atol=1e-6)


def test_what_lies_behind_the_face_is_not_seen_unless_occlusion_is_off():
    face = chain.face_of(makers.face_with_teeth())
    assert not face.views.anywhere[-4:].any()
    assert face.views.anywhere[: len(POINTS)].mean() > 0.8
    without = chain.face_of(makers.face_with_teeth(), chain.settings(candidates={"occlusion": False}))
    assert without.views.anywhere.all()
    hidden = chain.face_of(makers.face_with_teeth(visible=False), chain.settings(candidates={"occlusion": False}))
    assert not hidden.views.anywhere[-4:].any()


def test_tracks_inside_the_model_are_hidden_and_shallow_ones_are_not():
    face = chain.face_of(makers.face())
    point = np.argmin(np.linalg.norm(POINTS[:, :2], axis=1))
    steps = np.linspace(0.0, 1.0, 5)[:, None] * face.surface.normals[point]
    deep, out, shallow = (POINTS[point] + length * steps for length in (-0.3, 0.3, -0.01))
    normals = np.repeat(face.surface.normals[[point]], 3, axis=0)
    found = mostly_hidden(face.views, np.stack([deep, out, shallow]), normals, depth=0.02)
    assert found.tolist() == [True, False, False]


def test_a_copy_of_the_face_that_is_not_shown_hides_nothing():
    shapes = [makers.shape(i, offsets) for i, offsets in enumerate(SHAPES.values())]
    shown = makers.mesh(POINTS, QUADS, shapes)
    unseen = makers.mesh(POINTS, QUADS, shapes, path="/Root/proxy", visible=False)
    alone = chain.problem_of(makers.rig_of_meshes([shown], list(SHAPES)))
    doubled = chain.problem_of(makers.rig_of_meshes([unseen, shown], list(SHAPES)))
    assert [each.category == "hidden" for each in doubled.inputs.measured.classification] == [
        each.category == "hidden" for each in alone.inputs.measured.classification
    ]
    for with_copy, without in zip(*(each.candidates.sets.values() for each in (doubled, alone)), strict=True):
        assert (with_copy.points - len(POINTS)).tolist() == without.points.tolist()


def test_a_handle_is_clear_where_its_rim_is_seen_and_not_edge_on():
    """Two plates with a gap between them, over a floor; a wall that looks nearly aside."""
    floor = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0], [0, 0, 0]], float)
    plates = np.array([[s * x, y, 0.5] for s in (-1, 1) for x, y in ((0.05, -1), (1, -1), (1, 1), (0.05, 1))], float)
    quads = [[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4], [8, 7, 6, 5], [9, 10, 11, 12]]
    points = np.concatenate([floor, plates])
    rig = makers.rig(points, quads, {"move": np.tile([0.0, 0.0, 0.1], (len(points), 1))})
    face = chain.face_of(rig, chain.settings(candidates={"view": "front"}))
    views, normals = face.views, np.tile([0.0, 0.0, 1.0], (len(points), 1))
    assert views.visible[0, 4], "the point itself is seen through the gap"
    assert clear_handles(views, points, normals, 0.05)[4]
    assert not clear_handles(views, points, normals, 0.4)[4]
    aside = np.tile([0.99, 0.0, 0.1], (len(points), 1))
    assert not clear_handles(views, points, aside, 0.05)[4]


def test_only_a_single_view_from_the_side_sees_one_side_only():
    face = chain.face_of(makers.face())
    normal = face.symmetry.plane.normal
    assert not face.views.one_sided(normal)
    for toward, one_sided in ((normal, True), (face.views.directions[0], False)):
        assert replace(face.views, directions=toward[None]).one_sided(normal) == one_sided
    assert not replace(face.views, directions=np.stack([normal, -normal])).one_sided(normal)


def test_what_the_usual_views_hide_of_a_joint_is_seen_from_behind():
    """A tail behind a wall."""
    names, places = ["h", "h/t"], np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 3.0]])
    rig = limbs.with_default_controls(limbs.skeleton_rig(names, places, [0, 1], size=[2.0, 0.2]))
    face = chain.face_of(rig)
    plane = replace(face.symmetry.plane, normal=-face.symmetry.plane.normal)
    views = find_views(face.rig, face.trajectories, plane, CandidateSettings())
    assert not views.visible[:3, 8:].any()
    assert views.anywhere[8:].any()
    assert views.directions[3] @ views.ahead < 0.0
