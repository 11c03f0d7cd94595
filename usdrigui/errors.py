"""Every way in which usdrigui refuses or complains, by stable code.

A code is never reused or renamed; its catalogue entry says how severe it is and how to repair the
cause.  Library code raises `RigUIError` (via `refuse`) for what stops the run and collects `Issue`
records (via `issue`) for what does not.  Only `usdrigui.cli` turns either into output or an exit code.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import IntEnum
from types import MappingProxyType
from typing import Literal

Severity = Literal["info", "warning", "error"]


class Exit(IntEnum):
    """Process exit codes of every command."""

    OK = 0
    """Written or unchanged; warnings allowed."""
    REFUSED = 1
    """The asset was refused, or `--strict` met a warning."""
    USAGE = 2
    """Wrong command line or configuration."""
    FILE = 3
    """A file could not be read or written."""
    LIMIT = 4
    """A time or memory limit was hit before there was a usable result."""
    BUG = 5
    """A mistake of ours."""


@dataclass(frozen=True, slots=True)
class Code:
    """Catalogue entry of one issue code."""

    severity: Severity
    meaning: str
    """One sentence, without the facts of the case."""
    repair: str
    """What the user can do about it."""
    exit: Exit = Exit.REFUSED
    """Exit code when the issue ends the run."""


@dataclass(frozen=True, slots=True)
class Issue:
    """One finding about an asset, a configuration or a layout."""

    code: str
    severity: Severity
    path: str
    """USD prim path, or the file or settings key when there is no prim; may be empty."""
    message: str
    repair: str


class RigUIError(Exception):
    """The run cannot go on; carries one `Issue` and the exit code it calls for."""

    def __init__(self, found: Issue, exit_code: Exit) -> None:
        super().__init__(f"{found.code} {found.path}: {found.message}")
        self.issue = found
        self.exit_code = exit_code


def issue(code: str, path: str, message: str) -> Issue:
    """Record a finding; `code` must stand in `CODES`."""
    entry = CODES[code]
    return Issue(code, entry.severity, path, message, entry.repair)


def refuse(code: str, path: str, message: str) -> RigUIError:
    """Build (not raise) the error for a finding that ends the run: ``raise refuse(...)``."""
    entry = CODES[code]
    return RigUIError(Issue(code, "error", path, message, entry.repair), entry.exit)


_CODES: dict[str, Code] = {
    # --- files -----------------------------------------------------------------------------------
    "FILE_NOT_FOUND": Code(
        "error", "The file does not exist or cannot be read.", "Check the path and the permissions.", Exit.FILE
    ),
    "FILE_NOT_USD": Code(
        "error", "USD cannot read the file as a layer.", "Re-export the asset as .usd, .usda, .usdc or .usdz."
    ),
    # --- settings --------------------------------------------------------------------------------
    "CONFIG_SYNTAX": Code("error", "The configuration is not valid TOML.", "Correct the line named.", Exit.USAGE),
    "CONFIG_UNKNOWN_KEY": Code(
        "error",
        "The configuration has a key that usdrigui does not know.",
        "Remove or correct the key; docs/settings.md lists all.",
        Exit.USAGE,
    ),
    "CONFIG_VALUE": Code(
        "error", "A setting has a value outside its range or of the wrong type.", "Correct the value.", Exit.USAGE
    ),
    "CONFIG_UNKNOWN_CONTROL": Code(
        "error",
        "The configuration names a control that the asset does not have.",
        "Use a name listed by `usdrigui inspect`.",
        Exit.USAGE,
    ),
    "INTERRUPTED": Code(
        "error", "The run was stopped before there was a result.", "Run it again.", Exit.LIMIT
    ),
    # --- ours ------------------------------------------------------------------------------------
    "BUG": Code("error", "usdrigui made a mistake.", "Please report it with the asset and the command.", Exit.BUG),
}
CODES: Mapping[str, Code] = MappingProxyType(_CODES)
