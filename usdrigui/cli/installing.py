"""`sample`, and what other programs are given of us: `schema-path`, `conform`, `config-schema` and
`blender-extension`."""

from __future__ import annotations

import argparse
import shlex
from importlib.resources import files

from usdrigui.errors import Exit, refuse


def sample(arguments: argparse.Namespace) -> Exit:
    """Copy the sample character into a folder."""
    from usdrigui.isolation.foreign_file import whole_content
    from usdrigui.replacing.transaction import commit
    from usdrigui.stages.schema import shipped

    sources = shipped("sample_assets", "char.usda", "BUG").glob("*.usda")
    contents = {arguments.folder / each.name: each.read_bytes() for each in sorted(sources)}
    for target, content in contents.items():
        if target.exists() and whole_content(target) != content:
            raise refuse("FILE_TARGET", target, "is not the sample's, and is left as it is")
    for target, content in contents.items():
        print(f"usdrigui: {commit(content, target)} {target}")
    return Exit.OK


def schema_path(_: argparse.Namespace) -> Exit:
    """Print where the schema lies."""
    from usdrigui.stages.schema import schema_path

    print(schema_path())
    return Exit.OK


def conform(arguments: argparse.Namespace) -> Exit:
    """Ask a reader of layouts the questions of the conformance suite."""
    from usdrigui.cli.outcomes import screen_of
    from usdrigui.clients import conforming
    from usdrigui.report.documents import document

    found = tuple(conforming.conform(shlex.split(arguments.reader)))
    wrong = sum(len(each.wrong) for each in found)
    count, left = (sum(getattr(each, name) for each in found) for name in ("count", "unanswered"))
    screen_of(arguments).show(
        lambda: document("conform", reader=arguments.reader, layers=found),
        [
            *(f"wrong: {each.case}: {what}" for each in found for what in each.wrong),
            f"usdrigui: {wrong} wrong, {left} unanswered of {count} answers about {len(found)}"
            " layers",
        ],
    )
    return Exit.REFUSED if wrong else Exit.OK


def config_schema(_: argparse.Namespace) -> Exit:
    """Print the JSON Schema of a configuration."""
    print((files("usdrigui.settings") / "editor_schema.json").read_text("utf-8"), end="")
    return Exit.OK


def blender_extension(arguments: argparse.Namespace) -> Exit:
    """Write the archive that Blender installs."""
    from usdrigui.clients.blender_extension import write_extension

    write_extension(arguments.output)
    print(f"usdrigui: written {arguments.output}: install it from disk in Blender's preferences")
    return Exit.OK
