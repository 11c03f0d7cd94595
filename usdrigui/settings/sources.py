"""Where settings are written down: configuration files and the environment."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

from usdrigui.errors import refuse
from usdrigui.settings.parts import Settings


def read_toml(path: Path) -> dict[str, Any]:
    """Parse a configuration file; raises FILE_NOT_FOUND or CONFIG_SYNTAX."""
    try:
        with path.open("rb") as stream:
            return tomllib.load(stream)
    except OSError as error:
        raise refuse("FILE_NOT_FOUND", str(path), f"cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise refuse("CONFIG_SYNTAX", str(path), str(error)) from error


def environment_settings() -> dict[str, str]:
    """The environment variables that set something: ``USDRIGUI_<PART>_...`` with a part of `Settings`."""
    parts = {each.name.upper() for each in fields(Settings)}
    return {
        name: value
        for name, value in sorted(os.environ.items())
        if name.startswith("USDRIGUI_") and name.split("_")[1] in parts
    }


def from_environment(environment: Mapping[str, str]) -> dict[str, Any]:
    """``USDRIGUI_SOLVE_GAP=1e-3`` as ``{"solve": {"gap": 0.001}}``; values are TOML literals or plain words.

    Raises RigUIError CONFIG_UNKNOWN_KEY.
    """
    found: dict[str, Any] = {}
    parts = {each.name for each in fields(Settings)}
    for name, text in environment.items():
        part, _, key = name.removeprefix("USDRIGUI_").lower().partition("_")
        if part not in parts or not key:
            raise refuse("CONFIG_UNKNOWN_KEY", name, "no setting has this name")
        try:
            value = tomllib.loads(f"value = {text}")["value"]
        except tomllib.TOMLDecodeError:
            value = text
        found.setdefault(part, {})[key] = value
    return found
