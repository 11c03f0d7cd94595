"""The smallest character, and for every issue code the smallest change to it that calls for the code.

`TEXT` holds the file; `EDITS` maps a code to replacements in it.  What cannot be said by an edit of one
text file is made by a function in `MAKERS`.
"""

from __future__ import annotations

import os
import struct
import sys
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path

TEXT = """#usda 1.0
(
    defaultPrim = "Char"
    metersPerUnit = 0.01
    upAxis = "Y"
)

def SkelRoot "Char"
{
    def Skeleton "Skel" (prepend apiSchemas = ["SkelBindingAPI"])
    {
        uniform token[] joints = ["neck", "neck/jaw"]
        uniform matrix4d[] bindTransforms = [
            ((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1)), ((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,1,0,1))
        ]
        uniform matrix4d[] restTransforms = [
            ((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,0,0,1)), ((1,0,0,0),(0,1,0,0),(0,0,1,0),(0,1,0,1))
        ]
        rel skel:animationSource = </Char/Anim>
    }

    def SkelAnimation "Anim"
    {
        uniform token[] blendShapes = ["smile", "frown"]
        float[] blendShapeWeights = [0, 0]
    }

    def Mesh "Face" (prepend apiSchemas = ["SkelBindingAPI"])
    {
        point3f[] points = [(0,0,0), (2,0,0), (2,3,0), (0,3,0), (4,0,0), (4,3,0)]
        int[] faceVertexCounts = [4, 4]
        int[] faceVertexIndices = [0, 1, 2, 3, 1, 4, 5, 2]
        uniform token[] skel:blendShapes = ["smile", "frown"]
        rel skel:blendShapeTargets = [</Char/Face/smile>, </Char/Face/frown>]
        rel skel:skeleton = </Char/Skel>
        int[] primvars:skel:jointIndices = [0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1] (
            elementSize = 2
            interpolation = "vertex"
        )
        float[] primvars:skel:jointWeights = [1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0] (
            elementSize = 2
            interpolation = "vertex"
        )

        def BlendShape "smile"
        {
            uniform vector3f[] offsets = [(0,0,1), (0,0,0.5)]
            uniform int[] pointIndices = [0, 1]
        }

        def BlendShape "frown"
        {
            uniform vector3f[] offsets = [(0,0,0), (0,0,0), (0,0,0), (0,0,0), (0,0,0.3), (0,0,1)]
        }
    }
}
"""

_SMILE = 'token[] skel:blendShapes = ["smile", "frown"]'
_FACE = 'def Mesh "Face" (prepend apiSchemas = ["SkelBindingAPI"])\n    {\n'
_WEIGHTS = "float[] blendShapeWeights = [0, 0]"

