"""The command line: the only place that prints or chooses an exit code.

`main` parses, calls one function per command and turns every outcome into one closing line.
Nothing heavy (pxr, scipy, highspy) is imported before a command needs it.
"""

from __future__ import annotations

import argparse
import importlib
import os
import sys
from collections.abc import Sequence

from usdrigui.cli import distributions
from usdrigui.cli.lines import tell
from usdrigui.cli.outcomes import broken, prepare_streams, refused
from usdrigui.cli.parser import parsed
from usdrigui.errors import Exit, RigUIError, refuse, sentences
from usdrigui.isolation import worker


def main(argv: Sequence[str]) -> int:
    """Run one command in this process; returns its exit code (see `usdrigui.errors.Exit`).

    The command `usdrigui` runs it in a worker (`usdrigui.cli.supervised`).
    """
    arguments = argparse.Namespace(json="--json" in argv)
    try:
        arguments = parsed(argv)
        prepare_streams(machine=getattr(arguments, "json", False))
        for found in distributions.colliding():
            tell(f"warning: {found.code} {sentences(found)}", sys.stderr)
        module, _, function = arguments.run.partition(":")
        return int(getattr(importlib.import_module(f"{__name__}.{module}"), function)(arguments))
    except SystemExit as ended:  # --help and --version
        return int(ended.code or 0)
    except KeyboardInterrupt:
        return _interrupted(arguments)
    except Exception as error:
        return _interrupted(arguments) if worker.interrupted() else _failed(error, arguments)


def _interrupted(arguments: argparse.Namespace) -> int:
    worker.discard_result()
    return refused(refuse("INTERRUPTED", "", "stopped before there was a result"), arguments)


def _failed(error: Exception, arguments: argparse.Namespace) -> int:
    """How a command ends that has raised an error."""
    if isinstance(error, RigUIError):
        return refused(error, arguments)
    if isinstance(error, MemoryError):
        return refused(refuse("RUN_MEMORY_LIMIT", "", "the machine has no free memory"), arguments)
    if isinstance(error, BrokenPipeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return int(Exit.FILE)
    if isinstance(error, OSError):
        reason = error.strerror or str(error)
        return refused(refuse("FILE_ACCESS", error.filename or "", reason), arguments)
    return broken(error, arguments)
