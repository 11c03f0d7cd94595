"""Pictures of a layout for reports and review pages, made without a display.

`render` draws one character with its elements from several sides, `film` the same at many poses,
`contact_sheet` puts many pictures on one page.  The same input gives the same pixels.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from PIL import Image, ImageDraw

from usdrigui import palette
from usdrigui.errors import refuse
from usdrigui.model import Element, Floats, Layout, Rig, RigMesh
from usdrigui.pose.evaluate import PosedLayout, evaluate, prepare
from usdrigui.view import directions, lettering, overlay, shading
from usdrigui.view.complexion import complexion
from usdrigui.view.sections import cut_away, main_layout, sections
from usdrigui.view.shading import Camera, Complexion, Subject

VIEWS = {
    "front": 0.0,
    "left34": directions.TURN,
    "right34": -directions.TURN,
    "left": 90.0,
    "right": -90.0,
    "back": 180.0,
}
"""Degrees about the up axis from `LayoutFrame.view` toward the character's own left: ``front`` is
the view that the layout was made for, whichever that is.  Captions name the view."""

_TITLE, _CAPTION, _LEGEND, _GAP, _EDGE = 66, 24, 42, 14, 22
"""Heights of the title above the panels, of captions and legend below, space between panels and
around, in pixels."""
_MARGIN = np.array([0.14, 0.20])
"""Space around the elements on the face, to the sides and up and down, as a share of their
extent."""
_SIDE = 0.1
"""Space at the side of a head, in heights of the elements' frame."""
_FAR = 0.6
"""How far beyond the elements' frame the head may go on to be drawn whole, in heights of that
frame."""
_HEADROOM = 34.0
"""Space above a board for its heading, in pixels."""
_ON_BOARD = 9.0
"""Width of a handle on the board, in pixels, at which its rows take names in full size."""
_LEAST_FRAME = 22.0
"""Least extent of a frame, in handle widths."""
_TOP, _BOTTOM = np.array([0.962, 0.966, 0.972]), np.array([0.862, 0.872, 0.884])
"""Background of the panels."""
_FADE = 0.07
"""Share of a panel's height above its lower edge in which the body fades."""
_BETWEEN = "   ·   "
_PAPER, _INK, _QUIET = (250, 250, 251), (38, 42, 48), (104, 110, 120)


def render(
    rig: Rig,
    layout: Layout,
    values: ArrayLike | None = None,
    views: Sequence[str] | None = None,
    size: tuple[int, int] = (1800, 1000),
    labels: bool = False,
    title: str = "",
) -> Image.Image:
    """Picture of a character and its layout, RGB, of ``size`` (width, height) pixels; higher where
    there is a board.

    A character in several parts has a close-up of that size for each part, one below the other,
    unless ``views`` are given. ``values`` (controls,) is the pose, by default the layout's base
    pose.  ``views`` are some of `VIEWS`; by default the view that the layout was made for, and of
    front and three-quarter views the nearest two that show what it sees.  The board has a panel of
    its own below, as high as it needs, with the names of its elements; ``labels`` names those on
    the character, too, in the layout's own view.  Raises RigUIError CONFIG_VALUE for an unknown
    view or a size below 320 x 240, LAYOUT_STALE when the layout does not belong to the rig,
    POSE_VALUE for a pose that is not one.
    """
    _check(views, size)
    posed = evaluate(prepare(rig, layout), values)
    if views is not None or len(layout.frame.parts) < 2:
        return _page(
            rig, layout, posed, _set_up(rig, layout, posed, views, size, labels), size, title
        )
    pages, colours = [], complexion(rig, main_layout(layout))
    for each in sections(layout, posed, rig.skel_root.up):
        own = cut_away(rig, each.layout, colours)
        scene = _set_up(rig, each.layout, each.posed, each.views or None, size, labels, own)
        name = title or rig.skel_root.path.strip("/") or "character"
        held = len(each.layout.controls)
        pages.append(
            _page(rig, each.layout, each.posed, scene, size, f"{name}: {each.title}", held)
        )
    return _stacked(pages)


def film(
    rig: Rig,
    layout: Layout,
    poses: ArrayLike,
    views: Sequence[str] = ("front",),
    size: tuple[int, int] = (760, 820),
    title: str = "",
) -> Iterator[Image.Image]:
    """One picture per row of ``poses`` (frames, controls), all framed as the base pose is; raises
    as `render`."""
    _check(views, size)
    poser = prepare(rig, layout)
    scene = _set_up(rig, layout, evaluate(poser), views, size, False)
    for values in np.asarray(poses, dtype=np.float64):
        yield _page(rig, layout, evaluate(poser, values), scene, size, title)


