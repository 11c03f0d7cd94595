"""Small rigs made of plain arrays, for tests that need no USD.

`rig` turns points, faces and offsets into a `Rig`; `face` is a smooth, mirror-symmetric mask of a face
with named bumps, whose correct layout is known by construction.
"""

from dataclasses import fields, is_dataclass, replace
from types import MappingProxyType

import numpy as np

from usdrigui.character import (
    Body,
    Channel,
    Control,
    Drive,
    Rig,
    RigMesh,
    Shape,
    Skin,
    Topology,
)
from usdrigui.character.record import freeze
from usdrigui.model import Anchor, Layout, LayoutFrame, Member, MirrorPlane, Proof

Y_UP = np.array([0.0, 1.0, 0.0])


def drive(channels=(), values=(0.0, 1.0), weights=None, joints=(), turns=()):
    """A drive that raises one channel linearly, or as `weights` (keys, channels) say, and turns joints by the rotation
    vectors `turns` (keys, joints, 3)."""
    keys = np.asarray(values, dtype=np.float64)
    table = (
        np.repeat(keys[:, None], len(channels), axis=1) if weights is None else np.asarray(weights, dtype=np.float64)
    )
    moves = np.zeros((len(keys), 3, len(joints), 3))
    moves[:, 0] = np.reshape(turns, moves[:, 0].shape)
    return Drive(keys, np.asarray(channels, dtype=np.int64), table, np.asarray(joints, dtype=np.int64), moves)


def shape(channel, offsets, weights=(1.0,), path="/Root/mesh/shape"):
    """A shape from dense offsets (n, 3), or one (n, 3) per in-between weight."""
    stack = np.asarray(offsets, dtype=np.float32).reshape(len(weights), -1, 3)
    moved = np.flatnonzero(np.any(stack != 0.0, axis=(0, 2)))
    return Shape(channel, path, np.asarray(weights, dtype=np.float64), moved, stack[:, moved])


def mesh(points, faces, shapes=(), path="/Root/mesh", left_handed=False, visible=True, skin=None):
    """A mesh in root space; `faces` is a list of point-index lists."""
    return RigMesh(
        path=path,
        points=np.array(points, dtype=np.float64),
        topology=Topology(
            np.array([*map(len, faces)], dtype=np.int64),
            np.array([point for face in faces for point in face], dtype=np.int64),
            left_handed,
            f"{len(points)}-{len(faces)}",
        ),
        to_root=np.eye(4),
        skin=skin,
        shapes=tuple(shapes),
        visible=visible,
    )


def control(name, channel, minimum=0.0, maximum=1.0, default=0.0):
    """A blend-shape control whose value is the weight."""
    return Control(
        name,
        name,
        "blendShape",
        name,
        minimum,
        default,
        maximum,
        "default",
        drive((channel,), (default, default + 1.0), [[0.0], [1.0]]),
    )


def rig(points, faces, shapes, ranges=None, up=Y_UP):
    """A one-mesh rig; `shapes` maps names to dense offsets (n, 3) or to {weight: offsets}."""
    made = []
    for channel, offsets in enumerate(shapes.values()):
        if isinstance(offsets, dict):
            weights = sorted(offsets)
            made.append(shape(channel, np.stack([offsets[weight] for weight in weights]), weights))
        else:
            made.append(shape(channel, offsets))
    return rig_of_meshes([mesh(points, faces, made)], list(shapes), ranges, up)


def rig_of_meshes(meshes, names, ranges=None, up=Y_UP):
    """A rig of several meshes whose shapes' channels index `names`."""
    ranges = ranges or {}
    return Rig(
        path="/Root",
        up=np.asarray(up, dtype=np.float64),
        metres_per_unit=1.0,
        body=Body(
            meshes=tuple(meshes),
            skeletons=(),
            joints=(),
            channels=tuple(Channel(name, "/Root/anim", index) for index, name in enumerate(names)),
            base_weights=np.zeros(len(names)),
        ),
        controls=tuple(control(name, index, *ranges.get(name, (0.0, 1.0))) for index, name in enumerate(names)),
    )


