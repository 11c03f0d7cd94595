"""Faults seeded into the layout of the sample are found, each by a code that names its prim.

`check` and both validators ask `layout_faults`.  Rules of the schema have a table of their own, made from the schema.
"""

import re

import numpy as np
import pytest
from folders import ROOT
from pxr import Gf, Sdf, Usd, UsdGeom, Vt

from usdrigui import pipeline
from usdrigui.layer import author, rules
from usdrigui.layer.read_layout import points_by_role
from usdrigui.reader.faults import layout_faults
from usdrigui.reader.reader_main import read_composed
from usdrigui.settings import load
from usdrigui.stages import schema

SAMPLE, JOYSTICK = ROOT / "sample_assets/char.usda", ROOT / "schemas/conformance/joint_joystick.usda"
SCOPE = "/Char/RigUI"
MESH = f"{SCOPE}/FaceControls"
SMILE, OTHER, WIDE = "mouthSmileLeft", "mouthSmileRight", "eyeBlinkLeft_eyeWideLeft"
EYE, HEAD, SQUASH, PUFF = "EyeLeft_ry_EyeLeft_rx", "Head_ry_Head_rx", "headSquash", "cheekPuff"


@pytest.fixture(scope="module")
def layer(tmp_path_factory):
    """Of the sample without most of its shapes whose like is there: each fault costs what the layout has."""
    target = tmp_path_factory.mktemp("seeded") / "char.rigui.usda"
    stage = opened(SAMPLE)
    shapes = stage.GetPrimAtPath("/Char/Animation").GetAttribute("blendShapes").Get()
    families = {each for each in shapes if each.startswith(("brow", "cheekS", "eyeSquint", "mouth", "nose"))}
    left_out = {each: {"exclude": True} for each in families - {SMILE, OTHER, "browInnerUp"}}
    pipeline.process(SAMPLE, load({"solve": {"gap": 0.1}, "controls": left_out}), output=target)
    return target


def opened(layer):
    """Edits go to the session layer."""
    stage = Usd.Stage.Open(str(layer))
    stage.SetEditTarget(stage.GetSessionLayer())
    return stage


@pytest.fixture
def stage(layer):
    return opened(layer)


class Layout:
    """The layout of a stage, to be spoilt."""

    def __init__(self, stage):
        self.stage = stage

    def prim(self, name):
        return self.stage.GetPrimAtPath(name if name.startswith("/") else f"{MESH}/{name}")

    def attribute(self, name, prim=SMILE):
        """Of an element, by the end of its name, or of any prim by its path."""
        return self.prim(prim).GetAttribute(name)

    def set(self, name, change, prim=SMILE):
        """Let a function of the value, or a value, take its place."""
        found, declared = self.attribute(name, prim), DECLARED.get(plain(name))
        value = found.Get() if found and found.HasValue() else declared and declared.fallback
        held = np.array(value) if hasattr(value, "FromNumpy") else value
        new = change(held) if callable(change) else change
        if not found:
            kind = Sdf.ValueTypeNames.Find(declared.type_name)
            found = self.prim(prim).CreateAttribute(name, kind, False, Sdf.VariabilityUniform)
        if isinstance(new, np.ndarray):
            new = type(value).FromNumpy(np.ascontiguousarray(new, dtype=held.dtype))
        elif isinstance(new, list):
            new = type(value)(new)
        assert found.Set(new), name

    def target(self, name, *targets, prim=SMILE):
        self.prim(prim).CreateRelationship(name).SetTargets(targets)

    def faces(self, prim):
        return np.array(self.attribute("indices", prim).Get())


def plain(name):
    """With the placeholder of instance names."""
    return re.sub(r"^(rigUI:(?:control|part)):[^:]+", r"\1:__INSTANCE_NAME__", name)


DECLARED = {each.name: each for api in schema.APIS for each in author.properties(api).values()}


# --- the mesh that draws ------------------------------------------------------------------------------


