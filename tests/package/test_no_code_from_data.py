"""Nothing that a file holds is ever executed or unpacked: no module of the package has the means."""

import ast
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "usdrigui"
MODULES = sorted(PACKAGE.rglob("*.py"))
CALLS = {"eval", "exec", "compile", "__import__", "extract", "extractall", "unpack_archive", "system", "popen"}
"""Names of functions and methods; `re.compile` alone is harmless."""
IMPORTS = {"pickle", "cPickle", "dill", "cloudpickle", "marshal", "shelve", "joblib", "yaml"}


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_a_module(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Call):
            called = ast.unparse(node.func)
            assert called == "re.compile" or called.rpartition(".")[2] not in CALLS, f"line {node.lineno}: {called}"
            named = {each.arg: ast.unparse(each.value) for each in node.keywords}
            assert named.get("allow_pickle", "False") == "False", f"line {node.lineno}"
            assert named.get("shell", "False") == "False", f"line {node.lineno}"
        elif isinstance(node, (ast.Import, ast.ImportFrom)):
            names = [node.module or ""] if isinstance(node, ast.ImportFrom) else [each.name for each in node.names]
            assert not {name.partition(".")[0] for name in names} & IMPORTS, f"line {node.lineno}"
