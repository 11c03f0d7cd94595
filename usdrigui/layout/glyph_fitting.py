"""Custom handles: the glyphs that the configuration names, fitted to their elements."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from usdrigui.character import Floats, Glyph, Indices
from usdrigui.layout.face import Face
from usdrigui.layout.motion.tracks import lengths
from usdrigui.model import Anchor, Member
from usdrigui.settings import ControlSettings
from usdrigui.ties import axis_across

_LEVEL = 1e-3
"""Sine below which a normal points straight up or down."""


def fitted_glyph(
    face: Face,
    overrides: Sequence[ControlSettings],
    anchor: Anchor,
    members: Sequence[Member],
    reflected: bool,
) -> Glyph | None:
    """The glyph of an element: that of the first of its controls' `overrides` that names one; None
    where none does.

    Its up axis is the anchor's normal, its Y axis as upright as the surface allows, and the sphere
    around it is `glyph_size` handle widths wide, or as wide as the longest track is long.
    `reflected` swaps left and right, so that the elements of a pair are mirror images.
    """
    override = next((each for each in overrides if each.glyph), None)
    if override is None:
        return None
    glyph = face.rig.configured.glyphs[override.glyph]
    width = override.glyph_size * face.handle_width
    if width == 0.0:
        width = max(float(lengths(member.track[None])[0]) for member in members)
    points = glyph.points * [-1.0 if reflected else 1.0, 1.0, 1.0]
    toward = face.views.directions[0]
    frame = _frame(anchor.normal if anchor.normal.any() else toward, face.rig.skel_root.up, toward)
    placed = 0.5 * width * points @ frame
    turned = reflected and glyph.form == "mesh"
    return replace(glyph, points=placed, indices=_reversed(glyph) if turned else glyph.indices)


def _frame(normal: Floats, up: Floats, toward: Floats) -> Floats:
    """(3, 3) rows: right, up and out of an element that faces along `normal`.

    Where that is straight up or down, the side away from the viewer is up, as on a table.
    """
    upright = up - (up @ normal) * normal
    if np.linalg.norm(upright) < _LEVEL:
        away = -np.sign(up @ normal) * toward
        upright = away - (away @ normal) * normal
    if np.linalg.norm(upright) < _LEVEL:
        upright = np.cross(normal, axis_across(normal))
    upright = upright / np.linalg.norm(upright)
    return np.stack([np.cross(upright, normal), upright, normal])


def _reversed(glyph: Glyph) -> Indices:
    """Corners of its faces in the opposite order: a mirror image is seen from the same side."""
    faces = np.split(glyph.indices, np.cumsum(glyph.counts)[:-1])
    return np.concatenate([face[::-1] for face in faces])
