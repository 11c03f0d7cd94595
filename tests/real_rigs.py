"""The real rigs as tests use them: laid out once a run, turned and scaled copies, shapes added to them."""

from functools import cache
from pathlib import Path

import chain
import makers
import numpy as np
from folders import ASSETS
from pxr import Gf, Usd, UsdGeom

from usdrigui.character import Channel
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load

WORK = 100_000
"""Work after which a solve ends: every claim tested must hold without the last per cent of the cost."""


def asset(name):
    """Path of the rig of that name."""
    return ASSETS / f"{name}.usdc"


@cache
def line_of(name, joints="auto"):
    """Every record of one rig's layout, made once a run."""
    (rig,) = read_rigs(asset(name), load({"read": {"joints": joints}}))
    return laid_out(rig)


def laid_out(rig, work=WORK):
    """Every record of the layout of `rig`."""
    settings = load({"solve": {"work_limit": work}})
    return chain.solved(chain.problem_of(rig, settings), settings.solve)


def on_face(line):
    """Elements that stand on the face."""
    return [element for element in line.layout.elements if not element.anchor.on_board]


def point_of(line, element):
    """The element's anchor as a point of the rig."""
    starts = line.face.rig.body.starts
    paths = [mesh.path for mesh in line.face.rig.body.meshes]
    return int(starts[paths.index(element.anchor.mesh)] + element.anchor.point)


def homes(line):
    """Element of every control."""
    return {member.control: element for element in line.layout.elements for member in element.members}


# --- copies ------------------------------------------------------------------------------------------


def referring(name, folder, scale, z_up):
    """A stage that refers to the rig below an Xform that scales it and, if asked, turns it into a Z-up world."""
    stage = Usd.Stage.CreateNew(str(folder / f"{name}_referred.usda"))
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z if z_up else UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    above = UsdGeom.Xform.Define(stage, "/Shot")
    above.AddTranslateOp().Set(Gf.Vec3d(scale, -2.0 * scale, 3.0))
    if z_up:
        above.AddRotateXOp().Set(90.0)
    above.AddScaleOp().Set(Gf.Vec3f(scale))
    stage.SetDefaultPrim(above.GetPrim())
    stage.OverridePrim("/Shot/Char").GetReferences().AddReference(str(asset(name)))
    stage.Save()
    return Path(stage.GetRootLayer().realPath)


# --- additions ---------------------------------------------------------------------------------------


def with_whole_head_shapes(rig, base, moved):
    """The rig with five more controls: the head lifted, enlarged, widened, made fuller, and its earrings hidden.

    `base` (n, 3) are its points, `moved` those that its own controls move.  The earrings are two balls beside
    the head, a mesh of their own; the last control collapses each.
    """
    head = _head(rig, base, moved)
    middle = np.average(base, axis=0, weights=head + 1e-12)
    size = float(np.ptp(base[moved] @ rig.up))
    shapes = {
        "headUp": head[:, None] * (0.2 * size * rig.up),
        "headSize": head[:, None] * 0.15 * (base - middle),
        "headWide": head[:, None] * (base - middle) * np.array([0.2, 0.0, 0.0]),
        "headFuller": head[:, None] * (base - middle) * np.array([0.2, 0.0, 0.2]),
    }
    meshes = [_with_shapes(rig, index, shapes) for index in range(len(rig.body.meshes))]
    meshes.append(_earrings(middle, size, len(rig.body.channels) + len(shapes)))
    names = [*shapes, "hideEarrings"]
    first = len(rig.body.channels)
    return makers.changed(
        rig,
        meshes=tuple(meshes),
        channels=(*rig.body.channels, *(Channel(name, "", -1) for name in names)),
        base_weights=np.append(rig.body.base_weights, np.zeros(len(names))),
        controls=(*rig.controls, *(makers.control(name, first + at) for at, name in enumerate(names))),
    )


def _head(rig, base, moved):
    """(n,) one on the head, fading out below the lowest point that a control moves."""
    height = base @ rig.up
    low, high = height[moved].min(), height[moved].max()
    return np.clip((height - low) / (0.1 * (high - low)) + 1.0, 0.0, 1.0)


def _with_shapes(rig, index, shapes):
    """One mesh with its part of the new shapes, whose offsets are in root space."""
    mesh, (low, high) = rig.body.meshes[index], rig.body.starts[index : index + 2]
    to_mesh = np.linalg.inv(mesh.to_root if mesh.skin is None else mesh.skin.geom_bind)[:3, :3]
    new = [
        makers.shape(len(rig.body.channels) + at, offsets[low:high] @ to_mesh)
        for at, offsets in enumerate(shapes.values())
    ]
    return makers.changed(mesh, shapes=(*mesh.shapes, *new))


def _earrings(middle, size, channel):
    """Two octahedra at the sides of the head and the shape that collapses each into its middle."""
    corners = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64)
    faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    centres = [middle + np.array([side * 1.2 * size, 0.0, 0.0]) for side in (-1.0, 1.0)]
    points = np.concatenate([centre + 0.1 * size * corners for centre in centres])
    collapse = np.concatenate([-0.1 * size * corners] * 2)
    both = faces + [[at + 6 for at in face] for face in faces]
    return makers.mesh(points, both, [makers.shape(channel, collapse)], path="/Root/earrings")
