"""Statements one can read: comprehensions seldom stand in comprehensions."""

import ast
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2] / "usdrigui"
COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)
MOST = 2.0
"""Nested comprehensions in 1 000 lines."""


def nested(tree: ast.AST) -> list[int]:
    """Lines of the comprehensions inside a comprehension, each once."""
    found = []
    for outer in (node for node in ast.walk(tree) if isinstance(node, COMPREHENSIONS)):
        inside = list(ast.iter_child_nodes(outer))
        while inside:
            node = inside.pop()
            if isinstance(node, COMPREHENSIONS):
                found.append(node.lineno)
            elif not isinstance(node, ast.Lambda):
                inside += ast.iter_child_nodes(node)
    return sorted(found)


def test_it_sees_a_comprehension_inside_another():
    assert nested(ast.parse("[\n  [b for b in a]\n  for a in c]\n{d: f(e for e in d) for d in c}")) == [2, 4]
    assert nested(ast.parse("[b for a in c for b in a] + [sorted(a) for a in c]")) == []


def test_few_comprehensions_stand_in_another():
    text = {path: path.read_text(encoding="utf-8") for path in PACKAGE.rglob("*.py")}
    places = [f"{path.relative_to(PACKAGE)}:{line}" for path in text for line in nested(ast.parse(text[path]))]
    lines = sum(len(each.splitlines()) for each in text.values())
    assert len(places) <= MOST * lines / 1000, sorted(places)
