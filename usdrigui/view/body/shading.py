"""The character in its colours: an orthographic camera, three lights and smooth normals, by ray
casting.

Needs no graphics card, no display and no GL library.  One ray is cast per pixel and four more where
an outline passes through it.
"""

from __future__ import annotations

import numpy as np
from scipy.ndimage import maximum_filter, minimum_filter

from usdrigui.character import Flags, Floats, Indices, Record, RigMesh, Singles
from usdrigui.character.joint_tree import unit
from usdrigui.character.rays import Caster, make_caster
from usdrigui.character.surface import mesh_triangles, vertex_normals, weld

SKIN = (0.61, 0.40, 0.31)
"""Linear albedo of what has no colour of its own."""
EYE = {"pupil": (0.012, 0.011, 0.011), "iris": (0.17, 0.11, 0.065), "white": (0.80, 0.77, 0.74)}
"""Linear albedo of an eye that has no colours of its own, from its middle."""
PUPIL, IRIS = 0.19, 0.47
"""Their radii, in radii of the eyeball."""
_LIGHTS = (((-0.55, 0.60, 0.75), (0.84, 0.81, 0.77)), ((0.85, 0.05, 0.55), (0.20, 0.23, 0.28)))
"""Key and fill: direction in the camera's frame (right, up, toward) and linear colour."""
_SKY, _GROUND = (0.25, 0.26, 0.28), (0.10, 0.09, 0.085)
_RIM = 0.16
_FADING = np.array([0.93, 1.26, 1.26])
_SKIES = 40
"""Directions from which the light of the sky comes."""
_UNSEEN = 0.16
"""Of the light reaches what no sky sees."""
_SLACK = 0.013
"""How far light passes what is before a point, in the diagonal of the character: soft shade is of
folds, not of pores."""
_SUBPIXELS = np.array([[-0.125, -0.375], [0.375, -0.125], [0.125, 0.375], [-0.375, 0.125]])


class Camera(Record):
    """An orthographic view of a rectangle."""

    rows: Floats
    """(3, 3): right, up and toward the viewer, unit vectors in root space."""
    centre: Floats
    """(3,) what the middle of the picture shows."""
    scale: float
    """Pixels per scene unit."""
    width: int
    height: int

    def project(self, points: Floats) -> Floats:
        """Pixels (x to the right, y down) and depth (scene units, growing toward the viewer) of
        (..., 3)."""
        at = (points - self.centre) @ self.rows.T
        x = self.width / 2.0 + self.scale * at[..., 0]
        y = self.height / 2.0 - self.scale * at[..., 1]
        return np.stack([x, y, at[..., 2]], axis=-1)

    def unproject(self, pixels: Floats, depth: float) -> Floats:
        """(n, 3) points at ``pixels`` (n, 2) and one depth."""
        x = (pixels[:, :1] - self.width / 2.0) / self.scale
        y = (self.height / 2.0 - pixels[:, 1:]) / self.scale
        return np.asarray(
            x * self.rows[0] + y * self.rows[1] + (self.centre + depth * self.rows[2])
        )


class Complexion(Record):
    """How the points of a rig look, in the numbering of `Rig`."""

    colours: Floats
    """(n, 3) linear."""
    gaze: Floats
    """(n, 2) on eyeballs, where a point lies on the ball seen along the gaze, to the right and up:
    (0, 0) is the middle of the pupil, 1 from it the equator, up to 2 what lies behind; (9, 9) off
    the eyes."""
    clear: Flags
    """(n,) of what is transparent on a face and would hide the eyes."""
    open: Floats
    """(n,) share of the light of the sky that reaches a point at rest: soft shade in folds, dark
    inside the mouth."""

    @property
    def shaded(self) -> Floats:
        """(n, 3) linear colours darkened where little light comes: red goes last, as in flesh, and
        eyes shine."""
        light = np.where(np.abs(self.gaze[:, 0]) < 3.0, 0.5 * self.open + 0.5, self.open)
        return np.asarray(self.colours * light[:, None] ** _FADING)


class Subject(Record):
    """The visible surface of a character at one pose, ready for ray casting."""

    points: Floats
    corners: Indices
    """(t, 3)."""
    normals: Floats
    """(n, 3) smooth; zero where undefined."""
    colours: Floats
    """(n, 3) linear albedo, in the shade of the shape at rest."""
    gaze: Floats
    """(n, 2) as `Complexion.gaze`."""
    caster: Caster

    @property
    def skin(self) -> Floats:
        """Its points that faces have; all where there are no faces."""
        return self.points[np.unique(self.corners)] if len(self.corners) else self.points


