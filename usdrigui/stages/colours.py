"""Colours of a mesh at its points: the base colour of its materials, or else its displayColor."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
from pxr import Ar, Usd, UsdGeom, UsdShade

from usdrigui.character import Floats, Indices, Record, Topology
from usdrigui.stages.arrays import value_at

_BASE_COLOURS = ("diffuseColor", "base_color", "baseColor", "diffuse_color_constant")
"""Inputs of UsdPreviewSurface, of MaterialX's standard surface, of glTF's and of MDL's."""
_CONTEXTS = ("", "mtlx", "mdl")
_MOST_PIXELS = 2048 * 2048
"""Of a texture that is read; larger ones take longer than all other reading."""


class _Corners(Record):
    """The corners of the faces of a mesh, at which colours are looked up."""

    prim: Usd.Prim
    points: int
    topology: Topology
    time: Usd.TimeCode

    def values(self, name: str, width: int) -> Floats | None:
        """(corners, width) values of a primvar of any interpolation, flattened; None where it does
        not fit the mesh."""
        primvar = UsdGeom.PrimvarsAPI(self.prim).FindPrimvarWithInheritance(name)
        if not primvar or not primvar.HasValue():
            return None
        flat = primvar.ComputeFlattened(self.time)
        if flat is None:
            flat = primvar.ComputeFlattened(Usd.TimeCode.EarliestTime())
        values = np.asarray(flat)
        if values.ndim != 2 or values.shape[1] != width or values.dtype.kind != "f":
            return None
        counts, indices = self.topology.face_counts, self.topology.face_indices
        corners = np.arange(len(indices))
        ways = {
            "constant": (1, np.zeros_like(corners)),
            "uniform": (len(counts), np.repeat(np.arange(len(counts)), counts)),
            "vertex": (self.points, indices),
            "varying": (self.points, indices),
            "faceVarying": (len(corners), corners),
        }
        size, index = ways.get(str(primvar.GetInterpolation()), (-1, corners))
        return values.astype(np.float64)[index] if size == len(values) else None


def point_colours(
    prim: Usd.Prim, points: int, topology: Topology, time: Usd.TimeCode
) -> Floats | None:
    """(points, 3) linear colours from 0 to 1, None where the mesh has none.

    Colours per face or per corner are averaged at each point.  A primvar whose length does not fit,
    a shader that is not known, and a texture that cannot be read or has more than four million
    pixels give no colour.
    """
    corners, counts = _Corners(prim, points, topology, time), topology.face_counts
    colours = corners.values("displayColor", 3)
    for material, faces in _bindings(prim, len(counts)):
        painted = _material_colours(material, corners)
        if painted is not None:
            chosen = np.repeat(faces, counts)[:, None]
            colours = np.where(chosen, painted, np.nan if colours is None else colours)
    return None if colours is None else _at_points(colours, points, topology.face_indices)


def _at_points(corners: Floats, points: int, indices: Indices) -> Floats | None:
    """(points, 3) means of the corners that have a colour; points without any get the mean of
    all."""
    known = np.isfinite(corners).all(axis=1)
    if not known.any():
        return None
    at, colours = indices[known], np.clip(corners[known], 0.0, 1.0)
    weight = np.bincount(at, minlength=points)
    total = np.stack(
        [np.bincount(at, weights=axis, minlength=points) for axis in colours.T], axis=1
    )
    mean = colours.mean(axis=0)
    return np.where(weight[:, None] > 0, total / np.maximum(weight, 1)[:, None], mean)


# --- materials ------------------------------------------------------------------------------------


def _bindings(prim: Usd.Prim, faces: int) -> list[tuple[UsdShade.Material, Any]]:
    """Materials of the mesh and of its subsets, each with the flags (faces,) of where it is
    bound."""
    found = []
    whole = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0]
    if whole:
        found.append((whole, np.ones(faces, dtype=bool)))
    for subset in UsdShade.MaterialBindingAPI(prim).GetMaterialBindSubsets():
        material = UsdShade.MaterialBindingAPI(subset.GetPrim()).ComputeBoundMaterial()[0]
        members = np.asarray(subset.GetIndicesAttr().Get() or [], dtype=np.int64)
        if material:
            found.append((material, np.isin(np.arange(faces), members)))
    return found


def _material_colours(material: UsdShade.Material, corners: _Corners) -> Floats | None:
    """(corners, 3) base colour of a material on the mesh, None where it has none."""
    base = _base_colour(material)
    sources = base.GetValueProducingAttributes() if base else []
    if not sources:
        return None
    shader = UsdShade.Shader(sources[0].GetPrim())
    if shader and shader.GetIdAttr().Get() == "UsdUVTexture":
        return _textured(shader, corners)
    value = value_at(sources[0], corners.time) if len(sources) == 1 else None
    colour = np.asarray(() if value is None else value, dtype=np.float64)
    if colour.shape != (3,) or not np.isfinite(colour).all():
        return None
    return np.broadcast_to(colour, (len(corners.topology.face_indices), 3))


def _base_colour(material: UsdShade.Material) -> Any:
    for context in _CONTEXTS:
        shader = material.ComputeSurfaceSource(context)[0]
        for name in _BASE_COLOURS if shader else ():
            if shader.GetInput(name):
                return shader.GetInput(name)
    return None


def _textured(shader: UsdShade.Shader, corners: _Corners) -> Floats | None:
    """(corners, 3) the texture at the corners, by the primvar that its reader names."""
    uv, image = corners.values(_uv_name(shader), 2), _image(shader)
    if uv is None or image is None or not np.isfinite(uv).all():
        return None
    tall, wide = image.shape[:2]
    column = np.floor((uv[:, 0] % 1.0) * wide).astype(np.int64).clip(0, wide - 1)
    row = np.floor((1.0 - uv[:, 1] % 1.0) * tall).astype(np.int64).clip(0, tall - 1)
    return _linear(image[row, column].astype(np.float64) / 255.0)


def _uv_name(shader: UsdShade.Shader) -> str:
    reader = _source(shader, "st")
    name = _source(UsdShade.Shader(reader.GetPrim()), "varname") if reader else None
    return str(name.Get() or "st") if name else "st"


def _source(shader: UsdShade.Shader, name: str) -> Usd.Attribute | None:
    """The attribute that gives an input of a shader its value."""
    named = shader.GetInput(name) if shader else None
    return next(iter(named.GetValueProducingAttributes() if named else ()), None)


def _image(shader: UsdShade.Shader) -> Any:
    """(tall, wide, 3) bytes of the texture file, None where it cannot be read or is too large."""
    source = _source(shader, "file")
    asset = source.Get() if source else None
    if not asset or not asset.resolvedPath:
        return None
    opened = Ar.GetResolver().OpenAsset(Ar.ResolvedPath(asset.resolvedPath))
    if not opened:
        return None
    from PIL import Image, UnidentifiedImageError  # few assets come with textures

    try:
        with Image.open(io.BytesIO(bytes(opened.GetBuffer()))) as image:
            is_small = image.width * image.height <= _MOST_PIXELS
            return np.asarray(image.convert("RGB")) if is_small else None
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return None


def _linear(encoded: Floats) -> Floats:
    """sRGB, as the files of colour textures hold it, to linear light."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
