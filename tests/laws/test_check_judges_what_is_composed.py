"""`check` judges the stage it is given: variants, activation, overrides, animation, references, instances and packages.

The table says which issues each stage deserves; the law says that a stage and its flattened copy get the same one.
"""

import os
import random
import re
from pathlib import Path

import pytest
import skinned_stages
from pxr import Gf, Sdf, Usd, UsdGeom, UsdSkel, UsdUtils

import usdrigui
from usdrigui.cli import main
from usdrigui.errors import RigUIError
from usdrigui.layer.read_layout import read_layout
from usdrigui.pipeline import check, load_layer
from usdrigui.settings import Settings

CHAR, FACE = "World/Char", "World/Char/face0"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    character = skinned_stages.character(tmp_path_factory.mktemp("once") / "char.usda", meshes=2)
    assert main(["process", str(character), "--quiet"]) == 0
    return character.parent


def over(folder, layer="./char.rigui.usda", name="stage.usda"):
    """A stage over the layout."""
    stage = Usd.Stage.CreateNew(str(folder / name))
    stage.GetRootLayer().subLayerPaths.append(layer)
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    return stage


def shot(folder, *names, payload=False, instanceable=False):
    """A stage that brings in the laid out character once for every name, each elsewhere."""
    stage = Usd.Stage.CreateNew(str(folder / "stage.usda"))
    UsdGeom.SetStageMetersPerUnit(stage, 0.01)
    for number, name in enumerate(names):
        place = UsdGeom.Xform.Define(stage, f"/Shot/{name}")
        place.AddTranslateOp().Set((5.0 * number, 1.0, 0.0))
        prim = place.GetPrim()
        (prim.GetPayloads().AddPayload if payload else prim.GetReferences().AddReference)("./char.rigui.usda")
        prim.SetInstanceable(instanceable)
    return stage


def element(stage, name, above="/World"):
    return stage.GetPrimAtPath(f"{above}/Char/RigUI/FaceControls/{name}")


# --- edits, each of a stage in which a character stands below `above` ----------------------------------


def hide(stage, above="/World"):
    UsdGeom.Imageable(stage.GetPrimAtPath(f"{above}/Char/face0")).MakeInvisible()


def deactivate(stage, above="/World"):
    stage.GetPrimAtPath(f"{above}/Char/face0").SetActive(False)


def animate(stage, above="/World"):
    weights = UsdSkel.Animation(stage.GetPrimAtPath(f"{above}/Char/Anim")).GetBlendShapeWeightsAttr()
    for time in (1.0, 12.0, 24.0):
        weights.Set([0.5 * (time > 1.0)] * len(weights.Get()), time)


def displace(stage, above="/World"):
    points = UsdGeom.Mesh(stage.GetPrimAtPath(f"{above}/Char/face0")).GetPointsAttr()
    points.Set([Gf.Vec3f(x, y + 0.3 * x * x, z) for x, y, z in points.Get()])


def turn_a_face(stage, above="/World"):
    faces = UsdGeom.Mesh(stage.GetPrimAtPath(f"{above}/Char/face0")).GetFaceVertexIndicesAttr()
    indices = list(faces.Get())
    faces.Set([*indices[1:4], indices[0], *indices[4:]])


def regrab(stage, above="/World"):
    """A stronger opinion about the anchor, and none about where that is."""
    prim = element(stage, "pucker", above)
    index = prim.GetAttribute("rigUI:anchor:pointIndex")
    index.Set(index.Get() + 1)


def collide(stage, above="/World"):
    prim, other = (element(stage, name, above) for name in ("smile_L", "brow_L"))
    prim.GetAttribute("rigUI:anchor:position").Set(other.GetAttribute("rigUI:anchor:position").Get())


def take_shape(stage, above="/World"):
    """The meshes lose a shape that an element drives."""
    for mesh in (stage.GetPrimAtPath(f"{above}/Char/face{number}") for number in (0, 1)):
        tokens = UsdSkel.BindingAPI(mesh).GetBlendShapesAttr()
        if tokens.Get() and "sneer_L" in tokens.Get():
            tokens.Set(["gone" if token == "sneer_L" else token for token in tokens.Get()])


