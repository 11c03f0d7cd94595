"""In-between shapes, which Blender's USD importer leaves out, as shape keys with drivers.

The offset of a point is piecewise linear in the weight through the in-betweens.  The imported key
gives ``weight * offset``; each in-between adds a key with what it differs by, and a driver that is
1 at its weight, 0 at the others', linear between them and onwards beyond the ends, as UsdSkel is.
"""

from __future__ import annotations

import json

import numpy as np

_KNOTS = "usdrigui_inbetweens"
"""Custom property of the Key: per token, the weights and names of the keys added."""


def build(stage, character):
    """Add the in-betweens of the meshes of a character.

    Meshes that have their in-betweens already keep them.
    """
    for path, mesh in character.meshes.items():
        block = mesh.data.shape_keys
        if block is None or _KNOTS in block:
            continue
        made = {
            token: _add(mesh, key, shape)
            for token, shape in blend_shapes(stage.GetPrimAtPath(path))
            if (key := character.shape_key(path, token))
        }
        if any(made.values()):
            block[_KNOTS] = json.dumps(made)


def tokens_of(prim):
    """The blend-shape tokens of a mesh prim."""
    from pxr import UsdSkel

    return UsdSkel.BindingAPI(prim).GetBlendShapesAttr().Get() or ()


def blend_shapes(prim):
    """(token, `UsdSkel.BlendShape`) of each shape of a mesh prim."""
    from pxr import UsdSkel

    targets = UsdSkel.BindingAPI(prim).GetBlendShapeTargetsRel().GetTargets()
    for token, target in zip(tokens_of(prim), targets, strict=False):
        shape = UsdSkel.BlendShape(prim.GetStage().GetPrimAtPath(target))
        if shape:
            yield token, shape


def offsets_at(mesh, key, token, point):
    """Knots (k,) and offsets (k, 3) of one vertex under the shape key of a token and its
    in-betweens."""
    block = mesh.data.shape_keys
    here = slice(point, point + 1)
    (full,) = key_offsets(mesh, key, here)
    found = {0.0: 0.0 * full, 1.0: full}
    for weight, name in json.loads(block.get(_KNOTS, "{}")).get(token, ()):
        if name in block.key_blocks:
            (added,) = key_offsets(mesh, block.key_blocks[name], here)
            found[weight] = weight * full + added
    return tuple(map(np.array, zip(*sorted(found.items()), strict=True)))


def _add(mesh, key, shape):
    """Keys for the in-betweens of one shape: (weight, name) pairs, ascending."""
    between = {each.GetWeight(): each.GetOffsets() for each in shape.GetInbetweens()}
    weights = sorted(each for each in between if each not in (None, 0.0, 1.0) and between[each])
    knots = sorted({0.0, 1.0, *weights})
    moved = shape.GetPointIndicesAttr().Get() or slice(None)
    block = mesh.data.shape_keys
    rest, full = coordinates(block.reference_key.points), coordinates(key.points)
    names = []
    for weight in weights:
        offsets = np.zeros_like(rest)
        offsets[moved] = np.array(between[weight])
        added = mesh.shape_key_add(name=f"{key.name}@{weight:g}", from_mix=False)
        added.relative_key = block.reference_key
        added.data.foreach_set(
            "co", (rest + offsets - weight * (full - rest)).ravel().astype(np.float32)
        )
        added.slider_min, added.slider_max = -10.0, 10.0
        points = [(knot, float(knot == weight)) for knot in knots]
        drive(added, ("KEY", key.id_data), key.path_from_id("value"), points, "LINEAR")
        names.append((weight, added.name))
    return names


def drive(key, source, path, points, beyond):
    """Let the value of a shape key follow the property at ``path`` of a ``source``: (type,
    datablock).

    It goes straight from one of some ``points`` to the next, (property, value), ascending, and
    ``beyond`` them as Blender's curves do.  No Python: so it works with scripts switched off.
    """
    curve = key.driver_add("value")
    variable = curve.driver.variables.new()
    variable.name = "w"
    target = variable.targets[0]
    target.id_type, target.id = source
    target.data_path = path
    # To Blender's curves what is nearer to a point than a ten thousandth is the point.
    scale = 1000.0 / (points[-1][0] - points[0][0])
    curve.driver.expression = f"w*{scale:.9g}"
    for made in (curve.modifiers, curve.keyframe_points):  # by Blender, before and since 5.0
        while made:
            made.remove(made[0])
    for at, value in points:
        curve.keyframe_points.insert(scale * at, value).interpolation = "LINEAR"
    curve.extrapolation = beyond


def shape_keys(thing):
    """The shape keys of an object but the first, which is its rest."""
    block = getattr(thing.data, "shape_keys", None)
    return block.key_blocks[1:] if block else []


def key_offsets(mesh, key, some=slice(None)):
    """(n, 3) what a shape key adds to `some` vertices at 1: to the key that it is relative to,
    where its mask lets it."""
    offsets = (coordinates(key.points) - coordinates(key.relative_key.points))[some]
    group = mesh.vertex_groups.get(key.vertex_group)
    if group is not None:
        groups = (vertex.groups for vertex in mesh.data.vertices[some])
        weights = [{each.group: each.weight for each in mine} for mine in groups]
        offsets *= [[mine.get(group.index, 0.0)] for mine in weights]
    return offsets


def coordinates(items):
    """(n, 3) coordinates of vertices, or of the ``points`` of a shape key, which are read at once
    where its ``data`` takes a call for each."""
    flat = np.zeros(3 * len(items), dtype=np.float32)
    items.foreach_get("co", flat)
    return flat.reshape(-1, 3).astype(np.float64)
