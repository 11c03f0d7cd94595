"""Controls of pairs that have places of their own: they cannot be one decision."""

from __future__ import annotations

import numpy as np

from usdrigui.layout.face import Face
from usdrigui.layout.reuse.partial_layout import MIRROR, fixed_anchor
from usdrigui.layout.reuse.requests import Requests
from usdrigui.model import ONE_PLACE
from usdrigui.settings import ControlSettings


def has_own_place(face: Face, requests: Requests, control: int) -> bool:
    """Whether a control of a pair has a place that is not the mirror image of its twin's, so that
    the two cannot be one decision: a fixed anchor, or an earlier place that was moved on one side
    only."""
    symmetry, overrides, prior = face.symmetry, requests.overrides, requests.prior
    twin = int(symmetry.twins[control])
    if twin >= 0 and _region(overrides[control]) != _region(overrides[twin]):
        return True
    if any(group.doubled and {control, twin} <= set(group.controls) for group in prior.groups):
        return False  # Both sides of one element have both controls.
    if overrides[control].anchor:
        return not _fixed_in_mirror(face, requests, control)
    mine, other = prior.places.get(control), prior.places.get(twin)
    if mine is None or other is None or prior.cutoff_distance > 0.0:
        return False
    if mine.on_board or other.on_board:
        return mine.on_board != other.on_board
    apart = np.linalg.norm(symmetry.plane.reflected(mine.position) - other.position)
    return bool(apart > ONE_PLACE * face.handle_width)


def _region(override: ControlSettings) -> tuple[str, str, float]:
    """The configured place of a control, apart from a fixed anchor."""
    return override.place, override.near.removeprefix(MIRROR), override.within


def _fixed_in_mirror(face: Face, requests: Requests, control: int) -> bool:
    """Whether both twins are fixed, and the right one exactly at the mirror partner of the left
    one."""
    rig, symmetry, overrides = face.rig, face.symmetry, requests.overrides
    twin = int(symmetry.twins[control])
    if twin < 0 or not overrides[twin].anchor:
        return False
    pair = [fixed_anchor(rig, rig.control_names[c], overrides[c].anchor) for c in (control, twin)]
    apart = symmetry.apart[pair]
    left, right = pair if apart[0] >= apart[1] else pair[::-1]
    return bool(symmetry.partner[left] == right)
