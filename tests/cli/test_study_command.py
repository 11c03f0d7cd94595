"""`usdrigui study`: means over participants; what is printed of them, and refused, is the session `study`."""

import pytest
from commands import run

from usdrigui.clients import study

HEAD = (
    "participant,block,interface,trial,face,target_controls,seconds,share_of_time,edits,weight_error_squared,"
    "vertex_error_squared,question,answer"
)


def results(path, number, seconds, answers):
    """A file as the page saves it: `seconds` per face of each interface, the common face of each twice as long."""
    rows = [HEAD]
    for block, name in enumerate(("list", "face", "beside"), 1):
        for face in ("1a", "1b", "1c", "1d", "common"):
            taken = seconds[name] * (2 if face == "common" else 1)
            rows.append(f"{number},{block},{name},{len(rows)},{face},2,{taken},0,3,0.5,{0.1 * block:.1f},,")
    rows += [f"{number},,,,,,,,,,,{question},{answer}" for question, answer in answers]
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
