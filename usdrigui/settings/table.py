"""What is known of each setting, beside its field: documentation, unit, bounds and who needs it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import Field, dataclass, field, fields
from typing import Any, Literal

Level = Literal["user", "expert", "paper"]
"""``user``: somebody sees its effect in a layout; ``expert``: limits and thresholds of the stages;
``paper``: what only the preset ``paper`` needs."""


@dataclass(frozen=True, slots=True)
class About:
    """One setting."""

    doc: str
    unit: str
    bounds: tuple[float, float] | None
    """Least and largest value of a number; what lies outside has no meaning and would only fail
    later."""
    level: Level


def setting(
    default: Any,
    doc: str,
    *,
    unit: str = "",
    bounds: tuple[float, float] | None = None,
    level: Level = "user",
) -> Any:
    """A field of a settings dataclass; a dict as default stands for an empty table."""
    known = {"about": About(" ".join(doc.split()), unit, bounds, level)}
    if isinstance(default, dict):
        return field(default_factory=dict, metadata=known)
    return field(default=default, metadata=known)


def settings_in(part: Any) -> Iterator[tuple[Field[Any], About]]:
    """The settings of a settings dataclass, in order."""
    for each in fields(part):
        if "about" in each.metadata:
            yield each, each.metadata["about"]
