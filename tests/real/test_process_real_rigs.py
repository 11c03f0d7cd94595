"""The main job on real rigs: every control accounted for, handles apart, and on the skin when baked."""

import json

import laid_out
import numpy as np
import pytest
from folders import ASSETS
from pxr import Gf, Sdf, Usd, UsdSkel
from scipy.spatial.distance import cdist

from usdrigui import check
from usdrigui.cli import main
from usdrigui.layer.read_layout import read_layout
from usdrigui.model.levels import states
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

RIGS = sorted(path for path in ASSETS.glob("*") if path.suffix in (".usda", ".usdc"))
LIMIT = 3_000_000
"""Work after which the crowded rigs may stop: what is tested here does not need the last per cent."""

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not RIGS, reason=f"no rigs in {ASSETS}"),
]


@pytest.fixture(scope="module", params=RIGS, ids=lambda path: path.stem)
def run(request, tmp_path_factory):
    """(source, written layer, report document) of one rig."""
    folder = tmp_path_factory.mktemp(request.param.stem)
    layer, report = folder / "out.rigui.usda", folder / "out.json"
    options = ["--quiet", "-o", str(layer), "--report", str(report), "--set", f"solve.work_limit={LIMIT}"]
    assert main(["process", str(request.param), *options]) == 0
    return request.param, layer, json.loads(report.read_text())


def test_every_control_of_the_source_is_accounted_for(run):
    source, _, document = run
    for rig, character in zip(read_rigs(source, Settings()), document["characters"], strict=True):
        expected = {*rig.control_names} | {left.control for left in rig.left_off}
        assert {row["control"] for row in character["controls"]} == expected
        by_name = {element["name"]: element for element in character["elements"]}
        # Controls with a lobe on each side have a handle on each.
        doubled = {
            max(e["name"], e["mirror"])
            for e in by_name.values()
            if e["mirror"] and set(e["controls"]) == set(by_name[e["mirror"]]["controls"])
        }
        laid = [name for e in by_name.values() if e["name"] not in doubled for name in e["controls"]]
        assert len(laid) == len(set(laid)), "a control is in one element only"
        placed = {row["control"] for row in character["controls"] if row["place"] != "left off"}
        assert set(laid) == placed
        assert all(row["reason"] for row in character["controls"] if row["place"] != "face")


def test_the_bound_holds_and_handles_are_apart(run):
    """No place is better than a proven one.  Apart among elements that are visible together: members of a coarse one
    stand where others do that give way."""
    _, layer, document = run
    for character, layout in zip(document["characters"], read_layout(layer), strict=True):
        solution = character["solution"]
        assert solution["bound"] <= solution["cost"] + 1e-9
        elements, seen = [each for each in layout.elements if not each.anchor.on_board], states(layout.elements)
        spots = np.array([element.anchor.position for element in elements])
        alone = np.array([[a is b or seen[a.name].isdisjoint(seen[b.name]) for b in elements] for a in elements])
        apart = cdist(spots, spots) + alone * 1e30
        assert apart.min() >= character["handle_width"] * (1.0 - 1e-6)
    if all(each["solution"]["status"] == "optimal" for each in document["characters"]):
        assert "LAYOUT_BETTER_PLACE" not in {each.code for each in check(layer).issues}


def test_baked_handles_are_centred_on_their_anchors(run):
    source, layer_path, _ = run
    layer = Sdf.Layer.FindOrOpen(str(layer_path))
    rigs = {rig.path: rig for rig in read_rigs(source, Settings())}
    for layout in read_layout(layer_path):
        rig, rng = rigs[layout.root], np.random.default_rng(21)
        stage = laid_out.baked(layer, rig, [laid_out.random_values(rig, rng)])
        points = {mesh.path: laid_out.root_points(stage, mesh.path, rig.path, 0) for mesh in rig.body.meshes}
        diagonal = np.linalg.norm(np.ptp(np.concatenate(list(points.values())), axis=0))
        misses = [
            np.linalg.norm(
                laid_out.handle(stage, rig.path, element, 0)[0] - points[element.anchor.mesh][element.anchor.point]
            )
            for element in layout.elements
            if not element.anchor.on_board
        ]
        assert misses
        assert max(misses) < 1e-5 * diagonal


def test_check_doubts_no_pair_of_a_character_that_rests_in_a_pose(tmp_path):
    stage, posed = Usd.Stage.Open(str(ASSETS / "rpm_xr.usdc")), str(tmp_path / "posed.usda")
    skeleton = UsdSkel.Skeleton.Get(stage, "/RPM/Skel")
    # The left arm's joint is number 9.
    rest = skeleton.GetRestTransformsAttr().Get()
    rest[9] = Gf.Matrix4d().SetRotate(Gf.Rotation((0, 0, 1), 40)) * rest[9]
    skeleton.GetRestTransformsAttr().Set(rest)
    stage.Export(posed)
    assert (
        main(["process", "--quiet", posed]) == main(["check", "--strict", posed.replace(".usda", ".rigui.usda")]) == 0
    )