EDITS: Mapping[str, tuple[tuple[str, str], ...]] = {
    "FILE_NOT_USD": (("#usda 1.0", "#usda 1.0\ndef {"),),
    "LAYER_MISSING": (('upAxis = "Y"', 'subLayers = [@./gone.usda@]'),),
    "COMPOSITION_ERROR": (('def SkelRoot "Char"', 'def "Prop" (references = @./gone.usda@) {}\ndef SkelRoot "Char"'),),
    "USD_DIAGNOSTIC": (('def SkelRoot "Char"', 'def "Prop" (references = </Nothing>) {}\ndef SkelRoot "Char"'),),
    "SKELROOT_MISSING": (("def SkelRoot", "def Xform"),),
    "CONTROLS_MISSING": (
        (_SMILE, "token[] skel:blendShapes = []"),
        ("[</Char/Face/smile>, </Char/Face/frown>]", "[]"),
        ('["smile", "frown"]', "[]"),
        (_WEIGHTS, "float[] blendShapeWeights = []"),
    ),
    "INSTANCE": (
        ('def SkelRoot "Char"', 'def "Hero" (instanceable = true; references = </Char>) {}\nclass SkelRoot "Char"'),
    ),
    "TARGETS_LENGTH": ((", </Char/Face/frown>]", "]"),),
    "TARGET_INVALID": (("</Char/Face/frown>]", "</Char/Skel>]"),),
    "PART_LEFT_OFF": (("(0,0,1), (0,0,0.5)]", "(0,0,1)]"),),
    "OFFSETS_LENGTH": (("(0,0,1), (0,0,0.5)]", "(0,0,1)]"), ("(0,0,0.3), (0,0,1)]", "(0,0,1)]")),
    "INDEX_RANGE": (("faceVertexIndices = [0, 1, 2, 3,", "faceVertexIndices = [0, 1, 2, 6,"),),
    "NOT_FINITE": (("points = [(0,0,0),", "points = [(0,0,nan),"),),
    "ARRAY_TYPE": (("point3f[] points = [", 'string[] points = ["far", "near"]\n        point3f[] were = ['),),
    "INFLUENCES_LENGTH": (("[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0]", "[1, 0, 1]"),),
    "JOINT_UNKNOWN": ((_FACE, _FACE + '        uniform token[] skel:joints = ["neck", "neck/nose"]\n'),),
    "SKELETON_INVALID": (('["neck", "neck/jaw"]', '["neck/jaw", "neck"]'),),
    "ANIMATION_LENGTH": ((_WEIGHTS, "float[] blendShapeWeights = [0]"),),
    "TOPOLOGY_INVALID": (("faceVertexCounts = [4, 4]", "faceVertexCounts = [4, 5]"),),
    "MESH_UNBOUND": (
        ('    def SkelAnimation "Anim"', """    def Mesh "Hat" (prepend apiSchemas = ["SkelBindingAPI"])
    {
        point3f[] points = [(0,3,0), (2,3,0), (2,4,0)]
        int[] faceVertexCounts = [3]
        int[] faceVertexIndices = [0, 1, 2]
        uniform token[] skel:blendShapes = ["smile"]
        rel skel:blendShapeTargets = </Char/Face/smile>
    }

    def SkelAnimation "Anim\""""),
    ),
    "MESH_HIDDEN": ((_FACE, _FACE + '        token visibility = "invisible"\n'),),
    "MESH_OUTSIDE": (
        ('def SkelRoot "Char"', """def Mesh "Hat" (prepend apiSchemas = ["SkelBindingAPI"])
{
    point3f[] points = [(0,3,0), (2,3,0), (2,4,0)]
    uniform token[] skel:blendShapes = ["smile"]
    rel skel:blendShapeTargets = </Char/Face/smile>
}

def SkelRoot "Char\""""),
    ),
    "MESH_EMPTY": (('    def SkelAnimation "Anim"', '    def Mesh "Nothing" {}\n\n    def SkelAnimation "Anim"'),),
    "POINTS_ANIMATED": (
        (
            "        int[] faceVertexCounts",
            "        point3f[] points.timeSamples = {\n"
            "            1: [(0,0,0), (2,0,0), (2,3,0), (0,3,0), (4,0,0), (4,3,0)],\n"
            "            2: [(0,0,0), (2,0,0), (2,3,0), (0,3,0), (4,0,0), (4,3,1)] }\n"
            "        int[] faceVertexCounts",
        ),
    ),
    "PRIM_UNSUPPORTED": (
        ('    def SkelAnimation "Anim"', """    def Points "Sparks" (prepend apiSchemas = ["SkelBindingAPI"])
    {
        point3f[] points = [(0,0,0), (1,0,0)]
        rel skel:skeleton = </Char/Skel>
        uniform token[] skel:blendShapes = ["smile"]
        rel skel:blendShapeTargets = </Char/Face/smile>
    }

    def SkelAnimation "Anim\""""),
    ),
    "WEIGHTS_UNNORMALISED": (("[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0]", "[1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 2, 0]"),),
    "SKINNING_METHOD": ((_FACE, _FACE + '        uniform token primvars:skel:skinningMethod = "magic"\n'),),
    "TOKEN_NOT_ANIMATED": (('token[] blendShapes = ["smile", "frown"]', 'token[] blendShapes = ["smile", "sneer"]'),),
    "TOKEN_REPEATED": (
        ('token[] blendShapes = ["smile", "frown"]', 'token[] blendShapes = ["smile", "frown", "smile"]'),
        (_WEIGHTS, "float[] blendShapeWeights = [0, 0, 0]"),
    ),
    "INBETWEEN_INVALID": (
        (
            "            uniform int[] pointIndices",
            "            uniform vector3f[] inbetweens:half = [(0,0,1), (0,0,1)] (weight = 1)\n"
            "            uniform int[] pointIndices",
        ),
    ),
    "RANGE_INVALID": (
        (
            _WEIGHTS,
            _WEIGHTS + " (limits = { dictionary hard = { float[] minimum = [1, 0]; float[] maximum = [0, 1] } })",
        ),
    ),
    "WEIGHTS_BEYOND_LIMITS": (
        (
            _WEIGHTS,
            "float[] blendShapeWeights = [0, 2]"
            " (limits = { dictionary hard = { float[] minimum = [0, 0]; float[] maximum = [1, 1] } })",
        ),
    ),
    "POSES_MISMATCH": (
        ('upAxis = "Y"', 'upAxis = "Y"\n    customLayerData = { string[] framemapping = ["rest", "smirk", "grin"] }'),
        (_WEIGHTS, "float[] blendShapeWeights.timeSamples = { 0: [0, 0], 1: [1, 0] }"),
    ),
    "REST_MISSING": (("uniform matrix4d[] restTransforms", "uniform matrix4d[] otherTransforms"),),
    "JOINT_MOTION_IGNORED": (
        (
            _WEIGHTS,
            _WEIGHTS + """
        uniform token[] joints = ["neck/jaw"]
        float3[] translations.timeSamples = { 0: [(0,1,0)], 1: [(0,2,0)] }
        quatf[] rotations = [(1,0,0,0)]
        half3[] scales = [(1,1,1)]""",
        ),
    ),
    "CLIP_THINNED": (
        (_WEIGHTS, "float[] blendShapeWeights.timeSamples = { 0: [0, 0], 1: [1, 0], 2: [0, 0], 3: [0, 1] }"),
    ),
    "NORMALS_INWARD": (
        ("(4,0,0), (4,3,0)]", "(0,0,-2), (2,0,-2)]"),
        ("faceVertexCounts = [4, 4]", "faceVertexCounts = [4, 4, 4, 3, 3]"),
        ("[0, 1, 2, 3, 1, 4, 5, 2]", "[3, 2, 1, 0, 3, 4, 5, 2, 0, 1, 5, 4, 0, 4, 3, 1, 2, 5]"),
    ),
    "UNITS_TYPE": (("metersPerUnit = 0.01", "metersPerUnit = 0"),),
    "CONTROL_TINY": (("(0,0,1), (0,0,0.5)]", "(0,0,1e-4), (0,0,5e-5)]"),),
}  # fmt: skip
"""Code to (what stands in `TEXT`, what stands there instead)."""

