"""Parts of made-up characters: told by geometry and skin, each laid out at its own scale."""

from dataclasses import replace

import chain
import laid_out
import limbs
import makers
import numpy as np
import pytest
import rig_copies
from scipy.spatial.distance import pdist
from scipy.spatial.transform import Rotation

from usdrigui.layer import write_layout as layer
from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.layout.parts.division import divide
from usdrigui.layout.parts.joint_regions import joint_regions, seen_flat
from usdrigui.pipeline.joining import joined, joined_assignment
from usdrigui.pipeline.stages import character_of, part_problem
from usdrigui.settings import Settings, load

BODY = limbs.whole_body()


def named(rig, settings=None):
    """By part, the joints of its controls and the controls themselves."""
    settings = settings or Settings()
    parts = divide(rig, trajectories(rig, settings.trajectories), settings)
    return {part.name: {rig.controls[control].name for control in part.controls} for part in parts}


def test_joints_of_a_face_that_shapes_move_are_a_part_of_their_own():
    """The face of a body is laid out as without its joints."""
    found = named(limbs.smiling(BODY))
    assert found["face"] == {"smile"}
    assert found["head"] == named(BODY)["face"]
    found = named(limbs.smiling(limbs.whole_body(bare=("k0", "k1", "k2", "k3", "k4", "k5", "k6"))))
    assert [*found] == ["face", "hands", "body"], "two joints are no page of their own"


def test_fewer_joints_than_a_face_has_are_of_the_head():
    assert "head" in named(limbs.whole_body(bare=("k0", "k1", "k2", "k3")))


def test_the_left_of_a_face_is_that_of_the_character_whatever_its_few_controls_move():
    _, y, z = BODY.body.meshes[0].points.T
    moved = {"chest": (abs(y - 0.8) < 0.1) & (z > 0.0), "belly": (abs(y - 0.4) < 0.1) & (z > 0.0)}
    moved["hair"] = (y > 1.3) & (z < 0.0)
    shaped = limbs.with_shapes(BODY, {name: np.outer(each, [0.0, 0.0, 0.05]) for name, each in moved.items()})
    parts = character_of(shaped, Settings()).parts
    assert {part.name: part.symmetry.plane.normal[0] > 0.9 for part in parts}["face"]


def test_a_hand_is_as_large_as_it_is_long_however_flat_it_is_held():
    hands = character_of(BODY, Settings()).parts[1]
    assert hands.name == "hands"
    assert hands.trajectories.surface.face_size > 0.12


@pytest.mark.parametrize(
    "rig",
    [
        BODY,
        limbs.whole_body(head="e"),
        limbs.anyhow(BODY, 3),
        limbs.resting(BODY, {"a2": (0.0, 2.0, 0.0)}),
        limbs.whole_body(bare=("a2", "b2", "l2")),
        limbs.with_default_controls(limbs.flattened(limbs.hand_rig())),
    ],
    ids=["head named", "no name", "posed", "a wrist bent back", "limbs of two", "hand alone"],
)
def test_joints_are_told_apart_into_face_hands_and_body(rig):
    found = named(rig)
    fingers = {name for part in found.values() for name in part if "curl" in name or "spread" in name}
    if len(found) == 1:
        assert found == {"hands": {*rig.control_names}}
        return
    assert list(found) == ["face", "hands", "body"]
    assert found["hands"] == fingers
    assert {name.partition(":")[0] for name in found["face"]} == {f"k{k}" for k in range(9)}
    assert len(found["hands"]) == 16


@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_hands_are_no_feet_however_the_skeleton_is_turned_to_stand_up(axis):
    rotation = Rotation.from_euler(axis, 90, degrees=True).as_matrix()
    assert named(replace(rig_copies.turned(BODY, rotation), up=rotation @ BODY.up)) == named(BODY)


@pytest.mark.parametrize(
    ("part", "space", "deep", "seen"),
    [
        ("body", "part", 0.9, (True, True)),
        ("body", "part", 1.1, (False, False)),
        ("hands", "part", 1.1, (True, False)),
        ("face", "part", 1.1, (True, False)),
        ("body", "view", 0.9, (True, False)),
        ("face", "object", 0.9, (False, False)),
    ],
)
def test_a_body_is_measured_as_seen_unless_it_is_deeper_than_wide(part, space, deep, seen):
    """An animal on four legs is one behind the other from the front."""
    assert seen_flat(part, space, np.array([[0.0, 0.0, 0.0], [1.0, 3.0, deep]])) == seen


