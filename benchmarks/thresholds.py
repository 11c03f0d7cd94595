"""The numbers of layout/, one by one halved and doubled, and which characters notice.

    python benchmarks/thresholds.py ASSET ... [--only NAME ...] [--work 2000000] [--json FILE]

Every number at the top of a module of layout/ is a line of the table: its module and name, its
value, the first line of what its text says, and the assets whose layout is another one when it is
half as large, and twice.  A layout is another one when a control shares its element with others,
goes from the face to the board or back, is doubled or no longer so, or stands more than a handle's
width from where it stood.  A number that no asset notices needs a reason to stay.

Assets are read once; each trial is a process of its own that begins where reading ended.  A problem
that is the same to the last bit is not solved again.
"""

from __future__ import annotations

import argparse
import ast
import functools
import hashlib
import importlib
import json
import os
import pickle
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields, is_dataclass
from pathlib import Path
from typing import Any

import numpy as np

from usdrigui.character import Rig
from usdrigui.model import Assignment, Layout
from usdrigui.pipeline.joining import joined
from usdrigui.pipeline.records import LaidPart, Task
from usdrigui.pipeline.stages import character_of, layout_of, part_problem
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings, load
from usdrigui.solve import solve

ROOT = Path(__file__).resolve().parents[1]
FACTORS = (0.5, 2.0)


@dataclass(frozen=True)
class Threshold:
    """One number at the top of a module; one of several where the name holds a tuple."""

    module: str
    name: str
    place: int
    """Which one of a tuple; -1 where it is a number."""
    text: str
    """The first line of what stands below it."""

    @property
    def key(self) -> str:
        """Module and name, as the table prints them."""
        which = "" if self.place < 0 else f"[{self.place}]"
        return f"{self.module.removeprefix('usdrigui.layout.')}.{self.name}{which}"

    @property
    def value(self) -> float:
        """As it is."""
        held = getattr(importlib.import_module(self.module), self.name)
        return float(held if self.place < 0 else held[self.place])

    def set(self, factor: float) -> None:
        """Make it `factor` times as large, here and wherever it was imported."""
        held = getattr(importlib.import_module(self.module), self.name)
        changed: Any = _times(held, factor)
        if self.place >= 0:
            changed = tuple(
                _times(number, factor) if i == self.place else number
                for i, number in enumerate(held)
            )
        for module in list(sys.modules.values()):
            if module.__name__.startswith("usdrigui") and vars(module).get(self.name) is held:
                setattr(module, self.name, changed)


def _times(number: float, factor: float) -> float:
    return round(number * factor) if isinstance(number, int) else number * factor


def thresholds() -> Iterator[Threshold]:
    """Every number of layout/, in the order of the files."""
    for path in sorted((ROOT / "usdrigui/layout").rglob("*.py")):
        module = ".".join(path.relative_to(ROOT).with_suffix("").parts)
        body = ast.parse(path.read_text(encoding="utf-8")).body
        for statement, below in zip(body, [*body[1:], None], strict=True):
            if isinstance(statement, ast.Assign):
                yield from _of_statement(module, statement, _text(below))


def _of_statement(module: str, statement: ast.Assign, text: str) -> Iterator[Threshold]:
    names = [each.id for each in ast.walk(statement.targets[0]) if isinstance(each, ast.Name)]
    for name in names:
        held = getattr(importlib.import_module(module), name)
        if isinstance(held, int | float) and not isinstance(held, bool):
            yield Threshold(module, name, -1, text)
        elif isinstance(held, tuple) and held and all(isinstance(n, int | float) for n in held):
            yield from (Threshold(module, name, place, text) for place in range(len(held)))


def _text(below: ast.stmt | None) -> str:
    if isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
        return str(below.value.value).split("\n")[0]
    return ""


# --- a character laid out -------------------------------------------------------------------------


@dataclass(frozen=True)
class Laid:
    """What is compared of a layout."""

    digest: str
    """Of the whole layout, to the last bit."""
    controls: dict[str, tuple[Any, ...]]
    """By control, of each of its elements: with whom, on the face or not, and where."""
    width: float
    solved: dict[str, Assignment]
    """By digest of the problem."""

    def changed(self, after: Laid) -> str:
        """What is another in `after`; empty where nothing is that one sees."""
        if self.digest == after.digest:
            return ""
        regrouped, sent, moved = 0, 0, 0
        for name, elements in self.controls.items():
            others = after.controls.get(name, ())
            if [each[0] for each in elements] != [each[0] for each in others]:
                regrouped += 1
            elif [each[1] for each in elements] != [each[1] for each in others]:
                sent += 1
            else:
                moved += any(
                    one[1] and np.linalg.norm(np.subtract(one[2], two[2])) > self.width
                    for one, two in zip(elements, others, strict=True)
                )
        counts = (("regrouped", regrouped), ("sent", sent), ("moved", moved))
        return " ".join(f"{what} {count}" for what, count in counts if count)


