"""Where animation has the value of a control, and what the value is there."""

from __future__ import annotations

import numpy as np

from usdrigui.character.controls import Control
from usdrigui.character.record import Floats, Record
from usdrigui.character.rig import Body
from usdrigui.character.rotation import rotation_part, rotation_vectors


class ClipReading(Record):
    """Where the value of a control is read in a clip, for films and for pages: in the weight of the
    first of `rises`, else in the rotation of a joint."""

    rises: tuple[tuple[int, float], ...]
    """Channels, and what the weight of each gains per unit of the control."""
    joint: int
    """Index into `Body.joints`, or -1."""
    turn: Floats
    """(3,) rotation vector per unit of the control."""

    def turned(self, body: Body, rotations: Floats) -> Floats:
        """(f,) how far from the base pose local rotations (f, 3, 3) of the joint are about the
        control's axis, in its own units."""
        frame = rotation_part(body.joints[self.joint].base)
        return np.asarray(
            rotation_vectors(rotations @ frame.T) @ self.turn / (self.turn @ self.turn)
        )


def reading(control: Control) -> ClipReading | None:
    """Where a control is read; None for one that a clip does not determine."""
    drive = control.drive
    per_unit = 1.0 / float(drive.values[-1] - drive.values[0])
    rises = (drive.weights[-1] - drive.weights[0]) * per_unit
    if control.kind == "blendShape" and rises[:1].any():
        pairs = zip(drive.channels.tolist(), rises.tolist(), strict=True)
        return ClipReading(tuple(pairs), -1, np.zeros(3))
    return turning(control) if len(drive.joints) == 1 else None


def turning(control: Control) -> ClipReading | None:
    """The reading of a joint's control in the first of its joints, which those of a finger follow;
    None for another control, or one that turns none."""
    if control.kind != "joint":
        return None
    drive = control.drive
    rise = drive.rotations[-1, 0] - drive.rotations[0, 0]
    turn = rise / float(drive.values[-1] - drive.values[0])
    return ClipReading((), int(drive.joints[0]), turn) if turn.any() else None