def shifted(way, *roles, prim=SMILE):
    """What is drawn of an element in some roles."""
    return lambda layout: layout.set("points", lambda old: moved(old, drawn(layout, prim, *roles), way), MESH)


def moved(old, rows, way):
    new = old.copy()
    new[rows] += way
    return new


def swap_faces(layout):
    one, other = map(layout.faces, (SMILE, OTHER))
    layout.set("indices", other, SMILE)
    layout.set("indices", one, OTHER)


def mesh(name, change):
    return lambda layout: layout.set(name, change, MESH)


def without_shape(name):
    return mesh("skel:blendShapes", lambda old: [each if each != name else "grin" for each in old])


def element(name, value, prim=SMILE):
    return lambda layout: layout.set(f"rigUI:{name}", value, prim)


def control(name, change, prim=SMILE, instance=SMILE):
    return element(f"control:{instance}:{name}", change, prim)


def relation(name, *targets, prim=SMILE):
    return lambda layout: layout.target(name, *targets, prim=prim)


def layout(name, change):
    return element(f"layout:{name}", change, SCOPE)


def both(*edits):
    return lambda layout: [each(layout) for each in edits]


def in_time(name, prim=SMILE):
    return lambda layout: (found := layout.attribute(name, prim)).Set(found.Get(), 1.0)


def second(layout):
    layout.stage.DefinePrim("/Char/Other").AddAppliedSchema(schema.LAYOUT)
    layout.set("rigUI:layout:handleWidth", 1.0, "/Char/Other")


def elbows(*parts):
    """Elements of the elbows, among some parts of the layout."""

    def edit(layout):
        for each in parts:
            layout.prim(SCOPE).AddAppliedSchema(f"{schema.PART}:{each}")
            layout.set(f"rigUI:part:{each}:handleWidth", 0.1, SCOPE)
        layout.set("rigUI:drawing:part", "elbows", MESH)

    return edit


def correct_twice(layout):
    for name, place in (("smile", "face"), ("smile_2", "board")):
        path = f"/Char/{schema.CORRECTIONS}/{name}"
        layout.stage.DefinePrim(path, "Scope").AddAppliedSchema(schema.CORRECTION)
        layout.set("rigUI:correction:control", SMILE, path)
        layout.set("rigUI:correction:place", place, path)


def drawn(layout, prim, *roles):
    return points_by_role(layout.prim(prim), *roles)


def cut_track(layout):
    rows, home = drawn(layout, SMILE, "track"), drawn(layout, SMILE, "handle")[0]
    layout.set("points", lambda old: moved(old, rows, 0.8 * (old[home] - old[rows])), MESH)


def short_limits(layout):
    soft = dict.fromkeys(["minimum", "maximum"], Vt.FloatArray(3))
    layout.attribute("blendShapeWeights", "/Char/Animation").SetMetadata("limits", {"soft": soft})


def turn_track(layout):
    rows = drawn(layout, SQUASH, "track")
    layout.set("points", lambda old: moved(old, rows, 2.0 * (old[rows].mean(axis=0) - old[rows])), MESH)


def draw_nothing(layout):
    for each in UsdGeom.Subset.GetAllGeomSubsets(UsdGeom.Imageable(layout.prim(MESH))):
        each.GetIndicesAttr().Set([])


def far_from_base(layout):
    values = [9.0] * len(layout.attribute("rigUI:layout:baseControls", SCOPE).Get())
    layout.set("rigUI:layout:baseValues", values, SCOPE)


def share_a_point(layout):
    start, home = (drawn(layout, SQUASH, role)[0] for role in ("track", "handle"))
    layout.set("faceVertexIndices", lambda old: np.where(old == start, home, old), MESH)


