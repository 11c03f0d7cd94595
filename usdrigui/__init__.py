"""usdrigui: the USD pipeline step that gives any character its in-situ rig UI.

The stable Python interface, loaded when first used; importing the package loads no USD:

    report = usdrigui.process(Path("char.usda"), usdrigui.load_settings())
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from usdrigui.errors import Issue, RigUIError
    from usdrigui.inspection import Inspection
    from usdrigui.pipeline import inspect, process
    from usdrigui.report import Report
    from usdrigui.settings import Settings
    from usdrigui.settings import load as load_settings

_HOMES = {
    "Inspection": ("usdrigui.inspection", "Inspection"),
    "Issue": ("usdrigui.errors", "Issue"),
    "Report": ("usdrigui.report", "Report"),
    "RigUIError": ("usdrigui.errors", "RigUIError"),
    "Settings": ("usdrigui.settings", "Settings"),
    "inspect": ("usdrigui.pipeline", "inspect"),
    "load_settings": ("usdrigui.settings", "load"),
    "process": ("usdrigui.pipeline", "process"),
}

__all__ = [
    "Inspection",
    "Issue",
    "Report",
    "RigUIError",
    "Settings",
    "__version__",
    "inspect",
    "load_settings",
    "process",
]


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'usdrigui' has no attribute {name!r}")
    module, attribute = _HOMES[name]
    return getattr(importlib.import_module(module), attribute)
