"""Every asset that cannot be read is refused with its code and prim path, and USD prints nothing."""

import numpy as np
import pytest
from pxr import Gf, Sdf, Tf, Usd, UsdGeom, UsdSkel, Vt
from skel_stages import SIDE, add_even_skin, add_mesh, add_shape, add_skeleton, character, head, matrix, new_stage

from usdrigui.errors import Exit, RigUIError
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings, load


def refused(path, config=None):
    with pytest.raises(RigUIError) as caught:
        read_rigs(path, load(config or {}))
    return caught.value


def spoilt(tmp_path, edit, tokens=("smile", "frown")):
    return refused(head(tmp_path / "spoilt.usda", tokens, edit))


# --- files -------------------------------------------------------------------------------------------


def test_a_name_that_no_layer_can_refer_to(tmp_path):
    path = tmp_path / "char:SDF_FORMAT_ARGS:a=b.usda"
    path.write_bytes(head(tmp_path / "char.usda").read_bytes())
    assert refused(path).issue.code == "FILE_NAME"


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("empty.usda", b""),
        ("prose.usda", b"once upon a time"),
        ("broken.usda", b'#usda 1.0\ndef SkelRoot "A" {'),
        ("bytes.usda", b"#usda 1.0\n\xff\xfe\x00 {"),
        ("crate.usdc", b"PXR-USDC" + bytes(200)),
        ("short.usdc", b"PXR-USDC"),
        ("any.usd", b"\x00\x01\x02"),
        ("head.fbx", b"Kaydara FBX Binary"),
        ("noextension", b"#usda 1.0\n"),
    ],
)
def test_not_usd(tmp_path, capfd, name, content):
    path = tmp_path / name
    path.write_bytes(content)
    error = refused(path)
    assert error.issue.code == "FILE_NOT_USD"
    assert error.issue.path == str(path)
    assert error.exit_code == Exit.REFUSED
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("arc", ["subLayers", "reference", "payload"])
def test_missing_layer(tmp_path, capfd, arc):
    def edit(stage):
        if arc == "subLayers":
            stage.GetRootLayer().subLayerPaths.append("./gone.usda")
        elif arc == "reference":
            stage.GetPrimAtPath("/Char/Face").GetReferences().AddReference("./gone.usda", "/X")
        else:
            stage.DefinePrim("/Char/Hat", "Xform").GetPayloads().AddPayload("./gone.usda", "/X")

    with _silent():
        path = head(tmp_path / "char.usda", edit=edit)
    capfd.readouterr()
    error = refused(path)
    assert error.issue.code == "LAYER_MISSING"
    assert "gone.usda" in error.issue.message
    (tmp_path / "gone.usda").write_text('#usda 1.0\ndef Xform "X" {')
    there = refused(path)
    assert there.issue.code == "LAYER_UNREADABLE"
    assert "Expected }" in there.issue.message
    assert capfd.readouterr() == ("", "")


def test_a_layer_missing_elsewhere_is_a_warning(tmp_path):
    def edit(stage):
        stage.DefinePrim("/Room", "Xform").GetReferences().AddReference("./gone.usda", "/X")

    with _silent():
        path = head(tmp_path / "char.usda", edit=edit)
    (rig,) = read_rigs(path, Settings())
    assert [(each.code, each.path) for each in rig.issues if each.severity == "warning"] == [
        ("COMPOSITION_ERROR", "/Room")
    ]


def test_a_missing_layer_may_be_why_there_is_no_skelroot(tmp_path):
    stage = Usd.Stage.CreateNew(str(tmp_path / "shot.usda"))
    with _silent():
        stage.DefinePrim("/World", "Xform").GetReferences().AddReference("./gone.usda", "/X")
    stage.GetRootLayer().Save()
    assert refused(tmp_path / "shot.usda").issue.code == "LAYER_MISSING"


