"""Small faults put into the code one by one, and whether the tests of the file notice.

    python benchmarks/mutants.py [--count 100] [--seed 0] [--within layout solve pose usd]
    [--seconds 120] [--json FILE]

A mutant is one change of one expression: a number, a comparison, `+` for `-`, `max` for `min`, the
last for the first. The kind is drawn first, then the place, so that no kind crowds out the others.
Each is made in a copy of the checkout, and the quick tests of its file run there until one fails:
those of its name, those that import it, those of its folder, and the laws of its package.  A mutant
is killed when a test fails or when they take more than `--seconds` of processor time.  The test
that kills must pass without the mutant.  Prints a line for each and the share killed; exit 1 below
`--least`.
"""

from __future__ import annotations

import argparse
import ast
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LAWS = {
    "layout": ["tests/laws/test_layout_laws.py", "tests/unit/test_sample_asset.py"],
    "solve": ["tests/unit/test_solve_exact.py", "tests/unit/test_solve_methods.py"],
    "pose": ["tests/laws/test_posing_equals_usdskel.py"],
    "usd": [
        "tests/laws/test_layout_round_trip.py",
        "tests/unit/test_layer.py",
        "tests/unit/test_reading_controls.py",
    ],
}
"""Tests that every file of a package answers to, after its own."""
ELSEWHERE = ("tests/real/", "tests/refuse/", "tests/clients/", "tests/cli/", "tests/blender/")
"""Tests of whole commands import much and are near no file."""
COMPARED = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "=="}
REPLACED = {ast.Add: "-", ast.Sub: "+", ast.Mult: "/", ast.Div: "*"}
NAMES = {
    "max": "min",
    "min": "max",
    "mean": "max",
    "median": "max",
    "argmax": "argmin",
    "argmin": "argmax",
}
NAMES |= {"maximum": "minimum", "minimum": "maximum", "any": "all", "all": "any"}


@dataclass(frozen=True)
class Mutant:
    """One change: `new` for `old` at `start`, an offset in characters of the file."""

    path: str
    line: int
    kind: str
    start: int
    old: str
    new: str

    def applied(self, text: str) -> str:
        """The text of its file with the change."""
        end = self.start + len(self.old)
        assert text[self.start : end] == self.old
        return text[: self.start] + self.new + text[end:]


# --- mutants --------------------------------------------------------------------------------------


def mutants(path: Path) -> Iterator[Mutant]:
    """Every mutant of a file; messages of refusals and annotations are left alone."""
    text = path.read_text(encoding="utf-8")
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))

    def offset(line: int, column: int) -> int:
        raw = text[starts[line - 1] : starts[line]].encode()
        return starts[line - 1] + len(raw[:column].decode())

    def made(
        kind: str, node: ast.expr, after: int, before: int, pattern: str, new: str
    ) -> Iterator[Mutant]:
        found = re.compile(pattern).search(text, after, before)
        if found:
            yield Mutant(
                str(path.relative_to(ROOT)), node.lineno, kind, found.start(), found.group(), new
            )

    for node in _expressions(ast.parse(text)):
        start = offset(node.lineno, node.col_offset)
        end = offset(node.end_lineno or 0, node.end_col_offset or 0)
        match node:
            case ast.Constant(value=int() | float() as value) if not isinstance(value, bool):
                new = str(value + 1) if isinstance(value, int) else repr(value * 1.5 or 1.0)
                yield from made("number", node, start, end, re.escape(text[start:end]), new)
            case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in COMPARED:
                after, before = _end(left, offset), offset(right.lineno, right.col_offset)
                yield from made("comparison", node, after, before, "[<>=!]=?", COMPARED[type(op)])
            case ast.BinOp(left=left, op=op, right=right) if type(op) in REPLACED:
                after, before = _end(left, offset), offset(right.lineno, right.col_offset)
                yield from made("arithmetic", node, after, before, r"[-+*/]", REPLACED[type(op)])
            case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name) as callee) if (
                name in NAMES
            ):
                after = _end(callee, offset)
                yield from made("choice", node, after - len(name), after, name, NAMES[name])
            case ast.Subscript(slice=ast.Constant(value=0) as at):
                place = offset(at.lineno, at.col_offset)
                yield from made("choice", node, place, place + 1, "0", "-1")


def _end(node: ast.expr, offset: object) -> int:
    assert callable(offset)
    return int(offset(node.end_lineno, node.end_col_offset))


def _expressions(tree: ast.AST) -> Iterator[ast.expr]:
    """Expressions that decide something, each before those inside it."""
    for name, value in ast.iter_fields(tree):
        if name in ("annotation", "returns", "decorator_list"):
            continue
        for node in value if isinstance(value, list) else [value]:
            if not isinstance(node, ast.AST) or isinstance(
                node, ast.JoinedStr | ast.Raise | ast.Assert
            ):
                continue
            if isinstance(node, ast.expr):
                yield node
            yield from _expressions(node)


