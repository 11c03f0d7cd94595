"""Layout problems to measure solvers on: families of face-like ones from a seed, and finer heads
from real rigs."""

from __future__ import annotations

from dataclasses import replace
from types import MappingProxyType

import numpy as np

from usdrigui.character import Floats, Indices, Rig, RigMesh, Shape
from usdrigui.layout.place.handle_width import KEPT, fitting_width
from usdrigui.model import LayoutProblem, MeanOverlap, Variable
from usdrigui.overlap import own_costs
from usdrigui.settings import ObjectiveSettings

NEAR = 0.08
"""Of the face's height: what is nearer than this is around a place."""
TABLE_1 = MappingProxyType(
    {
        "head rig": (1_186, 26),
        "angela": (4_002, 22),
        "dakar valley girl": (5_064, 47),
        "mery": (12_942, 28),
        "metahuman": (24_049, 142),
        "nico": (27_434, 28),
        "allen henry": (85_753, 65),
    }
)
"""Points and controls of rigs in the paper's Table 1."""

_FEATURES = (
    # where controls gather on a face (x, height), how widely where they are crowded, and what share
    # of them
    (0.0, -0.45, 0.16, 0.45),  # mouth
    (0.33, 0.22, 0.10, 0.20),  # eye
    (0.33, 0.45, 0.10, 0.15),  # brow
    (0.10, -0.05, 0.08, 0.08),  # nose
    (0.50, -0.15, 0.12, 0.12),  # cheek
)
SCATTER = 2.25
"""How much more widely controls stand than where they are crowded: as closely as on the closest of
the real rigs (decision 034)."""
CROWDED = 1.0
"""Nearly three times as closely as on any rig we know: harder problems than a layout of a face
poses."""
MIXED = 5
"""Motions of the mouth that visemes are mixtures of: jaw, funnel, pucker, stretch, lower lip."""


