"""Which elements can be read and grabbed at a glance, from the layout alone.

A part is seen from its own view, what is drawn of it 640 pixels tall: what a face gets on a screen
of 1366 x 768.  An element is clear if no other handle is within a pointer's width of its own and
none is on its track, if its track neither crosses another one nor runs along it, and if it is long
enough for a hand.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from scipy.spatial.distance import cdist

from usdrigui.character import Flags, Floats, Indices
from usdrigui.layout.face import Face
from usdrigui.model import Element, Legibility
from usdrigui.model.levels import inner_names
from usdrigui.overlap import SAME_WAY, segment_distances, segments_cross

SCREEN_HEIGHT = 640.0
"""Pixels."""
_WIDEST = 1.25
"""Width over height up to which a part fills the height."""
_POINTER = 14.0
"""Pixels between two handles under which a pointer may take the other one."""
_ON_TRACK = 5.0
_ALONG = 4.0
_ALONG_SHARE = 1.0 / 3.0
"""Share of a track that runs along another one."""
_SHORTEST = 12.0


def legibility(elements: tuple[Element, ...], axes: Floats) -> Legibility:
    """How clear the elements of a part are that are drawn on the skin; `axes` (2, 3) are unit
    vectors to the right and up as its viewer sees them."""
    shown = first_level(elements)
    if not shown:
        return Legibility(0, ())
    found: dict[str, list[str]] = {}
    for element, reason in _obstacles(shown, axes):
        found.setdefault(shown[element].name, []).append(reason)
    return Legibility(len(shown), tuple((name, ", ".join(whys)) for name, whys in found.items()))


def legibility_of(face: Face, elements: tuple[Element, ...]) -> Legibility:
    """The same of the elements of a part on its face; of a part whose elements are measured in
    space none is judged, and of one that is looked at side by side only the left."""
    if face.each_side:
        plane = face.symmetry.plane
        elements = tuple(e for e in elements if plane.distance(e.anchor.position) >= 0.0)
    return legibility(elements, face.drawing_axes) if face.flat else Legibility(0, ())


def first_level(elements: Sequence[Element]) -> list[Element]:
    """The elements that are drawn on the skin before any of them is opened."""
    inner = inner_names(elements)
    return [e for e in elements if e.name not in inner and not e.anchor.on_board]


def on_screen(shown: Sequence[Element], axes: Floats) -> tuple[Floats, list[Floats], Floats, float]:
    """Handles (n, 2), the track (k, 2) of every member in order and its length, in pixels of the
    screen `axes` (2, 3), and the pixels of a unit."""
    tracks = [member.track @ axes.T for each in shown for member in each.members]
    handles = np.stack([each.anchor.position for each in shown]) @ axes.T
    size = np.ptp(np.concatenate([handles, *tracks]), axis=0)
    pixels = SCREEN_HEIGHT / max(size[1], size[0] / _WIDEST, 1e-300)
    tracks = [track * pixels for track in tracks]
    lengths = np.array([np.linalg.norm(np.diff(each, axis=0), axis=1).sum() for each in tracks])
    return handles * pixels, tracks, lengths, float(pixels)


def _obstacles(shown: list[Element], axes: Floats) -> Iterator[tuple[int, str]]:
    """The index of an element, and what is in its way; of the screen `axes` (2, 3)."""
    handles, tracks, lengths, _ = on_screen(shown, axes)
    owner = np.repeat(np.arange(len(shown)), [len(each.members) for each in shown])
    longest = np.zeros(len(shown))
    np.maximum.at(longest, owner, lengths)
    names = [each.name for each in shown]
    apart = cdist(handles, handles)
    np.fill_diagonal(apart, np.inf)
    for one, other in np.argwhere(apart < _POINTER).tolist():
        yield one, f"its handle is {apart[one, other]:.0f} px from that of {names[other]}"
    for one in np.flatnonzero(longest < _SHORTEST).tolist():
        yield one, f"its track is {longest[one]:.0f} px long"
    starts, ends, of_track = _pieces(tracks)
    of_piece = owner[of_track]
    gaps = segment_distances(handles.T[None], starts[..., None], ends[..., None])
    for one, other in _pairs(gaps < _ON_TRACK, of_piece, np.arange(len(shown))):
        yield one, f"the handle of {names[other]} is on its track"
    crossing: Flags = segments_cross(
        *(each[:, None, :, None] for each in (starts, ends)),
        *(each[None, :, :, None] for each in (starts, ends)),
    )[..., 0]
    for one, other in _pairs(crossing, of_piece, of_piece):
        yield one, f"its track crosses that of {names[other]}"
    for one, other in _running_along(starts, ends, of_track):
        if owner[one] != owner[other]:
            yield int(owner[one]), f"its track runs along that of {names[owner[other]]}"


def _pieces(tracks: list[Floats]) -> tuple[Floats, Floats, Indices]:
    """Starts (s, 2) and ends of the segments of all tracks, and the track of each."""
    of_track = np.repeat(np.arange(len(tracks)), [len(each) - 1 for each in tracks])
    starts = np.concatenate([track[:-1] for track in tracks])
    return starts, np.concatenate([track[1:] for track in tracks]), of_track


def _pairs(meets: Flags, rows: Indices, columns: Indices) -> list[tuple[int, int]]:
    """Pairs of different elements that meet: `rows` and `columns` tell whose `meets` is."""
    first, second = np.nonzero(meets)
    pairs = {(int(rows[i]), int(columns[j])) for i, j in zip(first, second, strict=True)}
    return sorted((one, other) for one, other in pairs if one != other)


def _running_along(starts: Floats, ends: Floats, of_track: Indices) -> list[tuple[int, int]]:
    """Pairs of tracks of which more than a third of the first runs along the second; of their
    pieces."""
    steps = ends - starts
    lengths = np.linalg.norm(steps, axis=1)
    counts = np.maximum(np.ceil(lengths).astype(np.int64), 1)
    piece = np.repeat(np.arange(len(starts)), counts)
    share = np.concatenate([(np.arange(count) + 0.5) / count for count in counts])
    points = starts[piece] + share[:, None] * steps[piece]
    alike = np.abs(steps @ steps.T) >= SAME_WAY * np.outer(lengths, lengths)
    of_point = of_track[piece]
    many = np.bincount(of_point)
    found = []
    for other in range(len(many)):
        mine = of_track == other
        gaps = segment_distances(points.T[None], starts[mine, :, None], ends[mine, :, None])
        beside = (gaps < _ALONG) & alike[mine][:, piece]
        along = np.bincount(of_point[beside.any(axis=0)], minlength=len(many))
        found += [(one, other) for one in np.flatnonzero(along > _ALONG_SHARE * many).tolist()]
    return found
