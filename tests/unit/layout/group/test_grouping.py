"""Which controls share an element."""

from dataclasses import replace

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES

from usdrigui.character import Joint
from usdrigui.errors import RigUIError
from usdrigui.layout.group.grouping import find_groups, suggested_groups


def eye(centre, sign=1.0):
    """Four gaze controls about one eye."""
    ways = {"In": (-sign, 0, 0), "Out": (sign, 0, 0), "Up": (0, 1, 0), "Down": (0, -1, 0)}
    return {way: makers.bump(POINTS, centre, direction, 0.2, 0.06) for way, direction in ways.items()}


def gazing():
    eyes = {"L": eye((0.35, 0.3)), "R": eye((-0.35, 0.3), -1.0)}
    looks = {f"look{way}_{side}": offsets for side, ways in eyes.items() for way, offsets in ways.items()}
    return makers.rig(POINTS, QUADS, {**{k: v for k, v in SHAPES.items() if not k.startswith("blink")}, **looks})


def groups_of(rig, **parts):
    line = chain.problem_of(rig, chain.settings(**parts))
    names = rig.control_names
    return {tuple(names[c] for c in group.controls): group for group in line.groups}, names


def test_pairs_are_folded_and_middle_controls_stand_alone():
    groups, names = groups_of(makers.face())
    assert [names[c] for c in groups["brow_L",].mirror] == ["brow_R"]
    assert ("brow_R",) not in groups
    assert groups["pucker",].mirror == ()
    unfolded, _ = groups_of(makers.face(), symmetry={"fold": False}, groups={"opposed": False})
    assert len(unfolded) == len(names)


def test_opposed_controls_become_one_slider_with_two_ends():
    groups, _ = groups_of(makers.face())
    jaw = groups["jawRight", "jawLeft"]
    assert (jaw.kind, jaw.opposed, jaw.mirror) == ("slider", ((0, 1),), ())
    apart, _ = groups_of(makers.face(), groups={"opposed": False})
    assert ("jawRight", "jawLeft") not in apart
    half_named, _ = groups_of(makers.rig(POINTS, QUADS, {k.replace("jawLeft", "two"): v for k, v in SHAPES.items()}))
    assert ("jawRight", "two") in half_named
    shy, _ = groups_of(makers.face(), groups={"opposed_cosine": -1.01})
    assert ("jawRight", "jawLeft") in shy, "twins have some leeway"


def test_the_opposite_of_like_amount_is_preferred():
    rig = makers.face_with(jawBit=-0.2 * SHAPES["jawLeft"])
    groups, _ = groups_of(rig, symmetry={"enabled": False})
    assert ("jawRight", "jawLeft") in groups or ("jawLeft", "jawRight") in groups


def test_two_crossing_axes_of_one_region_become_a_joystick():
    groups, names = groups_of(gazing())
    stick = groups["lookIn_L", "lookOut_L", "lookDown_L", "lookUp_L"]
    assert (stick.kind, stick.opposed) == ("patch", ((0, 1), (2, 3)))
    assert [names[c] for c in stick.mirror] == ["lookIn_R", "lookOut_R", "lookDown_R", "lookUp_R"]


def swinging(lesser=1.0):
    """Two controls of one region that go to both sides and cross."""
    shapes = {
        "across": makers.bump(POINTS, (0.0, 0.6), (1, 0, 0), 0.3, 0.1),
        "upright": makers.bump(POINTS, (0.0, 0.6), (0, 1, 0), 0.3, 0.1 * lesser),
    }
    return makers.rig(POINTS, QUADS, shapes, ranges=dict.fromkeys(shapes, (-1.0, 1.0, 0.0)))


def test_controls_that_swing_across_each_other_make_a_joystick_if_opposed_ones_may():
    assert ("across", "upright") in groups_of(swinging())[0]
    assert ("across", "upright") not in groups_of(swinging(), groups={"opposed": False})[0]


def test_a_far_lesser_axis_makes_no_joystick():
    assert ("across", "upright") in groups_of(swinging(0.2))[0]
    assert ("across", "upright") not in groups_of(swinging(0.05))[0]


