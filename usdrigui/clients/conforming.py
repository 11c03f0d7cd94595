"""Whether a reader of layouts reads them as the contract says: its answers to the questions of
`schemas/conformance`, compared with those that are kept there."""

from __future__ import annotations

import json
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from usdrigui.stages.schema import schema_path

_PATIENCE = 300.0
"""Seconds for the questions about one layer."""


@dataclass(frozen=True, slots=True)
class Answered:
    """What a reader made of the questions about one layer."""

    case: str
    wrong: tuple[str, ...]
    """One clause for each answer that differs."""
    unanswered: int
    """Questions answered with null: what the reader does not do."""
    count: int


def conform(reader: Sequence[str]) -> Iterator[Answered]:
    """Run a command for each layer, ``READER LAYER``, with the questions as a JSON array on its
    standard input; it prints an array with the answer to each, or null."""
    folder = schema_path() / "conformance"
    for case in sorted(folder.glob("*.json")):
        content = json.loads(case.read_text(encoding="utf-8"))
        questions = content["questions"]
        asked = [{k: v for k, v in each.items() if k not in _KEPT} for each in questions]
        answers, fault = _answers([*reader, str(folder / content["layer"])], asked)
        pairs = zip(questions, answers, strict=True) if not fault else ()
        wrong = [fault] if fault else [_named(q) for q, a in pairs if not agrees(q, a)]
        yield Answered(case.stem, tuple(wrong), answers.count(None), len(questions))


_KEPT = ("answer", "within")


def _answers(command: Sequence[str], asked: Sequence[Any]) -> tuple[list[Any], str]:
    """The answers, and what is wrong with all of them."""
    try:
        done = subprocess.run(
            command,
            input=json.dumps(asked),
            capture_output=True,
            text=True,
            timeout=_PATIENCE,
            check=False,
        )
        answers = json.loads(done.stdout)
    except (OSError, subprocess.TimeoutExpired, ValueError) as error:
        return [], f"no answers: {error}"
    if not isinstance(answers, list) or len(answers) != len(asked):
        return [], f"not {len(asked)} answers in an array"
    if all(each is None for each in answers):
        return answers, "none of the questions is answered"
    return answers, ""


def _named(question: Mapping[str, Any]) -> str:
    said = {k: v for k, v in question.items() if k not in _KEPT and isinstance(v, (str, dict))}
    return json.dumps(said, ensure_ascii=False)


def agrees(question: Mapping[str, Any], answer: Any) -> bool:
    """Whether an answer is the one that is kept, as near as it says, or null."""
    if answer is None:
        return True
    steps = answer if isinstance(answer, list) else [answer]
    lawful = question["ask"] != "drag" or all(_lawful(question, each) for each in steps)
    return lawful and _same(question["answer"], answer, question.get("within", 0.0))


def _lawful(element: Mapping[str, Any], values: Any) -> bool:
    """Whether the values of a drag are within their ranges, and one end of each axis at most is
    away from its default."""
    low, off, high = (element[name] for name in ("minimum", "default", "maximum"))
    numbers = isinstance(values, list) and all(isinstance(each, (int, float)) for each in values)
    if not numbers or len(values) != len(off):
        return False
    inside = all(a <= value <= b for a, value, b in zip(low, values, high, strict=True))
    pairs = (axis for axis in element["axes"] if len(axis) == 2)
    return inside and all(any(values[end] == off[end] for end in pair) for pair in pairs)


def _same(expected: Any, found: Any, within: Any) -> bool:
    """Whether an answer has the expected values, numbers to `within`; null stands for any."""
    if expected is None:
        return True
    if isinstance(expected, Mapping):
        return (
            isinstance(found, Mapping)
            and expected.keys() == found.keys()
            and all(_same(value, found[key], within) for key, value in expected.items())
        )
    if isinstance(expected, list):
        each = within if isinstance(within, list) else [within] * len(expected)
        same = isinstance(found, list) and len(found) == len(expected)
        return same and all(map(_same, expected, found, each))
    if isinstance(expected, (str, bool)):
        return bool(expected == found)
    return isinstance(found, (int, float)) and abs(found - expected) <= within
