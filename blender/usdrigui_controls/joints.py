"""Joint moves as UsdSkel and the layer say them, and as a bone's own loc, rot, scale; numpy only.

A bone's basis is relative to its bind pose, a control's drive to the base pose; both in the joint's
own axes.  Matrices are 4x4 for column vectors.
"""

from __future__ import annotations

import numpy as np

from .maths.rotation import rotation_part, rotation_vectors, rotations


class JointFrame:
    """One joint between its bind pose and its rest pose."""

    def __init__(self, bind, rest, unit=1.0):
        """``bind`` and ``rest`` are local transforms in USD's row-vector convention; ``unit`` is
        the scale of the parent in the bind pose, where bones have none."""
        both = np.array([bind, rest])
        turns = rotation_part(both)
        self.size, stretch = np.diagonal(both[:, :3, :3] @ turns.swapaxes(1, 2), axis1=1, axis2=2)
        self.unit, self.stretch = unit, stretch / self.size
        self.turn = turns[0].T
        self.lead = turns[0] @ turns[1].T
        self.offset = both[1, 3, :3] - both[0, 3, :3]

    def basis(self, move):
        """A bone's (location, (3, 3) rotation, scale) for a ``move``: (rotation vector,
        translation, log scale)."""
        rotation, translation, scale = np.array(move, dtype=np.float64)
        location = self.unit * self.turn.T @ (self.offset + translation)
        return location, self.lead @ rotations(rotation).T, self.stretch * np.exp(scale)

    def move(self, location, rotation, scale):
        """The inverse of `basis`: (3, 3), the rows rotation vector, translation and log scale."""
        turned = rotation_vectors((self.lead.T @ rotation).T)
        scales = np.log(np.maximum(np.abs(np.asarray(scale) / self.stretch), 1e-12))
        return np.array(
            [turned, self.turn @ np.asarray(location) / self.unit - self.offset, scales]
        )


def beside_parents(matrices, parents):
    """(j, 4, 4) transforms of joints, for row vectors, as their parents see them; ``parents`` (j,)
    with -1 for none."""
    placed = np.array([*matrices, np.eye(4)])
    return placed[:-1] @ np.linalg.inv(placed)[list(parents)]
