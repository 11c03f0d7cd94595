"""The catalogue: every issue code has one smallest trigger that calls for it, and golden.json holds what it ends in.

Exit code and paths alone: words are in one place, usdrigui/codes.toml or the line that raises them.
To add a code: an edit in minimal_assets.py or a trigger in triggers.py, then
``USDRIGUI_GOLDEN=write pytest tests/catalogue`` and a look at the new line of golden.json.
"""

import ast
import json
import os
import re
from pathlib import Path

import pytest
import triggers

import usdrigui
from usdrigui.errors import Exit, catalogue

GOLDEN = Path(__file__).parent / "golden.json"
WRITE = os.environ.get("USDRIGUI_GOLDEN") == "write"
PYTHONS_WORDS = re.compile(r"\bNone\b|\bnan\b| object at |<class |\{\w*\}")
"""What a message says when a value was put into it that nobody had."""


def golden():
    return json.loads(GOLDEN.read_text(encoding="utf-8"))


def write(reports):
    lines = (f"  {json.dumps(code)}: {json.dumps(reports[code], ensure_ascii=False)}" for code in sorted(reports))
    GOLDEN.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")


def test_no_code_lacks_an_occasion():
    lacking = sorted(set(catalogue()) - set(triggers.TRIGGERS))
    assert not lacking, f"add the smallest trigger for {lacking} to tests/catalogue/triggers.py"
    assert not sorted(set(triggers.TRIGGERS) - set(catalogue())), "codes are never removed"


def test_no_golden_report_is_left_over():
    assert list(golden()) == sorted(catalogue())


@pytest.mark.parametrize("code", triggers.TRIGGERS)
def test_its_golden_report(code, tmp_path, monkeypatch):
    exit_code, issues = triggers.TRIGGERS[code](tmp_path, monkeypatch)
    monkeypatch.undo()
    found = [each for each in issues if each["code"] == code]
    assert found, f"the trigger calls for {[each['code'] for each in issues]}"
    report = {"exit": exit_code, "paths": [each["path"].replace(str(tmp_path), "FOLDER") for each in found]}
    if WRITE:
        write(golden() | {code: report})
    assert report == golden()[code]
    for each in found:
        assert (each["repair"], each["severity"]) == (catalogue()[code].repair, catalogue()[code].severity)
        assert each["message"].splitlines() == [each["message"]]
        assert not PYTHONS_WORDS.search(each["message"])


@pytest.mark.parametrize("code", catalogue())
def test_its_entry_is_sound(code):
    entry = catalogue()[code]
    assert entry.repair
    assert entry.meaning.endswith(".")
    assert entry.exit in set(Exit) - {Exit.OK}


def test_what_refuses_is_documented_as_an_error():
    source = Path(usdrigui.__file__).parent
    calls = [call for path in source.rglob("*.py") for call in ast.walk(ast.parse(path.read_text())) if _refuses(call)]
    assert len(calls) > 100
    assert not {code for code in map(_code, calls) if code and catalogue()[code].severity != "error"}


def _refuses(node):
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "refuse"


def _code(call):
    return call.args[0].value if isinstance(call.args[0], ast.Constant) else ""
