"""Rays: both casters against geometry that can be worked out by hand, and against each other."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest

from usdrigui.character.rays import (
    Caster,
    EmbreeCaster,
    TreeCaster,
    blocked,
    hidden_share,
    make_caster,
    visible_from,
)

HAS_EMBREE = importlib.util.find_spec("embreex") is not None
NEEDS_EMBREE = pytest.mark.skipif(not HAS_EMBREE, reason="embreex not installed")
METHODS = [TreeCaster, pytest.param(EmbreeCaster, marks=NEEDS_EMBREE)]


def sphere(rows: int = 40, radius: float = 1.0, centre: tuple[float, float, float] = (0, 0, 0)) -> np.ndarray:
    """(t, 3, 3) triangles of a sphere by latitude and longitude."""
    lat, lon = np.meshgrid(np.linspace(0, np.pi, rows + 1), np.linspace(0, 2 * np.pi, 2 * rows + 1), indexing="ij")
    points = radius * np.stack([np.sin(lat) * np.cos(lon), np.cos(lat), np.sin(lat) * np.sin(lon)], axis=-1)
    points += np.array(centre)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    return np.concatenate([np.stack([a, c, b], -2).reshape(-1, 3, 3), np.stack([a, d, c], -2).reshape(-1, 3, 3)])


def random_directions(count: int) -> np.ndarray:
    found = np.random.default_rng(4).normal(size=(count, 3))
    return found / np.linalg.norm(found, axis=1, keepdims=True)


@pytest.fixture(params=METHODS)
def ball(request: pytest.FixtureRequest) -> Caster:
    return request.param(sphere())


def test_hits_the_near_side_of_a_sphere_at_its_distance(ball: Caster) -> None:
    starts = np.array([[0.3, 0.1, -5.0], [0.0, 0.0, -5.0], [0.9, 0.9, -5.0], [0.1, 0.2, 5.0]])
    hits = ball.first_hits(starts, np.array([0.0, 0.0, 1.0]))
    assert hits.triangle[2] == -1
    assert hits.triangle[3] == -1
    assert np.isinf(hits.distance[2:]).all()
    assert hits.distance[:2] == pytest.approx([5 - np.sqrt(1 - 0.1), 4.0], abs=5e-3)
    corners = sphere()[hits.triangle[0]]
    assert np.abs(corners - [0.3, 0.1, -0.9]).max() < 0.2


def test_half_of_a_sphere_faces_the_viewer_and_is_seen(ball: Caster) -> None:
    normals = random_directions(500)
    toward = np.array([0.3, -0.5, 0.8])
    expected = normals @ toward > 0
    clear = np.abs(normals @ toward) > 0.1
    assert (visible_from(ball, normals, normals, toward) == expected)[clear].all()


@pytest.mark.parametrize("method", METHODS)
def test_a_wall_in_front_hides_and_one_behind_does_not(method: type[Caster]) -> None:
    wall = np.array([[[-3, -3, 2], [3, -3, 2], [0, 4, 2.0]]])
    caster = method(np.concatenate([sphere(), wall]))
    point, normal = np.array([[0.0, 0.0, 1.0]]), np.array([[0.0, 0.0, 1.0]])
    assert not visible_from(caster, point, normal, np.array([0.0, 0.0, 1.0]))[0]
    assert visible_from(caster, point, normal, np.array([0.9, 0.0, 0.1]))[0]
    assert visible_from(caster, -point, -normal, np.array([0.0, 0.0, -1.0]))[0]


def test_points_without_a_normal_are_judged_by_the_ray_alone(ball: Caster) -> None:
    points = np.array([[0.0, 0.0, 1.01], [0.0, 0.0, -1.01]])
    assert visible_from(ball, points, np.zeros((2, 3)), np.array([0.0, 0.0, 1.0])).tolist() == [True, False]


def test_the_share_of_a_path_inside_the_surface_is_hidden(ball: Caster) -> None:
    steps = np.linspace(0, 1, 5)
    inward = np.array([0.0, 0.0, 1.0]) - steps[:, None] * np.array([0.0, 0.0, 0.5])
    outward = np.array([0.0, 0.0, 1.0]) + steps[:, None] * np.array([0.0, 0.0, 0.5])
    shares = hidden_share(ball, np.stack([inward, outward]), np.array([[0.0, 0, 1], [0, 0, 1]]), np.array([0.0, 0, 1]))
    assert shares == pytest.approx([0.8, 0.0])


@NEEDS_EMBREE
def test_the_two_casters_agree() -> None:
    soup = np.concatenate([sphere(30, 0.2 + 0.1 * i, tuple(at)) for i, at in enumerate(random_directions(6))])
    rng = np.random.default_rng(1)
    starts = rng.uniform(-1.5, 1.5, (4000, 3))
    embree, tree = EmbreeCaster(soup), TreeCaster(soup)
    for toward in random_directions(5):
        one, other = embree.first_hits(starts, toward), tree.first_hits(starts, toward)
        met = (one.triangle >= 0) & (other.triangle >= 0)
        assert ((one.triangle >= 0) == (other.triangle >= 0)).mean() > 0.999
        assert one.distance[met] - other.distance[met] == pytest.approx(0, abs=1e-3)
        assert (one.triangle == other.triangle)[met].mean() > 0.999


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("scale", [1e-3, 1e4])
def test_visibility_does_not_depend_on_scale_or_place(method: type[Caster], scale: float) -> None:
    normals = random_directions(200)
    toward = np.array([0.2, 0.3, 0.9])
    soup = np.concatenate([sphere(), sphere(20, 0.5, (0.3, 0.3, 1.5))])
    shift = np.array([50.0, -20.0, 7.0])
    here = visible_from(method(soup), normals, normals, toward)
    there = visible_from(method((soup + shift) * scale), (normals + shift) * scale, normals, toward)
    assert (here == there).mean() > 0.99


def test_the_fall_back_is_exact_in_small_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    soup, starts, toward = sphere(), random_directions(300) * 2, np.array([0.1, 0.7, 0.2])
    whole = TreeCaster(soup).first_hits(starts, toward)
    monkeypatch.setattr("usdrigui.character.rays._PAIRS", 50)
    pieces = TreeCaster(soup).first_hits(starts, toward)
    assert (whole.triangle == pieces.triangle).all()
    assert (whole.distance == pieces.distance).all()


def test_one_ray_alone_and_none_at_all(ball: Caster) -> None:
    toward = np.array([0.0, 1.0, 0.0])
    assert blocked(ball, np.array([[0.1, -3.0, 0.1]]), toward).tolist() == [True]
    assert blocked(ball, np.empty((0, 3)), toward).shape == (0,)


def test_an_empty_soup_hides_nothing() -> None:
    caster = make_caster(np.empty((0, 3, 3)))
    assert caster.size == 0.0
    assert not blocked(caster, np.zeros((3, 3)), np.array([0.0, 0.0, 1.0])).any()


def test_edge_on_triangles_hide_nothing() -> None:
    sliver = np.array([[[0.0, -1, -1], [0.0, 1, -1], [0.0, 0, 1]]])
    assert not blocked(TreeCaster(sliver), np.array([[0.0, 0.0, -5.0]]), np.array([0.0, 0.0, 1.0])).any()


def test_numpy_casts_where_embree_is_not_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("usdrigui.character.rays.find_spec", lambda _: None)
    assert isinstance(make_caster(sphere()), TreeCaster)