@dataclass(frozen=True)
class _Scene:
    """The panels of a page with their cameras and upper left corners."""

    panels: tuple[_Framed, ...]
    cameras: tuple[Camera, ...]
    corners: tuple[tuple[int, int], ...]
    complexion: Complexion


def _stacked(pages: Sequence[Image.Image]) -> Image.Image:
    """Pages below each other."""
    whole = Image.new("RGB", (pages[0].width, sum(page.height for page in pages)), _PAPER)
    for number, page in enumerate(pages):
        whole.paste(page, (0, sum(each.height for each in pages[:number])))
    return whole


def _set_up(
    rig: Rig,
    layout: Layout,
    posed: PosedLayout,
    views: Sequence[str] | Sequence[Floats] | None,
    size: tuple[int, int],
    labels: bool,
    colours: Complexion | None = None,
) -> _Scene:
    """Panels for ``views``, names or directions, or by default for the layout's own view and its
    companions.

    ``colours`` are by default those that the layout's own main part shows.
    """
    colours = colours or complexion(rig, main_layout(layout))
    up, own_view = rig.skel_root.up, layout.frame.view
    skin = _skin(rig.body.meshes, posed, colours)
    ahead = directions.ahead_of(rig, layout.frame.plane.normal, layout.character.base_values)
    if views is None:
        shown = [
            (own_view, True),
            *((each, False) for each in directions.companions(own_view, ahead, up)),
        ]
    else:
        azimuths = [VIEWS[view] if isinstance(view, str) else None for view in views]
        shown = [
            (
                (directions.turned(own_view, up, at), at == 0.0)
                if at is not None
                else (np.asarray(view), i == 0)
            )
            for i, (view, at) in enumerate(zip(views, azimuths, strict=True))
        ]
    panels: list[_Framed] = []
    boards: list[_Framed] = []
    for at, own in shown:
        rows = shading.look(at, up)
        panels.append(
            _framed(
                layout,
                posed,
                skin,
                rows,
                directions.caption(at, ahead, up),
                own,
                own and labels,
            )
        )
        if own and any(element.anchor.on_board for element in layout.elements):
            boards.append(_framed_board(layout.elements, layout.frame.handle_width, posed, rows))
    panels += boards
    cameras, corners = _arranged(panels, size)
    return _Scene(
        tuple(panels),
        tuple(cameras),
        tuple(corners),
        colours,
    )


def _page(
    rig: Rig,
    layout: Layout,
    posed: PosedLayout,
    scene: _Scene,
    size: tuple[int, int],
    title: str,
    controls: int | None = None,
) -> Image.Image:
    """One page; ``controls`` is their number in the title, by default that of the rig."""
    subject = shading.subject_of(rig.body.meshes, posed.points, scene.complexion)
    below = sum(
        camera.height + _CAPTION
        for panel, camera in zip(scene.panels, scene.cameras, strict=True)
        if panel.board
    )
    page = Image.new("RGB", (size[0], size[1] + below), _PAPER)
    for panel, camera, corner in zip(scene.panels, scene.cameras, scene.corners, strict=True):
        page.paste(_panel(subject, layout, posed, panel, camera), corner)
        middle = (corner[0] + camera.width / 2, corner[1] + camera.height + _CAPTION / 2)
        type_ = lettering.font(13)
        caption = lettering.cut(panel.caption, type_, float(camera.width))
        ImageDraw.Draw(page).text(middle, caption, fill=_QUIET, font=type_, anchor="mm")
    _title(
        page,
        title or rig.skel_root.path.strip("/") or "character",
        _numbers(controls or len(rig.controls), layout, size[0] - 2 * _EDGE),
    )
    _legend(page, layout.elements)
    return page


