"""Make the pictures of the README and of the guides anew.

    python docs/screens.py [WORD ...]

Everything is made from the sample character with the package and, for the page, with Chromium under
Playwright.  With words only the pictures whose names hold one of them are made.
"""

from __future__ import annotations

import argparse
import io
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw, ImageSequence

from usdrigui.pipeline import load_layer, process
from usdrigui.settings import Settings, load
from usdrigui.view.picture import Wanted, render

DOCS = Path(__file__).resolve().parent
IMAGES = DOCS / "images"
SAMPLE = DOCS.parent / "sample_assets"
QUALITY = 82

GLYPHS = """#usda 1.0
(
    upAxis = "Z"
)
def BasisCurves "Drop"
{
    uniform token type = "cubic"
    uniform token basis = "bspline"
    uniform token wrap = "periodic"
    int[] curveVertexCounts = [6]
    point3f[] points = [
        (0, 2, 0), (-0.2, 0.8, 0), (-1, -0.4, 0), (0, -1.2, 0), (1, -0.4, 0), (0.2, 0.8, 0)
    ]
}
def Mesh "Star"
{
    int[] faceVertexCounts = [10]
    int[] faceVertexIndices = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]
    point3f[] points = [
        (0, 1, 0), (-0.22, 0.31, 0), (-0.95, 0.31, 0), (-0.36, -0.12, 0), (-0.59, -0.81, 0),
        (0, -0.38, 0), (0.59, -0.81, 0), (0.36, -0.12, 0), (0.95, 0.31, 0), (0.22, 0.31, 0)
    ]
}
def Mesh "Arrow"
{
    int[] faceVertexCounts = [7]
    int[] faceVertexIndices = [0, 1, 2, 3, 4, 5, 6]
    point3f[] points = [
        (0, 1, 0), (-0.9, 0.1, 0), (-0.35, 0.1, 0), (-0.35, -1, 0), (0.35, -1, 0), (0.35, 0.1, 0),
        (0.9, 0.1, 0)
    ]
}
"""
WITH_GLYPHS = """
[controls]
jawOpen = { glyph = "glyphs.usda</Drop>", glyph_size = 2.8 }
cheekSquintLeft = { glyph = "glyphs.usda</Star>", glyph_size = 2.8 }
cheekSquintRight = { glyph = "glyphs.usda</Star>", glyph_size = 2.8 }
browOuterUpLeft = { glyph = "glyphs.usda</Arrow>", glyph_size = 2.8 }
browOuterUpRight = { glyph = "glyphs.usda</Arrow>", glyph_size = 2.8 }
"""
WITH_LEVELS = """
[poses.smile]
weights = { mouthSmileLeft = 1.0, mouthSmileRight = 1.0 }
[poses.frown]
weights = { mouthFrownLeft = 1.0, mouthFrownRight = 1.0 }
[controls]
smile.place = "face"
frown.place = "face"
[levels]
poses = true
"""


