"""Layers of the real rigs, baked by UsdSkel: every handle is centred on its deformed anchor."""

from __future__ import annotations

from pathlib import Path

import laid_out
import numpy as np
import pytest
from pxr import Sdf

from usdrigui.layer.read_layout import read_layout
from usdrigui.layer.write_layout import stage_metadata, write_layout
from usdrigui.reading.character import read_rigs
from usdrigui.settings import OutputSettings, Settings

ASSETS = Path(__file__).resolve().parents[3] / "shared" / "assets"
RIGS = sorted(path for path in ASSETS.glob("*") if path.suffix in (".usda", ".usdc"))

pytestmark = [
    pytest.mark.real,
    pytest.mark.skipif(not RIGS, reason=f"no rigs in {ASSETS}"),
]


@pytest.mark.parametrize("source", RIGS, ids=lambda path: path.stem)
def test_handles_are_centred_on_their_deformed_anchors(tmp_path, source):
    rigs = read_rigs(source, Settings())
    layouts = [laid_out.layout_of(rig, seed=12) for rig in rigs]
    target = tmp_path / "layout.rigui.usdc"
    metadata = stage_metadata(Sdf.Layer.FindOrOpen(str(source)))
    write_layout(list(zip(rigs, layouts, strict=True)), source, target, OutputSettings(), metadata)
    assert [len(back.elements) for back in read_layout(target)] == [len(layout.elements) for layout in layouts]
    layer = Sdf.Layer.FindOrOpen(str(target))
    for rig, layout in zip(rigs, layouts, strict=True):
        rng = np.random.default_rng(13)
        poses = [laid_out.random_values(rig, rng) for _ in range(2)]
        stage = laid_out.baked(layer, rig, poses)
        worst = _worst_miss(stage, rig, layout, len(poses))
        assert len(layout.elements) > 0.9 * len(rig.controls)
        assert worst < 1e-5, rig.skel_root.path


def _worst_miss(stage, rig, layout, poses):
    """Largest distance of a handle from its anchor, as a share of the diagonal of the character."""
    worst = 0.0
    for time in range(poses):
        points = {
            mesh.path: laid_out.root_points(stage, mesh.path, rig.skel_root.path, time) for mesh in rig.body.meshes
        }
        everything = np.concatenate(list(points.values()))
        diagonal = np.linalg.norm(np.ptp(everything, axis=0))
        for element in layout.elements:
            centre = laid_out.handle(stage, rig.skel_root.path, element, time)[0]
            miss = np.linalg.norm(centre - points[element.anchor.mesh][element.anchor.point])
            worst = max(worst, float(miss / diagonal))
    return worst
