"""The mutation job changes what it says, and runs the tests of the file that it changed."""

import ast
from pathlib import Path

import pytest
import scripts

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def job():
    with scripts.loaded(ROOT / "benchmarks" / "mutants.py") as module:
        yield module


def test_a_mutant_of_every_kind_differs_in_one_expression(job, tmp_path, monkeypatch):
    monkeypatch.setattr(job, "ROOT", tmp_path)
    path = tmp_path / "code.py"
    path.write_text('def f(a: int) -> int:\n    "é"; return max(a[0] - 2, 3) < 4\n', encoding="utf-8")
    text = path.read_text(encoding="utf-8")
    changes = {
        ("number", "0", "1"),
        ("number", "2", "3"),
        ("number", "3", "4"),
        ("number", "4", "5"),
        ("comparison", "<", "<="),
        ("arithmetic", "-", "+"),
        ("choice", "max", "min"),
        ("choice", "0", "-1"),
    }
    made = list(job.mutants(path))
    assert job.marked("code.py", made).startswith("from usdrigui._seen import")
    assert {(each.kind, each.old, each.new) for each in made} == changes
    for each in made:
        assert ast.dump(ast.parse(each.applied(text))) != ast.dump(ast.parse(text))


def test_a_mutant_answers_to_the_tests_that_reach_it_those_of_its_file_first(job, tmp_path, monkeypatch):
    monkeypatch.setattr(job, "ROOT", tmp_path)
    path = tmp_path / "code.py"
    path.write_text("from __future__ import annotations\n\nLEAST = 3\n\n\ndef f(a):\n    return a[0] > LEAST\n")
    constant, compared, *_ = sorted(job.mutants(path), key=lambda each: (each.line, each.kind))
    marked = job.marked("code.py", [constant, compared])
    assert "LEAST = (_place_seen(*['code.py:: number 3 -> 4 in LEAST = 3 #1']) or (3))" in marked
    assert "    _place_seen('code.py:f')\n    return (_place_seen(" in marked
    ast.parse(marked)
    places = [each.place for each in (constant, compared)]
    told = tmp_path / "told"
    told.write_text(
        f"S {places[0]}\nT laws/test_law.py::one\nS code.py:f\nS {places[1]}\nE 0.5\n"
        f"T laws/test_law.py::failed\nS {places[1]}\nT a/test_far.py::far\nS code.py:f\nS {places[1]}\nE 0.4\n"
        f"T a/test_code.py::two\nS code.py:f\nS {places[1]}\nE 3\nT laws/test_law.py::three\nE 1\n"
    )
    reached = job.Reached.read([told])
    for mutant in (constant, compared):
        assert reached.by(mutant, 60.0) == ["a/test_code.py::two", "laws/test_law.py::one", "a/test_far.py::far"]
        assert reached.by(mutant, 3.2) == ["a/test_code.py::two"]
