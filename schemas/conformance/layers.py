"""Makes the layers of the conformance suite and the questions about them, but for drags.json:
``python schemas/conformance/layers.py``.

Each layer lays out a mask of 81 points with the shapes and joints of its own character, which lies beside it.
"""

from __future__ import annotations

import contextlib
import io
import json
import re
import sys
from pathlib import Path

import numpy as np
from pxr import Gf, Usd, UsdGeom, UsdSkel, Vt
from readers import answers

from usdrigui import load_settings, process

FOLDER = Path(__file__).parent
MASK = np.array([(x, y, 0.6 - 0.5 * (x * x + y * y)) for y in np.linspace(-1, 1, 9) for x in np.linspace(-1, 1, 9)])
UP, DOWN, LEFT, RIGHT, OUT = (0, 0.3, 0), (0, -0.3, 0), (0.3, 0, 0), (-0.3, 0, 0), (0, 0.1, 0.3)
MOUTH = (0.0, -0.4)
JOYSTICK = {"up": (MOUTH, UP), "down": (MOUTH, DOWN), "left": (MOUTH, LEFT), "right": (MOUTH, RIGHT)}
LIPS = {"up": (MOUTH, UP), "left": (MOUTH, LEFT)}
BROWS = {"brow_L": ((0.5, 0.5), UP), "brow_R": ((-0.5, 0.5), UP)}
JAW = {"joints": {"Head/Jaw": {"axes": ["x"], "minimum": -5, "maximum": 30}}}
TURNS = {"joints": {"Head/Jaw": {"axes": ["x", "y"], "minimum": -20, "maximum": 20}}}
CASES = {
    "slider": {"shapes": {"up": (MOUTH, UP)}},
    "opposed": {"shapes": {"left": (MOUTH, LEFT), "right": (MOUTH, RIGHT)}},
    "patch": {"shapes": LIPS, "settings": {"groups": {"groups": {"lips": [*LIPS]}}}},
    "joystick": {"shapes": JOYSTICK},
    "fan": {
        "shapes": {**LIPS, "out": (MOUTH, (0.2, 0.15, 0.25))},
        "settings": {"groups": {"opposed": False, "groups": {"lips": ["up", "left", "out"]}}},
    },
    "mirrors": {"shapes": BROWS},
    "mirrored_joysticks": {
        "shapes": {
            f"{name}_{side}": ((sign * 0.5, 0.4), (sign * way[0], way[1], 0))
            for side, sign in (("L", 1), ("R", -1))
            for name, way in (("up", UP), ("down", DOWN), ("in", RIGHT), ("out", LEFT))
        }
    },
    "inbetweens": {"shapes": {"up": (MOUTH, UP)}, "between": OUT},
    "pose": {"shapes": {**BROWS, **LIPS}, "settings": {"poses": {"smile": {"weights": {"up": 1.0, "left": 0.5}}}}},
    "joint": {"shapes": BROWS, "settings": JAW},
    "joint_joystick": {"shapes": BROWS, "settings": TURNS},
    "joint_and_shapes": {"shapes": {**LIPS, **BROWS}, "settings": JAW},
    "range": {"shapes": {"up": (MOUTH, UP)}, "settings": {"controls": {"up": {"minimum": -0.5, "maximum": 2.0}}}},
    "base_pose": {"shapes": {**BROWS, **LIPS}, "settings": {"read": {"pose": {"up": 0.5}}}},
    "board": {"shapes": {**BROWS, **LIPS}, "settings": {"controls": {"up": {"place": "board"}}}},
    "joint_on_the_board": {
        "shapes": BROWS,
        "settings": {**JAW, "controls": {"Jaw:rx": {"place": "board"}}},
    },
    "levels": {"shapes": JOYSTICK, "settings": {"levels": {"groups": True}}},
    "static": {"shapes": {**BROWS, **LIPS}, "settings": {"output": {"adapt": "static"}}},
    "scaled": {"shapes": {**BROWS, **LIPS}, "scale": 100.0},
    "z_up": {"shapes": {**BROWS, **LIPS}, "z_up": True},
    "moved": {"shapes": {**BROWS, **LIPS}, "settings": JAW, "moved": True},
    "names": {"shapes": {"brow:up L": ((0.5, 0.5), UP), "0": (MOUTH, OUT)}},
}
SPOILT = {
    "later_version": ("pose", lambda text: text.replace("RigUILayoutAPI", "RigUILayoutAPI_1")),
    "too_few_values": ("base_pose", lambda text: re.sub(r"(baseValues = \[)[^,\]]*, ", r"\1", text)),
    "shifted": ("slider", lambda text: text.replace("rigUI:anchor:position = (", "rigUI:anchor:position = (9")),
    "payload": ("mirrors", lambda _: PAYLOAD),
}
"""What is made of the layer of another case."""
PAYLOAD = """#usda 1.0
(
    defaultPrim = "Asset"
    metersPerUnit = 0.01
    upAxis = "Y"
)
def Xform "Asset" {
    double3 xformOp:translate = (3, 0, 1)
    uniform token[] xformOpOrder = ["xformOp:translate"]
    def "Face" (payload = @mirrors.usda@) {}
}
"""


