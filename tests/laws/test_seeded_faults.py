"""Faults seeded into the layout of the sample are found, each by a code that names its prim.

`check` and both validators ask `layout_faults`.  Rules of the schema have a table of their own, made from the schema.
"""

from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Sdf, Usd, UsdGeom, Vt

from usdrigui import pipeline
from usdrigui.layer import author, rules
from usdrigui.reader.faults import layout_faults
from usdrigui.settings import load
from usdrigui.stages import schema

SAMPLE = Path(__file__).resolve().parents[2] / "sample_assets" / "char.usda"
SCOPE = "/Char/RigUI"
MESH = f"{SCOPE}/FaceControls"
SMILE, OTHER, WIDE = "mouthSmileLeft", "mouthSmileRight", "eyeBlinkLeft_eyeWideLeft"
EYE, SQUASH, PUFF, JAW = "EyeLeft_ry_EyeLeft_rx", "headSquash", "cheekPuff", "Jaw_rx"


@pytest.fixture(scope="module")
def layer(tmp_path_factory):
    target = tmp_path_factory.mktemp("seeded") / "char.rigui.usda"
    pipeline.process(SAMPLE, load({"solve": {"gap": 0.1}}), output=target)
    return target


@pytest.fixture
def stage(layer):
    """Edits go to the session layer."""
    stage = Usd.Stage.Open(str(layer))
    stage.SetEditTarget(stage.GetSessionLayer())
    return stage


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
        new = change(value) if callable(change) else change
        if not found:
            kind = Sdf.ValueTypeNames.Find(declared.type_name)
            found = self.prim(prim).CreateAttribute(name, kind, False, Sdf.VariabilityUniform)
        if isinstance(new, np.ndarray):
            new = type(value).FromNumpy(np.ascontiguousarray(new, dtype=np.asarray(value).dtype))
        assert found.Set(new), name

    def control(self, name, change, prim=SMILE, instance=SMILE):
        self.set(f"rigUI:control:{instance}:{name}", change, prim)

    def target(self, name, *targets, prim=SMILE):
        self.prim(prim).CreateRelationship(name).SetTargets([Sdf.Path(each) for each in targets])

    def faces(self, prim):
        return np.array(self.attribute("indices", prim).Get())

    def points_of(self, prim):
        counts = np.array(self.attribute("faceVertexCounts", MESH).Get())
        corners = np.split(np.array(self.attribute("faceVertexIndices", MESH).Get()), np.cumsum(counts)[:-1])
        return np.unique(np.concatenate([corners[each] for each in self.faces(prim)]))


def plain(name):
    """With the placeholder of instance names."""
    parts = name.split(":")
    return ":".join([*parts[:2], "__INSTANCE_NAME__", *parts[3:]]) if {*parts[1:2]} & {"control", "part"} else name


DECLARED = {each.name: each for api in schema.APIS for each in author.properties(api).values()}


# --- the mesh that draws ------------------------------------------------------------------------------


def shift(layout):
    rows = layout.points_of(SMILE)
    layout.set("points", lambda old: moved(old, rows, 0.1), MESH)


def moved(old, rows, way):
    new = np.array(old)
    new[rows] += way
    return new


def shift_one_track(layout):
    last = layout.points_of(SMILE)[-3:]
    layout.set("points", lambda old: moved(old, last, 1.0), MESH)


def swap_faces(layout):
    one, other = layout.faces(SMILE), layout.faces(OTHER)
    layout.set("indices", other, SMILE)
    layout.set("indices", one, OTHER)


def drop_shape(layout, name=SMILE):
    names = list(layout.attribute("skel:blendShapes", MESH).Get())
    relation = layout.stage.GetPrimAtPath(MESH).GetRelationship("skel:blendShapeTargets")
    targets, at = relation.GetTargets(), names.index(name)
    layout.set("skel:blendShapes", Vt.TokenArray(names[:at] + names[at + 1 :]), MESH)
    relation.SetTargets(targets[:at] + targets[at + 1 :])


def shape(name, change):
    return lambda layout: layout.set("offsets", lambda old: change(np.array(old)), f"{MESH}/shape_{name}")


def other_joint(layout):
    layout.set("primvars:skel:jointIndices", lambda old: (np.array(old) + 1) % 5, MESH)


def mesh(name, change):
    return lambda layout: layout.set(name, change, MESH)


def element(name, value, prim=SMILE):
    return lambda layout: layout.set(f"rigUI:{name}", value, prim)


