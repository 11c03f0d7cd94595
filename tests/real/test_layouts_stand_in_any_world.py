"""Real rigs in other worlds: a hundred times larger, Z-up, moved, or with shapes that move the whole head."""

from functools import cache

import numpy as np
import pytest
from real_rigs import (
    ASSETS,
    asset,
    homes,
    laid_out,
    line_of,
    on_face,
    point_of,
    referring,
    with_whole_head_shapes,
)
from rig_copies import WORLDS, turned

from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

WHOLE = {"headUp", "headSize", "headWide", "headFuller", "hideEarrings"}
pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not ASSETS.is_dir(), reason=f"needs the real rigs in {ASSETS}"),
]


PROVED = Settings().solve.work_limit


def anchors(line):
    """Where every element on the face stands, by its controls: mesh and point, and for one that acts on both sides
    the mirror image of that point too, for a layout and its mirror image cost the same."""
    partner, starts = line.face.symmetry.partner, line.face.rig.body.starts
    found = {}
    for element in on_face(line):
        at = point_of(line, element)
        both = {at, int(partner[at])} if element.side == "middle" else {at}
        meshes = np.searchsorted(starts, sorted(both), side="right") - 1
        found[element.controls] = frozenset(
            (int(mesh), point - int(starts[mesh])) for mesh, point in zip(meshes, sorted(both), strict=True)
        )
    return found


@cache
def proved(name):
    """Every record of one rig's layout, solved within the gap."""
    (rig,) = read_rigs(asset(name), Settings())
    return laid_out(rig, PROVED)


# --- size, axes and place ----------------------------------------------------------------------------


def test_a_face_of_joints_that_lies_on_its_back_has_the_same_anchors():
    (rig,) = read_rigs(asset("mh_poseunits"), Settings())
    assert anchors(laid_out(turned(rig, WORLDS["on its back"](None)))) == anchors(line_of("mh_poseunits"))


@pytest.mark.parametrize("z_up", [False, True], ids=["y-up", "z-up"])
@pytest.mark.parametrize("name", ["godette", "mh_expr34", "ict_face57"])
def test_a_shot_that_scales_and_turns_the_asset_gives_the_same_anchors(name, z_up, tmp_path):
    (rig,) = read_rigs(referring(name, tmp_path, 100.0, z_up), Settings())
    assert rig.path == "/Shot/Char"
    assert rig.up == pytest.approx([0, 1, 0]), "the character's own space is still Y-up"
    assert anchors(laid_out(rig, PROVED)) == anchors(proved(name))


# --- whole-head and hide shapes ----------------------------------------------------------------------


@cache
def with_whole_head(name):
    """Of shapes alone: a body under the face is a part of its own."""
    plain = line_of(name, "none")
    base = plain.face.surface.points
    moved = np.zeros(len(base), dtype=bool)
    for motion, said in zip(plain.face.trajectories.motions, plain.inputs.measured.classification, strict=True):
        if said.category != "global":
            moved[motion.points] = True
    return laid_out(with_whole_head_shapes(plain.face.rig, base, moved))


@pytest.mark.parametrize("name", ["godette", "mh_expr34", "ict_face57"])
def test_whole_head_and_hide_shapes_stand_beside_the_face(name):
    found = homes(with_whole_head(name))
    own = {control for control, element in homes(line_of(name, "none")).items() if element.category == "global"}
    assert {control for control, element in found.items() if element.category == "global"} == WHOLE | own
    assert all(found[control].anchor.on_board and found[control].reason for control in WHOLE)


# --- visibility, by another way of looking -----------------------------------------------------------


# --- jaws and eyes -----------------------------------------------------------------------------------


def test_eyes_and_jaws_of_other_makers_share_elements_too():
    gaze = homes(line_of("godette"))["look_up"]
    assert gaze.controls == {
        "look_up",
        "look_down",
        "look_left",
        "look_right",
    }
    assert gaze.kind == "patch"
    vitruvian = homes(line_of("vitruvian"))
    for side in ("Left", "Right"):
        eye = {vitruvian[f"Look_{way}_{side}"] for way in ("In", "Out", "Dwn", "Up")}
        assert [(each.kind, len(each.opposed)) for each in eye] == [("patch", 2)]
    assert vitruvian["Look_Up_Left"] is not vitruvian["Look_Up_Right"]
    assert vitruvian["Jaw_Out"] is vitruvian["Jaw_back"]
    assert vitruvian["Jaw_Out"].kind == "slider"


def test_elements_of_several_ways_drive_them_from_one_handle():
    """The conventions make a joystick of the gaze, and a slider of the jaw's two sides (decision 112)."""
    ict = homes(line_of("ict_face57"))
    gaze, jaw = ict["eyeLookUp_L"], ict["jawLeft"]
    assert (gaze.kind, len(gaze.members), len(gaze.opposed)) == ("patch", 4, 2)
    assert (jaw.kind, len(jaw.members), len(jaw.opposed)) == ("slider", 2, 1)
    assert jaw is ict["jawRight"]
    for element in (gaze, jaw):
        starts = [member.track[int(np.argmin(np.abs(member.values)))] for member in element.members]
        assert np.ptp(starts, axis=0).max() < 1e-6 * line_of("ict_face57").face.surface.face_size
