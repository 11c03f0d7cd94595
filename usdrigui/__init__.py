"""usdrigui: the USD pipeline step that gives any character its in-situ rig UI.

The stable Python interface, loaded when first used; importing the package loads no USD:

    settings = usdrigui.load_settings()
    report = usdrigui.process(Path("char.usda"), settings)            # writes char.rigui.usda beside it
    found = usdrigui.check(Path("char.rigui.usda"), settings).issues  # empty: it still fits
"""

from __future__ import annotations

import importlib

from usdrigui.version import __version__

TYPE_CHECKING = False  # `typing` takes most of the time before the command heeds signals
if TYPE_CHECKING:
    from typing import Any

    from usdrigui.errors import Issue, RigUIError
    from usdrigui.inspection import Inspection
    from usdrigui.pipeline import LayerDifference, LayerReview, check, diff, inspect, process
    from usdrigui.report import Report
    from usdrigui.settings import Settings
    from usdrigui.settings import load as load_settings

_HOMES = {
    "Inspection": ("usdrigui.inspection", "Inspection"),
    "Issue": ("usdrigui.errors", "Issue"),
    "LayerDifference": ("usdrigui.pipeline", "LayerDifference"),
    "LayerReview": ("usdrigui.pipeline", "LayerReview"),
    "Report": ("usdrigui.report", "Report"),
    "RigUIError": ("usdrigui.errors", "RigUIError"),
    "Settings": ("usdrigui.settings", "Settings"),
    "check": ("usdrigui.pipeline", "check"),
    "diff": ("usdrigui.pipeline", "diff"),
    "inspect": ("usdrigui.pipeline", "inspect"),
    "load_settings": ("usdrigui.settings", "load"),
    "process": ("usdrigui.pipeline", "process"),
}

__all__ = [
    "Inspection",
    "Issue",
    "LayerDifference",
    "LayerReview",
    "Report",
    "RigUIError",
    "Settings",
    "__version__",
    "check",
    "diff",
    "inspect",
    "load_settings",
    "process",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'usdrigui' has no attribute {name!r}")
    module, attribute = _HOMES[name]
    return getattr(importlib.import_module(module), attribute)
