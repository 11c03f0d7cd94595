"""Laws of the controls that a rig driven by joints alone has by default: read from geometry, never from names."""

import re
from collections import Counter
from dataclasses import replace

import limbs
import makers
import numpy as np
import pytest
import skel_stages
from pxr import Gf, Vt

from usdrigui.character.deform import posed
from usdrigui.character.joint_tree import Tree
from usdrigui.character.rotation import rotation_part, rotations
from usdrigui.character.skinning import in_skeleton_space
from usdrigui.reading.character import read_rigs
from usdrigui.reading.control import default_joint_drafts
from usdrigui.reading.joint import default_turns, posed_locals
from usdrigui.settings import JointSettings, Settings

HAND, BALL = limbs.hand_rig(), ("rx", "ry", "rz")


def turns_of(rig):
    """The degrees of freedom of its joints."""
    return default_turns(Tree(rig.body.joints, rig.body.meshes))


def kinds(rig):
    """How many controls of each kind."""
    return Counter(turn.name for turn in turns_of(rig))


@pytest.mark.parametrize(
    "made",
    [HAND, limbs.flattened(HAND), *(limbs.flattened(HAND, sign, 0.5) for sign in (1.0, -1.0))],
    ids=["hierarchy", "flat", "wrist aside", "wrist aside, looking back"],
)
def test_a_hand_gets_a_curl_and_a_spread_per_finger_and_a_wrist(made):
    assert kinds(made) == {"curl": 4, "spread": 4, "rx": 1, "ry": 1, "rz": 1}


_BENT = ((0.3, 0.2), (0.4, 0.7), (0.3, 1.2), (0.3, 1.6))


@pytest.mark.parametrize(
    ("aside", "long", "curled"), [(0, 4, 4), (0, 2, 2), (3, 4, 3)], ids=["legs", "short", "fingers"]
)
def test_what_hangs_on_the_middle_curls_whole_and_fingers_without_their_metacarpals(aside, long, curled):
    at = {"m": (0.0, 0.0, 0.0)}
    for side, name in ((1.0, "l"), (-1.0, "r")):
        at[f"m/{name}"] = (side * aside, 0.0, 0.0)
        for strand in range(3):
            ways = [(side * (aside + x), -y, strand - 1.0) for x, y in _BENT[:long]]
            limbs.hang(at, f"m/{name}" if aside else "m", f"{name}{strand}", ways)
    made = limbs.resting(limbs.skeleton_rig(*limbs.by_depth(at)), {"l00": (0.3, 0.0, 0.0)})
    curls = [turn for turn in turns_of(made) if turn.name == "curl"]
    assert {len(turn.joints) for turn in curls} == {curled}
    # What one side does the other mirrors, and no plane of this pose.
    assert aside or np.sum([turn.axes[0] for turn in curls], axis=0)[1:] == pytest.approx(0.0, abs=1e-6)


def test_skin_at_the_tip_of_a_finger_adds_no_joint_that_curls():
    """Skinners leave a little on the end of one finger."""
    names = [joint.path for joint in HAND.body.joints]
    owners = [i for i, name in enumerate(names) if name[-1] != "3" or name[-2:] == "33"]
    made = limbs.skeleton_rig(names, np.array([joint.bind[3, :3] for joint in HAND.body.joints]), owners)
    assert kinds_of(made) == kinds_of(HAND)


def test_rigid_motion_scale_and_other_own_axes_of_the_joints_change_no_turn():
    turned = limbs.moved(HAND, rotations(np.array([0.4, -1.1, 0.7])), 3.7, own=rotations(np.array([1.0, 0.3, -2.0])))
    assert kinds(turned) == kinds(HAND)


@pytest.mark.parametrize("made", [HAND, limbs.flattened(HAND)], ids=["hierarchy", "flat"])
def test_curled_fingers_reach_into_the_palm_and_stay_in_one_piece(made):
    tree = Tree(made.body.joints, made.body.meshes)
    for turn in (turn for turn in default_turns(tree) if turn.name == "curl"):
        world = in_skeleton_space(made.body.joints, posed_locals(tree, turn, np.array([60.0])))[0]
        tip = max(turn.joints)
        assert world[tip][3, 2] > tree.places[tip, 2]
        bones = [(a, b) for a, b in zip(turn.joints, turn.joints[1:], strict=False)]
        for a, b in bones:
            before, after = (np.linalg.norm(w[b][3, :3] - w[a][3, :3]) for w in (tree.world, world))
            assert after == pytest.approx(before)


