"""Products of displacement fields."""

import numpy as np
import pytest
from scipy.sparse import csr_array

from usdrigui.layout.motion import similarity


@pytest.mark.parametrize("share", [0.0, 0.05, 0.9])
def test_products_have_the_same_digits_sparse_and_dense(share, monkeypatch):
    random = np.random.default_rng(4)
    first, second = (
        (random.normal(size=(count, 3000)) * (random.random((count, 3000)) < share)).astype(np.float32)
        for count in (5, 7)
    )
    rows = csr_array(first), csr_array(second)
    found = []
    for least in (0.0, 1.0):
        monkeypatch.setattr(similarity, "_DENSE", least)
        found.append(similarity.inner_products(*rows))
    assert np.array_equal(*found)
    assert np.allclose(found[0], first.astype(np.float64) @ second.T, atol=1e-3)
