"""How much of each handle is seen without our code: ``python benchmarks/visible.py LAYER
[--all]``.

Stock USD geometry below the layout's Scope against the meshes of the character, at rest and in
parallel projection, from the viewer of the element's part and from 40 degrees to either side;
parts on both sides of the character, such as hands, also from the mirror image of that view.  Per
element on the skin the share of its circle, as wide as handles of its part are, in which a handle
is in front of the character, in the best view.  Prints the median, the 5 % quantile and the share
of the handles at 60 % and more; exits with 1 if that is below 95 %.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

import numpy as np
from pxr import Usd, UsdGeom
from turned_views import bases

from usdrigui.character import Floats
from usdrigui.character.surface import triangles
from usdrigui.layer.read_layout import element_prims, layout_at, layout_scopes

_SEEN, _MOST = 0.6, 0.95
_GRID = np.stack(np.meshgrid(*2 * [np.linspace(-0.5, 0.5, 25)]), axis=-1).reshape(-1, 2)
_DISC = _GRID[(_GRID**2).sum(axis=1) <= 0.25]


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("layer", type=Path)
    parser.add_argument("--all", action="store_true", help="list every handle, the worst first")
    options = parser.parse_args()
    stage = Usd.Stage.Open(str(options.layer))
    shares = [each for scope in layout_scopes(stage) for each in seen(scope)]
    if options.all:
        for share, name in sorted(shares):
            print(f"  {name:40s} {share:.2f}")
    numbers = np.array([share for share, _ in shares])
    enough = float((numbers >= _SEEN).mean())
    print(
        f"{options.layer.name}: {len(numbers)} handles, of the circle seen: median"
        f" {np.median(numbers):.2f}, 5 % {np.quantile(numbers, 0.05):.2f}; at 60 % and more:"
        f" {enough:.0%}"
    )
    return int(enough < _MOST)


def seen(scope: Usd.Prim) -> list[tuple[float, str]]:
    """The share of each handle on the character that is in sight, with the element's name."""
    layout, root = layout_at(scope), scope.GetParent()
    cache = UsdGeom.XformCache()
    to_root = np.linalg.inv(np.array(cache.GetLocalToWorldTransform(root)))
    inside = scope.GetPath()
    guides = _soup(root, cache, to_root, lambda prim: prim.GetPath().HasPrefix(inside))
    body = _soup(root, cache, to_root, lambda prim: not prim.GetPath().HasPrefix(inside))
    up = np.eye(3)["YZ".index(UsdGeom.GetStageUpAxis(scope.GetStage())) + 1] @ to_root[:3, :3]
    up /= np.linalg.norm(up)
    across = layout.frame.plane.normal
    found = []
    for prim, element in zip(element_prims(scope), layout.elements, strict=True):
        if element.anchor.on_board:
            continue
        view = layout.frame.view_of(element.part)
        width = layout.frame.handle_width_of(element.part)
        share = 0.0
        for basis in bases(view, up, across):
            samples = (element.anchor.position @ basis)[:2] + width * _DISC
            front, back = (_depth(each, basis, samples) for each in (guides, body))
            share = max(share, float((np.isfinite(front) & (front > back)).mean()))
        found.append((share, prim.GetName()))
    return found


def _soup(
    root: Usd.Prim,
    cache: UsdGeom.XformCache,
    to_root: Floats,
    wanted: Callable[[Usd.Prim], bool],
) -> Floats:
    """(t, 3, 3) triangles of the meshes below a SkelRoot in its space, in the bind pose."""
    found = [np.zeros((0, 3, 3))]
    for prim in Usd.PrimRange(root):
        if not prim.IsA(UsdGeom.Mesh) or not wanted(prim):
            continue
        mesh = UsdGeom.Mesh(prim)
        bind = prim.GetAttribute("primvars:skel:geomBindTransform")
        held = bind.Get() if bind else None
        to_world = np.array(cache.GetLocalToWorldTransform(prim))
        matrix = (np.eye(4) if held is None else np.array(held)) @ to_world @ to_root
        points = np.array(mesh.GetPointsAttr().Get() or np.zeros((0, 3)), dtype=np.float64)
        faces = (mesh.GetFaceVertexCountsAttr().Get(), mesh.GetFaceVertexIndicesAttr().Get())
        found.append((points @ matrix[:3, :3] + matrix[3, :3])[triangles(*faces)])
    return np.concatenate(found)


def _depth(soup: Floats, basis: Floats, samples: Floats) -> Floats:
    """(n,) greatest depth of triangles at samples (n, 2) in the plane; -inf where there is none."""
    flat = soup @ basis
    low, high = flat[..., :2].min(axis=1), flat[..., :2].max(axis=1)
    near = ((high >= samples.min(axis=0)) & (low <= samples.max(axis=0))).all(axis=1)
    a, b, c = np.moveaxis(flat[near], 1, 0)
    area = (b[:, 1] - c[:, 1]) * (a[:, 0] - c[:, 0]) + (c[:, 0] - b[:, 0]) * (a[:, 1] - c[:, 1])
    kept = np.abs(area) > 1e-18
    a, b, c, area = a[kept], b[kept], c[kept], area[kept]
    x, y = samples[:, :1], samples[:, 1:]
    u = ((b[:, 1] - c[:, 1]) * (x - c[:, 0]) + (c[:, 0] - b[:, 0]) * (y - c[:, 1])) / area
    v = ((c[:, 1] - a[:, 1]) * (x - c[:, 0]) + (a[:, 0] - c[:, 0]) * (y - c[:, 1])) / area
    depth = u * a[:, 2] + v * b[:, 2] + (1.0 - u - v) * c[:, 2]
    depth[(u < -1e-9) | (v < -1e-9) | (u + v > 1.0 + 1e-9)] = -np.inf
    return np.asarray(depth.max(axis=1, initial=-np.inf))


if __name__ == "__main__":
    raise SystemExit(main())
