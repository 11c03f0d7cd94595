"""Which assets a batch is about, and where their layers go."""

from __future__ import annotations

import glob
import os
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

from usdrigui.errors import refuse

_SUFFIXES = (".usd", ".usda", ".usdc", ".usdz")


def find_assets(patterns: Iterable[str]) -> tuple[Path, ...]:
    """The files that the patterns match, each once, in the order of the patterns and then by name.

    ``**`` matches folders at any depth.  Layers that usdrigui has written (``*.rigui.*``) are no
    assets unless a pattern names one in full.  Raises BATCH_NO_MATCH for a pattern without any
    match.
    """
    found: dict[str, Path] = {}
    for pattern in patterns:
        if Path(pattern).is_dir():
            inside = Path(pattern, "**", "*.usd*")
            raise refuse("BATCH_NO_MATCH", pattern, f"is a folder; '{inside}' are the files in it")
        matched = _matches(pattern)
        if not matched:
            raise refuse("BATCH_NO_MATCH", pattern, "matches no USD file")
        for each in matched:
            found.setdefault(os.path.realpath(each), each)
    return tuple(found.values())


def outputs_of(assets: Sequence[Path], folder: Path | None) -> tuple[Path, ...]:
    """Where the layer of each asset goes: beside it, or below `folder` as deep as it lies below all
    assets' folder.

    Assets whose layers would have one name, as those that differ in their extension alone, get
    layers with the extension in their names.  Raises FILE_TARGET where even so two of them would
    share one.
    """
    wheres = [each.parent for each in assets]
    if folder is not None:
        # It keeps symbolic links, where resolve() would follow them.
        common = os.path.commonpath([os.path.abspath(each) for each in wheres])  # noqa: PTH100
        wheres = [folder / os.path.relpath(each, common) for each in wheres]
    # One folder can be named in several ways.
    folders = [os.path.realpath(where) for where in wheres]
    names = [each.stem for each in assets]
    twins: set[int] = set()
    while more := _not_alone([*zip(folders, names, strict=True)]) - twins:
        twins |= more  # whose longer names may be those of others, as of char_usda.usda
        for index in more:
            names[index] = assets[index].name.replace(".", "_")
    outputs = tuple(where / f"{name}.rigui.usda" for where, name in zip(wheres, names, strict=True))
    check_apart(
        [(output, f"the layer of {asset}") for output, asset in zip(outputs, assets, strict=True)]
    )
    return outputs


def check_apart(files: Iterable[tuple[Path, str]]) -> None:
    """Refuse to write one file twice; each comes with a word on what it is to be.  Raises
    FILE_TARGET."""
    seen: dict[str, str] = {}
    for path, what in files:
        place = os.path.normcase(os.path.realpath(path))
        if place in seen:
            raise refuse(
                "FILE_TARGET",
                path,
                f"would be both {seen[place]} and {what}; give them different names",
            )
        seen[place] = what


def _not_alone(keys: Sequence[tuple[str, str]]) -> set[int]:
    """Places of the keys that occur more than once."""
    count = Counter(keys)
    return {index for index, key in enumerate(keys) if count[key] > 1}


def _matches(pattern: str) -> list[Path]:
    if not glob.has_magic(pattern) or Path(pattern).exists():
        return [Path(pattern)]
    return sorted(
        path
        # A pattern may be absolute, which Path.glob refuses.
        for path in map(Path, glob.glob(pattern, recursive=True))  # noqa: PTH207
        # What is no file, such as a link that leads nowhere, gets a row that says so.
        if path.suffix.lower() in _SUFFIXES and ".rigui" not in path.suffixes and not path.is_dir()
    )
