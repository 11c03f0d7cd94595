"""Which control of ict_face57 is which of vitruvian, by eye: two makers with words of their own."""

SIDES = ("Left", "Right")
PAIRS = {
    "browDown": "Eyebrows_Lower",
    "browInnerUp": "Eyebrows_InnerBrow_Raised",
    "browOuterUp": "Eyebrows_OuterBrow_Raised",
    "cheekRaiser": "Cheeks_Raised",
    "eyeBlink": "Eyes_Closed",
    "eyeLookDown": "Look_Dwn",
    "eyeLookIn": "Look_In",
    "eyeLookOut": "Look_Out",
    "eyeLookUp": "Look_Up",
    "eyeWide": "Eyes_Opened_Max",
    "mouthDimple": "Lips_Dimple",
    "mouthLowerDown": "Lips_Dn_Lower",
    "mouthSmile": "Smile_Lips_Closed",
    "mouthStretch": "Lips_Dn_Corner_Wide",
    "noseSneer": "Nostrils_Corners_Raise_GLOBAL",
    "PupilDilate": "Pupil_Dilation",
}
CROSSED = {"mouthFrown": "Frown", "mouthUpperUp": "Lips_Up_Raised"}
"""The other maker calls these by the side of the viewer."""
MIDDLE = {
    "jawForward": "Jaw_Out",
    "jawOpen": "Jaw_Lower",
    "mouthLeft": "Mouth_Closed_Move_Left",
    "mouthRight": "Mouth_Closed_Move_Right",
    "mouthRollLower": "Lips_Dn_In",
    "mouthRollUpper": "Lips_Up_In",
    "mouthShrugLower": "Chin_Raised",
    "mouthPucker": "Kiss",
}
NAMES = {
    **{f"{theirs}_{side[0]}": f"{ours}_{side}" for theirs, ours in PAIRS.items() for side in SIDES},
    **{
        f"{theirs}_{side[0]}": f"{ours}_{other}"
        for theirs, ours in CROSSED.items()
        for side, other in zip(SIDES, SIDES[::-1], strict=True)
    },
    **MIDDLE,
}
ALSO = {"mouthRollLower": "Lips_Dn_Bite", "mouthRollUpper": "Lips_Up_Bite"}
"""As good: *In* presses the lip a little, *Bite* rolls it in as far as the others do, with the teeth on it."""
APART = {"mouthStretch_L", "mouthStretch_R"}
"""Named so for want of a counterpart: Lips_Dn_Corner_Wide draws the lower lip straight down, a fifth as far as
mouthStretch draws the corner to the side."""