INVALID, DRAWN, TRACK = "LAYOUT_INVALID", "LAYOUT_DRAWN", "LAYOUT_TRACK"
FAULTS = {
    (DRAWN, SMILE): {
        "points shifted": shifted(0.1, *schema.ROLES),
        "points of a track shifted": shifted(1.0, "track"),
        "faces of two elements exchanged": swap_faces,
        "a shape twice as far": lambda each: each.set("offsets", lambda old: 2.0 * old, f"{MESH}/shape_{SMILE}"),
        "a shape left out": without_shape(SMILE),
        "skinned to another joint": mesh("primvars:skel:jointIndices", lambda old: (old + 1) % 5),
        "half the weight": mesh("primvars:skel:jointWeights", lambda old: 0.5 * old),
        "bound elsewhere": mesh("primvars:skel:geomBindTransform", Gf.Matrix4d().SetTranslate((0, 1, 0))),
        "the anchor's place moved": element("anchor:position", Gf.Vec3f(0.3, 0.4, 0.5)),
        "another lift": element("handle:lift", 0.0),
        "a normal the other way": element("anchor:normal", lambda old: -old),
        "a track elsewhere": control("trackPoints", lambda old: old + 2.0),
        "wide handles": layout("handleWidth", lambda old: 3.0 * old),
        "skin that is static": element("handle:adapt", "static"),
        "a track cut short": cut_track,
        "tracks called areas": mesh("primvars:rigUI:role:indices", lambda old: np.minimum(2 * old, 2)),
    },
    (INVALID, MESH): {
        "a face of two elements": lambda each: each.set("indices", lambda old: np.append(old, each.faces(OTHER)[0])),
        "a wrong number of corners": mesh("faceVertexCounts", lambda old: old + 1),
        "no role": mesh("primvars:rigUI:role", []),
        "an unknown role": mesh("primvars:rigUI:role", ["knob"] * 3),
        "roles of points": lambda each: (
            UsdGeom.PrimvarsAPI(each.prim(MESH)).GetPrimvar(schema.ROLE).SetInterpolation("vertex")
        ),
        "points in time": in_time("points", MESH),
        "indices of points": lambda each: each.set("elementType", "point"),
        "no Skeleton": relation("skel:skeleton", prim=MESH),
        "a purpose of render on the mesh": mesh("purpose", "render"),
        "smooth handles": mesh("subdivisionScheme", "catmullClark"),
        "faces inside out": mesh("orientation", "leftHanded"),
        "holes": mesh("holeIndices", Vt.IntArray(1)),
        "another extent": mesh("extent", lambda old: 0.5 * old),
        "normals of its own": mesh("normals", Vt.Vec3fArray(1)),
        "nothing to be seen": mesh("primvars:displayOpacity", Vt.FloatArray(1)),
        "members beside others": relation("rigUI:element:members", f"{MESH}/{OTHER}"),
        "points for a mesh": lambda each: each.prim(MESH).SetTypeName("Points"),
        "an unknown way of skinning": mesh("primvars:skel:skinningMethod", "magic"),
        "a part that is none": elbows("face"),
        "colours beyond those that there are": mesh("primvars:displayColor:indices", lambda old: old + 9),
        "an unknown type of family": mesh("subsetFamily:rigUI:familyType", "magic"),
    },
    (INVALID, SMILE): {
        "faces beyond the mesh": lambda each: each.set("indices", lambda old: old + 10**6),
        "no handle": mesh("primvars:rigUI:role", ["track"] * 3),
        "a track in time": in_time(f"rigUI:control:{SMILE}:trackPoints"),
        "another family of subsets": lambda each: each.set("familyName", "materialBind"),
        "another number of points": element("anchor:pointCount", 99999),
        "a heading on the face": element("element:category", "viseme"),
        "a carrier on the face": relation("rigUI:anchor:carrier", "/Char/Geometry/Head"),
        "a point without its index": element("anchor:pointIndex", -1),
        "the wrong side": element("element:side", "right"),
        "no side": element("element:side", "none"),
        "no mirror": both(relation("rigUI:element:mirror"), relation("rigUI:element:mirror", prim=OTHER)),
        "another mirror": relation("rigUI:element:mirror", f"{MESH}/jawOpen"),
        "a mirror that is none": relation("rigUI:element:mirror", "/Char/Skeleton"),
        "mirrored the other way": control("mirrorReversed", True),
        "mirrored the other way in a part that is not the main one": both(
            elbows("face", "elbows"), control("mirrorReversed", True)
        ),
        "a joystick with one axis": element("element:elementType", "patch"),
        "an end opposed to itself": control("opposes", SMILE),
        "an end opposed to none": control("opposes", "jawOpen"),
        "a control that is not applied": element("element:controls", ["grin"]),
        "a shape of no mesh": control("blendShapes", ["grin"]),
        "names exchanged": both(control("name", OTHER), control("name", SMILE, OTHER, OTHER)),
        "no shape": control("blendShapes", []),
        "two shapes without keys": control("blendShapes", [SMILE, "jawOpen"]),
        "degrees for weights": control("unit", "degrees"),
        "a track twice as long": control("arcLength", lambda old: 2.0 * old),
        "another magnification": control("magnification", 3.0),
        "the plane the other way": layout("planeNormal", lambda old: -old),
        "a normal aside": element("anchor:normal", lambda old: Gf.Cross(old, Gf.Vec3f.YAxis()).GetNormalized()),
        "a side without a plane": layout("planeNormal", Gf.Vec3f()),
        "a peak too low": control("peak", lambda old: 0.3 * old),
        "a peak too high": control("peak", lambda old: 3.0 * old),
        "an animation that is none": relation(f"rigUI:control:{SMILE}:animation", "/Char/Skeleton"),
    },
    (DRAWN, SQUASH): {
        "a track drawn backwards": turn_track,
        "a track that begins in a point of the handle": share_a_point,
        "a shape of the board left out": without_shape(SQUASH),
    },
    (INVALID, SCOPE): {
        "the plane elsewhere": layout("planeOrigin", Gf.Vec3f(5, 0, 0)),
        "a purpose of render": lambda each: each.set("purpose", "render", SCOPE),
        "handles wider than those of a part": elbows("elbows"),
        "the view of no part": both(
            elbows("elbows"), layout("handleWidth", 0.1), layout("viewDirection", Gf.Vec3f.XAxis())
        ),
        "a name twice": element("element:name", OTHER),
        "its own member": relation("rigUI:element:members", f"{MESH}/{SMILE}"),
        "no Skeleton of the layout": relation("rigUI:layout:skeleton", prim=SCOPE),
        "a mesh among the Skeletons": lambda each: (
            each.prim(SCOPE).GetRelationship("rigUI:layout:skeleton").AddTarget("/Char/Geometry/Head")
        ),
        "a character that is none": lambda each: each.prim("/Char").SetTypeName("Xform"),
        "a list without a control": layout(
            "baseControls", lambda old: [each if each != SMILE else "grin" for each in old]
        ),
        "a control listed twice": layout("baseControls", lambda old: [old[0], *list(old)[:-1]]),
        "a list of what is no element": relation("rigUI:layout:elements", "/Char/Skeleton", prim=SCOPE),
        "a second layout": second,
        "a Skeleton that is none": relation("rigUI:layout:skeleton", "/Char/Geometry/Head", prim=SCOPE),
        "an Xform for the Scope": lambda each: each.prim(SCOPE).SetTypeName("Xform"),
    },
    (TRACK, SMILE): {
        "another point": element("anchor:pointIndex", lambda old: old + 40),
        "another's shape": both(control("blendShapes", ["browInnerUp"]), control("source", "browInnerUp")),
        "twice the range": control("maximum", 2.0),
        "a track the other way": control("trackPoints", np.flipud),
    },
    ("RANGE_INVALID", "/Char/Animation"): {
        "limits that are short": short_limits,
    },
    ("LAYOUT_TOPOLOGY", SMILE): {
        "another topology": element("anchor:topologyHash", "0123"),
    },
    ("LAYOUT_MESH_GONE", "/Char/Nose"): {
        "a mesh that is not there": relation("rigUI:anchor:prim", "/Char/Nose"),
    },
    (INVALID, OTHER): {
        "a mirror that is not mutual": relation("rigUI:element:mirror"),
    },
    (INVALID, EYE): {
        "not mirrored the other way": control("mirrorReversed", False, EYE, "EyeLeft_ry"),
        "a slider with two axes": element("element:elementType", "slider", EYE),
        "a joint of no Skeleton": control("joints", ["Tail"], EYE, "EyeLeft_ry"),
        "joints without a Skeleton": relation("rigUI:control:EyeLeft_ry:skeleton", prim=EYE),
        "radians for degrees": control("jointRotationVectors", np.radians, EYE, "EyeLeft_ry"),
        "weights for degrees": control("unit", "weight", EYE, "EyeLeft_ry"),
        "a Skeleton of nobody": relation("rigUI:control:EyeLeft_ry:skeleton", "/Skeleton", prim=EYE),
        "an axis listed twice": element("element:controls", ["EyeLeft_ry"] * 2, EYE),
        "another joint": control("joints", ["Neck/Head/Jaw"], EYE, "EyeLeft_ry"),
        "another joint's name": control("source", "Neck/Head/Jaw", EYE, "EyeLeft_ry"),
        "a range beyond the track": control("maximum", 99.0, EYE, "EyeLeft_rx"),
        "a turn at the default": control("jointRotationVectors", lambda old: old + 5.0, EYE, "EyeLeft_ry"),
    },
    (INVALID, WIDE): {
        "two ends that are not opposed": control("opposes", "", WIDE, "eyeWideLeft"),
    },
    (TRACK, EYE): {
        "a turn the other way": control("jointRotationVectors", lambda old: -old, EYE, "EyeLeft_ry"),
    },
    (INVALID, f"{PUFF}_mirror"): {
        "a control in two ways": control("maximum", 0.5, PUFF, PUFF),
    },
    (INVALID, "jawOpen"): {
        "a side in the middle": element("element:side", "left", "jawOpen"),
        "no face for any element": draw_nothing,
    },
    (INVALID, SQUASH): {
        "a board seen from its edge": element("anchor:normal", Gf.Vec3f.XAxis(), SQUASH),
        "the view from behind": layout("viewDirection", lambda old: -old),
        "no side on the board": element("element:side", "none", SQUASH),
        "a carrier that is no mesh": relation("rigUI:anchor:carrier", "/Char/Skeleton", prim=SQUASH),
    },
    (DRAWN, EYE): {
        "axes exchanged": element("element:controls", ["EyeLeft_rx", "EyeLeft_ry"], EYE),
        "a base pose outside": far_from_base,
        "areas shifted": shifted(1.0, "area", prim=EYE),
    },
    (INVALID, HEAD): {
        "a head that turns farther": control("jointRotationVectors", lambda old: 3.0 * old, HEAD, "Head_ry"),
        "a path of the board that is not the longest": both(
            control("arcLength", lambda old: 9.0 * old, HEAD, "Head_ry"),
            control("magnification", lambda old: old / 9.0, HEAD, "Head_ry"),
        ),
    },
    (INVALID, f"/Char/{schema.CORRECTIONS}/smile_2"): {
        "two corrections of one control": correct_twice,
    },
}
"""By the code that finds them and the prim that it names."""


