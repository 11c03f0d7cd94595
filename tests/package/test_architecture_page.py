"""ARCHITECTURE.md is one page and names files and tests that exist, each file by the noun of its paragraph."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")


def test_every_file_named_exists():
    named = set(re.findall(r"\b((?:tests/|docs/)?[a-z_]+(?:/[a-z_0-9.-]+)*\.(?:py|md|js))\b", PAGE))
    places = (ROOT, ROOT / "usdrigui", ROOT / "tests" / "unit" / "layout")
    missing = [name for name in named if not any((place / name).exists() for place in places)]
    assert [name for name in missing if not list(ROOT.glob(f"*/{name}"))] == []


def test_every_test_named_exists():
    source = "\n".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests").rglob("test_*.py"))
    named = set(re.findall(r"\b(test_[a-z_0-9]+)\b(?!\.py|\*)", PAGE))
    assert named
    assert [name for name in sorted(named) if f"def {name}(" not in source] == []


def test_every_decision_named_exists():
    known = {path.name[:3] for path in (ROOT / "docs" / "decisions").glob("*.md")}
    assert set(re.findall(r"\b(0\d\d)\b", PAGE)) <= known


ROWS = re.findall(r"^\| (?:\d|[\d., ]+) \| (.+?) \| `([^`|]+)` \| [^|]+ \|$", PAGE, re.MULTILINE)
"""Paragraph and file of each row about the paper."""


def test_each_paragraph_names_one_file_by_its_noun():
    assert len(ROWS) > 25
    assert len({path for _, path in ROWS}) == len(ROWS), "one file, one paragraph"
    for paragraph, path in ROWS:
        (noun,) = re.findall(r"\*\*(.+?)\*\*", paragraph)
        assert noun.replace(" ", "_") in Path(path).stem, (noun, path)


def test_it_is_one_page_with_one_figure():
    assert len(PAGE.splitlines()) < 100
    assert len(PAGE.replace("|", " ").split()) <= 800
    assert PAGE.count("```") == 2
