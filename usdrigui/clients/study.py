"""Results of the evaluation (`usdrigui view --study`), summed over participants beside the paper's
figures.

The paper's are from Kim and Singh 2021, section 5.2: twelve people, another face, and an artist's
layout off the face.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean, stdev

from usdrigui.errors import refuse
from usdrigui.isolation.foreign_file import whole_content
from usdrigui.report.documents import document, plain

INTERFACES = {"list": "slider list", "beside": "on a copy", "face": "on the face"}
"""In the order of the table; the paper's second is its layout off the face."""
FACES = 15
"""Of one participant."""
QUESTIONS = {
    "overall": "experience, 1 to 5",
    "easy": "without effort, 1 to 5",
    "unexpected": "unexpected results, 1 to 5",
    "cluttered": "cluttered, 1 to 5",
    "placed": "placed where it acts, 1 to 5",
    "direct": "like moving the face itself, 1 to 5",
}
PAPER: Mapping[str, Mapping[str, float]] = {
    "share of time, %": {"list": 46.87, "beside": 25.62, "face": 27.51},
    "time on the common face, of that on the face": {"list": 1.36, "beside": 1.12, "face": 1.0},
    QUESTIONS["overall"]: {"list": 2.25, "beside": 4.0, "face": 4.0},
    QUESTIONS["direct"]: {"face": 4.83},
}
PAPER_PARTICIPANTS = 12

Answers = Mapping[str, str]


@dataclass(frozen=True, slots=True)
class Measure:
    """One figure of one interface over the participants."""

    measure: str
    interface: str
    participants: int
    mean: float
    deviation: float
    """Standard deviation between participants; 0 of one."""
    paper: float | None
    """The paper's mean, where its text gives one."""

    def __str__(self) -> str:
        paper = "" if self.paper is None else f" ({self.paper:.2f})"
        return f"{self.mean:.2f} ± {self.deviation:.2f}{paper}"


@dataclass(frozen=True, slots=True)
class Study:
    """What all participants did."""

    participants: tuple[str, ...]
    measures: tuple[Measure, ...]
    left_out: tuple[str, ...]
    """Files of sessions that were not finished."""


def summed(paths: Sequence[Path]) -> Study:
    """Sum the results of files, one participant each.  Raises STUDY_RESULTS, for those of different
    studies, too."""
    found: dict[str, list[Answers]] = {}
    left_out, same = list[str](), list[str]()
    for path in paths:
        rows = _rows(path)
        if len([row for row in rows if row["face"]]) != FACES:
            left_out.append(str(path))
            continue
        participant, own = rows[0]["participant"], [rows[0][key] for key in _SAME]
        if own != (same := same or own):
            what = "is of another character, layout, version or set of targets than the first"
            raise refuse("STUDY_RESULTS", path, what)
        if participant in found:
            raise refuse(
                "STUDY_RESULTS",
                path,
                f"holds participant {participant}, whom another file holds, too",
            )
        found[participant] = rows
    if not found:
        raise refuse("STUDY_RESULTS", paths[0], f"no file holds all {FACES} faces of a participant")
    return Study(
        tuple(
            sorted(found, key=lambda name: (float(name) if name.isdecimal() else math.inf, name))
        ),
        tuple(_measures(list(found.values()))),
        tuple(left_out),
    )


def as_json(study: Study) -> str:
    """What all participants did as one JSON document."""
    return document("study", **plain(study))


# --- one file -------------------------------------------------------------------------------------

_NEEDED = (
    "participant",
    "interface",
    "face",
    "seconds",
    "weight_error_squared",
    "vertex_error_squared",
)
_ASKED, _SAME = ("question", "answer"), ("character", "layout", "version", "targets")
"""In files of later versions; the second are the same in all that is summed."""


def _rows(path: Path) -> list[Answers]:
    """The rows of a file, all of one participant."""
    try:
        reader = csv.DictReader(io.StringIO(whole_content(path).decode(), newline=""), restval="")
        rows: list[Answers] = [
            {key: row.get(key) or "" for key in (*_NEEDED, *_ASKED, *_SAME)} for row in reader
        ]
        known = set(_NEEDED) <= set(reader.fieldnames or ())
        numbers = [float(value) for row in rows for value in _numbers(row)]
    except (OSError, ValueError, csv.Error) as error:
        raise refuse("STUDY_RESULTS", path, f"cannot be read as results: {error}") from error
    alien = any(row["face"] and row["interface"] not in INTERFACES for row in rows)
    if not known or not rows or alien or not all(math.isfinite(each) for each in numbers):
        raise refuse("STUDY_RESULTS", path, "is not a CSV file that the viewer's study saved")
    if len({row["participant"] for row in rows}) > 1:
        raise refuse("STUDY_RESULTS", path, "holds more than one participant")
    return rows


def _numbers(row: Answers) -> tuple[str, ...]:
    """What must be a number in a row: of a face its time and errors, of an answer its score."""
    if row["face"]:
        return tuple(row[key] for key in _NEEDED[3:])
    return (row["answer"],) if row["question"] not in ("", "comment") else ()


# --- measures -------------------------------------------------------------------------------------


def _measures(people: Sequence[Sequence[Answers]]) -> Iterable[Measure]:
    for measure, value in _OF_FACES.items():
        for name in INTERFACES:
            yield _over(measure, name, [value(rows, name) for rows in people])
    for question, words in QUESTIONS.items():
        for name in INTERFACES if question == "overall" else ("face",):
            asked = f"{question}_{name}" if question == "overall" else question
            answers = [
                float(row["answer"]) for rows in people for row in rows if row["question"] == asked
            ]
            if answers:
                yield _over(words, name, answers)


def _over(measure: str, name: str, values: Sequence[float]) -> Measure:
    deviation = stdev(values) if len(values) > 1 else 0.0
    return Measure(
        measure, name, len(values), fmean(values), deviation, PAPER.get(measure, {}).get(name)
    )


def _share(rows: Sequence[Answers], name: str) -> float:
    return (
        100.0 * _seconds(rows, name) / max(sum(_seconds(rows, each) for each in INTERFACES), 1e-9)
    )


def _common(rows: Sequence[Answers], name: str) -> float:
    common = [row for row in rows if row["face"] == "common"]
    return _seconds(common, name) / max(_seconds(common, "face"), 1e-9)


def _seconds(rows: Sequence[Answers], name: str) -> float:
    return sum(float(row["seconds"]) for row in rows if row["face"] and row["interface"] == name)


def _mean_of(key: str) -> Callable[[Sequence[Answers], str], float]:
    return lambda rows, name: fmean(
        float(row[key]) for row in rows if row["face"] and row["interface"] == name
    )


_OF_FACES: Mapping[str, Callable[[Sequence[Answers], str], float]] = {
    "minutes": lambda rows, name: _seconds(rows, name) / 60.0,
    "share of time, %": _share,
    "time on the common face, of that on the face": _common,
    "weight error squared": _mean_of("weight_error_squared"),
    "vertex error squared": _mean_of("vertex_error_squared"),
}