class _silent:  # noqa: N801 - reads as a statement
    """Keep what USD says while a broken stage is made."""

    def __enter__(self):
        from pxr import UsdUtils

        self._delegate = UsdUtils.CoalescingDiagnosticDelegate()

    def __exit__(self, *exc):
        self._delegate.TakeUncoalescedDiagnostics()
        del self._delegate


# --- the stage ---------------------------------------------------------------------------------------


def test_blend_shapes_without_a_skeleton_are_counted(tmp_path):
    error = spoilt(tmp_path, lambda stage: stage.RemovePrim("/Char/Skel"))
    assert error.issue.code == "CONTROLS_MISSING"
    assert "smile and frown (" in error.issue.message
    assert "bind a Skeleton" in error.issue.repair


@pytest.mark.parametrize("where", ["itself", "above"])
def test_instance(tmp_path, where):
    """Nothing can be written below an instance."""
    head(tmp_path / "char.usda")
    stage = Usd.Stage.CreateNew(str(tmp_path / "shot.usda"))
    if where == "above":
        inner = Usd.Stage.CreateNew(str(tmp_path / "wrap.usda"))
        inner.DefinePrim("/Wrap", "Xform")
        inner.DefinePrim("/Wrap/Hero").GetReferences().AddReference("./char.usda", "/Char")
        inner.GetRootLayer().Save()
    prim = stage.DefinePrim("/Hero")
    prim.GetReferences().AddReference(*(("./char.usda", "/Char") if where == "itself" else ("./wrap.usda", "/Wrap")))
    prim.SetInstanceable(True)
    stage.GetRootLayer().Save()
    error = refused(tmp_path / "shot.usda")
    assert (error.issue.code, error.issue.path) == ("INSTANCE", "/Hero")


@pytest.mark.parametrize(("kind", "path"), [("mesh", ""), ("Skeleton", "/Char/Copy/Bones")])
def test_what_moves_the_character_may_be_no_instance(tmp_path, kind, path):
    """A mesh may: nothing has to be said of it."""

    def edit(stage):
        prim = stage.DefinePrim("/Char/Copy")
        prim.GetReferences().AddInternalReference("/Geo")
        prim.SetInstanceable(True)
        stage.DefinePrim("/Geo", "Xform")
        mesh = add_mesh(stage, "/Geo/Nose", seed=8)
        add_shape(mesh, "smile")
        bones = UsdSkel.Skeleton.Define(stage, "/Geo/Bones") if path else None
        if bones:
            bones.CreateJointsAttr(["bone"])
            bones.CreateBindTransformsAttr([Gf.Matrix4d(1)])
            bones.CreateRestTransformsAttr([Gf.Matrix4d(1)])
        UsdSkel.BindingAPI.Apply(prim).CreateSkeletonRel().SetTargets([path or "/Char/Skel"])

    if kind == "mesh":
        head(tmp_path / "char.usda")
        stage = Usd.Stage.Open(str(tmp_path / "char.usda"))
        edit(stage)
        stage.Save()
        assert "/Char/Copy/Nose" in {mesh.path for mesh in read_rigs(tmp_path / "char.usda", load())[0].body.meshes}
    else:
        error = spoilt(tmp_path, edit)
        assert (error.issue.code, error.issue.path) == ("INSTANCE", path)


# --- bindings that UsdSkel passes over -----------------------------------------------------------------


def _joints_for_shapes(stage):
    """Give the face joint influences instead of its shapes."""
    add_even_skin(_face(stage), 1)
    for name in ("skel:blendShapes", "skel:blendShapeTargets"):
        stage.GetPrimAtPath("/Char/Face").RemoveProperty(name)


def _not_applied(stage):
    stage.GetPrimAtPath("/Char/Face").RemoveAPI(UsdSkel.BindingAPI)


def _not_applied_above(stage):
    stage.GetPrimAtPath("/Char/Face").RemoveProperty("skel:skeleton")
    stage.GetPrimAtPath("/Char").CreateRelationship("skel:skeleton").SetTargets(["/Char/Skel"])


