"""The usdrigui schema: its names, where it lies, and how to register it.

Importing this module loads no USD, and neither does `schema_path`.  Nobody needs the schema
registered to read, write or show a layout: registration serves hosts that want fallback values,
documentation and `HasAPI` queries.
"""

from __future__ import annotations

from pathlib import Path

from usdrigui.errors import refuse

SCOPE = "RigUI"
"""Name of the prim below the SkelRoot that holds a layout."""
VARIANTS = "rigUI"
"""Variant set of the SkelRoot that brings a layout in, or leaves it away."""
WITH, WITHOUT = "ui", "none"
"""Its variants; layers select `WITH` unless a stronger opinion selects another."""

LAYOUT = "RigUILayoutAPI"
PART = "RigUIPartAPI"
DRAWING = "RigUIDrawingAPI"
ELEMENT = "RigUIElementAPI"
ANCHOR = "RigUIAnchorAPI"
HANDLE = "RigUIHandleAPI"
CONTROL = "RigUIControlAPI"
CORRECTION = "RigUICorrectionAPI"
CORRECTIONS = "RigUICorrections"
"""Name of the prim below the SkelRoot that holds the corrections of a person."""
APIS = (LAYOUT, PART, DRAWING, ELEMENT, ANCHOR, HANDLE, CONTROL, CORRECTION)
ROLE = "rigUI:role"
ROLES = ("handle", "track", "area")
"""Primvar of a drawing, and what each of its faces is by it."""
NOTES = "usdrigui"
"""Key of the customData in which usdrigui keeps its own books: no part of the schema."""


def is_layout(applied: str) -> bool:
    """Whether an applied schema marks a layout, of whichever version."""
    return applied == LAYOUT or (is_later(applied) and applied.startswith(f"{LAYOUT}_"))


def is_later(applied: str) -> bool:
    """Whether an applied schema is a later version of one of ours (schemas/CONTRACT.md)."""
    family, _, version = applied.partition(":")[0].partition("_")
    return family in APIS and version.isdigit()


def shipped(name: str, mark: str, code: str) -> Path:
    """A folder that comes with us, and has the file `mark`: in an installed package inside it, in a
    source tree beside it.  Raises the `code` when it is in neither place."""
    package = Path(__file__).resolve().parents[1]
    for folder in (package / name, package.parent / name):
        if (folder / mark).is_file():
            return folder
    raise refuse(code, package / name, f"has no {mark}")


def schema_path() -> Path:
    """Folder with plugInfo.json and generatedSchema.usda, for ``PXR_PLUGINPATH_NAME``; raises
    SCHEMA_MISSING."""
    return shipped("schemas", "plugInfo.json", "SCHEMA_MISSING")


def register() -> None:
    """Register the schema with the USD of this process; does nothing if it is registered already.

    USD builds its schema registry once, when the first stage is opened, and ignores plug-ins that
    come later without a word.  Raises SCHEMA_TOO_LATE in that case, SCHEMA_MISSING where the folder
    is not found.
    """
    from pxr import Plug, Usd

    # Asking the schema registry would build it, so register first and look afterwards.
    Plug.Registry().RegisterPlugins(str(schema_path()))
    registry = Usd.SchemaRegistry()
    lacking = [name for name in APIS if registry.FindAppliedAPIPrimDefinition(name) is None]
    if lacking:
        raise refuse("SCHEMA_TOO_LATE", schema_path(), f"USD does not know {', '.join(lacking)}")