def changed(record, **new):
    """A copy of a rig or mesh with other values of fields: its own or those of the records that it holds."""
    own = {each.name for each in fields(record)}
    for name in sorted(own):
        held = getattr(record, name)
        inner = new.keys() & {each.name for each in fields(held)} - own if is_dataclass(held) else ()
        if inner:
            new[name] = replace(held, **{each: new.pop(each) for each in inner})
    return replace(record, **new)


def mask(columns=33, rows=41, height=2.0):
    """A smooth mask facing +z, 1.6 wide and 2 high at scale 1, mirror-symmetric about x = 0.

    Returns points (rows * columns, 3) and quads, counter-clockwise from +z.  With an odd number of
    columns the middle column lies on the plane.
    """
    x, y = np.meshgrid(np.linspace(-0.8, 0.8, columns), np.linspace(-1.0, 1.0, rows))
    x[:, : columns // 2] = -x[:, : -(columns // 2) - 1 : -1]
    z = 0.7 * np.sqrt(np.maximum(0.0, 1.0 - (x / 0.95) ** 2 - (y / 1.25) ** 2))
    points = np.stack([x, y, z], axis=-1).reshape(-1, 3) * (height / 2.0)
    return points, quads(rows, columns)


def quads(rows, columns):
    """Of a grid of points."""
    index = np.arange(rows * columns).reshape(rows, columns)
    return np.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], axis=-1).reshape(-1, 4).tolist()


def bump(points, centre, direction, radius=0.25, amount=0.1):
    """Offsets (n, 3): a smooth bump of compact support around `centre` (x, y of the mask)."""
    apart = np.linalg.norm(points[:, :2] - np.asarray(centre, dtype=np.float64), axis=1) / radius
    fall = np.where(apart < 1.0, (1.0 - apart**2) ** 2, 0.0)
    unit = np.asarray(direction, dtype=np.float64)
    return amount * fall[:, None] * (unit / np.linalg.norm(unit))


LEFT_BUMPS = {
    "brow": ((0.35, 0.55), (0.1, 1.0, 0.2), 0.3, 0.10),
    "blink": ((0.35, 0.3), (0.0, -1.0, 0.2), 0.18, 0.08),
    "smile": ((0.3, -0.45), (0.6, 0.6, -0.1), 0.3, 0.12),
    "sneer": ((0.15, 0.0), (0.2, 1.0, 0.1), 0.2, 0.06),
}
MIDDLE_BUMPS = {
    "pucker": ((0.0, -0.45), (0.0, 0.0, 1.0), 0.3, 0.1),
    "chin": ((0.0, -0.8), (0.0, 1.0, 0.3), 0.3, 0.07),
}


def face_shapes(points, scale=1.0):
    """Offsets by name: four left/right pairs, two self-symmetric bumps, and an opposed jaw axis."""
    flat = points / scale
    shapes = {}
    for name, (centre, direction, radius, amount) in LEFT_BUMPS.items():
        for side, sign in (("L", 1.0), ("R", -1.0)):
            mirrored = (centre[0] * sign, centre[1]), (direction[0] * sign, *direction[1:])
            shapes[f"{name}_{side}"] = bump(flat, *mirrored, radius, amount) * scale
    for name, (centre, direction, radius, amount) in MIDDLE_BUMPS.items():
        shapes[name] = bump(flat, centre, direction, radius, amount) * scale
    for name, sign in (("jawLeft", 1.0), ("jawRight", -1.0)):
        shapes[name] = bump(flat, (0.0, -0.7), (sign, 0.0, 0.0), 0.45, 0.15) * scale
    return shapes


def face(columns=33, rows=41, height=2.0, ranges=None, up=Y_UP):
    """The mask with `face_shapes`: 12 controls."""
    points, quads = mask(columns, rows, height)
    return rig(points, quads, face_shapes(points, height / 2.0), ranges, up)


POINTS, QUADS = mask()
SHAPES = MappingProxyType(face_shapes(POINTS))
freeze((POINTS, *SHAPES.values()))
TEETH = np.array([[-0.3, -0.6, 0.2], [0.3, -0.6, 0.2], [0.3, -0.3, 0.2], [-0.3, -0.3, 0.2]])
"""(4, 3) a plate behind the skin of the face."""


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
    shapes = {f"arm{k}": bump(points, (0.6 * np.cos(a), 0.6 * np.sin(a)), (0, 0, 1), 0.3) for k, a in enumerate(turns)}
    return rig(points, faces, shapes)


