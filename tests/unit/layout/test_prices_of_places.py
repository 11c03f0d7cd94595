"""What a place costs: of a group the worst member counts, of a middle element the way to the plane."""

import chain
import makers
import numpy as np
import pytest

POINTS, QUADS = makers.mask()
PLAIN = {"occlusion_price": 0.0, "beside_global": False, "beside_composite": False}


def test_of_two_unlike_members_the_lesser_displacement_counts():
    """Two bumps of unlike height, a little apart: which of the two moves less changes from place to place."""
    shapes = {
        "up": makers.bump(POINTS, (0.0, -0.4), (0, 1, 0), 0.4, 0.10),
        "out": makers.bump(POINTS, (0.0, -0.5), (0, 0, 1), 0.4, 0.09),
    }
    line = chain.posed(
        makers.rig(POINTS, QUADS, shapes),
        chain.settings(
            candidates={**PLAIN, "prune_at": 0.0, "peak_share": 0.2, "occlusion": False},
            symmetry={"plane_price": 0.0},
            objective={"relative_displacement": 0.0},
            groups={"groups": {"both": ["up", "out"]}},
        ),
    )
    (variable,) = line.problem.variables
    arcs = np.stack(
        [m.arc_length[np.searchsorted(m.points, variable.points)] for m in line.context.trajectories.motions]
    )
    assert (arcs[0] < arcs[1]).any()
    assert (arcs[1] < arcs[0]).any()
    unit = line.context.trajectories.typical_length
    left = line.context.trajectories.base[variable.points][:, 0] >= 0.0  # the other side pays to break the tie
    assert variable.cost[left] == pytest.approx(-0.85 * arcs.min(axis=0)[left] / unit, rel=1e-6)
    assert variable.displacement == pytest.approx(arcs.min(axis=0) / unit, rel=1e-6)


@pytest.mark.parametrize(("price", "on_plane"), [(0.1, True), (0.0, False)])
def test_a_middle_element_stands_on_the_plane_for_a_price(price, on_plane):
    """It moves a little more at both sides than on the plane."""
    both = sum(makers.bump(POINTS, (side * 0.3, -0.4), (0, 1, 0), 0.2, 0.10) for side in (-1.0, 1.0))
    shape = both + makers.bump(POINTS, (0.0, -0.4), (0, 1, 0), 0.2, 0.09)
    rig = makers.rig(POINTS, QUADS, {**makers.face_shapes(POINTS), "press": shape})
    line = chain.lay_out(rig, chain.settings(candidates=PLAIN, symmetry={"plane_price": price}))
    anchor = chain.by_name(line)["press"].anchor
    assert not anchor.beside
    assert (abs(anchor.position[0]) < 1e-6) == on_plane


@pytest.mark.parametrize("kept_apart", [True, False])
def test_handles_that_want_one_place_are_kept_a_width_apart_by_constraint(kept_apart):
    """With the whole weight on displacement no overlap costs anything: only the constraint parts them."""
    shapes = {
        "one": makers.bump(POINTS, (0.3, 0.3), (0, 1, 0), 0.3, 0.10),
        "other": makers.bump(POINTS, (0.3, 0.35), (1, 0, 0), 0.3, 0.10),
    }
    line = chain.lay_out(
        makers.rig(POINTS, QUADS, shapes),
        chain.settings(
            candidates=PLAIN,
            groups={"opposed": False},
            objective={"displacement_weight": 1.0, "separation": kept_apart, "handle_size": 0.3, "handle_crowd": 0.0},
        ),
    )
    one, other = (each.anchor for each in line.layout.elements)
    assert not one.beside
    assert not other.beside
    assert (np.linalg.norm(one.position - other.position) >= line.layout.handle_width) == kept_apart
