"""What carries an element, and which controls it ignores.

Decided once, as a record.  `usdrigui.pose` and the page evaluate it; the layer's gprims have it as
influences and blend shapes, as far as UsdSkel can express it (docs/decisions/151).
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from usdrigui.model import Control, Indices, Record


@dataclass(frozen=True, eq=False)
class Following(Record):
    """How one element goes with the character."""

    held: Indices
    """Controls, as indices into `Rig.controls`, that its tracks ignore: these go as if each was in
    the base pose."""
    deforms: bool
    """Whether it goes with the skin at its anchor, and its handle with all of it.  What does not
    follows joints alone, and its handle slides along its tracks."""
    joint: int
    """Index into `Body.joints` of the one that alone carries it, or -1: those of its anchor do."""


def following(
    own: Indices, board: Indices, carrier: int, *, on_board: bool, static: bool
) -> Following:
    """How an element with the controls `own` goes with the character.

    `board` are `board_controls`, `carrier` is the joint that carries the face.
    """
    held = board if on_board else own
    return Following(held, not on_board and not static, carrier if static else -1)


def board_controls(controls: Sequence[Control], on_board: Iterable[Indices]) -> Indices:
    """Those of the controls of the elements `on_board` that drive joints: they leave all of the
    board where it is, so that it stays in one piece."""
    found = sorted({control for own in on_board for control in own.tolist()})
    return np.array([each for each in found if len(controls[each].drive.joints)], dtype=np.int64)
