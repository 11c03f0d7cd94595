"""The typeface of pictures, and text as it can be shown."""

from __future__ import annotations

import importlib.util
import re
import unicodedata
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from PIL import ImageFont

from usdrigui.errors import visible

_FALLBACKS = ("JP", "SC", "TC", "KR")
"""Faces of Kurinto Sans to which names turn, in this order: kanji alone look Japanese."""


def font(size: int, text: str = "") -> ImageFont.FreeTypeFont:
    """The typeface of pictures, which comes with Pillow; for a text with letters that it lacks the
    first of the package weblate-fonts, where that is installed, that has them all."""
    return _face(_number(visible(text)), size)


@cache
def _face(number: int, size: int) -> ImageFont.FreeTypeFont:
    """The typeface of Pillow, 0, or a fallback."""
    if number:
        return ImageFont.truetype(_fallbacks()[number - 1], size)
    face = ImageFont.load_default(size)
    if not isinstance(face, ImageFont.FreeTypeFont):
        raise TypeError("Pillow was built without FreeType")
    return face


@cache
def _fallbacks() -> tuple[str, ...]:
    """Files of the extra ``fonts``; none without it.  No font of the system is asked, for the same
    layout gives the same picture everywhere."""
    package = importlib.util.find_spec("weblate_fonts")
    if package is None or not package.submodule_search_locations:
        return ()
    folder = Path(package.submodule_search_locations[0], "static/weblate_fonts/kurinto/ttf")
    files = (folder / f"KurintoSans{each}-Rg.ttf" for each in _FALLBACKS)
    return tuple(str(file) for file in files if file.is_file())


@cache
def _number(text: str) -> int:
    """Which typeface draws a text: the first with all of its letters, else the usual one."""
    numbers = range(len(_fallbacks()) + 1)
    return next((each for each in numbers if all(_drawable(c, each) for c in text)), 0)


def legible(text: str) -> str:
    """The text as its typeface can show it: letters that it lacks lose their accents, kana and
    hangul are spelt as they sound, other letters by their code point; line ends are spelt out."""
    text = visible(text)
    return text if _number(text) else "".join(map(_shown, text))


def spelt_out(texts: Sequence[str]) -> tuple[str, ...]:
    """Those of the texts with wide letters (Han, kana, hangul) that no typeface here has."""
    if _fallbacks():
        return ()
    return tuple(text for text in texts if any(map(_is_wide, text)) and legible(text) != text)


def _is_wide(letter: str) -> bool:
    return unicodedata.east_asian_width(letter) in "WF" and letter.isalpha()


@cache
def _shown(letter: str) -> str:
    """A letter, or what the typeface has for it."""
    if _drawable(letter):
        return letter
    plain = unicodedata.normalize("NFKD", letter)[0]
    return plain if _drawable(plain) else _spelt(letter)


def _spelt(letter: str) -> str:
    """A letter that every typeface lacks as it sounds, where Unicode names it so."""
    called = unicodedata.name(unicodedata.normalize("NFKC", letter)[0], "")
    sound = re.fullmatch(
        r"(?:HIRAGANA LETTER|KATAKANA LETTER|HANGUL SYLLABLE) (?:SMALL )?([A-Z]+)", called
    )
    if sound is not None:
        return sound[1].lower()
    return "-" if "PROLONGED SOUND MARK" in called else f"[U+{ord(letter):04X}]"


@cache
def _drawable(letter: str, number: int = 0) -> bool:
    face = _face(number, 12)
    return bytes(face.getmask(letter)) != bytes(face.getmask("\uffff"))


def width_of(text: str, size: int) -> float:
    """Pixels that a text takes."""
    return font(size, text).getlength(legible(text))


def cut(name: str, size: int, free: float) -> str:
    """The name, with its middle left out where it is wider than `free` pixels."""
    if width_of(name, size) <= free:
        return name
    for letters in range(len(name) - 1, 3, -1):
        short = name[: (letters + 1) // 2] + "…" + name[len(name) - letters // 2 :]
        if width_of(short, size) <= free:
            return short
    return name[:2] + "…" + name[-2:]