def deactivate_element(stage, above="/World"):
    element(stage, "pucker", above).SetActive(False)


def deactivate_twin(stage, above="/World"):
    element(stage, "smile_L", above).SetActive(False)


def swap_clip(stage, above="/World"):
    """Another clip, which has one of the shapes."""
    clip = UsdSkel.Animation.Define(stage, f"{above}/OtherAnim")
    clip.CreateBlendShapesAttr(["pucker"])
    clip.CreateBlendShapeWeightsAttr([0.5])
    skeleton = UsdSkel.BindingAPI(stage.GetPrimAtPath(f"{above}/Char/Skel"))
    skeleton.GetAnimationSourceRel().SetTargets([clip.GetPath()])


def drop_clip(stage, above="/World"):
    UsdSkel.BindingAPI(stage.GetPrimAtPath(f"{above}/Char/Skel")).GetAnimationSourceRel().SetTargets([])


def deactivate_all(stage, above="/World"):
    for mesh in ("face0", "face1"):
        stage.GetPrimAtPath(f"{above}/Char/{mesh}").SetActive(False)


def drop_layout(stage, above="/World"):
    """What is left is an asset, and that is sound."""
    stage.GetPrimAtPath(f"{above}/Char/RigUI").SetActive(False)


def drop_character(stage, above="/World"):
    stage.GetPrimAtPath(f"{above}/Char").SetActive(False)


def nothing(stage, above="/World"):
    pass


EDITS = {
    nothing: set(),
    animate: set(),
    hide: {"LAYOUT_ANCHOR_HIDDEN"},
    deactivate: {"LAYOUT_MESH_GONE"},
    deactivate_all: {"LAYOUT_MESH_GONE"},
    displace: {"LAYOUT_ANCHOR_MOVED", "LAYOUT_RESHAPED"},
    turn_a_face: {"LAYOUT_TOPOLOGY"},
    regrab: {"LAYOUT_ANCHOR_MOVED", "LAYOUT_TRACK", "LAYOUT_DRAWN"},
    # Its track and what is drawn stay.
    collide: {"LAYOUT_HANDLES_COLLIDE", "LAYOUT_ANCHOR_MOVED", "LAYOUT_TRACK", "LAYOUT_DRAWN"},
    take_shape: {"LAYOUT_CONTROL_GONE", "LAYOUT_CONTROL_NEW"},
    deactivate_element: {"LAYOUT_CONTROL_NEW"},
    deactivate_twin: {"LAYOUT_CONTROL_NEW"},
    swap_clip: {"LAYOUT_NOT_ANIMATED"},
    drop_clip: {"LAYOUT_NOT_ANIMATED"},
    drop_layout: set(),  # of the only one, LAYOUT_NONE of one of two
    drop_character: {"SKELROOT_MISSING"},
}


# --- stages --------------------------------------------------------------------------------------------


def _variant(folder, selected):
    """The layout under an asset that has a level of detail without the face."""
    stage = over(folder)
    details = stage.GetPrimAtPath("/World").GetVariantSets().AddVariantSet("LOD")
    for name in ("high", "low"):
        details.AddVariant(name)
        details.SetVariantSelection(name)
        with details.GetVariantEditContext():
            if name == "low":
                deactivate(stage)
    details.SetVariantSelection(selected)
    return stage


def _below(folder):
    """Animation in the asset itself."""
    stage = Usd.Stage.Open(str(folder / "char.usda"))
    animate(stage)
    stage.Save()
    return over(folder)


def _one_of_two(folder):
    stage = shot(folder, "A", "B")
    deactivate(stage, "/Shot/B")
    return stage


def _one_without_meshes(folder):
    stage = shot(folder, "A", "B")
    deactivate_all(stage, "/Shot/B")
    return stage


