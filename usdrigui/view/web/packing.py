"""Rig and Layout records packed into one compact binary scene for the web viewer.

A scene is a JSON header and a body of arrays.  Positions are quantised to 16 bits within each
mesh's bounding box, blend-shape offsets to 16 bits within each shape's own largest offset; arrays
of integers are stored as differences and byte planes, which is what makes them deflate well.  The
same records always give the same bytes (docs/decisions/070-viewer-scene.md has the measured
errors).
"""

from __future__ import annotations

import hashlib
import io
import itertools
import json
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PIL import Image

from usdrigui.character import (
    Clip,
    Control,
    Flags,
    Floats,
    Glyph,
    Indices,
    Rig,
    RigMesh,
    Shape,
    Skin,
    Texels,
    Texturing,
)
from usdrigui.character.clip_reading import ClipReading, reading
from usdrigui.character.palette import SIDES
from usdrigui.character.surface import mesh_triangles, triangles
from usdrigui.errors import Issue, refuse
from usdrigui.following import following, shared
from usdrigui.model import Element, Layout
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.settings import OutputSettings
from usdrigui.version import __version__
from usdrigui.view.body.complexion import complexion
from usdrigui.view.body.shading import EYE, IRIS, PUPIL, Complexion, encoded
from usdrigui.view.directions import camera_rows
from usdrigui.view.flat import framing
from usdrigui.view.flat.callouts import shortened
from usdrigui.view.flat.columns import heading, rank
from usdrigui.view.panels import on_character
from usdrigui.view.sections import sections

Json = dict[str, Any]

_POSITION_STEPS = 65535
_OFFSET_STEPS = 32767
_WEIGHT_STEPS = 65535
_GAZE_STEP = 3.0 / 8192
_UV_STEPS = 65535
_IMAGES = 0.5
"""Bytes of images, at most, of those of the page without them."""
_SIDES = (1024, 768, 512, 384, 256, 128, 64, 32)
"""Texels along the longer side of an image, as there is room."""