class Shaded(Record):
    """A picture of the body alone."""

    colour: Floats
    """(height, width, 3) linear, where covered."""
    cover: Floats
    """(height, width) share of the pixel that the body covers."""
    depth: Floats
    """(height, width) as `Camera.project`, at pixel centres; -inf beside the body."""


def subject_of(meshes: tuple[RigMesh, ...], points: Floats, look: Complexion) -> Subject:
    """The rig's visible meshes (all, if none is visible) at ``points`` (n, 3) in root space,
    without triangles that are clear or not finite."""
    corners = mesh_triangles(meshes, visible_only=True)
    if not len(corners):
        corners = mesh_triangles(meshes)
    finite: Flags = np.asarray(np.isfinite(points).all(axis=1))
    corners = corners[finite[corners].all(axis=1) & ~look.clear[corners].all(axis=1)]
    points = np.where(finite[:, None], points, 0.0)
    normals = vertex_normals(points, corners, weld(points))
    return Subject(points, corners, normals, look.shaded, look.gaze, make_caster(points[corners]))


def openness(subject: Subject) -> Floats:
    """(n,) share of the light of the sky that reaches each point, by rays to all around."""
    seen, light = np.zeros(len(subject.points)), np.full(len(subject.points), 1e-12)
    length = np.maximum(np.linalg.norm(subject.normals, axis=1), 1e-30)
    # Directions of a Fibonacci lattice on the sphere.
    height = 1.0 - (2.0 * np.arange(_SKIES) + 1.0) / _SKIES
    angle = np.arange(_SKIES) * np.pi * (3.0 - np.sqrt(5.0))
    across = np.sqrt(1.0 - height**2)
    skies = np.stack([across * np.cos(angle), height, across * np.sin(angle)], axis=1)
    for sky in skies:
        share = subject.normals @ sky / length
        lit = np.flatnonzero(share > 0.05)
        starts = subject.points[lit] + _SLACK * subject.caster.size * sky
        free = subject.caster.first_hits(starts, sky).triangle < 0
        light[lit] += share[lit]
        seen[lit] += share[lit] * free
    return _UNSEEN + (1.0 - _UNSEEN) * np.where(light > 1e-6, seen / light, 1.0)


def shade(subject: Subject, camera: Camera) -> Shaded:
    """Render the body under three lights."""
    y, x = np.mgrid[: camera.height, : camera.width]
    pixels = np.stack([x.ravel(), y.ravel()], axis=1) + 0.5
    colour, depth = _samples(subject, camera, pixels)
    cover = np.isfinite(depth).astype(np.float64)
    grid = depth.reshape(camera.height, camera.width)
    edge = np.flatnonzero(_outlines(grid, camera).ravel())
    if len(edge):
        finer = (pixels[edge][:, None] + _SUBPIXELS).reshape(-1, 2)
        fine, fine_depth = _samples(subject, camera, finer)
        met = np.isfinite(fine_depth).reshape(-1, len(_SUBPIXELS))
        cover[edge] = met.mean(axis=1)
        total = (fine.reshape(*met.shape, 3) * met[..., None]).sum(axis=1)
        colour[edge] = total / np.maximum(met.sum(axis=1), 1)[:, None]
    shape = (camera.height, camera.width)
    return Shaded(colour.reshape(*shape, 3), cover.reshape(shape), grid)


def _samples(subject: Subject, camera: Camera, pixels: Floats) -> tuple[Floats, Floats]:
    """Linear colours (n, 3) and depths (n,) where rays through ``pixels`` (n, 2) meet the body."""
    colour, depth = np.zeros((len(pixels), 3)), np.full(len(pixels), -np.inf)
    if not len(subject.corners):
        return colour, depth
    reach = (subject.points[subject.corners.ravel()] - camera.centre) @ camera.rows[2]
    front = float(reach.max()) + 0.01 * subject.caster.size
    hits = subject.caster.first_hits(camera.unproject(pixels, front), -camera.rows[2])
    met = np.flatnonzero(hits.triangle >= 0)
    depth[met] = front - hits.distance[met]
    corners = subject.corners[hits.triangle[met]]
    flat = camera.project(subject.points)[:, :2]
    weights = _barycentric(flat[corners], pixels[met]).astype(np.float32)

    def at_hits(values: Floats) -> Singles:
        return np.asarray(np.einsum("nk,nkd->nd", weights, values.astype(np.float32)[corners]))

    albedo = at_hits(subject.colours)
    on_eye: Flags = np.asarray((np.abs(subject.gaze) < 3.0).all(axis=1))
    eye = on_eye[corners].all(axis=1)
    if eye.any():
        albedo[eye] *= eye_colours(at_hits(subject.gaze)[eye].astype(np.float64)) / EYE["white"]
    colour[met] = _lit(at_hits(subject.normals @ camera.rows.T)) * albedo
    return colour, depth


