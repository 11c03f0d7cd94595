"""Reading and writing USD: the two ends of the line, and the only code that imports pxr."""

from usdrigui.distributions import require_usd

require_usd()