def contact_sheet(
    images: Sequence[Image.Image], titles: Sequence[str] = (), columns: int = 2, width: int = 1800
) -> Image.Image:
    """All ``images`` on one page of ``width`` pixels, in rows of ``columns``, each over its title
    if there are any.

    Raises ValueError when there are no images or not one title for each.
    """
    if not images or len(titles) not in (0, len(images)):
        raise ValueError(
            f"{len(images)} images and {len(titles)} titles do not make a contact sheet"
        )
    columns = min(columns, len(images))
    cell = (width - _GAP * (columns + 1)) // columns
    small = [
        each.resize(
            (cell, max(1, round(each.height * cell / each.width))), Image.Resampling.LANCZOS
        )
        for each in images
    ]
    rows = [small[start : start + columns] for start in range(0, len(small), columns)]
    heights = [max(each.height for each in row) + (26 if titles else 0) for row in rows]
    page = Image.new("RGB", (width, sum(heights) + _GAP * (len(rows) + 1)), _PAPER)
    pen = ImageDraw.Draw(page)
    top = _GAP
    for number, (row, height) in enumerate(zip(rows, heights, strict=True)):
        for column, each in enumerate(row):
            left = _GAP + column * (cell + _GAP)
            page.paste(each, (left, top))
            if titles:
                text = lettering.legible(titles[number * columns + column])
                pen.text(
                    (left + 2, top + each.height + 5),
                    text,
                    fill=_INK,
                    font=lettering.font(14, titles[number * columns + column]),
                )
        top += height + _GAP
    return page


@dataclass(frozen=True)
class _Framed:
    """What one panel shows, before the scale is known."""

    caption: str
    """What the view is called."""
    rows: Floats
    low: Floats
    """(2,) lower left corner of the frame along the rows' right and up, scene units."""
    high: Floats
    columns: tuple[float, float] = (0.0, 0.0)
    """Pixels kept free on the left and on the right for names."""
    labels: bool = False
    board: float = 0.0
    """Pixels a scene unit at which names have their full size, of the panel that shows the board
    alone; else 0."""


# --- arrangement ----------------------------------------------------------------------------------


def _check(views: Sequence[str] | None, size: tuple[int, int]) -> None:
    if views is not None and (not views or any(view not in VIEWS for view in views)):
        raise refuse(
            "CONFIG_VALUE",
            "views",
            f"expected some of {', '.join(VIEWS)}, got {', '.join(views) or 'none'}",
        )
    if size[0] < 320 or size[1] < 240:
        raise refuse(
            "CONFIG_VALUE", "size", f"a picture of {size[0]} x {size[1]} pixels is too small"
        )


def _skin(meshes: tuple[RigMesh, ...], posed: PosedLayout, colours: Complexion) -> Floats:
    """(m, 3) the points that are drawn; all finite ones if no triangle is."""
    seen = np.unique(shading.drawn(meshes, posed.points, colours))
    points = posed.points[seen] if len(seen) else posed.points
    return np.asarray(points[np.isfinite(points).all(axis=1)])


def _framed(
    layout: Layout,
    posed: PosedLayout,
    skin: Floats,
    rows: Floats,
    caption: str,
    own: bool,
    labels: bool,
) -> _Framed:
    """The rectangle around the elements on the character and the head (`skin`, (m, 3)), with a
    margin.

    ``rows`` are those of the camera; the layout's ``own`` view is broader.
    """
    placed = zip(layout.elements, posed.elements, strict=True)
    tracks = [track for each, at in placed if not each.anchor.on_board for track in at.tracks]
    low, high = bare = _extent(tracks or [skin], rows)
    middle, half = 0.5 * (low + high), 0.5 * (high - low)
    half = np.maximum(half * (1.0 + 2.0 * _MARGIN), 0.5 * _LEAST_FRAME * layout.frame.handle_width)
    half[0] = max(half[0], (0.85 if own else 0.72) * half[1])
    low, high = _around_head(middle - half, middle + half, bare, skin @ rows[:2].T)
    names = [each.look.label for each in layout.elements if labels and not each.anchor.on_board]
    wide = min(lettering.widest(names), lettering.CALLED) + 16.0 if names else 0.0
    return _Framed(caption, rows, low, high, (wide, wide), labels)


def _framed_board(
    elements: tuple[Element, ...], handle_width: float, posed: PosedLayout, rows: Floats
) -> _Framed:
    """The rectangle around the board, with room for the names to its right."""
    placed = zip(elements, posed.elements, strict=True)
    drawn = [at for each, at in placed if each.anchor.on_board]
    low, high = _extent(
        [line for at in drawn for line in (*at.tracks, at.glyph) if len(line)], rows
    )
    pad = 1.5 * handle_width
    names = lettering.widest([each.look.label for each in elements if each.anchor.on_board]) + 6.0
    return _Framed(
        "board", rows, low - pad, high + pad, (0.0, names), False, _ON_BOARD / handle_width
    )