def eye_colours(gaze: Floats) -> Floats:
    """(n, 3) linear albedo of an eye at `Complexion.gaze` (n, 2); the viewer has the same
    (viewer/src/eye.js)."""
    away = np.linalg.norm(gaze, axis=1, keepdims=True)
    rim = 1.0 - 0.6 * smooth_step(0.75 * IRIS, IRIS, away)
    inner = _mixed(
        np.array(EYE["pupil"]),
        rim * np.array(EYE["iris"]),
        smooth_step(PUPIL - 0.015, PUPIL + 0.015, away),
    )
    return _mixed(inner, np.array(EYE["white"]), smooth_step(IRIS - 0.025, IRIS + 0.025, away))


def _mixed(a: Floats, b: Floats, share: Floats) -> Floats:
    return (1.0 - share) * a + share * b


def smooth_step(low: float, high: float, value: Floats) -> Floats:
    """0 below `low`, 1 above `high`, smooth between."""
    t = np.clip((value - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def encoded(linear: Floats) -> Floats:
    """sRGB of linear light, both from 0 to 1."""
    clipped = np.clip(linear, 0.0, 1.0)
    return np.where(clipped <= 0.0031308, 12.92 * clipped, 1.055 * clipped ** (1.0 / 2.4) - 0.055)


def turns(flat: Floats) -> Floats:
    """(n, 3) twice the signed area that each side of triangles (n, 3, 2), in the order of the
    corners before them, spans with the origin."""
    (x, y), (next_x, next_y) = (
        flat[:, order].transpose(2, 0, 1) for order in ([1, 2, 0], [2, 0, 1])
    )
    return np.asarray(x * next_y - next_x * y)


def _barycentric(corners: Floats, at: Floats) -> Floats:
    """(n, 3) weights of the corners (n, 3, 2) that give the points (n, 2)."""
    areas = turns(corners - at[:, None])
    total = areas.sum(axis=1, keepdims=True)
    return np.asarray(
        np.divide(areas, total, out=np.full_like(areas, 1.0 / 3.0), where=np.abs(total) > 1e-30)
    )


def _lit(normals: Singles) -> Singles:
    """Linear light (n, 3) on surfaces with ``normals`` (n, 3) in the camera's frame, seen from
    either side."""
    n = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.float32(1e-30))
    n *= np.where(n[:, 2:] < 0.0, np.float32(-1.0), np.float32(1.0))
    height = 0.5 + 0.5 * n[:, 1:2]
    sky, ground = np.array(_SKY, dtype=np.float32), np.array(_GROUND, dtype=np.float32)
    light = ground + height * (sky - ground)
    for direction, colour in _LIGHTS:
        toward = unit(np.array(direction))
        half = toward + np.array([0.0, 0.0, 1.0])
        ways = np.stack([toward, unit(half)], axis=1).astype(np.float32)
        facing, shine = np.split(n @ ways, 2, axis=1)
        # Light that wraps a little round the form keeps the turn to the shadow soft, as on skin.
        lit = np.maximum((facing + 0.15) / 1.15, 0.0)
        lit += 0.10 * np.maximum(shine, 0.0) ** 24
        light += lit * np.array(colour, dtype=np.float32)
    rim = (1.0 - np.clip(n[:, 2:], 0.0, 1.0)) ** 3 * np.clip(0.4 + 0.6 * n[:, 1:2], 0.0, 1.0)
    return np.asarray(light + _RIM * rim, dtype=np.float32)


def _outlines(depth: Floats, camera: Camera) -> Flags:
    """Pixels next to a jump in depth, or to the border of the body."""
    known = np.isfinite(depth)
    low = float(depth[known].min()) if known.any() else 0.0
    filled = np.where(known, depth, low - 1e3 / camera.scale)
    jump = maximum_filter(filled, 3) - minimum_filter(filled, 3)
    return np.asarray(jump > 8.0 / camera.scale)
