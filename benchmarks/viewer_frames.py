"""Frames per second of the web viewer while a handle is dragged, in Chromium without a graphics
card.

    python benchmarks/viewer_frames.py char.rigui.html [--control NAME] [--seconds 5] [--size
    1280x800]
                                                       [--draw webgl|canvas]

The picture is drawn as fine as on a machine with nothing else to do: other work on this one, which
makes frames slow, does not make it coarser.  Also prints where the time of a frame goes: what the
page measures, and the processor time per frame of the page's own process (script, style, canvases)
and of the graphics process (software WebGL and putting the picture together), which other work on
the machine changes less (Linux only), and the page's heap after a collection of garbage.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests"))

from browser_pages import Viewer, chromium, started

TIMED = """() => {
  const { view, session } = usdrigui.app;
  view.setFineness(view.brisk);
  view.setFineness = () => undefined;
  window.parts = {};
  const time = (owner, name, label) => {
    const plain = owner[name].bind(owner);
    const times = (window.parts[label] = []);
    owner[name] = (...given) => {
      const began = performance.now();
      const result = plain(...given);
      times.push(performance.now() - began);
      return result;
    };
  };
  time(session, 'set', 'set values');
  time(session.deformer, 'pose', '  points');
  time(session.elements, 'follow', '  elements');
  time(view, 'drawNow', 'draw');
  time(view.stage, 'refresh', '  normals');
  time(view.stage, 'draw', '  skin');
  time(view, 'arrangeOverlay', '  project elements');
  time(view.overlay, 'draw', '  handles and tracks');
}"""

SPENT = """() => Object.entries(window.parts).map(([name, times]) =>
  [name, times.length, times.reduce((sum, time) => sum + time, 0) / Math.max(1, times.length)])"""


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("page", type=Path)
    parser.add_argument("--control", help="by default jawOpen, or the first one")
    parser.add_argument("--seconds", type=float, default=5.0)
    parser.add_argument("--size", default="1280x800")
    parser.add_argument(
        "--draw", choices=("webgl", "canvas"), help="insist on one; by default the page chooses"
    )
    given = parser.parse_args()
    playwright = started()
    browser = chromium(playwright)
    viewer = Viewer(browser, given.page, tuple(map(int, given.size.split("x"))), draw=given.draw)
    measure(viewer.page, given.control, given.seconds)
    browser.close()
    playwright.stop()


def measure(page, control, seconds):
    page.wait_for_timeout(1500)
    elements = page.evaluate("usdrigui.elements()")
    names = [control] if control else ["jawOpen", elements[0]["controls"][0]]
    element = next(each for name in names for each in elements if name in each["controls"])
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
    while (now := time.perf_counter() - began) < seconds:
        share = 0.5 - 0.5 * math.cos(3.0 * now)
        page.mouse.move(x + share * (to_x - x), y + share * (to_y - y))
    frames = page.evaluate("usdrigui.app.view.drawn") - before
    processor = processor_seconds() - spent_before
    spent = page.evaluate(SPENT)
    by, fineness = page.evaluate("[usdrigui.app.view.stage.drawnBy, usdrigui.app.view.fineness]")
    page.mouse.up()
    heap = page.context.new_cdp_session(page)
    heap.send("HeapProfiler.collectGarbage")
    used = heap.send("Runtime.getHeapUsage")
    print(
        f"{frames / now:.1f} frames per second, drawn by the {by} at {fineness:.2f} of the"
        " resolution"
    )
    each = {role: 1000 * used / max(1, frames) for role, used in processor.items()}
    print(
        f"{sum(each.values()):.0f} ms of processor time per frame on {os.cpu_count()} processors,"
        " of which ",
        end="",
    )
    print(
        f"page {each['page']:.0f}, graphics {each['graphics']:.0f}; load {os.getloadavg()[0]:.1f}"
    )
    whole = (
        used["usedSize"] + used.get("embedderHeapUsedSize", 0) + used.get("backingStorageSize", 0)
    )
    print(f"{whole / 1e6:.0f} MB of heap, arrays among it")
    for name, count, mean in spent:
        print(f"  {name:20} {mean:7.2f} ms  x {count}")


def processor_seconds() -> Counter[str]:
    """Processor time so far of the processes that come from this one, by what they do for the
    browser."""
    parents, ticks, roles = {}, {}, {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
            command = (folder / "cmdline").read_bytes()
        except OSError:
            continue
        process = int(folder.name)
        parents[process], ticks[process] = int(fields[1]), int(fields[11]) + int(fields[12])
        page, graphics = b"--renderer-client-id" in command, b"--gpu-preferences" in command
        roles[process] = "page" if page else "graphics" if graphics else "other"
    ours = {os.getpid()}
    for _ in range(8):
        ours |= {process for process, parent in parents.items() if parent in ours}
    spent: Counter[str] = Counter()
    for process in ours - {os.getpid()}:
        if process in ticks:
            spent[roles[process]] += ticks[process] / os.sysconf("SC_CLK_TCK")
    return spent


if __name__ == "__main__":
    main()
