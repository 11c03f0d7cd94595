"""Colours to judge a face by: those of the asset, and for what has none skin, eyes with pupils,
lips and teeth.

Where the asset has no colour, the layout tells what is what.  Skin is the piece of surface that
bears the elements of the face or lies behind what bears them; the piece that a gaze control turns
is an eye; a card before the skin is of the colour of the region that its controls move.  Form tells
the rest: where the skin faces itself among the elements of the mouth are the lips.  The layout is
not changed by any of this.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse.csgraph import connected_components
from scipy.spatial import KDTree

from usdrigui.character import Flags, Floats, Indices, Record, Rig, RigMesh
from usdrigui.character.deform import Posed, posed, sweep
from usdrigui.character.surface import components, graph, mesh_triangles, vertex_normals, weld
from usdrigui.conventions import Action, meanings
from usdrigui.model import Element, Layout
from usdrigui.view.body.shading import (
    EYE,
    IRIS,
    SKIN,
    Complexion,
    openness,
    smooth_step,
    subject_of,
    turns,
)
from usdrigui.view.directions import camera_rows

_TRIM, _TEETH, _GUMS, _HAIR = (
    (0.66, 0.63, 0.60),
    (0.80, 0.76, 0.68),
    (0.52, 0.20, 0.19),
    (0.07, 0.045, 0.03),
)
_LIPS, _BROWS, _BLUSH = (0.43, 0.17, 0.15), (0.12, 0.075, 0.05), (0.60, 0.33, 0.27)
_NAMED = (
    (re.compile(r"teeth|tooth|denture", re.IGNORECASE), _TEETH),
    (re.compile(r"tongue|gum", re.IGNORECASE), _GUMS),
    (re.compile(r"lash|brow|hair|beard|moustache", re.IGNORECASE), _HAIR),
)
"""Colours of meshes by a word of their name; numbers are linear light."""
_CARDS = {"brow": _BROWS, "eye": _HAIR, "gaze": _HAIR}
"""Colours of what lies on the skin, by the region that its controls move; of any other region it is
of the lips' colour."""
_LASH = re.compile(r"lash", re.IGNORECASE)
"""Lashes are cards that a texture cuts out: without one they are bands around the eyes, and left
out."""

_BEFORE = 0.12
"""How far before the skin a card lies at most, in the larger extent of the elements' box."""
_TURNED = 0.5
"""Share of a piece that the gaze moves more than half as far as anything."""
_ABOUT = 0.65
"""How far the elements of an eye are from its middle at most, in its width and height."""
_MAX_EYE = 0.5
"""Width of an eye at most, in the extent of all elements."""
_MOUTH = ("mouth", "mouthCorner", "upperLip", "lowerLip")
_FLAT = 3.0
"""Radius by which an eye is a card, in half widths of it: its iris fills it."""
_SHELL = 1.6
"""What lies within so many radii of an eye's centre lies over the eye: tears, corneas, shadows of
lids."""
_LIP_STEP = 0.028
"""Half of the gap between lips that touch, at most, in the extent of all elements."""


@dataclass(frozen=True)
class _Eye:
    centre: Floats
    radius: float
    piece: int


