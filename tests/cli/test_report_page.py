"""docs/internals/report.md names every field of the report."""

import re

import scripts
import skinned_stages
from folders import ROOT

from usdrigui import load_settings, process
from usdrigui.report.run_documents import to_json

PAGE = ROOT / "docs" / "internals" / "report.md"


def test_every_field_is_documented(tmp_path):
    import json

    report = process(skinned_stages.character(tmp_path / "char.usda"), load_settings(), dry_run=True)
    document = json.loads(to_json(report))
    character = document["characters"][0]
    fields = {*document, *character, *character["controls"][0], *character["elements"][0], *character["solution"]}
    fields |= set(character["solution"]["steps"][0])
    assert fields - set(re.findall(r"[a-z_0-9]+", PAGE.read_text(encoding="utf-8"))) == set()


def test_a_control_says_the_part_on_which_it_stands(tmp_path):
    settings = load_settings({"parts": {"controls": {"brow_R": "muzzle"}}, "controls": {"chin": {"place": "board"}}})
    report = process(skinned_stages.character(tmp_path / "char.usda"), settings, dry_run=True)
    rows = {row.control: row for row in report.characters[0].rows}
    assert (rows["brow_R"].place, rows["brow_R"].part, rows["brow_R"].stands) == ("face", "muzzle", "muzzle")
    assert (rows["chin"].part, rows["chin"].stands) == ("face", "board")


def test_reference_pages_are_up_to_date():
    docs = PAGE.parents[1]
    with scripts.loaded(docs / "generate.py") as generate:
        pages = generate.pages()
    for name, text in pages.items():
        assert (docs / name).read_text(encoding="utf-8") == text, "run: python docs/generate.py"
