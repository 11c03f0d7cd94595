"""ARCHITECTURE.md is one page and names files that exist, each file by the noun of its paragraph."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8")


def test_every_file_named_exists():
    named = set(re.findall(r"\b((?:tests/|docs/)?[a-z_]+(?:/[a-z_0-9.-]+)*\.(?:py|md|js))\b", PAGE))
    places = (ROOT, ROOT / "usdrigui", ROOT / "tests" / "unit" / "layout")
    missing = [name for name in named if not any((place / name).exists() for place in places)]
    assert [name for name in missing if not list(ROOT.glob(f"*/{name}"))] == []


def test_every_room_is_named():
    assert [path for path in (ROOT / "usdrigui").glob("[a-z]*") if path.stem not in PAGE] == []


def test_every_decision_named_exists():
    known = {path.name[:3] for path in (ROOT / "docs" / "decisions").glob("*.md")}
    named = set(re.findall(r"\((\d{3})\)", PAGE))
    assert len(named) > 8
    assert named <= known


TABLE = re.findall(r"^\| (.+) \|$", PAGE.partition("| paragraph | file |")[2], re.MULTILINE)[1:]
"""Rows about the paper, without the ruler of the table."""
PLACES = {"": "usdrigui", "viewer": "viewer/src", "benchmarks": "benchmarks"}
"""Where one looks for a file, by the folder that its row names first."""


@pytest.mark.parametrize("row", TABLE)
def test_where_is_the_noun_of_a_paragraph(row):
    """The row names one file; among the files called by its noun that one has the shortest name.

    The records of `model/` answer what a thing is, not where it is made.
    """
    paragraph, named = row.split(" | ")
    ((noun,), (path,)) = re.findall(r"\*\*(.+?)\*\*", paragraph), re.findall(r"^`(.+)`$", named)
    folder = ROOT / PLACES.get(path.split("/")[0], PLACES[""])
    called = re.compile(rf"(.*_)?{noun.replace(' ', '_')}[a-z_]*\.(py|js)")
    found = [each for each in folder.rglob("*.*") if called.fullmatch(each.name) and "model" not in each.parts]
    least = min((len(each.name) for each in found), default=0)
    assert [each for each in found if len(each.name) == least] == [
        ROOT / path if (ROOT / path).exists() else folder / path
    ]


def test_every_paragraph_has_a_row_and_a_file_of_its_own():
    assert len({row.split(" | ")[1] for row in TABLE}) == len(TABLE)


def test_it_is_one_page_with_one_figure():
    assert len(PAGE.splitlines()) <= 115
    assert len(PAGE.replace("|", " ").split()) <= 900
    assert PAGE.count("```") == 2
