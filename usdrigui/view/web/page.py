"""The web viewer: characters and their layouts as one self-contained HTML file.

The file needs no network and no server: script, style, geometry and layout are inside it, and its
content security policy forbids everything else.  The script is built from `viewer/` (see its
README).
"""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path

from usdrigui.character import Rig
from usdrigui.errors import refuse
from usdrigui.isolation.foreign_file import whole_content
from usdrigui.model import Layout
from usdrigui.report.markup import markup
from usdrigui.view.web.packing import pack

_SAVED = re.compile(r"#usda.*string (note|pose) = ", re.DOTALL)
"""Every review (docs/decisions/142) and every shelf of poses (docs/decisions/141) that a page
saves."""

_PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="usdrigui">
<title>{title}</title>
<style>{style}</style>
</head>
<body{flags}>
<div id="app"><p class="loading">Loading {title}…</p></div>
<noscript>This page needs JavaScript.</noscript>
<script type="text/plain" id="scene">{scene}</script>{reviews}
<script>{script}</script>
</body>
</html>
"""


def page_html(
    rig_layouts: Sequence[tuple[Rig, Layout]],
    title: str,
    study: bool = False,
    live: str = "",
    reviews: Sequence[str] = (),
) -> str:
    """One HTML file in which the characters can be posed by their layouts.

    The same records and title always give the same text.  With ``study`` the page offers the
    evaluation of the paper's section 5 as well (docs/decisions/073); with the name of a file
    ``live`` it keeps its animation there, by way of the server that it comes from
    (docs/decisions/079).  `reviews` are layers whose notes it opens (docs/decisions/142), and
    shelves whose poses the evaluation has as targets.  Raises RigUIError as `pack`, and
    VIEW_MISMATCH when there is no character at all.
    """
    if not rig_layouts:
        raise refuse("VIEW_MISMATCH", "", "there is no character with a layout to show")
    script, style = _asset("viewer.js"), _asset("viewer.css")
    return _PAGE.format(
        policy=_policy(script, style, live),
        title=markup(title),
        style=style,
        flags=(" data-study" if study else "") + (f' data-live="{markup(live)}"' if live else ""),
        scene=base64.b64encode(pack(rig_layouts, title, 0.75 * len(script))).decode("ascii"),
        script=script,
        reviews=_reviews(reviews),
    )


def read_review(path: Path) -> str:
    """The text of a review, or of a shelf of poses.  Raises RigUIError REVIEW_LAYER for a file that
    is none, or over 16 MB."""
    try:
        text = whole_content(path).decode()
    except (OSError, UnicodeDecodeError) as error:
        raise refuse("REVIEW_LAYER", path, f"cannot be read as text: {error}") from error
    if not _SAVED.match(text):
        raise refuse("REVIEW_LAYER", path, "is not a review or a shelf that the viewer saved")
    return text


def _reviews(layers: Sequence[str]) -> str:
    """The layers as JSON in an element of their own; nothing where there are none."""
    text = json.dumps(list(layers), ensure_ascii=False).replace("<", "\\u003c")
    return f'\n<script type="text/plain" id="reviews">{text}</script>' if layers else ""


def _asset(name: str) -> str:
    """A built asset as text that may stand inside its element."""
    text = (files("usdrigui.view") / "assets" / name).read_text(encoding="utf-8")
    return text.replace("</script", "<\\/script").replace("</style", "<\\/style")


def _policy(script: str, style: str, live: str) -> str:
    """Content security policy: this script and this style, pictures made by them, the server of a
    live link."""
    link = "connect-src 'self'; " if live else ""
    return (
        f"default-src 'none'; script-src 'sha256-{_digest(script)}'; style-src"
        f" 'sha256-{_digest(style)}'; {link}img-src data: blob:; base-uri 'none'; form-action"
        " 'none'"
    )


def _digest(text: str) -> str:
    return base64.b64encode(hashlib.sha256(text.encode("utf-8")).digest()).decode("ascii")