def face_like(points: int, controls: int, seed: int = 0, scatter: float = SCATTER) -> LayoutProblem:
    """A problem of the size and the crowding of a face: a head of `points`, `controls` bumps of
    motion on it.

    A third of the controls lies on the middle line; of the rest, mirrored pairs are optimised once
    with two copies, so the number of variables is about two thirds of `controls`.  Lengths in head
    half-heights. Handles are as wide as a layout of such controls would make them by default
    (decisions 034, 045).
    """
    generator = np.random.default_rng(seed)
    positions, normals = _head(points)
    middle = round(controls / 3)
    middle += (controls - middle) % 2
    motions = [
        _motion(generator, positions, normals, scatter, mirrored=at >= middle)
        for at in range((controls + middle) // 2)
    ]
    return _problem(positions, motions)


def viseme_like(points: int, controls: int, seed: int = 0) -> LayoutProblem:
    """A problem of a head that has visemes alone: `controls` mixtures of a few motions of the
    mouth, which all want the same places.  Lengths in head half-heights."""
    generator = np.random.default_rng(seed)
    positions, normals = _head(points)
    mouth = np.stack(
        [_motion(generator, positions, normals, CROWDED, mirrored=False)[0] for _ in range(MIXED)]
    )
    shares = generator.dirichlet(np.ones(MIXED), controls)
    return _problem(positions, [(np.tensordot(each, mouth, 1), False) for each in shares])


def _problem(positions: Floats, motions: list[tuple[Floats, bool]]) -> LayoutProblem:
    """The problem of a head whose controls make these motions; of mirrored ones one of two."""
    settings = ObjectiveSettings()
    width = _handle_width(positions, motions, settings)
    overlap = MeanOverlap(
        settings.overlap_max,
        settings.overlap_radius * width,
        settings.overlap_sharpness / (settings.overlap_radius * width),
        settings.overlap_cutoff * settings.overlap_radius * width,
        1.0 - settings.displacement_weight,
    )
    typical = float(np.median([np.linalg.norm(offsets, axis=1).max() for offsets, _ in motions]))
    variables = tuple(
        _variable(f"control{at}", positions, offsets, mirrored, typical, settings, overlap, width)
        for at, (offsets, mirrored) in enumerate(motions)
    )
    return LayoutProblem(variables, overlap, width)


def _head(points: int) -> tuple[Floats, Floats]:
    """Evenly spread points and normals of an ellipsoid; the face looks along +z, the denser
    half."""
    at = np.arange(points) + 0.5
    height, turn = 1.0 - 2.0 * at / points, np.pi * (1.0 + 5.0**0.5) * at
    round_ = np.sqrt(1.0 - height**2)
    normals = np.column_stack([round_ * np.cos(turn), height, round_ * np.sin(turn)])
    # Three quarters of the points of real heads lie on the face: pull the back forward.
    normals[:, 2] = np.where(normals[:, 2] > 0, normals[:, 2], -(np.abs(normals[:, 2]) ** 0.5))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return normals * np.array([0.75, 1.0, 0.85]), normals


def _motion(
    generator: np.random.Generator,
    positions: Floats,
    normals: Floats,
    scatter: float,
    *,
    mirrored: bool,
) -> tuple[Floats, bool]:
    """(n, 3) offsets of one control: a smooth bump at one of the features, sideways and
    outwards."""
    share = np.array([each[3] for each in _FEATURES])
    across, height, spread, _ = _FEATURES[int(generator.choice(len(share), p=share / share.sum()))]
    spread *= scatter
    x = across + spread * generator.normal() if mirrored else 0.0
    y = (height if mirrored else -0.45) + spread * generator.normal()
    front = np.array([0.75 * x, y, 0.85 * np.sqrt(max(0.05, 1.0 - x**2 - y**2))])
    centre = positions[np.square(positions - front).sum(axis=1).argmin()]
    radius = generator.uniform(0.06, 0.25)
    fall = np.exp(-np.square((positions - centre) / radius).sum(axis=1))
    fall[fall < 1e-3] = 0.0
    direction = generator.normal(size=3) + 0.5 * normals
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    amplitude = 0.03 * generator.lognormal(sigma=0.6)
    offsets = amplitude * fall[:, None] * direction
    if not mirrored:
        offsets[:, 0] = 0.0
    return offsets, mirrored


def _handle_width(
    positions: Floats, motions: list[tuple[Floats, bool]], settings: ObjectiveSettings
) -> float:
    """By the rule for real rigs; each of a mirrored pair is a control.  The points are evenly
    spread, so that the places that a control wants share it equally."""
    total = np.zeros((2, len(positions)))
    for offsets, mirrored in motions:
        length = np.linalg.norm(offsets, axis=1)
        wanted = np.flatnonzero(length >= KEPT * length.max())
        total[: 1 + mirrored, wanted] += 1.0 / len(wanted)
    places = np.concatenate([positions, positions * np.array([-1.0, 1.0, 1.0])])
    weights = total.ravel()
    return fitting_width(places[weights > 0], weights[weights > 0], 2.0, settings)


def _variable(
    name: str,
    positions: Floats,
    offsets: Floats,
    mirrored: bool,
    typical: float,
    settings: ObjectiveSettings,
    overlap: MeanOverlap,
    width: float,
) -> Variable:
    """The candidates of one control: points that move more than the mean and half the peak (paper
    section 4.2)."""
    length = np.linalg.norm(offsets, axis=1)
    moving = length[length > 0]
    points: Indices = np.flatnonzero((length >= moving.mean()) & (length >= 0.5 * length.max()))
    along = np.linspace(0.0, 1.0, settings.samples)[None, :, None]
    one = positions[points][:, None] + along * offsets[points][:, None]
    flip = np.array([-1.0, 1.0, 1.0])
    samples = np.stack([one, one * flip], axis=1) if mirrored else one[:, None]
    handles = samples[:, :, 0]
    copies = samples.shape[1]
    displacement = copies * length[points] / typical
    cost = own_costs(samples, handles, overlap, width) - settings.displacement_weight * displacement
    free = np.isfinite(cost)
    off_face = settings.off_face_penalty * copies
    return Variable(
        name,
        points[free],
        cost[free],
        samples[free],
        handles[free].copy(),
        off_face,
        displacement[free],
    )


def subdivided(rig: Rig) -> Rig:
    """The same rig with every mesh face cut into quads once, linearly: four times the points, same
    motions."""
    meshes = tuple(_subdivided_mesh(each) for each in rig.body.meshes)
    return replace(rig, body=replace(rig.body, meshes=meshes))


def _subdivided_mesh(mesh: RigMesh) -> RigMesh:
    counts, indices = mesh.topology.face_counts, mesh.topology.face_indices
    count, faces = len(mesh.points), len(counts)
    face = np.repeat(np.arange(faces), counts)
    first = np.cumsum(counts) - counts
    corner = np.arange(len(face)) - first[face]
    following = indices[first[face] + (corner + 1) % counts[face]]
    ends = np.sort(np.column_stack([indices, following]), axis=1)
    edges, edge = np.unique(ends, axis=0, return_inverse=True)
    edge = edge.reshape(-1)
    before = edge[first[face] + (corner - 1) % counts[face]]
    quads = np.column_stack([indices, count + edge, count + len(edges) + face, count + before])

    def finer(values: Floats) -> Floats:
        """Values at the corners, at the middles of the edges and of the faces."""
        middle = np.add.reduceat(values[indices], first) / counts[:, None]
        return np.concatenate([values, (values[edges[:, 0]] + values[edges[:, 1]]) / 2, middle])

    skin = mesh.skin
    if skin is not None:
        rows = np.concatenate([np.arange(count), edges[:, 0], indices[first]])
        skin = replace(skin, joints=skin.joints[rows], weights=skin.weights[rows])
    shapes = tuple(_finer_shape(each, count, finer) for each in mesh.shapes)
    topology = replace(
        mesh.topology, face_counts=np.full(len(quads), 4), face_indices=quads.reshape(-1)
    )
    return replace(
        mesh,
        points=finer(mesh.points),
        topology=topology,
        skin=skin,
        shapes=shapes,
    )


def _finer_shape(shape: Shape, count: int, finer: object) -> Shape:
    dense = np.zeros((len(shape.weights), count, 3))
    dense[:, shape.points] = shape.offsets
    fine = np.stack([finer(each) for each in dense])  # type: ignore[operator]
    moving = np.flatnonzero(np.abs(fine).max(axis=(0, 2)) > 0)
    return replace(shape, points=moving, offsets=fine[:, moving].astype(np.float32))