class _Face(Record):
    """The character at rest in its layout's view: x to the right, y up, z toward the viewer."""

    at: Floats
    """(n, 3)."""
    normals: Floats
    corners: Indices
    """(t, 3) of the visible surface."""
    pieces: Indices
    """(n,) connected piece of the visible surface, -1 for points of none."""
    sheets: Indices
    """(n,) as `pieces`, but of points that share triangles, whatever else lies where they lie."""
    free: Flags
    """(n,) visible points whose mesh has no colour, neither by values nor by its name."""
    anchors: Indices
    """(k,) points of the elements on the face."""
    regions: tuple[str, ...]
    """(k,) what the controls of each move, or an empty word."""
    middle: float
    """x of the mid-plane."""

    @property
    def extent(self) -> float:
        """The larger side of the box of the elements."""
        return float(np.ptp(self.at[self.anchors, :2], axis=0).max())

    def pierced(self, at: Floats) -> set[int]:
        """Pieces that the line of sight through a place (3,) meets not far behind it."""
        depth = self.at[self.corners, 2].mean(axis=1)
        near = self.corners[(depth < at[2]) & (depth > at[2] - _BEFORE * self.extent)]
        return set(self.pieces[near[_crossed(self.at[near, :2] - at[:2]), 0]].tolist())

    def eye(self, piece: int) -> _Eye:
        """The ball that fits a piece in the least-squares sense; of a flat one its middle, and a
        radius by which its iris fills it."""
        at = self.at[self.pieces == piece]
        low, high = at.min(axis=0), at.max(axis=0)
        system = np.hstack([2.0 * (at - low), np.ones((len(at), 1))])
        fit = np.linalg.lstsq(system, ((at - low) ** 2).sum(axis=1), rcond=None)[0]
        radius = float(np.sqrt(max(fit[3] + fit[:3] @ fit[:3], 0.0)))
        half = 0.5 * float((high - low)[:2].max())
        if radius > _FLAT * half:
            return _Eye(0.5 * (low + high) - [0.0, 0.0, half / IRIS], half / IRIS, piece)
        return _Eye(low + fit[:3], radius, piece)


def complexion(rig: Rig, layout: Layout) -> Complexion:
    """Colours of a character in the base pose of its layout, and the shade there."""
    start = posed(rig, layout.base_values)
    coloured = _coloured(rig, layout, start)
    return replace(coloured, open=openness(subject_of(rig.body.meshes, start.points, coloured)))


def _coloured(rig: Rig, layout: Layout, start: Posed) -> Complexion:
    """The colours, without shade."""
    colours, clear = _of_meshes(rig.body.meshes)
    gaze, everywhere = np.full((len(colours), 2), 9.0), np.ones(len(colours))
    actions = _actions(rig)
    face = _face(rig, layout, start, actions)
    if face is None:
        return Complexion(colours, gaze, clear, everywhere)
    turned = _turned(rig, layout, start, face, actions)
    main = _main_piece(face, turned)
    eyes = [face.eye(piece) for piece in sorted(turned)] or _eyes_by_region(face, main)
    cards, bearing = _cards(face, main, turned | {eye.piece for eye in eyes})
    skin = face.free & np.isin(face.pieces, list(bearing))
    colours[face.free & ~skin] = _TRIM
    for piece, colour in cards.items():
        colours[face.free & (face.pieces == piece)] = colour
    for eye in eyes:
        on, over = _on_eye(face, eye)
        gaze[on], clear[over] = _directions(face.at[on] - eye.centre, eye.radius), True
        colours[on] = EYE["white"]
    line = _mouth_line(face, skin)
    if line is not None:
        lips, behind = _mouth(face, line)
        colours += (lips * skin)[:, None] * (np.array(_LIPS) - colours)
        inside = behind & face.free & ~skin & (gaze[:, 0] > 2.0)
        colours[inside] = _TEETH
        largest = np.bincount(face.pieces[inside]).argmax() if inside.any() else -1
        colours[inside & (face.pieces == largest)] = _GUMS
    return Complexion(colours, gaze, clear, everywhere)


def _of_meshes(meshes: tuple[RigMesh, ...]) -> tuple[Floats, Flags]:
    """(n, 3) the colours that meshes have, or the usual ones of the things that they name; (n,)
    what is left out for want of a colour."""
    colours, clear = [np.zeros((0, 3))], [np.zeros(0, dtype=bool)]
    for mesh in meshes:
        count, own = len(mesh.points), mesh.colours
        usual = np.tile(np.array(_usual(mesh) or SKIN), (count, 1))
        colours.append(usual if own is None else np.asarray(own))
        clear.append(np.full(count, own is None and _LASH.search(_name(mesh)) is not None))
    return np.concatenate(colours), np.concatenate(clear)


