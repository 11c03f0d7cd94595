"""Stages say what they read: no record of the layout that holds everything is passed around (decision 106)."""

import ast
from collections import Counter
from pathlib import Path

import pytest

PACKAGE = Path(__file__).resolve().parents[2] / "usdrigui"
FIELDS, FUNCTIONS = 5, 10


TOGETHER = [("layout", "pipeline"), ("cli", "clients"), ("pose",), ("solve",), ("view",)]
"""Folders whose functions pass each other's records."""


def parsed(folders):
    for folder in folders:
        for path in sorted((PACKAGE / folder).rglob("*.py")):
            yield ast.parse(path.read_text(encoding="utf-8"))


def bags(trees):
    """Records with more than five fields that are parameters of more than ten functions."""
    nodes = [node for tree in trees for node in ast.walk(tree)]
    classes = [node for node in nodes if isinstance(node, ast.ClassDef)]
    large = {each.name for each in classes if sum(isinstance(line, ast.AnnAssign) for line in each.body) > FIELDS}
    taken = Counter()
    for node in nodes:
        if isinstance(node, ast.FunctionDef):
            arguments = (*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs)
            words = {word for each in arguments if each.annotation for word in ast.walk(each.annotation)}
            taken.update({word.id for word in words if isinstance(word, ast.Name)} & large)
    return {name for name, count in taken.items() if count > FUNCTIONS}


@pytest.mark.parametrize("folders", TOGETHER)
def test_no_record_holds_everything(folders):
    assert bags(parsed(folders)) == set()


def test_a_record_that_holds_everything_is_found():
    fields = "\n".join(f"    f{i}: int" for i in range(FIELDS + 1))
    functions = "\n".join(f"def g{i}(bag: Bag | None): ..." for i in range(FUNCTIONS + 1))
    assert bags([ast.parse(f"class Bag:\n{fields}\n{functions}")]) == {"Bag"}
    assert bags([ast.parse(f"class Bag:\n{fields}\n" + functions.replace("Bag", "int"))]) == set()


def test_tests_of_the_layout_stand_in_the_folders_of_its_packages():
    tests, packages = PACKAGE.parent / "tests" / "unit" / "layout", PACKAGE / "layout"
    folders = {path.parent.relative_to(tests) for path in tests.rglob("test_*.py")}
    assert len(folders) > 8
    assert [str(folder) for folder in folders if not (packages / folder / "__init__.py").is_file()] == []
