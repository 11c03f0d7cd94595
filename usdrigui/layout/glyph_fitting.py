"""Custom handles: the glyphs that the configuration names, fitted to their elements."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from usdrigui.character import Glyph
from usdrigui.layout.face import Face
from usdrigui.layout.motion.tracks import lengths
from usdrigui.layout.symmetry.front import seen_from
from usdrigui.model import Anchor, Member
from usdrigui.settings import ControlSettings


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
    glyph = face.rig.glyphs[override.glyph]
    width = override.glyph_size * face.handle_width
    if width == 0.0:
        width = max(float(lengths(member.track)) for member in members)
    points = glyph.points * [-1.0 if reflected else 1.0, 1.0, 1.0]
    toward = face.views.directions[0]
    out = anchor.normal if anchor.normal.any() else toward
    placed = 0.5 * width * points @ seen_from(out, face.rig.up, toward)
    # A mirror image is seen from the same side.
    turned = reflected and glyph.form == "mesh"
    return replace(glyph, points=placed, indices=glyph.turned_round if turned else glyph.indices)
