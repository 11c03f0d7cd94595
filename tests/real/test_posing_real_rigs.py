"""Posing the real rigs: deformed meshes and handles equal UsdSkel's, and pulls arrive."""

from __future__ import annotations

from pathlib import Path

import laid_out
import numpy as np
import pytest
from usdskel_oracle import Oracle

from usdrigui.deform import channel_state
from usdrigui.pose.direct import Feel, grab, solve
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.settings import Settings
from usdrigui.usd.rig import read_rigs

ASSETS = Path(__file__).resolve().parents[3] / "shared" / "assets"
RIGS = sorted(path for path in ASSETS.glob("*") if path.suffix in (".usda", ".usdc"))

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not RIGS, reason=f"no rigs in {ASSETS}"),
]


@pytest.mark.parametrize("source", RIGS, ids=lambda path: path.stem)
def test_points_and_handles_equal_usdskel(source):
    for rig in read_rigs(source, Settings()):
        layout = laid_out.layout_of(rig, seed=3)
        values = laid_out.random_values(rig, np.random.default_rng(4))
        posed = evaluate(prepare(rig, layout), values)
        expected = Oracle(source, rig).deformed(*channel_state(rig, values))
        diagonal = float(np.linalg.norm(np.ptp(expected, axis=0)))
        assert np.abs(posed.points - expected).max() < 1e-5 * diagonal
        starts = dict(zip((mesh.path for mesh in rig.meshes), rig.starts.tolist(), strict=False))
        for element, at in zip(layout.elements, posed.elements, strict=True):
            anchor = expected[starts[element.anchor.mesh] + element.anchor.point]
            assert np.abs(at.handle - anchor).max() < 1e-5 * diagonal, element.name


@pytest.mark.parametrize("source", RIGS, ids=lambda path: path.stem)
def test_a_pull_to_where_a_control_would_bring_the_point_arrives(source):
    (rig, *_) = read_rigs(source, Settings())
    layout = laid_out.layout_of(rig, seed=5)
    poser = prepare(rig, layout)
    rest = evaluate(poser)
    names = {control.name: index for index, control in enumerate(rig.controls)}
    missed = []
    for element in layout.elements[:: max(1, len(layout.elements) // 4)]:
        point = rig.starts[[mesh.path for mesh in rig.meshes].index(element.anchor.mesh)] + element.anchor.point
        values = layout.base_values.copy()
        control = rig.controls[names[element.name]]
        values[names[element.name]] = control.default + 0.6 * (control.maximum - control.default)
        goal = evaluate(poser, values).points[[point]]
        grip = grab(rig, layout.base_values, [int(point)], feel=Feel(stay=1e-3))
        answer = solve(grip, goal)
        low = np.array([each.minimum for each in rig.controls])
        high = np.array([each.maximum for each in rig.controls])
        assert ((answer.values >= low) & (answer.values <= high)).all()
        far = float(np.linalg.norm(goal - rest.points[point]))
        missed.append(float(np.linalg.norm(answer.reached[0] - goal)) / max(far, 1e-12))
    assert np.median(missed) < 0.05
