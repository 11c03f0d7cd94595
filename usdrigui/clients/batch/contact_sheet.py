"""All layouts of a batch on one page, refusals included."""

from __future__ import annotations

import io
import textwrap
from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw

from usdrigui.clients.batch.job import Row
from usdrigui.isolation.foreign_file import whole_content
from usdrigui.view.flat.lettering import font
from usdrigui.view.flat.pillow import png
from usdrigui.view.picture import contact_sheet

_EMPTY = (900, 300)
_PAPER, _INK = (240, 236, 234), (150, 50, 40)


def sheet_png(rows: Sequence[Row]) -> bytes:
    """PNG bytes: the picture of each asset over its name, or why there is none."""
    rows = [row for row in rows if row.outcome != "part"]
    images = [_picture(row) for row in rows]
    return png(
        contact_sheet(
            images,
            [f"{row.asset}   {row.outcome}" for row in rows],
            columns=3 if len(rows) > 4 else 2,
        )
    )


def _picture(row: Row) -> Image.Image:
    if row.sound and row.picture and Path(row.picture).is_file():
        with Image.open(io.BytesIO(whole_content(row.picture, 64))) as picture:
            return picture.convert("RGB")
    page = Image.new("RGB", _EMPTY, _PAPER)
    text = "\n".join([row.code or "no picture", *textwrap.wrap(row.message, 70)[:5]])
    ImageDraw.Draw(page).multiline_text((30, 30), text, fill=_INK, font=font(24), spacing=10)
    return page
