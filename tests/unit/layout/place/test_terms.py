"""Element-model occlusion as a cost: a trajectory's tangent against the surface normal (paper section 3.3)."""

import chain
import makers
import numpy as np
import pytest

from usdrigui.layout.place.terms import linear_cost, occlusion

SIDE = 11
PRICE = 0.15


def sheet(direction_at, ranges=None):
    """A flat sheet facing +z, every point of which moves by ``direction_at(points)``."""
    x, y = np.meshgrid(np.linspace(-1, 1, SIDE), np.linspace(-1, 1, SIDE))
    points = np.stack([x, y, np.zeros_like(x)], axis=-1).reshape(-1, 3)
    return makers.rig(points, makers.quads(SIDE, SIDE), {"move": 0.3 * direction_at(points)}, ranges)


def costs(rig, **candidates):
    settings = chain.settings(candidates=candidates)
    face = chain.face_of(rig, settings)
    motion = face.trajectories.motions[0]
    own = occlusion(face.surface.normals, motion, motion.points, settings.candidates.occlusion_weight)
    return own, linear_cost(face, motion, motion.points, settings)


@pytest.mark.parametrize(
    ("direction", "share"), [((0, 0, 1), 0.0), ((0, 0, -1), 1.0), ((1, 0, 0), 0.5), ((0, 1, 1), 0.5 - 0.5 * 0.5**0.5)]
)
def test_the_cost_grows_from_out_of_the_surface_to_into_it(direction, share):
    unit = np.array(direction) / np.linalg.norm(direction)
    own, total = costs(sheet(lambda points: np.tile(unit, (len(points), 1))))
    assert own == pytest.approx(np.full(SIDE * SIDE, PRICE * share), abs=1e-6)
    assert total == pytest.approx(own), "it is part of the linear cost of candidates"


def test_both_directions_count_where_the_control_goes_both_ways():
    own, _ = costs(sheet(lambda points: np.tile([0.0, 0.0, 1.0], (len(points), 1)), {"move": (-1.0, 1.0)}))
    assert own == pytest.approx(np.full(SIDE * SIDE, 0.5 * PRICE), abs=1e-6)


def test_the_weight_is_a_setting():
    own, _ = costs(sheet(lambda points: np.tile([0.0, 0.0, -1.0], (len(points), 1))), occlusion_weight=0.6)
    assert own == pytest.approx(np.full(SIDE * SIDE, 0.6), abs=1e-6)


def test_of_equal_places_the_one_where_the_track_comes_out_is_taken():
    """The right half of the sheet comes forward as far as the left half sinks; nothing else tells them apart."""

    def halves(points):
        return np.where(points[:, :1] > 0.0, 1.0, -1.0) * np.array([0.0, 0.0, 1.0])

    settings = chain.settings(candidates={"occlusion": False, "board_global": False}, symmetry={"enabled": False})
    (element,) = chain.lay_out(sheet(halves), settings).layout.elements
    assert element.anchor.position[0] > 0.0
    assert not element.anchor.on_board
