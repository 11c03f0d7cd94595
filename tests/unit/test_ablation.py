"""The comparison of layouts with parts of the objective left out: rows on a small face, and their figures."""

import csv
import io
from pathlib import Path
from types import SimpleNamespace

import makers
import numpy as np
import pytest
import scripts
from folders import ROOT

from usdrigui.pipeline import build_problem
from usdrigui.settings import load

SCRIPT = ROOT / "benchmarks" / "ablation.py"


@pytest.fixture(scope="module")
def ablation():
    with scripts.loaded(SCRIPT) as module:
        yield module


@pytest.fixture(scope="module")
def ready():
    return build_problem(makers.face(17, 21), load({"objective": {"handle_size": 0.1}}))


@pytest.fixture(scope="module")
def rows(ablation, ready):
    found = ablation.ablation(ready, ["random", "peak only", "centroid", "20 %"])
    return {row.name: row for row in found}


def test_no_row_beats_the_bound_of_the_full_one(rows):
    assert len(rows) == 5
    assert all(np.isfinite(row.cost) and row.cost >= rows["full"].bound - 1e-9 for row in rows.values())
    assert rows["full"].cost < rows["centroid of influence"].cost
    assert rows["full"].cost < rows["random"].cost


def test_peaks_keep_most_and_the_full_layout_keeps_handles_apart(rows):
    assert rows["peak only"].kept == max(row.kept for row in rows.values())
    assert rows["peak only"].kept > rows["random"].kept
    assert rows["full"].nearest >= 1.0
    assert rows["peak only"].nearest < 1.0


def test_one_command_leaves_table_and_picture(ablation, ready, tmp_path, capsys, monkeypatch):
    found = SimpleNamespace(rigs=(ready.face.rig,))
    monkeypatch.setattr(ablation, "read_rigs_isolated", lambda *_: found)
    ablation.compare(Path("face.usda"), ["random", "peak"], 2.0, tmp_path)
    assert sorted(each.name for each in tmp_path.iterdir()) == [f"ablation_face.{end}" for end in ("csv", "md", "png")]
    table = csv.DictReader(io.StringIO((tmp_path / "ablation_face.csv").read_text()))
    assert [row["row"] for row in table] == ["random", "peak only", "full"]
    printed = capsys.readouterr().out.splitlines()
    assert "full" in printed[1], "first come, first printed"
    assert len(printed) == 5
