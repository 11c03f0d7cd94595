"""Chromium for the viewer's tests and benchmarks; tests skip, saying so, where it or Playwright is missing."""

import io
import shutil
import time

import numpy as np
import pytest
from PIL import Image

FLAGS = (
    "--no-sandbox",
    "--disable-gpu",
    "--enable-unsafe-swiftshader",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
)

DRAWN_BY = {"canvas": "processor", "webgl": "graphics card"}


def decoded(png):
    """(height, width, 3) of a picture."""
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"), dtype=np.int64)


def chromium_path():
    return next(
        (path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))), None
    )


def started():
    """Playwright, or a skip that says what is missing."""
    sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
    if chromium_path() is None:
        pytest.skip("no Chromium is installed")
    return sync_api.sync_playwright().start()


def chromium(playwright, *more_flags):
    """A browser with software WebGL."""
    return playwright.chromium.launch(executable_path=chromium_path(), args=[*FLAGS, *more_flags])


class Viewer:
    """A viewer page in the browser, driven with the mouse."""

    def __init__(self, browser, path, size=(1200, 760), permissions=(), draw=None, script=None):
        """`path` is a file, or an address; `script` runs in the page before its own."""
        self.trouble = []
        viewport = {"width": size[0], "height": size[1]}
        context = browser.new_context(viewport=viewport, permissions=list(permissions))
        if script:
            context.add_init_script(script)
        self.page = context.new_page()
        self.page.on("console", self._heard)
        self.page.on("pageerror", lambda error: self.trouble.append(str(error)))
        self.page.on("request", self._asked)
        address = path if isinstance(path, str) else path.resolve().as_uri()
        self.page.goto(address + (f"#draw={draw}" if draw else ""))
        self.until("window.usdrigui !== undefined", 60.0)
        self.settle()

    def _heard(self, message):
        """Errors and warnings, but for what the software renderer says about screenshots."""
        if message.type in ("error", "warning") and "GL Driver Message" not in message.text:
            self.trouble.append(message.text)

    def _asked(self, request):
        if not request.url.startswith(("file:", "blob:", "data:")):
            self.trouble.append(f"asked the network for {request.url}")

    def settle(self):
        """Until what was asked for is drawn."""
        self.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def until(self, expression, seconds=20.0):
        """Wait for a JavaScript expression to hold.  Playwright's own way evaluates text, which the page forbids."""
        end = time.monotonic() + seconds
        while not self.page.evaluate(expression):
            assert time.monotonic() < end, f"still not so: {expression}"
            self.page.wait_for_timeout(20)

    def saved(self, label, path):
        """Where a button downloads a file to, under the name that the page suggests."""
        with self.page.expect_download() as download:
            self.page.get_by_role("button", name=label, exact=True).click()
        character = self.page.evaluate("usdrigui.app.session.character.root").split("/")[-1]
        # What a participant or a reviewer did is of all characters.
        of_character = not path.name.startswith(("evaluation", "review"))
        assert download.value.suggested_filename == (f"{character}.{path.name}" if of_character else path.name)
        download.value.save_as(path)
        return path

    def values(self):
        return self.page.evaluate("usdrigui.values()")

    def points(self):
        return np.array(self.page.evaluate("usdrigui.points()")).reshape(-1, 3)

    def furthest(self, rig, expected):
        """By how much a point that is shown is elsewhere than expected, at most, by the diagonal of all."""
        shown = np.concatenate([np.full(len(mesh.points), mesh.visible) for mesh in rig.body.meshes])
        return np.abs(self.points() - expected)[shown].max() / np.linalg.norm(np.ptp(expected, axis=0))

    def moved(self, least=1e-6):
        return {name: value for name, value in self.values().items() if abs(value) > least}

    def set(self, **values):
        self.page.evaluate("(values) => usdrigui.set(values)", values)
        self.settle()

    def element(self, name):
        return next(each for each in self.page.evaluate("usdrigui.elements()") if each["name"] == name)

    def unfold(self, panel="list"):
        """Open a panel that is folded away: `list` or `inspector`."""
        self.page.evaluate("(panel) => usdrigui.app.fold(panel, true)", panel)
        self.settle()

    def option(self, name, value):
        self.page.evaluate("([name, value]) => usdrigui.app.session.setOption(name, value)", [name, value])
        self.settle()

    def on_page(self, at):
        box = self.page.locator(".surface").bounding_box()
        return box["x"] + at[0], box["y"] + at[1]

    def click(self, button, exact=False):
        self.page.get_by_role("button", name=button, exact=exact).click()

    def key(self, name):
        self.page.keyboard.press(name)

    def press(self, at):
        self.page.mouse.move(*self.on_page(at))
        self.page.mouse.down()

    def glide(self, start, end, steps=8):
        for k in range(1, steps + 1):
            share = k / steps
            self.page.mouse.move(*self.on_page([a + share * (b - a) for a, b in zip(start, end, strict=True)]))
            self.settle()

    def drag(self, start, end, steps=8):
        self.press(start)
        self.glide(start, end, steps)
        self.page.mouse.up()
        self.settle()

    def touch(self, kind, *places):
        """Fingers on the view: `kind` is touchStart, touchMove or touchEnd, `places` those that are down."""
        self.fingers = getattr(self, "fingers", None) or self.page.context.new_cdp_session(self.page)
        points = [dict(zip(("x", "y"), self.on_page(at), strict=True), id=i) for i, at in enumerate(places)]
        self.fingers.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        self.settle()

    def marks_in(self, left, top, width, height):
        """How much of a rectangle of the view the handles and tracks cover: the sum of their opacity, 0 to 1 each."""
        return self.page.evaluate(
            """([x, y, w, h]) => {
              const { canvas, ratio, box: [left, top] } = usdrigui.app.view.overlay;
              const box = [x - left, y - top, w, h].map((value) => Math.round(value * ratio));
              const copy = new OffscreenCanvas(box[2], box[3]).getContext('2d', { willReadFrequently: true });
              copy.drawImage(canvas, -box[0], -box[1]);
              const { data } = copy.getImageData(0, 0, box[2], box[3]);
              let sum = 0;
              for (let i = 3; i < data.length; i += 4) sum += data[i] / 255;
              return sum;
            }""",
            [left, top, width, height],
        )

    def marks_at(self, at, reach=9):
        return self.marks_in(at[0] - reach, at[1] - reach, 2 * reach, 2 * reach)

    def skin_shot(self):
        """Pixels of the drawn skin alone, as PNG bytes."""
        self.page.evaluate("document.querySelector('.marks').style.visibility = 'hidden'")
        self.settle()
        shot = self.page.locator(".view").screenshot()
        self.page.evaluate("document.querySelector('.marks').style.visibility = ''")
        return shot

    def close(self):
        self.page.context.close()