def test_the_axes_of_an_eye_share_what_the_lids_leave_of_it():
    """No view sees the skin that its joint owns most."""
    line = chain.problem_of(swinging(), chain.settings())
    known, found = line.inputs.measured, line.face.trajectories
    lids = POINTS[:, 1] > 0.6
    motions = tuple(replace(each, owned=np.where(lids[each.points], 1.0, 0.5)) for each in found.motions)
    views = replace(line.face.views, visible=line.face.views.visible & ~lids)
    face = replace(line.face, trajectories=replace(found, motions=motions), views=views)
    assert [group.kind for group in find_groups(replace(known, face=face), line.candidates)] == ["patch"]


WHOLE, CURL, CARRIED = {0: 1.0, 1: 1.0}, {0: 1.0, 1: 2.0}, {0: 1.0, 1: 1.0 + 1e-5}


def turning(face, turns):
    """The controls of a face as controls of joints of one parent: by control the turns of its joints."""
    controls = []
    for each, turn in zip(face.rig.controls, turns, strict=True):
        vectors = np.array([[[sign * amount, 0, 0] for amount in turn.values()] for sign in (-1.0, 1.0)])
        drive = makers.drive(each.drive.channels, joints=[*turn], turns=vectors)
        controls.append(replace(each, kind="joint", drive=drive))
    joints = tuple(Joint(f"j{i}", 0, -1, np.eye(4), np.eye(4), np.eye(4)) for i in range(2))
    return replace(face, rig=makers.changed(face.rig, controls=tuple(controls), joints=joints))


@pytest.mark.parametrize(
    ("turns", "shared"),
    [
        (({0: 1.0}, {0: 1.0}), True),
        (({0: 1.0}, {1: 1.0}), False),
        (({0: 1.0}, CURL), False),
        ((WHOLE, CURL), False),
        ((WHOLE, CARRIED), True),
    ],
)
def test_joints_make_a_joystick_of_one_joint_only(turns, shared):
    """What a joint carries with it where the joints of a hand are all roots is no turn of another joint."""
    line = chain.problem_of(swinging(), chain.settings())
    face = turning(line.face, turns)
    assert (
        any(
            len(group.controls) == 2 for group in find_groups(replace(line.inputs.measured, face=face), line.candidates)
        )
        == shared
    )


AT = (0.0, -0.55)


def test_axes_of_two_joints_are_no_opposites_by_convention():
    ends = {name: makers.bump(POINTS, AT, (0, 1, 0), 0.3, 0.1) for name in ("mouthDown", "mouthUp")}
    line = chain.problem_of(makers.rig(POINTS, QUADS, ends), chain.settings(candidates={"board_composite": False}))
    face = turning(line.face, ({0: 1.0}, {1: 1.0}))
    assert [group.reason for group in find_groups(replace(line.inputs.measured, face=face), line.candidates)] == [
        "",
        "",
    ]


@pytest.mark.parametrize(
    ("first", "second", "way", "amount", "together"),
    [
        ("one", "two", (0, 1, 0), 1.0, True),
        ("one", "two", (0.75, 0.6, 0), 1.0, False),
        ("one", "two", (0, 1, 0), 0.15, False),
        ("mouthDown", "mouthUp", (0.75, 0.6, 0), 0.15, True),
        ("mouthDown", "mouthUp", (1, 0.1, 0), 1.0, False),
        ("jawOpen", "mouthRollLower", (0, 1, 0), 1.0, False),
        ("mouthPucker", "viseme_OO", (0, 1, 0), 1.0, False),
        ("mouthSmile", "two", (0, 1, 0), 1.0, False),
        ("mouth-1", "mouth-2", (0, 1, 0), 1.0, True),
        ("mouth-1", "nose-2", (0, 1, 0), 1.0, False),
    ],
)
def test_names_decide_first_and_motions_where_they_say_nothing_or_disagree(first, second, way, amount, together):
    ends = {
        first: makers.bump(POINTS, AT, (0, -1, 0), 0.3, 0.1),
        second: makers.bump(POINTS, AT, way, 0.3, 0.1 * amount),
    }
    groups, _ = groups_of(makers.rig(POINTS, QUADS, ends), symmetry={"enabled": False})
    assert any(len(key) == 2 for key in groups) == together


def test_the_report_says_why_opposites_by_convention_stayed_apart():
    ends = {
        name: makers.bump(POINTS, AT, (0, 1, 0), 0.3, size) for name, size in (("mouthDown", 0.1), ("mouthUp", 0.06))
    }
    groups, _ = groups_of(makers.rig(POINTS, QUADS, ends), candidates={"board_composite": False})
    assert groups["mouthUp",].reason.startswith(
        "apart from mouthDown, its opposite by convention (their directions are 0 degrees apart, their regions share"
    )


