"""Valid characters as plain USDA text, from a seed, by nothing but the standard library: what else may be written.

Everything is drawn anew and in another structure than by valid_rigs.py: bindings that are inherited, animations
bound above the Skeleton, rest and bind poses apart, joint orders of a mesh's own, BlendShapes in a Scope that meshes
share, layers that are sublayers, references, payloads, variants, classes or instances of others, shapes in any order,
blocked samples, tubes, fans, star-shaped faces, meshes of one point or of a line, meshes far from all else, units from
a tenth of a millimetre to a kilometre.  At least one shape moves a point of a mesh that is drawn.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

Vector = tuple[float, float, float]


@dataclass
class Surface:
    """A mesh before it is written."""

    points: list[Vector]
    faces: list[list[int]]


@dataclass
class Plan:
    """What has been drawn for one character."""

    rng: random.Random
    scale: float
    joints: list[str]
    tokens: list[str] = field(default_factory=list)


def write_rig(seed: int, folder: Path) -> Path:
    """Write the files of a seed into `folder`; returns the one to open."""
    rng = random.Random(f"written {seed}")
    scale = 10.0 ** rng.uniform(-3.0, 3.0) if rng.random() < 0.4 else 1.0
    plan = Plan(rng, scale, _joints(rng))
    body = _skel_root(plan)
    head = [
        f"    upAxis = {_text(rng.choice('YZ'))}",
        f"    metersPerUnit = {rng.choice([0.0001, 0.01, 1, 1000])}",
        '    defaultPrim = "World"',
        *rng.sample(["    startTimeCode = 0\n    endTimeCode = 10", "    timeCodesPerSecond = 30"], rng.randint(0, 2)),
    ]
    return _composed(rng, folder / f"written{seed}.usda", head, body)


# --- layers ------------------------------------------------------------------------------------------


def _composed(rng: random.Random, path: Path, head: list[str], body: str) -> Path:
    """One layer that holds all, or one that brings the character in from another in some way."""
    way = rng.choice(["alone", "alone", "alone", "subLayers", "references", "payload", "variant", "inherits"])
    if way == "alone":
        return _layer(path, head, f'def Xform "World"\n{{\n{body}}}\n')
    if way == "variant":
        opened = 'def Xform "World" (\n    variants = { string lod = "high" }\n    prepend variantSets = "lod"\n)'
        low = '"low" {\ndef Mesh "Proxy"\n{\n    point3f[] points = [(0,0,0)]\n}\n}'
        return _layer(path, head, f'{opened}\n{{\n    variantSet "lod" = {{\n"high" {{\n{body}}}\n{low}\n}}\n}}\n')
    if way == "inherits":
        body = body.replace("</World/", "</_World/")
        text = f'class "_World"\n{{\n{body}}}\ndef Xform "World" (\n    prepend inherits = </_World>\n)\n{{\n}}\n'
        return _layer(path, head, text)
    other = path.with_name(f"{path.stem}_part.usda")
    _layer(other, head, f'def Xform "World"\n{{\n{body}}}\n')
    if way == "subLayers":
        offset = rng.choice(["", " (offset = 5)", " (scale = 2)"])
        return _layer(path, [*head, f"    subLayers = [@./{other.name}@{offset}]"], "")
    arc = f'def Xform "World" (\n    prepend {way} = @./{other.name}@</World>\n)\n{{\n}}\n'
    return _layer(path, head, arc)


def _layer(path: Path, head: Iterable[str], text: str) -> Path:
    path.write_text("#usda 1.0\n(\n" + "\n".join(head) + f"\n)\n\n{text}", encoding="utf-8")
    return path


# --- the character -----------------------------------------------------------------------------------


def _skel_root(plan: Plan) -> str:
    rng = plan.rng
    shapes: list[str] = []
    meshes = [_mesh(plan, index, shapes) for index in range(rng.choice([1, 1, 2, 3]))]
    inherited = rng.random() < 0.5
    bound = f"    rel skel:skeleton = </World/Char/{_RIG}>\n" if inherited else ""
    geometry = "".join(meshes)
    if inherited:
        geometry = f'def Xform "Geo" (\n    prepend apiSchemas = ["SkelBindingAPI"]\n)\n{{\n{bound}{geometry}}}\n'
    else:
        geometry = geometry.replace(_UNBOUND, f"    rel skel:skeleton = </World/Char/{_RIG}>\n")
    above = rng.random() < 0.5
    source = "    rel skel:animationSource = </World/Char/Anim>\n"
    root = f'def SkelRoot "Char" (\n    prepend apiSchemas = ["SkelBindingAPI"]\n)\n{{\n{_transform(plan)}'
    library = f'def Scope "Shapes"\n{{\n{"".join(shapes)}}}\n'
    skeleton = _skeleton(plan, "" if above else source)
    return root + (source if above else "") + skeleton + _animation(plan) + library + geometry + "}\n"


_RIG = "Rig/Bones"
_UNBOUND = "    # bound here\n"


def _transform(plan: Plan) -> str:
    """Nothing, or operations in some order."""
    rng = plan.rng
    ops = {
        "xformOp:translate": f"    double3 xformOp:translate = {_vector([rng.gauss(0, 5) for _ in range(3)])}\n",
        "xformOp:rotateXYZ": f"    float3 xformOp:rotateXYZ = {_vector([rng.uniform(-180, 180) for _ in range(3)])}\n",
        "xformOp:scale": f"    float3 xformOp:scale = {_vector([rng.uniform(0.5, 2)] * 3)}\n",
    }
    chosen = rng.sample(sorted(ops), rng.choice([0, 0, 1, 3]))
    if not chosen:
        return ""
    order = ", ".join(map(_text, chosen))
    return "".join(ops[name] for name in chosen) + f"    uniform token[] xformOpOrder = [{order}]\n"


def _joints(rng: random.Random) -> list[str]:
    """None, a chain, a comb or a tree."""
    paths: list[str] = []
    shape = rng.choice(["none", "chain", "comb", "tree"])
    for index in range(0 if shape == "none" else rng.randint(1, 9)):
        above = {"chain": paths[-1:], "comb": paths[:1], "tree": [rng.choice(paths)] if paths else []}[shape]
        paths.append("/".join([*above, f"j{index}"]))
    return paths


def _skeleton(plan: Plan, source: str) -> str:
    rng, count = plan.rng, len(plan.joints)
    bind = [_matrix(rng, 0.5 * plan.scale, turned=rng.random() < 0.5) for _ in range(count)]
    rest = [_matrix(rng, 0.3 * plan.scale, turned=rng.random() < 0.5) for _ in range(count)]
    return (
        'def Xform "Rig"\n{\n    def Skeleton "Bones" (\n    prepend apiSchemas = ["SkelBindingAPI"]\n)\n    {\n'
        f"{source}    uniform token[] joints = [{', '.join(map(_text, plan.joints))}]\n"
        f"    uniform matrix4d[] bindTransforms = [{', '.join(bind)}]\n"
        f"    uniform matrix4d[] restTransforms = [{', '.join(rest)}]\n    }}\n}}\n"
    )


def _matrix(rng: random.Random, reach: float, *, turned: bool) -> str:
    angle = rng.uniform(-math.pi, math.pi) if turned else 0.0
    c, s = math.cos(angle), math.sin(angle)
    rows = [[c, s, 0, 0], [-s, c, 0, 0], [0, 0, 1, 0], [*(rng.uniform(-reach, reach) for _ in range(3)), 1]]
    return f"({', '.join(_vector(row) for row in rows)})"


def _animation(plan: Plan) -> str:
    """Shapes in another order, some of them or more; one value, keys, keys of which one is blocked; or turning
    joints."""
    rng = plan.rng
    listed = rng.sample(plan.tokens, rng.choice([0, len(plan.tokens), len(plan.tokens)]))
    listed += ["unused"] * (rng.random() < 0.2)
    times = rng.choice([[], [0], [0, 4, 10], [-3, 2.5]])

    def values(name: str, kind: str, one: Sequence[str]) -> str:
        if not times:
            return f"    {kind}[] {name} = [{', '.join(one)}]\n"
        samples = [f"{time}: [{', '.join(one)}]" for time in times]
        if len(times) > 2 and rng.random() < 0.3:
            samples[1] = f"{times[1]}: None"
        return f"    {kind}[] {name}.timeSamples = {{ {', '.join(samples)} }}\n"

    weights = [f"{rng.choice([0.0, 0.0, 0.5, 1.0, -0.4, 1.7]):g}" for _ in listed]
    found = f"    uniform token[] blendShapes = [{', '.join(map(_text, listed))}]\n"
    found += values("blendShapeWeights", "float", weights)
    if plan.joints and rng.random() < 0.5:
        driven = rng.sample(plan.joints, rng.randint(1, len(plan.joints)))
        found += f"    uniform token[] joints = [{', '.join(map(_text, driven))}]\n"
        angles = [rng.uniform(-1, 1) for _ in driven]
        found += values("rotations", "quatf", [f"({math.cos(a):.6g}, {math.sin(a):.6g}, 0, 0)" for a in angles])
        found += values("translations", "float3", [_vector([rng.gauss(0, 0.2 * plan.scale)] * 3) for _ in driven])
        found += values("scales", "half3", ["(1, 1, 1)" for _ in driven])
    return f'def SkelAnimation "Anim"\n{{\n{found}}}\n'


# --- meshes ------------------------------------------------------------------------------------------


def _mesh(plan: Plan, index: int, library: list[str]) -> str:
    rng = plan.rng
    surface = _surface(rng, rng.choice(_FORMS if index else _FORMS[:5]))
    far = rng.choice([1e4, 1e6]) if index and rng.random() < 0.15 else 0.0
    placed = [tuple(plan.scale * (each + far * (axis == 0)) for axis, each in enumerate(p)) for p in surface.points]
    names = [f"m{index}_{i}" if rng.random() < 0.6 else f"both{i}" for i in range(rng.randint(1, 7))]
    names = list(dict.fromkeys(names)) if index else [*dict.fromkeys([*names, "sure"])]
    targets = []
    for name in names:
        shape = f"{name}_{index}"
        moved = "sure" if name == "sure" else rng.choice(["bump", "bump", "all", "one", "none", "tiny"])
        library.append(_blend_shape(rng, shape, surface.points, moved, plan.scale))
        targets.append(f"</World/Char/Shapes/{shape}>")
    plan.tokens += [name for name in names if name not in plan.tokens]
    hidden = index and rng.random() < 0.2
    return (
        f'def Mesh "M{index}" (\n    prepend apiSchemas = ["SkelBindingAPI"]\n)\n{{\n{_UNBOUND}'
        f"    point3f[] points = [{', '.join(map(_vector, placed))}]\n"
        f"    int[] faceVertexCounts = [{', '.join(str(len(face)) for face in surface.faces)}]\n"
        f"    int[] faceVertexIndices = [{', '.join(str(i) for face in surface.faces for i in face)}]\n"
        f"    uniform token subdivisionScheme = {_text(rng.choice(['none', 'catmullClark']))}\n"
        f"    uniform token orientation = {_text(rng.choice(['rightHanded', 'rightHanded', 'leftHanded']))}\n"
        f"    uniform token[] skel:blendShapes = [{', '.join(map(_text, names))}]\n"
        f"    rel skel:blendShapeTargets = [{', '.join(targets)}]\n"
        f"{_influences(plan, len(surface.points))}{_subset(rng, len(surface.faces))}"
        + ('    token visibility = "invisible"\n' if hidden else "")
        + "}\n"
    )


_FORMS = ("grid", "tube", "fan", "star", "ball", "point", "line", "triangle")


def _surface(rng: random.Random, form: str) -> Surface:
    """About a unit in size."""
    across, up = rng.randint(3, 8), rng.randint(3, 8)
    if form in ("grid", "tube", "ball"):
        closed = form != "grid"
        points = [_at(form, i / across, j / up) for j in range(up + 1) for i in range(across + (not closed))]
        row = across + (not closed)
        columns = [(i, (i + 1) % row) for i in range(across)]
        quads = [
            [j * row + a, j * row + b, (j + 1) * row + b, (j + 1) * row + a] for j in range(up) for a, b in columns
        ]
        return Surface(points, quads)
    if form in ("fan", "star"):
        count = rng.randint(4, 9)
        reach = [1.0 if form == "fan" or i % 2 else 0.3 for i in range(count)]
        angles = [2.0 * math.pi * i / count for i in range(count)]
        rim = [(r * math.cos(a), r * math.sin(a), 0.1 * i) for i, (r, a) in enumerate(zip(reach, angles, strict=True))]
        return Surface(rim, [list(range(count))])
    corners = {
        "point": [(0.2, 0.2, 0.2)] * 4,
        "line": [(0.0, 0.25 * i, 0.0) for i in range(4)],
        "triangle": [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)],
    }[form]
    return Surface(corners, [[0, 1, 2], [0, 2, 3]])


def _at(form: str, u: float, v: float) -> Vector:
    if form == "grid":
        return (u - 0.5, v - 0.5, 0.3 * math.cos(3.0 * u) * math.cos(2.0 * v))
    a, b = 2.0 * math.pi * u, math.pi * v
    if form == "tube":
        return (0.4 * math.sin(a), v - 0.5, 0.4 * math.cos(a))
    return (math.sin(b) * math.sin(a), -math.cos(b), math.sin(b) * math.cos(a))


def _blend_shape(rng: random.Random, name: str, points: Sequence[Vector], moved: str, scale: float) -> str:
    """Dense or sparse, its points in any order, perhaps with in-betweens and offsets of normals."""
    centre, way = rng.choice(points), [rng.gauss(0, 0.2) for _ in range(3)]
    near = rng.uniform(0.3, 1.5)
    share = {
        "bump": [max(0.0, 1.0 - math.dist(each, centre) / near) for each in points],
        "sure": [max(0.1, 1.0 - math.dist(each, centre)) for each in points],
        "all": [1.0] * len(points),
        "one": [float(each is centre) for each in points],
        "none": [0.0] * len(points),
        "tiny": [1e-6] * len(points),
    }[moved]
    offsets = [tuple(scale * part * axis for axis in way) for part in share]
    rows = list(range(len(points)))
    sparse = rng.random() < 0.5
    if sparse:
        rows = [i for i in rows if share[i]] or [0]
        rng.shuffle(rows)

    def values(factor: float) -> str:
        return ", ".join(_vector([factor * axis for axis in offsets[i]]) for i in rows)

    text = f"    uniform vector3f[] offsets = [{values(1.0)}]\n"
    if sparse:
        text += f"    uniform int[] pointIndices = [{', '.join(map(str, rows))}]\n"
    if rng.random() < 0.3:
        text += f"    uniform vector3f[] normalOffsets = [{values(0.1)}]\n"
    for weight in rng.choice([[], [], [], [0.5], [-1.0, 0.25]]):
        factor = weight * rng.uniform(0.5, 1.5)
        text += f"    uniform vector3f[] inbetweens:at{abs(int(100 * weight))} = [{values(factor)}] (\n"
        text += f"        weight = {weight}\n    )\n"
    return f'def BlendShape "{name}"\n{{\n{text}}}\n'


def _influences(plan: Plan, count: int) -> str:
    """None, those of every point, or one for all; by the joints of the Skeleton or by an order of the mesh's own."""
    rng = plan.rng
    if not plan.joints or rng.random() < 0.3:
        return ""
    rigid = rng.random() < 0.3
    order = rng.sample(plan.joints, rng.randint(1, len(plan.joints))) if rng.random() < 0.4 else []
    width = rng.randint(1, 3)
    rows = 1 if rigid else count
    indices = [str(rng.randrange(len(order or plan.joints))) for _ in range(rows * width)]
    weights = []
    for _ in range(rows):
        drawn = [rng.random() + 0.01 for _ in range(width)]
        weights += [f"{each / sum(drawn):.6g}" for each in drawn]
    meta = f'(\n        interpolation = "{"constant" if rigid else "vertex"}"\n        elementSize = {width}\n    )\n'
    found = f"    int[] primvars:skel:jointIndices = [{', '.join(indices)}] {meta}"
    found += f"    float[] primvars:skel:jointWeights = [{', '.join(weights)}] {meta}"
    if order:
        found += f"    uniform token[] skel:joints = [{', '.join(map(_text, order))}]\n"
    if rng.random() < 0.3:
        found += '    uniform token primvars:skel:skinningMethod = "dualQuaternion"\n'
    if rng.random() < 0.4:
        found += f"    matrix4d primvars:skel:geomBindTransform = {_matrix(rng, plan.scale, turned=True)}\n"
    return found


def _subset(rng: random.Random, faces: int) -> str:
    if rng.random() < 0.7:
        return ""
    chosen = ", ".join(str(i) for i in range(faces) if rng.random() < 0.5)
    kind = '        uniform token elementType = "face"\n'
    return f'    def GeomSubset "part"\n    {{\n{kind}        int[] indices = [{chosen}]\n    }}\n'


# --- text --------------------------------------------------------------------------------------------


def _text(name: str) -> str:
    return f'"{name}"'


def _vector(values: Iterable[float]) -> str:
    return f"({', '.join(f'{each:.7g}' for each in values)})"
