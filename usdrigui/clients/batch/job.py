"""One asset of a batch: what is asked, and what came of it."""

from __future__ import annotations

from dataclasses import dataclass

from usdrigui.errors import Exit


@dataclass(frozen=True, slots=True)
class Job:
    """One asset to lay out."""

    asset: str
    output: str
    picture: str
    """Where to draw the layout; empty for no picture."""
    named: bool = True
    """Whether the asset was named in full, not found by a pattern."""
    arguments: tuple[str, ...] = ()
    """Further options of `usdrigui process`."""
    settings: str = ""
    """Digest of the settings that these options and the asset's own configuration give."""
    timeout: float = 0.0
    """Seconds after which the process is ended; 0 for never."""
    again: bool = False
    """Lay out even what has not changed."""


@dataclass(frozen=True, slots=True)
class Row:
    """What became of one asset."""

    asset: str
    output: str
    picture: str
    """Empty where none was asked for, and where there is no layout."""
    outcome: str
    """``written``, ``unchanged``, ``skipped`` (nothing has changed since the last batch),
    ``refused``, ``failed``, or ``part``: no character by itself, but a part of another asset of the
    batch."""
    exit: int
    """Exit code that `usdrigui process` gave or would have given."""
    code: str = ""
    """Issue code of a refusal or failure."""
    message: str = ""
    controls: int = 0
    face: int = 0
    board: int = 0
    left_off: int = 0
    gap: float = 0.0
    """Largest relative gap of its characters."""
    warnings: int = 0
    seconds: float = 0.0
    sources: tuple[str, ...] = ()
    """Real paths of the files that composed it; no part of the summary."""

    @property
    def sound(self) -> bool:
        """Whether there is a layout now."""
        return self.exit == Exit.OK and self.outcome != "part"