def _name(mesh: RigMesh) -> str:
    return mesh.path.rsplit("/", 1)[-1]


def _usual(mesh: RigMesh) -> tuple[float, float, float] | None:
    """The colour of the thing that a mesh names."""
    return next((colour for word, colour in _NAMED if word.search(_name(mesh))), None)


def _face(rig: Rig, layout: Layout, start: Posed, actions: Mapping[str, Action]) -> _Face | None:
    """None where no point is left to be coloured."""
    body, elements = rig.body, _on_face(layout)
    plain = [mesh.colours is None and _usual(mesh) is None for mesh in body.meshes]
    free = np.repeat(np.array(plain, dtype=bool), np.diff(body.starts))
    corners = mesh_triangles(body.meshes, visible_only=True)
    anchors = [each.anchor.on(body) for each in elements]
    if not free.any() or not len(corners) or not anchors:
        return None
    rows = camera_rows(layout, rig.up)
    points = np.where(np.isfinite(start.points), start.points, 0.0)
    places = weld(points)
    used = np.isin(np.arange(len(points)), corners)
    acts = [actions.get(element.members[0].control) for element in elements]
    return _Face(
        at=points @ rows.T,
        normals=vertex_normals(points, corners, places) @ rows.T,
        corners=corners,
        pieces=np.where(used, components(corners, places), -1),
        sheets=np.where(used, components(corners, np.arange(len(points))), -1),
        free=free & used,
        anchors=np.array(anchors),
        regions=tuple("" if act is None else act.region for act in acts),
        middle=float(layout.frame.plane.origin @ rows[0]),
    )


def _on_face(layout: Layout) -> list[Element]:
    """The elements of the first part, which is the face where there is one, that are not on the
    board."""
    main = [part.name for part in layout.frame.parts[:1]]
    return [
        element
        for element in layout.elements
        if not (element.anchor.on_board or (main and element.part not in main))
    ]


def _actions(rig: Rig) -> Mapping[str, Action]:
    """What controls do by their names, as far as these have a known meaning."""
    read = zip(rig.control_names, meanings(rig.control_names), strict=True)
    return {name: meaning.action for name, meaning in read if meaning is not None}


# --- skin and what lies on it ---------------------------------------------------------------------


def _main_piece(face: _Face, eyes: set[int]) -> int:
    """The piece that bears most elements of the face, or lies behind those that do."""
    own, free = face.pieces[face.anchors], set(face.pieces[face.free].tolist()) - eyes
    votes = Counter(own.tolist())
    for anchor, piece in zip(face.anchors, own, strict=True) if len(votes) > 1 else ():
        votes.update(face.pierced(face.at[anchor]) - {int(piece)})
    return max(sorted(free), key=lambda piece: votes[piece], default=-1)


def _crossed(flat: Floats) -> Flags:
    """(t,) triangles (t, 3, 2) that hold the origin."""
    areas = turns(flat)
    return np.asarray((areas >= 0.0).all(axis=1) | (areas <= 0.0).all(axis=1))


def _cards(
    face: _Face, main: int, eyes: set[int]
) -> tuple[dict[int, tuple[float, float, float]], set[int]]:
    """The colour of each piece before the main one, and the pieces of skin: the main one and
    what else bears elements."""
    cards, skin = {}, {main}
    own = face.pieces[face.anchors]
    for piece in set(face.pieces[face.free].tolist()) - eyes - {main}:
        on, at = np.flatnonzero(own == piece), face.at[face.pieces == piece]
        places = at.mean(axis=0)[None] if not len(on) else face.at[face.anchors[on]]
        if all(main in face.pierced(place) for place in places):
            region = Counter(face.regions[i] for i in on).most_common(1)
            cards[piece] = _CARDS.get(region[0][0], _LIPS) if region else _BLUSH
        elif len(on):
            skin.add(piece)
    return cards, skin


