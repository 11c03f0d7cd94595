"""The picture file of one run: one page a character, together on a contact sheet."""

from __future__ import annotations

import io
from collections.abc import Sequence

from usdrigui.model import Layout, Rig
from usdrigui.view.picture import contact_sheet, render


def sheet_png(characters: Sequence[tuple[Rig, Layout]], *, labels: bool = False) -> bytes:
    """PNG bytes of all `characters`, the same for the same input."""
    images = [render(rig, layout, labels=labels) for rig, layout in characters]
    page = images[0] if len(images) == 1 else contact_sheet(images, [rig.root for rig, _ in characters])
    buffer = io.BytesIO()
    page.save(buffer, format="PNG")
    return buffer.getvalue()