@pytest.mark.parametrize(("bend", "back"), [(0.0, 1.0), (10.0, 1.0), (0.0, -1.0)], ids=["straight", "bent", "back"])
def test_the_thumb_is_the_finger_apart_and_it_and_the_others_curl_towards_each_other(bend, back):
    ahead = [rotations(np.radians([0.0, 0.0, -bend * k])) @ [-0.25, 0.15, 0.02] for k in range(3)]
    thumb = np.cumsum([[-0.4, 0.2, 0.3], *ahead], axis=0)
    paths, places = zip(*((joint.path, joint.bind[3, :3]) for joint in HAND.body.joints), strict=True)
    names = [*paths, "w/t0", "w/t0/t1", "w/t0/t1/t2", "w/t0/t1/t2/t3"]
    made = limbs.skeleton_rig(
        names, np.vstack([np.array(places) * [1.0, 1.0, back], thumb]), [i for i, n in enumerate(names) if n[-1] != "3"]
    )
    tree = Tree(made.body.joints, made.body.meshes)
    curls = {turn.joints[0]: turn for turn in default_turns(tree) if turn.name == "curl"}
    turn = curls.pop(len(paths))
    others = tree.places[sorted(curls)].mean(axis=0)
    posed = in_skeleton_space(made.body.joints, posed_locals(tree, turn, np.array([0.0, 30.0])))
    tips = posed[:, len(paths) + 3, 3, :3]
    assert np.linalg.norm(tips[1] - others) < np.linalg.norm(tips[0] - others) - 0.1
    assert all(each.axes[0][0] > 0.99 for each in curls.values()), "fingers curl about their row"


def test_what_a_flat_skeleton_does_under_a_control_is_what_the_hierarchy_does():
    """The keys of the flat one follow the arcs to a hundredth of the hand."""
    size = np.ptp(HAND.body.meshes[0].points, axis=0).max()
    made = [with_defaults(rig) for rig in (HAND, limbs.flattened(HAND))]
    assert len(made[0].controls) == len(made[1].controls) == 8
    for i, control in enumerate(made[0].controls):
        values = np.zeros(len(made[0].controls))
        values[i] = 0.37 * control.maximum
        assert np.abs(posed(made[0], values).points - posed(made[1], values).points).max() < 0.01 * size, control.name


def with_defaults(rig):
    """The rig with the default controls of its fingers."""
    drafts = (each for each in default_joint_drafts(rig.body, None, (), {}) if ":r" not in each.name)
    ordered = sorted(drafts, key=lambda draft: draft.name.rsplit("/", 1)[-1])
    return replace(rig, controls=tuple(map(limbs.as_control, ordered)))


def test_the_only_joint_of_a_skeleton_has_no_turns():
    """It stands for the place of a mesh with shapes beside the character's own Skeleton."""
    rig = limbs.body_rig()
    (body,), joints = rig.body.meshes, rig.body.joints
    mouth = replace(body, skin=makers.skin(len(body.points), len(joints)))
    more = replace(joints[0], path="joint1", skeleton=1)
    assert kinds(makers.changed(rig, joints=(*joints, more), meshes=(body, mouth))) == kinds(rig)


def test_a_trunk_and_small_bones_of_a_face_have_no_hinge_where_no_plane_mirrors_the_joints():
    at = {joint.path.replace("h/s", "h/u/v/s"): joint.bind[3, :3] for joint in limbs.whole_body().body.joints}
    at |= {"h/u": (0.0, 0.1, 0.0), "h/u/v": (0.0, 0.15, 0.0)}
    names, places = limbs.by_depth(at)
    askew = rotations(np.array([0.4, -1.1, 0.7]))
    rig = limbs.anyhow(limbs.skeleton_rig(names, places @ askew), 3)
    assert Tree(rig.body.joints, rig.body.meshes).mirror is None
    bends = {path.rpartition("/")[2] for path, kind in kinds_of(rig) if kind == "bend"}
    assert bends == {"a1", "al1", "b1", "bl1"}


def test_an_elbow_is_one_axis_that_lies_across_the_bend_and_a_joint_without_skin_is_none():
    rig = limbs.body_rig()
    tree = Tree(rig.body.joints, rig.body.meshes)
    turns = default_turns(tree)
    bends = [turn for turn in turns if turn.name == "bend"]
    assert [rig.body.joints[turn.home].path.rsplit("/", 1)[-1] for turn in bends] == ["c1", "d1", "a1", "b1"]
    for turn in bends:
        axis = rotation_part(tree.world[turn.home][None])[0].T @ turn.axes[0]
        along = tree.direction([turn.home])
        assert abs(axis @ along) < 1e-6
        # Straight knees bend back, straight elbows ahead, on both sides.
        assert np.cross(axis, along) == pytest.approx([0, 0, -1 if along[1] else 1])
    assert {turn.home for turn in turns} <= tree.owners
    assert len(tree.owners) < len(rig.body.joints)


