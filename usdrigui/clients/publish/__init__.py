"""Layouts in a studio's publish: plug-ins for Pyblish and AYON, and the same three steps without a
framework.

import usdrigui.clients.publish
usdrigui.clients.publish.register()          # or add plugin_folder() to PYBLISHPLUGINPATH
"""

from __future__ import annotations

from pathlib import Path


def plugin_folder() -> Path:
    """The folder with the Pyblish plug-ins, for ``PYBLISHPLUGINPATH``; needs no Pyblish."""
    return Path(__file__).parent / "plugins"


def register() -> None:
    """Make the plug-ins known to the Pyblish of this process."""
    import pyblish.api

    pyblish.api.register_plugin_path(str(plugin_folder()))