def _below(kind):
    def edit(stage):
        stage.DefinePrim("/Char/Geo", kind)
        editor = Usd.NamespaceEditor(stage)
        assert editor.MovePrimAtPath("/Char/Face", "/Char/Geo/Face")
        assert editor.ApplyEdits()

    return edit


def _astray(stage):
    _binding(stage).GetSkeletonRel().SetTargets(["/Char/Gone"])


def _nowhere(stage):
    _binding(stage).GetSkeletonRel().SetTargets([])


CAUSES = [
    (_not_applied, "skel:skeleton is authored on /Char/Face, but SkelBindingAPI is not applied there: apply it"),
    (_not_applied_above, "skel:skeleton is authored on /Char, but SkelBindingAPI is not applied there: apply it"),
    (_below(""), "/Char/Geo has no type, so that UsdSkel ignores all prims below it: make it an Xform"),
    (_below("Material"), "/Char/Geo is a Material, which is not imageable, so that UsdSkel ignores all prims below it"),
    (_below("Mesh"), "/Char/Geo is a Mesh itself, so that UsdSkel ignores all prims below it: move the mesh out"),
    (_astray, "skel:skeleton of /Char/Face leads to /Char/Gone, which is not an active Skeleton: correct it"),
    (_nowhere, "skel:skeleton of /Char/Face has no target"),
]


@pytest.mark.parametrize(("edit", "cause"), CAUSES)
@pytest.mark.parametrize("joints_only", [False, True])
def test_a_binding_in_vain_is_refused_with_its_cause(tmp_path, edit, cause, joints_only):
    def edits(stage):
        if joints_only:
            _joints_for_shapes(stage)
        edit(stage)

    error = spoilt(tmp_path, edits)
    assert error.issue.code == "CONTROLS_MISSING"
    assert error.issue.message.count(cause) == 1
    assert "no Skeleton is bound" not in error.issue.message
    assert ("Face has joint influences; " in error.issue.message) == joints_only


def test_every_cause_of_a_binding_in_vain_is_reported(tmp_path):
    def edit(stage):
        _not_applied(stage)
        _below("")(stage)

    message = spoilt(tmp_path, edit).issue.message
    assert "SkelBindingAPI is not applied there: apply it; /Char/Geo has no type" in message


def test_a_mesh_that_nothing_is_bound_to_has_no_other_cause(tmp_path):
    message = spoilt(tmp_path, lambda stage: stage.GetPrimAtPath("/Char/Face").RemoveProperty("skel:skeleton"))
    assert "no Skeleton is bound to /Char/Face" in message.issue.message


# --- arrays ------------------------------------------------------------------------------------------


def _face(stage):
    return UsdGeom.Mesh(stage.GetPrimAtPath("/Char/Face"))


def _smile(stage):
    return UsdSkel.BlendShape(stage.GetPrimAtPath("/Char/Face/s_smile"))


def _more_names(stage):
    UsdSkel.BindingAPI(_face(stage)).GetBlendShapesAttr().Set(["smile", "frown", "more"])


def _no_names(stage):
    UsdSkel.BindingAPI(_face(stage)).GetBlendShapesAttr().Block()


def _index_too_large(stage):
    _smile(stage).CreateOffsetsAttr().Set(Vt.Vec3fArray(2))
    _smile(stage).CreatePointIndicesAttr().Set([0, SIDE**2])


def _offsets_short(stage):
    _smile(stage).CreateOffsetsAttr().Set(Vt.Vec3fArray(3))


def _inbetween_short(stage):
    between = _smile(stage).CreateInbetween("half")
    between.SetWeight(0.5)
    between.SetOffsets(Vt.Vec3fArray(4))


