"""The command line as commands.toml has it: its parser, and what was meant where it is wrong."""

from __future__ import annotations

import argparse
import re
import sys
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, NoReturn

from usdrigui.errors import meant, refuse
from usdrigui.version import __version__

_LAYOUT = "LAYER.toml, or else CHAR.rigui.toml beside the CHAR below LAYER"
_ASSET = "CHAR.rigui.toml beside CHAR"
"""The configuration that a command takes where none is given."""


@cache
def command_table() -> dict[str, Any]:
    """What commands.toml holds."""
    return tomllib.loads((files(__package__) / "commands.toml").read_text("utf-8"))


def parsed(argv: Sequence[str]) -> argparse.Namespace:
    """The command line.  Raises RigUIError COMMAND_LINE for a wrong one, with the option that was
    meant, after the usage of its command is printed."""
    whole = parser()
    arguments, unknown = whole.parse_known_args(_with_negative_values(argv))
    if unknown:
        command = arguments.command
        what = f"unrecognized arguments: {' '.join(unknown)}{_hint(command, unknown, whole)}"
        whole.commands[command].error(what)
    return arguments


def _with_negative_values(argv: Sequence[str]) -> list[str]:
    """``--view -90,0`` as ``--view=-90,0``: argparse takes for an option what begins with a hyphen
    and is no number."""
    words: list[str] = []
    for word in argv:
        if words and re.match(r"-\.?\d", word) and re.fullmatch("--[a-z][a-z-]*", words[-1]):
            words[-1] += f"={word}"
        else:
            words.append(word)
    return words


class CommandLine(argparse.ArgumentParser):
    """As argparse's, with errors as all others."""

    commands: Mapping[str, argparse.ArgumentParser]

    def error(self, message: str) -> NoReturn:
        """Print the usage and raise the error."""
        self.print_usage(sys.stderr)
        misspelt = re.search(r"argument COMMAND: invalid choice: '([^']*)'", message)
        message += meant(misspelt[1], self.commands) if misspelt else ""
        raise refuse("COMMAND_LINE", self.prog, message)


@cache
def parser() -> CommandLine:
    """The parser of all commands; `run` of what it parses names the function of the command,
    `light` whether that needs no worker."""
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
    for name, about in command_table()["commands"].items():
        _add_command(commands, name, about)
    parser.commands = commands.choices
    return parser


def _add_command(commands: Any, name: str, about: Mapping[str, Any]) -> None:
    summary = about["summary"]
    command = commands.add_parser(
        name, help=summary, description=summary[0].upper() + summary[1:] + "."
    )
    light = about.get("light")
    command.set_defaults(command=name, run=about["run"], light=light)
    if about.get("reads"):
        command.set_defaults(written="")
    arguments = about.get("arguments", {})
    for key, argument in arguments.items():
        _add(command, key, argument)
    groups: dict[str | None, Any] = {None: command}
    for each in sorted(_tables(about), key=lambda known: "title" in known):
        title = each.get("title")
        if title not in groups:
            groups[title] = command.add_argument_group(title, each.get("about"))
        default = _LAYOUT if "layer" in arguments else _ASSET
        for key, option in each.get("options", {}).items():
            help_text = option["help"].replace("{configuration}", default)
            _add(groups[title], f"--{key}", {**option, "help": help_text})


def _tables(about: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """The sets of options that a command has, and then its own."""
    return [*(command_table()["sets"][name] for name in about.get("sets", ())), about]


def command_options(arguments: argparse.Namespace) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """The options of the command that was parsed, by the names of their values."""
    about = command_table()["commands"][arguments.command]
    for each in _tables(about):
        for key, option in each.get("options", {}).items():
            yield key.replace("-", "_"), option


def _variant(text: str) -> tuple[str, str]:
    """``LOD=low``, as usdchecker's ``LOD:low`` too."""
    found = re.fullmatch("([^=:]+)[=:](.+)", text)
    if not found:
        raise argparse.ArgumentTypeError(f"expected SET=NAME, got {text!r}")
    return found[1], found[2]


_KINDS = {"file": Path, "text": str, "number": float, "count": int, "variant": _variant}


def _add(group: Any, name: str, about: Mapping[str, Any]) -> None:
    """One argument, or an option where the name begins with dashes."""
    given = {key: about[key] for key in ("help", "choices", "default", "required") if key in about}
    is_option = name.startswith("--")
    kind = next((each for each in _KINDS if each in about), None)
    if kind is None:
        given["action"] = "store_true"
    else:
        given |= {"type": _KINDS[kind], "metavar": about[kind] or None}
    if about.get("many"):
        given |= {"action": "append", "default": []}
    if about.get("optional"):
        given["nargs"] = "?"
    if about.get("several"):
        given |= {"nargs": "+", **({"action": "extend", "default": []} if is_option else {})}
    group.add_argument(*filter(None, (about.get("short"), name)), **given)


# --- what was meant -------------------------------------------------------------------------------


def _hint(command: str, unknown: Sequence[str], whole: CommandLine) -> str:
    """A hint for the first unknown option that has one."""
    every = {name: options_of(each) for name, each in whole.commands.items()}
    options = [each.partition("=")[0] for each in unknown if each.startswith("-")]
    return next(filter(None, (hint(each, command, every) for each in options)), "")


def options_of(parser: argparse.ArgumentParser) -> list[str]:
    """The options of a command as its usage has them, the short form where there is one."""
    return re.findall(r"(?<![\w-])--?[a-z][a-z-]*", parser.format_usage())


def hint(option: str, command: str, every: Mapping[str, Sequence[str]]) -> str:
    """A clause for the error about an unknown `option` of a command; empty where nothing is like
    it.  `every`: the options of each command."""
    own = every[command]
    synonyms = [each.split() for each in command_table()["synonyms"]]
    words: list[str] = next((each for each in synonyms if option in each), [])
    same = next((each for each in words if each in own), "")
    if same:
        return f"; did you mean {same!r}?"
    others = [name for name, options in every.items() if option in options]
    if option in synonyms[0] and "--json" in own:
        return "; its result is printed: --json > FILE keeps it"
    return f"; that is an option of {', '.join(others)}" if others else meant(option, own)
