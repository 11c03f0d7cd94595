"""Colours of a mesh at its points, the base colour of its materials or else its displayColor, and
the images that these come from."""

from __future__ import annotations

import io
from collections.abc import Iterator
from typing import Any

import numpy as np
from pxr import Ar, Gf, Sdf, Usd, UsdGeom, UsdShade

from usdrigui.character import Flags, Floats, Indices, Record, Texels, Texturing, Topology
from usdrigui.character.palette import decoded
from usdrigui.stages.arrays import value_at

_BASE_COLOURS = ("diffuseColor", "base_color", "baseColor", "diffuse_color_constant")
"""Inputs of UsdPreviewSurface, of MaterialX's standard surface, of glTF's and of MDL's."""
_CONTEXTS = ("", "mtlx", "mdl")
_MOST_PIXELS = 4096 * 4096
"""Of a texture that is read; larger ones take longer than all other reading."""
_MOST_SIDE = 1024
"""Texels of an image along a side, once it is read: a page has no room for more."""
_TILE = "<UDIM>"
"""In the name of a texture: the number of the tile that it is of."""
_Painted = tuple[Flags, Floats, Floats, Texels | None]
"""What a material gives some faces (faces,) of a mesh: (corners, 3) linear colours, and where
(corners, 2) these are in an image, if they come from one."""


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
        if not primvar.HasValue():
            return None
        flat = primvar.ComputeFlattened(self.time)
        if flat is None:
            flat = primvar.ComputeFlattened(Usd.TimeCode.EarliestTime())
        values = np.asarray(flat)
        if values.shape[1:] != (width,) or values.dtype.kind != "f":
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


def colours_and_images(
    prim: Usd.Prim, points: int, topology: Topology, time: Usd.TimeCode
) -> tuple[Floats | None, Texturing | None]:
    """(points, 3) linear colours from 0 to 1, None where the mesh has none, and the images that
    they come from, where there are any.

    Colours per face or per corner are averaged at each point.  A primvar whose length does not fit,
    a shader that is not known, and a texture that cannot be read or has more than sixteen million
    pixels give no colour.
    """
    corners, counts = _Corners(prim, points, topology, time), topology.face_counts
    colours, uv = corners.values("displayColor", 3), np.zeros((len(topology.face_indices), 2))
    image, images = np.full(len(counts), -1), list[Texels]()
    for material, bound in _bindings(prim, len(counts)):
        for faces, *painted, texels in _material_colours(material, bound, corners):
            chosen = np.repeat(faces, counts)[:, None]
            colours = np.where(chosen, painted[0], np.nan if colours is None else colours)
            uv = np.where(chosen, painted[1], uv)
            image = np.where(faces, -1 if texels is None else len(images), image)
            images += [] if texels is None else [texels]
    return (
        None if colours is None else _at_points(colours, points, topology.face_indices),
        Texturing(uv, image, tuple(images)) if images else None,
    )


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
    parts = [(prim, np.ones(faces, dtype=bool))]
    for subset in UsdShade.MaterialBindingAPI(prim).GetMaterialBindSubsets():
        members = np.asarray(subset.GetIndicesAttr().Get() or [], dtype=np.int64)
        parts.append((subset.GetPrim(), np.isin(np.arange(faces), members)))
    api = UsdShade.MaterialBindingAPI
    bound = [(api(part).ComputeBoundMaterial()[0], where) for part, where in parts]
    return [each for each in bound if each[0]]


def _material_colours(
    material: UsdShade.Material, faces: Flags, corners: _Corners
) -> Iterator[_Painted]:
    """The base colour of a material on some faces of the mesh, nothing where it has none."""
    base = _base_colour(material)
    sources = base.GetValueProducingAttributes() if base else []
    if not sources:
        return
    shader = UsdShade.Shader(sources[0].GetPrim())
    if shader.GetIdAttr().Get() == "UsdUVTexture":
        # Opacity that comes from the same image cuts it out: hair cards.
        cut = _source(UsdShade.Shader(base.GetPrim()), "opacity")
        yield from _textured(
            shader, faces, corners, cut is not None and cut.GetPrim() == shader.GetPrim()
        )
        return
    colour = np.asarray(value_at(sources[0], corners.time))
    if colour.shape == (3,) and colour.dtype.kind == "f":
        count = len(corners.topology.face_indices)
        linear = np.broadcast_to(colour.astype(np.float64), (count, 3))
        yield faces, linear, np.zeros((count, 2)), None