def _offset_nan(stage):
    offsets = np.zeros((SIDE**2, 3), dtype=np.float32)
    offsets[6, 1] = np.nan
    _smile(stage).GetOffsetsAttr().Set(Vt.Vec3fArray.FromNumpy(offsets))


def _point_infinite(stage):
    points = np.zeros((SIDE**2, 3), dtype=np.float32)
    points[2, 0] = np.inf
    _face(stage).GetPointsAttr().Set(Vt.Vec3fArray.FromNumpy(points))


def _face_index(stage):
    _face(stage).GetFaceVertexIndicesAttr().Set([0, 1, 2, 999] + [0] * (4 * (SIDE - 1) ** 2 - 4))


def _face_counts(stage):
    _face(stage).GetFaceVertexCountsAttr().Set([4, 4])


@pytest.mark.parametrize(
    ("edit", "code"),
    [
        (_index_too_large, "INDEX_RANGE"),
        (_offsets_short, "OFFSETS_LENGTH"),
        (_inbetween_short, "OFFSETS_LENGTH"),
        (_offset_nan, "NOT_FINITE"),
    ],
)
def test_a_shape_that_contradicts_costs_its_control_alone(tmp_path, capfd, edit, code):
    (rig,) = read_rigs(head(tmp_path / "char.usda", edit=edit), Settings())
    assert [*rig.control_names] == ["frown"]
    (lost,) = rig.left_off
    assert lost.control == "smile"
    (warned,) = (each for each in rig.issues if each.severity == "warning")
    assert (warned.code, warned.path) == ("PART_LEFT_OFF", "/Char/Face/s_smile")
    assert warned.message.startswith(f"{code}: ")
    assert lost.reason.endswith(warned.message.removeprefix(f"{code}: "))
    alone = spoilt(tmp_path, edit, ("smile",))
    assert (alone.issue.code, alone.issue.path) == (code, "/Char/Face/s_smile"), "nothing is left"
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("edit", "code"),
    [
        (_more_names, "TARGETS_LENGTH"),
        (_no_names, "TARGETS_LENGTH"),
        (_point_infinite, "NOT_FINITE"),
        (_face_index, "INDEX_RANGE"),
        (_face_counts, "TOPOLOGY_INVALID"),
    ],
)
def test_a_mesh_that_contradicts_costs_what_it_alone_has(tmp_path, capfd, edit, code):
    def two(stage):
        add_shape(add_mesh(stage, "/Char/Hat", "/Char/Skel", seed=1), "lift")
        edit(stage)

    (rig,) = read_rigs(head(tmp_path / "char.usda", edit=two), Settings())
    assert [*rig.control_names] == ["lift"]
    assert {"smile", "frown"} <= {lost.control for lost in rig.left_off}
    (warned,) = (each for each in rig.issues if each.severity == "warning")
    assert (warned.code, warned.path, warned.message.partition(":")[0]) == ("PART_LEFT_OFF", "/Char/Face", code)
    alone = spoilt(tmp_path, edit)
    assert (alone.issue.code, alone.issue.path) == (code, "/Char/Face"), "nothing is left"
    assert capfd.readouterr() == ("", "")


# --- skeletons ---------------------------------------------------------------------------------------


def _boned(tmp_path, edit):
    """A mesh on two joints, then `edit(stage)`."""
    stage, _ = new_stage(tmp_path / "bones.usda")
    add_skeleton(stage, "/Char/Skel", ("a", "a/b"), (matrix(), matrix(translation=(0, 1, 0))))
    mesh = add_mesh(stage, "/Char/Face", "/Char/Skel")
    add_shape(mesh, "smile")
    add_even_skin(mesh, 2)
    edit(stage)
    stage.GetRootLayer().Save()
    return refused(tmp_path / "bones.usda")


def _skeleton(stage):
    return UsdSkel.Skeleton(stage.GetPrimAtPath("/Char/Skel"))


def _binding(stage):
    return UsdSkel.BindingAPI(stage.GetPrimAtPath("/Char/Face"))


