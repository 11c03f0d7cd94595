"""The rules that the schema's documentation has for numbers, held against the values of a prim.

A property that lists numbers says ``Range: [0, inf)``, ``Length: 0 or keys * joints``,
``Order: ascending`` or ``Norm: 0 or 1`` (schemas/CONTRACT.md).  Names are those of other properties
of the same schema: as a bound the value of that property, or how many entries it has.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np

from usdrigui.character import Floats
from usdrigui.layer import author

Sibling = Callable[[str], Any]
"""The value of another property of the schema by its last name: a number, or a list of entries."""

INTERVAL = re.compile(r"([\[(])(\S+), (\S+)([\])])")
"""The ends of a ``Range`` with what stands for whether they belong to it."""
_UNIT = 1e-3


def broken(rules: Mapping[str, str], value: Any, sibling: Sibling) -> Iterator[str]:
    """A clause for each rule that a value breaks."""
    numbers = np.asarray(value, dtype=np.float64)
    if not np.isfinite(numbers).all():
        yield "holds NaN or infinity"
        return
    checks = {"Range": _in_range, "Length": _as_long, "Order": _ascending, "Norm": _with_norm}
    for name, said in rules.items():
        if not checks[name](said, numbers, sibling):
            yield f"has another {name.lower()} than {said}"


def _in_range(said: str, numbers: Floats, sibling: Sibling) -> bool:
    opening, low, high, closing = INTERVAL.fullmatch(said).groups()  # type: ignore[union-attr]
    slack = author.TOLD * float(np.abs(numbers).max(initial=0.0))
    least = _bound(low, sibling, -slack)
    most = _bound(high, sibling, slack)
    above = numbers > least if opening == "(" else numbers >= least
    below = numbers < most if closing == ")" else numbers <= most
    return bool((above & below).all())


def _as_long(said: str, numbers: Floats, sibling: Sibling) -> bool:
    def product(names: str) -> int:
        named = names.split(" * ")
        return math.prod(int(each) if each.isdigit() else len(sibling(each)) for each in named)

    count = len(numbers)
    return any(
        _in_range(each, np.array(float(count)), sibling)
        if each.startswith("[")
        else count == product(each)
        for each in said.split(" or ")
    )


def _ascending(_: str, numbers: Floats, __: Sibling) -> bool:
    return bool((np.diff(numbers) > 0.0).all())


def _with_norm(said: str, numbers: Floats, _: Sibling) -> bool:
    lengths = np.linalg.norm(numbers.reshape(-1, 3), axis=1)
    wanted = np.array([*map(float, said.split(" or "))])
    return bool((np.abs(lengths[:, None] - wanted).min(axis=1) <= _UNIT).all())


def _bound(end: str, sibling: Sibling, slack: float) -> float:
    if end.endswith("inf") or not end.isalpha():
        return float(end)
    found = sibling(end)
    if isinstance(found, int):
        return found or math.inf  # a number of points that is not known
    return found + slack if isinstance(found, float) else float(max(len(found), 1))
