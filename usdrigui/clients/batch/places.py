"""Which assets a batch is about, and where their layers go."""

from __future__ import annotations

import glob
import os
from collections.abc import Iterable, Sequence
from pathlib import Path

from usdrigui.errors import refuse

_SUFFIXES = (".usd", ".usda", ".usdc", ".usdz")


def find_assets(patterns: Iterable[str]) -> tuple[Path, ...]:
    """The files that the patterns match, each once, in the order of the patterns and then by name.

    ``**`` matches folders at any depth.  Layers that usdrigui has written (``*.rigui.*``) are no assets
    unless a pattern names one in full.  Raises BATCH_NO_MATCH for a pattern without any match.
    """
    found: dict[str, Path] = {}
    for pattern in patterns:
        matched = _matches(pattern)
        if not matched:
            raise refuse("BATCH_NO_MATCH", pattern, "matches no USD file")
        for each in matched:
            found.setdefault(os.path.realpath(each), each)
    return tuple(found.values())


def output_of(asset: Path, assets: Sequence[Path], folder: Path | None) -> Path:
    """Where the layer of an asset goes: beside it, or below `folder` as deep as it lies below all assets' folder.

    Two assets that differ in their extension alone get layers with the extension in their names.
    """
    twins = [each for each in assets if each.parent == asset.parent and each.stem == asset.stem]
    name = asset.name.replace(".", "_") if len(twins) > 1 else asset.stem
    where = asset.parent
    if folder is not None:
        common = os.path.commonpath([os.path.abspath(each.parent) for each in assets])  # noqa: PTH100 (keeps links)
        where = folder / os.path.relpath(asset.parent, common)
    return Path(os.path.normpath(where / f"{name}.rigui.usda"))


def _matches(pattern: str) -> list[Path]:
    if not glob.has_magic(pattern) or Path(pattern).exists():
        return [Path(pattern)]
    return sorted(
        path
        for path in map(Path, glob.glob(pattern, recursive=True))  # noqa: PTH207 (patterns may be absolute)
        if path.suffix.lower() in _SUFFIXES and ".rigui" not in path.suffixes and path.is_file()
    )
