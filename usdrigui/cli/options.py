"""The settings that the options of a command amount to."""

from __future__ import annotations

import argparse
import hashlib
import itertools
import os
import re
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from usdrigui.cli.parser import command_options
from usdrigui.errors import NO_LAYOUT, RigUIError, refuse
from usdrigui.isolation import worker

if TYPE_CHECKING:
    from usdrigui.settings import ReadSettings, Settings, UnsoundSettingsError


def settings_of(arguments: argparse.Namespace) -> Settings:
    """Settings of a command, from the weakest to the strongest source.

    Only the layer names the configuration that belongs to it, so it is read for that where none
    is given.  Raises RigUIError with what that reading raises, and with the CONFIG_ codes, those
    that only the asset shows among them.  The run's budget is known from here on.
    """
    from usdrigui.settings import UnsoundSettingsError

    try:
        found = settings_quietly(arguments)
    except UnsoundSettingsError as error:
        raise _with_faults_of_asset(error, arguments) from None
    worker.budget(found.run.time_limit, found.run.memory_limit)
    return found


def settings_quietly(arguments: argparse.Namespace) -> Settings:
    """As `settings_of`, of a run that is not this one."""
    from usdrigui import settings

    overrides = _said(arguments)

    def load(*weaker: Path) -> Settings:
        preset = getattr(arguments, "preset", "default")
        return settings.load(
            *weaker, *overrides, preset=preset, environment=settings.environment_settings()
        )

    try:
        loaded = load()
    except settings.UnsoundSettingsError as error:
        # Faults of the files are reported with those of the command line.
        try:
            load(*_configuration(arguments, error.sound.read))
        except RigUIError as all_of_it:
            if isinstance(all_of_it, settings.UnsoundSettingsError):
                raise
        raise
    arguments.configuration = files = _configuration(arguments, loaded.read)
    if not files:
        return loaded
    configured = load(*files)
    return configured if getattr(arguments, "config", []) else settings.limited(configured, loaded)


def _with_faults_of_asset(error: UnsoundSettingsError, arguments: argparse.Namespace) -> RigUIError:
    """The error with what of the sound rest the asset does not allow, where the command has
    one."""
    from usdrigui import pipeline

    asset = getattr(arguments, "asset", None) or getattr(arguments, "layer", None)
    return error if asset is None else pipeline.with_faults_of_asset(error, asset)


def settings_of_command_line(arguments: argparse.Namespace) -> Settings:
    """The settings of the options alone, for a command that takes no configuration."""
    from usdrigui import settings

    return settings.load(*_said(arguments))


_SETTINGS = ("config", "preset", "set")
"""Options that give settings, beside those that name theirs."""
_INPUTS = ("asset", "layer", "before", "pose", "fixed", "previous", "like", "base")
_SEVERAL = ("config", "configuration", "animation", "corrections")


def files_read(arguments: argparse.Namespace) -> list[Path]:
    """The files that the command line and the settings name to be read: outputs never replace
    them."""
    named = [getattr(arguments, name, None) for name in _INPUTS]
    several = [each for name in _SEVERAL for each in getattr(arguments, name, ())]
    return [Path(each) for each in (*named, *several) if each]


def _said(arguments: argparse.Namespace) -> list[Mapping[str, Any]]:
    """The settings of the command line, the strongest last."""
    from usdrigui import settings

    sources = [_assignment(text) for text in getattr(arguments, "set", [])]
    for name, option in command_options(arguments):
        value = getattr(arguments, name)
        if "setting" in option and value is not False and value not in (None, []):
            part, _, key = option["setting"].partition(".")
            if "file" in option:
                value = settings.read_toml(value)
            sources.append({part: {key: dict(value) if "variant" in option else value}})
    return sources


def settings_digest(arguments: argparse.Namespace) -> str:
    """Digest of all settings of a command."""
    return hashlib.sha256(repr(settings_quietly(arguments)).encode()).hexdigest()


