"""Locality: near something, or at a proxy."""

import chain
import makers
import numpy as np
import pytest

from usdrigui.errors import RigUIError

POINTS, QUADS = makers.mask()


SHAPES = makers.face_shapes(POINTS)


TEETH = np.array([[-0.3, -0.6, 0.2], [0.3, -0.6, 0.2], [0.3, -0.3, 0.2], [-0.3, -0.3, 0.2]])


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
    found = chain.with_candidates(rig, chain.settings(**parts))
    return lambda name: chain.set_of(found, name)


def test_a_hidden_control_may_stand_at_a_visible_proxy():
    found = chosen(rig_with_teeth(), controls={"teeth": {"place": "proxy"}})("teeth")
    assert found.category != "hidden"
    assert (found.points < len(POINTS)).all()
    assert (found.sources >= len(POINTS)).all()
    near = np.linalg.norm(POINTS[found.points] - TEETH.mean(axis=0), axis=1)
    assert near.max() < 0.8


@pytest.mark.parametrize("near", ["/Root/mesh.point[700]", "/Root/mesh.point[0]"])
def test_locality_keeps_candidates_near_or_takes_the_nearest(near):
    point = int(near.split("[")[1][:-1])
    line = chain.with_candidates(makers.face(), chain.settings(controls={"jawLeft": {"near": near, "within": 0.1}}))
    found, free = chain.set_of(line, "jawLeft"), chosen(makers.face())("jawLeft")
    moved = line.face.trajectories.motions[found.motion].points
    seen = moved[line.face.views.anywhere[moved]]
    apart = np.linalg.norm(POINTS - POINTS[point], axis=1)
    assert 1 <= len(found.points) < len(free.points)
    assert apart[found.points].min() == pytest.approx(apart[seen].min())


@pytest.mark.parametrize("near", ["joint:nobody", "/no/mesh", "/Root/mesh.point[99999]"])
def test_locality_refuses_what_is_not_there(near):
    with pytest.raises(RigUIError) as refused:
        chosen(makers.face(), controls={"chin": {"near": near}})
    assert refused.value.issue.code == "CONFIG_VALUE"