def character(path, *, shapes=(), between=None, scale=1.0, z_up=False, moved=False, **_):
    """The mask on a head with a jaw."""
    stage = Usd.Stage.CreateNew(str(path))
    turned = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]) if z_up else np.eye(3)
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.z if z_up else UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 0.1 / scale)
    root = UsdSkel.Root.Define(stage, "/Char")
    stage.SetDefaultPrim(root.GetPrim())
    skeleton, animation = UsdSkel.Skeleton.Define(stage, "/Char/Skel"), UsdSkel.Animation.Define(stage, "/Char/Anim")
    joints = ("Head", "Head/Jaw")
    places = [scale * np.array(each) @ turned for each in ((0, 0, -0.5), (0, -0.2, -0.2))]
    local = [Gf.Matrix4d().SetTranslate(Gf.Vec3d(*each)) for each in places]
    skeleton.CreateJointsAttr(joints)
    skeleton.CreateRestTransformsAttr(local)
    skeleton.CreateBindTransformsAttr([local[0], local[1] * local[0]])
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets(["/Char/Anim"])
    animation.CreateBlendShapesAttr([*shapes])
    animation.CreateBlendShapeWeightsAttr([0.0] * len(shapes))
    if moved:
        UsdGeom.XformCommonAPI(root).SetTranslate((3, 1, -2))
        UsdGeom.XformCommonAPI(skeleton).SetRotate((0, 20, 5))
    mesh = UsdGeom.Mesh.Define(stage, "/Char/Face")
    mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy((scale * MASK @ turned).astype(np.float32)))
    mesh.CreateFaceVertexCountsAttr([4] * 64)
    corners = [(9 * row + column, 9 * row + column + 1) for row in range(8) for column in range(8)]
    mesh.CreateFaceVertexIndicesAttr([each for a, b in corners for each in (a, b, b + 9, a + 9)])
    mesh.CreateSubdivisionSchemeAttr("none")
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets(["/Char/Skel"])
    jaw = np.clip(-2.0 * MASK[:, 1], 0.0, 1.0)
    binding.CreateJointIndicesPrimvar(False, 2).Set([0, 1] * 81)
    binding.CreateJointWeightsPrimvar(False, 2).Set(np.stack([1.0 - jaw, jaw], axis=1).ravel().tolist())
    binding.CreateBlendShapesAttr([*shapes])
    targets = [f"/Char/Face/shape{index}" for index in range(len(shapes))]
    for target, (place, way) in zip(targets, dict(shapes).values(), strict=True):
        shape = UsdSkel.BlendShape.Define(stage, target)
        fall = np.maximum(1.0 - np.linalg.norm(MASK[:, :2] - place, axis=1) / 0.5, 0.0)[:, None]
        shape.CreateOffsetsAttr(offsets(scale * fall * np.array(way) @ turned))
        if between:
            shape.CreateInbetween("half").SetOffsets(offsets(scale * fall * np.array(between) @ turned))
            shape.GetInbetween("half").SetWeight(0.5)
    binding.CreateBlendShapeTargetsRel().SetTargets(targets)
    stage.Save()


def toml(value):
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{json.dumps(key)} = {toml(each)}' for key, each in value.items())} }}"
    return json.dumps(value)


def offsets(rows):
    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(rows, dtype=np.float32))


def questions(layer, controls, width, posed):
    """What is asked about a layer, with usdrigui's own answers; positions to a twentieth of a handle's width."""
    rng = np.random.default_rng(len(controls))
    poses = (
        [{}, *({name: round(rng.uniform(*ends), 3) for name, ends in controls.items()} for _ in range(2))]
        if posed
        else []
    )
    asked = [{"ask": "layout"}, *({"ask": "pose", "values": pose} for pose in poses), {"ask": "findings"}]
    given = zip(asked, answers(layer, asked), (1e-5, *[0.05 * width] * len(poses), 0), strict=True)
    return [{**each, "answer": rounded(answer), "within": within} for each, answer, within in given]


def rounded(value):
    """With six digits, which every processor has alike."""
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    if isinstance(value, list):
        return [rounded(each) for each in value]
    return float(f"{value:.6g}") + 0.0 if isinstance(value, float) else value


def make(folder):
    """Write every character, layer and file of questions."""
    known = {}
    for name, case in CASES.items():
        path, layer = folder / f"{name}.char.usda", folder / f"{name}.usda"
        path.unlink(missing_ok=True)
        character(path, **case)
        settings = load_settings({"solve": {"gap": 1e-4}, **case.get("settings", {})})
        if "settings" in case:  # usdrigui finds the controls of joints and poses again by them
            text = "".join(f"{key} = {toml(value)}\n" for key, value in case["settings"].items())
            (folder / f"{name}.rigui.toml").write_text(text, "utf-8")
        with contextlib.redirect_stdout(io.StringIO()):
            (laid,) = process(path, settings, output=layer).characters
        known[name] = {c.name: (c.minimum, c.maximum) for c in laid.rig.controls}, laid.layout.frame.handle_width
        ask(folder, name, *known[name])
    for name, (source, spoil) in SPOILT.items():
        (folder / f"{name}.usda").write_text(spoil((folder / f"{source}.usda").read_text("utf-8")), "utf-8")
        controls, width = known[source]
        ask(folder, name, controls, width, posed=name != "shifted")


def ask(folder, name, controls, width, *, posed=True):
    lines = ",\n".join(json.dumps(each) for each in questions(folder / f"{name}.usda", controls, width, posed))
    (folder / f"{name}.json").write_text(f'{{"layer": "{name}.usda", "questions": [\n{lines}\n]}}\n', "utf-8")


if __name__ == "__main__":
    make(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER)
