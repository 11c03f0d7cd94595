"""The numbers of layout/, one by one halved and doubled, and which characters notice.

    python benchmarks/thresholds.py ASSET ... [--only NAME ...] [--work 2000000] [--rows FILE]

Assets come one after the other, cheap ones first: a number that one of them notices is asked of no
further one.  A layout is another one when a control shares its element with others, goes from the
face to the board or back, is doubled or no longer so, or stands more than a handle's width from
where it stood; ``-`` says that it differs in what nobody sees.  A number that no asset notices
needs a reason to stay.

Each row is appended to the file as soon as it is known, and a run goes on from the rows that are
there.  Each trial is a process of its own that begins where reading ended.  Stages before the first
that knows the number's module are not run again, nor is a problem solved that is the same to the
last bit.
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
from usdrigui.pipeline import stages
from usdrigui.pipeline.joining import joined
from usdrigui.pipeline.records import LaidPart
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
    character = character_of(rig, settings)
    parts: list[LaidPart] = []
    answers = {}
    for part in character.parts:
        neighbours = tuple(element for each in parts for element in each.layout.elements)
        inputs = part_problem(character, part, neighbours)
        key = digest(inputs.placement.problem)
        answer = solved.get(key) or solve(inputs.placement.problem, settings.solve)
        answers[key] = answer
        parts.append(LaidPart(inputs, layout_of(inputs, answer), answer))
    layout = joined(parts)
    return Laid(digest(layout.elements), _controls(layout), layout.frame.handle_width, answers)


def _controls(layout: Layout) -> dict[str, tuple[Any, ...]]:
    found: dict[str, list[tuple[Any, ...]]] = {}
    for element in sorted(layout.elements, key=lambda each: each.name):
        for member in element.members:
            on_face = not element.anchor.on_board
            where = element.anchor.position.tolist()
            row = (tuple(sorted(element.controls)), on_face, where)
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


KEPT = {
    "trajectories": ("motion.trajectory",),
    "symmetry_at_pose": ("motion.trajectory", "symmetry.base_pose"),
    "_parts": ("motion.trajectory", "symmetry.base_pose", "parts.division"),
}
"""Stages at the beginning, and the modules of layout/ at which what they know begins."""


def modules_of(starts: Sequence[str]) -> set[str]:
    """All modules of the package that some modules of layout/ import, themselves included."""
    left, found = [f"usdrigui.layout.{each}" for each in starts], set[str]()
    while left:
        path = (ROOT / (module := left.pop()).replace(".", "/")).with_suffix(".py")
        if module in found or not path.exists():
            continue
        found.add(module)
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module:
                left += [node.module, *(f"{node.module}.{each.name}" for each in node.names)]
    return found


class Base:
    """The layout of an asset as it is, and what its first stages gave."""

    def __init__(self, asset: Path, settings: Settings) -> None:
        self.name, self.settings, self.kept = asset.stem, settings, dict[str, Any]()
        self.rig = read_rigs(asset, Settings())[0]
        honest = {name: getattr(stages, name) for name in KEPT}
        for name, stage in honest.items():
            setattr(stages, name, functools.partial(self._keep, name, stage))
        self.laid = laid_out(self.rig, settings, {})
        for name, stage in honest.items():
            setattr(stages, name, stage)

    def _keep(self, name: str, stage: Callable[..., Any], *given: Any) -> Any:
        self.kept[name] = stage(*given)
        return self.kept[name]

    def noticed(self, threshold: Threshold, factor: float) -> str:
        """What is another where a threshold is so many times as large."""

        def change() -> None:
            for name, starts in KEPT.items():
                if threshold.module not in modules_of(starts):
                    setattr(stages, name, lambda *_, name=name: self.kept[name])
            threshold.set(factor)

        after = trial(change, lambda: laid_out(self.rig, self.settings, self.laid.solved))
        if isinstance(after, str):
            return f"fails: {after}"
        return self.laid.changed(after) or "-" * (after.digest != self.laid.digest)


def main() -> int:
    """Print the table, row by row."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("assets", nargs="+", type=Path)
    parser.add_argument("--only", nargs="*", default=[])
    parser.add_argument("--work", type=int, default=2_000_000)
    parser.add_argument("--rows", type=Path, default=Path("thresholds.jsonl"))
    options = parser.parse_args()
    settings = load({"solve": {"work_limit": options.work}})
    wanted = [
        each
        for each in thresholds()
        if not options.only or any(word in each.key for word in options.only)
    ]
    lines = options.rows.read_text("utf-8").splitlines() if options.rows.exists() else []
    rows = [json.loads(line) for line in lines]
    for asset in options.assets:
        asked = {row["key"] for row in rows if row["rig"] == asset.stem or seen(row)}
        left = [each for each in wanted if each.key not in asked]
        base = Base(asset, settings) if left else None
        for each in left if base else ():
            what = {str(factor): base.noticed(each, factor) for factor in FACTORS}
            rows.append({"rig": base.name, "key": each.key, "value": each.value, "what": what})
            with options.rows.open("a", encoding="utf-8") as file:
                print(json.dumps(rows[-1]), file=file)
            print(f"{base.name:20s} {each.key:48s} {each.value:12g}  {what}", flush=True)
    by_key = {row["key"] for row in rows if seen(row)}
    for each in wanted:
        if each.key not in by_key:
            print(f"nobody notices {each.key:48s} {each.value:12g}  {each.text}")
    return 0


def seen(row: dict[str, Any]) -> bool:
    """Whether an asset's layout is another one."""
    return any(what not in ("", "-") for what in row["what"].values())


if __name__ == "__main__":
    sys.exit(main())
