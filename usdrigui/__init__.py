"""usdrigui: the USD pipeline step that gives any character its in-situ rig UI.

The stable Python interface, loaded when first used; importing the package loads no USD:

    report = usdrigui.process("char.usda")     # writes char.rigui.usda beside it
    layout = usdrigui.open("char.rigui.usda")  # or a Usd.Stage that is open, or an Sdf.Layer
    layout.controls, layout.pose({"jawOpen": 0.5}), layout.picture(), layout.view(), layout.check()

docs/python.ipynb shows all of it.
"""

from __future__ import annotations

import importlib

from usdrigui.version import __version__

TYPE_CHECKING = False  # `typing` takes most of the time before the command handles signals
if TYPE_CHECKING:
    from typing import Any

    from usdrigui.errors import Issue, RigUIError
    from usdrigui.interface import OpenLayout, bake, check, diff, inspect, open, process  # noqa: A004
    from usdrigui.pipeline import Event, LayerDifference, LayerReview
    from usdrigui.report.inspection import Inspection
    from usdrigui.report.run_report import Report
    from usdrigui.settings import Settings, load as load_settings

_HOMES = {
    "Event": ("usdrigui.pipeline", "Event"),
    "Inspection": ("usdrigui.report.inspection", "Inspection"),
    "Issue": ("usdrigui.errors", "Issue"),
    "LayerDifference": ("usdrigui.pipeline", "LayerDifference"),
    "LayerReview": ("usdrigui.pipeline", "LayerReview"),
    "OpenLayout": ("usdrigui.interface", "OpenLayout"),
    "Report": ("usdrigui.report.run_report", "Report"),
    "RigUIError": ("usdrigui.errors", "RigUIError"),
    "Settings": ("usdrigui.settings", "Settings"),
    "bake": ("usdrigui.interface", "bake"),
    "check": ("usdrigui.interface", "check"),
    "diff": ("usdrigui.interface", "diff"),
    "inspect": ("usdrigui.interface", "inspect"),
    "load_settings": ("usdrigui.settings", "load"),
    "open": ("usdrigui.interface", "open"),
    "process": ("usdrigui.interface", "process"),
}

__all__ = [
    "Event",
    "Inspection",
    "Issue",
    "LayerDifference",
    "LayerReview",
    "OpenLayout",
    "Report",
    "RigUIError",
    "Settings",
    "__version__",
    "bake",
    "check",
    "diff",
    "inspect",
    "load_settings",
    "open",
    "process",
]


def __dir__() -> list[str]:
    return sorted(__all__)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'usdrigui' has no attribute {name!r}")
    module, attribute = _HOMES[name]
    return getattr(importlib.import_module(module), attribute)
