"""Glyphs: curves and meshes that the configuration names to be drawn as handles.

A glyph is drawn as its own stage shows it from above: the stage's up axis comes out of the face,
its X axis points to the viewer's right.  Its place there and its size do not matter:
it is centred and fitted into a sphere of radius 1.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np
from pxr import Sdf, Usd, UsdGeom

from usdrigui.character import Floats, Glyph
from usdrigui.errors import Faults, RigUIError, refuse
from usdrigui.isolation.foreign_file import check_source
from usdrigui.reading.mesh import checked_faces, left_handed
from usdrigui.settings import Settings
from usdrigui.stages.arrays import integers, value_at, vectors
from usdrigui.stages.opening import open_stage

_MOST_POINTS = 1000
"""Every handle repeats each shape's offset for each of its points."""
_STEPS = 6
"""Straight pieces that stand for one piece of a cubic curve."""
_TOP_VIEW: Mapping[str, tuple[tuple[int, int, int], ...]] = {
    "Y": ((1, 0, 0), (0, 0, -1), (0, 1, 0)),
    "Z": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
}
"""By up axis: what is to the right, up on the page, and towards the viewer who looks at it from
above."""
_CUBIC: Mapping[str, tuple[tuple[float, ...], ...]] = {
    "bezier": ((1, 0, 0, 0), (-3, 3, 0, 0), (3, -6, 3, 0), (-1, 3, -3, 1)),
    "bspline": (
        (1 / 6, 4 / 6, 1 / 6, 0),
        (-0.5, 0, 0.5, 0),
        (0.5, -1, 0.5, 0),
        (-1 / 6, 0.5, -0.5, 1 / 6),
    ),
    "catmullRom": ((0, 1, 0, 0), (-0.5, 0, 0.5, 0), (1, -2.5, 2, -0.5), (-0.5, 1.5, -1.5, 0.5)),
}
"""By basis: rows are the powers 0 to 3 of the parameter, columns the four control points."""


def read_glyphs(
    stage: Usd.Stage, asset: Path, settings: Settings, faults: Faults
) -> dict[str, Glyph]:
    """The glyphs that ``[controls.NAME] glyph`` names, by that name; `stage` is the asset's.

    ``/PRIM`` is a prim of the asset, ``FILE</PRIM>`` one of another layer, whose path is relative
    to the asset's folder.  Collects RigUIError CONFIG_VALUE, GLYPH_MISSING, GLYPH_TYPE,
    GLYPH_EMPTY, the code of an array that cannot be right, and what opening FILE raises.
    """
    glyphs: dict[str, Glyph] = {}
    for control, override in settings.controls.items():
        key, name = f'controls."{control}".glyph', override.glyph
        if name and name not in glyphs:
            with faults.collected():
                file, path = _address(key, name)
                source = stage
                if file:
                    source = _opened(key, asset.parent / file, settings.read.size_limit)
                prim = source.GetPrimAtPath(path)
                if not prim or not prim.IsActive():
                    what = f"there is no prim {path} in {file or asset.name}"
                    raise refuse("GLYPH_MISSING", key, what)
                glyphs[name] = _glyph(prim, name)
    return glyphs


def _address(key: str, text: str) -> tuple[str, str]:
    """The file, empty for the asset itself, and the prim path that a setting names."""
    file, bracket, path = "", "", text
    if text.endswith(">"):
        file, bracket, path = text.removesuffix(">").partition("<")
    is_valid = path.startswith("/") and Sdf.Path.IsValidPathString(path)[0]
    if not is_valid or not Sdf.Path(path).IsPrimPath() or (bracket and not file):
        raise refuse("CONFIG_VALUE", key, f"expected /PRIM or FILE</PRIM>, got {text!r}")
    return file, path


def _opened(key: str, path: Path, size_limit: int) -> Usd.Stage:
    try:
        check_source(path, size_limit)
        return open_stage(path)
    except RigUIError as error:
        if error.issue.code != "FILE_NOT_FOUND":
            raise
        raise refuse(
            "GLYPH_MISSING", key, f"{path.name} does not exist or cannot be read"
        ) from None


