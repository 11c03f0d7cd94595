# ruff: noqa: E501  (a table: one trap, one line)
"""Strange characters, each one edit away from the smallest: the broken and the legal.

`TRAPS` maps what is strange to (replacements, exit code, codes that must be among the issues).
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import minimal_assets

Edit = tuple[str, str]
Trap = tuple[tuple[Edit, ...], int, frozenset[str]]

_NAMES = 'uniform token[] skel:blendShapes = ["smile", "frown"]'
_TARGETS = "rel skel:blendShapeTargets = [</Char/Face/smile>, </Char/Face/frown>]"
_WEIGHTS = "float[] blendShapeWeights = [0, 0]"
_SOURCE = "rel skel:animationSource = </Char/Anim>"
_POINTS = "point3f[] points = [(0,0,0), (2,0,0), (2,3,0), (0,3,0), (4,0,0), (4,3,0)]"
_OFFSETS = "uniform vector3f[] offsets = [(0,0,1), (0,0,0.5)]"
_INDICES = "uniform int[] pointIndices = [0, 1]"
_FROWN = "[(0,0,0), (0,0,0), (0,0,0), (0,0,0), (0,0,0.3), (0,0,1)]"
_JOINTS = 'uniform token[] joints = ["neck", "neck/jaw"]'
_ROOT = 'def SkelRoot "Char"'
_FACE = 'def Mesh "Face" (prepend apiSchemas = ["SkelBindingAPI"])\n    {\n'
_ANIM = '    def SkelAnimation "Anim"'


def _inbetween(weight: float, more: str = "") -> tuple[Edit, ...]:
    text = f"uniform vector3f[] inbetweens:a = [(0,0,1), (0,0,1)] (weight = {weight})\n{more}"
    return ((_INDICES, text + _INDICES),)


def _many_names() -> tuple[Edit, ...]:
    names = ", ".join(f'"n{i}"' for i in range(300))
    return ((_NAMES, f"uniform token[] skel:blendShapes = [{names}]"), (_TARGETS, ""))


_MORE = "uniform vector3f[] inbetweens:b = [(0,0,2), (0,0,1)] (weight = 0.5)\n"

TRAPS: Mapping[str, Trap] = {
    # --- broken ----------------------------------------------------------------------------------
    "more names than targets": (((_TARGETS, "rel skel:blendShapeTargets = </Char/Face/smile>"),), 1, frozenset({"TARGETS_LENGTH"})),
    "300 names and no target": (_many_names(), 1, frozenset({"TARGETS_LENGTH"})),
    "a target that is not there": (((_TARGETS, _TARGETS.replace("frown", "gone")),), 0, frozenset({"TARGET_INVALID"})),
    "an index too high": (((_INDICES, "uniform int[] pointIndices = [0, 6]"),), 0, frozenset({"PART_LEFT_OFF"})),
    "an index below zero": (((_INDICES, "uniform int[] pointIndices = [-1, 1]"),), 0, frozenset({"PART_LEFT_OFF"})),
    "unsorted indices": (((_INDICES, "uniform int[] pointIndices = [5, 0]"),), 0, frozenset()),
    "a repeated index": (((_INDICES, "uniform int[] pointIndices = [1, 1]"),), 0, frozenset()),
    "too few offsets": (((_OFFSETS, "uniform vector3f[] offsets = [(0,0,1)]"),), 0, frozenset({"PART_LEFT_OFF"})),
    "an in-between at 0": (_inbetween(0), 0, frozenset({"INBETWEEN_INVALID"})),
    "an in-between at 1": (_inbetween(1), 0, frozenset({"INBETWEEN_INVALID"})),
    "two in-betweens at one weight": (_inbetween(0.5, _MORE), 0, frozenset({"INBETWEEN_INVALID"})),
    "NaN in an offset": (((_OFFSETS, "uniform vector3f[] offsets = [(0,nan,1), (0,0,1)]"),), 0, frozenset({"PART_LEFT_OFF"})),
    "an infinite offset": (((_OFFSETS, "uniform vector3f[] offsets = [(0,inf,1), (0,0,1)]"),), 0, frozenset({"PART_LEFT_OFF"})),
    "NaN in a point": (((_POINTS, _POINTS.replace("(2,0,0)", "(2,nan,0)")),), 1, frozenset({"NOT_FINITE"})),
    "an infinite point": (((_POINTS, _POINTS.replace("(2,0,0)", "(2,-inf,0)")),), 1, frozenset({"NOT_FINITE"})),
    "NaN in a weight": (((_WEIGHTS, "float[] blendShapeWeights = [nan, 0]"),), 1, frozenset({"NOT_FINITE"})),
    "NaN in a rest transform": ((("restTransforms = [\n            ((1,", "restTransforms = [\n            ((nan,"),), 1, frozenset({"NOT_FINITE"})),
    "NaN in the transform of the root": (
        ((_ROOT + "\n{", _ROOT + '\n{\ndouble3 xformOp:translate = (nan, 0, 0)\nuniform token[] xformOpOrder = ["xformOp:translate"]\n'),),
        1,
        frozenset({"NOT_FINITE"}),
    ),
    "NaN in the transform of a mesh without skin": (
        (
            (_FACE, _FACE + 'double3 xformOp:translate = (nan, 0, 0)\nuniform token[] xformOpOrder = ["xformOp:translate"]\n'),
            ("int[] primvars:skel:jointIndices", "int[] was:jointIndices"),
            ("float[] primvars:skel:jointWeights", "float[] was:jointWeights"),
        ),
        1,
        frozenset({"NOT_FINITE"}),
    ),
    "a mesh without extent in a plane": (((_POINTS, _POINTS.replace(",3,0)", ",0,0)")),), 0, frozenset()),
    "a skeleton scaled to nothing": (
        ((_JOINTS, 'double3 xformOp:scale = (1, 0, 1)\nuniform token[] xformOpOrder = ["xformOp:scale"]\n' + _JOINTS),),
        1,
        frozenset({"SKELETON_INVALID"}),
    ),
    "a joint named twice": (((_JOINTS, _JOINTS.replace("neck/jaw", "neck")),), 1, frozenset({"SKELETON_INVALID"})),
    "NaN in a joint weight": ((("[1, 0, 1, 0, 1, 0", "[nan, 0, 1, 0, 1, 0"),), 1, frozenset({"NOT_FINITE"})),
    "a character in an instance": (
        ((_ROOT, 'def "Hero" (instanceable = true; references = </Char>) {}\nclass SkelRoot "Char"'),),
        1,
        frozenset({"INSTANCE"}),
    ),
    "a mesh without points": (((_POINTS, "point3f[] points = []"),), 1, frozenset({"CONTROLS_MISSING"})),
    "a missing sublayer": ((('upAxis = "Y"', 'upAxis = "Y"\n    subLayers = [@./gone.usda@]'),), 1, frozenset({"LAYER_MISSING"})),
    "a missing payload": (((_ROOT, _ROOT + " (payload = @./gone.usda@)"),), 1, frozenset({"LAYER_MISSING"})),
    "a layer that is its own sublayer": ((('upAxis = "Y"', 'upAxis = "Y"\n    subLayers = [@./char.usda@]'),), 0, frozenset({"COMPOSITION_ERROR"})),
    "a prim that references itself": (((_ROOT, _ROOT + " (references = </Char>)"),), 0, frozenset({"COMPOSITION_ERROR"})),
    "a mesh that is the class of itself": (((_FACE, _FACE.replace("prepend api", "inherits = </Char/Face>; prepend api")),), 0, frozenset({"COMPOSITION_ERROR"})),
    "joints without animation or poses": (((_NAMES, "uniform token[] skel:blendShapes = []"), (_TARGETS, ""), ('token[] blendShapes = ["smile", "frown"]', "token[] blendShapes = []"), (_WEIGHTS, "")), 1, frozenset({"CONTROLS_MISSING"})),
    # --- strange but legal -----------------------------------------------------------------------
    "no animation source": (((_SOURCE, ""),), 0, frozenset({"TOKEN_NOT_ANIMATED"})),
    "a skeleton outside the SkelRoot": (
        ((_ROOT, 'def Skeleton "Bones" {}\n' + _ROOT), ("rel skel:skeleton = </Char/Skel>", "rel skel:skeleton = </Bones>")),
        0,
        frozenset({"TOKEN_NOT_ANIMATED"}),
    ),
    "a mesh outside the SkelRoot": (((_ROOT, 'def Mesh "Hat" {\npoint3f[] points = [(0,0,0)]\n}\n' + _ROOT),), 0, frozenset()),
    "a mesh with influences outside the SkelRoot": (
        ((_ROOT, 'def Mesh "Hat" {\npoint3f[] points = [(0,0,0)]\nint[] primvars:skel:jointIndices = [0]\n}\n' + _ROOT),),
        0,
        frozenset({"MESH_OUTSIDE"}),
    ),
    "a skeleton without joints": (
        ((_JOINTS, "uniform token[] joints = []"), ("int[] primvars:skel:jointIndices", "int[] was:jointIndices"), ("float[] primvars:skel:jointWeights", "float[] was:jointWeights")),
        0,
        frozenset(),
    ),
    "metersPerUnit without meaning": ((("metersPerUnit = 0.01", "metersPerUnit = 0.0"),), 0, frozenset({"UNITS_TYPE"})),
    "a SkelRoot inside a SkelRoot": (((_ANIM, '    def SkelRoot "Inner" {}\n\n' + _ANIM),), 0, frozenset()),
    "time samples on the points": (
        ((_POINTS, "point3f[] points.timeSamples = {\n1: [(0,0,0), (2,0,0), (2,3,0), (0,3,0), (4,0,0), (4,3,0)],\n2: [(0,0,1), (2,0,0), (2,3,0), (0,3,0), (4,0,0), (4,3,0)] }"),),
        0,
        frozenset({"POINTS_ANIMATED"}),
    ),
    "influences constant over the mesh": (
        (("[0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]", "[0, 1]"), ("[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0]", "[1, 0]"), ('"vertex"', '"constant"'), ('"vertex"', '"constant"')),
        0,
        frozenset(),
    ),
    "a mesh with joints of its own order": (((_FACE, _FACE + 'uniform token[] skel:joints = ["neck/jaw", "neck"]\n'),), 0, frozenset()),
    "shapes on a Points prim": (
        ((_ANIM, '    def Points "Sparks" (prepend apiSchemas = ["SkelBindingAPI"]) {\nrel skel:skeleton = </Char/Skel>\n}\n\n' + _ANIM),),
        0,
        frozenset({"PRIM_UNSUPPORTED"}),
    ),
    "weights as time samples only": (((_WEIGHTS, "float[] blendShapeWeights.timeSamples = { 1: [0, 0], 24: [1, -1] }"),), 0, frozenset()),
    "a class and an over beside it": (((_ROOT, 'class SkelRoot "Proto" {}\nover "Ghost" {}\n' + _ROOT),), 0, frozenset()),
    "an invisible mesh": (((_FACE, _FACE + 'token visibility = "invisible"\n'),), 0, frozenset()),
    "names that are not ASCII": ((('"smile", "frown"', '"lächeln", "怒り"'), ('["smile", "frown"]', '["lächeln", "怒り"]')), 0, frozenset()),
    "a name with markup": ((('"smile", "frown"', '"<b>&\\"smile", "frown"'), ('["smile", "frown"]', '["<b>&\\"smile", "frown"]')), 0, frozenset()),
    "a name with control characters": ((('"smile", "frown"', '"smi\\x1b[31mle", "frown"'), ('["smile", "frown"]', '["smi\\x1b[31mle", "frown"]')), 0, frozenset()),
    "a character so huge that its motion is nothing": (((_POINTS, _POINTS.replace("4,", "4e30,")),), 1, frozenset({"CONTROLS_MISSING"})),
    "a flat character": (((_POINTS, "point3f[] points = [(0,0,0), (0,0,0), (0,0,0), (0,0,0), (0,0,0), (0,0,0)]"),), 0, frozenset()),
    "names that are numbers or hold dots, colons and hyphens": ((('"smile", "frown"', '"12", "-a.b:c d"'), ('["smile", "frown"]', '["12", "-a.b:c d"]')), 0, frozenset()),
    "a token that no mesh implements": ((('blendShapes = ["smile", "frown"]\n        float', 'blendShapes = ["smile", "frown", "ghost"]\n        float'), (_WEIGHTS, "float[] blendShapeWeights = [0, 0, 0]")), 0, frozenset()),
    "an empty shape": (((_OFFSETS, "uniform vector3f[] offsets = []"), (_INDICES, "uniform int[] pointIndices = []")), 0, frozenset()),
    "two shapes that are the same": (((_FROWN, "[(0,0,1), (0,0,0.5), (0,0,0), (0,0,0), (0,0,0), (0,0,0)]"),), 0, frozenset()),
    "two shapes that are opposites on one line": (((_FROWN, "[(0,0,-1), (0,0,-0.5), (0,0,0), (0,0,0), (0,0,0), (0,0,0)]"),), 0, frozenset()),
    "a shape that moves a thousandth of the face": (((_OFFSETS, "uniform vector3f[] offsets = [(0,0,1e-4), (0,0,5e-5)]"),), 0, frozenset({"CONTROL_TINY"})),
    "a shape that collapses the mesh to a point": (((_FROWN, "[(0,0,0), (-2,0,0), (-2,-3,0), (0,-3,0), (-4,0,0), (-4,-3,0)]"),), 0, frozenset()),
    "a shape that moves the whole head": (((_FROWN, "[(0,0,1), (0,0,1), (0,0,1), (0,0,1), (0,0,1), (0,0,1)]"),), 0, frozenset()),
    "a face driven by joints only": (
        (
            (_NAMES, "uniform token[] skel:blendShapes = []"), (_TARGETS, ""), ('token[] blendShapes = ["smile", "frown"]', "token[] blendShapes = []"),
            (_WEIGHTS, 'uniform token[] joints = ["neck/jaw"]\nquatf[] rotations.timeSamples = { 0: [(1, 0, 0, 0)], 1: [(0.9, 0.43589, 0, 0)] }\nfloat3[] translations = [(0, 1, 0)]\nhalf3[] scales = [(1, 1, 1)]'),
            ("[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0]", "[1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 0, 1]"),
        ),
        0,
        frozenset(),
    ),
    "a mesh with some of the joints": (((_FACE, _FACE + 'uniform token[] skel:joints = ["neck/jaw"]\n'), ("[0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]", "[0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]")), 0, frozenset()),
    "points split at a seam": ((("[0, 1, 2, 3, 1, 4, 5, 2]", "[0, 1, 2, 3, 6, 4, 5, 7]"), (_POINTS, _POINTS.replace("(4,3,0)]", "(4,3,0), (2,0,0), (2,3,0)]")), ("(0,0,0.3), (0,0,1)]", "(0,0,0.3), (0,0,1), (0,0,0), (0,0,0)]"), ("[0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]", "[0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1]"), ("[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0]", "[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0]")), 0, frozenset()),
    "no faces": ((("[4, 4]", "[]"), ("[0, 1, 2, 3, 1, 4, 5, 2]", "[]")), 0, frozenset()),
}  # fmt: skip


def trapped(folder: Path, name: str) -> Path:
    """The smallest character with that trap."""
    text = minimal_assets.TEXT
    for old, new in TRAPS[name][0]:
        assert old in text, f"{name}: {old!r} is not in the smallest character"
        text = text.replace(old, new, 1)
    path = folder / "char.usda"
    path.write_text(text, encoding="utf-8")
    return path
