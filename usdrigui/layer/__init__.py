"""The layout layer: written from layouts, drawn, read back and checked."""

from usdrigui.stages import require_usd

__all__ = ["require_usd"]