def _one_bare(folder):
    """The second character as its maker left it."""
    stage = shot(folder, "A")
    stage.DefinePrim("/Shot/B").GetReferences().AddReference("./char.usda")
    return stage


def _beside_a_prop(folder):
    """A SkelRoot that nothing moves is no character."""
    stage = shot(folder, "A")
    UsdSkel.Root.Define(stage, "/Shot/Chair")
    UsdGeom.Mesh.Define(stage, "/Shot/Chair/seat")
    return stage


def _attached(folder):
    assert main(["process", str(folder / "char.usda"), "--bare", "-o", str(folder / "bare.rigui.usda"), "--quiet"]) == 0
    stage = over(folder, "./char.usda")
    stage.GetRootLayer().subLayerPaths.insert(0, "./bare.rigui.usda")
    return stage


def _packed(folder):
    UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(folder / "char.rigui.usda")), str(folder / "stage.usdz"))
    return Usd.Stage.Open(str(folder / "stage.usdz"))


def _class(folder):
    """A class of the character is no character."""
    stage = shot(folder, "A")
    stage.CreateClassPrim("/_kind").GetReferences().AddReference("./char.rigui.usda")
    stage.GetPrimAtPath("/Shot/A").GetInherits().AddInherit("/_kind")
    return stage


STAGES = {
    "variant with the face": (lambda folder: _variant(folder, "high"), set()),
    "variant without the face": (lambda folder: _variant(folder, "low"), EDITS[deactivate]),
    "animation below": (_below, set()),
    "one reference": (lambda folder: shot(folder, "A"), set()),
    "two references": (lambda folder: shot(folder, "A", "B"), set()),
    "two references, one without its face": (_one_of_two, EDITS[deactivate]),
    "two references, one without any mesh": (_one_without_meshes, EDITS[deactivate]),
    "two references, one of a character without a layout": (_one_bare, {"LAYOUT_NONE"}),
    "one reference, beside a prop": (_beside_a_prop, set()),
    "a payload": (lambda folder: shot(folder, "A", payload=True), set()),
    "two instances": (lambda folder: shot(folder, "A", "B", instanceable=True), set()),
    "the layout as a sublayer of the asset": (_attached, set()),
    "a package": (_packed, set()),
    "a class": (_class, set()),
    **{
        f"{edit.__name__} above": ((lambda folder, edit=edit: edited(over(folder), edit)), expected)
        for edit, expected in EDITS.items()
    },
}


FORGOTTEN = re.compile("; not active: .*")
"""Flattening leaves out what is not active."""


def edited(stage, edit, above="/World"):
    edit(stage, above)
    return stage


def judged(path):
    """Code, path and message of every error and warning, and the cost of every character."""
    try:
        found = check(path, Settings())
    except RigUIError as error:
        return {(error.issue.code, error.issue.severity)}, ()
    told = ((each, FORGOTTEN.sub("", each.message.replace(str(path), ""))) for each in found.issues)
    issues = {(each.code, each.severity, each.where.replace(str(path), ""), message) for each, message in told}
    return issues, tuple((root, review.cost, review.elements) for root, review in found.characters)


def flattened(stage, folder):
    target = folder / "flat.usdc"
    stage.Flatten().Export(str(target))
    return target


def saved(stage):
    if not stage.GetRootLayer().realPath.endswith(".usdz"):
        stage.Save()
    return Path(stage.GetRootLayer().realPath)


@pytest.mark.parametrize("name", STAGES)
def test_a_stage_gets_the_issues_that_it_deserves_and_so_does_its_flattened_copy(name, folder):
    make, expected = STAGES[name]
    stage = make(folder)
    path = saved(stage)
    issues, costs = judged(path)
    assert {code for code, severity, *_ in issues if severity != "info"} == expected
    assert judged(flattened(stage, folder)) == (issues, costs)


