"""Reading and writing USD: the two ends of the line, and the only code that imports pxr."""

from importlib.util import find_spec

from usdrigui.errors import refuse


def require_usd() -> None:
    """Refuse with USD_MISSING where this Python finds no pxr."""
    try:
        found = find_spec("pxr")
    except ValueError:  # an embedding program put in a module without a spec
        return
    if found is None:
        raise refuse("USD_MISSING", "", "this Python has no pxr")


require_usd()
