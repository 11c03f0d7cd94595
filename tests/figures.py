"""Figures of records and documents, beside those that were kept of them.

A file of figures has a row for every field, of all records alike together: words as they are, numbers by their count
and the means of eighths of them, which every processor has alike.  To change what comes out: USDRIGUI_GOLDEN=write
for the tests of the file, and a look at the rows that changed.
"""

from __future__ import annotations

import itertools
import json
import math
import os
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path

import numpy as np

KEPT = Path(__file__).with_name("figures")
PASSING = {
    "added",
    "asset",
    "at",
    "element",
    "hash",
    "identity",
    "layoutDigest",
    "output",
    "seconds",
    "seen",
    "topology_hash",
    "version",
}
"""Fields that another machine, version or processor has otherwise, that have no order, or stand there already."""


def rows(values, name):
    """Name and figures of every field of the values of one place."""
    kinds = {}
    for value in values:
        plain = value if isinstance(value, (Mapping, tuple, list)) or is_dataclass(value) else np.asarray(value)
        kinds.setdefault(plain.dtype.kind in "biuf" if isinstance(plain, np.ndarray) else type(plain), []).append(plain)
    for kind, found in kinds.items():
        if kind is True:
            flat = np.concatenate([*map(np.ravel, found)]).astype(np.float64)
            eighths = [part.mean() for part in np.array_split(flat, 8) if len(part)]
            yield f"{name} numbers", [len(flat), *(float(f"{mean:.6g}") for mean in eighths)]
        elif kind is False:
            yield f"{name} words", [str(word) for each in found for word in np.ravel(each)]
        elif is_dataclass(kind) or issubclass(kind, Mapping):
            records = [each if isinstance(each, Mapping) else _named(each) for each in found]
            for key in sorted({*itertools.chain(*records)} - PASSING):
                yield from rows([each[key] for each in records if key in each], f"{name}.{key}")
        else:
            yield from rows([len(each) for each in found], f"{name} lengths")
            yield from rows([*itertools.chain(*found)], f"{name}[]")


def _named(record):
    return {each.name: getattr(record, each.name) for each in fields(record)}


def other_than_kept(name, value):
    """By row, the figures of a value that are not those in figures/NAME.json, and those that are there."""
    now, file = dict(rows([value], "")), KEPT / f"{name}.json"
    if os.environ.get("USDRIGUI_GOLDEN") == "write":
        lines = ",\n".join(f"{json.dumps(key)}: {json.dumps(row)}" for key, row in now.items())
        file.write_text(f"{{\n{lines}\n}}\n", encoding="utf-8")
    kept = json.loads(file.read_text(encoding="utf-8"))
    return {
        key: (now.get(key), kept.get(key))
        for key in now.keys() | kept.keys()
        if not _agree(now.get(key), kept.get(key))
    }


def _agree(row, kept):
    """Whether they are the same, numbers to a few ten-thousandths of the largest."""
    if not row or not kept or len(row) != len(kept) or isinstance(row[0], str):
        return row == kept
    return np.allclose(
        row, kept, rtol=0.0, atol=3e-4 * max(filter(math.isfinite, map(abs, kept[1:])), default=0.0), equal_nan=True
    )