def main() -> int:
    """Make the pictures; returns the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("words", nargs="*")
    words = parser.parse_args().words
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        for path in SAMPLE.glob("char*.usda"):
            shutil.copy(path, folder)
        process(folder / "char.usda", load({}), output=folder / "char.rigui.usda")
        for name, make in PICTURES.items():
            if not words or any(word in name for word in words):
                make(folder, IMAGES / name)
                print(IMAGES / name, (IMAGES / name).stat().st_size, flush=True)
    return 0


def _command(*words: str | Path) -> None:
    subprocess.run([sys.executable, "-m", "usdrigui", *map(str, words), "-q"], check=True)


def layout(folder: Path, target: Path) -> None:
    """The layout from its views, enlarged where it is crowded, with names."""
    _command("picture", folder / "char.rigui.usda", "-o", target, "--labels")


def animation(folder: Path, target: Path) -> None:
    """The sample's own animation under its layout."""
    _command("picture", folder / "char.rigui.usda", "-o", target, "--frames", "24")
    with Image.open(target) as film:
        frames = [
            frame.convert("RGB").resize((532, 532 * frame.height // frame.width))
            for frame in ImageSequence.Iterator(film)
        ]
    _film(frames, target)


def glyphs(folder: Path, target: Path) -> None:
    """Handles of shapes of one's own."""
    (folder / "glyphs.usda").write_text(GLYPHS)
    settings = load(tomllib.loads(WITH_GLYPHS))
    made = process(folder / "char.usda", settings, output=folder / "glyphs.rigui.usda")
    (character, *_) = made.characters
    picture = render(character.rig, character.layout, wanted=Wanted(0.0, (640, 640)))
    picture.save(target, optimize=True)


def levels(folder: Path, target: Path) -> None:
    """Two coarse elements, and one of them opened."""
    config, layer = folder / "levels.toml", folder / "levels.rigui.usda"
    config.write_text(WITH_LEVELS)
    _command("process", folder / "char.usda", "--config", config, "-o", layer)
    panels = []
    for opened in ((), ("--open", "smile")):
        drawn = folder / "level.png"
        _command("picture", layer, "-o", drawn, "--config", config, *opened)
        panels.append(Image.open(drawn).convert("RGB").crop((0, 0, 700, 942)))
    both = Image.new("RGB", (1400, 942))
    for index, panel in enumerate(panels):
        both.paste(panel, (700 * index, 0))
    both.save(target, quality=QUALITY)


def shot(folder: Path, target: Path) -> None:
    """What a shot adds to the layout of its asset: the shapes of docs/pipeline.md's example."""
    text = (DOCS / "pipeline.md").read_text("utf-8")
    shot_layer = text.partition("cat > shot.usda <<'USD'\n")[2].partition("\nUSD\n")[0]
    (folder / "shot.usda").write_text(shot_layer + "\n")
    layer = folder / "shot.rigui.usda"
    _command("process", folder / "shot.usda", "--base", folder / "char.rigui.usda", "-o", layer)
    (rig, made), *_ = load_layer(layer, Settings()).characters
    render(rig, made, wanted=Wanted(0.0, (760, 740), title="shot")).save(target, quality=QUALITY)


# --- the page -------------------------------------------------------------------------------------


@contextmanager
def _page(folder: Path, size: tuple[int, int]) -> Iterator[Any]:
    """The page of the layout in Chromium."""
    from playwright.sync_api import sync_playwright

    html = folder / "char.html"
    _command("view", folder / "char.rigui.usda", "--html", html)
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=shutil.which("chromium"), args=["--no-sandbox", "--disable-gpu"]
        )
        page = browser.new_page(viewport={"width": size[0], "height": size[1]})
        page.goto(html.as_uri())
        while not page.evaluate("window.usdrigui !== undefined"):
            page.wait_for_timeout(50)
        _settle(page)
        yield page
        browser.close()


def _settle(page: Any) -> None:
    """Until what was asked for is drawn, and drawn as finely as at rest."""
    page.evaluate(
        "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    )
    page.evaluate("() => { const { view } = usdrigui.app; view.setFineness(2); view.drawNow(); }")


def viewer(folder: Path, target: Path) -> None:
    """The page with a pose and its keys."""
    with _page(folder, (1400, 900)) as page:
        pose = {"jawOpen": 0.35, "mouthSmileLeft": 0.8, "mouthSmileRight": 0.8, "browInnerUp": 0.6}
        page.evaluate("() => usdrigui.app.fold('inspector', true)")
        page.get_by_role("button", name="Keys", exact=True).click()
        page.evaluate("(pose) => usdrigui.set(pose)", pose)
        page.get_by_role("button", name="Key", exact=True).click()
        _settle(page)
        page.screenshot(path=str(target))


FACE = {"x": 150, "y": 39, "width": 520, "height": 610}
"""The part of the page that the drag is shown in, pixels."""


def drag(folder: Path, target: Path) -> None:
    """Handles being dragged on the page: the smile, a lid, the jaw; twins go along."""
    frames: list[Image.Image] = []
    with _page(folder, (1000, 720)) as page:
        page.evaluate("() => usdrigui.app.session.setOption('symmetric', true)")

        def taken(at: tuple[float, float], times: int = 1) -> None:
            _settle(page)
            picture = Image.open(io.BytesIO(page.screenshot(clip=FACE))).convert("RGB")
            _pointer(picture, (at[0] - FACE["x"], at[1] - FACE["y"]))
            frames.extend([picture] * times)

        for name, share in (("mouthSmileLeft", 0.9), ("eyeBlinkLeft", 0.7), ("jawOpen", 0.5)):
            start, end = _ends(page, name)
            page.mouse.move(*start)
            taken(start, 3)
            page.mouse.down()
            for step in range(1, 9):
                part = share * step / 8
                at = tuple(a + part * (b - a) for a, b in zip(start, end, strict=True))
                page.mouse.move(*at)
                taken(at)
            page.mouse.up()
            taken(at, 4)
    _film(frames, target)


def _ends(page: Any, control: str) -> list[tuple[float, float]]:
    """Where the track of a control begins and ends on the page."""
    box = page.locator(".surface").bounding_box()
    elements = page.evaluate("usdrigui.elements()")
    element = next(element for element in elements if control in element["controls"])
    track = element["tracks"][element["controls"].index(control)]
    return [(box["x"] + x, box["y"] + y) for x, y in (track[0], track[-1])]


def _pointer(picture: Image.Image, at: tuple[float, float]) -> None:
    """The pointer of a mouse, which a screenshot lacks."""
    outline = [(0, 0), (0, 19), (4.5, 15), (8, 22.5), (11, 21), (7.8, 14), (13.5, 14)]
    points = [(at[0] + x, at[1] + y) for x, y in outline]
    ImageDraw.Draw(picture).polygon(points, fill="white", outline="black", width=1)


def _film(frames: Sequence[Image.Image], target: Path) -> None:
    # All frames have the colours of one, with those of small marks among them.
    palette = frames[-1].quantize(256, Image.Quantize.FASTOCTREE)
    small = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    small[0].save(
        target, save_all=True, append_images=small[1:], duration=90, loop=0, optimize=True
    )


PICTURES: dict[str, Callable[[Path, Path], None]] = {
    "sample.png": layout,
    "sample.gif": animation,
    "drag.gif": drag,
    "viewer.png": viewer,
    "glyphs.png": glyphs,
    "levels.jpg": levels,
    "shot.jpg": shot,
}


if __name__ == "__main__":
    sys.exit(main())