def drawn(packages: Sequence[str], count: int, seed: int) -> list[Mutant]:
    """`count` of the packages' mutants, of every kind alike."""
    chance = random.Random(seed)
    by_kind: dict[str, list[Mutant]] = {}
    for package in packages:
        for path in sorted((ROOT / "usdrigui" / package).rglob("*.py")):
            for each in mutants(path):
                by_kind.setdefault(each.kind, []).append(each)
    for each in by_kind.values():
        chance.shuffle(each)
    kinds = sorted(by_kind)
    return [by_kind[kinds[at % len(kinds)]].pop() for at in range(count)]


# --- tests ----------------------------------------------------------------------------------------


def tests_of(path: str) -> list[str]:
    """Test files that answer for a file of the package, the nearest first."""
    inside = Path(path).relative_to("usdrigui").with_suffix("")
    folder = ROOT / "tests" / "unit" / inside.parent
    if inside.parts[0] == "solve":
        near = sorted(ROOT.glob("tests/unit/test_solve_*.py"))
    else:
        near = [
            *folder.glob(f"test_{inside.stem}.py"),
            *ROOT.glob(f"tests/unit/test_{inside.stem}.py"),
        ]
    module = ".".join(("usdrigui", *inside.parts))
    everything = sorted((ROOT / "tests").rglob("test_*.py"))
    near += [each for each in everything if module in _imported(each)]
    near += sorted(folder.glob("test_*.py")) if len(inside.parts) > 2 else []
    names = [str(each.relative_to(ROOT)) for each in near] + LAWS[inside.parts[0]]
    return [
        each
        for each in dict.fromkeys(names)
        if not each.startswith(ELSEWHERE) and (ROOT / each).exists()
    ]


def _imported(path: Path) -> set[str]:
    """Dotted names that a file imports, of modules or of what is in them."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {each.name for each in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {node.module, *(f"{node.module}.{each.name}" for each in node.names)}
    return found


def failing(copy: Path, tests: Sequence[str], seconds: float) -> str:
    """The first test that fails in the copy, `time` if they take too long, or nothing."""
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-x",
        "-n",
        "0",
        "--suite",
        "quick",
        "-p",
        "no:cacheprovider",
        *tests,
    ]
    whole = max(1, int(seconds))
    done = subprocess.run(
        command,
        cwd=copy,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(copy)},
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (whole, whole + 5)),
    )
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "time"
    if done.returncode == 0:
        return ""
    named = re.search(r"^(?:FAILED|ERROR) (\S+)", done.stdout, re.MULTILINE)
    return named.group(1) if named else f"exit {done.returncode}"


def _copied(folder: Path) -> Path:
    """A copy of the files of the checkout that git knows, as they are now."""
    listed = subprocess.run(
        ["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    for name in filter(None, listed.stdout.split("\0")):
        if (ROOT / name).exists():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name)
    return folder


def judged(copy: Path, mutant: Mutant, seconds: float) -> str:
    """What kills the mutant; nothing where it survives."""
    target = copy / mutant.path
    sound = target.read_text(encoding="utf-8")
    target.write_text(mutant.applied(sound), encoding="utf-8")
    try:
        return failing(copy, tests_of(mutant.path), seconds)
    finally:
        target.write_text(sound, encoding="utf-8")


def main() -> int:
    """Judge the mutants that were drawn; exit 1 if fewer than `--least` of them are killed."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="pass over so many of those drawn")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--within", nargs="+", choices=sorted(LAWS), default=sorted(LAWS))
    parser.add_argument("--seconds", type=float, default=120.0)
    parser.add_argument("--least", type=float, default=0.9)
    parser.add_argument("--json", type=Path)
    asked = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as place:
        copy = _copied(Path(place))
        chosen = drawn(asked.within, asked.first + asked.count, asked.seed)[asked.first :]
        for mutant in chosen:
            by = judged(copy, mutant, asked.seconds)
            if "::" in by and failing(copy, [by], asked.seconds):
                print(f"{by} fails without a mutant", file=sys.stderr)
                return 2
            rows.append({**asdict(mutant), "killed by": by})
            change = f"{mutant.path}:{mutant.line} {mutant.kind}: {mutant.old} -> {mutant.new}"
            print(f"{'killed  ' if by else 'SURVIVED'} {change}  {by}", flush=True)
    killed = sum(bool(row["killed by"]) for row in rows)
    print(f"{killed} of {len(rows)} killed")
    if asked.json:
        asked.json.write_text(json.dumps(rows, indent=1) + "\n")
    return int(killed < asked.least * len(rows))


if __name__ == "__main__":
    sys.exit(main())
