"""Frames per second of the web viewer while a handle is dragged, in Chromium with software WebGL.

    python benchmarks/viewer_frames.py char.rigui.html [--control NAME] [--seconds 5] [--size 1280x800]

Also prints where the time of a frame goes, as the page measures it, and the processor time per frame of
all of the browser's processes, which other work on the machine does not change (Linux only).
"""

from __future__ import annotations

import argparse
import math
import os
import time
from pathlib import Path

from playwright.sync_api import sync_playwright

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

TIMED = """() => {
  const { view, session } = usdrigui.app;
  window.parts = {};
  const time = (owner, name) => {
    const plain = owner[name].bind(owner);
    window.parts[name] = [];
    owner[name] = (...given) => {
      const began = performance.now();
      const result = plain(...given);
      window.parts[name].push(performance.now() - began);
      return result;
    };
  };
  time(view, 'drawNow');
  time(view.stage, 'refresh');
  time(view.stage, 'draw');
  time(view, 'arrangeOverlay');
  time(view.overlay, 'draw');
  time(session.deformer, 'pose');
  time(session.elements, 'follow');
  time(session, 'set');
}"""

SPENT = """() => Object.fromEntries(Object.entries(window.parts).map(([name, times]) => [
  name, [times.length, times.reduce((sum, time) => sum + time, 0) / Math.max(1, times.length)]]))"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path)
    parser.add_argument("--control", default="jawOpen")
    parser.add_argument("--seconds", type=float, default=5.0)
    parser.add_argument("--size", default="1280x800")
    parser.add_argument("--browser", default="/usr/bin/chromium")
    arguments = parser.parse_args()
    width, height = map(int, arguments.size.split("x"))
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=arguments.browser, args=FLAGS)
        page = browser.new_page(viewport={"width": width, "height": height})
        page.goto(arguments.page.resolve().as_uri())
        page.wait_for_function("window.usdrigui !== undefined")
        page.wait_for_timeout(1500)
        measure(page, arguments)
        browser.close()


def measure(page, arguments):
    element = next(each for each in page.evaluate("usdrigui.elements()") if arguments.control in each["controls"])
    box = page.locator(".surface").bounding_box()
    x, y = box["x"] + element["handle"][0], box["y"] + element["handle"][1]
    to_x, to_y = element["tracks"][0][-1][0] + box["x"], element["tracks"][0][-1][1] + box["y"]
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 5, y + 5)
    page.wait_for_timeout(300)
    page.evaluate(TIMED)
    spent_before = processor_seconds()
    before, began = page.evaluate("usdrigui.app.view.drawn"), time.perf_counter()
    while (now := time.perf_counter() - began) < arguments.seconds:
        share = 0.5 - 0.5 * math.cos(3.0 * now)
        page.mouse.move(x + share * (to_x - x), y + share * (to_y - y))
    frames = page.evaluate("usdrigui.app.view.drawn") - before
    processor = processor_seconds() - spent_before
    spent = page.evaluate(SPENT)
    fineness = page.evaluate("usdrigui.app.view.fineness")
    page.mouse.up()
    print(f"{frames / now:.1f} frames per second, drawn at {fineness:.2f} of the resolution")
    print(f"{1000 * processor / max(1, frames):.0f} ms of processor time per frame, on {os.cpu_count()} processors")
    for name, (count, mean) in spent.items():
        print(f"  {name:16} {mean:7.2f} ms  x {count}")


def processor_seconds() -> float:
    """Processor time so far of all processes that come from this one, without its own."""
    parents, ticks = {}, {}
    for entry in Path("/proc").glob("[0-9]*/stat"):
        try:
            name, _, rest = entry.read_text().rpartition(")")
        except OSError:
            continue
        fields = rest.split()
        process = int(name.split()[0])
        parents[process], ticks[process] = int(fields[1]), int(fields[11]) + int(fields[12])
    ours = {os.getpid()}
    for _ in range(8):
        ours |= {process for process, parent in parents.items() if parent in ours}
    return sum(ticks[process] for process in ours - {os.getpid()} if process in ticks) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    main()
