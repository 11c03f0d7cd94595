"""Headings of the board, in pictures and on pages."""

from __future__ import annotations

from usdrigui.layout.board.board import CATEGORIES

_HEADINGS = {
    "global": "whole character",
    "hidden": "hidden",
    "interior": "inside the mouth",
    "composite": "composite",
    "viseme": "visemes",
    "emotion": "emotions",
    "combination": "combinations",
    "identity": "identity",
    "requested": "by request",
    "crowded": "no room on the face",
}


def heading(category: str, part: str) -> str:
    """What stands over the elements of a category on the board of a part of the character; a word
    that another tool wrote as it is."""
    return _HEADINGS.get(category, category).replace("face", part or "face")


def rank(category: str) -> int:
    """Place of a category on the board from top to bottom; a word that another tool wrote comes
    last."""
    return CATEGORIES.index(category) if category in CATEGORIES else len(CATEGORIES)
