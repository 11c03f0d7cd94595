"""What a batch remembers of an asset, in a small file beside its layer, so that it can be skipped
next time.

``char.rigui.usda`` has ``char.rigui.batch.json``: the files that composed the asset, the counts of
its layout, and a digest over these, the settings, our version, the content of the files and of the
layer; a second digest is that of the picture.  An asset is skipped when both are what they were.
A file in which anything is wrong counts as none.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from usdrigui.clients.batch.job import Job, Row
from usdrigui.errors import Exit, RigUIError
from usdrigui.isolation.foreign_file import hashed, whole_content
from usdrigui.replacing.transaction import commit
from usdrigui.version import __version__

FORMAT = "usdrigui.batch.state"
VERSION = 2
_COUNTS = ("controls", "face", "board", "left_off", "warnings", "gap")
"""Columns of a row that are remembered; all others are made anew."""


def state_path(output: str) -> Path:
    """The file that remembers how a layer was made."""
    return Path(output).with_suffix(".batch.json")


def recall(job: Job) -> Row | None:
    """The row of an asset whose layout would come out the same; None where that is not certain,
    whatever the file holds."""
    try:
        known = json.loads(whole_content(state_path(job.output)))
        if not job.picture:  # one that nobody asks for now changes nothing
            known["picture"] = ""
        paths, counts = known["sources"], {name: known["counts"][name] for name in _COUNTS}
        if not all(map(_is_count, counts, counts.values())) or known != _record(job, paths, counts):
            return None
        sources = real_paths(job.asset, paths)
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError):
        return None
    row = Row(job.asset, job.output, job.picture, "skipped", int(Exit.OK), sources=sources)
    return replace(row, **counts) if sources[:1] == (os.path.realpath(job.asset),) else None


def remember(job: Job, sources: Sequence[Mapping[str, str]], row: Row) -> None:
    """Write the file; where that fails, the asset is laid out again next time."""
    paths = [source["path"] for source in sources]
    with contextlib.suppress(OSError, RigUIError):
        record = _record(job, paths, {name: getattr(row, name) for name in _COUNTS})
        # A file changed since it was read must not count as laid out.
        if _digests(real_paths(job.asset, paths)) == [source["sha256"] for source in sources]:
            commit(json.dumps(record, indent=2) + "\n", state_path(job.output), read=[job.asset])


def forget(output: str) -> None:
    """Remove the file of a layer: its content may be wrong from now on."""
    with contextlib.suppress(OSError):
        state_path(output).unlink()


def _record(job: Job, paths: Sequence[str], counts: Mapping[str, float]) -> dict[str, Any]:
    """What the file holds where nothing has changed; raises OSError where a file is gone."""
    folder = os.path.realpath(Path(job.output).parent)
    result = [
        __version__,
        job.settings,
        os.path.relpath(os.path.realpath(job.asset), folder),
        _digests(real_paths(job.asset, paths)),
        _digests([job.output]),
        counts,
    ]
    return {
        "format": FORMAT,
        "version": VERSION,
        "digest": hashlib.sha256(json.dumps(result).encode()).hexdigest(),
        "picture": hashed(job.picture).sha256 if job.picture else "",
        "sources": paths,
        "counts": counts,
    }


def _is_count(name: str, value: Any) -> bool:
    return type(value) is (float if name == "gap" else int) and 0 <= value < math.inf


def _digests(paths: Sequence[str]) -> list[str]:
    return [hashed(path).sha256 for path in paths]


def real_paths(asset: str, paths: Sequence[str]) -> tuple[str, ...]:
    """The files that composed an asset, by their real paths."""
    folder = Path(asset).parent
    return tuple(os.path.realpath(folder / path) for path in paths)
