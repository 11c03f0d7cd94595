"""What was meant by an option that a command does not have: another spelling, its own option for
the same thing, or another command."""

from __future__ import annotations

import argparse
import re
from collections.abc import Mapping, Sequence

from usdrigui.errors import meant

_SAME = (
    "-o --output --out --outfile --html --svg --png --output-dir --folder --preview --save",
    "-n --dry-run --no-write --simulate",
    "-c --config --configuration --settings --conf",
    "-s --set --option --preset",
    "-q --quiet --silent",
    "-j --jobs --workers --threads --processes",
    "--time-limit --timeout --limit --max-time",
    "--memory-limit --memory --max-memory",
    "--variant --each-variant --variants --lod --lods",
    "--previous --prior --earlier --from --keep --fixed",
    "--animation --anim --clip --take --frames",
    "--report --summary --sheet --log",
    "--labels --names",
    "--strict --werror --fail-on-warnings",
)
"""Options that programs of the field have for one thing; of those that a command has, the first is
suggested."""
_OUTPUTS = _SAME[0].split()


def options_of(parser: argparse.ArgumentParser) -> list[str]:
    """The options of a command as its usage has them, the short form where there is one."""
    return re.findall(r"(?<![\w-])--?[a-z][a-z-]*", parser.format_usage())


def hint(option: str, command: str, every: Mapping[str, Sequence[str]]) -> str:
    """A clause for the error about an unknown `option` of a command; empty where nothing is like
    it.  `every`: the options of each command."""
    own = every[command]
    words = next((each.split() for each in _SAME if option in each.split()), [])
    same = next((each for each in words if each in own), "")
    if same:
        return f"; did you mean {same!r}?"
    others = [name for name, options in every.items() if option in options]
    if option in _OUTPUTS and "--json" in own:
        return "; its result is printed: --json > FILE keeps it"
    return f"; that is an option of {', '.join(others)}" if others else meant(option, own)
