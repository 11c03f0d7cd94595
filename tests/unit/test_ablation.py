"""The comparison of layouts with parts of the objective left out: rows on a small face, and their figures."""

import importlib.util
import sys
from pathlib import Path

import makers
import numpy as np
import pytest

from usdrigui.pipeline import posed
from usdrigui.settings import load

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "ablation.py"


@pytest.fixture(scope="module")
def ablation():
    spec = importlib.util.spec_from_file_location("ablation", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    sys.modules["ablation"] = module
    spec.loader.exec_module(module)
    yield module
    del sys.modules["ablation"]


@pytest.fixture(scope="module")
def rows(ablation):
    ready = posed(makers.face(17, 21), load({"solve": {"threads": 1}, "objective": {"handle_size": 0.1}}))
    found = ablation.ablation(ready, ["random", "peak only", "centroid", "lambda 0.85", "20 %"])
    return {row.name: row for row in found}


def test_no_row_beats_the_bound_of_the_full_one(rows):
    assert len(rows) == 6
    assert all(np.isfinite(row.cost) and row.cost >= rows["full"].bound - 1e-9 for row in rows.values())
    assert rows["full"].cost < rows["centroid of influence"].cost
    assert rows["full"].cost < rows["random"].cost


def test_peaks_keep_most_and_the_full_layout_keeps_handles_apart(rows):
    assert rows["peak only"].kept == max(row.kept for row in rows.values())
    assert rows["peak only"].kept > rows["random"].kept
    assert rows["full"].nearest >= 1.0
    assert rows["peak only"].nearest < 1.0


def test_the_default_weight_is_the_full_layout(rows):
    assert rows["lambda 0.85"].cost == pytest.approx(rows["full"].cost, rel=2e-4)


def test_the_table_has_a_line_for_every_row(ablation, rows):
    lines = ablation.table("face", list(rows.values())).splitlines()
    assert len(lines) == 1 + len(rows)
    assert all(name in line for name, line in zip(rows, lines[1:], strict=True))
