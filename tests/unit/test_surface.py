"""usdrigui.character.surface: triangulation, normals, welding and distances on meshes small enough to reason about."""

import makers
import numpy as np
import pytest

from usdrigui.character import surface

SQUARE = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
"""Seen from +z, counter-clockwise."""


def split_strip():
    """Two squares side by side whose common edge is split: points 1, 2 and 4, 7 coincide."""
    points = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [1, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0]])
    return points, surface.triangles([4, 4], np.arange(8))


def test_polygons_become_fans_and_lines_nothing():
    corners = surface.triangles([3, 2, 5], [0, 1, 2, 8, 9, 3, 4, 5, 6, 7])
    assert corners.tolist() == [[0, 1, 2], [3, 4, 5], [3, 5, 6], [3, 6, 7]]
    assert surface.triangles([], []).shape == (0, 3)


@pytest.mark.parametrize(("order", "left_handed"), [([0, 1, 2, 3], False), ([3, 2, 1, 0], True)])
def test_normals_point_outward_for_both_orientations(order, left_handed):
    corners = surface.triangles([4], order, left_handed)
    assert np.allclose(surface.vertex_normals(SQUARE, corners, np.arange(4)), [0, 0, 1])


def test_normals_are_weighted_by_area():
    points = np.array([[0.0, 0, 0], [3, 0, 0], [0, 3, 0], [0, 0, 1]])
    corners = np.array([[0, 1, 2], [0, 2, 3]])
    assert np.allclose(surface.vertex_normals(points, corners, np.arange(4))[0], np.array([3.0, 0, 9]) / np.hypot(3, 9))


def test_a_point_without_triangles_has_no_normal():
    points = np.vstack([SQUARE, [5.0, 5, 5]])
    corners = surface.triangles([4], [0, 1, 2, 3])
    assert np.allclose(surface.vertex_normals(points, corners, np.arange(5))[4], 0)


def test_weld_joins_seams_and_normals_smooth_over_them():
    points, corners = split_strip()
    points = points.copy()
    points[[5, 6], 2] = -1.0
    places = surface.weld(points)
    assert places.tolist() == [0, 1, 2, 3, 1, 5, 6, 2]
    split, smooth = (surface.vertex_normals(points, corners, each) for each in (np.arange(8), places))
    assert not np.allclose(split[1], split[4])
    assert np.allclose(smooth[1], smooth[4])


def test_weld_keeps_apart_what_moves_apart():
    points = np.zeros((3, 3))
    assert surface.weld(points).tolist() == [0, 0, 0]
    assert surface.weld(points, np.array([[0.0], [1.0], [0.0]])).tolist() == [0, 1, 0]


def test_weld_does_not_depend_on_scale_or_offset():
    random = np.random.default_rng(1)
    points = random.normal(size=(50, 3))
    points[30:] = points[:20]
    assert np.array_equal(surface.weld(points), surface.weld(points * 1e-3 + 7.0))
    assert surface.weld(points)[30:].tolist() == list(range(20))


def test_edges_cross_seams_only_by_place():
    points, corners = split_strip()
    places = surface.weld(points)
    assert len(surface.edges(corners)) == 10
    assert len(surface.edges(places[corners])) == 9
    assert surface.mean_edge_length(points, corners, places) == pytest.approx((7 + 2 * np.sqrt(2)) / 9)
    assert len(set(surface.components(corners, np.arange(8)))) == 2
    assert len(set(surface.components(corners, places))) == 1


def test_areas_sum_to_the_surface_and_fall_to_the_first_point_of_a_place():
    points, corners = split_strip()
    places = surface.weld(points)
    area = surface.point_areas(points, corners, places)
    assert area.sum() == pytest.approx(2.0)
    assert area[[4, 7]].tolist() == [0.0, 0.0]


def test_ways_along_the_surface_are_little_longer_than_the_shortest():
    points, quads = makers.mask()
    points[:, 2] = 0.0
    corners = surface.triangles([4] * len(quads), np.ravel(quads))
    found = surface.surface_distances(points, corners, np.arange(len(points)), np.array([0]))
    straight = np.linalg.norm(points - points[0], axis=1)
    assert (found >= straight - 1e-12).all()
    assert (found <= 1.09 * straight + 1e-12).all()


def test_no_way_leads_to_another_piece_and_the_nearest_source_counts():
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 0, 0], [6, 0, 0], [5, 1, 0], [1, 0, 0], [2, 0, 0]])
    corners = np.array([[0, 1, 2], [3, 4, 5], [6, 7, 2]])
    places = np.array([0, 1, 2, 3, 4, 5, 1, 7])  # point 6 is point 1 at a seam
    found = surface.surface_distances(points, corners, places, np.array([0, 7]))
    assert found[[0, 1, 6, 7]].tolist() == [0.0, 1.0, 1.0, 0.0]
    assert np.isinf(found[3:6]).all()
