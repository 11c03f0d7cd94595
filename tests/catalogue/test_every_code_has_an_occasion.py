"""The catalogue: every issue code has one smallest occasion that calls for it, and a golden report of it.

To add a code: an edit in smallest.py or an occasion in occasions.py, then
``USDRIGUI_GOLDEN=write pytest tests/catalogue`` and a look at the new file under golden/.
"""

from __future__ import annotations

import ast
import json
import os
import re
from pathlib import Path

import occasions
import pytest

import usdrigui
from usdrigui.errors import CODES, Exit

GOLDEN = Path(__file__).parent / "golden"
WRITE = os.environ.get("USDRIGUI_GOLDEN") == "write"
IN_USDS_WORDS = {"FILE_NOT_USD", "LAYER_MISSING", "LAYER_UNREADABLE", "COMPOSITION_ERROR"}
IN_USDS_WORDS |= {"USD_DIAGNOSTIC", "USD_ERROR", "LAYOUT_VERSION"}
"""Their messages are not ours, or name a version: any text will do."""
FRESH = {"SOURCE_READER_LOST", "SOURCE_CRASHES_USD", "SOURCE_TIME_LIMIT", "SOURCE_MEMORY_LIMIT"}
"""Read by a real child of its own."""


def test_no_code_lacks_an_occasion():
    lacking = sorted(set(CODES) - set(occasions.OCCASIONS))
    assert not lacking, f"add the smallest occasion for {lacking} to tests/catalogue/occasions.py"
    assert not sorted(set(occasions.OCCASIONS) - set(CODES)), "codes are never removed"


def test_no_golden_report_is_left_over():
    assert {each.stem for each in GOLDEN.glob("*.json")} == set(CODES)


@pytest.mark.parametrize("code", occasions.OCCASIONS)
def test_its_golden_report(code, tmp_path, monkeypatch, request):
    if code in FRESH:
        request.getfixturevalue("fresh_readers")
    exit_code, issues = occasions.OCCASIONS[code](tmp_path, monkeypatch)
    monkeypatch.undo()
    report = {"exit": exit_code, "issues": [_anonymous(each, tmp_path) for each in issues if each["code"] == code]}
    assert report["issues"], f"the occasion calls for {[each['code'] for each in issues]}"
    path = GOLDEN / f"{code}.json"
    if WRITE:
        path.write_text(json.dumps(report, indent=2, ensure_ascii=False) + "\n", encoding="utf-8")
    assert report == json.loads(path.read_text(encoding="utf-8"))


@pytest.mark.parametrize("code", CODES)
def test_its_entry_is_sound(code):
    entry = CODES[code]
    (golden,) = json.loads((GOLDEN / f"{code}.json").read_text(encoding="utf-8"))["issues"][:1]
    assert golden["repair"] == entry.repair
    assert golden["severity"] == entry.severity
    assert entry.meaning.endswith(".")
    assert entry.exit in set(Exit) - {Exit.OK}


def test_what_refuses_is_documented_as_an_error():
    source = Path(usdrigui.__file__).parent
    calls = [call for path in source.rglob("*.py") for call in ast.walk(ast.parse(path.read_text())) if _refuses(call)]
    assert len(calls) > 100
    assert not {code for code in map(_code, calls) if code and CODES[code].severity != "error"}


def _refuses(node):
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "refuse"


def _code(call):
    return call.args[0].value if isinstance(call.args[0], ast.Constant) else ""


def _anonymous(found, folder):
    """An issue without the place where the test ran, and without the words of others."""
    clean = {key: value.replace(str(folder), "FOLDER") for key, value in found.items()}
    assert all(clean[key] for key in ("code", "severity", "message", "repair"))
    clean["message"] = re.sub(r"\(\w+\.py:\d+\)", "(PLACE)", clean["message"])
    if found["code"] in IN_USDS_WORDS:
        clean["message"] = "..."
    return clean
