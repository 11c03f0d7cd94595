"""How a command ends: signals, verdict lines, refusals, bugs."""

from __future__ import annotations

import argparse
import io
import os
import signal
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from usdrigui.errors import Exit, RigUIError, refuse, visible

if TYPE_CHECKING:
    from usdrigui import terminal


def screen_of(arguments: argparse.Namespace) -> terminal.Screen:
    """Where a command shows its progress and its outcome."""
    from usdrigui import terminal

    return terminal.Screen(quiet=arguments.quiet, machine=arguments.json)


def say(line: str, arguments: argparse.Namespace) -> None:
    """Print one line, unless the command owes a JSON document."""
    if not arguments.json:
        print(visible(line))


def strict(issues: Sequence[Any], arguments: argparse.Namespace) -> Exit:
    """How a command ends that found these issues: `Exit.REFUSED` for a warning under ``--strict``."""
    warned = any(found.severity == "warning" for found in issues)
    return Exit.REFUSED if arguments.strict and warned else Exit.OK


def refused(error: RigUIError, arguments: argparse.Namespace) -> None:
    """Print a refusal, its repair and the verdict line; as JSON too if that was asked for."""
    from usdrigui import report

    asset = _subject(error, arguments)
    if getattr(arguments, "json", False):
        sys.stdout.write(report.failure_json(asset, error.issue, error.exit_code))
    found = error.issue
    if getattr(arguments, "openjd", False):
        from usdrigui.clients import openjd

        print(*openjd.failure_lines(found), sep="\n", flush=True)
    where = f" {found.path}:" if found.path else ""
    print(visible(f"usdrigui: {found.code}{where} {found.message}"), file=sys.stderr)
    print(f"  repair: {found.repair}", file=sys.stderr)
    done = getattr(arguments, "layer_state", "")
    kept = f"the layout itself is {done}" if done else "nothing was written"
    print(visible(f"usdrigui: refused {asset}; {kept}"), file=sys.stderr)


def _subject(error: RigUIError, arguments: argparse.Namespace) -> str:
    """What was refused: of several files the one that the finding names, else all of them."""
    if getattr(arguments, "asset", None) is not None:
        return str(arguments.asset)
    named = [str(each) for each in (getattr(arguments, "before", None), getattr(arguments, "layer", None)) if each]
    named = named or list(getattr(arguments, "patterns", ()))
    return error.issue.path if error.issue.path in named else ", ".join(named)


def broken(error: Exception, arguments: argparse.Namespace) -> int:
    """An exception that nobody expected is ours: say so in one line, with the place, without a traceback."""
    if os.environ.get("USDRIGUI_TRACEBACK"):
        raise error
    place = error.__traceback__
    while place is not None and place.tb_next is not None:
        place = place.tb_next
    where = f" ({Path(place.tb_frame.f_code.co_filename).name}:{place.tb_lineno})" if place is not None else ""
    refused(refuse("BUG", "", f"{type(error).__name__}: {error}{where}"), arguments)
    return int(Exit.BUG)


def prepare_streams(*, machine: bool) -> None:
    """Names can hold any character: JSON is UTF-8 whatever the locale, and text never fails for want of a letter."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace", encoding="utf-8" if machine else None)


class Interruption:
    """Ctrl-C and SIGTERM: during the search they ask for the best so far; otherwise, or twice, they end the run."""

    def __init__(self) -> None:
        self.patient = False
        self._asked = False
        self._previous: dict[int, Any] = {}

    def requested(self) -> bool:
        """Whether the best so far is asked for."""
        return self._asked

    def __enter__(self) -> Self:
        for number in (signal.SIGINT, signal.SIGTERM):
            self._previous[number] = signal.signal(number, self._on_signal)
        return self

    def __exit__(self, *exc: object) -> None:
        for number, handler in self._previous.items():
            signal.signal(number, handler)

    def _on_signal(self, number: int, frame: object) -> None:
        del number, frame
        if self._asked:
            os._exit(int(Exit.LIMIT))
        self._asked = True
        if not self.patient:
            raise refuse("INTERRUPTED", "", "stopped before there was a result")
