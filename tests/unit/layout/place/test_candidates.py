"""Where controls may be anchored."""

import chain
import makers
import numpy as np
import pytest
from makers import POINTS, QUADS, SHAPES


def test_pruning_keeps_what_moves_more_than_the_mean_and_half_the_peak():
    line = chain.with_candidates(makers.face())
    motion = line.face.trajectories.motions[0]
    kept = chain.set_of(line, "brow_L").points
    arc = dict(zip(motion.points.tolist(), motion.arc_length.tolist(), strict=True))
    least = max(motion.arc_length.mean(), 0.5 * motion.arc_length.max())
    assert all(arc[point] >= least for point in kept.tolist())
    assert motion.points[np.argmax(motion.arc_length)] in kept


def test_pruning_follows_its_settings():
    def size(**parts):
        return len(chain.chosen(makers.face(), candidates=parts)("brow_L").points)

    assert size(peak_share=0.9) < size() < size(peak_share=0.0, prune_at=0.5)


def test_split_points_give_one_candidate_per_place():
    seam = np.flatnonzero(np.isclose(POINTS[:, 0], 0.0))
    doubled = np.vstack([POINTS, POINTS[seam]])
    shapes = {name: np.vstack([each, each[seam]]) for name, each in SHAPES.items()}
    found = chain.chosen(makers.rig(doubled, QUADS, shapes))("pucker")
    assert (found.points < len(POINTS)).all()


def test_a_control_that_peaks_inside_stands_on_the_skin_it_moves():
    found = chain.chosen(makers.face_with_teeth(skin_moves=0.7, name="inside"))("inside")
    assert found.category != "hidden"
    assert (found.points < len(POINTS)).all()


def test_only_what_can_be_seen_from_the_view_is_a_candidate():
    assert chain.chosen(makers.face(), candidates={"view": "90,0"})("smile_R").category == "hidden"
    assert chain.chosen(makers.face(), candidates={"view": "-90,0"})("smile_R").category != "hidden"


@pytest.mark.parametrize(("outward", "inside"), [(0.07, True), (0.095, False)])
def test_a_trajectory_into_the_skin_is_drawn_where_others_keep_much_less(outward, inside):
    """A corner of the mouth that is drawn back runs into the cheek."""
    draws = makers.bump(POINTS, (0.35, -0.3), (0, 0, -1), 0.2, 0.1)
    lifts = makers.bump(POINTS, (0.35, 0.3), (0, 0, 1), 0.2, outward)
    found = chain.chosen(makers.face_with(both=draws + lifts))("both")
    assert (POINTS[found.points, 1] < 0.0).any() == inside


@pytest.mark.parametrize(("share", "on_skin"), [(1.0, True), (0.5, False)])
def test_a_strand_holds_no_handle_where_the_skin_moves_enough(share, on_skin):
    strand = 0.05 * makers.TEETH + np.array([1.0, 0.0, 0.8])
    found = chain.chosen(makers.face_with_teeth(share, name="inside", at=strand))("inside")
    assert (found.points < len(POINTS)).all() == on_skin


@pytest.mark.parametrize(("share", "among"), [(0.75, True), (0.6, False)])
def test_what_lifts_an_ear_too_stands_among_the_others_where_that_keeps_enough(share, among):
    lifts = makers.bump(POINTS, (0.75, 0.95), (0, 1, 0), 0.2) + makers.bump(
        POINTS, (0.35, 0.5), (0, share, 0), 0.2, 0.1 * share
    )
    found = chain.chosen(makers.face_with(target=lifts))("target")
    assert (POINTS[found.points, 1] > 0.75).any() != among
