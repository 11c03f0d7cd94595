"""What a batch remembers of an asset, in a small file beside its layer, so that it can be skipped
next time.

``char.rigui.usda`` has ``char.rigui.batch.json``.  An asset is skipped when its settings, our
version, every file that composed it, the layer and the picture, if one is asked for, are what they
were.
"""

from __future__ import annotations

import contextlib
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from usdrigui.clients.batch.job import Job
from usdrigui.errors import RigUIError
from usdrigui.isolation.foreign_file import hashed, whole_content
from usdrigui.replacing.transaction import commit
from usdrigui.version import __version__

FORMAT = "usdrigui.batch.state"
VERSION = 1


def state_path(output: str) -> Path:
    """The file that remembers how a layer was made."""
    return Path(output).with_suffix(".batch.json")


def recall(job: Job) -> dict[str, Any] | None:
    """The row of the last batch, if laying out again would give the same; else None, whatever the
    file holds."""
    try:
        known = json.loads(whole_content(state_path(job.output)))
        about = _about(job, known["sources"])
        if not job.picture:
            about["picture"] = known["about"][
                "picture"
            ]  # one that nobody asks for now changes nothing
        # Names are of this batch: the last one may have been started in another folder.
        row = {**known["row"], "asset": job.asset, "output": job.output, "picture": job.picture}
        return (
            {**row, "sources": _paths(job, known["sources"])} if known["about"] == about else None
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return None


def remember(job: Job, sources: Sequence[Mapping[str, str]], row: Mapping[str, Any]) -> None:
    """Write the file; where that fails, the asset is laid out again next time."""
    with contextlib.suppress(OSError, RigUIError):
        about = _about(job, sources)
        row = {key: value for key, value in row.items() if key != "sources"}
        document = {
            "format": FORMAT,
            "version": VERSION,
            "about": about,
            "sources": list(sources),
            "row": row,
        }
        # A file changed since it was read must not count as laid out.
        if about["sources"] == [each["sha256"] for each in sources]:
            commit(json.dumps(document, indent=2) + "\n", state_path(job.output), read=[job.asset])


def forget(job: Job) -> None:
    """Remove the file: its content may be wrong from now on."""
    with contextlib.suppress(OSError):
        state_path(job.output).unlink()


def _about(job: Job, sources: Sequence[Mapping[str, str]]) -> dict[str, Any]:
    """Everything that the result depends on, as it is now; raises OSError where a file is gone."""
    return {
        "usdrigui": __version__,
        "settings": job.options.settings,
        "asset": os.path.relpath(
            os.path.realpath(job.asset), os.path.realpath(Path(job.output).parent)
        ),
        "sources": [hashed(each).sha256 for each in _paths(job, sources)],
        "output": hashed(job.output).sha256,
        "picture": hashed(job.picture).sha256 if job.picture else "",
    }


def _paths(job: Job, sources: Sequence[Mapping[str, str]]) -> tuple[str, ...]:
    """The files that composed an asset, by their real paths."""
    folder = Path(job.asset).parent
    return tuple(os.path.realpath(folder / each["path"]) for each in sources)
