"""The command line: the only place that prints or chooses an exit code.

`main` parses, calls one function per command and turns every outcome into one closing line.
Nothing heavy (pxr, scipy, highspy) is imported before a command needs it.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import NoReturn

from usdrigui import worker
from usdrigui.cli import distributions
from usdrigui.cli.attaching import add_attach, add_detach
from usdrigui.cli.laying_out import add_inspect, add_process
from usdrigui.cli.many import add_batch, add_openjd
from usdrigui.cli.outcomes import broken, prepare_streams, refused
from usdrigui.cli.reviewing import add_check, add_diff
from usdrigui.cli.showing import add_flat_picker, add_picture, add_study, add_view
from usdrigui.cli.tables import columns, wrapped
from usdrigui.cli.unknown_options import hint, options_of
from usdrigui.errors import Exit, RigUIError, meant, refuse, sentences
from usdrigui.version import __version__


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command in this process; returns its exit code (see `usdrigui.errors.Exit`).

    The command `usdrigui` runs it in a worker (`usdrigui.cli.supervised`).
    """
    arguments = parsed(argv)
    prepare_streams(machine=getattr(arguments, "json", False))
    for found in distributions.colliding():
        print(
            "\n".join(wrapped(f"warning: {found.code} {sentences(found)}", columns(sys.stderr))),
            file=sys.stderr,
        )
    try:
        return int(arguments.run(arguments))
    except KeyboardInterrupt:
        return _interrupted(arguments)
    except Exception as error:
        return _interrupted(arguments) if worker.interrupted() else _failed(error, arguments)


def _interrupted(arguments: argparse.Namespace) -> int:
    worker.discard_result()
    return _refused(refuse("INTERRUPTED", "", "stopped before there was a result"), arguments)


def _failed(error: Exception, arguments: argparse.Namespace) -> int:
    """How a command ends that has raised an error."""
    if isinstance(error, RigUIError):
        return _refused(error, arguments)
    if isinstance(error, MemoryError):
        return _refused(refuse("RUN_MEMORY_LIMIT", "", "the machine has no free memory"), arguments)
    if isinstance(error, BrokenPipeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return int(Exit.FILE)
    if isinstance(error, OSError):
        reason = error.strerror or str(error)
        return _refused(refuse("FILE_ACCESS", str(error.filename or ""), reason), arguments)
    return broken(error, arguments)


def _refused(error: RigUIError, arguments: argparse.Namespace) -> int:
    refused(error, arguments)
    return int(error.exit_code)


def parsed(argv: Sequence[str] | None) -> argparse.Namespace:
    """The command line; exits with 2 on a wrong one, with the usage of its command and the option
    that was meant."""
    whole = parser()
    arguments, unknown = whole.parse_known_args(argv)
    if unknown:
        own: argparse.ArgumentParser = getattr(arguments, "parser", whole)
        own.error(f"unrecognized arguments: {' '.join(unknown)}{_hint(own, unknown, whole)}")
    return arguments


def _hint(own: argparse.ArgumentParser, unknown: Sequence[str], whole: CommandLine) -> str:
    """A hint for the first unknown option that has one."""
    every = {name: options_of(each) for name, each in whole.commands.items()}
    name = own.prog.rpartition(" ")[2]
    options = [each.partition("=")[0] for each in unknown if each.startswith("-")]
    hints = (hint(each, name, every) for each in options if name in every)
    return next((each for each in hints if each), "")


class CommandLine(argparse.ArgumentParser):
    """As argparse's, with errors in lines as wide as the terminal."""

    commands: Mapping[str, argparse.ArgumentParser] = MappingProxyType({})
    """By name, as far as they have options."""

    def error(self, message: str) -> NoReturn:
        """Exit with 2: usage and error."""
        self.print_usage(sys.stderr)
        misspelt = re.search(r"argument COMMAND: invalid choice: '([^']*)'", message)
        message += meant(misspelt[1], self.commands) if misspelt else ""
        lines = wrapped(f"{self.prog}: error: {message}", columns(sys.stderr))
        self.exit(int(Exit.USAGE), "\n".join(lines) + "\n")


def parser() -> CommandLine:
    """The command line; ``light`` commands need no worker."""
    parser = CommandLine(
        prog="usdrigui",
        description="Automatic in-situ rig UI layouts for USD characters.",
        epilog=(
            "Exit codes: 0 done, 1 asset refused, 2 usage or configuration, 3 file, 4 limit, 5 a"
            " bug of usdrigui."
        ),
    )
    parser.add_argument("--version", action="version", version=f"usdrigui {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")
    add_process(commands)
    add_inspect(commands)
    add_check(commands)
    add_diff(commands)
    add_view(commands)
    add_picture(commands)
    add_flat_picker(commands)
    add_study(commands)
    add_batch(commands)
    add_openjd(commands)
    add_attach(commands)
    add_detach(commands)
    parser.commands = dict(commands.choices)
    schema = commands.add_parser(
        "schema-path", help="print the folder to add to PXR_PLUGINPATH_NAME"
    )
    schema.set_defaults(run=_schema_path, light=True)
    configuration = commands.add_parser(
        "config-schema", help="print a JSON Schema with which editors complete settings"
    )
    configuration.set_defaults(run=_config_schema, light=True)
    blender = commands.add_parser(
        "blender-extension", help="write the extension that shows layouts in Blender"
    )
    blender.add_argument(
        "output", type=Path, nargs="?", default=Path("usdrigui_controls.zip"), metavar="ZIP"
    )
    blender.set_defaults(run=_blender_extension)
    return parser


def _blender_extension(arguments: argparse.Namespace) -> Exit:
    from usdrigui.clients.blender_extension import write_extension

    write_extension(arguments.output)
    print(f"usdrigui: written {arguments.output}: install it from disk in Blender's preferences")
    return Exit.OK


def _schema_path(arguments: argparse.Namespace) -> Exit:
    from usdrigui.usd.schema import schema_path

    del arguments
    print(schema_path())
    return Exit.OK


def _config_schema(arguments: argparse.Namespace) -> Exit:
    import json

    from usdrigui.settings.editor_schema import editor_schema

    del arguments
    print(json.dumps(editor_schema(), indent=2))
    return Exit.OK