# --- eyes -----------------------------------------------------------------------------------------


def _turned(
    rig: Rig, layout: Layout, start: Posed, face: _Face, actions: Mapping[str, Action]
) -> set[int]:
    """Pieces that the controls of a gaze turn as wholes."""
    gazing = {name for name, action in actions.items() if action.axis.startswith("gaze")}
    sizes = np.bincount(face.pieces[face.free], minlength=int(face.pieces.max()) + 1)
    turned: set[int] = set()
    for element in layout.elements:
        gazes = [rig.control_indices[name] for name in element.controls if name in gazing]
        share = np.zeros(len(sizes))
        for control in gazes:
            ends = [rig.controls[control].minimum, rig.controls[control].maximum]
            points, offsets = sweep(rig, start, control, ends)
            moved = np.linalg.norm(offsets, axis=2).max(axis=0)
            far = points[(moved > 0.5 * moved.max(initial=0.0)) & face.free[points]]
            share += np.bincount(face.pieces[far], minlength=len(sizes)) / len(gazes)
        turned.update(np.flatnonzero(share > _TURNED * np.maximum(sizes, 1)).tolist())
    return turned


def _eyes_by_region(face: _Face, main: int) -> list[_Eye]:
    """On either side the largest piece about the elements of the eye."""
    eyes = []
    places, aside = face.at[face.anchors], face.at[face.anchors, 0] > face.middle
    near = np.array([region in ("eye", "gaze") for region in face.regions])
    for side in (near & aside, near & ~aside):
        place = places[side, :2].mean(axis=0) if side.any() else np.full(2, np.inf)
        sizes = {}
        for piece in set(face.pieces[face.free].tolist()) - {main}:
            at = face.at[face.pieces == piece]
            low, high = at[:, :2].min(axis=0), at[:, :2].max(axis=0)
            off = abs(place - 0.5 * (low + high)) / np.maximum(high - low, 1e-12)
            if (off < _ABOUT).all() and float((high - low).max()) < _MAX_EYE * face.extent:
                sizes[piece] = float((high - low).min())
        if sizes:
            eyes.append(face.eye(max(sizes, key=lambda piece: sizes[piece])))
    return eyes


def _on_eye(face: _Face, eye: _Eye) -> tuple[Flags, Flags]:
    """(n,) points of the eyeball and of other balls about its centre, and of the shells that lie
    over its pupil."""
    within = face.free & (np.linalg.norm(face.at - eye.centre, axis=1) / eye.radius < _SHELL)
    balls = [piece for piece in _whole(face.pieces, within) if _is_about(face, piece, eye)]
    on = np.isin(face.pieces, [*balls, eye.piece])
    crossed = _crossed(face.at[face.corners, :2] - eye.centre[:2])
    before = crossed & (face.at[face.corners, 2] > eye.centre[2]).all(axis=1)
    over = np.intersect1d(_whole(face.sheets, within & ~on), face.sheets[face.corners[before, 0]])
    return on, np.isin(face.sheets, over)


def _is_about(face: _Face, piece: int, eye: _Eye) -> bool:
    """Whether a piece is as large as an eye, and no lid."""
    return bool((np.ptp(face.at[face.pieces == piece], axis=0)[:2] > 1.5 * eye.radius).all())


def _whole(labels: Indices, flags: Flags) -> list[int]:
    """The labels all of whose points have the flag."""
    return [
        int(each) for each in np.unique(labels[flags]) if each >= 0 and flags[labels == each].all()
    ]


def _directions(offsets: Floats, radius: float) -> Floats:
    """(n, 2) `Complexion.gaze` of points that lie at `offsets` (n, 3) from an eye's centre."""
    unit = offsets / np.maximum(np.linalg.norm(offsets, axis=1, keepdims=True), 1e-12 * radius)
    across = np.linalg.norm(unit[:, :2], axis=1, keepdims=True)
    length = np.where(unit[:, 2:] >= 0.0, across, 2.0 - across)
    return np.asarray(unit[:, :2] / np.maximum(across, 1e-12) * length)


