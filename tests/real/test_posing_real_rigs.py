"""Posing the real rigs: deformed meshes and handles equal UsdSkel's."""

from __future__ import annotations

from pathlib import Path

import laid_out
import numpy as np
import pytest
from usdskel_oracle import Oracle

from usdrigui.character.deform import channel_state
from usdrigui.pose.evaluate import evaluate, prepare
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings

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
        starts = dict(zip((mesh.path for mesh in rig.body.meshes), rig.body.starts.tolist(), strict=False))
        for element, at in zip(layout.elements, posed.elements, strict=True):
            anchor = expected[starts[element.anchor.mesh] + element.anchor.point]
            assert np.abs(at.handle - anchor).max() < 1e-5 * diagonal, element.name
