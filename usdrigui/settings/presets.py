"""Settings under one name."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any


@cache
def presets() -> Mapping[str, Mapping[str, Mapping[str, Any]]]:
    """By name, the sections of presets.toml."""
    return tomllib.loads((files(__package__) / "presets.toml").read_text("utf-8"))
