"""Picture files: one page a character, together on a contact sheet, or a short animation."""

from __future__ import annotations

import io
from collections.abc import Mapping, Sequence

import numpy as np
from PIL import Image

from usdrigui.character import Rig
from usdrigui.character.palette import SIDES
from usdrigui.errors import visible
from usdrigui.model import Layout
from usdrigui.pose.evaluate import values_of
from usdrigui.view.clip import clip_values
from usdrigui.view.flat import lettering
from usdrigui.view.flat.pillow import png
from usdrigui.view.picture import Wanted, contact_sheet, film, render

_FRAME = 80
"""Milliseconds that a frame of an animation is shown."""


def sheet_png(
    characters: Sequence[tuple[Rig, Layout]],
    *,
    labels: bool = False,
    pose: Mapping[str, float] | None = None,
) -> bytes:
    """PNG bytes of all `characters`, the same for the same input.

    `pose` holds values by the name of the control, the others at the base pose; of several
    characters each takes those of its own controls.  Raises POSE_CONTROL for a name that none of
    them has, POSE_VALUE.
    """
    pose, known = pose or {}, {name for rig, _ in characters for name in rig.control_names}
    images = []
    for rig, layout in characters:
        own = {
            name: value
            for name, value in pose.items()
            if name in rig.control_names or name not in known
        }
        values = values_of(rig, own, layout.base_values) if own else None
        images.append(render(rig, layout, values, Wanted(labels=labels)))
    # Each names its character itself.
    return png(images[0] if len(images) == 1 else contact_sheet(images))


def spelt_out(characters: Sequence[tuple[Rig, Layout]]) -> tuple[str, ...]:
    """A sentence where names of Han, kana or hangul are spelt as they sound in pictures of the
    characters, for want of the extra ``fonts``; else none."""
    labels = [element.label for _, layout in characters for element in layout.elements]
    found = lettering.spelt_out(labels)
    if not found:
        return ()
    names = " and ".join([visible(found[0]), *(["other names"] if len(found) > 1 else [])])
    return (
        f"pip install weblate-fonts draws the letters of {names}; without it they are"
        " transliterated or shown as code points",
    )


def film_gif(characters: Sequence[tuple[Rig, Layout]], *, frames: int) -> bytes:
    """GIF bytes of the first character playing its clip under its layout; `frames` pictures,
    looped.

    Raises RigUIError ANIMATION_MISSING.
    """
    rig, layout = characters[0]
    values = clip_values(rig)
    steps = np.unique(np.linspace(0, len(values) - 1, frames).round().astype(int))
    pictures = list(film(rig, layout, values[steps]))
    palette = _palette(pictures)
    reduced = [picture.quantize(palette=palette, dither=Image.Dither.NONE) for picture in pictures]
    buffer = io.BytesIO()
    reduced[0].save(
        buffer, format="GIF", save_all=True, append_images=reduced[1:], duration=_FRAME, loop=0
    )
    return buffer.getvalue()


def _palette(pictures: Sequence[Image.Image]) -> Image.Image:
    """256 colours for all frames: most of them the pictures' own, the rest kept for the small
    marks."""
    marks = [
        tuple(round(part * shade) for part in colour)
        for colour in SIDES.values()
        for shade in (0.6, 0.8, 1.0)
    ]
    pair = Image.new("RGB", (pictures[0].width * 2, pictures[0].height))
    pair.paste(pictures[0], (0, 0))
    pair.paste(pictures[len(pictures) // 2], (pictures[0].width, 0))
    common = pair.quantize(colors=256 - len(marks)).getpalette() or []
    palette = Image.new("P", (1, 1))
    palette.putpalette(
        [*common[: 3 * (256 - len(marks))], *(part for mark in marks for part in mark)]
    )
    return palette
