"""`schema-path`, `config-schema` and `blender-extension`: what other programs are given of us."""

from __future__ import annotations

import argparse

from usdrigui.errors import Exit


def schema_path(_: argparse.Namespace) -> Exit:
    """Print where the schema lies."""
    from usdrigui.usd.schema import schema_path

    print(schema_path())
    return Exit.OK


def config_schema(_: argparse.Namespace) -> Exit:
    """Print the JSON Schema of a configuration."""
    import json

    from usdrigui.settings.editor_schema import editor_schema

    print(json.dumps(editor_schema(), indent=2))
    return Exit.OK


def blender_extension(arguments: argparse.Namespace) -> Exit:
    """Write the archive that Blender installs."""
    from usdrigui.clients.blender_extension import write_extension

    write_extension(arguments.output)
    print(f"usdrigui: written {arguments.output}: install it from disk in Blender's preferences")
    return Exit.OK
