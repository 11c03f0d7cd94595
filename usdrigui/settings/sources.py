"""Where settings are written down: configuration files and the environment."""

from __future__ import annotations

import os
import tomllib
from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

from usdrigui.errors import Faults, refuse
from usdrigui.isolation.foreign_file import whole_content
from usdrigui.settings.parts import Settings


def read_toml(path: Path) -> dict[str, Any]:
    """Parse a configuration file; raises FILE_NOT_FOUND or CONFIG_SYNTAX."""
    try:
        return tomllib.loads(whole_content(path).decode())
    except OSError as error:
        raise refuse(
            "FILE_NOT_FOUND", path, f"cannot be read: {error.strerror or error}"
        ) from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise refuse("CONFIG_SYNTAX", path, str(error)) from error
    except RecursionError:
        raise refuse("CONFIG_SYNTAX", path, "is nested too deeply") from None


def environment_settings() -> dict[str, str]:
    """The environment variables that set something: ``USDRIGUI_<PART>_...`` with a section."""
    parts = {each.name.upper() for each in fields(Settings)}
    return {
        name: value
        for name, value in sorted(os.environ.items())
        if name.startswith("USDRIGUI_") and name.split("_")[1] in parts
    }


def from_environment(environment: Mapping[str, str], faults: Faults) -> dict[str, Any]:
    """``USDRIGUI_SOLVE_GAP=1e-3`` as ``{"solve": {"gap": 0.001}}``; values are TOML literals or
    plain words.

    Collects RigUIError CONFIG_UNKNOWN_KEY.
    """
    found: dict[str, Any] = {}
    parts = {each.name for each in fields(Settings)}
    for name, text in environment.items():
        part, _, key = name.removeprefix("USDRIGUI_").lower().partition("_")
        with faults.collected():
            if part not in parts or not key:
                raise refuse("CONFIG_UNKNOWN_KEY", name, "no setting has this name")
            found.setdefault(part, {})[key] = literal(text)
    return found


def literal(text: str) -> Any:
    """The value that a text is in TOML, or else the text itself."""
    try:
        return tomllib.loads(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, RecursionError):
        return text
