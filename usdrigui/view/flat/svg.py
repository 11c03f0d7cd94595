"""A flat scene as a stand-alone SVG: one group per element, with its controls and where it is
anchored as data attributes."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence

from usdrigui.character import Floats
from usdrigui.model import Element
from usdrigui.report.markup import markup
from usdrigui.view.flat.marks import handle_outlines, rings, runs
from usdrigui.view.flat.pillow import png
from usdrigui.view.flat.scene import GROUND, PAPER, Label, Mark, Page, Panel

_FAINT = 0.35
_ANCHORS = {"l": "start", "m": "middle", "r": "end"}


def svg(page: Page) -> str:
    """The page as SVG text."""
    width, height = page.size
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}"'
        f' width="{width}" height="{height}" font-family="sans-serif">',
        f'<rect width="{width}" height="{height}" fill="{_hex(PAPER)}"/>',
    ]
    for panel in page.panels:
        lines += _panel(panel)
    return "\n".join([*lines, "</svg>"]) + "\n"


def _panel(panel: Panel) -> list[str]:
    (left, top), (width, height) = panel.corner, panel.size
    lines = [f'<svg x="{left}" y="{top}" width="{width}" height="{height}">']
    if panel.grounded:
        lines.append(f'<rect width="{width}" height="{height}" fill="{_hex(GROUND)}"/>')
    if panel.body is not None:
        shown = base64.b64encode(png(panel.body)).decode("ascii")
        lines.append(
            f'<image x="{(width - panel.body.width) // 2}" width="{panel.body.width}"'
            f' height="{height}" href="data:image/png;base64,{shown}"/>'
        )
    lines += [_line(leader, "#82878f", 1.0) for leader in panel.leaders]
    for mark in panel.marks:
        lines += _group(mark.element, mark) if mark.element else _drawn(mark, ())
    return [*lines, *map(_text, panel.labels), "</svg>"]


def _group(element: Element, mark: Mark) -> list[str]:
    anchor = element.anchor
    controls = [member.control for member in element.members]
    facts = {
        "id": element.name,
        "data-controls": json.dumps(controls, ensure_ascii=False),
        "data-kind": element.kind,
        "data-side": element.side,
        "data-mirror": element.mirror,
        "data-anchor": f"{anchor.mesh}#{anchor.point}",
        "data-board": str(anchor.on_board).lower(),
    }
    attributes = " ".join(f'{name}="{markup(value)}"' for name, value in facts.items())
    title = f"<title>{markup(element.label)}: {markup(', '.join(controls))}</title>"
    return [f"<g {attributes}>", title, *_drawn(mark, controls), "</g>"]


def _drawn(mark: Mark, controls: Sequence[str]) -> list[str]:
    """Tracks, one path a control, and the handle."""
    colour, width = _hex(mark.colour), 0.36 * mark.radius
    lines = []
    for control, track, seen in zip(controls, mark.tracks, mark.seen, strict=True):
        lines.append(f'<g data-control="{markup(control)}">')
        lines += [_line(run, colour, width) for run in runs(track, seen)]
        lines += [_line(run, colour, width, _FAINT) for run in runs(track, ~seen)]
        lines.append("</g>")
    lines += [_line(ring, colour, width) for ring, width in rings(mark)]
    outlines, filled = handle_outlines(mark)
    fill = f'fill="{colour}" stroke="#ffffff"' if filled else f'fill="none" stroke="{colour}"'
    faint = f' opacity="{_FAINT}"' if mark.hidden else ""
    return lines + [
        f'<path d="M{_points(outline)}{"Z" * filled}" {fill} stroke-width="2"{faint}/>'
        for outline in outlines
    ]


def _line(line: Floats, colour: str, width: float, opacity: float = 1.0) -> str:
    faint = f' opacity="{opacity}"' if opacity < 1.0 else ""
    return (
        f'<polyline points="{_points(line)}" fill="none" stroke="{colour}"'
        f' stroke-width="{width:.2f}" stroke-linecap="round" stroke-linejoin="round"{faint}/>'
    )


def _text(label: Label) -> str:
    (x, y), size = label.place, label.size
    return (
        f'<text x="{x:.2f}" y="{y + 0.36 * size:.2f}" font-size="{size}" fill="{_hex(label.ink)}"'
        f' text-anchor="{_ANCHORS[label.anchor[0]]}">{markup(label.text)}</text>'
    )


def _points(points: Floats) -> str:
    return " ".join(f"{x:.2f},{y:.2f}" for x, y in points)


def _hex(colour: tuple[int, int, int]) -> str:
    return "#{:02x}{:02x}{:02x}".format(*colour)