def test_what_hangs_on_no_arm_is_no_hand():
    hand = limbs.hand_rig().body
    names = [*(joint.path for joint in hand.joints), "stand"]
    places = np.array([*(joint.bind[3, :3] for joint in hand.joints), (0.5, -0.5, 0.0)])
    owners = [*np.unique(hand.meshes[0].skin.joints), len(hand.joints)]
    found = named(limbs.with_default_controls(limbs.skeleton_rig(names, places, owners)))
    assert list(found) == ["hands", "body"]
    assert {name.partition(":")[0] for name in found["body"]} == {"w", "stand"}


RING = np.array([[np.cos(a), np.sin(a)] for a in np.arange(6) * np.pi / 3.0])


def tube(points):
    """The faces of rings of six points."""
    rings = len(points) // 6
    return [
        [6 * i + j, 6 * i + (j + 1) % 6, 6 * i + 6 + (j + 1) % 6, 6 * i + 6 + j]
        for i in range(rings - 1)
        for j in range(6)
    ]


def with_eyes():
    """The body with two eyeballs of their own meshes; its own skin is shared between neighbours."""
    at = {joint.path: joint.bind[3, :3] for joint in BODY.body.joints}
    hung = {"h/s/t/n/Head/b": (0.03, 1.6, 0.1), "h/s/t/n/Head/c": (-0.03, 1.6, 0.1)}
    names = [*at, *hung]
    places = np.array([*at.values(), *hung.values()])
    joints = limbs.skeleton_rig(names, places).body.joints
    own = BODY.body.meshes[0].skin.joints
    above = np.maximum([joint.parent for joint in joints], 0)
    skin = replace(
        BODY.body.meshes[0].skin,
        joints=np.concatenate([own, above[own]], axis=1),
        weights=np.tile([0.7, 0.3], (len(own), 1)),
    )
    meshes = [makers.changed(BODY.body.meshes[0], skin=skin)]
    ball = np.concatenate([np.c_[np.sin(t) * RING, np.full(6, np.cos(t))] for t in np.linspace(0.3, 2.8, 5)])
    for name, place in hung.items():
        held = replace(skin, joints=np.full((len(ball), 1), names.index(name)), weights=np.ones((len(ball), 1)))
        meshes.append(makers.mesh(0.02 * ball + place, tube(ball), path=f"/Root/{name[-1]}", skin=held))
    return limbs.with_default_controls(makers.changed(BODY, joints=joints, meshes=tuple(meshes)))


@pytest.mark.parametrize("face", [lambda rig: rig, limbs.smiling])
def test_what_has_one_or_two_elements_joins_the_part_beside_it(face):
    found = named(face(with_eyes()))
    assert "eyes" not in found, "two eyes are of the face, whatever else moves it"
    assert {name.partition(":")[0] for name in found["face"]} >= {"b", "c"}


@pytest.mark.parametrize(
    ("strands", "part"),
    [
        (("h/s/t/n/Head", "head", (0.0, 0.1, 0.0)), "face"),
        (("h/s/t", "wing", (0.0, 0.1, -0.1)), "body"),
        (("h/s/t/a0/a1", "tip", (-0.1, -0.1, 0.0)), "body"),
        (("h/s/t/a0/a1", "tip", (0.1, -0.1, 0.0)), "hands"),
    ],
    ids=["hair", "wings", "tassels", "fingers"],
)
def test_strands_are_fingers_where_they_carry_on_a_limb_and_no_heads_though_named_so(strands, part):
    rig = limbs.whole_body(strands=strands)
    regions = joint_regions(rig, trajectories(rig, Settings().trajectories))
    of = {joint.name: name for joint, name in zip(rig.body.joints, regions.of_joint, strict=True)}
    assert {of[f"{strands[1]}{k}_{n}"] for k in range(3) for n in range(2)} == {part}
    assert (of["k4"], of["a0"], of["bf00"]) == ("face", "body", "hands")