@pytest.mark.parametrize("seed", range(4))
def test_any_shot_and_its_flattened_copy_are_judged_alike(seed, folder):
    """Edits by chance of the characters of one shot; their layouts and faces need not be left."""
    chance = random.Random(seed)
    stage = shot(folder, "A", "B", payload=chance.random() < 0.5)
    for above in ("/Shot/A", "/Shot/B"):
        for edit in chance.sample(list(EDITS)[:-1], 2):
            edit(stage, above)
    assert judged(saved(stage)) == judged(flattened(stage, folder))


def test_what_is_on_the_board_alone_fits_its_rig(tmp_path):
    """There pairs are on one side of the plane, and the track of a joint that turns far round is straight."""
    jaw = {"axes": ["x"], "minimum": -20.0, "maximum": 340.0}
    asset, rig = skinned_stages.read(tmp_path)
    layer, names = tmp_path / "char.rigui.usda", (*rig.control_names, "Jaw:rx")
    said = {"joints": {"Hips/Head/Jaw": jaw}, "controls": {name: {"place": "board"} for name in names}}
    settings = usdrigui.load_settings(said)
    usdrigui.process(asset, settings, output=layer)
    assert [each for each in usdrigui.check(layer, settings).issues if each.severity == "error"] == []


def judged_open(stage):
    """The same of an open stage, by character: edits of it may leave USD's order of prims behind."""
    try:
        found = usdrigui.check(stage)
    except RigUIError as error:
        return {error.issue.code}, {}
    issues = {(each.code, each.severity, each.where, FORGOTTEN.sub("", each.message)) for each in found.issues}
    return issues, {root: (review.cost, review.elements) for root, review in found.characters}


def open_shot(folder, chance):
    """An open stage of one or two characters with unsaved edits in all its layers, some of them muted, in variants that
    are fallbacks, and with a part of it loaded and populated."""
    names = ["A", "B"][: chance.randint(1, 2)]
    made = shot(folder, *names, payload=chance.random() < 0.5)
    root = made.GetRootLayer()
    below = Sdf.Layer.CreateNew(str(folder / "below.usda"))
    root.subLayerPaths.append("./below.usda")
    session = Sdf.Layer.CreateAnonymous()
    underneath = Sdf.Layer.CreateAnonymous()
    session.subLayerPaths.append(underneath.identifier)
    levels = made.GetPrimAtPath("/Shot/A").GetVariantSets().AddVariantSet("LOD")
    levels.AddVariant("high")
    levels.AddVariant("low")
    Sdf.CreatePrimInLayer(root, "/Shot/A{LOD=low}Char/face0").SetInfo("active", False)
    Usd.Stage.SetGlobalVariantFallbacks({"LOD": [chance.choice(["high", "low"])]})
    try:
        stage = Usd.Stage.Open(root, session)
    finally:
        Usd.Stage.SetGlobalVariantFallbacks({})
    for layer in (root, below, session, underneath):
        above = f"/Shot/{chance.choice(names)}"
        with Usd.EditContext(stage, layer):
            if element(stage, "pucker", above):
                chance.choice([*EDITS][:-2])(stage, above)
    if chance.random() < 0.5:
        stage.MuteLayer(chance.choice([below, session, underneath]).identifier)
    if chance.random() < 0.3:
        stage.Unload(f"/Shot/{names[-1]}")
    if chance.random() < 0.3:
        stage.SetPopulationMask(Usd.StagePopulationMask([f"/Shot/{chance.choice(names)}"]))
    return stage, underneath  # which the stage lets go of when it is muted


@pytest.mark.parametrize("seed", range(int(os.environ.get("USDRIGUI_STAGES", "8"))))
def test_an_open_stage_and_its_flattened_copy_are_judged_alike(seed, folder):
    stage, _held = open_shot(folder, random.Random(seed))
    before = {layer: layer.ExportToString() for layer in stage.GetUsedLayers()}
    found = judged_open(stage)
    assert {layer: layer.ExportToString() for layer in stage.GetUsedLayers()} == before
    assert found == judged_open(Usd.Stage.Open(stage.Flatten()))


