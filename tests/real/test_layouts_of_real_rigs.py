"""What a layout must be on real rigs: mirrored, visible, graspable, telling; whatever the search's limit."""

import re
from functools import partial

import numpy as np
import pytest
import real_rigs
from real_rigs import ASSETS, asset, homes, on_face, point_of

from usdrigui.layout.review.legibility import legibility_of
from usdrigui.pipeline import stages
from usdrigui.reading.character import read_rigs
from usdrigui.settings import load

line_of = partial(real_rigs.line_of, joints="none")
"""The layout of shapes and poses alone: a body would be of one part with its face."""
LIMBS = {"hands": "finger|thumb|index|pinky|hand(middle|ring)|f[23][ab]_", "feet": "toe"}
"""What joints of a limb are called, by the title of its part."""
RIGS = ("godette", "mh_expr34", "mh_poseunits", "ict_face57", "vitruvian")

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not ASSETS.is_dir(), reason=f"needs the real rigs in {ASSETS}"),
]


@pytest.mark.parametrize("name", RIGS)
def test_pairs_mirror_where_the_mesh_does(name):
    line = line_of(name)
    symmetry, elements = line.face.symmetry, {element.name: element for element in line.layout.elements}
    pairs = [(e, elements[e.mirror]) for e in on_face(line) if e.mirror]
    assert len(pairs) >= 2
    for one, other in pairs:
        assert not other.anchor.on_board
        assert other.mirror == one.name
        apart = float((one.anchor.position - symmetry.plane.origin) @ symmetry.plane.normal)
        image = one.anchor.position - 2.0 * apart * symmetry.plane.normal
        missed = float(np.linalg.norm(image - other.anchor.position)) / line.face.surface.face_size
        assert missed <= 5e-5, "the meshes of these rigs mirror everywhere"


@pytest.mark.parametrize("name", ["godette", "mh_poseunits", "rocketbox_male17", "rpm_xr", "vitruvian"])
def test_titles_name_the_limbs_of_nine_in_ten_joints(name):
    """By the names of the joints, which no part is known by."""
    (rig,) = read_rigs(asset(name), load({}))
    for part in stages.character_of(rig, load({})).parts:
        joints = [rig.controls[i].source.rsplit("/", 1)[-1] for i in part.controls if rig.controls[i].kind == "joint"]
        found = (
            next((t for t, limb in LIMBS.items() if re.search(limb, each, re.IGNORECASE)), None) for each in joints
        )
        told = [title == (part.name if part.name in LIMBS else None) for title in found]
        assert sum(told) >= 0.9 * len(told), part.name


@pytest.mark.parametrize("name", RIGS)
def test_no_anchor_is_invisible_from_front_and_three_quarters(name):
    line = line_of(name)
    seen = line.face.views.anywhere
    assert all(seen[point_of(line, element)] for element in on_face(line))


@pytest.mark.parametrize(("name", "least"), [(rig, 0.91 if rig == "ict_face57" else 0.85) for rig in RIGS])
def test_shapes_and_poses_keep_their_displacement_on_the_face(name, least):
    line = line_of(name)
    peaks = {line.face.rig.controls[m.control].name: m.arc_length.max() for m in line.face.trajectories.motions}
    kept = [member.arc_length / peaks[member.control] for element in on_face(line) for member in element.members]
    assert np.mean(kept) >= least
    assert len(kept) >= 0.7 * len(peaks)


def test_a_body_can_be_read_from_the_front():
    (rig,) = read_rigs(ASSETS / "usdwg_CesiumMan.usdz", load({}))
    line = real_rigs.laid_out(rig)
    assert legibility_of(line.face, line.layout.elements).clear > 0.9 * len(on_face(line))


def test_two_heads_of_one_convention_are_laid_out_with_the_same_elements():
    elements = [homes(line_of(name)) for name in ("ict_face57", "facecap_blender")]
    shared = sorted(set.intersection(*map(set, elements)))
    assert len(shared) > 40
    made = [{name: (each[name].anchor.on_board, each[name].controls) for name in shared} for each in elements]
    assert made[0] == made[1]


def test_shapes_that_hide_parts_stand_beside_the_face():
    found = homes(line_of("godette"))
    beside = {name for name, element in found.items() if element.category == "global"}
    assert beside == {"HideHairBalls", "HdieEarRings", "HideBlush"}


def test_eyes_share_joysticks_and_opposites_share_sliders():
    ict = homes(line_of("ict_face57"))
    assert ict["jawLeft"] is ict["jawRight"]
    assert len(ict["jawOpen"].members) == 1
    for side in "LR":
        assert len({ict[f"eyeLook{way}_{side}"].name for way in ("In", "Out", "Up", "Down")}) == 1
    assert ict["mouthLeft"] is ict["mouthRight"]
    assert ict["eyeBlink_L"] is ict["eyeWide_L"]
    assert ict["browDown_L"] is not ict["browDown_R"]
    poses = homes(line_of("mh_poseunits"))
    assert poses["LeftEyeturnLeft"] is poses["LeftEyeUp"]
    assert poses["ChinLeft"] is poses["ChinRight"]


@pytest.mark.parametrize(("category", "start"), [("hidden", "Pupil"), ("interior", "Tongue")])
def test_tongue_and_pupils_are_hidden(category, start):
    vitruvian = homes(line_of("vitruvian"))
    assert {name for name, element in vitruvian.items() if element.category == category} == {
        name for name in vitruvian if name.startswith(start)
    }


def test_visemes_and_emotions_stand_beside_and_atoms_do_not():
    vitruvian = homes(line_of("vitruvian"))
    composite = {name for name, element in vitruvian.items() if element.category in ("composite", "viseme", "emotion")}
    assert {"Happy", "Sad", "Scared", "Revulsion", "Disgusted", "er_05", "w_uw_07"} <= composite
    assert not {"Jaw_Out", "Eyes_Closed_Left", "Frown_Left", "Lips_Dn_In", "Eyebrows_Raised_Left"} & composite
    for other in ("godette", "mh_expr34", "mh_poseunits", "ict_face57"):
        assert not any(element.category == "composite" for element in line_of(other).layout.elements), other


@pytest.mark.parametrize(
    ("name", "control", "low", "high"),
    [
        ("ict_face57", "eyeBlink_L", 0.7, 0.9),
        ("ict_face57", "browOuterUp_L", 0.75, 1.0),
        ("ict_face57", "jawOpen", 0.0, 0.2),
        ("ict_face57", "mouthSmile_L", 0.2, 0.4),
        ("mh_poseunits", "JawDrop", 0.0, 0.45),
        ("mh_poseunits", "LeftUpperLidClosed", 0.6, 0.95),
        ("vitruvian", "Eyes_Closed_Left", 0.7, 0.93),
        ("vitruvian", "Jaw_Out", 0.0, 0.35),
    ],
)
def test_blink_on_the_lid_jaw_on_the_chin_brows_on_the_brows(name, control, low, high):
    """Heights of anchors between the lowest and the highest handle of the face."""
    line = line_of(name)
    up = line.face.rig.up
    heights = [float(element.anchor.position @ up) for element in on_face(line)]
    own = float(homes(line)[control].anchor.position @ up)
    share = (own - min(heights)) / (max(heights) - min(heights))
    assert low <= share <= high