def test_the_layout_of_the_sample_has_no_fault(stage):
    """Nor with a single number of a person's own on what draws it."""
    UsdGeom.PrimvarsAPI(stage.GetPrimAtPath(MESH)).CreatePrimvar("weight", Sdf.ValueTypeNames.Float).Set(1.0)
    assert layout_faults(stage) == ()


@pytest.mark.parametrize(
    ("edit", "code", "where"),
    [pytest.param(edit, *at, id=name) for at, faults in FAULTS.items() for name, edit in faults.items()],
)
def test_a_fault_is_found_by_a_code_that_names_its_prim(stage, edit, code, where):
    edit(Layout(stage))
    path = where if where.startswith("/") else f"{MESH}/{where}"
    found = layout_faults(stage)
    named = [each for each in found if each.code == code and (each.path.startswith(path) or each.path == where)]
    assert named, found[:4]
    assert all(each.repair for each in named)


def test_a_control_of_the_board_is_that_of_the_character(stage):
    control("jointRotationVectors", lambda old: -old, HEAD, "Head_ry")(Layout(stage))
    found = read_composed(stage, load({}), ["/Char"]).contradictions
    assert {each.path for each in found} >= {f"{MESH}/{HEAD}"}


# --- the rules of the schema --------------------------------------------------------------------------


