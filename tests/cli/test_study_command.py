"""`usdrigui study`: results of several participants as one table, beside the paper's."""

from pathlib import Path

import figures
import pytest
from commands import run

from usdrigui.cli import main
from usdrigui.clients import study

HEAD = (
    "participant,block,interface,trial,face,target_controls,seconds,share_of_time,edits,weight_error_squared,"
    "vertex_error_squared,question,answer"
)


def results(path, number, seconds, answers=(), faces=15):
    """A file as the page saves it: `seconds` per face of each interface, the common face of each twice as long."""
    rows = [HEAD]
    for block, name in enumerate(("list", "face", "beside"), 1):
        for face in ("1a", "1b", "1c", "1d", "common"):
            taken = seconds[name] * (2 if face == "common" else 1)
            rows.append(f"{number},{block},{name},{len(rows)},{face},2,{taken},0,3,0.5,{0.1 * block:.1f},,")
    rows = rows[: faces + 1] + [f"{number},,,,,,,,,,,{question},{answer}" for question, answer in answers]
    path.write_text("\n".join(rows) + "\n")
    return path


@pytest.fixture
def two(tmp_path):
    one = results(tmp_path / "1.csv", 1, {"list": 20, "face": 10, "beside": 10}, [("overall_list", 2), ("direct", 5)])
    said = [("overall_list", 3), ("comment", '"well, ""fine"""'), ("direct", 4)]
    other = results(tmp_path / "2.csv", 2, {"list": 20, "face": 15, "beside": 5}, said)
    return one, other


def measure(found, words, interface):
    return next(each for each in found["measures"] if (each["measure"], each["interface"]) == (words, interface))


def test_shares_errors_and_answers_are_means_over_participants(two, capsys):
    found = run(capsys, "study", *two)
    assert figures.other_than_kept("study", found) == {}
    assert found["participants"] == ["1", "2"]
    share = measure(found, "share of time, %", "face")
    assert (share["mean"], share["paper"]) == (pytest.approx((25 + 37.5) / 2), 27.51)
    assert share["deviation"] == pytest.approx(12.5 / 2**0.5)
    assert measure(found, "share of time, %", "list")["mean"] == pytest.approx(50)
    assert measure(found, "time on the common face, of that on the face", "list")["mean"] == pytest.approx(
        (2 + 20 / 15) / 2
    )
    assert measure(found, "vertex error squared", "beside")["mean"] == pytest.approx(0.3)
    assert measure(found, study.QUESTIONS["overall"], "list")["mean"] == 2.5
    assert measure(found, study.QUESTIONS["direct"], "face") | {"mean": 0} == {
        "measure": study.QUESTIONS["direct"], "interface": "face", "participants": 2, "mean": 0,
        "deviation": pytest.approx(0.5**0.5), "paper": 4.83,
    }  # fmt: skip


def test_the_table_names_the_paper_and_what_was_left_out(two, tmp_path, capsys):
    part = results(tmp_path / "3.csv", 3, {"list": 1, "face": 1, "beside": 1}, faces=7)
    assert main(["study", *map(str, two), str(part)]) == 0
    out = capsys.readouterr().out
    assert "Kim and Singh 2021" in out
    assert "50.00 ± 0.00 (46.87)" in out
    assert f"left out, as not all 15 faces were done: {part}" in out


@pytest.mark.parametrize(
    "change",
    [
        lambda _: "",
        lambda _: "a,b\n1,2\n",
        lambda text: text.replace(",20,", ",nan,"),
        lambda text: text.replace(",20,", ",soon,"),
        lambda text: text.replace(",list,", ",menu,"),
        lambda text: text.replace("\n1,2,", "\n2,2,"),
        lambda text: "\n".join(text.splitlines()[:8]),
        lambda text: text + "1,,,,,,,,,,,direct,much\n",
        lambda _: "\0",
    ],
)
def test_what_holds_no_results_is_refused(two, change, capsys):
    two[0].write_text(change(two[0].read_text()))
    assert main(["study", str(two[0])]) == 3
    assert "STUDY_RESULTS" in capsys.readouterr().err


def test_results_of_two_layouts_are_not_summed(two, capsys):
    head, *rows = two[1].read_text().splitlines()
    two[1].write_text("\n".join([f"{head},layout", *(f"{row},another" for row in rows)]))
    assert main(["study", *map(str, two)]) == 3
    assert "another character, layout" in capsys.readouterr().err


def test_a_participant_counts_once(two, tmp_path, capsys):
    again = Path(tmp_path / "again.csv")
    again.write_bytes(two[0].read_bytes())
    assert main(["study", str(two[0]), str(again)]) == 3
    assert "holds participant 1" in capsys.readouterr().err