def _around_head(
    low: Floats, high: Floats, elements: tuple[Floats, Floats], across: Floats
) -> tuple[Floats, Floats]:
    """A frame widened to both sides of the head, of points (m, 2), level with the box of the
    elements, raised to its crown and lowered to its chin.

    A side of which more lies farther off than `_FAR` stays as it is: it is a body, or an arm, and
    the face would get small.
    """
    reach, pad = _FAR * (high - low)[1], _SIDE * (high - low)[1]
    wide_low, wide_high = low.copy(), high.copy()
    level = across[(across[:, 1] >= elements[0][1]) & (across[:, 1] <= elements[1][1])]
    inner = across[(across[:, 0] >= elements[0][0]) & (across[:, 0] <= elements[1][0])]
    for axis, points in ((0, level), (1, inner)):
        first = points[:, axis].min(initial=elements[0][axis])
        last = points[:, axis].max(initial=elements[1][axis])
        if first - pad < low[axis] and first > low[axis] - reach:
            wide_low[axis] = first - pad
        if last + pad > high[axis] and last < high[axis] + reach:
            wide_high[axis] = last + pad
    return wide_low, wide_high


def _extent(lines: Sequence[Floats], rows: Floats) -> tuple[Floats, Floats]:
    """Corners (2,) of the box in the view's plane around lines of points (k, 3)."""
    across = np.concatenate(lines) @ rows[:2].T
    return across.min(axis=0), across.max(axis=0)


def _arranged(
    panels: Sequence[_Framed], size: tuple[int, int]
) -> tuple[list[Camera], list[tuple[int, int]]]:
    """One scale for all panels, their cameras, and where each goes on the page; boards go below the
    others."""
    boards = [panel for panel in panels if panel.board]
    panels = [panel for panel in panels if not panel.board]
    low = min(float(panel.low[1]) for panel in panels)
    high = max(float(panel.high[1]) for panel in panels)
    height = size[1] - _TITLE - _CAPTION - _LEGEND
    names = sum(sum(panel.columns) for panel in panels)
    free = size[0] - 2 * _EDGE - _GAP * (len(panels) - 1) - names
    wide = sum(float(panel.high[0] - panel.low[0]) for panel in panels)
    scale = max(min(height / (high - low), max(free, 0.3 * size[0]) / wide), 1e-12)
    widths = [
        round(scale * float(panel.high[0] - panel.low[0]) + sum(panel.columns)) for panel in panels
    ]
    # Space that is left over widens the panels: more of the character is better than a broad
    # border.
    spare = (size[0] - 2 * _EDGE - _GAP * (len(panels) - 1) - sum(widths)) // len(panels)
    widths = [width + max(spare, 0) for width in widths]
    left, top = (size[0] - sum(widths) - _GAP * (len(panels) - 1)) // 2, _TITLE
    cameras, corners = [], []
    for panel, width in zip(panels, widths, strict=True):
        middle = np.array([0.5 * (panel.low[0] + panel.high[0]), 0.5 * (low + high)])
        cameras.append(Camera(panel.rows, middle @ panel.rows[:2], scale, width, height))
        corners.append((left, top))
        left += width + _GAP
    for board in boards:
        top += height + _CAPTION
        cameras.append(_board_camera(board, size[0] - 2 * _EDGE))
        corners.append((_EDGE, top))
        height = cameras[-1].height
    return cameras, corners


def _board_camera(board: _Framed, width: int) -> Camera:
    """The camera of a board that begins at the left of a panel, below the room for its headings."""
    across, tall = (board.high - board.low).tolist()
    scale = min(board.board, max(width - sum(board.columns), 0.3 * width) / across)
    height = round(scale * tall + _HEADROOM)
    middle = np.array(
        [board.low[0] + 0.5 * width / scale, board.high[1] + (_HEADROOM - 0.5 * height) / scale]
    )
    return Camera(board.rows, middle @ board.rows[:2], scale, width, height)


# --- one panel ------------------------------------------------------------------------------------


def _panel(
    subject: Subject, layout: Layout, posed: PosedLayout, panel: _Framed, camera: Camera
) -> Image.Image:
    shaded = shading.empty(camera) if panel.board else shading.shade(subject, camera)
    picture, width = _developed(shaded), layout.frame.handle_width_of
    shown = [
        (element, overlay.mark(element, at, camera, shaded.depth, width(element.placement.part)))
        for element, at in zip(layout.elements, posed.elements, strict=True)
        if element.anchor.on_board == bool(panel.board)
    ]
    if panel.labels:
        picture = lettering.call_out(picture, shown)
    picture = overlay.draw(picture, [drawn for _, drawn in shown])
    if panel.board:
        lettering.name_on_board(picture, shown)
    return picture


