"""What is known of each setting beside its type and default: documentation, unit, bounds and who
needs it."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Literal

Level = Literal["user", "expert", "paper"]
"""``user``: somebody sees its effect in a layout; ``expert``: limits and thresholds of the stages;
``paper``: what only the preset ``paper`` needs."""


@dataclass(frozen=True, slots=True)
class About:
    """One setting."""

    doc: str
    unit: str = ""
    bounds: Sequence[float] = ()
    """Least and largest value of a number; what lies outside has no meaning and would only fail
    later."""
    level: Level = "user"


@cache
def settings_table() -> Mapping[str, Mapping[str, About]]:
    """By section and name, in the order of about.toml."""
    sections = tomllib.loads((files(__package__) / "about.toml").read_text("utf-8"))
    return {
        section: {name: About(**known) for name, known in settings.items()}
        for section, settings in sections.items()
    }
