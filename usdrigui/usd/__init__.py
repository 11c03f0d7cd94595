"""Layouts in USD: written, drawn, read and checked."""

from usdrigui.stages import require_usd

__all__ = ["require_usd"]
