"""Visibility shapes: controls that make parts disappear."""

import chain
import makers
import numpy as np
from makers import POINTS, QUADS, SHAPES


def test_parts_that_vanish_are_global():
    hair = np.array([[0.9, 1.0, 0.3], [1.2, 1.0, 0.3], [1.2, 1.3, 0.3], [0.9, 1.3, 0.3]])
    points, quads = np.vstack([POINTS, hair]), [*QUADS, [len(POINTS) + i for i in range(4)]]
    still = {name: np.vstack([each, np.zeros((4, 3))]) for name, each in SHAPES.items()}

    def hides(offsets):
        shapes = {**still, "hide": np.vstack([np.zeros_like(POINTS), offsets])}
        return chain.chosen(makers.rig(points, quads, shapes))("hide")

    collapsed, swung = hides(hair.mean(axis=0) - hair), hides(np.tile([0.0, 0.4, 0.0], (4, 1)))
    assert collapsed.category == "global"
    assert "disappear" in collapsed.off_face_reason
    assert swung.category != "global"
    pinched = np.where(np.arange(4)[:, None] < 2, hair[:2].mean(axis=0) - hair, 0.0)
    assert hides(pinched).category != "global", "half of it stays"
