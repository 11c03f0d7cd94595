"""The images of a character in one picture, as a page draws them: the one that most elements stand
on as large as there is room for, all others half as large beside it.

The corners of faces lie in the picture; a point that lies at several places of it, where a texture
is cut, is several vertices (docs/decisions/146).
"""

from __future__ import annotations

import io
from collections import Counter
from itertools import count

import numpy as np
from PIL import Image

from usdrigui.character import Floats, Indices, Record, Rig, RigMesh, Texels, Texturing
from usdrigui.model import Layout

_SIDES = (1024, 768, 512, 384, 256, 128, 64)
"""Texels of the largest image along a side, as there is room."""
_QUALITY = 80
_BORDER = 0.002
"""Of an image is left out on each side, so that it does not mix with the next one."""
_STEPS = 65534


class Atlas(Record):
    """All images of a character, the largest first."""

    images: tuple[Texels, ...]
    numbers: dict[bytes, int]
    """Index into `images` by content."""

    @property
    def wide(self) -> float:
        """Width of the picture, in its height."""
        return 1.0 + 0.5 * (len(self.images) // 2)

    def box(self, number: int) -> Floats:
        """(4,) left, top, width and height of an image in the picture, in its height."""
        if not number:
            return np.array([0.0, 0.0, 1.0, 1.0])
        column, row = divmod(number - 1, 2)
        return np.array([1.0 + 0.5 * column, 0.5 * row, 0.5, 0.5])

    def encoded(self, room: float) -> bytes:
        """The picture as a WebP file of at most so many bytes, or as small as it gets."""
        finest = max(self.images[0].shape[:2])
        for side in [each for each in _SIDES if each <= max(finest, _SIDES[-1])]:
            picture = Image.new("RGBA", (round(self.wide * side), side))
            for number, texels in enumerate(self.images):
                left, top, wide, high = np.rint(side * self.box(number)).astype(int).tolist()
                drawn = Image.fromarray(texels).resize((wide, high), Image.Resampling.BOX)
                picture.paste(drawn, (left, top))
            file = io.BytesIO()
            picture.save(file, "WEBP", quality=_QUALITY)
            if len(file.getvalue()) <= room:
                break
        return file.getvalue()

    def places(self, texturing: Texturing, counts: Indices) -> Indices:
        """(corners, 2) where each corner of the faces of a mesh lies in the picture, from the left
        and from above in steps from 1; 0 for those of no image."""
        numbers = [self.numbers[each.tobytes()] for each in texturing.images]
        boxes = np.array([self.box(number) for number in numbers])
        image = np.repeat(texturing.image, counts)
        inside = _BORDER + (1.0 - 2.0 * _BORDER) * texturing.uv
        at = np.stack([inside[:, 0], 1.0 - inside[:, 1]], axis=1)
        at = (boxes[image, :2] + at * boxes[image, 2:]) / [self.wide, 1.0]
        return np.where(image[:, None] < 0, 0, 1 + np.rint(_STEPS * at).astype(np.int64))


class Vertices(Record):
    """A mesh whose points are taken apart where its texture is cut."""

    corners: Indices
    """(t, 3) triangles of vertices: the points, and after them the doubles."""
    doubles: Indices
    """(d,) point of each vertex more."""
    places: Indices
    """(n + d, 2) as `Atlas.places`."""


def atlas(rig: Rig, layout: Layout) -> Atlas | None:
    """The images of a character, None where it has none."""
    anchors = {(each.anchor.mesh, each.anchor.point) for each in layout.elements}
    borne = Counter[bytes]()
    known: dict[bytes, Texels] = {}
    for mesh in rig.body.meshes:
        texturing = mesh.display.texturing
        if texturing is None:
            continue
        names = [each.tobytes() for each in texturing.images]
        known.update(zip(names, texturing.images, strict=True))
        own = [point for path, point in anchors if path == mesh.path]
        bears = np.isin(mesh.topology.face_indices, own)
        for image in np.repeat(texturing.image, mesh.topology.face_counts)[bears]:
            if image >= 0:
                borne[names[image]] += 1
    if not known:
        return None
    order = sorted(known, key=lambda name: (-borne[name], -len(name)))
    return Atlas(tuple(known[name] for name in order), dict(zip(order, count(), strict=False)))


def vertices(mesh: RigMesh, corners: Indices, places: Indices) -> Vertices:
    """The triangles of a mesh, (t, 3) by the corners of its faces, with a vertex for each place of
    a point in the picture."""
    used = np.unique(corners)
    points = mesh.topology.face_indices[used]
    rows, which = np.unique(np.column_stack([points, places[used]]), axis=0, return_inverse=True)
    more = np.diff(rows[:, 0], prepend=-1) == 0
    number = np.where(more, len(mesh.points) + np.cumsum(more) - 1, rows[:, 0])
    of_corner = np.zeros(len(places), dtype=np.int64)
    of_corner[used] = number[which.ravel()]
    placed = np.zeros((len(mesh.points) + np.count_nonzero(more), 2), dtype=np.int64)
    placed[number] = rows[:, 1:]
    return Vertices(of_corner[corners], rows[more, 0], placed)


def painted(mesh: RigMesh, texturing: Texturing) -> Indices:
    """The points of a mesh that an image colours."""
    shown = np.repeat(texturing.image >= 0, mesh.topology.face_counts)
    return np.unique(mesh.topology.face_indices[shown])
