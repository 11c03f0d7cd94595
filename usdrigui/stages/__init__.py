"""What USD itself says: stages and how they are opened, checked arrays, variants, colours, and the
names of our schema."""

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
