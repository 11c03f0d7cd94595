"""`attach` and `detach`: a layout among the sublayers or payloads of the asset itself."""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from usdrigui.cli.options import add_variant, command, settings_of
from usdrigui.cli.outcomes import say, strict
from usdrigui.errors import Exit, Issue, sentences


def add_attach(commands: Any) -> None:
    """Add ``attach`` to the commands."""
    parser = command(
        commands,
        "attach",
        _attach,
        "put a bare layout layer among the sublayers or payloads of the asset itself",
    )
    _add_files(parser, "written by `usdrigui process --bare`")
    parser.add_argument(
        "--payload",
        action="store_true",
        help="make the layer a payload in the variant rigUI = ui: shots that select `none`"
        " do not load it",
    )


def add_detach(commands: Any) -> None:
    """Add ``detach`` to the commands."""
    parser = command(commands, "detach", _detach, "remove an attached layout layer from the asset")
    _add_files(parser, "the layer to remove; its file need not exist")


def _add_files(parser: Any, layer: str) -> None:
    """The arguments asset, layer (with the help `layer`) and variant."""
    parser.add_argument(
        "asset", type=Path, metavar="CHAR", help="the asset's root layer, which is edited"
    )
    parser.add_argument("layer", type=Path, metavar="LAYER", help=layer)
    add_variant(parser)


def _attach(arguments: argparse.Namespace) -> Exit:
    from usdrigui.usd.attach import attach

    found: list[Issue] = []
    state = attach(
        arguments.asset,
        arguments.layer,
        settings_of(arguments),
        found.append,
        payload=arguments.payload,
    )
    return _edited(state, "is attached", found, arguments)


def _detach(arguments: argparse.Namespace) -> Exit:
    from usdrigui.usd.attach import detach

    state = detach(arguments.asset, arguments.layer, settings_of(arguments))
    return _edited(state, "is not attached", (), arguments)


def _edited(state: str, what: str, issues: Sequence[Issue], arguments: argparse.Namespace) -> Exit:
    code = strict(issues, arguments)
    if arguments.json:
        document = {
            "asset": str(arguments.asset),
            "layer": str(arguments.layer),
            "outcome": state,
            "exit": int(code),
            "issues": [asdict(each) for each in issues],
        }
        print(json.dumps({"format": "usdrigui.attach", "version": 1, **document}, indent=2))
    for each in () if arguments.quiet else issues:
        say(f"{each.severity}: {each.code} {each.where}: {sentences(each)}", arguments)
    say(f"usdrigui: {state} {arguments.asset}: {arguments.layer} {what}", arguments)
    return code
