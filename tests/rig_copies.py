"""Copies of a rig as its life makes them: renamed, reordered, on a coarser mesh, reshaped, sculpted again."""

from __future__ import annotations

import itertools
import re
import zlib
from dataclasses import replace

import numpy as np
from makers import changed
from scipy.spatial.transform import Rotation

from usdrigui.character import RigMesh, Shape

_SIDE = re.compile("(?:_|-)?(L|R|Left|Right|left|right)$")


def box_of(rig):
    """Corner and size of the box around all points that a shape moves."""
    points = np.concatenate([mesh.points[shape.points] for mesh in rig.body.meshes for shape in mesh.shapes])
    return points.min(axis=0), np.ptp(points, axis=0)


def reshaped(points, box):
    """Another head in the same box: wider jaw, longer chin, flatter; smooth, and the same for every point."""
    low, size = box
    x, y, z = ((points - low) / size - 0.5).T
    turned = np.stack([x * (1.1 - 0.3 * y), 1.15 * y + 0.1 * y * y, 0.85 * z + 0.15 * x * x], axis=1)
    return (turned + 0.5) * size + low


def other_head(rig, cells, box):
    """The rig on coarser meshes, reshaped: points of one cell of a grid become one, motions go along."""

    def other_mesh(mesh):
        cell = np.floor((mesh.points - box[0]) / box[1].max() * cells).astype(np.int64)
        return _merged(mesh, cell, lambda points: reshaped(points, box), 0)

    return changed(rig, meshes=tuple(map(other_mesh, rig.body.meshes)))


def decimated(rig, share):
    """The rig with about this share of each mesh's points: points become one with a neighbour, the anchors' too."""
    return changed(rig, meshes=tuple(_merged(mesh, _absorbed(mesh, share), np.array, 2) for mesh in rig.body.meshes))


def _faces(mesh):
    return np.split(mesh.topology.face_indices, np.cumsum(mesh.topology.face_counts)[:-1])


def _absorbed(mesh, share):
    """(n, 1) which point each becomes: itself, or a neighbour that takes in two at most."""
    corners = _faces(mesh)
    pairs = np.concatenate([np.stack([face, np.roll(face, 1)], axis=1) for face in corners])
    place, taken = np.arange(len(mesh.points)), np.zeros(len(mesh.points))
    left = (1.0 - share) * len(place)
    for one, other in np.random.default_rng(0).permutation(pairs):
        if left > 0.0 and 0 <= taken[one] < 2 and not taken[other]:
            place[other], taken[other], taken[one], left = one, -1, taken[one] + 1, left - 1.0
    return place[:, None]


def _merged(mesh: RigMesh, cell, reshaped, lost):
    """The mesh whose points of one cell (n, k) are one, without faces that have lost more corners."""
    _, kept, place = np.unique(cell, axis=0, return_index=True, return_inverse=True)
    place = place.reshape(-1)
    shrunk = [(len(face), list(dict.fromkeys(place[face].tolist()))) for face in _faces(mesh)]
    faces = [face for count, face in shrunk if len(face) >= max(3, count - lost)]
    old = mesh.points[kept]
    shapes = []
    for shape in mesh.shapes:
        dense = np.zeros((len(shape.weights), len(mesh.points), 3))
        dense[:, shape.points] = shape.offsets
        offsets = np.stack([reshaped(old + each[kept]) - reshaped(old) for each in dense])
        points = np.flatnonzero(offsets.any(axis=(0, 2)))
        shapes.append(Shape(shape.channel, shape.path, shape.weights, points, offsets[:, points].astype(np.float32)))
    skin = mesh.skin and replace(mesh.skin, joints=mesh.skin.joints[kept], weights=mesh.skin.weights[kept])
    return changed(
        mesh,
        points=reshaped(old),
        face_counts=np.array([len(face) for face in faces], dtype=np.int64),
        face_indices=np.concatenate(faces) if faces else np.zeros(0, dtype=np.int64),
        shapes=tuple(shapes),
        skin=skin,
        hash="coarse " + mesh.topology.hash,
        subsets=(),
    )


def split(rig):
    """The rig whose meshes are two each: the faces of the second half, as they are listed, are another mesh."""
    return changed(rig, meshes=tuple(half for mesh in rig.body.meshes for half in _halves(mesh)))


