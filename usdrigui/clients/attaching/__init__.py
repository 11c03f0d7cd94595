"""A layout among the sublayers or references of its asset: the one edit of a source."""

from usdrigui.stages import require_usd

__all__ = ["require_usd"]
