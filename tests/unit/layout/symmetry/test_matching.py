"""Which controls are matched as twins: all at once, of greatest agreement in sum."""

import networkx as nx
import numpy as np
import pytest

from usdrigui.layout.symmetry.twins import greatest_matching


@pytest.mark.parametrize("seed", range(40))
def test_a_matching_weighs_as_much_as_edmonds_finds(seed):
    """Few weights for many pairs, so that they tie, or weights all different; groups that are tried and larger ones."""
    rng = np.random.default_rng(seed)
    nodes, most = int(rng.integers(2, 16)), int(rng.choice([4, 10**9]))
    pairs = [(i, j) for i in range(nodes) for j in range(i + 1, nodes) if rng.random() < 2.5 / nodes]
    weights = {pair: int(rng.integers(1, most)) for pair in pairs}
    graph = nx.Graph()
    graph.add_weighted_edges_from((i, j, weight) for (i, j), weight in weights.items())
    matched = [tuple(sorted(pair)) for pair in greatest_matching(weights)]
    assert len({node for pair in matched for node in pair}) == 2 * len(matched)
    assert sum(weights[pair] for pair in matched) == sum(
        graph.edges[pair]["weight"] for pair in nx.max_weight_matching(graph)
    )


def test_small_groups_are_matched_without_edmonds_and_the_first_of_equals_wins(monkeypatch):
    monkeypatch.setattr(nx, "max_weight_matching", None)
    twins = {(i, i + 1): 190 - i for i in range(0, 20, 2)}
    alone = {(i, -1 - i): 90 - i for i in range(20)}
    assert sorted(greatest_matching(twins | alone)) == sorted(twins)
    assert greatest_matching({(0, 1): 3, (1, 2): 3}) == [(0, 1)]
    assert greatest_matching({(1, 2): 3, (0, 1): 3}) == [(1, 2)]