def _halves(mesh):
    corners = _faces(mesh)
    for name, faces in (("", corners[: len(corners) // 2]), ("_more", corners[len(corners) // 2 :])):
        kept, place = np.unique(np.concatenate(faces), return_inverse=True)
        inside = [np.isin(shape.points, kept) for shape in mesh.shapes]
        shapes = tuple(
            replace(each, points=np.searchsorted(kept, each.points[own]), offsets=each.offsets[:, own])
            for each, own in zip(mesh.shapes, inside, strict=True)
        )
        counts, title = np.array([len(face) for face in faces]), f"half{name} {mesh.topology.hash}"
        yield changed(
            mesh, path=mesh.path + name, points=mesh.points[kept], face_counts=counts, face_indices=place.reshape(-1),
            shapes=shapes, hash=title, subsets=(),
        )  # fmt: skip


def renamed(rig, name):
    """The rig whose controls are called `name(old)`, and the names by the old ones."""
    names = {control.name: name(control.name) for control in rig.controls}
    return replace(rig, controls=tuple(replace(each, name=names[each.name]) for each in rig.controls)), names


def spelt_otherwise(name):
    """``browDown_L`` as ``FCL_l-brow-down``: another case, another order, a prefix that all share."""
    side = _SIDE.search(name)
    words = re.findall("[A-Z]?[a-z]+|[A-Z]+|[0-9]+", name[: side.start()] if side else name)
    return "FCL_" + "-".join([*([side[1][0].lower()] if side else []), *(word.lower() for word in words)])


def numbers():
    """Names that say nothing, one after the other."""
    count = itertools.count()
    return lambda _: f"target.{next(count):03d}"


def reordered(rig, seed):
    """The rig with its controls and the points of its meshes in another order."""
    random = np.random.default_rng(seed)
    controls = tuple(rig.controls[i] for i in random.permutation(len(rig.controls)))
    meshes = tuple(_reordered(mesh, random.permutation(len(mesh.points))) for mesh in rig.body.meshes)
    return changed(rig, controls=controls, meshes=meshes)


def _reordered(mesh, order):
    place = np.argsort(order)
    skin = mesh.skin and replace(mesh.skin, joints=mesh.skin.joints[order], weights=mesh.skin.weights[order])
    return changed(
        mesh,
        points=mesh.points[order],
        face_indices=place[mesh.topology.face_indices],
        shapes=tuple(_in_order(shape, place) for shape in mesh.shapes),
        skin=skin,
        hash=f"{mesh.topology.hash} in the order {zlib.crc32(order.tobytes())}",
        subsets=(),
    )


def _in_order(shape, place):
    points = place[shape.points]
    order = np.argsort(points)
    return replace(shape, points=points[order], offsets=shape.offsets[:, order])


def resculpted(rig, seed, amount=0.15):
    """The rig with every shape stronger or weaker, and bent by a smooth share `amount` of itself."""
    random = np.random.default_rng(seed)
    return changed(rig, meshes=tuple(_resculpted(mesh, random, amount) for mesh in rig.body.meshes))


def _resculpted(mesh, random, amount):
    size = np.ptp(mesh.points, axis=0).max()
    shapes = []
    for shape in mesh.shapes:
        wave = np.sin(mesh.points[shape.points] @ random.normal(size=(3, 3)) * 6.0 / size)
        length = np.linalg.norm(shape.offsets, axis=2, keepdims=True)
        bent = shape.offsets * random.uniform(0.8, 1.25) + amount * length * wave
        shapes.append(replace(shape, offsets=bent.astype(np.float32)))
    return changed(mesh, shapes=tuple(shapes))


def _about(axis, degrees):
    return Rotation.from_euler(axis, degrees, degrees=True).as_matrix()


WORLDS = {
    "on its back": lambda _: _about("x", 90),
    "on its belly": lambda _: _about("x", -90),
    "on a side": lambda rng: _about("z", 90 * rng.choice([-1, 1])),
    "tilted": lambda rng: _about("z", rng.uniform(-35, 35)),
    "nodding": lambda rng: _about("x", rng.uniform(-40, 40)),
    "turned": lambda rng: _about("y", rng.uniform(0, 360)),
    "mirrored": lambda _: np.diag([-1.0, 1.0, 1.0]),
}
"""How a Y-up character stands otherwise than its stage has it: rotations (3, 3) of column vectors, of a generator."""


def turned(rig, rotation):
    """The rig under a rotation or reflection (3, 3) of a Y-up world about the origin; its stage stays as it is."""
    world = np.eye(4)
    level = Rotation.align_vectors([rig.up], [[0.0, 1.0, 0.0]])[0].as_matrix()
    world[:3, :3] = (level @ rotation @ level.T).T
    meshes = [
        changed(
            mesh,
            to_root=mesh.to_root @ world,
            left_handed=mesh.topology.left_handed ^ bool(np.linalg.det(rotation) < 0.0),
        )
        for mesh in rig.body.meshes
    ]
    skeletons = [replace(each, to_root=each.to_root @ world) for each in rig.body.skeletons]
    return changed(rig, meshes=tuple(meshes), skeletons=tuple(skeletons))
