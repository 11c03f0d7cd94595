"""What commands share on the command line: common options, and the settings they amount to."""

from __future__ import annotations

import argparse
import dataclasses
import hashlib
import tomllib
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from usdrigui.errors import Exit, refuse

if TYPE_CHECKING:
    from usdrigui.settings import Settings


def command(commands: Any, name: str, run: Callable[[argparse.Namespace], Exit], summary: str) -> Any:
    """A command's parser, with the options that every command has; ``run`` gives its exit code."""
    parser = commands.add_parser(name, help=summary, description=summary[0].upper() + summary[1:] + ".")
    parser.set_defaults(run=run)
    parser.add_argument("--json", action="store_true", help="print one JSON document instead of text")
    parser.add_argument("-q", "--quiet", action="store_true", help="print the verdict line only")
    parser.add_argument("--strict", action="store_true", help="exit 1 if there are warnings")
    return parser


def add_settings(parser: Any) -> None:
    """The options that choose settings; `settings_of` reads them."""
    group = parser.add_argument_group("settings", "docs/settings.md lists all that a configuration can say")
    group.add_argument("--config", type=Path, metavar="TOML", help="default: CHAR.rigui.toml beside CHAR, if there")
    group.add_argument("--preset", default="default", metavar="NAME", help="default, or paper: the paper's constants")
    group.add_argument("--set", action="append", default=[], metavar="PART.KEY=VALUE", help="any one setting")
    group.add_argument("--view", metavar="VIEW", help="front, side, AZ,EL in degrees or a camera prim")
    group.add_argument("--space", choices=("object", "view"), help="space elements in 3-D or as seen from the view")
    group.add_argument("--pose", type=Path, metavar="TOML", help="base pose: a file of control = value lines")
    group.add_argument("--time", type=float, metavar="CODE", help="base pose: the animation at this time code")
    group.add_argument("--gap", type=float, metavar="SHARE", help="relative gap at which to stop")
    group.add_argument("--method", metavar="NAME", help="highs, paper, enumerate or toulbar2")
    group.add_argument("--threads", type=int, metavar="N", help="accepted; the solver runs one thread")
    group.add_argument("--time-limit", type=float, metavar="SECONDS", help="stop solving with the best layout so far")
    group.add_argument("--memory-limit", type=int, metavar="MIB", help="memory that the solver may plan to use")


def settings_of(arguments: argparse.Namespace) -> Settings:
    """Settings of a command, from the weakest to the strongest source."""
    from usdrigui import settings

    sources: list[Mapping[str, Any]] = []
    configuration = _configuration(arguments)
    if configuration is not None:
        sources.append(settings.read_toml(configuration))
    sources += [_assignment(text) for text in getattr(arguments, "set", [])]
    if getattr(arguments, "pose", None):
        sources.append({"read": {"pose": settings.read_toml(arguments.pose)}})
    for option, (part, key) in _OPTIONS.items():
        value = getattr(arguments, option, None)
        if value is not None and value is not False:
            sources.append({part: {key: value}})
    return settings.load(
        *sources,
        preset=getattr(arguments, "preset", "default"),
        environment=settings.environment_settings(),
    )


def settings_digest(arguments: argparse.Namespace) -> str:
    """Digest of everything that the settings of a command say, but for the threads, which change no result."""
    settings = settings_of(arguments)
    settings = dataclasses.replace(settings, solve=dataclasses.replace(settings.solve, threads=0))
    return hashlib.sha256(repr(settings).encode()).hexdigest()


def passed_on(arguments: argparse.Namespace) -> list[str]:
    """The settings of a command as options of another, with files by their absolute paths."""
    passed = []
    for name in ("config", "pose"):
        if getattr(arguments, name) is not None:
            passed += [f"--{name}", str(getattr(arguments, name).absolute())]
    if arguments.preset != "default":
        passed += ["--preset", arguments.preset]
    for text in arguments.set:
        passed += ["--set", text]
    for option in _OPTIONS:
        value = getattr(arguments, option, None)
        if value is not None and value is not False:
            name = f"--{option.replace('_', '-')}"
            passed += [name] if value is True else [f"{name}={value}"]
    return passed


_OPTIONS: Mapping[str, tuple[str, str]] = {
    "view": ("candidates", "view"),
    "space": ("candidates", "space"),
    "time": ("read", "time"),
    "gap": ("solve", "gap"),
    "method": ("solve", "method"),
    "threads": ("solve", "threads"),
    "time_limit": ("solve", "time_limit"),
    "memory_limit": ("solve", "memory_limit"),
    "bare": ("output", "bare"),
}


def _configuration(arguments: argparse.Namespace) -> Path | None:
    given: Path | None = getattr(arguments, "config", None)
    if given is not None:
        return given
    asset: Path | None = getattr(arguments, "asset", None)
    layer: Path | None = getattr(arguments, "layer", None)
    beside = asset.with_suffix(".rigui.toml") if asset is not None else None
    if asset is None and layer is not None:
        beside = layer.with_suffix(".toml")  # char.rigui.usda → char.rigui.toml
    return beside if beside is not None and beside.is_file() else None


def _assignment(text: str) -> Mapping[str, Any]:
    """``solve.gap=1e-3`` as nested tables; the value is TOML, or else a plain word."""
    key, equals, value = text.partition("=")
    part, dot, name = key.partition(".")
    if not (equals and dot):
        raise refuse("CONFIG_VALUE", "--set", f"expected PART.KEY=VALUE, got {text!r}")
    try:
        return {part: {name: tomllib.loads(f"value = {value}")["value"]}}
    except tomllib.TOMLDecodeError:
        return {part: {name: value}}
