"""Lay out every rig of a folder and write the gallery of them.

    python docs/gallery.py ASSETS [NAME ...] [--judge SCRIPT]

ASSETS holds the real rigs by the names in gallery.toml; absent ones are skipped, and where names
are given all others. SCRIPT is a program that prints how many controls of a layer stand where an
animator expects them.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import subprocess
import sys
import tempfile
import tomllib
from dataclasses import asdict, dataclass
from pathlib import Path

from PIL import Image

from usdrigui.pipeline import load_layer, process
from usdrigui.settings import Settings
from usdrigui.view.picture import Wanted, render

DOCS = Path(__file__).resolve().parent
IMAGES, PAGE, ROWS = (
    DOCS / "images" / "gallery",
    DOCS / "internals" / "gallery.md",
    DOCS / "images" / "gallery" / "rows.json",
)
PANEL, QUALITY = (760, 620), 72

REMARKS: dict[str, str] = tomllib.loads((DOCS / "gallery.toml").read_text("utf-8"))
"""By rig, in the order of the page: what is still wrong on it, looked at by eye."""

_INTRODUCTION = """\
Layouts of real rigs with default settings: each with its remaining faults. *On the character*:
controls with an element on the character, of all; *clear*: elements that can be read and grabbed
at a glance in a picture 640 pixels high, of all that are visible at first, as `usdrigui check`
tells; *kept*: mean displacement at the handle as a share of the control's peak; *gap*: proven
distance of the cost from the optimum; *placed*: controls (of joints: axes) that are where an
animator expects them, judged by a separate program; - where it knows no place for any.

Sources and licences are in the `customLayerData` of each file. `ict_*`: ICT FaceKit, MIT; `mh_*`:
MakeHuman, CC0; vitruvian: CharMorph Vitruvian, CC0; godette: Godette by SirRichard94, VRM by Lyuma,
CC-BY 3.0; facecap_blender: Face Cap, (c) 2020 Niels J., MIT; rocketbox_male17: Microsoft Rocketbox,
MIT; rpm_xr: Ready Player Me template in ubiq-rocketbox, (c) 2024 Ready Player Me, MIT;
weboji_tiger: jeelizWeboji, Apache-2.0; hand_webxr: WebXR input profiles, Amazon, MIT;
openusd_blendshapes: OpenUSD's own test."""


@dataclass(frozen=True)
class Result:
    """What one layout comes to."""

    parts: str
    on_character: str
    clear: str
    kept: str
    gap: str
    judged: str


def main() -> int:
    """Lay out the rigs, draw them and write the page; returns the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("assets", type=Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--judge", type=Path)
    given = parser.parse_args()
    IMAGES.mkdir(parents=True, exist_ok=True)
    rows = json.loads(ROWS.read_text("utf-8")) if ROWS.is_file() else {}
    for name in given.names or REMARKS:
        asset = next(iter(sorted(given.assets.glob(f"{name}.usd*"))), None)
        if asset is None:
            print(f"{name}: absent, skipped")
            continue
        rows[name] = asdict(_result(name, asset, given.judge))
        ROWS.write_text(json.dumps(rows, indent=1) + "\n", "utf-8")
    PAGE.write_text(page(rows), "utf-8")
    return 0


def _result(name: str, asset: Path, judge: Path | None) -> Result:
    """What today's layout comes to; its picture is drawn."""
    with tempfile.TemporaryDirectory() as scratch:
        layer = Path(scratch) / f"{name}.rigui.usda"
        report = process(asset, Settings(), output=layer)
        _picture(layer).save(IMAGES / f"{name}.jpg", quality=QUALITY)
        judged = _judged(layer, judge)
    (character, *_) = report.characters
    on_face, kept, legible = character.count("face"), character.kept, character.legibility
    return Result(
        ", ".join(part.name for part in character.parts),
        f"{on_face}/{len(character.rows)}",
        f"{legible.clear}/{legible.elements}" if legible.elements else "-",
        f"{kept:.0%}" if math.isfinite(kept) else "-",
        f"{character.assignment.gap:.1e}",
        judged,
    )


def _picture(layer: Path) -> Image.Image:
    (rig, layout), *_ = load_layer(layer, Settings()).characters
    parts = len(layout.frame.parts) > 1
    return render(rig, layout, wanted=Wanted(None if parts else 0.0, PANEL))


def _judged(layer: Path, judge: Path | None) -> str:
    if judge is None:
        return "-"
    judged = subprocess.run(
        [sys.executable, str(judge), str(layer)], capture_output=True, text=True, check=False
    ).stdout
    found = re.search(r"(\d+/[1-9]\d*) placed|joint axes (\d+/[1-9]\d*)", judged)
    return next((each for each in found.groups() if each), "-") if found else "-"


def page(rows: dict[str, dict[str, str]]) -> str:
    """The page: a table, then a picture of each rig with what is still wrong on it."""
    lines = [
        "# Gallery",
        "",
        "<!-- Made by docs/gallery.py; do not edit. -->",
        "",
        *_INTRODUCTION.splitlines(),
        "",
        "| rig | parts | on the character | clear | kept | gap | placed |",
        "|---|---|---|---|---|---|---|",
    ]
    shown = [name for name in REMARKS if name in rows]
    for name in shown:
        row = rows[name]
        columns = (row[key] for key in ("parts", "on_character", "clear", "kept", "gap", "judged"))
        lines.append(f"| {name} | {' | '.join(columns)} |")
    for name in shown:
        lines += [
            "",
            f"## {name}",
            "",
            f"![{name}](../images/gallery/{name}.jpg)",
            "",
            REMARKS[name].strip(),
        ]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.exit(main())
