"""ARCHITECTURE.md names files and tests that exist."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")


def test_every_file_named_exists():
    named = set(re.findall(r"\b((?:tests/|docs/)?[a-z_]+(?:/[a-z_0-9-]+)*\.(?:py|md))\b", PAGE))
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