def rules_of_the_schema():
    """Each rule with values that break it."""
    for api in schema.APIS:
        for key, declared in author.properties(api).items():
            for rule, said in declared.rules.items():
                for number, value in enumerate(breaking(rule, said, declared)):
                    yield pytest.param(api, declared, value, id=f"{api}:{key} {rule} {number}")
            if declared.allowed and key != "role":
                value = Vt.TokenArray(["no"]) if declared.type_name.endswith("[]") else "no"
                yield pytest.param(api, declared, value, id=f"{api}:{key} allowed")


def breaking(rule, said, declared):
    if rule == "Length":
        return [typed(declared, [1.0] * (1 if said.startswith("[2") else 97))]
    if rule == "Order":
        return [typed(declared, [0.0, 1.0, 1.0]), typed(declared, [1.0, 0.0])]
    if rule == "Norm":
        return [typed(declared, [0.25])]
    opening, low, high, _ = rules.INTERVAL.fullmatch(said).groups()
    ends = [] if declared.type_name.startswith("int") else [np.nan, np.inf, -np.inf]
    ends += [float(low) - (opening == "[")] if low not in ("-inf", "minimum") else []
    ends += [10**6] * (high != "inf") + [-(10**6)] * (low == "minimum")
    return [typed(declared, [end]) for end in ends]


