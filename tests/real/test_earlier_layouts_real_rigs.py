"""Layouts over the life of real rigs: fixed, kept, and carried to a head of other topology."""

from dataclasses import replace

import numpy as np
import pytest
from laid_out_again import lay_out, read

from usdrigui.layout.review.difference import difference
from usdrigui.model import RigMesh, Shape
from usdrigui.settings import load

pytestmark = pytest.mark.real


def anchors(layout):
    return {e.name: (e.anchor.mesh, e.anchor.point, e.anchor.beside) for e in layout.elements}


@pytest.mark.parametrize("name", ["godette.usdc", "mh_expr34.usdc", "openusd_blendshapes.usda"])
def test_fixed_anchors_are_kept_exactly_and_the_rest_is_optimal_given_them(name):
    rig = read(name)
    _, _, first = lay_out(rig)
    half = replace(first, elements=first.elements[::2])
    proven = load({"solve": {"gap": 1e-4}})
    _, found, made = lay_out(rig, proven, fixed={rig.root: half})
    by_control = {member.control: element for element in made.elements for member in element.members}
    for element in half.elements:
        now = by_control[element.members[0].control]
        assert {m.control for m in now.members} == {m.control for m in element.members}
        assert now.anchor.beside == element.anchor.beside
        if not element.anchor.beside:
            assert (now.anchor.mesh, now.anchor.point) == (element.anchor.mesh, element.anchor.point)
    assert found.status == "optimal"
    assert found.gap <= 1e-4


def test_removing_and_adding_five_moves_fewer_than_one_in_twenty():
    rig = read("vitruvian.usdc")
    quick = load({"solve": {"gap": 1e-2, "work_limit": 300_000}})
    names = np.random.default_rng(5).permutation([control.name for control in rig.controls])
    coming, going = set(names[:5]), set(names[5:10])

    def without(gone):
        return replace(rig, controls=tuple(control for control in rig.controls if control.name not in gone))

    _, _, before = lay_out(without(coming), quick)
    _, _, after = lay_out(without(going), quick, previous={rig.root: before})
    found = difference(before, after)
    told = {kind: {c.control for c in found.changes if c.kind == kind} for kind in ("added", "removed")}
    laid = {m.control for layout in (before, after) for e in layout.elements for m in e.members}
    assert told == {"added": coming & laid, "removed": going & laid}
    assert len(found.displaced) < found.shared / 20


def reshaped(points, box):
    """Another head in the same box: wider jaw, longer chin, flatter; smooth, and the same for every point."""
    low, size = box
    x, y, z = ((points - low) / size - 0.5).T
    turned = np.stack([x * (1.1 - 0.3 * y), 1.15 * y + 0.1 * y * y, 0.85 * z + 0.15 * x * x], axis=1)
    return (turned + 0.5) * size + low


def other_head(rig, cells, box):
    """The rig on coarser meshes, reshaped: points of one cell of a grid become one, motions go along."""
    return replace(rig, meshes=tuple(_other_mesh(mesh, cells, box) for mesh in rig.meshes))


def _other_mesh(mesh: RigMesh, cells, box):
    low, size = box
    cell = np.floor((mesh.points - low) / size.max() * cells).astype(np.int64)
    _, kept, place = np.unique(cell, axis=0, return_index=True, return_inverse=True)
    place = place.reshape(-1)
    corners = np.split(place[mesh.face_indices], np.cumsum(mesh.face_counts)[:-1])
    faces = [face for face in corners if len(set(face.tolist())) == len(face)]
    old = mesh.points[kept]
    shapes = []
    for shape in mesh.shapes:
        dense = np.zeros((len(shape.weights), len(mesh.points), 3))
        dense[:, shape.points] = shape.offsets
        offsets = np.stack([reshaped(old + each[kept], box) - reshaped(old, box) for each in dense])
        points = np.flatnonzero(offsets.any(axis=(0, 2)))
        shapes.append(Shape(shape.channel, shape.path, shape.weights, points, offsets[:, points].astype(np.float32)))
    skin = mesh.skin and replace(mesh.skin, joints=mesh.skin.joints[kept], weights=mesh.skin.weights[kept])
    return replace(
        mesh,
        points=reshaped(old, box),
        face_counts=np.array([len(face) for face in faces], dtype=np.int64),
        face_indices=np.concatenate(faces) if faces else np.zeros(0, dtype=np.int64),
        shapes=tuple(shapes),
        skin=skin,
        topology_hash="coarse " + mesh.topology_hash,
        subsets=(),
    )


def test_nine_in_ten_controls_stand_within_two_handle_widths_on_a_head_of_other_topology():
    rig = read("ict_face57.usdc")
    ready, _, theirs = lay_out(rig)
    points = np.concatenate([mesh.points for mesh in rig.meshes])
    box = points.min(axis=0), np.ptp(points, axis=0)
    other = other_head(rig, 110, box)
    assert sum(len(mesh.points) for mesh in other.meshes) < 0.7 * len(points)
    context, _, ours = lay_out(other, like=((rig, theirs),))
    now = {member.control: element.anchor for element in ours.elements for member in element.members}
    # Meshes without skin or transform: root space is their own.
    assert all(
        np.allclose(ready.face.trajectories.base[s : s + len(m.points)], m.points, atol=1e-4)
        for s, m in zip(rig.starts, rig.meshes, strict=False)
    )
    apart = []
    for element in theirs.elements:
        for member in element.members:
            anchor = now[member.control]
            if element.anchor.beside:
                apart.append(0.0 if anchor.beside else np.inf)
            else:
                place = reshaped(element.anchor.position[None], box)[0]
                off = np.linalg.norm(anchor.position - place) / context.face.handle_width
                apart.append(np.inf if anchor.beside else off)
    assert np.mean(np.array(apart) <= 2.0) >= 0.9