@pytest.mark.parametrize(
    ("edit", "code", "path"),
    [
        (
            lambda stage: _skeleton(stage).GetBindTransformsAttr().Set([Gf.Matrix4d(1)]),
            "SKELETON_INVALID",
            "/Char/Skel",
        ),
        (
            lambda stage: _skeleton(stage).GetBindTransformsAttr().Set([Gf.Matrix4d(1), Gf.Matrix4d(0)]),
            "SKELETON_INVALID",
            "/Char/Skel",
        ),
        (lambda stage: _skeleton(stage).GetJointsAttr().Set(["a/b", "a"]), "SKELETON_INVALID", "/Char/Skel"),
        (
            lambda stage: _binding(stage).GetJointIndicesPrimvar().Set([7] * (2 * SIDE**2)),
            "INDEX_RANGE",
            "/Char/Face",
        ),
        (lambda stage: _binding(stage).GetJointWeightsPrimvar().Set([1.0]), "INFLUENCES_LENGTH", "/Char/Face"),
        (lambda stage: _binding(stage).CreateJointsAttr(["a", "c"]), "JOINT_UNKNOWN", "/Char/Face"),
    ],
)
def test_skeletons_that_contradict(tmp_path, capfd, edit, code, path):
    error = _boned(tmp_path, edit)
    assert (error.issue.code, error.issue.path) == (code, path)
    assert capfd.readouterr() == ("", "")


# --- the configuration -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("config", "code", "path"),
    [
        ({"controls": {"smirk": {"exclude": True}}}, "CONFIG_UNKNOWN_CONTROL", 'controls."smirk"'),
        ({"joints": {"neck/nose": {"axes": ["x"]}}}, "CONFIG_UNKNOWN_CONTROL", 'joints."neck/nose"'),
        ({"poses": {"p": {"weights": {"smirk": 1.0}}}}, "CONFIG_UNKNOWN_CONTROL", 'poses."p".weights'),
        ({"poses": {"p": {}}}, "CONFIG_VALUE", 'poses."p"'),
        ({"poses": {"p": {"clip": [3.0, 1.0]}}}, "CONFIG_VALUE", 'poses."p"'),
        ({"poses": {"p": {"frame": 1.0, "animation": "/No"}}}, "CONFIG_VALUE", 'poses."p".animation'),
        ({"controls": {"smile": {"minimum": 2.0, "maximum": 1.0}}}, "CONFIG_VALUE", 'controls."smile"'),
        ({"controls": {"smile": {"default": 3.0}}}, "CONFIG_VALUE", 'controls."smile"'),
        ({"controls": {"smile": {"rename": "jaw"}}}, "CONFIG_VALUE", 'controls."jaw".rename'),
    ],
)
def test_configuration_that_does_not_fit(tmp_path, config, code, path):
    error = refused(character(tmp_path / "char.usda"), config)
    assert (error.issue.code, error.issue.path, error.exit_code) == (code, path, Exit.USAGE)


def test_joints_are_named_to_whom_names_another(tmp_path):
    """`inspect` lists controls only: what joints there are is told where one is missing."""
    path = character(tmp_path / "char.usda")
    assert "did you mean 'jaw'" in refused(path, {"joints": {"Jow": {"axes": ["x"]}}}).issue.message
    assert "has the joints " in refused(path, {"joints": {"zzz": {"axes": ["x"]}}}).issue.message


def test_usd_errors_without_utf8_do_not_escape(tmp_path):
    """str() of such a Tf.ErrorException raises UnicodeDecodeError by itself."""
    path = tmp_path / "bytes.usda"
    path.write_bytes(b'#usda 1.0\ndef "\xff\xfe\xfd" {')
    with pytest.raises(Tf.ErrorException):
        Sdf.Layer.FindOrOpen(str(path))
    assert refused(path).issue.code == "FILE_NOT_USD"
