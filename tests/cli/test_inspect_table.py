"""The table of `usdrigui inspect`: shares that are small are not told as nothing."""

from types import SimpleNamespace

import pytest
import skel_stages
import skinned_stages
from commands import run

from usdrigui import errors
from usdrigui.cli import main
from usdrigui.cli.terminal.review_lines import facts_table
from usdrigui.cli.terminal.run_lines import issue_lines, on_what, percent
from usdrigui.cli.terminal.table import Table
from usdrigui.report import inspection


@pytest.mark.parametrize(
    ("share", "text"),
    [(0.0, "0 %"), (1e-9, "<1 %"), (0.0049, "<1 %"), (0.0051, "1 %"), (1.0, "100 %"), (float("nan"), "-")],
)
def test_small_shares_are_not_nothing(share, text):
    assert percent(share) == text


def test_one_is_not_several():
    assert [errors.counted(number, "part") for number in (0, 1)] == ["0 parts", "1 part"]


def inspected(path, capsys):
    """What the only character of a file is found to be."""
    (only,) = run(capsys, "inspect", path)["characters"]
    return only


def test_joints_that_are_no_controls_are_told_with_the_reason(tmp_path, capsys):
    character = skinned_stages.character(tmp_path / "char.usda", animated_joints=("Hips/Head/Jaw",), hinged=True)
    assert [*inspected(character, capsys)["without"].values()] == [["Head"], ["Hips", "Eye"]]
    assert main(["inspect", str(character)]) == 0
    assert "no controls: Hips and Eye: no skin hangs on it" in capsys.readouterr().out


def test_a_skeleton_without_joints_has_none_to_tell(tmp_path, capsys):
    skel_stages.head(tmp_path / "char.usda")
    assert inspected(tmp_path / "char.usda", capsys)["without"] == {}


@pytest.mark.parametrize("width", [40, 80, 160])
def test_a_narrow_terminal_loses_no_number(width, tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(width))
    character = skinned_stages.character(tmp_path / "char.usda")
    only = inspected(character, capsys)
    assert main(["inspect", str(character)]) == 0
    _, _, table = capsys.readouterr().out.partition("\ncontrol  ")
    starts = [table.index(f"\n{row['control']}  ") for row in only["controls"]]
    for row, start, end in zip(only["controls"], starts, [*starts[1:], len(table)], strict=True):
        told = {word.strip(";") for word in table[start:end].split()}
        numbers = {f"{row['minimum']:g}..{row['maximum']:g}", str(row["points"]), f"{row['peak']:.2f}"}
        numbers.add(f"{100 * row['coverage']:.0f}")
        assert numbers | {row["kind"], row["range_source"], row["twin"] or row["kind"]} <= told


def _facts(control, twin, flags):
    return inspection.ControlFacts(
        control, "blendShape", "", 0.0, 0.0, 1.0, "default", 7, 0.5, 1.0, twin, "geometry", flags
    )


def test_one_long_name_squeezes_no_other_column():
    long = "x" * 120
    facts = [_facts(long, "smile_R", ("global",)), _facts("smile_R", long, ())]
    lines = list(facts_table(facts).lines(160))
    assert sum(line.count("x") for line in lines) == 240
    assert any("smile_R" in line and "global" in line for line in lines)
    assert len(lines) < 12
    assert [*Table("a | b", [("x", "y")], below="b").lines(4)] == ["a  b", "x  y"]


def test_a_finding_is_one_line_of_two_sentences():
    found = errors.issue("CONTROL_TINY", "chin", "moves no point further than " + "very " * 40 + "little.")
    (line,) = issue_lines([found])
    assert line.startswith("info: CONTROL_TINY chin: moves")
    assert line.endswith(f"very little. {found.repair}")


def test_findings_with_one_repair_say_it_once():
    tiny = [errors.issue("CONTROL_TINY", name, f"moves {name}") for name in ("chin", "jaw")]
    found = [*tiny, errors.issue("LAYOUT_TOPOLOGY", "/r", "a")]
    *lines, repair, last = issue_lines(found)
    assert lines == ["info: CONTROL_TINY chin: moves chin", "info: CONTROL_TINY jaw: moves jaw"]
    assert repair == f"  repair: {tiny[0].repair}"
    assert last.endswith(f"a. {found[-1].repair}")


def test_a_finding_that_many_elements_share_is_one_line():
    (line,) = issue_lines(errors.issue("LAYOUT_TOPOLOGY", f"/r{i}", "a") for i in range(6))
    assert line.startswith("error: LAYOUT_TOPOLOGY /r0, /r1, /r2 and 3 more: a.")


@pytest.mark.parametrize(("parts", "said"), [(["face"], "face"), (["hands"], "hands"), (["face", "body"], "character")])
def test_controls_stand_on_the_one_part_that_there_is_or_on_the_character(parts, said):
    assert on_what([SimpleNamespace(parts=[SimpleNamespace(name=name) for name in parts])]) == said
