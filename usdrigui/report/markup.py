"""Text from files inside XML and HTML: one rule for every document that is written."""

from __future__ import annotations

import html
import re

_FORBIDDEN = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""What XML 1.0 (section 2.2) allows nowhere, not even as a reference; names of USD may hold it."""
_SPACES = {"\t": "&#9;", "\n": "&#10;", "\r": "&#13;"}
"""Would be read back as plain spaces from an attribute."""


def markup(text: str) -> str:
    """`text` as the content of an element or of an attribute in double quotes.

    What markup reserves is escaped and comes back when it is read; characters that XML forbids are
    spelt out, as `usdrigui.errors.visible` does for terminals.
    """
    legal = _FORBIDDEN.sub(lambda found: found.group().encode("unicode_escape").decode(), text)
    return "".join(_SPACES.get(each, each) for each in html.escape(legal))
