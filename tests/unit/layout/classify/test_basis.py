"""Which controls are atoms is decided for all at once: a cheap set that explains the rest."""

from itertools import combinations

import numpy as np
import pytest

from usdrigui.layout.classify.basis import EXPLAINED, best_sum, choose_basis


def cosines(vectors):
    unit = vectors / np.linalg.norm(vectors, axis=1, keepdims=True)
    return unit @ unit.T


def chosen(vectors, costs=None, twins=None):
    count = len(vectors)
    costs = np.ones(count) if costs is None else np.asarray(costs, dtype=float)
    twins = np.full(count, -1) if twins is None else np.asarray(twins)
    return choose_basis(cosines(vectors), costs, twins)


E = np.eye(6)


def test_a_sum_of_two_is_no_atom_and_says_of_which():
    basis = chosen(np.stack([E[0], E[1], E[0] + E[1], E[2]]))
    assert basis.atoms.tolist() == [True, True, False, True]
    assert sorted(basis.explanations[2].parts.tolist()) == [0, 1]
    assert basis.explanations[2].share == pytest.approx(1.0, abs=1e-3)


@pytest.mark.parametrize("keep", [0, 1, 2])
def test_of_copies_the_cheapest_is_the_atom_and_only_one(keep):
    costs = np.full(3, 1.0)
    costs[keep] = 0.5
    basis = chosen(np.stack([E[0], 2.0 * E[0], 0.5 * E[0]]), costs)
    assert np.flatnonzero(basis.atoms).tolist() == [keep]
    assert all(each.parts.tolist() == [keep] for each in basis.explanations.values())


def test_a_negative_cost_keeps_a_control_that_others_explain_unless_it_repeats_one():
    vectors = np.stack([E[0], E[1], E[0] + E[1], 3.0 * (E[0] + E[1])])
    assert chosen(vectors, [1.0, 1.0, -1.0, -2.0]).atoms.tolist() == [True, True, False, True]


def test_a_sum_that_explains_a_dear_one_is_no_atom_where_its_own_parts_explain_that_too():
    vectors = np.stack([E[0], E[1], E[0] + E[1], 0.5 * (E[0] + E[1])])
    assert chosen(vectors, [-1.0, -1.0, 1.0, 4.0]).atoms.tolist() == [True, True, False, False]


@pytest.mark.parametrize("cost", [1.0, -1.0])
def test_two_are_one_only_where_they_hardly_differ(cost):
    assert chosen(np.stack([E[0], E[0] + 0.15 * E[1]]), [cost, cost]).atoms.sum() == 2
    assert chosen(np.stack([E[0], E[0] + 0.05 * E[1]]), [cost, cost]).atoms.sum() == 1


@pytest.mark.parametrize("beside", [0.25, 0.45])
def test_a_sculpt_of_its_own_near_a_sum_of_others_is_an_atom(beside):
    """With the names of none of them known: a kiss was sent away as nine tenths of twelve others."""
    assert chosen(np.stack([E[0], E[1], E[0] + E[1] + beside * E[2]]), [1.0, 1.0, 1.1]).atoms[2] == (beside > 0.3)


def test_twins_are_atoms_together():
    left, right = E[0] + 0.05 * E[2], E[1] + 0.05 * E[2]
    vectors = np.stack([left, right, left + right])
    for twins in ([1, 0, 2], [-1, -1, -1]):
        atoms = chosen(vectors, [1.0, 1.0, 0.2], twins).atoms
        assert atoms[0] == atoms[1]


def test_explanations_end_at_atoms_whatever_chains_there_are():
    """x is nearly y, y is nearly z: judged one by one each is explained by the next, and nobody is left."""
    angles = np.radians([0.0, 9.0, 18.0, 27.0])
    basis = chosen(np.stack([np.cos(angles), np.sin(angles)], axis=1))
    assert {*basis.explanations} == {*np.flatnonzero(~basis.atoms)}
    assert all(basis.atoms[explanation.parts].all() for explanation in basis.explanations.values())


@pytest.mark.parametrize("seed", range(6))
def test_no_cheaper_set_explains_the_rest(seed):
    random = np.random.default_rng(seed)
    base = E[:3] + 0.3 * np.abs(random.normal(size=(3, 6)))
    sums = np.stack([base[a] + base[b] for a, b in combinations(range(3), 2)])
    vectors = np.concatenate([base, sums])[random.permutation(6)]
    costs = 1.0 + random.random(6)
    basis, cosine = chosen(vectors, costs), cosines(vectors)

    def explains(atoms):
        flags = np.isin(np.arange(6), atoms)
        for i in np.flatnonzero(~flags):
            found = best_sum(i, flags, cosine)
            squares = np.square(found.weights)
            parts = squares.sum() ** 2 / max(np.square(squares).sum(), 1e-300)
            if not (found.share >= EXPLAINED and parts >= 1.8):
                return False
        return True

    cheapest = min(
        costs[list(atoms)].sum() for size in range(1, 7) for atoms in combinations(range(6), size) if explains(atoms)
    )
    assert costs[basis.atoms].sum() == pytest.approx(cheapest)


def test_the_order_of_controls_does_not_matter():
    random = np.random.default_rng(3)
    vectors = np.concatenate([random.normal(size=(4, 9)), np.zeros((2, 9))])
    vectors[4], vectors[5] = vectors[0] + vectors[1], vectors[2] + vectors[3]
    costs, order = 1.0 + random.random(6), random.permutation(6)
    plain, shuffled = chosen(vectors, costs), chosen(vectors[order], costs[order])
    assert shuffled.atoms.tolist() == plain.atoms[order].tolist()
