"""Names of every convention that the table cites are read as what they mean, in the company of their own rig."""

import pytest

from usdrigui.conventions import joysticks, meanings, words

_ARKIT = "eyeBlinkLeft eyeLookInRight jawOpen jawLeft mouthLeft mouthSmile_L browInnerUp cheekSquintLeft tongueOut"

_RIGS = {
    "ARKit": {
        **dict.fromkeys(("eyeBlinkLeft", "eyeBlink_L"), ("eyeBlink", "left")),
        "eyeLookInRight": ("eyeLookIn", "right"),
        "jawLeft": ("jawLeft", ""),
        "mouthLeft": ("mouthLeft", ""),
        "mouthRollLower": ("mouthRollLower", ""),
        "mouthUpperUp_R": ("mouthUpperUp", "right"),
        "cheekSquintLeft": ("cheekSquint", "left"),
        "tongueOut": ("tongue", ""),
    },
    "VALID": {
        "h_expressions.LbrowUp_h": ("browUp", "left"),
        "h_expressions.RmouthSad_h": ("mouthFrown", "right"),
        "h_expressions.LlowLid_h": ("eyeSquint", "left"),
        "h_expressions.SH_CH_h": ("viseme", ""),
        "h_expressions.MouthOpen_h": ("mouthOpen", ""),
    },
    "VRoid": {
        "Fcl_MTH_A": ("viseme", ""),
        "Fcl_BRW_Angry": ("browMood", ""),
        "Fcl_EYE_Close_L": ("eyeBlink", "left"),
        "Fcl_HA_Fung1": ("teeth", ""),
        "Fcl_ALL_Joy": ("emotion", ""),
    },
    "FACS": {"1": ("browInnerUp", ""), "L12": ("mouthSmile", "left"), "AU43R": ("eyeBlink", "right")},
    "VRM": {"A": ("viseme", ""), "Joy": ("emotion", ""), "Blink_L": ("eyeBlink", "left"), "LookUp": ("eyeLookUp", "")},
    "Character Creator": {
        "Brow_Raise_Inner_L": ("browInnerUp", "left"),
        "Eye_R_Look_Up": ("eyeLookUp", "right"),
        "V_Explosive": ("viseme", ""),
        "Mouth_Roll_In_Upper_L": ("mouthRollUpper", "left"),
    },
    "MakeHuman": {
        "eye-left-slit": ("eyeSquint", "left"),
        "mouth-corner-puller": ("mouthSmile", ""),
        "nose-right-dilatation": ("nostrilDilate", "right"),
    },
    "series": {"identity042": ("identity", ""), "viseme_PP": ("viseme", ""), "phalanx": None, "sculpt": None},
}


@pytest.mark.parametrize("rig", sorted(_RIGS))
def test_names_are_read_as_their_convention_means_them(rig):
    expected = _RIGS[rig]
    found = meanings(list(expected))
    assert {
        name: each and (each.action.name, each.side) for name, each in zip(expected, found, strict=True)
    } == expected


def test_a_number_is_an_action_unit_only_among_action_units():
    alone = meanings(["12", "smile", "jawOpen", "browUp"])[0]
    assert alone is None


def test_a_word_that_all_names_share_says_nothing():
    prefixed = meanings([f"face_mouth.{name}" for name in _ARKIT.split()])
    assert [each and each.action.name for each in prefixed] == [
        each and each.action.name for each in meanings(_ARKIT.split())
    ]


def test_a_side_glued_to_a_known_word_comes_off_and_a_known_word_stays_whole():
    assert words("LbrowUp") == ("l", "brow", "up")
    assert words("Lower_Lip") == ("lower", "lip")


def test_the_axes_of_a_joystick_have_two_ends_each():
    ends = {}
    for each in meanings([f"eyeLook{way}_L" for way in ("Up", "Down", "In", "Out")] + ["lookLeft", "lookRight"]):
        ends.setdefault(each.action.axis, set()).add(each.action.pole)
    assert all(ends[axis] == {-1, 1} for pair in joysticks().values() for axis in pair)
