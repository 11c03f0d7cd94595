"""The command `usdrigui`: a supervisor that loads neither numpy nor USD, over a worker that does
what is asked.

Whatever becomes of the worker, the user gets one closing line and a documented exit code.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import sys
from collections.abc import Callable, Iterator, Sequence

from usdrigui import cli
from usdrigui.cli.outcomes import prepare_streams, refused
from usdrigui.cli.parser import parsed
from usdrigui.errors import RigUIError, refuse
from usdrigui.isolation.supervising import Events, Outcome, interrupted, supervise


def run(argv: Sequence[str], events: Events) -> int:
    """Run a command line; `events` receives signals.  Returns the exit code."""
    try:
        with _captured():
            arguments = parsed(argv)
    except (SystemExit, RigUIError):  # the command says it, as one that needs no worker
        arguments = argparse.Namespace(json="--json" in argv, light=True, patterns=argv[:2])
    prepare_streams(machine=getattr(arguments, "json", False))
    return _printed(_outcome(argv, arguments, events), arguments)


def _outcome(argv: Sequence[str], arguments: argparse.Namespace, events: Events) -> Outcome:
    """What becomes of a command line."""
    if getattr(arguments, "light", False):
        return _said(cli.main, argv)
    if not events.empty():
        return _said(refused, interrupted(), arguments)
    try:
        os.getcwd()  # noqa: PTH109 (the question is whether there is one)
    except OSError as error:
        return _said(
            refused,
            refuse("WORKING_DIRECTORY", "", f"it does not exist: {error.strerror}"),
            arguments,
        )
    terminals = (_is_terminal(sys.stdout), _is_terminal(sys.stderr))
    outcome = supervise(argv, _show, events, terminals=terminals)
    if account := _account(outcome):
        arguments.written = account
    if outcome.death is not None:
        return _said(refused, outcome.death, arguments)
    return outcome


def _account(outcome: Outcome) -> str:
    """What is known of the files that a command was to write; empty if it wrote none."""
    clauses = [f"written {', '.join(outcome.written)}"] if outcome.written else []
    clauses += [f"as before or complete: {', '.join(outcome.unknown)}"] if outcome.unknown else []
    return "; ".join(clauses)


@contextlib.contextmanager
def _captured() -> Iterator[tuple[io.StringIO, io.StringIO]]:
    """What is printed within, on each of the two streams."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        yield out, err


def _said(command: Callable[..., int], *arguments: object) -> Outcome:
    """What a function prints that ends a command, and the exit code that it returns."""
    with _captured() as (out, err):
        code = command(*arguments)
    return Outcome(code, out.getvalue(), err.getvalue())


# --- the streams ----------------------------------------------------------------------------------


def _show(name: str, text: str) -> None:
    """Print what comes before the end, as far as that is possible."""
    with contextlib.suppress(OSError):
        _write(name, text)


def _is_terminal(stream: object) -> bool:
    return isinstance(stream, io.TextIOBase) and stream.isatty()


def _printed(outcome: Outcome, arguments: argparse.Namespace) -> int:
    """Print the closing line; what standard output does not take ends on standard error."""
    try:
        _write("out", outcome.out)
    except OSError as error:
        if not outcome.err:
            reason = error.strerror or type(error).__name__
            outcome = _said(refused, refuse("OUTPUT_STREAM", "standard output", reason), arguments)
    with contextlib.suppress(OSError):
        _write("err", outcome.err)
    return outcome.code


def _write(name: str, text: str) -> None:
    """Write and flush; a stream that fails is written to no more, not even at the interpreter's
    end."""
    stream = sys.stdout if name == "out" else sys.stderr
    if not text:
        return
    if stream is None:
        raise OSError(None, "it is closed")
    try:
        stream.write(text)
        stream.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
        raise
