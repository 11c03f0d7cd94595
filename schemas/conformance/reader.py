"""A reader of layouts in 200 lines, an example: ``reader.py LAYER``, with questions on standard input (*Conformance* in
CONTRACT.md).  It was written from that page and reads the rules of schema.usda; it needs usd-core alone."""

import itertools as it
import json
import math
import re
import sys
from pathlib import Path

from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, Vt

SCHEMA = Sdf.Layer.FindOrOpen(str(Path(__file__).resolve().parents[1] / "schema.usda"))
SPECS = {each.name: {spec.name.split(":")[-1]: spec for spec in each.properties} for each in SCHEMA.rootPrims}
NONE, ONE, HERE = Gf.Vec3d(0), Gf.Vec3d(1), Gf.Vec2d(0)


class Applied:
    """A schema applied to a prim: its properties, with their fallbacks and rules."""

    def __init__(self, prim, schema, instance=""):
        self.prim, self.specs, self.instance = prim, SPECS[schema], instance
        self.prefix = f"rigUI:control:{instance}:" if instance else ""
        for short, spec in self.specs.items():
            if isinstance(spec, Sdf.AttributeSpec) and self(short) not in (None, spec.default):
                self.refuse_unlawful(short, spec)

    def __call__(self, short):
        spec = self.specs[short]
        found = self.prim.GetProperty(self.prefix + spec.name)
        if isinstance(spec, Sdf.RelationshipSpec):
            return [self.prim.GetStage().GetPrimAtPath(each) for each in found.GetTargets()] if found else []
        return spec.default if not found or found.Get() is None else found.Get()

    def refuse_unlawful(self, short, spec):
        entries = list(self(short)) if spec.typeName.isArray else [self(short)]
        numbers = [n for each in entries for n in ([each] if isinstance(each, (str, int, float)) else each)]
        rules = dict(re.findall(r"(Range|Length|Order|Norm): *([^\n]*)", spec.documentation))
        norms, lengths = (rules.get(rule, "").split(" or ") for rule in ("Norm", "Length"))
        lawful = [{*entries} <= {*(spec.GetInfo("allowedTokens") or entries)}]
        lawful += [self.within(n, rules["Range"]) for n in numbers if "Range" in rules]
        lawful += [any(self.within(len(entries), each) for each in lengths if each) or lengths == [""]]
        lawful += [a < b for a, b in it.pairwise(entries) if "Order" in rules]
        lawful += [any(abs(v.GetLength() - float(n)) < 1e-4 for n in norms) for v in entries if norms != [""]]
        if not all(lawful):
            raise ValueError(f"{self.prim.GetPath()}: {short}")

    def within(self, number, rule):
        if rule[0] not in "[(":
            return number == math.prod(map(self.bound, rule.split(" * ")))
        low, high = map(self.bound, rule[1:-1].split(", "))
        at_end = (rule[0] == "[" and number == low) or (rule[-1] == "]" and number == high)
        return math.isfinite(number) and (low < number < high or at_end)

    def bound(self, word):
        value = self(word) if word in self.specs else float(word)
        return len(value) if hasattr(value, "__len__") else value


def between(keys, row, value):
    """Linear between the keys and beyond them."""
    i = max(0, min(len(keys) - 2, sum(key <= value for key in keys) - 1))
    share = (value - keys[i]) / (keys[i + 1] - keys[i])
    return row[i] * (1 - share) + row[i + 1] * share


class Control(Applied):
    def __init__(self, prim, instance):
        super().__init__(prim, "RigUIControlAPI", instance)
        self.name, self.points = self("name") or instance, [Gf.Vec3d(p) for p in self("trackPoints")]
        low, step = self("minimum"), (self("maximum") - self("minimum")) / (len(self.points) - 1)
        self.values = list(self("trackValues")) or [low + step * i for i in range(len(self.points))]

    def place(self, value):
        return between(self.values, self.points, value)

    def at(self, short, count, value):
        """The entries of an array of the drive at a value, one for each of `count` weights or joints."""
        array, keys, log = [*self(short)], self("keys"), short == "jointScaleFactors"
        rows = [[Gf.Vec3d(*map(math.log, each)) if log else each for each in array[i::count]] for i in range(count)]
        found = [between(keys, row, value) if row else None for row in rows]
        return [Gf.Vec3d(*map(math.exp, each)) if log and each else each for each in found]


class Element(Applied):
    def __init__(self, prim):
        super().__init__(prim, "RigUIElementAPI")
        anchor, handle = Applied(prim, "RigUIAnchorAPI"), Applied(prim, "RigUIHandleAPI")
        applied = [s.split(":", 1) for s in prim.GetPrimTypeInfo().GetAppliedAPISchemas() if ":" in s]
        instances = self("controls") or [name for schema, name in applied if schema == "RigUIControlAPI"]
        self.controls, self.name = [Control(prim, each) for each in instances], self("name") or prim.GetName()
        self.board, (self.mesh,) = not anchor("prim"), anchor("prim") or anchor("carrier")
        self.index, self.place = anchor("pointIndex"), Gf.Vec3d(anchor("position"))
        self.rigid = self.board or handle("adapt") == "static"

    def described(self, names):
        index = {c.instance: i for i, c in enumerate(self.controls)}
        pairs = {index[c("opposes")]: i for i, c in enumerate(self.controls) if c("opposes")}
        axes = [[i, pairs[i]] if i in pairs else [i] for i in index.values() if i not in pairs.values()]
        told = {"type": self("elementType"), "axes": [[self.controls[i].name for i in axis] for axis in axes]}
        told |= {"mirror": "".join(names[p] for p in self("mirror")), "members": [names[p] for p in self("members")]}
        return {**told, "side": self("side"), "onBoard": self.board, "values": [c.values for c in self.controls]}