def _base_colour(material: UsdShade.Material) -> Any:
    for context in _CONTEXTS:
        shader = material.ComputeSurfaceSource(context)[0]
        for name in _BASE_COLOURS if shader else ():
            if shader.GetInput(name):
                return shader.GetInput(name)
    return None


def _textured(
    shader: UsdShade.Shader, faces: Flags, corners: _Corners, cut: bool
) -> Iterator[_Painted]:
    """The texture at the corners: one image, or one for each tile that the faces lie on."""
    uv = _coordinates(shader, corners)
    file = _file(shader)
    if uv is None or not np.isfinite(uv).all():
        return
    tiles = _tiles(uv, corners.topology) if _TILE in file else np.zeros(len(faces), dtype=np.int64)
    for tile in np.unique(tiles[faces]).tolist():
        image = _image(file.replace(_TILE, str(tile)))
        if image is None:
            continue
        tall, wide = image.shape[:2]
        column = np.floor((uv[:, 0] % 1.0) * wide).astype(np.int64).clip(0, wide - 1)
        row = np.floor((1.0 - uv[:, 1] % 1.0) * tall).astype(np.int64).clip(0, tall - 1)
        if not cut:
            image[..., 3] = 255
        linear = decoded(image[row, column, :3].astype(np.float64) / 255.0)
        yield faces & (tiles == tile), linear, uv, image


def _tiles(uv: Floats, topology: Topology) -> Indices:
    """(faces,) the tile that the middle of each face lies on: ten in a row, the first is 1001."""
    counts = topology.face_counts
    face = np.repeat(np.arange(len(counts)), counts)
    sums = [np.bincount(face, weights=axis, minlength=len(counts)) for axis in uv.T]
    column, row = np.floor(sums / np.maximum(counts, 1)).clip(0.0, 899.0)
    tiles: Indices = (1001.0 + np.minimum(column, 9.0) + 10.0 * row).astype(np.int64)
    return tiles


def _coordinates(shader: UsdShade.Shader, corners: _Corners) -> Floats | None:
    """(corners, 2) what a texture is looked up by: the primvar that its reader names, scaled,
    turned and moved by a UsdTransform2d between the two; other shaders have no such inputs."""
    place = _shader_of(shader, "st")
    uv = corners.values(_said(_shader_of(place, "in"), "varname", "st"), 2)
    if uv is None:
        return None
    # https://openusd.org/release/spec_usdpreviewsurface.html: counterclockwise, in degrees
    turn = np.radians(_said(place, "rotation", 0.0))
    turned = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    scale, shift = _said(place, "scale", Gf.Vec2f(1.0)), _said(place, "translation", Gf.Vec2f(0.0))
    return np.asarray(uv * scale @ turned + shift)


def _said(shader: UsdShade.Shader, name: str, fallback: Any) -> Any:
    """An input of the type of its fallback, or that."""
    source = _source(shader, name)
    value = source.Get() if source else None
    return value if isinstance(value, type(fallback)) else fallback


def _source(shader: UsdShade.Shader, name: str) -> Usd.Attribute | None:
    """The attribute that gives an input of a shader its value."""
    return next(iter(shader.GetInput(name).GetValueProducingAttributes()), None)


def _shader_of(shader: UsdShade.Shader, name: str) -> UsdShade.Shader:
    """The shader that gives an input of another one its value, itself where none does."""
    source = _source(shader, name)
    return UsdShade.Shader(source.GetPrim()) if source else shader


def _file(shader: UsdShade.Shader) -> str:
    """The path of a texture's file, with `_TILE` where it has several; empty where it has none."""
    source, asset = _source(shader, "file"), _said(shader, "file", Sdf.AssetPath())
    if source and _TILE in asset.path:
        layer = source.GetPropertyStack()[0].layer
        return str(UsdShade.UdimUtils.ResolveUdimPath(asset.path, layer))
    return str(asset.resolvedPath)


def _image(path: str) -> Any:
    """(tall, wide, 4) bytes of a texture file, None where it cannot be read or is too large."""
    opened = Ar.GetResolver().OpenAsset(Ar.ResolvedPath(path))
    if not opened:
        return None
    from PIL import Image, UnidentifiedImageError  # few assets come with textures

    try:
        with Image.open(io.BytesIO(bytes(opened.GetBuffer()))) as image:
            if image.width * image.height > _MOST_PIXELS:
                return None
            image.draft("RGB", (_MOST_SIDE, _MOST_SIDE))  # a JPEG is read smaller at once
            small = image.convert("RGBA")
            small.thumbnail((_MOST_SIDE, _MOST_SIDE))
            return np.array(small)
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return None