def test_a_stage_whose_layout_is_muted_is_laid_out_again(folder):
    """As docs/hosts.md has it; what else is muted need not be there, nor be USD."""
    (folder / "broken.usda").write_text('#usda 1.0\ndef "A" {')
    stage = over(folder, "./char.usda")
    for name in ("char.rigui.usda", "gone.usda", "broken.usda"):
        stage.GetRootLayer().subLayerPaths.insert(0, f"./{name}")
        stage.MuteLayer(str(folder / name))
    assert usdrigui.process(stage, usdrigui.load_settings({"solve": {"gap": 0.05}})).outcome == "in memory"


def test_every_finding_says_whose_it_is(folder, capsys):
    """Two characters with one fault each, of elements and controls of the same name."""
    stage = shot(folder, "A", "B")
    for above in ("/Shot/A", "/Shot/B"):
        collide(stage, above)
        take_shape(stage, above)
    path = saved(stage)
    roots = ["/Shot/A/Char", "/Shot/B/Char"]
    found = check(path, Settings()).issues
    assert [each.character for each in found] == sorted(each.character for each in found)
    told = [[(each.code, each.path.removeprefix(root)) for each in found if each.character == root] for root in roots]
    assert told[0]
    assert told[0] == told[1]
    main(["check", str(path)])
    said = " ".join(capsys.readouterr().out.split())
    assert all(f"LAYOUT_CONTROL_GONE {root} sneer_L: " in said for root in roots)


def test_a_character_without_meshes_is_reported_with_what_is_not_active(folder, capsys):
    stage = over(folder)
    deactivate_all(stage)
    for path, codes in ((saved(stage), ["LAYOUT_MESH_GONE"]), (_asset_without_meshes(folder), ["CONTROLS_MISSING"])):
        errors = [each for each in check(path, Settings()).issues if each.severity == "error"]
        assert [each.code for each in errors] == codes
        assert re.search("not active: /.*/face0 and /.*/face1", errors[0].message)
    assert main(["check", str(saved(stage))]) == 1
    assert "does not fit its rig" in capsys.readouterr().out


def _asset_without_meshes(folder):
    stage = over(folder, "./char.usda", name="without.usda")
    deactivate_all(stage)
    return saved(stage)


def test_a_layout_that_one_character_of_two_has_switched_off_is_no_layout_that_is_missing(folder):
    stage = shot(folder, "A", "B")
    stage.GetPrimAtPath("/Shot/B/Char").GetVariantSet("rigUI").SetVariantSelection("none")
    (found,) = (each for each in check(saved(stage), Settings()).issues if each.character == "/Shot/B/Char")
    assert (found.code, found.severity) == ("LAYOUT_OFF", "info")
    assert "rigUI = none on /Shot/B/Char" in found.message


def test_a_mesh_that_is_gone_is_reported_once_with_all_that_it_takes_along(folder):
    found = check(saved(edited(over(folder), deactivate)), Settings()).issues
    (told,) = (each for each in found if each.severity == "error")
    elements = read_layout(folder / "char.rigui.usda")[0].elements
    lost = sum(each.anchor.mesh == f"/{FACE}" for each in elements)
    assert told.path == f"/{FACE}"
    assert f"{lost} elements of the layout" in told.message
    assert re.search(r"; [1-9][0-9]* controls", told.message)
    assert "activate the mesh" in told.repair


def test_viewers_show_every_character_of_a_shot_as_it_is_there(folder):
    stage = shot(folder, "A", "B")
    animate(stage, "/Shot/B")
    stage.Save()
    loaded = load_layer(folder / "stage.usda", Settings())
    assert [rig.path for rig, _ in loaded.characters] == ["/Shot/A/Char", "/Shot/B/Char"]
    assert [len(rig.clip.times) > 1 for rig, _ in loaded.characters] == [True, True]
    first, second = (rig.clip.weights for rig, _ in loaded.characters)
    assert first.max() != second.max()
    for command in ("picture -o shot.png", "view --html shot.html", "picker --svg shot.svg"):
        name, option, output = command.split()
        assert main([name, str(folder / "stage.usda"), option, str(folder / output)]) == 0
