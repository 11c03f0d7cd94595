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
    assert {(each.kind, each.old, each.new) for each in made} == changes
    for each in made:
        assert ast.dump(ast.parse(each.applied(text))) != ast.dump(ast.parse(text))


def test_the_same_seed_draws_the_same_mutants_of_all_kinds_alike(job):
    first = job.drawn(["layout", "pose"], 8, 3)
    assert first == job.drawn(["layout", "pose"], 8, 3)
    assert first != job.drawn(["layout", "pose"], 8, 4)
    assert sorted(each.kind for each in first[:4]) == ["arithmetic", "choice", "comparison", "number"]


def test_a_file_answers_to_the_tests_of_its_name_first_then_to_the_laws(job):
    found = job.tests_of("usdrigui/layout/group/grouping.py")
    assert found[0] == "tests/unit/layout/group/test_grouping.py"
    assert found[-2:] == job.LAWS["layout"]
    assert all((ROOT / each).exists() for each in found)