def face_with(**more):
    """The face with further shapes, by name."""
    return rig(POINTS, QUADS, {**SHAPES, **more})


def face_with_teeth(skin_moves=0.0, visible=True, name="teeth", at=TEETH):
    """The face with teeth `at` (4, 3), and a control `name` that moves them, and the skin by `skin_moves`."""
    points, faces = mask()
    shapes = face_shapes(points)
    last = len(shapes)
    skin_shapes = [shape(i, offsets) for i, offsets in enumerate(shapes.values())]
    skin_shapes.append(shape(last, skin_moves * shapes["pucker"]))
    moved_teeth = [shape(last, np.full((4, 3), 0.1))]
    teeth = mesh(at, [[0, 1, 2, 3]], moved_teeth, path="/Root/teeth", visible=visible)
    return rig_of_meshes([mesh(points, faces, skin_shapes), teeth], [*shapes, name])


def rotation(seed):
    turn = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]
    return turn * np.sign(np.linalg.det(turn))


def moved(made, matrix, offset=(0.0, 0.0, 0.0)):
    """A copy of a skinless one-mesh rig under a linear map and an offset (winding flips with a mirror)."""
    linear = np.asarray(matrix, dtype=np.float64)
    turned = []
    for each in made.body.meshes:
        shapes = tuple(
            replace(one, offsets=(one.offsets.astype(np.float64) @ linear.T).astype(np.float32)) for one in each.shapes
        )
        turned.append(
            changed(
                each,
                points=each.points @ linear.T + np.asarray(offset),
                shapes=shapes,
                left_handed=each.topology.left_handed ^ bool(np.linalg.det(linear) < 0.0),
            )
        )
    up = linear @ made.up
    return changed(made, meshes=tuple(turned), up=up / np.linalg.norm(up))


def shuffled(made, order):
    """A copy of a one-mesh rig whose new point k is the old point ``order[k]``."""
    order = np.asarray(order)
    place = np.empty(len(order), dtype=np.int64)
    place[order] = np.arange(len(order))
    old = made.body.meshes[0]
    shapes = []
    for one in old.shapes:
        where = place[one.points]
        rank = np.argsort(where)
        shapes.append(replace(one, points=where[rank], offsets=one.offsets[:, rank].copy()))
    new = changed(old, points=old.points[order], face_indices=place[old.topology.face_indices], shapes=tuple(shapes))
    return changed(made, meshes=(new,))


def skin(count, joint=0):
    """Rigid influences of one joint."""
    return Skin(np.full((count, 1), joint), np.ones((count, 1)), "classicLinear", np.eye(4), True)


def anchor(rig, point, position, normal=(0.0, 0.0, 1.0), on_board=False):
    """Of an element at a `position` that holds on to a point of a rig."""
    held, local = rig.body.mesh_of(point)
    place, out = np.asarray(position), np.array(normal)
    return Anchor(held.path, local, len(held.points), held.topology.hash, place, out, on_board)


def member(control, values, origin, point, points, offsets):
    """A control whose track goes from `origin` as one of the `points` that it moves by `offsets`, if it does."""
    row = np.flatnonzero(points == point)
    track = origin + (offsets[:, row[0]].astype(np.float64) if len(row) else np.zeros((len(values), 3)))
    return Member(control.name, values, track, float(np.linalg.norm(np.diff(track, axis=0), axis=1).sum()), 1.0)


def layout(rig, *elements, base_values=None, drawn=None):
    """A layout of the elements, in the frame `drawn`: by default one in which a handle is a tenth of a unit wide."""
    return Layout(
        root=rig.path,
        base_values=np.zeros(len(rig.controls)) if base_values is None else base_values,
        elements=elements,
        left_off=(),
        frame=drawn or frame(0.1),
        proof=Proof(method="", status="stopped", cost=0.0, bound=-np.inf, above_unary_bound=0.0),
    )


def frame(width, view=(0.0, 0.0, 1.0), normal=(0.0, 0.0, 0.0)):
    """Of handles of a width, seen from `view`, with the mirror plane through the origin that has the `normal`."""
    plane = MirrorPlane(origin=np.zeros(3), normal=np.array(normal))
    return LayoutFrame(space="object", view=np.asarray(view, dtype=np.float64), plane=plane, handle_width=width)
