"""What a control does to the face as a whole."""

from __future__ import annotations

import bpy
import numpy as np

from .anchors import Spot

_SIDEWAYS = 0.5


class Places:
    """The vertices that are shown of some, and where the controls of some names take them."""

    def __init__(self, character, anchors, places, names):
        """``places`` are (mesh path, vertex)."""
        depsgraph = bpy.context.evaluated_depsgraph_get()
        self.values, self.posed = character.values(), anchors.posed()
        spots = (Spot(character, anchors.bones, *each, names) for each in places)
        seen = ((spot, spot.shown(depsgraph)) for spot in spots)
        self.seen = [
            (spot, point, spot.skin(self.posed, self.values, {}))
            for spot, point in seen
            if point is not None
        ]

    def at(self, to):
        """(p, 3) in the world, with controls at the values of ``to`` by name, others as they
        are."""
        return np.array(
            [spot.carried(self.posed, at, self.values, to, now)[0] for spot, at, now in self.seen]
        ).reshape(-1, 3)


def crossing(character, anchors):
    """Tells of the name of a control whether it moves the anchors of all elements to one side."""
    layout = character.layout
    on_skin = [(each.mesh, each.point) for each in layout.elements if each.follows]
    places = Places(character, anchors, on_skin, character.controls)
    path, mesh = next(iter(character.meshes.items()))
    turn = np.array(mesh.matrix_world) @ np.linalg.inv(layout.to_root(path))
    normal = turn[:3, :3] @ layout.normal

    def crosses(name):
        control = character.controls[name]
        ends = control.base, control.minimum, control.maximum
        base, *others = (places.at({name: value}) for value in ends)
        moves = np.array(others) - base
        ways = np.linalg.norm(moves, axis=2).sum(axis=1)
        return bool((np.abs((moves @ normal).sum(axis=1)) > _SIDEWAYS * ways).any())

    return crosses
