"""Characters with layouts for Blender, and where USD says that their points are in Blender's world."""

import laid_out
import makers
import numpy as np
import skinned_stages
from folders import SAMPLE
from pxr import Usd, UsdGeom
from usdskel_oracle import Oracle
from viewer_layouts import member_at

from usdrigui.character.deform import channel_state, posed
from usdrigui.model import Element, Member
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

Z_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
"""Row-vector map from Y up to Z up."""


def written(source, **options):
    """Lay a character out at random points; returns (layer, rig, layout)."""
    (rig,) = read_rigs(source, Settings())
    layout = laid_out.layout_of(rig, **options)
    target = source.with_name(f"{source.stem}.rigui.usda")
    laid_out.written(source, rig, layout, target.name)
    return target, rig, layout


def skinned(folder, name, **kind):
    """One of the small, nasty skinned characters, laid out."""
    return written(skinned_stages.character(folder / f"{name}.usda", **kind))


def to_world(source, rig):
    """Function from root space to Blender's world: metres, Z up."""
    stage = Usd.Stage.Open(str(source))
    matrix = np.array(UsdGeom.XformCache().GetLocalToWorldTransform(stage.GetPrimAtPath(rig.path)))
    turn = Z_UP if UsdGeom.GetStageUpAxis(stage) == "Y" else np.eye(3)
    size = UsdGeom.GetStageMetersPerUnit(stage)
    return lambda points: size * ((np.asarray(points) @ matrix[:3, :3] + matrix[3, :3]) @ turn)


def usdskel_points(source, rig, values):
    """By mesh path, UsdSkel's points in root space at control values."""
    points = Oracle(source, rig).deformed(*channel_state(rig, values))
    bounds = zip(rig.body.meshes, rig.body.starts[:-1], rig.body.starts[1:], strict=True)
    return {mesh.path: points[start:end] for mesh, start, end in bounds}


def diagonal(points):
    """Length of the diagonal of the box around all points."""
    return float(np.linalg.norm(np.ptp(np.concatenate(list(points)), axis=0)))


# --- the sample, laid out by hand ---------------------------------------------------------------------

_ON_FACE = {
    "jaw": ("patch", ("jawRight", "jawLeft", "jawOpen"), ((0, 1),), "Head", 641, "middle", ""),
    "mouthSmileLeft": ("slider", ("mouthSmileLeft",), (), "Head", 1253, "left", "mouthSmileRight"),
    "mouthSmileRight": ("slider", ("mouthSmileRight",), (), "Head", 2743, "right", "mouthSmileLeft"),
    "browInnerUp": ("slider", ("browInnerUp",), (), "Head", 174, "middle", ""),
    "browOuterUpLeft": ("slider", ("browOuterUpLeft",), (), "Brows", 44, "left", ""),
    "cheekPuff": ("slider", ("cheekPuff",), (), "Head", 2028, "middle", ""),
    "cheekSquintLeft": ("slider", ("cheekSquintLeft",), (), "Head", 357, "left", ""),
    "EyeLeft:ry": ("slider", ("EyeLeft:ry",), (), "EyeLeft", 166, "left", "EyeRight:ry"),
    "EyeRight:ry": ("slider", ("EyeRight:ry",), (), "EyeRight", 166, "right", "EyeLeft:ry"),
    "lidLeft": ("slider", ("eyeBlinkLeft", "eyeWideLeft"), ((0, 1),), "Lashes", 32, "left", ""),
}
"""Elements of the sample: kind, controls, opposed, mesh, point, side, mirror."""


def sample(folder):
    """The sample with a patch, sliders, a two-way slider and a joystick beside it; (layer, rig, source)."""
    source = folder / "char.usda"
    for name in ("char.usda", "char_geometry.usda"):
        (folder / name).write_bytes((SAMPLE.parent / name).read_bytes())
    (rig,) = read_rigs(source, Settings())
    base = posed(rig)
    elements = [_on_face(rig, base, name, *said) for name, said in _ON_FACE.items()]
    layout = makers.layout(
        rig,
        *elements,
        _joystick(rig),
        base_values=rig.defaults,
        drawn=makers.frame(0.44, normal=(1.0, 0.0, 0.0)),
    )
    target = folder / "char.rigui.usda"
    laid_out.written(source, rig, layout, target.name)
    return target, rig, source


def _on_face(rig, base, name, kind, controls, opposed, mesh, local, side, mirror):
    number = next(i for i, each in enumerate(rig.body.meshes) if each.path.endswith(f"/{mesh}"))
    point = int(rig.body.starts[number]) + local
    index = rig.control_indices
    toward = base.points[point] * (1.0, 0.0, 1.0)
    members = tuple(member_at(rig, base, index[one], point, np.zeros(3)) for one in controls)
    inner = ("cheekSquintLeft",) if name == "cheekPuff" else ()
    return Element(
        name=name,
        kind=kind,
        members=members,
        opposed=opposed,
        mirror=mirror,
        anchor=makers.anchor(rig, point, base.points[point], toward / np.linalg.norm(toward)),
        label=name,
        side=side,
        inner=inner,
    )


def _joystick(rig):
    place = np.array([10.0, 10.0, -0.66])
    members = []
    for name, axis in (("Head:ry", (1.0, 0.0, 0.0)), ("Head:rx", (0.0, -1.0, 0.0))):
        control = next(each for each in rig.controls if each.name == name)
        values = np.array([control.minimum, control.default, control.maximum])
        share = (values - control.default) / max(control.maximum, -control.minimum)
        members.append(Member(name, values, place + 1.5 * share[:, None] * axis, 3.0, 1.0))
    return Element(
        name="head",
        kind="patch",
        members=tuple(members),
        anchor=makers.anchor(rig, 0, place, on_board=True),
        label="head",
        side="middle",
        category="global",
        reason="moves the whole face",
    )
