"""Models the sample character and writes char.usda and char_geometry.usda.

    python sample_assets/make_char.py [FOLDER]

Needs numpy and usd-core. Without FOLDER the files beside this script are replaced; the same code gives the
same bytes.
"""

from __future__ import annotations

import sys
from pathlib import Path

from character.head import build_head
from character.parts import build_parts
from character.shapes import build_body, build_controls
from character.stage import Character, write_character


def make(folder: Path) -> tuple[Path, ...]:
    """Model, shape and write the character; returns the files."""
    head = build_head()
    parts = build_parts(head)
    body = build_body(head, parts)
    return write_character(Character(parts, body, build_controls(body)), folder)


if __name__ == "__main__":
    target = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent
    for written in make(target):
        print(f"{written} {written.stat().st_size} bytes")