@pytest.mark.parametrize(
    ("names", "together"),
    [
        (("one", "two", "three"), True),
        (("eyeLookIn_L", "eyeLookOut_L", "eyeLookUp_L"), True),
        (("jawRight", "jawLeft", "jawOpen", "browUp"), False),
    ],
)
def test_an_axis_takes_a_crossing_single_control_if_the_convention_has_no_other_word(names, together):
    ways = ((-1, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
    shapes = {name: makers.bump(POINTS, (0.35, 0.3), way, 0.3, 0.1) for name, way in zip(names, ways, strict=False)}
    groups, _ = groups_of(makers.rig(POINTS, QUADS, shapes), symmetry={"enabled": False})
    assert (names[:3] in groups) == together
    if together:
        assert (groups[names].kind, groups[names].opposed) == ("patch", ((0, 1),))


def test_a_gaze_of_both_eyes_stands_on_each_of_them():
    ways = {"lookLeft": (1, 0, 0), "lookRight": (-1, 0, 0), "lookUp": (0, 1, 0), "lookDown": (0, -1, 0)}
    shapes = {
        name: sum(makers.bump(POINTS, (side * 0.35, 0.3), way, 0.2, 0.06) for side in (-1, 1))
        for name, way in ways.items()
    }
    groups, names = groups_of(makers.rig(POINTS, QUADS, shapes))
    stick = groups["lookRight", "lookLeft", "lookDown", "lookUp"]
    assert [names[c] for c in stick.mirror] == ["lookLeft", "lookRight", "lookDown", "lookUp"]


def test_patches_and_fans_by_the_jaccard_index():
    third = makers.bump(POINTS, (0.0, -0.45), (0.0, 1.0, 0.0), 0.3, 0.1)
    rig = makers.face_with(lipUp=third, lipOut=makers.bump(POINTS, (0.0, -0.45), (0.0, 1.0, 0.5), 0.3, 0.1))
    off = {"opposed": False}
    assert not any(len(key) > 1 for key in groups_of(rig, groups=off)[0])
    pairs = [key for key in groups_of(rig, groups={**off, "patches": True})[0] if len(key) > 1]
    assert all(len(key) == 2 for key in pairs)
    assert len(pairs) >= 1
    fans, _ = groups_of(rig, groups={**off, "patches": True, "fan_size": 3, "jaccard_min": 0.5})
    fan = next(group for key, group in fans.items() if set(key) == {"pucker", "lipUp", "lipOut"})
    assert fan.kind == "fan"
    line = chain.problem_of(rig, chain.settings(groups=off))
    assert any(set(names) <= {"pucker", "lipUp", "lipOut"} for names in suggested_groups(*line.grouping, line.groups))
    assert not any(len(k) > 1 for k in groups_of(rig, groups={**off, "patches": True, "jaccard_min": 1.0})[0])


def test_nothing_is_suggested_for_a_part_of_which_nothing_can_stand():
    known, candidates = chain.problem_of(gazing(), chain.settings()).grouping
    assert suggested_groups(known, replace(candidates, sets=()), ()) == ()


def test_the_users_groups_are_kept_and_their_image_is_made():
    said = {"groups": {"mouth": ("smile_L", "sneer_L"), "middle": ("pucker", "chin")}}
    rig = makers.face_with(chin=0.5 * SHAPES["pucker"] + SHAPES["chin"])
    line = chain.problem_of(rig, chain.settings(groups=said, candidates={"peak_share": 0.05, "prune_at": 0.1}))
    found = {group.name: group for group in line.groups}
    assert found["mouth"].reason == "grouped by the configuration"
    assert [rig.controls[c].name for c in found["mouth"].mirror] == []
    assert "smile_R" in found
    assert found["middle"].kind == "patch"


@pytest.mark.parametrize(
    ("groups", "code"),
    [
        ({"a": ("pucker", "nobody")}, "CONFIG_UNKNOWN_CONTROL"),
        ({"a": ("pucker",)}, "CONFIG_VALUE"),
        ({"a": ("pucker", "pucker")}, "CONFIG_VALUE"),
        ({"a": ("pucker", "chin"), "b": ("chin", "brow_L")}, "CONFIG_VALUE"),
    ],
)
def test_wrong_groups_are_refused(groups, code):
    with pytest.raises(RigUIError, match=code):
        groups_of(makers.face(), groups={"groups": groups})
