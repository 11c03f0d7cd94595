"""Reviews: notes at frames that a page saved as a small USD layer, for another page to open
(docs/decisions/142).

The page reads the notes itself; here is only told that a file is a review.
"""

from __future__ import annotations

from pathlib import Path

from usdrigui.errors import refuse

_MARK = "string note = "
_MOST_BYTES = 1 << 24


def read_review(path: Path) -> str:
    """The text of a review.  Raises RigUIError REVIEW_LAYER for a file that is none, or over 16
    MB."""
    try:
        with path.open("rb") as file:
            content = file.read(_MOST_BYTES + 1)
        text = content.decode("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise refuse("REVIEW_LAYER", str(path), f"cannot be read as text: {error}") from error
    if len(content) > _MOST_BYTES:
        raise refuse("REVIEW_LAYER", str(path), "is larger than 16 MB")
    if not text.startswith("#usda") or _MARK not in text:
        raise refuse("REVIEW_LAYER", str(path), "is not what Save review in the viewer writes")
    return text
