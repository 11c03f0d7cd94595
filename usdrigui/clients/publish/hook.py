"""The three steps of a publish, for any framework or none: judge a layout, repair it, stage it.

No step edits the asset.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from usdrigui import pipeline
from usdrigui.clients.attaching.attach import write_bare
from usdrigui.errors import Issue, RigUIError, by_cause, issue
from usdrigui.settings.loading import load_beside

COLLECTOR = "CollectUSDLayerContributions"
"""AYON's collector of USD contributions."""
TITLE = "Rig UI layout is missing, stale or invalid"
DESCRIPTION = """\
### {title}

The layout layer of `{asset}` cannot be published:

{findings}

**How to repair:** {repair}
"""


def judge(asset: Path, layer: Path, root: str = "") -> tuple[Issue, ...]:
    """Everything that is wrong with the layout of an asset; empty when it may be published.

    Errors of `usdrigui check`, its warnings (a control without slider, two handles on one spot),
    and the refusal if a file is missing, the layer cannot be read, sublayers another asset, or is
    of a character that is not below `root`, where a contribution asks for a root prim of this name.
    """
    for file, code in ((asset, "FILE_NOT_FOUND"), (layer, "LAYOUT_MISSING")):
        if not file.exists():
            return (issue(code, file, "does not exist"),)
    try:
        loaded = pipeline.load_layer(layer, load_beside(asset))
        if Path(loaded.source).resolve() != asset.resolve():
            return (issue("LAYOUT_STALE", layer, f"sublayers {loaded.source}, not {asset}"),)
        for each, _ in loaded.characters if root else ():
            if each.path.split("/")[1] != root:
                what = f"is not below /{root}, which the contribution composes"
                return (issue("PUBLISH_ROOT", each.path, what),)
        found = pipeline.check(layer, load_beside(asset)).issues
    except RigUIError as error:
        return (error.issue,)
    return tuple(each for each in found if each.severity != "info")


def root_of(instance: Mapping[str, Any]) -> str:
    """The name of the root prim of AYON's USD asset, that of its folder, where an instance
    contributes a sublayer to it; empty elsewhere: a variant refers to its default prim."""
    said = instance.get("publish_attributes", {}).get(COLLECTOR, {})
    sublayer = said.get("contribution_enabled") and not said.get("contribution_apply_as_variant")
    return Path(instance.get("folderPath", "")).name if sublayer else ""


def repair(asset: Path, layer: Path) -> str:
    """Lay the asset out anew and write the layer; returns ``written`` or ``unchanged``.

    Raises `usdrigui.errors.RigUIError`; then nothing has been written.
    """
    return pipeline.process(asset, load_beside(asset), output=layer).outcome


def stage(layer: Path, folder: Path) -> Path:
    """A bare copy of the layer in a staging folder: published beside other layers, it must not name
    the asset.

    It is a crate that ends in ``.usd``: AYON expects the representation ``usd`` in a file that ends
    so. Returns its path.  Raises `usdrigui.errors.RigUIError` with a FILE_ code.
    """
    target = folder / layer.with_suffix(".usd").name
    write_bare(layer, target)
    return target


def described(asset: Path, found: Sequence[Issue]) -> str:
    """Some findings as Markdown, for a publisher's report: a line for each cause."""
    causes = by_cause(found)
    lines = [f"- **{each.code}** {each.where}: {each.message}" for each in causes[:20]]
    more = [f"- and {len(causes) - 20} more"] if len(causes) > 20 else []
    repairs = list(dict.fromkeys(each.repair for each in found))
    return DESCRIPTION.format(
        title=TITLE,
        asset=asset.name,
        findings="\n".join(lines + more),
        repair="; or: ".join(
            ["use the repair action, which runs `usdrigui process` again", *repairs[:3]]
        ),
    )