def typed(declared, numbers):
    """The numbers as the attribute holds them, each for all components of a vector."""
    kind = declared.type_name.removesuffix("[]")
    rows = [int(each) if kind == "int" else float(each) for each in numbers]
    if kind.startswith(("vector", "point")):
        rows = [(Gf.Vec3d if kind.endswith("d") else Gf.Vec3f)(each) for each in rows]
    return type(declared.fallback)(rows) if declared.type_name.endswith("[]") else rows[0]


@pytest.mark.parametrize(("api", "declared", "value"), list(rules_of_the_schema()))
def test_a_value_that_breaks_a_rule_of_the_schema_is_refused(api, declared, value):
    joystick = opened(JOYSTICK)  # as small as it can be: there are many rules
    of_other = {schema.LAYOUT: SCOPE, schema.PART: SCOPE, schema.CORRECTION: f"/Char/{schema.CORRECTIONS}/smile"}
    where = of_other.get(api, f"{MESH}/Jaw_ry_Jaw_rx")
    if api == schema.CORRECTION:
        joystick.DefinePrim(where, "Scope").AddAppliedSchema(schema.CORRECTION)
    if api == schema.PART:
        joystick.GetPrimAtPath(where).AddAppliedSchema(f"{schema.PART}:Jaw_ry")
        Layout(joystick).set("rigUI:part:Jaw_ry:handleWidth", 0.1, where)
    name = declared.name.replace("__INSTANCE_NAME__", "Jaw_ry")
    if declared.type_name:
        Layout(joystick).set(name, value, where)
    else:
        Layout(joystick).target(name, MESH, SCOPE, prim=where)
    (found,) = layout_faults(joystick)
    assert (found.code, found.path.partition(".")[0]) == (INVALID, where)
    named = found.path.partition(".")[2].replace("Jaw_ry", "__INSTANCE_NAME__")
    told = " ".join(DECLARED[named].rules.values())
    assert named == declared.name or declared.name.rpartition(":")[2] in told, found
