"""How a command ends: closing lines, refusals, bugs."""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import sys
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from usdrigui.cli.lines import tell
from usdrigui.errors import Exit, RigUIError, raised_at, refuse
from usdrigui.isolation import worker

if TYPE_CHECKING:
    from usdrigui.cli.terminal.screen import Screen


_SUBJECTS = ("asset", "before", "layer", "patterns", "results", "folder")
"""Arguments that are files, patterns of files or folders which a command is about."""


def screen_of(arguments: argparse.Namespace) -> Screen:
    """Where a command shows its progress and its outcome."""
    from usdrigui.cli.terminal.screen import Screen

    return Screen(quiet=arguments.quiet, machine=arguments.json)


def wrote(
    arguments: argparse.Namespace,
    files: Mapping[Path, str],
    lines: Iterable[str] = (),
    more: str = "",
) -> Exit:
    """Tell which `files` a command has written, if any, and what became of each, and before them
    its `lines`; the last of all is the closing line, and ends with `more`."""
    from usdrigui.report.documents import document

    told = [*lines, *(f"{state} {path}" for path, state in files.items())]
    outputs = [{"output": str(path), "outcome": state} for path, state in files.items()]
    told[-1] += more
    screen_of(arguments).show(
        lambda: document(arguments.command, written=outputs),
        [f"usdrigui: {line}" for line in told],
    )
    return Exit.OK


def check_ending(option: str, path: Path | None, *endings: str) -> None:
    """Raise CONFIG_VALUE where the name of a picture to be written ends otherwise."""
    if path is not None and path.suffix.lower() not in endings:
        known = " or ".join(endings)
        raise refuse("CONFIG_VALUE", option, f"a picture ends in {known}, not in {path.suffix!r}")


def strict(issues: Sequence[Any], arguments: argparse.Namespace) -> Exit:
    """How a command ends that found these issues: `Exit.REFUSED` for a warning under
    ``--strict``."""
    warned = any(found.severity == "warning" for found in issues)
    return Exit.REFUSED if arguments.strict and warned else Exit.OK


def refused(error: RigUIError, arguments: argparse.Namespace) -> int:
    """Print a refusal, its repair and the closing line, as JSON too if that was asked for; returns
    the exit code."""
    found = error.issue
    asset = _given(found.path, arguments)
    subject = asset or found.path
    worker.hold_errors()
    if getattr(arguments, "json", False):
        from usdrigui.report.documents import document

        code = int(error.exit_code)
        told = {"asset": asset, "outcome": "refused", "exit": code, "issues": error.issues}
        sys.stdout.write(document("report", **told))
    if getattr(arguments, "openjd", False):
        from usdrigui.clients import openjd

        worker.print_now("\n".join(openjd.failure_lines(found)))
    for each in error.issues:
        where = f" {each.where}:" if each.where else ""
        _complain(f"usdrigui: {each.code}{where} {each.message}")
        _complain(f"  repair: {each.repair}")
    closing = (
        f"finished {subject} without its report"
        if found.code == "OUTPUT_STREAM"
        else f"refused {subject}"
    )
    written = getattr(arguments, "written", "nothing was written")
    _complain(f"usdrigui: {closing}{'; ' * bool(written)}{written}")
    return int(error.exit_code)


def _complain(line: str) -> None:
    """Print on standard error, as far as it takes anything."""
    with contextlib.suppress(OSError):
        tell(line, sys.stderr)


def _given(path: str, arguments: argparse.Namespace) -> str:
    """Of the files that a command is about the one at `path`, else all of them."""
    given = [getattr(arguments, name, []) for name in _SUBJECTS]
    named = [str(each) for one in given for each in (one if isinstance(one, list) else [one])]
    return path if path in named else ", ".join(named)


def broken(error: Exception, arguments: argparse.Namespace) -> int:
    """An exception that nobody expected is ours: say so in one line, with the place, without a
    traceback."""
    if os.environ.get("USDRIGUI_TRACEBACK"):
        raise error
    what = f"{type(error).__name__}: {error}{raised_at(error)}"
    return refused(refuse("BUG", "", what), arguments)


def prepare_streams(*, machine: bool) -> None:
    """Names can hold any character: JSON is UTF-8 whatever the locale, and text never fails for
    want of a letter."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace", encoding="utf-8" if machine else None)