# --- mouth ----------------------------------------------------------------------------------------


def _mouth(face: _Face, line: Floats) -> tuple[Floats, Flags]:
    """(n,) how much of a point the lips about a line cover, and what lies behind it."""
    half, middle = 0.5 * float(np.ptp(line[:, 0])), 0.5 * float(line[0, 0] + line[-1, 0])
    height, depth = (np.interp(face.at[:, 0], line[:, 0], line[:, axis]) for axis in (1, 2))
    across, above, before = (
        (face.at - np.stack([0.0 * depth + middle, height, depth], 1)) / half
    ).T
    full = np.sqrt(np.clip(1.0 - across**2, 0.0, 1.0))
    thick = np.where(above > 0.0, 0.30, 0.36) * full + 1e-9
    cover = smooth_step(0.0, 0.4, 1.0 - abs(above) / thick) * (abs(before) < 0.8) * (full > 0.0)
    lips = 0.75 * cover * ((face.normals[:, 2] > -0.5) | (abs(above) < 0.2))
    behind = (abs(across) < 1.4) & (abs(above) < 1.6) & (before < 0.1) & (before > -4.0)
    return np.asarray(lips), np.asarray(behind)


def _mouth_line(face: _Face, skin: Flags) -> Floats | None:
    """(k, 3) from right to left of the picture, where the skin faces itself across a small gap
    among the elements of the mouth, in one stretch over the mid-plane; the widest one counts."""
    of_mouth = face.anchors[np.isin(face.regions, _MOUTH)]
    if not len(of_mouth):
        return None
    places, room = face.at[of_mouth, :2], 0.15 * face.extent
    low, high = places.min(axis=0) - room, places.max(axis=0) + room
    near = np.flatnonzero(skin & ((face.at[:, :2] > low) & (face.at[:, :2] < high)).all(axis=1))
    step = _LIP_STEP * face.extent
    facing = near[_faces_itself(face.at[near], face.normals[near], 2.0 * step)]
    widest, best = 0.0, None
    for stretch in _stretches(face.at[facing], 1.5 * step):
        line = _front_line(face.at[facing[stretch]], step)
        if line[0, 0] < face.middle < line[-1, 0] and np.ptp(line[:, 0]) > widest:
            widest, best = float(np.ptp(line[:, 0])), line
    return best


def _faces_itself(at: Floats, normals: Floats, reach: float) -> Flags:
    """(n,) points with another within reach in front of them that looks back."""
    pairs = KDTree(at).query_pairs(reach, output_type="ndarray")
    apart = at[pairs[:, 1]] - at[pairs[:, 0]]
    length = np.maximum(np.linalg.norm(apart, axis=1), 1e-12)
    out, back = normals[pairs[:, 0]], normals[pairs[:, 1]]
    against = np.einsum("ni,ni->n", out, back) < 0.0
    ahead = (np.einsum("ni,ni->n", out, apart) > 0.2 * length) & (
        np.einsum("ni,ni->n", back, apart) < -0.2 * length
    )
    found = np.zeros(len(at), dtype=bool)
    found[pairs[against & ahead].ravel()] = True
    return found


def _stretches(at: Floats, reach: float) -> list[Indices]:
    if not len(at):
        return []
    pairs = KDTree(at).query_pairs(reach, output_type="ndarray")
    count, labels = connected_components(graph(pairs, len(at)), directed=False)
    return [np.flatnonzero(labels == each) for each in range(count)]


def _front_line(at: Floats, step: float) -> Floats:
    """(k, 3) the foremost points of a stretch, one for each step to the side."""
    cell = np.floor(at[:, 0] / step).astype(np.int64)
    rows = [at[cell == each][np.argmax(at[cell == each][:, 2])] for each in np.unique(cell)]
    return np.array(sorted(rows, key=lambda row: float(row[0])))
