"""What a control does to the face as a whole."""

from __future__ import annotations

import bpy
import numpy as np

from .inbetweens import coordinates

_SIDEWAYS = 0.5
"""Of all motion: a control moves the face to one side by more than that."""


def crossing(character):
    """Tells of the name of a control whether it moves all points of the character to one side; the
    scene is then as it was."""
    path, mesh = next(iter(character.meshes.items()))
    to_root = character.layout.to_root(path) @ np.linalg.inv(np.array(mesh.matrix_world))

    def points(name, value):
        character.set_values({name: value})
        depsgraph = bpy.context.evaluated_depsgraph_get()
        shown = (each.evaluated_get(depsgraph) for each in character.meshes.values())
        return np.concatenate([_world_points(each) for each in shown])

    def crosses(name):
        control, before = character.controls[name], character.values()[name]
        ends = (control.base, control.minimum, control.maximum, before)
        base, *found, _ = [points(name, value) for value in ends]
        moves = (np.array(found) - base) @ to_root[:3, :3].T
        ways = np.linalg.norm(moves, axis=2).sum(axis=1)
        aside = np.abs((moves @ character.layout.normal).sum(axis=1))
        return bool((aside > _SIDEWAYS * ways).any())

    return crosses


def _world_points(mesh):
    world = np.array(mesh.matrix_world)
    return coordinates(mesh.data.vertices) @ world[:3, :3].T + world[:3, 3]
