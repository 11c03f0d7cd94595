"""What a file's arrays must hold."""

import numpy as np
import pytest

from usdrigui.errors import RigUIError
from usdrigui.stages.arrays import check_finite, check_range


def test_one_number_that_is_not_finite_is_told_by_its_place():
    for bad in (np.nan, np.inf, -np.inf):
        with pytest.raises(RigUIError, match=r"points\[1\] is not a finite"):
            check_finite(np.array([[1.0, 2, 3], [4, bad, 6], [bad, 8, 9]]), "/Mesh", "points")
    check_finite(np.full((2, 3), 1e200), "/Mesh", "points")  # its squares are beyond all measure


@pytest.mark.parametrize("indices", [[0, 3, 2], [-1, 0], [2, -2, 7]])
def test_indices_lie_from_nothing_to_one_less_than_the_count(indices):
    wrong = next(each for each in indices if not 0 <= each < 3)
    with pytest.raises(RigUIError, match=f"holds {wrong}; only 0 to 2 exist"):
        check_range(np.array(indices), 3, "/Mesh", "indices")
    check_range(np.array([0, 2]), 3, "/Mesh", "indices")
    check_range(np.zeros(0, dtype=np.int64), 0, "/Mesh", "indices")
