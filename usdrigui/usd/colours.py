"""Colours of a mesh at its points: the base colour of its materials, or else its displayColor."""

from __future__ import annotations

import io
from typing import Any

import numpy as np
from pxr import Ar, Usd, UsdGeom, UsdShade

from usdrigui.model import Floats, Indices
from usdrigui.usd.arrays import value_at

_BASE_COLOURS = ("diffuseColor", "base_color", "baseColor", "diffuse_color_constant")
"""Inputs of UsdPreviewSurface, of MaterialX's standard surface, of glTF's and of MDL's."""
_CONTEXTS = ("", "mtlx", "mdl")
_MOST_PIXELS = 2048 * 2048
"""Of a texture that is read; larger ones take longer than all other reading."""


def point_colours(
    prim: Usd.Prim, points: int, counts: Indices, indices: Indices, time: Usd.TimeCode
) -> Floats | None:
    """(points, 3) linear colours from 0 to 1, None where the mesh has none.

    Colours per face or per corner are averaged at each point.  A primvar whose length does not fit,
    a shader that is not known, and a texture that cannot be read or has more than four million
    pixels give no colour.
    """
    corners = _display_colours(UsdGeom.PrimvarsAPI(prim), points, counts, indices, time)
    for bound, faces in _bindings(prim, len(counts)):
        painted = _material_colours(bound, prim, points, counts, indices, time)
        if painted is not None:
            chosen = np.repeat(faces, counts)[:, None]
            corners = np.where(chosen, painted, np.nan if corners is None else corners)
    return None if corners is None else _at_points(corners, points, indices)


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


def _display_colours(
    primvars: Any, points: int, counts: Indices, indices: Indices, time: Usd.TimeCode
) -> Floats | None:
    return _at_corners(
        primvars.FindPrimvarWithInheritance("displayColor"), 3, points, counts, indices, time
    )


def _at_corners(
    primvar: Any, width: int, points: int, counts: Indices, indices: Indices, time: Usd.TimeCode
) -> Floats | None:
    """(corners, width) values of a primvar of any interpolation, flattened; None where it does not
    fit the mesh."""
    if not primvar or not primvar.HasValue():
        return None
    flat = primvar.ComputeFlattened(time)
    values = np.asarray(
        flat if flat is not None else primvar.ComputeFlattened(Usd.TimeCode.EarliestTime())
    )
    if values.ndim != 2 or values.shape[1] != width or values.dtype.kind != "f":
        return None
    values = values.astype(np.float64)
    spread: dict[str, Indices] = {
        "constant": np.zeros(len(indices), dtype=np.int64),
        "uniform": np.repeat(np.arange(len(counts)), counts),
        "vertex": indices,
        "varying": indices,
        "faceVarying": np.arange(len(indices)),
    }
    sizes = {
        "constant": 1,
        "uniform": len(counts),
        "vertex": points,
        "varying": points,
        "faceVarying": len(indices),
    }
    interpolation = str(primvar.GetInterpolation())
    return values[spread[interpolation]] if sizes.get(interpolation) == len(values) else None


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


def _material_colours(
    material: UsdShade.Material,
    prim: Usd.Prim,
    points: int,
    counts: Indices,
    indices: Indices,
    time: Usd.TimeCode,
) -> Floats | None:
    """(corners, 3) base colour of a material on the mesh, None where it has none."""
    base = _base_colour(material)
    if base is None:
        return None
    sources = base.GetValueProducingAttributes()
    shader = UsdShade.Shader(sources[0].GetPrim()) if sources else UsdShade.Shader()
    if shader and shader.GetIdAttr().Get() == "UsdUVTexture":
        return _textured(shader, prim, points, counts, indices, time)
    value = value_at(sources[0], time) if len(sources) == 1 else None
    colour = np.asarray(value if value is not None else (), dtype=np.float64)
    return (
        np.broadcast_to(colour, (len(indices), 3))
        if colour.shape == (3,) and np.isfinite(colour).all()
        else None
    )


def _base_colour(material: UsdShade.Material) -> Any:
    for context in _CONTEXTS:
        shader = material.ComputeSurfaceSource(context)[0]
        for name in _BASE_COLOURS if shader else ():
            if shader.GetInput(name):
                return shader.GetInput(name)
    return None


def _textured(
    shader: UsdShade.Shader,
    prim: Usd.Prim,
    points: int,
    counts: Indices,
    indices: Indices,
    time: Usd.TimeCode,
) -> Floats | None:
    """(corners, 3) the texture at the corners, by the primvar that its reader names."""
    primvar = UsdGeom.PrimvarsAPI(prim).FindPrimvarWithInheritance(_uv_name(shader))
    uv, image = _at_corners(primvar, 2, points, counts, indices, time), _image(shader)
    if uv is None or image is None or not np.isfinite(uv).all():
        return None
    tall, wide = image.shape[:2]
    column = np.floor((uv[:, 0] % 1.0) * wide).astype(np.int64).clip(0, wide - 1)
    row = np.floor((1.0 - uv[:, 1] % 1.0) * tall).astype(np.int64).clip(0, tall - 1)
    return _linear(image[row, column].astype(np.float64) / 255.0)


def _uv_name(shader: UsdShade.Shader) -> str:
    st = shader.GetInput("st")
    sources = st.GetValueProducingAttributes() if st else []
    reader = UsdShade.Shader(sources[0].GetPrim()) if sources else UsdShade.Shader()
    named = reader.GetInput("varname") if reader else None
    found = named.GetValueProducingAttributes() if named else []
    return str(found[0].Get() or "st") if found else "st"


def _image(shader: UsdShade.Shader) -> Any:
    """(tall, wide, 3) bytes of the texture file, None where it cannot be read or is too large."""
    file = shader.GetInput("file")
    sources = file.GetValueProducingAttributes() if file else []
    asset = sources[0].Get() if sources else None
    opened = (
        Ar.GetResolver().OpenAsset(Ar.ResolvedPath(asset.resolvedPath))
        if asset and asset.resolvedPath
        else None
    )
    if not opened:
        return None
    from PIL import Image, UnidentifiedImageError  # few assets come with textures

    try:
        with Image.open(io.BytesIO(bytes(opened.GetBuffer()))) as image:
            return (
                np.asarray(image.convert("RGB"))
                if image.width * image.height <= _MOST_PIXELS
                else None
            )
    except (UnidentifiedImageError, OSError, ValueError, SyntaxError, Image.DecompressionBombError):
        return None


def _linear(encoded: Floats) -> Floats:
    """sRGB, as the files of colour textures hold it, to linear light."""
    return np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