@pytest.mark.parametrize(("lowest", "head"), [(1.4, {"e", "k7"}), (-9.0, set())])
def test_a_head_without_a_name_is_what_nearly_all_shapes_move(lowest, head):
    body = limbs.whole_body(head="e", bare=tuple(f"k{k}" for k in range(6)))
    raised = (body.body.meshes[0].points[:, 1:2] > lowest) * [[0.0, 0.0, 0.01]]
    made = limbs.with_shapes(body, {"smile": raised})
    regions = joint_regions(made, trajectories(made, Settings().trajectories))
    skin = {joint.name for joint, name in zip(made.body.joints, regions.of_skin, strict=True) if name == "face"}
    assert skin & {"e", "k7", "n", "t"} == head


def bust(rig, wrists=(), left=0.0):
    """The same with the skin of the limbs held by the hips, but for the `wrists` and the share that is `left`."""
    paths = [{*joint.path.split("/")} for joint in rig.body.joints]
    limb = [i for i, path in enumerate(paths) if path & {"a0", "b0", "al0", "bl0"} and not path & {*wrists}]
    own = rig.body.meshes[0].skin
    cut = np.isin(own.joints, limb)
    joints = np.concatenate([own.joints, np.where(cut, 0, own.joints)], axis=1)
    weights = np.concatenate(
        [own.weights * np.where(cut, left, 1.0), own.weights * np.where(cut, 1.0 - left, 0.0)], axis=1
    )
    trunk = makers.changed(rig.body.meshes[0], skin=replace(own, joints=joints, weights=weights))
    return limbs.with_default_controls(makers.changed(rig, meshes=(trunk, *rig.body.meshes[1:])))


@pytest.mark.parametrize("wrists", [set(), {"a2", "b2"}])
def test_a_head_without_a_body_keeps_its_eyes_and_with_hands_it_is_a_body(wrists):
    found = named(bust(with_eyes(), wrists))
    assert list(found) == ["face", "hands", "body"][: 1 + 2 * bool(wrists)]
    of = {name.partition(":")[0] for name in found[list(found)[-1]]}
    assert of & {"n", "b", *wrists} == {"n", *(wrists or "b")}


def test_a_neck_and_shoulders_are_a_body_under_a_face_that_shapes_move():
    """The face is as large as without them."""
    found = named(limbs.smiling(bust(BODY)))
    assert list(found) == ["face", "head", "body"]
    assert found["face"] == {"smile"}
    assert list(named(bust(BODY))) == ["face"]


@pytest.mark.parametrize(("left", "turns"), [(0.04, False), (0.06, True)])
def test_a_limb_that_is_cut_off_has_no_controls_for_the_trace_that_is_left_of_it(left, turns):
    of = {control.name.partition(":")[0] for control in bust(BODY, left=left).controls}
    assert {"n", "k0"} <= of
    assert of.isdisjoint({"a0", "a1", "bl1", "af00"}) != turns


def test_a_body_does_not_change_the_scale_of_its_face():
    facial = named(BODY)["face"]
    alone = replace(BODY, controls=tuple(control for control in BODY.controls if control.name in facial))
    character = character_of(BODY, Settings())
    face = part_problem(character, character.parts[0]).face
    sizes = [trajectories(rig, Settings().trajectories).surface.face_size for rig in (BODY, alone)]
    assert face.surface.face_size == sizes[1]
    assert sizes[0] > 5.0 * sizes[1]


def test_parts_keep_clear_of_each_other_and_their_proofs_add_up():
    laid = chain.laid_parts(BODY)
    whole, sums = joined(laid), joined_assignment([each.assignment for each in laid], ["face", "hands", "body"])
    assert [part.name for part in whole.frame.parts] == ["face", "hands", "body"]
    assert joined(laid[1:2]).frame.parts, "each hand alone has its own view"
    assert not joined(laid[:1]).frame.parts
    assert whole.proof.cost == pytest.approx(sum(part.cost for part in whole.frame.parts)) == sums.cost
    standing = laid_out.on_face(whole)
    assert {element.part for element in standing} == {"face", "hands", "body"}
    assert all(" face" not in element.reason for element in whole.elements if element.part != "face")
    widths = [(whole.frame.handle_width_of(element.part),) for element in standing]
    apart = pdist([element.anchor.position for element in standing])
    assert (apart >= pdist(widths, lambda *both: np.max(both)) * (1.0 - 1e-9)).all()