@pytest.mark.parametrize("turned", [0, 1, 2])
@pytest.mark.parametrize(("neck", "height"), [(0.5, 0.6), (0.5, 1.1), (0.0, 0.6)])
def test_an_eye_turns_about_the_axes_that_lie_across_its_gaze(neck, height, turned):
    """Whichever of its own axes looks ahead, high above most of its head, or on a head without a neck."""
    frame = np.roll(np.eye(3), turned, axis=0)
    at = {"h": (0, 0.5 - neck, 0), "h/n": (0, 0.5, 0), "h/n/l": (0.2, height, 0.4), "h/n/r": (-0.2, height, 0.4)}
    at |= {f"h/n/{name}": (x, 0.1, 0.1) for name, x in (("a", 0.9), ("b", -0.9))}
    rig = limbs.skeleton_rig(list(at), np.array(list(at.values()), float), range(len(at)), frame)
    axes = [turn.axes[0] @ frame for turn in turns_of(rig) if rig.body.joints[turn.home].path in ("h/n/l", "h/n/r")]
    assert np.abs(np.sum(np.square(axes), axis=0) - [2.0, 2.0, 0.0]).max() < 1e-9


def test_keys_of_a_flat_skeleton_are_no_more_than_ten_degrees_apart_and_no_more_than_needed():
    made = limbs.flattened(HAND)
    for draft in default_joint_drafts(made.body, None, (), {}):
        low, high, values = draft.range.minimum, draft.range.maximum, draft.drive_over(draft.range).values
        assert np.diff(values).max() <= 10.0 + 1e-9
        assert set(values) == {0.0, *np.linspace(low, high, int(np.ceil((high - low) / 10.0)) + 1)}


@pytest.mark.parametrize("twists", ["beside", "below"])
def test_a_limb_whose_skin_hangs_on_twist_joints_turns_as_one_with_skin_of_its_own(twists):
    found, plain = kinds_of(limbs.twisted_body(twists)), kinds_of(limbs.twisted_body(""))
    assert ("h/s/a0/a1", "bend") in plain
    assert found >= plain
    assert [kind for _, kind in found - plain] == ["twist"] * 16


def test_joints_in_line_on_the_bones_of_a_bent_arm_twist():
    """t between the shoulder a and the elbow e, u between that and the hand, without which they turn alike."""
    found, along = [], {"a": (0, -4, -1), "t": (0, -3, -0.5), "e": (0, -2, 0), "u": (0, -1, 0)}
    for arm in ("ae", "ateu"):
        at = {"r": (0, -5, -1), "r/b": (1, -5, -1), "r/b/c": (2, -5, -1)}
        at |= {"r/" + "/".join(arm[: k + 1]): along[name] for k, name in enumerate(arm)}
        at |= {f"{[*at][-1]}/{joint.path}": joint.bind[3, :3] for joint in HAND.body.joints}
        owners = [i for i, name in enumerate(at) if name[-1] != "3"]
        # Aslant: no axis mirrors the hand.
        places = np.array([*at.values()], float) @ rotations(np.array([0.3, 0.5, 0.0]))
        rig = limbs.skeleton_rig([*at], places, owners)
        found.append({(path[-2:], kind) for path, kind in kinds_of(rig)})
    assert found[1] - found[0] == {("/t", "twist"), ("/u", "twist")}
    assert found[1] > found[0] > {("/e", "bend")}


def kinds_of(rig):
    """Path of the first joint and kind of every turn."""
    return {(rig.body.joints[turn.joints[0]].path, turn.name) for turn in turns_of(rig)}


def test_helpers_off_the_way_change_no_degree_of_freedom():
    """A joint without skin on the ground above each limb, as exports have those of constraints."""
    rig = limbs.body_rig()
    at = {re.sub(r"/([abcd])0", r"/m\1/\g<1>0", joint.path): joint.bind[3, :3] for joint in rig.body.joints}
    at |= {path: np.array([0.0, -2.0, 0.0]) for path in ("h/s/ma", "h/s/mb", "h/mc", "h/md")}
    names, places = limbs.by_depth(at)
    owners = [i for i, name in enumerate(names) if name[-1] not in "e3" and name[-3:-1] != "/m"]
    helped = limbs.skeleton_rig(names, places, owners)
    assert {(path[-2:], kind) for path, kind in kinds_of(helped)} == {(path[-2:], kind) for path, kind in kinds_of(rig)}