def control(name, change, prim=SMILE, instance=SMILE):
    return lambda layout: layout.control(name, change, prim, instance)


def relation(name, *targets, prim=SMILE):
    return lambda layout: layout.target(name, *targets, prim=prim)


def layout(name, change):
    return lambda each: each.set(f"rigUI:layout:{name}", change, SCOPE)


def both(*edits):
    def edit(layout):
        for each in edits:
            each(layout)

    return edit


def roles(change):
    def edit(layout):
        primvar = UsdGeom.PrimvarsAPI(layout.stage.GetPrimAtPath(MESH)).GetPrimvar(schema.ROLE)
        change(layout, primvar)

    return edit


def beside(layout):
    layout.set("indices", lambda old: np.append(np.array(old), layout.faces(OTHER)[0]), SMILE)


def reverse(values):
    return np.array(values)[::-1]


def twice(names):
    return Vt.TokenArray([names[0], *list(names)[:-1]])


def second(layout):
    layout.stage.DefinePrim("/Char/Other").AddAppliedSchema(schema.LAYOUT)
    layout.set("rigUI:layout:handleWidth", 1.0, "/Char/Other")


TRACK_POINTS = f"rigUI:control:{SMILE}:trackPoints"
GONE = Gf.Vec3f(0.3, 0.4, 0.5)
INVALID, DRAWN, TRACK = "LAYOUT_INVALID", "LAYOUT_DRAWN", "LAYOUT_TRACK"
FAULTS = {
    # What draws.
    "points shifted": (shift, DRAWN, SMILE),
    "points of a track shifted": (shift_one_track, DRAWN, SMILE),
    "faces of two elements exchanged": (swap_faces, DRAWN, SMILE),
    "a face of two elements": (beside, INVALID, MESH),
    "faces beyond the mesh": (lambda each: each.set("indices", lambda old: np.array(old) + 10**6), INVALID, SMILE),
    "a wrong number of corners": (mesh("faceVertexCounts", lambda old: np.array(old) + 1), INVALID, MESH),
    "a shape twice as far": (shape(SMILE, lambda old: 2.0 * old), DRAWN, SMILE),
    "a shape left out": (drop_shape, DRAWN, SMILE),
    "a shape of the board left out": (lambda each: drop_shape(each, SQUASH), DRAWN, SQUASH),
    "skinned to another joint": (other_joint, DRAWN, SMILE),
    "half the weight": (mesh("primvars:skel:jointWeights", lambda old: 0.5 * np.array(old)), DRAWN, SMILE),
    "bound elsewhere": (
        mesh("primvars:skel:geomBindTransform", Gf.Matrix4d().SetTranslate((0, 1, 0))),
        DRAWN,
        SMILE,
    ),
    "no handle": (roles(lambda _, primvar: primvar.Set(Vt.TokenArray(["track"] * 3))), INVALID, SMILE),
    "no role": (roles(lambda _, primvar: primvar.Set(Vt.TokenArray())), INVALID, MESH),
    "an unknown role": (roles(lambda _, primvar: primvar.Set(Vt.TokenArray(["knob"] * 3))), INVALID, MESH),
    "roles of points": (roles(lambda _, primvar: primvar.SetInterpolation("vertex")), INVALID, MESH),
    "points in time": (lambda each: in_time(each.attribute("points", MESH)), INVALID, MESH),
    "a track in time": (lambda each: in_time(each.attribute(TRACK_POINTS)), INVALID, SMILE),
    "indices of points": (lambda each: each.set("elementType", "point"), INVALID, MESH),
    "no Skeleton": (relation("skel:skeleton", prim=MESH), INVALID, MESH),
    "a purpose of render": (lambda each: each.set("purpose", "render", SCOPE), INVALID, SCOPE),
    "a purpose of render on the mesh": (
        lambda each: UsdGeom.Imageable(each.prim(MESH)).CreatePurposeAttr("render"),
        INVALID,
        MESH,
    ),
    "smooth handles": (mesh("subdivisionScheme", "catmullClark"), INVALID, MESH),
    "holes": (lambda each: UsdGeom.Mesh(each.prim(MESH)).CreateHoleIndicesAttr([0]), INVALID, MESH),
    "faces inside out": (lambda each: UsdGeom.Mesh(each.prim(MESH)).CreateOrientationAttr("leftHanded"), INVALID, MESH),
    "another extent": (mesh("extent", lambda old: 0.5 * np.array(old)), INVALID, MESH),
    "another family of subsets": (lambda each: each.set("familyName", "materialBind"), INVALID, SMILE),
    # Elements.
    "the anchor's place moved": (element("anchor:position", GONE), DRAWN, SMILE),
    "another point": (element("anchor:pointIndex", lambda old: old + 40), TRACK, SMILE),
    "another number of points": (element("anchor:pointCount", 99999), INVALID, SMILE),
    "another topology": (element("anchor:topologyHash", "0123"), "LAYOUT_TOPOLOGY", SMILE),
    "a mesh that is not there": (relation("rigUI:anchor:prim", "/Char/Nose"), "LAYOUT_MESH_GONE", "/Char/Nose"),
    "a heading on the face": (element("element:category", "viseme"), INVALID, SMILE),
    "a carrier on the face": (relation("rigUI:anchor:carrier", "/Char/Geometry/Head"), INVALID, SMILE),
    "a point without its index": (element("anchor:pointIndex", -1), INVALID, SMILE),
    "another lift": (element("handle:lift", 3.0), DRAWN, SMILE),
    "the wrong side": (element("element:side", "right"), INVALID, SMILE),
    "no side": (element("element:side", "none"), INVALID, SMILE),
    "no mirror": (
        both(relation("rigUI:element:mirror"), relation("rigUI:element:mirror", prim=OTHER)),
        INVALID,
        SMILE,
    ),
    "a mirror that is not mutual": (relation("rigUI:element:mirror"), INVALID, OTHER),
    "another mirror": (relation("rigUI:element:mirror", f"{MESH}/jawOpen"), INVALID, SMILE),
    "a mirror that is none": (relation("rigUI:element:mirror", "/Char/Skeleton"), INVALID, SMILE),
    "mirrored the other way": (control("mirrorReversed", True), INVALID, SMILE),
    "not mirrored the other way": (control("mirrorReversed", False, EYE, "EyeLeft_ry"), INVALID, EYE),
    "a slider with two axes": (element("element:elementType", "slider", EYE), INVALID, EYE),
    "a joystick with one axis": (element("element:elementType", "patch"), INVALID, SMILE),
    "two ends that are not opposed": (control("opposes", "", WIDE, "eyeWideLeft"), INVALID, WIDE),
    "an end opposed to itself": (control("opposes", SMILE), INVALID, SMILE),
    "an end opposed to none": (control("opposes", "jawOpen"), INVALID, SMILE),
    "a name twice": (element("element:name", OTHER), INVALID, SCOPE),
    "a control that is not applied": (element("element:controls", Vt.TokenArray(["grin"])), INVALID, SMILE),
    "its own member": (relation("rigUI:element:members", f"{MESH}/{SMILE}"), INVALID, SCOPE),
    # Controls.
    "another's shape": (
        both(control("blendShapes", Vt.TokenArray(["browInnerUp"])), control("source", "browInnerUp")),
        TRACK,
        SMILE,
    ),
    "a shape of no mesh": (control("blendShapes", Vt.TokenArray(["grin"])), INVALID, SMILE),
    "names exchanged": (both(control("name", OTHER), control("name", SMILE, OTHER, OTHER)), INVALID, SMILE),
    "no shape": (control("blendShapes", Vt.TokenArray()), INVALID, SMILE),
    "two shapes without keys": (control("blendShapes", Vt.TokenArray([SMILE, "jawOpen"])), INVALID, SMILE),
    "another joint": (control("joints", Vt.TokenArray(["Neck/Head/Jaw"]), EYE, "EyeLeft_ry"), TRACK, EYE),
    "a joint of no Skeleton": (control("joints", Vt.TokenArray(["Tail"]), EYE, "EyeLeft_ry"), INVALID, EYE),
    "joints without a Skeleton": (relation("rigUI:control:EyeLeft_ry:skeleton", prim=EYE), INVALID, EYE),
    "radians for degrees": (
        control("jointRotationVectors", lambda old: np.radians(np.array(old)), EYE, "EyeLeft_ry"),
        INVALID,
        EYE,
    ),
    "a turn the other way": (
        control("jointRotationVectors", lambda old: -np.array(old), EYE, "EyeLeft_ry"),
        TRACK,
        EYE,
    ),
    "weights for degrees": (control("unit", "weight", EYE, "EyeLeft_ry"), INVALID, EYE),
    "degrees for weights": (control("unit", "degrees"), INVALID, SMILE),
    "twice the range": (control("maximum", 2.0), TRACK, SMILE),
    "a track the other way": (control("trackPoints", reverse), TRACK, SMILE),
    "a track elsewhere": (control("trackPoints", lambda old: np.array(old) + 2.0), DRAWN, SMILE),
    "a track twice as long": (control("arcLength", lambda old: 2.0 * old), INVALID, SMILE),
    "another magnification": (control("magnification", 3.0), INVALID, SMILE),
    "a control in two ways": (control("maximum", 0.5, PUFF, PUFF), INVALID, f"{PUFF}_mirror"),
    # The layout.
    "narrow handles": (layout("handleWidth", lambda old: 0.1 * old), DRAWN, SMILE),
    "the plane the other way": (layout("planeNormal", lambda old: -old), INVALID, SMILE),
    "the plane elsewhere": (layout("planeOrigin", Gf.Vec3f(5, 0, 0)), INVALID, SMILE),
    "the view from behind": (layout("viewDirection", lambda old: -old), INVALID, SQUASH),
    "no Skeleton of the layout": (relation("rigUI:layout:skeleton", prim=SCOPE), INVALID, SCOPE),
    "a mesh among the Skeletons": (
        lambda each: each.prim(SCOPE).GetRelationship("rigUI:layout:skeleton").AddTarget("/Char/Geometry/Head"),
        INVALID,
        SCOPE,
    ),
    "a character that is none": (lambda each: each.prim("/Char").SetTypeName("Xform"), INVALID, SCOPE),
    "a list without a control": (
        layout("baseControls", lambda old: Vt.TokenArray([each if each != SMILE else "grin" for each in old])),
        INVALID,
        SCOPE,
    ),
    "a control listed twice": (layout("baseControls", twice), INVALID, SCOPE),
    "a base pose outside": (
        layout("baseValues", Vt.DoubleArray([9.0] * 53)),
        DRAWN,
        EYE,
    ),
    "a list of what is no element": (relation("rigUI:layout:elements", "/Char/Skeleton", prim=SCOPE), INVALID, SCOPE),
    "a Skeleton of nobody": (relation("rigUI:control:EyeLeft_ry:skeleton", "/Skeleton", prim=EYE), INVALID, EYE),
    "a second layout": (second, INVALID, SCOPE),
    "a Skeleton that is none": (relation("rigUI:layout:skeleton", "/Char/Geometry/Head", prim=SCOPE), INVALID, SCOPE),
}


