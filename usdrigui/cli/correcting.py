"""`pin`, `unpin` and `pins`: a person's decisions about the controls of a layout; and
`bake`: the samples that their keys make."""

from __future__ import annotations

import argparse

from usdrigui.cli.options import settings_of
from usdrigui.cli.outcomes import screen_of, wrote
from usdrigui.errors import Exit, counted, refuse


def pin(arguments: argparse.Namespace) -> Exit:
    """Write decisions into a layer of corrections."""
    decisions: dict[str, str] = {}
    for each in arguments.decisions:
        control, _, value = each.partition("=")
        if not (control and value):
            raise refuse("CONFIG_VALUE", each, "is not CONTROL=PLACE")
        decisions[control] = value
    return _pinned(arguments, decisions, arguments.reason)


def unpin(arguments: argparse.Namespace) -> Exit:
    """Take decisions out of a layer of corrections, or say there that a control is free."""
    return _pinned(arguments, dict.fromkeys(arguments.controls, "free"), "")


def _pinned(arguments: argparse.Namespace, decisions: dict[str, str], reason: str) -> Exit:
    from usdrigui import pipeline

    layer, output = arguments.layer, arguments.output
    state = pipeline.pin(layer, decisions, output, settings_of(arguments), reason)
    return wrote(arguments, {output: state})


def bake(arguments: argparse.Namespace) -> Exit:
    """Write samples from the values that are keyed on the controls of a shot."""
    from usdrigui import pipeline

    state, output = pipeline.bake(arguments.layer, settings_of(arguments), arguments.output)
    return wrote(arguments, {output: state})


def pins(arguments: argparse.Namespace) -> Exit:
    """List the decisions of a layer."""
    from usdrigui import pipeline
    from usdrigui.cli.terminal.table import Table
    from usdrigui.report.documents import document

    found = pipeline.pins(arguments.layer, settings_of(arguments))
    rows = []
    for each in found:
        at = str(each.place)
        if each.place == "point":
            at = ", ".join(f"{x:.6g}" for x in each.position)
        told = {**each.settings, **({"group": ", ".join(each.group)} if each.group else {})}
        more = "; ".join(f"{key} {value}" for key, value in told.items())
        rows.append((each.control, at, more, each.reason))
    screen_of(arguments).show(
        lambda: document("pins", layer=str(arguments.layer), pins=found),
        [
            *([Table("control | place | more | why", rows, below="why")] if rows else ()),
            f"usdrigui: {arguments.layer}: {counted(len(found), 'decision')}",
        ],
    )
    return Exit.OK
