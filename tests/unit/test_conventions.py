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
        "Fcl_EYE_Joy_L": ("eyeMood", ""),
        "Fcl_HA_Fung1": ("teeth", ""),
        "Fcl_ALL_Joy": ("emotion", ""),
        "emotion_Disgust": ("emotion", ""),
        "happy_surprise70": ("emotion", ""),
    },
    "FACS": {"1": ("browInnerUp", ""), "L12": ("mouthSmile", "left"), "AU43R": ("eyeBlink", "right")},
    "VRM": {"A": ("viseme", ""), "Joy": ("emotion", ""), "Blink_L": ("eyeBlink", "left"), "LookUp": ("eyeLookUp", "")},
    "Character Creator": {
        "Brow_Raise_Inner_L": ("browInnerUp", "left"),
        "Eye_R_Look_Up": ("eyeLookUp", "right"),
        "V_Explosive": ("viseme", ""),
        "Mouth_Roll_In_Upper_L": ("mouthRollUpper", "left"),
        "Mouth_L": ("mouthLeft", ""),
        "Eye_L_Look_R": ("eyeLookRight", "left"),
        "Mouth_Tighten_L": ("mouthTighten", "left"),
    },
    "Meta and Unified Expressions": {
        "EyesLookRightL": ("eyeLookRight", "left"),
        "EyesLookLeftL": ("eyeLookLeft", "left"),
        "LeftEyeturnRight": ("eyeLookRight", "left"),
        "LipPressorL": ("mouthPress", "left"),
        "LowerLipDepressorR": ("mouthLowerDown", "right"),
        "LipSuckLB": ("mouthSuck", "left"),
        "MouthCornerPullLeft": ("mouthSmile", "left"),
        "MouthRaiserLower": ("mouthShrugLower", ""),
        "NasalDilationRight": ("nostrilDilate", "right"),
    },
    "MetaHuman": {
        "CTRL_expressions_mouthFunnelUL": ("mouthFunnel", "left"),
        "CTRL_expressions_jawClenchR": ("jawClench", "right"),
        "CTRL_expressions_mouthLipsBlowL": ("mouth", "left"),
        "CTRL_expressions_eyeRelaxL": ("eye", "left"),
        "CTRL_expressions_mouthLipsTogetherDR": ("mouthClose", "right"),
    },
    "Mixamo": {
        "MouthNarrow_Left": ("mouthNarrow", "left"),
        "Midmouth_Right": ("mouthRight", ""),
        "NoseScrunch_Left": ("noseSneer", "left"),
    },
    "action units with their names": {
        "AU27_MouthStretch": ("jawOpen", ""),
        "AU_12_LipCornerPuller_L": ("mouthSmile", "left"),
        "AA_VI_01_PP": ("viseme", ""),
    },
    "without capitals": {
        "jawopen": ("jawOpen", ""),
        "eyelookinleft": ("eyeLookIn", "left"),
        "mouthrolllower": ("mouthRollLower", ""),
        **dict.fromkeys(("visemee", "visemeoh"), ("viseme", "")),
        "lowercase": None,
    },
    "Faceshift": {
        "EyeIn_L": ("eyeLookIn", "left"),
        "BrowsU_C": ("browInnerUp", ""),
        "BrowsD_R": ("browDown", "right"),
        "LipsTogether": ("mouthClose", ""),
    },
    "Daz": {
        "eCTRLvAA": ("viseme", ""),
        "eCTRLEyesClosedL": ("eyeBlink", "left"),
        "eCTRLLipBottomDownL": ("mouthLowerDown", "left"),
        "eCTRLMouthSideL": ("mouthLeft", ""),
    },
    "VRChat": {"vrc.v_aa": ("viseme", ""), "vrc.blink_left": ("eyeBlink", "left")},
    "MikuMikuDance": {
        "まばたき": ("eyeBlink", ""),
        "まばたき左": ("eyeBlink", "left"),
        "ウィンク右": ("eyeBlink", "right"),
        "ｳｨﾝｸ２右": ("eyeBlink", "right"),
        **dict.fromkeys(("あ", "あ２", "お"), ("viseme", "")),
        "なごみ": ("eyeMood", ""),
        "にやり２": ("mouthSmile", ""),
    },
    "an alphabet that the table does not know": {"закрыть_L": None, "眼_L": None},
    "Preston Blair": dict.fromkeys(("AI", "W_Q", "CDGKNRSThYZ", "Rest"), ("viseme", "")),
    "deformers of several meshes": {
        "blendShape1_jawOpen": ("jawOpen", ""),
        "blendShape12_eyeBlinkLeft": ("eyeBlink", "left"),
        "shape_012": None,
    },
    "MakeHuman": {
        "eye-left-slit": ("eyeSquint", "left"),
        "mouth-corner-puller": ("mouthSmile", ""),
        "nose-right-dilatation": ("nostrilDilate", "right"),
    },
    "letters that count": dict.fromkeys(("targetA", "targetB", "targetC", "targetE", "targetF")),
    "people": {"Identity_NoseLength": ("identity", ""), "id_004": ("identity", ""), "id_card": None},
    "series": {"identity042": ("identity", ""), "viseme_PP": ("viseme", ""), "phalanx": None, "sculpt": None},
}


