"""Orbits of an n-fold symmetry."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest

from usdrigui.errors import RigUIError
from usdrigui.layout.symmetry.orbits import orbit_points


@pytest.mark.parametrize("arms", [2, 3, 5])
def test_an_orbit_is_laid_out_once_and_all_its_copies_count(arms):
    rig = makers.star(arms)
    orbit = {"orbit": tuple(f"arm{k}" for k in range(arms))}
    said = chain.settings(controls={"arm0": orbit}, candidates={"occlusion": False})
    if arms == 2:
        rig = makers.changed(rig, up=np.array([0.0, 0.0, 1.0]))
    line = chain.lay_out(rig, said)
    assert len(line.problem.variables) == 1
    assert line.problem.variables[0].handles.shape[1] == arms
    anchors = np.stack([chain.by_name(line)[f"arm{k}"].anchor.position for k in range(arms)])
    assert np.allclose(np.linalg.norm(anchors, axis=1), np.linalg.norm(anchors[0]))
    angle = 2.0 * np.pi / arms
    turn = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1]])
    assert np.allclose(anchors[0] @ turn, anchors[1], atol=1e-6)
    found = line.face.trajectories
    assert (
        orbit_points(found.surface, found.motions, rig.up, 0.01 * found.surface.face_size, np.arange(60)) >= 0
    ).all()


@pytest.mark.parametrize("orbit", [("arm0",), ("arm0", "nobody"), ("arm0", "arm0")])
def test_wrong_orbits_are_refused(orbit):
    with pytest.raises(RigUIError):
        chain.problem_of(makers.star(3), chain.settings(controls={"arm0": {"orbit": orbit}}))


def test_an_orbit_of_two_does_not_depend_on_where_the_character_is():
    rig = makers.changed(makers.star(2), up=np.array([0.0, 0.0, 1.0]))
    moved = makers.changed(
        rig, meshes=tuple(replace(mesh, points=mesh.points + np.array([3.0, 5.0, -2.0])) for mesh in rig.body.meshes)
    )
    said = chain.settings(controls={"arm0": {"orbit": ("arm0", "arm1")}}, candidates={"occlusion": False})
    here, there = (chain.by_name(chain.lay_out(each, said)) for each in (rig, moved))
    assert {name: each.anchor.point for name, each in here.items()} == {
        name: each.anchor.point for name, each in there.items()
    }