def passed_on(arguments: argparse.Namespace) -> list[str]:
    """The settings of a command as options of another, with files by their absolute paths."""
    passed = []
    for name, option in command_options(arguments):
        value = getattr(arguments, name)
        is_setting = "setting" in option or name in _SETTINGS
        if not is_setting or value is False or value == option.get("default"):
            continue
        key = f"--{name.replace('_', '-')}"
        values = value if isinstance(value, list) else [value]
        passed += [key if each is True else f"{key}={_spelt(each)}" for each in values]
    return passed


def _spelt(value: Any) -> str:
    """A value of an option as it is written on a command line."""
    if isinstance(value, Path):
        return str(value.absolute())
    return "=".join(value) if isinstance(value, tuple) else str(value)


_WORD = r"""(?:"(?:[^"\\]|\\.)*"|'[^']*'|[^."'=][^.=]*)"""
"""One part of a key: as TOML quotes it, or else anything but a dot; names of controls are no bare
keys of TOML."""
_ASSIGNED = re.compile(rf"({_WORD}(?:\.{_WORD})*)=(.*)", re.DOTALL)


def _configuration(arguments: argparse.Namespace, opening: ReadSettings) -> Sequence[Path]:
    """The configurations of a command: those given, or that of its asset or layer; none if there
    is no such file."""
    from usdrigui.settings.loading import beside

    given: list[Path] = getattr(arguments, "config", [])
    if given:
        return given
    asset: Path | None = getattr(arguments, "asset", None)
    layer: Path | None = getattr(arguments, "layer", None)
    if asset is not None:
        return beside(asset)
    if layer is None:
        return []
    return list(itertools.islice(_of_layer(layer, opening), 1))


def _of_layer(
    layer: Path, opening: ReadSettings, above: frozenset[str] = frozenset()
) -> Iterator[Path]:
    """The configurations of what a command takes as a layout, the first of which counts; `above`
    are layers over it.

    A layout was made with the configuration of the asset below it, wherever the layout itself lies,
    unless it has one of its own name.  An asset may be given as well, by itself or with its layout
    inside: a file `char.toml` beside `char.usda` is somebody else's.
    """
    from usdrigui.reader.reader_process import read_layouts_isolated
    from usdrigui.settings.loading import beside

    try:
        found = read_layouts_isolated(layer, opening)
    except RigUIError as error:
        if error.issue.code not in NO_LAYOUT:
            raise
        # Where the variant selected has no layout, only its name can identify its configuration.
        yield from beside(layer)
        return
    if _same(found.source, layer) or (found.composed_from and not found.source):
        yield from beside(layer)
        return
    own = layer.with_suffix(".toml")  # char.rigui.usda → char.rigui.toml
    if os.path.isfile(own):  # noqa: PTH113 (a name too long for a file is an OSError there)
        yield own
    yield from beside(Path(found.source))
    above |= {os.path.realpath(layer)}
    # Layers can have each other as sublayers, in a circle.
    if found.composed_from and os.path.realpath(found.source) not in above:
        yield from _of_layer(Path(found.source), opening, above)


def _same(first: str, second: Path) -> bool:
    return bool(first) and os.path.realpath(first) == os.path.realpath(second)


def _assignment(text: str) -> Mapping[str, Any]:
    """``solve.gap=1e-3`` as nested tables, however deep; the value is TOML, or else a plain
    word."""
    from usdrigui import settings

    found = _ASSIGNED.fullmatch(text)
    if not found:
        raise refuse("CONFIG_VALUE", "--set", f"expected PART.KEY=VALUE, got {text!r}")
    *parts, last = (_unquoted(word, text) for word in re.findall(_WORD, found[1]))
    tables = {last: settings.literal(found[2])}
    for part in reversed(parts):
        tables = {part: tables}
    return tables


def _unquoted(word: str, text: str) -> str:
    """A part of a key without the quotes that a name with a dot, or an equals sign, needs."""
    if word[0] not in "\"'":
        return word.strip()
    try:
        return str(tomllib.loads(f"word = {word}")["word"])
    except tomllib.TOMLDecodeError as error:
        raise refuse(
            "CONFIG_VALUE", "--set", f"{word} of {text!r} is not a TOML string: {error}"
        ) from error