def pack(rig_layouts: Sequence[tuple[Rig, Layout]], title: str, around: float = 0.0) -> bytes:
    """Everything the viewer needs to show and pose the characters, deflated; `around` are the bytes
    of the page besides, by which images have the more room.

    The inflated bytes are: the header's length (uint32, little endian), the header (UTF-8 JSON,
    padded with spaces to a multiple of four), the body.  Header entries ``{"at", "kind", "shape"}``
    refer to arrays in the body.  Raises RigUIError LAYOUT_STALE when a layout was made for another
    version of its rig, VIEW_MISMATCH for a number that is not finite.
    """
    arrays = _Arrays()
    header = {
        "title": title,
        "version": __version__,
        "characters": [_character(arrays, rig, layout) for rig, layout in rig_layouts],
    }
    if arrays.images:
        room = _IMAGES * (around + len(zlib.compress(arrays.content)))
        drawn = image_files([*arrays.images.values()], room)
        header["images"] = [arrays.numbers(np.frombuffer(each, "u1"), "u1") for each in drawn]
    text = json.dumps(header, ensure_ascii=False, allow_nan=False, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    return zlib.compress(len(text).to_bytes(4, "little") + text + bytes(arrays.content), 9)


def image_files(images: Sequence[Texels], room: float) -> list[bytes]:
    """Images as WebP files, all as large as there is room for so many bytes together."""
    for side in _SIDES:
        files = [_webp(each, side) for each in images]
        if sum(map(len, files)) <= room:
            break
    return files


def _webp(texels: Texels, side: int) -> bytes:
    image, file = Image.fromarray(texels), io.BytesIO()
    image.thumbnail((side, side))
    image.save(file, "WEBP")
    return file.getvalue()


class _Arrays:
    """Growing store of arrays, each entered as its byte planes."""

    def __init__(self) -> None:
        self.content = bytearray()
        self.images: dict[bytes, Texels] = {}
        """By their content, in the order of their numbers."""

    def image(self, texels: Texels) -> int:
        """The number of an image, the same of the same one."""
        self.images.setdefault(content := texels.tobytes(), texels)
        return [*self.images].index(content)

    def numbers(self, array: ArrayLike, kind: str = "f4") -> Json:
        """Store numbers of the little-endian `kind` (u1, u2, i2, u4, i4, f4, f8)."""
        stored = np.ascontiguousarray(array, dtype=np.dtype(kind).newbyteorder("<"))
        at, width = len(self.content), stored.dtype.itemsize
        self.content += stored.reshape(-1).view(np.uint8).reshape(-1, width).T.tobytes()
        self.content += bytes(-len(self.content) % 4)
        return {"at": at, "kind": kind, "shape": list(stored.shape)}

    def ascending(self, array: ArrayLike) -> Json:
        """Store an ascending list of indices as differences."""
        values = np.asarray(array, dtype=np.int64)
        return {**self.numbers(np.diff(values, prepend=0), "u4"), "sum": True}

    def wandering(self, array: ArrayLike) -> Json:
        """Store indices that stay near each other (triangle corners) as signed differences."""
        values = np.asarray(array, dtype=np.int64)
        stored = self.numbers(np.diff(values.ravel(), prepend=0), "i4")
        return {**stored, "sum": True, "shape": list(values.shape)}


# --- the rig --------------------------------------------------------------------------------------


def _character(arrays: _Arrays, rig: Rig, layout: Layout) -> Json:
    body = rig.body
    joints, packed = body.joints, _layout(rig, layout)
    return {
        "root": rig.path,
        "identity": _identity(rig),
        "layoutDigest": hashlib.sha256(json.dumps(packed).encode()).hexdigest()[:32],
        **_fields(rig, "up metres_per_unit time_codes"),
        "meshes": _meshes(arrays, body.meshes, body.starts, complexion(rig, layout)),
        "eye": {
            **{name: _list(encoded(np.array(colour))) for name, colour in EYE.items()},
            "radii": [PUPIL, IRIS],
        },
        "skeletons": [_fields(each, "path animation to_root") for each in body.skeletons],
        "joints": [_fields(each, "path skeleton parent") for each in joints],
        **{
            name: arrays.numbers(np.reshape([getattr(e, name) for e in joints], (-1, 4, 4)), "f8")
            for name in ("bind", "base")
        },
        "channels": [_fields(each, "token animation index") for each in body.channels],
        **_fields(body, "base_weights"),
        "controls": _controls(rig.controls, layout),
        "clip": _clip(arrays, rig.clip, rig.issues),
        "toWorld": _list(rig.to_world.reshape(-1, 16)),
        "shotCamera": None if rig.shot_camera is None else _list(rig.shot_camera),
        "layout": packed,
    }


def _identity(rig: Rig) -> str:
    """Hex digest of what work on a character belongs to: its meshes and controls, not its layout or
    animation."""
    found = hashlib.sha256(json.dumps([rig.path, rig.control_names]).encode())
    for mesh in rig.body.meshes:
        found.update(mesh.path.encode() + np.ascontiguousarray(mesh.points, dtype="<f4").tobytes())
    return found.hexdigest()[:32]


def _meshes(
    arrays: _Arrays, meshes: tuple[RigMesh, ...], starts: Indices, seen: Complexion
) -> list[Json]:
    spans = [slice(a, b) for a, b in itertools.pairwise(starts.tolist())]
    looks = [
        Complexion(seen.colours[span], seen.gaze[span], seen.clear[span], seen.open[span])
        for span in spans
    ]
    return [_mesh(arrays, mesh, own) for mesh, own in zip(meshes, looks, strict=True)]


def _mesh(arrays: _Arrays, mesh: RigMesh, seen: Complexion) -> Json:
    low, step, grid = _quantised_positions(mesh.points)
    faces, points = mesh.topology, mesh.topology.face_indices
    at = triangles(faces.face_counts, np.arange(len(points)), faces.left_handed)
    at = at[~seen.clear[points[at]].all(axis=1)]
    corners, colours, texture = points[at], seen.shaded, None
    if mesh.texturing is not None:
        texture, painted = _texture(arrays, mesh.texturing, faces.face_counts, at)
        # An image has the colours; points have the shade on them.
        shade = replace(seen, colours=np.ones_like(seen.colours)).shaded
        colours[corners[painted]] = shade[corners[painted]]
    on_eye = (np.abs(seen.gaze) < 3.0).any()
    return {
        **_fields(mesh, "path visible to_root"),
        "low": _list(low),
        "step": _list(step),
        "points": arrays.numbers(grid, "u2"),
        "triangles": arrays.wandering(corners),
        "skin": None if mesh.skin is None else _skin(arrays, mesh.skin),
        "shapes": [_shape(arrays, shape) for shape in mesh.shapes],
        "texture": texture,
        "colours": arrays.numbers(np.rint(255.0 * encoded(colours)), "u1"),
        "gaze": (
            arrays.numbers(np.rint(seen.gaze / _GAZE_STEP).clip(-32767, 32767), "i2")
            if on_eye
            else None
        ),
    }


def _texture(
    arrays: _Arrays, texturing: Texturing, counts: Indices, at: Indices
) -> tuple[Json, Flags]:
    """Where the images of a mesh are on its triangles, (t, 3) by the corners of its faces, each
    moved by whole tiles to where the image is; which of them (t,) have one."""
    numbers = np.array([arrays.image(each) for each in texturing.images])
    own = np.repeat(texturing.image, counts)[at[:, 0]]
    uv = texturing.uv[at] - np.floor(texturing.uv[at].min(axis=1, keepdims=True))
    steps = np.rint(_UV_STEPS * uv.clip(0.0, 1.0)).astype(np.int64)
    images = np.where(own < 0, -1, numbers[own])
    return {"uv": arrays.wandering(steps.T), "images": arrays.numbers(images, "i2")}, images >= 0


def _quantised_positions(points: Floats) -> tuple[Floats, Floats, NDArray[np.int64]]:
    """Bounding box corner, step per axis and whole steps of each point, all in mesh space."""
    if not len(points):
        return np.zeros(3), np.ones(3), np.zeros((0, 3), dtype=np.int64)
    low, high = points.min(axis=0), points.max(axis=0)
    step = np.where(high > low, (high - low) / _POSITION_STEPS, 1.0)
    return low, step, np.rint((points - low) / step).astype(np.int64)


def _shape(arrays: _Arrays, shape: Shape) -> Json:
    """Offsets in steps of the largest; points that round to no offset at all are left out."""
    largest = float(np.abs(shape.offsets).max(initial=0.0))
    step = (largest or 1.0) / _OFFSET_STEPS
    grid = np.rint(shape.offsets.astype(np.float64) / step).astype(np.int64)
    kept = np.flatnonzero(grid.any(axis=(0, 2)))
    return {
        **_fields(shape, "channel weights"),
        "step": step,
        "points": arrays.ascending(shape.points[kept]),
        "offsets": arrays.numbers(grid[:, kept], "i2"),
    }


def _skin(arrays: _Arrays, skin: Skin) -> Json:
    """Influences; a rigid skin stores one row, and columns without any weight are left out."""
    rows = slice(0, 1) if skin.rigid else slice(None)
    joints, weights = skin.joints[rows], skin.weights[rows]
    used = (
        np.flatnonzero((weights > 0.0).any(axis=0)) if len(weights) else np.arange(weights.shape[1])
    )
    return {
        "joints": arrays.numbers(joints[:, used], "u2"),
        "weights": arrays.numbers(np.rint(weights[:, used] * _WEIGHT_STEPS), "u2"),
        "dualQuaternion": skin.method == "dualQuaternion",
        **_fields(skin, "geom_bind"),
    }


def _controls(controls: tuple[Control, ...], layout: Layout) -> list[Json]:
    labels = shortened([control.label for control in controls])
    members = [each for element in layout.elements for each in element.members]
    attributes = {each.control: each.attribute for each in reversed(members)}
    return [
        {
            **_fields(control, "name kind source minimum default maximum"),
            "label": label,
            "drive": _fields(
                control.drive, "values channels weights joints rotations translations scales"
            ),
            "reading": _reading(reading(control)),
            "attribute": attributes.get(control.name, ""),
        }
        for control, label in zip(controls, labels, strict=True)
    ]


def _reading(found: ClipReading | None) -> Json | None:
    """Where a clip has the value of a control."""
    if found is None:
        return None
    return _fields(found, "rises" if found.rises else "joint turn")


def _clip(arrays: _Arrays, clip: Clip | None, issues: tuple[Issue, ...]) -> Json | None:
    if clip is None or not len(clip.times):
        return None
    return {
        **_fields(clip, "times frames_per_second"),
        "thinned": any(each.code == "CLIP_THINNED" for each in issues),
        "weights": arrays.numbers(clip.weights),
        "locals": arrays.numbers(clip.locals),
    }


# --- the layout -----------------------------------------------------------------------------------


def _layout(rig: Rig, layout: Layout) -> Json:
    looked_at = _sections(rig, layout)  # refuses a layout of another version of the rig
    return {
        "planeOrigin": _list(layout.frame.plane.origin),
        "planeNormal": _list(layout.frame.plane.normal),
        **_fields(layout, "base_values"),
        "leastTrack": OutputSettings().min_track,
        "colours": {side: f"#{bytes(colour).hex()}" for side, colour in SIDES.items()},
        "elements": _elements(rig, layout),
        "sections": looked_at,
        "leftOff": [[each.control, each.stage, each.reason] for each in layout.left_off],
    }


def _sections(rig: Rig, layout: Layout) -> list[Json]:
    """What is looked at by itself, the face first; all of a character in one part."""
    posed, up = evaluate(prepare(rig, layout)), rig.up
    corners = np.unique(mesh_triangles(rig.body.meshes, visible_only=True))
    skin = posed.points[corners] if len(corners) else posed.points
    packed: list[Json] = []
    tracks: list[Floats] = []
    for each in sections(rig, layout, posed):
        # Tongue and teeth have no handle on the character: they are looked at in its face.
        own = [t for i in on_character(each.layout) for t in each.posed.elements[i].tracks]
        tracks = own or tracks
        packed.append(
            {
                "title": each.title,
                **_fields(each.layout.frame, "handle_width view"),
                "frame": _list(framing.corners(tracks, skin, camera_rows(each.layout, up))),
                "elements": [element.name for element in each.layout.elements],
            }
        )
    return packed


def _elements(rig: Rig, layout: Layout) -> list[Json]:
    controls = rig.control_indices
    meshes = {mesh.path: index for index, mesh in enumerate(rig.body.meshes)}
    found = [_element(meshes, controls, each) for each in layout.elements]
    all_of = shared(rig, layout.elements)
    labels = shortened([element.label for element in layout.elements])
    for packed, label, element in zip(found, labels, layout.elements, strict=True):
        packed["label"] = label
        packed["follows"] = {
            place: _fields(following(rig, _on(place, element), all_of), "held deforms joint")
            for place in ("character", "board")
        }
    return found


def _on(place: str, element: Element) -> Element:
    """The element, were it on the character or the board."""
    return replace(element, anchor=replace(element.anchor, on_board=place == "board"))


def _element(meshes: dict[str, int], controls: Mapping[str, int], element: Element) -> Json:
    anchor = element.anchor
    category = element.category or ("" if anchor.on_board else "requested")
    title = heading(category, element.part)
    return {
        "name": element.name,
        **_fields(element, "kind axes mirror reversed"),
        **_fields(anchor, "point position normal on_board"),
        **_fields(element, "side inner category reason"),
        "members": [
            {"control": controls[each.control], **_fields(each, "values track magnification")}
            for each in element.members
        ],
        "mesh": meshes[anchor.mesh],
        "boardCategory": category,  # of one on the character: where `process` lists it off it
        "rank": rank(category),
        "heading": title[:1].upper() + title[1:],
        "glyph": _glyph(element.glyph),
    }


def _glyph(glyph: Glyph | None) -> Json | None:
    """The outlines of a custom handle: offsets from its centre, and which of them make each line or
    face."""
    if glyph is None:
        return None
    return {
        "points": _list(glyph.points),
        "parts": [part.tolist() for part in glyph.parts],
        "closed": glyph.form == "mesh",
    }


# --- fields and numbers ---------------------------------------------------------------------------


def _fields(record: Any, names: str) -> Json:
    """Some fields of a record, each as JavaScript spells its name."""
    return {_spelt(name): _value(getattr(record, name)) for name in names.split()}


def _spelt(name: str) -> str:
    first, *rest = name.split("_")
    return first + "".join(word.capitalize() for word in rest)


def _value(value: Any) -> Any:
    """Text, numbers and nested tuples as they are, arrays as `_list` of whole numbers."""
    if isinstance(value, np.ndarray):
        return _list(value) if value.dtype.kind == "f" else value.tolist()
    return value


def _list(array: ArrayLike) -> list[Any]:
    """Nested list of floats, rounded to 9 significant digits (single precision and a bit)."""
    values = np.asarray(array, dtype=np.float64)
    if not np.isfinite(values).all():
        raise refuse("VIEW_MISMATCH", "", "a record holds a number that is not finite")
    return [_nested(each) for each in values.tolist()]


def _nested(value: Any) -> Any:
    return [_nested(each) for each in value] if isinstance(value, list) else float(f"{value:.9g}")
