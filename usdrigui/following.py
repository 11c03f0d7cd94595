"""What carries an element, and which controls it ignores.

Decided once, as a record.  `usdrigui.pose` and the page evaluate it; the layer's gprims have it as
influences and blend shapes, as far as UsdSkel can express it (docs/decisions/151).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.character import Indices, Record, Rig
from usdrigui.character.skinning import carrying_joint
from usdrigui.model import Element


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


def shared(rig: Rig, elements: Sequence[Element]) -> Shared:
    """The same for the elements of a layout that fits the rig."""
    found, points = set[int](), list[int]()
    for element in elements:
        if element.anchor.on_board:
            found.update(controls_of(rig, element).tolist())
        else:
            points.append(element.anchor.on(rig.body))
    board = [each for each in sorted(found) if len(rig.controls[each].drive.joints)]
    carrier = carrying_joint(rig.body, np.array(points, dtype=np.int64))
    return Shared(np.array(board, dtype=np.int64), carrier)


def following(rig: Rig, element: Element, all_of: Shared) -> Following:
    """How one element goes with the character."""
    on_board, static = element.anchor.on_board, element.adapt == "static"
    held = all_of.board if on_board else controls_of(rig, element)
    return Following(held, not on_board and not static, all_of.carrier if static else -1)


def controls_of(rig: Rig, element: Element) -> Indices:
    """The controls of an element, as indices into `Rig.controls`, in the order of its members."""
    places = rig.control_indices
    return np.array([places[each.control] for each in element.members], dtype=np.int64)
