"""load(): settings from nested tables, every key, type and value checked."""

from __future__ import annotations

import math
import os
import sys
import types
import typing
from collections.abc import Mapping
from dataclasses import is_dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, TypeVar

from usdrigui.errors import Faults, RigUIError, meant, refuse
from usdrigui.settings.about import settings_table
from usdrigui.settings.bounds import check_value
from usdrigui.settings.parts import Settings
from usdrigui.settings.presets import presets
from usdrigui.settings.sources import environment_settings, from_environment, read_toml

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

T = TypeVar("T", bound="DataclassInstance")


class UnsoundSettingsError(RigUIError):
    """A configuration that cannot be taken; carries what of it can be."""

    def __init__(self, error: RigUIError, sound: Settings) -> None:
        super().__init__(error.issue, error.exit_code, error.others)
        self.sound = sound


def load(
    *sources: Mapping[str, Any] | Path,
    preset: str = "default",
    environment: Mapping[str, str] | None = None,
) -> Settings:
    """Settings from configurations, each a TOML file or its sections as parsed: ``{"solve":
    {"gap": 0.001}}``; later ones win over earlier ones.

    Raises UnsoundSettingsError CONFIG_UNKNOWN_KEY or CONFIG_VALUE, naming the file and the key; all
    faults at once; and as `read_toml`.
    """
    settings, faults = Settings(), Faults()
    weakest = (_preset(preset, faults), from_environment(environment or {}, faults))
    for source in (*weakest, *sources):
        table = read_toml(source) if isinstance(source, Path) else source
        where, own = "" if table is source else f"in {source}: ", Faults()
        settings = _changed(settings, table, "", own)
        faults.add(replace(each, message=where + each.message) for each in own.issues)
    try:
        faults.raise_all()
    except RigUIError as error:
        raise UnsoundSettingsError(error, settings) from None
    return settings


def load_beside(path: Path) -> Settings:
    """The settings that the commands would take for an asset or its layout: the environment, and
    ``CHAR.rigui.toml``.

    Raises RigUIError CONFIG_...
    """
    files, environment = beside(path), environment_settings()
    ceilings = load(environment=environment)
    return limited(load(*files, environment=environment), ceilings) if files else ceilings


def beside(path: Path) -> list[Path]:
    """``CHAR.rigui.toml`` beside an asset or its layout; none where there is no such file, and of
    what has no name."""
    own = path.parent / f"{path.stem.removesuffix('.rigui')}.rigui.toml"
    # A name too long for a file is an OSError of Path.
    return [own] if path.name and os.path.isfile(own) else []  # noqa: PTH113


def limited(settings: Settings, ceilings: Settings) -> Settings:
    """`settings` of a file beside an asset, which may come from anywhere with it: the limits of the
    run and of reading are at most those of `ceilings`."""
    run, most = settings.run, ceilings.run
    run = replace(
        run,
        time_limit=min(run.time_limit, most.time_limit, key=lambda limit: limit or math.inf),
        memory_limit=min(run.memory_limit, most.memory_limit),
    )
    read, most_read = settings.read, ceilings.read
    read = replace(
        read,
        time_limit=min(read.time_limit, most_read.time_limit),
        memory_limit=min(read.memory_limit, most_read.memory_limit),
        size_limit=min(read.size_limit, most_read.size_limit),
    )
    return replace(settings, run=run, read=read)


def _preset(name: str, faults: Faults) -> Mapping[str, Any]:
    with faults.collected():
        if name not in presets():
            known = " and ".join(sorted(presets()))
            what = f"no preset is called {name!r}; there are {known}{meant(name, presets())}"
            raise refuse("CONFIG_VALUE", "preset", what)
    return presets().get(name, {})


def _changed(current: T, source: Mapping[str, Any], where: str, faults: Faults) -> T:
    """The settings, or a part of them, with what is sound of `source`."""
    hints, changed = typing.get_type_hints(type(current)), dict[str, Any]()
    for key, value in source.items():
        path = f"{where}.{key}" if where else key
        with faults.collected():
            if key not in hints:
                table = {} if where else settings_table()
                inside = [f"{part}.{name}" for part, names in table.items() for name in names]
                hint = meant(key, (*hints, *inside))
                known = hint and f"there is no setting of this name{hint}"
                raise refuse("CONFIG_UNKNOWN_KEY", path, known or f"known here: {', '.join(hints)}")
            converted = _converted(getattr(current, key), hints[key], value, path, faults)
            check_value(path, converted)
            changed[key] = converted
    return replace(current, **changed)


def _converted(current: Any, hint: Any, value: Any, path: str, faults: Faults) -> Any:
    """`value` as a setting of an annotated type; a table changes the `current` one."""
    origin, arguments = typing.get_origin(hint), typing.get_args(hint)
    if origin is types.UnionType:
        hint = arguments[0]
    if is_dataclass(hint) or origin is Mapping:
        if not isinstance(value, Mapping):
            raise refuse("CONFIG_VALUE", path, f"expected a table, got {value!r}")
        if origin is Mapping:
            return _mapping(current, arguments[1], value, path, faults)
        return _changed(current, value, path, faults)
    if origin is tuple:
        if not isinstance(value, (list, tuple)):
            raise refuse("CONFIG_VALUE", path, f"expected a list, got {value!r}")
        return tuple(
            _converted(None, arguments[0], item, f"{path}[{i}]", faults)
            for i, item in enumerate(value)
        )
    if origin is Literal:
        if value not in arguments:
            allowed = ", ".join(map(repr, arguments))
            likely = meant(str(value), filter(None, arguments))
            raise refuse("CONFIG_VALUE", path, f"expected one of {allowed}, got {value!r}{likely}")
        return value
    return _scalar(hint, value, path)


def _mapping(
    current: Mapping[str, Any], hint: Any, table: Mapping[str, Any], path: str, faults: Faults
) -> Mapping[str, Any]:
    merged = dict(current)
    for name, value in table.items():
        base = merged.get(name, hint() if isinstance(hint, type) and is_dataclass(hint) else None)
        with faults.collected():
            merged[name] = _converted(base, hint, value, f'{path}."{name}"', faults)
    return types.MappingProxyType(merged)


def _scalar(hint: Any, value: Any, path: str) -> Any:
    if hint is float and isinstance(value, int) and not isinstance(value, bool):
        value = float(value) if abs(value) <= sys.float_info.max else math.inf
    if not isinstance(value, hint) or (hint is not bool and isinstance(value, bool)):
        raise refuse("CONFIG_VALUE", path, f"expected {hint.__name__}, got {value!r}")
    if hint is float and not math.isfinite(value):
        raise refuse("CONFIG_VALUE", path, f"expected a number, got {value}")
    return value
