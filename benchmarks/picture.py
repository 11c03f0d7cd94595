"""Time of the preview picture: ``python benchmarks/picture.py ASSET [--elements 150] [-o
OUT.png]``.

Lays elements at random points that move (no optimiser), draws front and three-quarter views and
prints the seconds of processor time and of the clock, with Embree where it is installed and with
numpy alone.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import numpy as np

from usdrigui.character import Rig
from usdrigui.character.deform import knots, posed, sweep
from usdrigui.character.rays import TreeCaster, make_caster
from usdrigui.character.surface import mesh_triangles, vertex_normals
from usdrigui.model import (
    Anchor,
    Element,
    Layout,
    LayoutFrame,
    Member,
    MirrorPlane,
    Proof,
)
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings
from usdrigui.view.body import shading
from usdrigui.view.picture import render


def scattered(rig: Rig, count: int) -> Layout:
    """``count`` sliders, control after control, each at a random point that its control moves."""
    rng = np.random.default_rng(0)
    values = np.array([control.default for control in rig.controls])
    base = posed(rig, values)
    normals = vertex_normals(
        base.points, mesh_triangles(rig.body.meshes), np.arange(len(base.points))
    )
    elements: list[Element] = []
    for number in range(20 * count):
        j = number % len(rig.controls)
        at = knots(rig, j)
        points, offsets = sweep(rig, base, j, at)
        length = np.linalg.norm(offsets[-1] - offsets[0], axis=1) if len(points) else np.zeros(0)
        moving = np.flatnonzero(length > 0.5 * length.max(initial=0.0))
        if len(moving) and len(elements) < count:
            row = int(rng.choice(moving))
            elements.append(
                _slider(rig, number, j, at, base.points, normals, int(points[row]), offsets[:, row])
            )
    anchors = np.array([element.anchor.position for element in elements])
    # Facing +Z with Y up, or -Y with Z up: the left is +X.
    front = np.cross(np.array([1.0, 0.0, 0.0]), rig.up)
    zero = np.zeros(3)
    width = 0.02 * float(np.ptp(anchors @ rig.up))
    return Layout(
        root=rig.path,
        base_values=values,
        elements=tuple(elements),
        left_off=(),
        frame=LayoutFrame(
            space="object",
            view=front,
            plane=MirrorPlane(origin=zero, normal=zero),
            handle_width=width,
        ),
        proof=Proof(
            method="scattered", status="stopped", cost=0.0, bound=-np.inf, above_unary_bound=0.0
        ),
    )


def _slider(rig, number, j, at, points, normals, point, offsets) -> Element:
    where, local = rig.body.mesh_of(point)
    anchor = Anchor(
        where.path,
        local,
        len(where.points),
        where.topology.hash,
        points[point],
        normals[point],
        False,
    )
    member = Member(rig.controls[j].name, at, points[point] + offsets.astype(np.float64), 1.0, 1.0)
    side = "left" if points[point][0] > 0 else "right"
    return Element(
        name=f"e{number}",
        kind="slider",
        members=(member,),
        anchor=anchor,
        label=rig.controls[j].label,
        side=side,
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("asset", type=Path)
    parser.add_argument("--elements", type=int, default=150)
    parser.add_argument("-o", "--output", type=Path)
    given = parser.parse_args()
    rig, *_ = read_rigs(given.asset, Settings())
    layout = scattered(rig, given.elements)
    points = sum(len(mesh.points) for mesh in rig.body.meshes)
    print(
        f"{given.asset.name}: {points} points, {len(layout.elements)} elements, 3 views, 1800 x"
        " 1000"
    )
    for name, caster in (("as installed", make_caster), ("numpy alone", TreeCaster)):
        shading.make_caster = caster
        began, clock = time.process_time(), time.perf_counter()
        image = render(rig, layout)
        print(
            f"{name:13} {time.process_time() - began:5.2f} s processor,"
            f" {time.perf_counter() - clock:5.2f} s clock"
        )
        if given.output is not None and caster is make_caster:
            image.save(given.output)


if __name__ == "__main__":
    main()
