"""What a control does to the face as a whole."""

from __future__ import annotations

import bpy
import numpy as np

from .anchors import matrix_of
from .inbetweens import coordinates

_SIDEWAYS = 0.5
"""Of all motion: a control moves the face to one side by more than that."""


def crossing(character):
    """Tells of the name of a control whether it moves all points of the character to one side; the
    scene is then as it was."""
    path, mesh = next(iter(character.meshes.items()))
    to_world = matrix_of(mesh.matrix_world) @ np.linalg.inv(character.layout.to_root(path))
    normal = to_world[:3, :3] @ character.layout.normal
    normal = normal / max(float(np.linalg.norm(normal)), 1e-30)

    def points():
        depsgraph = bpy.context.evaluated_depsgraph_get()
        shown = (each.evaluated_get(depsgraph) for each in character.meshes.values())
        return np.concatenate([_world_points(each) for each in shown])

    def crosses(name):
        control, before = character.controls[name], character.values()[name]
        found = []
        for value in (control.base, control.minimum, control.maximum, before):
            character.set_values({name: value})
            found.append(points())
        moves = np.array(found[1:3]) - found[0]
        ways = np.linalg.norm(moves, axis=2).sum(axis=1)
        return bool((np.abs((moves @ normal).sum(axis=1)) > _SIDEWAYS * ways).any())

    return crosses


def _world_points(mesh):
    world = matrix_of(mesh.matrix_world)
    return coordinates(mesh.data.vertices) @ world[:3, :3].T + world[:3, 3]
