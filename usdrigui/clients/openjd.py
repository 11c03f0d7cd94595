"""Laying out many assets on a render farm, by Open Job Description (template version
jobtemplate-2023-09).

`template` makes the job: one task per asset, each a `usdrigui process` that reports its progress in
the lines that `progress_lines` makes of the stages.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from usdrigui.errors import Issue, refuse, sentences

if TYPE_CHECKING:
    from usdrigui.pipeline import Event

_TASKS = 1024
"""Values that the specification allows a task parameter; more assets make more steps."""
_STEPS = 100
_TEXT = 1024
"""Characters that the specification allows one value."""
_SHARES = {
    "read": 15,
    "trajectories": 25,
    "symmetry": 30,
    "candidates": 45,
    "problem": 50,
    "solve": 90,
    "layout": 95,
    "write": 99,
}
"""Percent done when a stage has ended, by what the stages took on rigs of 5 K to 40 K points."""


def template(places: Sequence[tuple[Path, Path]], arguments: Sequence[str]) -> str:
    """The job template, as JSON, that lays out each asset of `places` (asset, layer).

    Paths are made absolute, as tasks run in folders of their own.  Raises FILE_NAME for a name that
    the template language would read as its own, BATCH_TOO_MANY beyond what one job may hold.
    """
    if len(places) > _TASKS * _STEPS:
        raise refuse("BATCH_TOO_MANY", "", f"{len(places)} assets; one job holds {_TASKS * _STEPS}")
    pairs = [(_value(asset), _value(output)) for asset, output in places]
    parts = [pairs[start : start + _TASKS] for start in range(0, len(pairs), _TASKS)]
    options = [_value(each, plain=True) for each in arguments]
    job = {
        "specificationVersion": "jobtemplate-2023-09",
        "name": "usdrigui {{Param.JobName}}",
        "parameterDefinitions": [
            {
                "name": "JobName",
                "type": "STRING",
                "default": "layouts",
                "description": "Name of the job on the farm.",
            },
            {
                "name": "Command",
                "type": "STRING",
                "default": "usdrigui",
                "description": "The usdrigui command on the farm's machines.",
            },
        ],
        "steps": [_step(number, part, options, len(parts)) for number, part in enumerate(parts, 1)],
    }
    return json.dumps(job, indent=2, ensure_ascii=False) + "\n"


def progress_lines(tell: Callable[[str], None]) -> Callable[[Event], None]:
    """A watcher of a run that reports its progress to a farm: ``openjd_progress: N`` and
    ``openjd_status: ...``."""

    def watch(event: Event) -> None:
        if event.seconds is None:
            tell(f"openjd_status: {event.stage}")
        else:
            tell(f"openjd_progress: {_SHARES[event.stage]}")

    return watch


def failure_lines(found: Issue) -> Iterator[str]:
    """A refusal as a farm reads it: one line, in which line breaks are spaces."""
    text = f"{found.code} {found.where}: {sentences(found)}"
    yield f"openjd_fail: {' '.join(text.split())}"


def _step(
    number: int, pairs: Sequence[tuple[str, str]], options: Sequence[str], steps: int
) -> dict[str, Any]:
    task = [
        "process",
        "{{Task.Param.Asset}}",
        "-o",
        "{{Task.Param.Output}}",
        "--quiet",
        "--openjd",
        *options,
    ]
    return {
        "name": "Layout" if steps == 1 else f"Layout{number}",
        "parameterSpace": {
            "taskParameterDefinitions": [
                {"name": "Asset", "type": "PATH", "range": [asset for asset, _ in pairs]},
                {"name": "Output", "type": "PATH", "range": [output for _, output in pairs]},
            ],
            "combination": "(Asset, Output)",
        },
        "script": {"actions": {"onRun": {"command": "{{Param.Command}}", "args": task}}},
    }


def _value(given: Path | str, *, plain: bool = False) -> str:
    text = str(given) if plain else os.path.abspath(given)  # noqa: PTH100 (keeps links)
    if "{{" in text or len(text) > _TEXT:
        raise refuse("FILE_NAME", text[:80], "cannot be written in a job template")
    return text
