"""Lay out every rig of a folder and write the gallery of them, before and after.

    python docs/gallery.py ASSETS [NAME ...] [--before FOLDER] [--judge SCRIPT]

ASSETS holds the real rigs by the names in gallery.toml; absent ones are skipped, and where names
are given all others. FOLDER holds earlier layers of the same rigs and their reports
(NAME.rigui.usda, NAME.json).  SCRIPT is a program that prints how many controls of a layer stand
where an animator expects them.
"""

from __future__ import annotations

import argparse
import json
import re
import subprocess
import sys
import tempfile
import tomllib
from dataclasses import asdict, dataclass
from pathlib import Path

from PIL import Image

from usdrigui.pipeline import load_layer, process
from usdrigui.report.run_report import to_json
from usdrigui.settings import Settings
from usdrigui.view.picture import contact_sheet, render

DOCS = Path(__file__).resolve().parent
IMAGES, PAGE, ROWS = (
    DOCS / "images" / "gallery",
    DOCS / "internals" / "gallery.md",
    DOCS / "images" / "gallery" / "rows.json",
)
WIDTH, PANEL, QUALITY = 760, (760, 620), 72

REMARKS: dict[str, str] = tomllib.loads((DOCS / "gallery.toml").read_text("utf-8"))
"""By rig, in the order of the page: what is still wrong on it, looked at by eye."""

_INTRODUCTION = """\
Layouts of real rigs with default settings: by an earlier version → by this one. Each rig has its
remaining faults listed. *On the character*: controls with an element on the character, of all;
*kept*: mean displacement at the handle as a share of the control's peak; *gap*: proven distance of
the cost from the optimum; *placed*: controls (of joints: axes) that are where an animator expects
them, judged by a separate program; - where it knows no place for any.

Sources and licences are in the `customLayerData` of each file. `ict_*`: ICT FaceKit, MIT; `mh_*`:
MakeHuman, CC0; vitruvian: CharMorph Vitruvian, CC0; godette: Godette by SirRichard94, VRM by Lyuma,
CC-BY 3.0; facecap_blender: Face Cap, (c) 2020 Niels J., MIT; rocketbox_male17: Microsoft Rocketbox,
MIT; hand_webxr: WebXR input profiles, Amazon, MIT; openusd_blendshapes: OpenUSD's own test."""


@dataclass(frozen=True)
class Result:
    """What one layout comes to."""

    parts: str
    on_character: str
    kept: str
    gap: str
    judged: str


def main() -> int:
    """Lay out the rigs, draw them and write the page; returns the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("assets", type=Path)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--before", type=Path)
    parser.add_argument("--judge", type=Path)
    given = parser.parse_args()
    IMAGES.mkdir(parents=True, exist_ok=True)
    rows = json.loads(ROWS.read_text("utf-8")) if ROWS.is_file() else {}
    for name in given.names or REMARKS:
        asset = next(iter(sorted(given.assets.glob(f"{name}.usd*"))), None)
        if asset is None:
            print(f"{name}: absent, skipped")
            continue
        rows[name] = [asdict(each) for each in _results(name, asset, given.before, given.judge)]
    ROWS.write_text(json.dumps(rows, indent=1) + "\n", "utf-8")
    PAGE.write_text(page(rows), "utf-8")
    return 0


def _results(name: str, asset: Path, before: Path | None, judge: Path | None) -> list[Result]:
    """Of the earlier layer, if there is one, and of today's; their picture is drawn."""
    with tempfile.TemporaryDirectory() as scratch:
        layer = Path(scratch) / f"{name}.rigui.usda"
        (Path(scratch) / f"{name}.json").write_text(
            to_json(process(asset, Settings(), output=layer)), "utf-8"
        )
        layers = [layer]
        if before is not None and (before / layer.name).is_file():
            layers.insert(0, before / layer.name)
        images = [_picture(each) for each in layers]
        titles = ["before", "now"][-len(layers) :]
        contact_sheet(images, titles, len(images), WIDTH * len(images)).save(
            IMAGES / f"{name}.jpg", quality=QUALITY
        )
        return [_result(each, judge) for each in layers]


def _picture(layer: Path) -> Image.Image:
    (rig, layout), *_ = load_layer(layer, Settings()).characters
    parts = len(layout.frame.parts) > 1
    return render(rig, layout, views=None if parts else ("front",), size=PANEL)


def _result(layer: Path, judge: Path | None) -> Result:
    character = json.loads(
        layer.with_name(layer.name.replace(".rigui.usda", ".json")).read_text("utf-8")
    )["characters"][0]
    counts, solution = character["counts"], character["solution"]
    parts = ", ".join(part["name"] for part in character.get("parts", ())) or "one"
    kept = character["displacement_kept"]
    return Result(
        parts,
        f"{counts['face']}/{sum(counts.values())}",
        "-" if kept is None else f"{kept:.0%}",
        f"{solution['gap']:.1e}",
        _judged(layer, judge),
    )


def _judged(layer: Path, judge: Path | None) -> str:
    if judge is None:
        return "-"
    judged = subprocess.run(
        [sys.executable, str(judge), str(layer)], capture_output=True, text=True, check=False
    ).stdout
    found = re.search(r"(\d+/[1-9]\d*) placed|joint axes (\d+/[1-9]\d*)", judged)
    return next((each for each in found.groups() if each), "-") if found else "-"


def page(rows: dict[str, list[dict[str, str]]]) -> str:
    """The page: a table, then a picture of each rig with what is still wrong on it."""
    lines = [
        "# Gallery",
        "",
        "<!-- Made by docs/gallery.py; do not edit. -->",
        "",
        *_INTRODUCTION.splitlines(),
        "",
        "| rig | parts | on the character | kept | gap | placed |",
        "|---|---|---|---|---|---|",
    ]
    shown = [name for name in REMARKS if name in rows]
    for name in shown:
        cells = [
            [each[key] for each in rows[name]] for key in ("on_character", "kept", "gap", "judged")
        ]
        columns = [" → ".join(each) for each in cells]
        lines.append(f"| {name} | {rows[name][-1]['parts']} | {' | '.join(columns)} |")
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