CONFIGURED: Mapping[str, str] = {
    "SKELROOT_UNKNOWN": "read.skel_root=/Other",
    "VARIANT_UNKNOWN": "read.variants.LOD=low",
    "CONFIG_UNKNOWN_KEY": "solve.gapp=1",
    "CONFIG_VALUE": 'solve.gap="small"',
    "CONFIG_UNKNOWN_CONTROL": 'read.pose={"smirk"=1.0}',
    "SOURCE_TOO_LARGE": "read.size_limit=0",
    "GROUP_APART": 'groups.groups.both=["smile", "frown"]',
    "PLACE_KEEPS_LITTLE": 'controls.frown.anchor="/Char/Face#4"',
}
"""Code to the setting (``--set``) with which the sound character calls for it."""


def character(folder: Path, code: str = "") -> Path:
    """The smallest character, changed so as to call for `code`."""
    text = TEXT
    for old, new in EDITS.get(code, ()):
        assert old in text, f"{code}: {old!r} is not in the smallest character"
        text = text.replace(old, new, 1)
    path = folder / "char.usda"
    path.write_text(text, encoding="utf-8")
    return path


# --- files that are not text -------------------------------------------------------------------------


def _nested(folder: Path) -> Path:
    path = folder / "char.usda"
    path.write_text("#usda 1.0\n" + 'def "a" {\n' * 200_000 + "}\n" * 200_000)
    return path


def _endless(folder: Path) -> Path:
    os.mkfifo(folder / "pipe.usda")
    path = folder / "char.usda"
    path.write_text("#usda 1.0\n(\n    subLayers = [@./pipe.usda@]\n)\n")
    return path


def _large(folder: Path) -> Path:
    path = character(folder)
    path.write_text(path.read_text() + 'def "a" {\n    int[] many = [' + "0," * 3_000_000 + " 0]\n}\n")
    return path


def _pointer(folder: Path) -> Path:
    path = folder / "char.usdc"
    path.write_text(f"version https://git-lfs.github.com/spec/v1\noid sha256:{'4d7a' * 16}\nsize 12345\n")
    return path


def _bytes_in_name(folder: Path) -> Path:
    path = folder / "char:SDF_FORMAT_ARGS:a=b.usda"
    path.write_text(TEXT)
    return path


def _bad_package(folder: Path) -> Path:
    content = TEXT.encode()
    name = b"char.usda"
    fields = struct.pack(
        "<5H3L2H", 20, 0, 0, 0, 0x21, zlib.crc32(content) ^ 1, len(content), len(content), len(name), 0
    )
    local = b"PK\3\4" + fields + name
    central = b"PK\1\2" + struct.pack("<H", 20) + fields + struct.pack("<3H2L", 0, 0, 0, 0, 0) + name
    end = b"PK\5\6" + struct.pack("<4H2LH", 0, 0, 1, 1, len(central), len(local) + len(content), 0)
    path = folder / "char.usdz"
    path.write_bytes(local + content + central + end)
    return path


MAKERS: Mapping[str, Callable[[Path], Path]] = {
    "FILE_NOT_FOUND": lambda folder: folder / "none.usda",
    "FILE_NAME": _bytes_in_name,
    "FILE_CORRUPT": _bad_package,
    "SOURCE_NOT_A_FILE": lambda folder: folder,
    "SOURCE_LFS_POINTER": _pointer,
    "SOURCE_CRASHES_USD": _nested,
    "SOURCE_TIME_LIMIT": _endless,
    "SOURCE_MEMORY_LIMIT": _large,
}

if __name__ == "__main__":
    sys.stdout.write(character(Path(sys.argv[2] if len(sys.argv) > 2 else "."), sys.argv[1]).read_text())
