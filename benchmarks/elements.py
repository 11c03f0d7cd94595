"""What each element of the layout beyond the paper is good for: a table of rigs by what is left
out.

    python benchmarks/elements.py ASSET... --judge SCRIPT --folder FOLDER [--rows WORD...]
        [--seconds 8]

SCRIPT is a program that prints how many controls of a layer stand where an animator expects them
(``43/45 placed`` or ``joint axes 70/72``), and ``FAIL`` with the reasons where that does not do.
Each cell has its count, the elements that are clear of those drawn on the skin, the mean
displacement kept on the face, the controls there, the elements, and the reasons.  The layers stay
in FOLDER, one subfolder a row.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
from collections.abc import Mapping
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from unittest.mock import patch

from usdrigui.pipeline import process
from usdrigui.settings import load


@dataclass(frozen=True)
class Row:
    """What is left out: by settings, or by a function that finds nothing."""

    name: str
    settings: Mapping[str, Mapping[str, Any]] = field(default_factory=dict)
    replaced: Mapping[str, Any] = field(default_factory=dict)


ROWS = (
    Row("nothing"),
    Row("names", {"candidates": {"conventions": False}}),
    Row("places of one's own", {"objective": {"distinctive_weight": 0.0}}),
    Row(
        "names and places of one's own",
        {"candidates": {"conventions": False}, "objective": {"distinctive_weight": 0.0}},
    ),
    Row("two lobes", {"symmetry": {"double_middle": "never"}}),
    Row("places beside the plane", {"symmetry": {"plane_weight": 100.0}}),
    Row("enlarged tracks", replaced={"usdrigui.layout.motion.tracks._ENLARGED": 1.0}),
    Row("the basis", {"candidates": {"board_composite": False}}),
    Row(
        "families",
        replaced={"usdrigui.layout.classify.composites.find_families": lambda *_: ()},
    ),
    Row("the least kept", {"candidates": {"least_kept": 0.0}}),
    Row(
        "owned skin",
        replaced={"usdrigui.layout.motion.trajectory.owned_skin": lambda *_: None},
    ),
    Row("parts", {"parts": {"divide": False}}),
    Row(
        "evidence of groups",
        replaced={
            "usdrigui.layout.group.evidence.Evidence.relation": lambda *_: "open",
            "usdrigui.layout.group.evidence.Evidence.crossing": lambda *_: ("open", 1.0),
            "usdrigui.layout.group.evidence.Evidence.like": lambda *_: True,
            "usdrigui.layout.group.evidence.Evidence.one_place": lambda *_: True,
        },
    ),
    Row(
        "sides of the skeleton",
        replaced={"usdrigui.layout.symmetry.mirror_plane.plane_of_names": lambda *_: None},
    ),
    Row("the dear board", {"objective": {"off_face_penalty": 0.3}}),
)


def main() -> None:
    given = _arguments()
    rows = [row for row in ROWS if not given.rows or any(word in row.name for word in given.rows)]
    print("| without | " + " | ".join(asset.stem for asset in given.assets) + " |")
    print("|---" * (len(given.assets) + 1) + "|")
    for row in rows:
        cells = [cell(row, asset, given) for asset in given.assets]
        print(f"| {row.name} | " + " | ".join(cells) + " |", flush=True)


def cell(row: Row, asset: Path, given: argparse.Namespace) -> str:
    """The judge's figures of one rig without the element of the row."""
    layer = given.folder / row.name.replace(" ", "_") / f"{asset.stem}.rigui.usda"
    layer.parent.mkdir(parents=True, exist_ok=True)
    settings = load(row.settings, {"solve": {"time_limit": given.seconds}})
    with ExitStack() as replacing:
        for name, other in row.replaced.items():
            replacing.enter_context(patch(name, other))
        (character, *_) = process(asset, settings, output=layer).characters
    said = subprocess.run(
        [sys.executable, str(given.judge), str(layer)], capture_output=True, text=True, check=False
    ).stdout
    found = re.search(r"(\d+/\d+) placed|joint axes (\d+/\d+)", said)
    count = next((each for each in found.groups() if each), "-") if found else "-"
    failed = re.search(r"FAIL\s+(.*)", said)
    elements = len(character.layout.elements)
    kept = f"{character.kept:.3f} of {character.count('face')} in {elements}"
    read = character.legibility
    clear = f"{read.elements - len(read.unclear)}/{read.elements} clear"
    return f"{count}, {clear}, {kept}" + (f"; {failed[1].strip()}" if failed else "")


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("assets", nargs="+", type=Path)
    parser.add_argument("--judge", type=Path, required=True)
    parser.add_argument("--rows", nargs="*", default=[], help="only rows with one of these words")
    parser.add_argument("--seconds", type=float, default=8.0, help="limit of every solve")
    parser.add_argument("--folder", type=Path, required=True)
    return parser.parse_args()


if __name__ == "__main__":
    main()
