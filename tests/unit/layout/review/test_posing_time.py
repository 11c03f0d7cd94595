"""The model of a person's seconds: worked by hand, its laws, and what it says beside the paper's figures."""

import re
from math import log2

import numpy as np
import pytest

from usdrigui.cli import main
from usdrigui.clients.study import PAPER
from usdrigui.layout.review.posing_time import predicted


def test_seconds_of_two_handles_and_two_rows_by_hand():
    found = predicted(np.array([[0, 0], [18, 24]]), np.array([100]), 10, 2)
    by_list, beside, face = np.array([*found.values()]) / 30
    # 3 (1.2 + .23) + .2 of thoughts, looks, a button; Hick of 2 handles; it is 3 widths away, the end of its drag 7.
    assert face[1] == pytest.approx(4.49 + 0.15 * log2(3) + 5 / 4.3)
    assert beside - face == pytest.approx([0.14, 0.46, 1.4])
    # One and a half rows, and the eye goes there and back; a row is 23 pixels high, a drag .7 of 78, a thumb 10.
    assert by_list[1] == pytest.approx(4.49 + 0.23 * 3.5 + log2(3.3 * 6.46) / 4.3)
    # A page has 27 rows: half of as many again to look at, and a key half of the time.
    one, two = (times(rows=rows)[0][1] / 30 for rows in (27, 54))
    assert two - one == pytest.approx(0.23 * 13.5 + 0.28 / 2, abs=0.02)


def times(count=40, near=1, width=1, rows=80):
    places = np.linspace(0, 640 * near, 40)[:count, None]
    return [*predicted(places, places, width, rows).values()]


@pytest.mark.parametrize("less", [{"count": 9}, {"near": 0.8}, {"width": 2}, {"rows": 79}])
def test_fewer_larger_nearer_handles_never_take_longer(less):
    change = np.subtract(times(**less), times())
    assert change.max() <= 0 > change.min()


def test_shares_of_time_on_the_sample_are_within_three_points_of_the_papers(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for command in ("sample .", "process char.usda", "check char.rigui.usda"):
        main(command.split())
    found = np.array(re.findall(r"(\d+) s \(", capsys.readouterr().out), float)
    assert 100 * found / found.sum() == pytest.approx([*PAPER["share of time, %"].values()], abs=3)
