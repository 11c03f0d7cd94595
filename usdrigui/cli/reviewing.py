"""`check` and `diff`: what became of a layout, and how two differ."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from usdrigui.cli.options import (
    add_each_variant,
    add_settings,
    add_variant,
    command,
    settings_of,
    settings_of_command_line,
)
from usdrigui.cli.outcomes import screen_of, strict
from usdrigui.errors import Exit


def add_check(commands: Any) -> None:
    """Add ``check`` to the commands."""
    parser = command(
        commands,
        "check",
        _check,
        "check that a layout still fits its rig, or that an asset is valid",
    )
    parser.set_defaults(written="")  # it only reads, whatever comes of it
    parser.add_argument(
        "layer",
        type=Path,
        metavar="LAYER",
        help="a layout layer over its character, or the character itself",
    )
    add_each_variant(parser, "check every variant of this set")
    add_settings(parser, layer=True)


def add_diff(commands: Any) -> None:
    """Add ``diff`` to the commands."""
    parser = command(
        commands,
        "diff",
        _diff,
        "list the controls that two layouts of a character place differently, and why",
    )
    parser.set_defaults(written="")  # it only reads, whatever comes of it
    parser.add_argument("before", type=Path, metavar="BEFORE", help="a layout layer")
    parser.add_argument(
        "layer", type=Path, metavar="AFTER", help="another layout layer of the same character"
    )
    add_variant(parser)
    add_each_variant(parser, "compare every variant of this set")


def _check(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.report import run_report

    screen = screen_of(arguments)
    with screen.progress() as shown:
        found = pipeline.check(arguments.layer, settings_of(arguments), progress=shown)
    if arguments.json:
        sys.stdout.write(run_report.review_json(found.layer, found.characters, found.issues))
    else:
        screen.review(found)
    if any(each.severity == "error" for each in found.issues):
        return Exit.REFUSED
    return strict(found.issues, arguments)


def _diff(arguments: argparse.Namespace) -> Exit:
    from usdrigui import pipeline
    from usdrigui.report import run_report

    found = pipeline.diff(arguments.before, arguments.layer, settings_of_command_line(arguments))
    if arguments.json:
        sys.stdout.write(
            run_report.difference_json(
                found.before, found.after, found.characters, found.only_in_one
            )
        )
    else:
        screen_of(arguments).difference(
            found.before, found.after, found.characters, found.only_in_one
        )
    return Exit.REFUSED if arguments.strict and not found.empty else Exit.OK