def _glyph(prim: Usd.Prim, name: str) -> Glyph:
    path, time = prim.GetPath(), Usd.TimeCode.Default()
    if not (prim.IsA(UsdGeom.Mesh) or prim.IsA(UsdGeom.BasisCurves)):
        raise refuse("GLYPH_TYPE", path, f"is {prim.GetTypeName() or 'a prim without a type'}")
    authored = value_at(UsdGeom.PointBased(prim).GetPointsAttr(), time)
    points = vectors(authored, path, "points").astype(np.float64)
    if not len(points):
        raise refuse("GLYPH_EMPTY", path, "has no points")
    to_world = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(prim))[:3, :3]
    form: Literal["curve", "mesh"] = "mesh"
    if prim.IsA(UsdGeom.Mesh):
        counts, indices = checked_faces(UsdGeom.Mesh(prim), time, len(points))
    else:
        form, lines = "curve", _curves(UsdGeom.BasisCurves(prim), points, path)
        counts = np.array([*map(len, lines)], dtype=np.int64)
        points, indices = np.concatenate(lines), np.arange(counts.sum(), dtype=np.int64)
    if len(points) > _MOST_POINTS:
        what = f"has {len(points)} points; a glyph has {_MOST_POINTS} at most"
        raise refuse("GLYPH_EMPTY", path, what)
    up = "Z" if UsdGeom.GetStageUpAxis(prim.GetStage()) == UsdGeom.Tokens.z else "Y"
    glyph = Glyph(name, form, _fitted(points @ to_world, up, path), counts, indices)
    if form == "curve" or not left_handed(UsdGeom.Mesh(prim), to_world):
        return glyph
    return replace(glyph, indices=glyph.turned_round)


def _fitted(points: Floats, up: str, path: object) -> Floats:
    """The points as seen from above, in a sphere of radius 1 about the origin."""
    seen = points @ np.array(_TOP_VIEW[up], dtype=np.float64).T
    centred = seen - 0.5 * (seen.min(axis=0) + seen.max(axis=0))
    radius = float(np.linalg.norm(centred, axis=1).max())
    if not np.isfinite(radius):
        what = "its transform or its points are too large for floating-point numbers"
        raise refuse("NOT_FINITE", path, what)
    if radius <= 1e-12 * float(np.abs(seen).max()):
        raise refuse("GLYPH_EMPTY", path, "all its points are at one place")
    return np.asarray(centred / radius)


# --- curves ---------------------------------------------------------------------------------------


def _curves(gprim: UsdGeom.BasisCurves, points: Floats, path: object) -> list[Floats]:
    """Polylines for the curves; cubic ones in small straight pieces."""
    authored = value_at(gprim.GetCurveVertexCountsAttr(), Usd.TimeCode.Default())
    counts = integers(authored, path, "curveVertexCounts")
    if not len(counts) or counts.min() < 2 or counts.sum() != len(points):
        what = f"curves of {counts.tolist()[:9]} vertices for {len(points)} points"
        raise refuse("TOPOLOGY_INVALID", path, what)
    is_cubic = gprim.GetTypeAttr().Get() == UsdGeom.Tokens.cubic
    basis, wrap = str(gprim.GetBasisAttr().Get()) if is_cubic else "", gprim.GetWrapAttr().Get()
    if basis and basis not in _CUBIC:
        raise refuse("GLYPH_TYPE", path, f"has curves of the basis {basis!r}")
    return [_line(each, basis, wrap, path) for each in np.split(points, np.cumsum(counts)[:-1])]


def _line(vertices: Floats, basis: str, wrap: str, path: object) -> Floats:
    if not basis:
        return np.concatenate([vertices, vertices[:1]]) if wrap == "periodic" else vertices
    step = 3 if basis == "bezier" else 1
    if wrap == "periodic":
        vertices = np.concatenate([vertices, vertices[: 4 - step]])
    elif wrap == "pinned" and step == 1:
        # USD's own rule: phantom points that make the curve start and end in its end points.
        ends = 2.0 * vertices[[0, -1]] - vertices[[1, -2]]
        vertices = np.concatenate([ends[:1], vertices, ends[1:]])
    if len(vertices) < 4 or (len(vertices) - 4) % step:
        raise refuse(
            "TOPOLOGY_INVALID", path, f"a cubic {basis} curve cannot have {len(vertices)} vertices"
        )
    firsts = np.arange(0, len(vertices) - 3, step)
    powers = np.linspace(0.0, 1.0, _STEPS + 1)[:, None] ** np.arange(4)
    pieces = np.einsum(
        "tp,pc,kci->kti", powers, np.array(_CUBIC[basis]), vertices[firsts[:, None] + np.arange(4)]
    )
    return np.concatenate([pieces[:, :-1].reshape(-1, 3), pieces[-1, -1:]])
