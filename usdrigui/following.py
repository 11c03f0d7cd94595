"""What carries an element, and which controls it ignores.

Decided once, as a record.  `usdrigui.pose` and the page evaluate it; the layer's gprims have it as
influences and blend shapes, as far as UsdSkel can express it (docs/decisions/151).
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import compress

import numpy as np

from usdrigui.character import Flags, Indices, Record, Rig
from usdrigui.character.skinning import carrying_joint


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


class Shared(Record):
    """What all elements of a layout have in common in how they go with the character."""

    board: Indices
    """Those of the controls of the elements on the board that drive joints: they leave all of the
    board where it is, so that it stays in one piece."""
    carrier: int
    """Index into `Body.joints` of the joint that carries the face, by the anchors on it; -1 where
    there is none."""


def shared(rig: Rig, owned: Sequence[Indices], points: Indices, on_board: Flags) -> Shared:
    """The same for elements with the controls `owned`, anchored at `points` (elements,) of the rig;
    `on_board` (elements,)."""
    found = sorted({each for own in compress(owned, on_board) for each in own.tolist()})
    board = [each for each in found if len(rig.controls[each].drive.joints)]
    return Shared(np.array(board, dtype=np.int64), carrying_joint(rig.body, points[~on_board]))


def following(own: Indices, all_of: Shared, *, on_board: bool, static: bool) -> Following:
    """How an element with the controls `own` goes with the character."""
    held = all_of.board if on_board else own
    return Following(held, not on_board and not static, all_of.carrier if static else -1)