@pytest.mark.parametrize("rig", sorted(_RIGS))
def test_names_are_read_as_their_convention_means_them(rig):
    expected = _RIGS[rig]
    found = meanings(list(expected), numbers=True)
    assert {
        name: each and (each.action.name, each.side) for name, each in zip(expected, found, strict=True)
    } == expected


def test_a_number_is_an_action_unit_only_among_action_units():
    assert meanings(["12", "smile", "jawOpen", "browUp"], numbers=True)[0] is None
    assert not any(meanings(["12", "15", "26", "4"]))


def test_what_stands_before_the_last_dot_or_colon_is_the_owner_of_the_name():
    """Each mesh and deformer has its own; a side behind a dot is none, and an axis of a joint neither."""
    read = meanings(["h_teeth.AE_AA", "geo:jawOpen", "brow.down.L", "ah", "12_a", "jaw:rx", "h_teeth.smile_L", "m:r_3"])
    told = ["viseme", "jawOpen", "browDown", "viseme", None, "jaw", "mouthSmile", "viseme"]
    assert [each and each.action.name for each in read] == told
    assert {each.side for each in meanings(["brow.down.L", "brow.L_1"])} == {"left"}


def test_the_version_of_a_sculpt_behind_its_name_says_nothing():
    assert meanings(["Angry_v2", "jawOpen_V01"]) == meanings(["Angry", "jawOpen"])


def test_a_word_that_all_names_share_says_nothing():
    prefixed = meanings([f"face_mouth.{name}" for name in _ARKIT.split()])
    assert [each and each.action.name for each in prefixed] == [
        each and each.action.name for each in meanings(_ARKIT.split())
    ]


def test_a_word_that_says_whose_names_they_are_says_nothing_beside_names_of_another_maker():
    vroid = {"Fcl_MTH_A": "viseme", "Fcl_BRW_Joy": "browMood", "Fcl_MTH_Up": "mouthUp", "Fcl_MTH_Down": "mouthDown"}
    daz = {"facs_ctrl_vAA": "viseme", "facs_bs_JawOpen": "jawOpen", "facs_ctrl_MouthSmile": "mouthSmile"}
    others = {"facs_ctrl_JawForward": "jawForward", "facs_ctrl_BrowDown": "browDown", "Fcl_EYE_Close_L": "eyeBlink"}
    costumes = dict.fromkeys(("coat_a", "coat_b", "coat_c"))
    expected = {**vroid, **daz, **others, **dict.fromkeys(_ARKIT.split(), ...), **costumes}
    found = meanings(list(expected))
    wanted = {name: action for name, action in expected.items() if action is not ...}
    assert {n: e and e.action.name for n, e in zip(expected, found, strict=True) if n in wanted} == wanted


def test_a_side_glued_to_a_known_word_comes_off_and_a_known_word_stays_whole():
    assert words("LbrowUp") == ("l", "brow", "up")
    assert words("Lower_Lip") == ("lower", "lip")


def test_the_axes_of_a_joystick_have_two_ends_each():
    ends = {}
    for each in meanings([f"eyeLook{way}_L" for way in ("Up", "Down", "In", "Out")] + ["lookLeft", "lookRight"]):
        ends.setdefault(each.action.axis, set()).add(each.action.pole)
    assert all(ends[axis] == {-1, 1} for pair in joysticks().values() for axis in pair)


def test_a_word_for_the_middle_is_no_control_of_both_sides():
    found = meanings(["Lips_Dn_Lower_M", "mouthLowerDown_C", "Lips_Dn_Lower_Left", "browInnerUp", "m", "mbp"])
    assert [each.middle for each in found] == [True, True, False, False, False, False]
