"""Which installed packages this Python has USD from: several overwrite each other's files.

Nothing here imports pxr.
"""

from __future__ import annotations

from importlib.machinery import PathFinder
from pathlib import Path

from usdrigui.errors import Issue, issue

_OWNED = b"\npxr/Usd/__init__.py,"
"""In the list of files of every package that installs USD; some have no ``pxr/__init__.py``."""


def colliding() -> tuple[Issue, ...]:
    """USD_TWICE where several installed packages hold the same files of pxr; none where this user
    may not look."""
    try:
        owners = _owners()
        if len(owners) < 2:
            return ()
        named = _names(owners)
    except OSError:
        return ()
    found = f"{' and '.join(named)} own the same files of pxr in {_places()[0]}"
    return (issue("USD_TWICE", "", found),)


def _owners() -> list[Path]:
    """The metadata folders of the packages that hold pxr."""
    records = [record for place in _places() for record in sorted(place.glob("*.dist-info/RECORD"))]
    return [record.parent for record in records if _OWNED in b"\n" + record.read_bytes()]


def _names(owners: list[Path]) -> list[str]:
    from importlib.metadata import PathDistribution  # as long to load as the whole command line

    return [f"{each.metadata['Name']} {each.version}" for each in map(PathDistribution, owners)]


def _places() -> list[Path]:
    """The folders that pxr is found in, whatever module an embedding program put in its place."""
    spec = PathFinder.find_spec("pxr")
    return [Path(each).parent for each in spec.submodule_search_locations or ()] if spec else []