class Layout:
    def __init__(self, path):
        self.stage, everywhere = Usd.Stage.Open(path), Usd.TraverseInstanceProxies()
        applied = {p: p.GetPrimTypeInfo().GetAppliedAPISchemas() for p in self.stage.Traverse(everywhere)}
        if any(re.match(r"RigUI\w+API_\d", schema) for each in applied.values() for schema in each):
            raise ValueError("a later version")
        scope = next(p for p in applied if "RigUILayoutAPI" in applied[p])
        layout, self.root = Applied(scope, "RigUILayoutAPI"), scope.GetParent()
        self.elements = [Element(p) for p in applied if "RigUIElementAPI" in applied[p]]
        order = layout("elements") or [e.prim for e in self.elements]
        self.elements.sort(key=lambda e: order.index(e.prim))
        self.controls = {c.name: c for e in self.elements for c in e.controls}
        self.base = {name: control("default") for name, control in self.controls.items()}
        self.base |= dict(it.zip_longest(layout("baseControls"), layout("baseValues"), fillvalue=0.0))
        cache, root = UsdSkel.Cache(), UsdSkel.Root(self.root)
        cache.Populate(root, everywhere)
        bindings = cache.ComputeSkelBindings(root, everywhere)
        self.bound = {s.GetPrim(): (b.GetSkeleton(), s) for b in bindings for s in b.GetSkinningTargets()}

    def layout(self, _):
        names = {e.prim: e.name for e in self.elements}
        return {e.name: e.described(names) for e in self.elements}

    def pose(self, question):
        values, answer = self.base | question["values"], {}
        for e in self.elements:
            (before, offset), (now, moved) = (self.at(e, each) for each in (self.base, values))
            aside, others = self.at(e, values | {c.name: self.base[c.name] for c in e.controls})
            carried = before.GetInverse() * Gf.Matrix4d().SetTranslate(others - offset) * aside
            on, off = (sum((c.place(each[c.name]) for c in e.controls), NONE) for each in (values, self.base))
            handle = carried.Transform(e.place + on - off) if e.rigid else now.Transform(moved)
            tracks = [[[*carried.Transform(point)] for point in c.points] for c in e.controls]
            answer[e.name] = {"handle": [*handle], "tracks": tracks}
        return answer

    def at(self, element, values):
        """An element's anchor in a pose: the map of its joints into the SkelRoot's space, and the point before it."""
        skeleton, skin = self.bound[element.mesh]
        weights, joints = self.driven(values)
        points = UsdGeom.Mesh(element.mesh).GetPointsAttr().Get()
        if skin.HasBlendShapes() and not element.rigid:
            blend = UsdSkel.BlendShapeQuery(UsdSkel.BindingAPI(element.mesh))
            shares = blend.ComputeSubShapeWeights([weights.get(shape, 0.0) for shape in skin.GetBlendShapeOrder()])
            indices, offsets = blend.ComputeBlendShapePointIndices(), blend.ComputeSubShapePointOffsets()
            blend.ComputeDeformedPoints(*shares, indices, offsets, points)
        local, names = [], skeleton.GetJointsAttr().Get()
        for name, rest in zip(names, skeleton.GetRestTransformsAttr().Get(), strict=True):
            translation, rotation, scale = UsdSkel.DecomposeTransform(rest)
            vector, shift, factors = joints.get((skeleton.GetPrim(), name), (NONE, NONE, ONE))
            turn = Gf.Rotation(vector or ONE, vector.GetLength()) * Gf.Rotation(rotation)
            stretch = Gf.Matrix4d().SetScale(Gf.CompMult(factors, Gf.Vec3d(scale)))
            local.append(stretch * Gf.Matrix4d(turn, Gf.Vec3d(translation) + shift))
        posed = UsdSkel.ConcatJointTransforms(UsdSkel.Topology(names), local, Gf.Matrix4d(1))
        bind = dict(zip(names, skeleton.GetBindTransformsAttr().Get(), strict=True))
        moved = {name: bind[name].GetInverse() * now for name, now in zip(names, posed, strict=True)}
        arrays = skin.ComputeVaryingJointInfluences(len(points))
        n = len(arrays[0]) // len(points)
        four = [type(each)([*each[element.index * n : (element.index + 1) * n]] * 4) for each in arrays]
        corners, order = Vt.Vec3fArray([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]), skin.GetJointOrder() or names
        bound = skin.GetSkinningMethod(), skin.GetGeomBindTransform()
        UsdSkel.SkinPoints(*bound, [moved[joint] for joint in order], *four, n, corners)
        out, into = (UsdGeom.XformCache().GetLocalToWorldTransform(p) for p in (skeleton.GetPrim(), self.root))
        o, x, y, z = ((out * into.GetInverse()).Transform(Gf.Vec3d(corner)) for corner in corners)
        return Gf.Matrix4d(*x - o, 0, *y - o, 0, *z - o, 0, *o, 1), Gf.Vec3d(points[element.index])

    def driven(self, values):
        """Weights by blend shape, and by joint a rotation vector, a translation and factors."""
        weights, moved, parts = {}, {}, ("jointRotationVectors", "jointTranslations", "jointScaleFactors")
        for name, control in self.controls.items():
            shapes, joints, value = control("blendShapes"), control("joints"), values[name]
            added = control.at("blendShapeWeights", len(shapes), value) if control("keys") else [value]
            for shape, weight in zip(shapes, added, strict=True):
                weights[shape] = weights.get(shape, 0.0) + weight
            which = control("jointSkeletons") or [0] * len(joints)
            given = (control.at(part, len(joints), value) for part in parts)
            for joint, i, turn, shift, factors in zip(joints, which, *given, strict=True):
                at = moved.setdefault((control("skeleton")[i], joint), [NONE, NONE, ONE])
                at[:] = at[0] + (turn or NONE), at[1] + (shift or NONE), Gf.CompMult(at[2], factors or ONE)
        return weights, moved


