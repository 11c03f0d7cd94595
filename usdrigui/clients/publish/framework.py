"""What the plug-ins need of AYON, and stand-ins for it under plain Pyblish."""

from __future__ import annotations

from typing import Any

import pyblish.api

try:
    from ayon_core.pipeline import PublishValidationError
    from ayon_core.pipeline.publish import OptionalPyblishPluginMixin, RepairAction
except ImportError:

    class PublishValidationError(Exception):  # type: ignore[no-redef]
        """A validation that failed, with what a publisher shows of it; the same arguments as
        AYON's."""

        def __init__(
            self, message: str, title: str = "", description: str = "", detail: str = ""
        ) -> None:
            super().__init__(message)
            self.message = message
            self.title = title
            self.description = description
            self.detail = detail

    class OptionalPyblishPluginMixin:  # type: ignore[no-redef]
        """A plug-in that a publisher may switch off for an instance; Pyblish's own publishers never
        run it then."""

        def is_active(self, data: Any) -> bool:
            """Whether the plug-in is to run for an instance with that data."""
            del data
            return True

    class RepairAction(pyblish.api.Action):  # type: ignore[no-redef]
        """Calls the plug-in's `repair` on every instance that it failed on, as AYON's does."""

        label = "Repair"
        on = "failed"
        icon = "wrench"

        def process(self, context: Any, plugin: Any) -> None:
            """Repair what failed."""
            # Instances are lists, empty ones are equal, and none can be hashed: distinguish them by
            # identity.
            failed = {
                id(result["instance"]): result["instance"]
                for result in context.data["results"]
                if result["error"] is not None and result["plugin"].__name__ == plugin.__name__
            }
            for instance in failed.values():
                plugin.repair(instance)


__all__ = ["OptionalPyblishPluginMixin", "PublishValidationError", "RepairAction"]