def laid_out(rig: Rig, settings: Settings, solved: dict[str, Assignment]) -> Laid:
    """The layout of a character; `solved` are answers that are known already."""
    character = character_of(rig, Task(settings))
    parts: list[LaidPart] = []
    answers = {}
    for part in character.parts:
        neighbours = tuple(element for each in parts for element in each.layout.elements)
        inputs = part_problem(character, part, neighbours)
        key = digest(inputs.placement.problem)
        answer = solved.get(key) or solve(inputs.placement.problem, settings.layout.solve)
        answers[key] = answer
        parts.append(LaidPart(inputs, layout_of(inputs, answer), answer))
    layout = joined(parts)
    return Laid(digest(layout.elements), _controls(layout), layout.frame.handle_width, answers)


def _controls(layout: Layout) -> dict[str, tuple[Any, ...]]:
    found: dict[str, list[tuple[Any, ...]]] = {}
    for element in sorted(layout.elements, key=lambda each: each.name):
        for member in element.manipulator.members:
            on_face = not element.anchor.on_board
            where = element.anchor.position.tolist()
            row = (tuple(sorted(element.manipulator.controls)), on_face, where)
            found.setdefault(member.control, []).append(row)
    return {name: tuple(rows) for name, rows in found.items()}


def digest(record: object) -> str:
    """Of all numbers and words in a record."""
    found = hashlib.sha256()
    _add(record, found.update)
    return found.hexdigest()


def _add(value: object, take: Callable[[bytes], None]) -> None:
    if isinstance(value, np.ndarray):
        take(repr((value.shape, value.dtype.str)).encode())
        take(np.ascontiguousarray(value).tobytes())
    elif is_dataclass(value):
        for field in fields(value):
            _add(getattr(value, field.name), take)
    elif isinstance(value, tuple | list):
        for each in value:
            _add(each, take)
    else:
        take(repr(sorted(value) if isinstance(value, frozenset) else value).encode())


# --- trials ---------------------------------------------------------------------------------------


def trial(change: Callable[[], None], work: Callable[[], Any]) -> Any:
    """What `work` gives after `change`, in a process of its own; an exception that it raises."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        try:
            change()
            answer = work()
        except BaseException as error:
            answer = f"{type(error).__name__}: {error}"[:200]
        with os.fdopen(writing, "wb") as pipe:
            pickle.dump(answer, pipe)
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading, "rb") as pipe:
        found = pipe.read()
    os.waitpid(child, 0)
    return pickle.loads(found) if found else "killed"


def rigs_of(assets: Sequence[Path]) -> dict[str, Rig]:
    """The characters of some assets, by the name of the file."""
    return {asset.stem: read_rigs(asset, Settings())[0] for asset in assets}


def bases(rigs: dict[str, Rig], settings: Settings) -> dict[str, Laid]:
    """Their layouts as they are."""
    return {
        name: trial(lambda: None, lambda rig=rig: laid_out(rig, settings, {}))
        for name, rig in rigs.items()
    }


def noticed(
    rigs: dict[str, Rig], known: dict[str, Laid], settings: Settings, change: Callable[[], None]
) -> Iterator[tuple[str, str]]:
    """By asset, what a change changes."""
    for name, rig in rigs.items():
        base = known[name]
        after = trial(change, lambda rig=rig, base=base: laid_out(rig, settings, base.solved))
        what = f"fails: {after}" if isinstance(after, str) else base.changed(after)
        if isinstance(after, Laid) and not what and after.digest != base.digest:
            what = "-"
        if what:
            yield name, what


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("assets", nargs="+", type=Path)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--work", type=int, default=2_000_000)
    parser.add_argument("--json", type=Path)
    options = parser.parse_args()
    settings = load({"solve": {"work_limit": options.work}})
    rigs = rigs_of(options.assets)
    known = bases(rigs, settings)
    table = []
    for each in thresholds():
        if options.only and not any(word in each.key for word in options.only):
            continue
        changes = {factor: functools.partial(each.set, factor) for factor in FACTORS}
        found = {
            factor: dict(noticed(rigs, known, settings, change))
            for factor, change in changes.items()
        }
        seen = sorted({name for by in found.values() for name, what in by.items() if what != "-"})
        print(f"{each.key:48s} {each.value:12g}  {', '.join(seen) or 'nobody'}", flush=True)
        table.append({"name": each.key, "value": each.value, "text": each.text, "changes": found})
        if options.json:
            options.json.write_text(json.dumps(table, indent=1), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
