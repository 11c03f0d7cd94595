"""The schema of in-situ rig UI layouts, without code: ``import usdrigui_schemas`` before the first
stage is opened.

The import registers the schema with the USD of this process, where there is one.  Programs without
Python put the folder, `PATH`, on ``PXR_PLUGINPATH_NAME``; so does a process in which USD has opened
a stage already, for the next one.
"""

from pathlib import Path

PATH = Path(__file__).resolve().parent
"""Folder with plugInfo.json and generatedSchema.usda."""

try:
    from pxr import Plug
except ImportError:
    pass
else:
    Plug.Registry().RegisterPlugins(str(PATH))