@pytest.mark.parametrize("ways", [(0.0,), (-0.3, 0.3)], ids=["tail", "coat"])
def test_legs_are_legs_beside_what_hangs_with_them(ways):
    at = {joint.path: joint.bind[3, :3] for joint in limbs.body_rig().body.joints}
    for number, way in enumerate(ways):
        limbs.hang(at, "h", f"t{number}", [(way, -0.3 * k, -0.2) for k in range(1, 4)])
    names, places = limbs.by_depth(at)
    clad = limbs.skeleton_rig(names, places, [i for i, name in enumerate(names) if name[-1] not in "e3"])
    assert {turn for turn in kinds_of(clad) if "/t" not in turn[0]} == kinds_of(limbs.body_rig())


def test_a_neck_that_carries_ears_and_a_jaw_is_no_finger_beside_legs():
    at = {"m": (0.0, 0.0, 0.0)}
    for x in (-1.0, 1.0, 0.0):
        end = limbs.hang(at, "m", str(x), [(x, -y, 0.0) for y in range(1, 5)])
    at |= {f"{end}/{x}": (x, -5.0, 0.0) for x in (-0.3, 0.0, 0.3)}
    assert "curl" not in kinds(limbs.skeleton_rig(*limbs.by_depth(at)))


def test_a_head_turns_every_way_and_a_strand_across_its_bone():
    kinds = [kind for path, kind in sorted(kinds_of(limbs.body_rig())) if path[-2:] in ("/n", "a2")]
    assert kinds == [*BALL[1:], *BALL]


def test_a_finger_curls_further_in_than_out_and_all_else_goes_alike_to_both_sides():
    spans = {turn.name: turn.range for turn in turns_of(HAND)}
    assert spans == {"curl": (-10.0, 80.0), "spread": (-20.0, 20.0), **dict.fromkeys(BALL, (-30.0, 30.0))}


def staged_body(path, *, smiling, waving):
    """A body on a stage: with a shape on its face, and with a clip that turns one upper arm by up to 90 degrees."""
    rig = limbs.whole_body()
    stage, _ = skel_stages.new_stage(path)
    joints, (mesh,) = [joint.path for joint in rig.body.joints], rig.body.meshes
    rest = [Gf.Matrix4d(*joint.rest.ravel().tolist()) for joint in rig.body.joints]
    skel_stages.add_skeleton(stage, "/Char/Skel", joints, rest)
    made = skel_stages.add_mesh(stage, "/Char/Body", "/Char/Skel")
    made.GetPointsAttr().Set(Vt.Vec3fArray.FromNumpy(mesh.points.astype(np.float32)))
    made.GetFaceVertexCountsAttr().Set(mesh.topology.face_counts.tolist())
    made.GetFaceVertexIndicesAttr().Set(mesh.topology.face_indices.tolist())
    skel_stages.add_skin(made, mesh.skin.joints, mesh.skin.weights, 1)
    if smiling:
        offsets = np.where(mesh.points[:, 1:2] > 1.4, [[0.0, 0.0, 0.05]], 0.0)
        skel_stages.add_shape(made, "smile", offsets)
    wave = skel_stages.matrix((0, 0, 90))
    raised = [wave * local if name.endswith("/a0") else local for name, local in zip(joints, rest, strict=True)]
    keys, shapes = {0.0: rest, 1.0: raised}, ("smile",) * smiling
    if smiling or waving:
        skel_stages.add_animation(stage, "/Char/Anim", "/Char/Skel", shapes, None, joints * waving, keys)
    stage.GetRootLayer().Save()
    return path


def test_a_body_has_the_same_controls_whatever_else_moves_it(tmp_path):
    """Shapes on its face and a clip of one arm add or widen, and take no control of a joint away."""
    rigs = [
        read_rigs(staged_body(tmp_path / f"{smiling}{waving}.usda", smiling=smiling, waving=waving), Settings())[0]
        for smiling in (False, True)
        for waving in (False, True)
    ]
    turns = [{each.name: each for each in rig.controls if each.kind == "joint"} for rig in rigs]
    assert {"a1:bend", "b1:bend", "af00:curl", "bf00:curl", "h:rx", "al1:bend"} <= turns[0].keys()
    assert all(each.keys() == turns[0].keys() for each in turns)
    assert [each["a0:rz"].maximum for each in turns] == pytest.approx([30.0, 90.0, 30.0, 90.0])
    assert [each["b0:rz"].maximum for each in turns] == [30.0] * 4


def test_what_is_configured_or_set_by_a_pose_has_no_control_by_default():
    body = limbs.whole_body().body
    hips = [joint.path for joint in body.joints].index("h")
    found = default_joint_drafts(body, None, {hips}, {"a0": JointSettings(axes=("x",))})
    assert not {draft.source for draft in found} & {"h", "h/s/t/a0"}
    assert "b0:rx" in {draft.name for draft in found}
