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
from collections.abc import Iterator, Sequence

from usdrigui import cli
from usdrigui.cli.outcomes import prepare_streams, refused
from usdrigui.cli.parser import parsed
from usdrigui.errors import RigUIError, refuse
from usdrigui.isolation.supervising import Events, Outcome, interrupted, supervise


def run(argv: Sequence[str], events: Events) -> int:
    """Run a command line; `events` receives signals.  Returns the exit code."""
    arguments = argparse.Namespace(json="--json" in argv, patterns=argv[:2])
    try:
        with _captured() as (out, err):
            arguments = parsed(argv)
    except SystemExit as ended:
        outcome = Outcome(int(ended.code or 0), out.getvalue(), err.getvalue())
    else:
        outcome = _outcome(argv, arguments, events)
    return _printed(outcome, arguments)


def _outcome(argv: Sequence[str], arguments: argparse.Namespace, events: Events) -> Outcome:
    """What becomes of a command line that is understood."""
    if not events.empty():
        return _refusal(interrupted(), arguments)
    try:
        os.getcwd()  # noqa: PTH109 (the question is whether there is one)
    except OSError as error:
        return _refusal(
            refuse("WORKING_DIRECTORY", "", f"it does not exist: {error.strerror}"), arguments
        )
    if getattr(arguments, "light", False):
        return _alone(argv)
    prepare_streams(machine=getattr(arguments, "json", False))
    terminals = (_is_terminal(sys.stdout), _is_terminal(sys.stderr))
    outcome = supervise(argv, _show, events, terminals=terminals)
    if account := _account(outcome):
        arguments.written = account
    if outcome.death is not None:
        return _refusal(outcome.death, arguments)
    return outcome


def _account(outcome: Outcome) -> str:
    """What is known of the files that a command was to write; empty if it wrote none."""
    clauses = [f"written {', '.join(outcome.written)}"] if outcome.written else []
    clauses += [f"as before or complete: {', '.join(outcome.unknown)}"] if outcome.unknown else []
    return "; ".join(clauses)


def _alone(argv: Sequence[str]) -> Outcome:
    """A command that needs no worker."""
    with _captured() as (out, err):
        code = cli.main(argv)
    return Outcome(code, out.getvalue(), err.getvalue())


@contextlib.contextmanager
def _captured() -> Iterator[tuple[io.StringIO, io.StringIO]]:
    """What is printed within, on each of the two streams."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        yield out, err


def _refusal(error: RigUIError, arguments: argparse.Namespace) -> Outcome:
    """The closing line of a command whose worker has none."""
    with _captured() as (out, err):
        code = refused(error, arguments)
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
            outcome = _refusal(refuse("OUTPUT_STREAM", "standard output", reason), arguments)
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