def _developed(shaded: shading.Shaded) -> Image.Image:
    """Linear light to an sRGB picture over the background."""
    down = np.linspace(0.0, 1.0, len(shaded.depth))[:, None, None]
    behind = (1.0 - down) * _TOP + down * _BOTTOM
    # The body goes on below the picture: it fades out there, and no sleeve stands cut on the edge.
    cover = (shaded.cover * np.clip((1.0 - down[..., 0]) / _FADE, 0.0, 1.0))[..., None]
    mixed = cover * shading.encoded(shaded.colour) + (1.0 - cover) * behind
    return Image.fromarray((255.0 * mixed).round().astype(np.uint8), "RGB")


# --- title and legend -----------------------------------------------------------------------------


def _numbers(controls: int, layout: Layout, width: float) -> str:
    """What the layout of so many controls holds, as far as it goes into a line of so many
    pixels."""
    on_face = sum(not element.anchor.on_board for element in layout.elements)
    board = len(layout.elements) - on_face
    held = {part for part in (element.placement.part for element in layout.elements) if part}
    place = held.pop() if len(held) == 1 else "character" if held else "face"
    parts = [f"{controls} control{'s' * (controls != 1)}"]
    parts += [f"{on_face} elements on the {place}"] if on_face or not board else []
    parts += [f"{board} on the board"] if board else []
    parts += [f"{len(layout.left_off)} left off"] if layout.left_off else []
    proof = layout.proof
    if np.isfinite(proof.bound) and np.isfinite(proof.cost):
        gap = max(0.0, proof.cost - proof.bound) / max(abs(proof.cost), 1e-12)
        parts.append(f"cost {proof.cost:.4g}, {proof.status} at gap {gap:.2g} of the cost")
    font = lettering.font(14)
    while len(parts) > 1 and font.getlength(_BETWEEN.join(parts)) > width:
        parts.pop()
    return _BETWEEN.join(parts)


def _title(page: Image.Image, title: str, numbers: str) -> None:
    pen = ImageDraw.Draw(page)
    pen.text((_EDGE, 12), lettering.legible(title), fill=_INK, font=lettering.font(25, title))
    pen.text((_EDGE, 43), numbers, fill=_QUIET, font=lettering.font(14))


def _legend(page: Image.Image, elements: tuple[Element, ...]) -> None:
    """Colours by side and forms by kind, of what the layout holds."""
    pen, font = ImageDraw.Draw(page), lettering.font(13)
    x, y = float(_EDGE + 8), page.height - _LEGEND / 2
    for form, colour, text, coarse in _legend_entries(elements):
        if x + 15 + font.getlength(text) > page.width - _EDGE:
            break  # a narrow page explains the colours first
        overlay.paste_knob(page, form, colour, 5.5 if coarse else 7.5, (x, y), coarse)
        pen.text((x + 15, y), text, fill=_QUIET, font=font, anchor="lm")
        x += 15 + font.getlength(text) + 30
    note = "faint: hidden by the character"
    if x + font.getlength(note) + _EDGE < page.width:
        pen.text((page.width - _EDGE, y), note, fill=_QUIET, font=font, anchor="rm")


def _legend_entries(elements: Sequence[Element]) -> list[tuple[str, palette.Colour, str, bool]]:
    used = {"board" if each.anchor.on_board else each.look.side for each in elements}
    names = {
        "left": "character's left",
        "right": "character's right",
        "middle": "middle",
        "none": "no side",
    }
    if "board" in used:
        names |= {"none": "no side, board" if "none" in used else "board"}
        used = used - {"board"} | {"none"}
    colours = palette.SIDES
    entries = [
        ("slider", colours[side], text, False) for side, text in names.items() if side in used
    ]
    forms = {overlay.form_of(each.manipulator) for each in elements}
    grey = (128, 134, 142)
    if forms != {"slider"}:
        entries += [
            (form, grey, text, False) for form, text in overlay.FORMS.items() if form in forms
        ]
    if any(each.look.inner for each in elements):
        entries.append(("slider", grey, "coarse: opens into finer ones", True))
    return entries
