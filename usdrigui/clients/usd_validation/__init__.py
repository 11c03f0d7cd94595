"""Our checks as validators of USD itself (UsdValidation, USD 26.5 and later).

plugInfo.json beside this file describes a plug-in, `usdrigui.clients.usd_validation.tasks`, that
USD imports when its validators are asked for.  With `plugin_path()` in ``PXR_PLUGINPATH_NAME``
every application that runs validators finds them; `register` makes them known to this process.
"""

from __future__ import annotations

import importlib
from pathlib import Path

NAME = "usdrigui.clients.usd_validation.tasks"
"""Name of the plug-in; a validator's name is this, a colon, and BlendShapes, ShapeWeights or
Layouts."""


def plugin_path() -> Path:
    """The folder for ``PXR_PLUGINPATH_NAME``; loads no USD."""
    return Path(__file__).parent


def register() -> None:
    """Make the validators known to the USD of this process, even if it has looked for validators
    before."""
    from pxr import Plug, UsdValidation

    Plug.Registry().RegisterPlugins(str(plugin_path()))
    known = {each.name for each in UsdValidation.ValidationRegistry().GetAllValidatorMetadata()}
    if f"{NAME}:Layouts" not in known:
        importlib.import_module(NAME)
