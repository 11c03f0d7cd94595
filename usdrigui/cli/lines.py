"""Lines of text as wide as whoever reads them; names come from files, so that nothing in them may
steer the terminal."""

from __future__ import annotations

import os
import shutil
import textwrap
from typing import TextIO

from usdrigui.errors import visible


def columns(stream: TextIO | None) -> int | None:
    """Characters in a line of a stream: of its terminal, or ``COLUMNS``; None in a log, whose lines
    stay whole."""
    if os.environ.get("COLUMNS", "").isdecimal() or (stream is not None and stream.isatty()):
        return shutil.get_terminal_size().columns
    return None


def wrapped(text: str, width: int | None, indent: str = "  ") -> list[str]:
    """Text in lines of at most `width` characters, broken between words alone; all but the first
    begin with `indent` more than the text itself."""
    if width is None:
        return [text]
    own = text[: len(text) - len(text.lstrip())]
    lines = textwrap.wrap(
        text.strip(),
        max(width, 20),
        initial_indent=own,
        subsequent_indent=own + indent,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return lines or [""]


def tell(text: str, stream: TextIO) -> None:
    """Print a sentence, in as many lines as it needs."""
    print("\n".join(wrapped(visible(text), columns(stream))), file=stream)