def test_the_whole_says_of_the_part_that_is_not_proved_why():
    laid = chain.laid_parts(BODY)
    open_ = {"status": "stopped", "method": "highs", "closed_by": "interrupt"}
    layout = replace(laid[1].layout, proof=replace(laid[1].layout.proof, **open_))
    laid[1] = replace(laid[1], layout=layout, assignment=replace(laid[1].assignment, **open_))
    found = joined(laid).proof, joined_assignment([each.assignment for each in laid], ["face", "hands", "body"])
    assert {(each.status, each.method, each.closed_by) for each in found} == {tuple(open_.values())}


def test_blend_shapes_are_of_the_part_whose_skin_they_move_and_a_neck_is_of_the_face():
    owners = BODY.body.meshes[0].skin.joints
    paths = [joint.path for joint in BODY.body.joints]
    on = {"smile": "h/s/t/n/Head/k0", "swallow": "h/s/t/n", "biceps": "h/s/t/a0/a1", "nail": "h/s/t/a0/a1/a2/af00/af01"}
    shapes = {name: (owners == paths.index(path)) * [[0.0, 0.0, 0.01]] for name, path in on.items()}
    made = limbs.with_shapes(replace(BODY, controls=()), shapes)
    assert named(made) == {"face": {"smile", "swallow"}, "body": {"biceps", "nail"}}


def test_the_configuration_names_parts_and_keeps_groups_together():
    nose, pair = "k4:rx", ("k0:rx", "k8:rx")
    moved = named(
        BODY, load({"parts": {"controls": {nose: "nose", pair[1]: "ears"}}, "groups": {"groups": {"g": pair}}})
    )
    assert moved["nose"] == {nose}
    assert set(pair) <= moved["face"]
    assert "ears" not in moved


@pytest.mark.parametrize(
    ("names", "conventions", "inside"),
    [
        (("tongueUp", "tongueOut", "tongueIn"), True, {"tongueUp", "tongueOut", "tongueIn"}),
        (("tongueUp", "tongueOut"), True, set()),
        (("tongueUp", "tongueOut", "tongueIn"), False, set()),
    ],
)
def test_tongue_and_teeth_are_a_part_where_they_have_several_controls(names, conventions, inside):
    rig = makers.face_with_teeth()
    *of_skin, inner = rig.controls
    called = tuple(replace(inner, name=name, source=name) for name in names)
    rig = replace(rig, controls=(*of_skin, *called))
    found = named(rig, load({"candidates": {"conventions": conventions}}))
    assert found.pop("interior", set()) == inside
    assert found == {"face": {*rig.control_names} - inside}


def test_what_moves_the_skin_is_not_inside_the_mouth_whatever_it_is_called():
    rig = makers.face()
    tongues = {f"tongue{way}" for way in ("Up", "Down", "Out")}
    called = tuple(replace(control, name=name) for control, name in zip(rig.controls, sorted(tongues), strict=False))
    rig = replace(rig, controls=called + rig.controls[len(called) :])
    assert list(named(rig)) == ["face"]
    assert all(chain.chosen(rig)(name).category != "interior" for name in tongues)


def test_a_part_without_height_is_as_large_as_what_it_moves():
    """Not as the whole character: a tongue whose joint owned one point had a board as wide as the body."""
    points, faces = makers.mask()
    moved = np.flatnonzero(points[:, 1] == points[len(points) // 2, 1])[:5]
    offsets = np.zeros_like(points)
    offsets[moved] = 0.0, 0.0, 0.1
    found = trajectories(makers.rig(points, faces, {"lift": offsets}), Settings().trajectories)
    assert found.surface.face_size == pytest.approx(np.linalg.norm(np.ptp(points[moved], axis=0)))


def test_the_layer_draws_the_handles_of_each_part_at_its_own_width(monkeypatch):
    rig = makers.face()
    layout = laid_out.layout_of(rig, only=["chin", "smile_L"])
    widths = {"face": 0.02, "body": 0.3}
    layout = laid_out.parted(layout, widths, widths)
    drawn, draw = {}, layer.drawn_parts

    def seen(skin, element, frame):
        handle, tracks = draw(skin, element, frame)
        drawn[element.part] = round(handle.lift / 0.35, 6)
        return handle, tracks

    monkeypatch.setattr(layer, "drawn_parts", seen)
    layer.layer_for([(rig, layout)], "", {})
    assert drawn == widths