def in_time(attribute):
    attribute.Set(attribute.Get(), 1.0)


def test_the_layout_of_the_sample_has_no_fault(stage):
    assert layout_faults(stage) == ()


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_found_by_a_code_that_names_its_prim(stage, name):
    edit, code, where = FAULTS[name]
    edit(Layout(stage))
    path = where if where.startswith("/") else f"{MESH}/{where}"
    found = layout_faults(stage)
    named = [each for each in found if each.code == code and (each.path.startswith(path) or each.path == where)]
    assert named, found[:4]
    assert all(each.repair for each in named)


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
def test_a_value_that_breaks_a_rule_of_the_schema_is_refused(stage, api, declared, value):
    where = {schema.LAYOUT: SCOPE, schema.CORRECTION: f"/Char/{schema.CORRECTIONS}/smile"}.get(api, f"{MESH}/{EYE}")
    if api == schema.CORRECTION:
        stage.DefinePrim(where, "Scope").AddAppliedSchema(schema.CORRECTION)
    if api == schema.PART:
        where = SCOPE
        stage.GetPrimAtPath(where).AddAppliedSchema(f"{schema.PART}:EyeLeft_ry")
        Layout(stage).set("rigUI:part:EyeLeft_ry:handleWidth", 0.1, where)
    name = declared.name.replace("__INSTANCE_NAME__", "EyeLeft_ry")
    if declared.type_name:
        Layout(stage).set(name, value, where)
    else:
        Layout(stage).target(name, MESH, SCOPE, prim=where)
    (found,) = layout_faults(stage)
    assert (found.code, found.path.partition(".")[0]) == (INVALID, where)
    named = found.path.partition(".")[2].replace("EyeLeft_ry", "__INSTANCE_NAME__")
    told = " ".join(DECLARED[named].rules.values())
    assert named == declared.name or declared.name.rpartition(":")[2] in told, found
