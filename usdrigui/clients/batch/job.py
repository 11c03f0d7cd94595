"""One asset of a batch."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Job:
    """One asset to lay out."""

    asset: str
    output: str
    picture: str
    """Where to draw the layout; empty for no picture."""
    options: JobOptions
    named: bool = True
    """Whether the asset was named in full, not found by a pattern."""


@dataclass(frozen=True, slots=True)
class JobOptions:
    """How an asset is laid out."""

    arguments: tuple[str, ...] = ()
    """Further options of `usdrigui process`."""
    settings: str = ""
    """Digest of the settings that these options and the asset's own configuration give."""
    timeout: float = 0.0
    """Seconds after which the process is ended; 0 for never."""
    again: bool = False
    """Lay out even what has not changed."""