def drag(q):
    """Values of the members after each move.  Fans, and tracks that are seen from their end, are left out."""
    now, lines = dict(enumerate(q["start"])), []
    for axis in q["axes"]:
        off, ends = ({i: q[limit][i] for i in axis} for limit in ("default", "maximum"))
        low = {i: q["minimum"][i] for i in axis if ends[i] - off[i] < off[i] - q["minimum"][i]}
        reach = {i: end - off[i] for i, end in (ends | low).items()}
        shares = {i: [(value - off[i]) / (reach[i] or 1) for value in (now[i], *q["values"][i])] for i in axis}
        if len(axis) == 2:
            down, up = ([(i, share) for share in sorted(shares[i][1:]) if share >= 0] for i in axis)
            lines.append([{**off, i: off[i] + share * reach[i]} for i, share in (*down[:0:-1], *up)])
            one, other = sorted(axis, key=lambda i, shares=shares: -shares[i][0])
            now |= {**off, one: off[one] + (shares[one][0] - shares[other][0]) * reach[one]}
        else:
            lines.append([{axis[0]: value} for value in q["values"][axis[0]]])
    pieces = [[*it.pairwise((place(q, values), values) for values in line)] for line in lines]
    if len(lines) > 2 or any(sum((b[0] - a[0]).GetLength() for a, b in each) < 6 for each in pieces):
        return None
    answer, cell, cells = [], None, [*it.product(*(range(len(each)) for each in pieces))]
    for move in ((0, 0), *q["moves"]):
        goal = place(q, now) + Gf.Vec2d(*move)
        found = {c: nearest([each[i] for each, i in zip(pieces, c, strict=True)], goal) for c in cells}
        near, best = None, min(cells, key=lambda c: found[c][0])
        while cell and near != cell:
            around = [c for c in cells if all(abs(a - b) < 2 for a, b in zip(c, cell, strict=True))]
            near, cell = cell, min([cell, *around], key=lambda c: found[c][0])
        cell = cell if cell and found[cell][0] <= 2 * found[best][0] + 4 else best
        answer.append([value for _, value in sorted(found[cell][1].items())])
    return answer[1:]


def place(q, values):
    """Where some members at their values take the handle from its place in the base pose."""
    tracks = {i: [Gf.Vec2d(*point) for point in q["tracks"][i]] for i in values}
    ends = [(between(q["values"][i], tracks[i], each[i])) for i in values for each in (values, q["base"])]
    return sum(ends[::2], HERE) - sum(ends[1::2], HERE)


def nearest(pieces, goal):
    """Of what one piece of each axis spans, how far the place nearest to the goal is, and its values."""
    arms, left = [b[0] - a[0] for a, b in pieces], goal - sum((a[0] for a, _ in pieces), HERE)
    shares = [0.0] * len(arms)
    for _, (i, arm) in it.product(range(60), enumerate(arms)):
        rest = left - sum((each * shares[j] for j, each in enumerate(arms) if j != i), HERE)
        shares[i] = min(max(rest * arm / (arm * arm or 1), 0.0), 1.0)
    values = {m: between((0, 1), (a[1][m], b[1][m]), s) for s, (a, b) in zip(shares, pieces, strict=True) for m in a[1]}
    return (rest - arm * shares[-1]).GetLength(), values


def answers(layer, questions):
    try:
        read = Layout(layer)
    except ValueError:
        return [{"refused": True} for _ in questions]
    ask = {"layout": read.layout, "pose": read.pose, "drag": drag, "findings": lambda _: None}
    return [ask[each["ask"]](each) for each in questions]


if __name__ == "__main__":
    print(json.dumps(answers(sys.argv[1], json.load(sys.stdin))))
