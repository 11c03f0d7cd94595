"""Foreign USD is read in a process that may be lost: what it is asked, does and answers."""

from usdrigui.stages import require_usd

__all__ = ["require_usd"]
