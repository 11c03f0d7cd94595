"""Small faults put into the code one by one, and whether the tests of the file notice.

    python benchmarks/mutants.py [--count 100] [--seed 0] [--within layout pipeline solve errors.py]
    [--record tests/unit tests/laws] [--reached FILE ...] [--seconds 60] [--json FILE]

A mutant is one change of one expression: a number, a comparison, `+` for `-`, `max` for `min`, the
last for the first. A comparison changes at its boundary, one with a number that is not whole is
turned round: what is measured is never at the boundary. The kind is drawn first, then the place, so
that no kind crowds out the others.
All is done in a copy of the checkout. The quick tests of `--record` run there once with the places
of the mutants marked (mutants_seen.py): what reaches a place is known, and what it takes. Then each
mutant is made, and the tests that reach it run until one fails: those of its file first, then the
laws, the quick before the slow, as many as took `--seconds` of processor time. A mutant is killed
when a test fails or when they take five times as long as they did. The test that kills must pass
without the mutant.
Prints a line for each and the share killed; exit 1 below `--least`.

Shares: `--only-record FILE` writes what one share of `--record` reached; `--reached FILE ...` takes
such files in place of recording; `--first` and `--count` are a share of the mutants.
"""

from __future__ import annotations

import argparse
import ast
import hashlib
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
ROOMS = sorted(
    path.name
    for path in (ROOT / "usdrigui").iterdir()
    if path.suffix == ".py" or path.joinpath("__init__.py").is_file()
)
RECORDED = ("tests/unit", "tests/laws", "tests/cli", "tests/clients")
COMPARED = {ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">", ast.Eq: "!=", ast.NotEq: "=="}
TURNED = {ast.Lt: ">", ast.LtE: ">", ast.Gt: "<", ast.GtE: "<"}
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
GUARD = 1e-100
"""Half more of a smaller number matters only to lengths and weights that are smaller still."""


@dataclass(frozen=True)
class Mutant:
    """One change: `new` for `old` at `start`, an offset in characters of the file."""

    path: str
    line: int
    kind: str
    start: int
    old: str
    new: str
    span: tuple[int, int]
    """The expression that is marked to see which tests reach it."""
    place: str
    """Path, function, the change, the expression around it and its turn among equal ones: the same
    wherever the function stands in its file and however its lines are broken."""

    def applied(self, text: str) -> str:
        """The text of its file with the change."""
        end = self.start + len(self.old)
        assert text[self.start : end] == self.old
        return text[: self.start] + self.new + text[end:]


# --- mutants --------------------------------------------------------------------------------------


def mutants(path: Path) -> Iterator[Mutant]:
    """Every mutant of a file.

    Left alone are messages of refusals, annotations, decorators, and numbers under `GUARD`, which
    keep a quotient finite and change no other.
    """
    text = path.read_text(encoding="utf-8")
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    where = path.relative_to(ROOT).as_posix()
    alike: Counter[str] = Counter()

    def offset(line: int, column: int) -> int:
        raw = text[starts[line - 1] : starts[line]].encode()
        return starts[line - 1] + len(raw[:column].decode())

    for node, around, function in _expressions(ast.parse(text)):
        span = (
            offset(node.lineno, node.col_offset),
            offset(node.end_lineno or 0, node.end_col_offset or 0),
        )
        for kind, after, before, pattern, new in _changes(node, span, offset):
            found = re.compile(pattern).search(text, after, before)
            if found:
                old = found.group()
                place = f"{where}:{function}: {kind} {old} -> {new} in {ast.unparse(around)}"
                alike[place] += 1
                place = f"{place} #{alike[place]}"
                yield Mutant(where, node.lineno, kind, found.start(), old, new, span, place)


def _changes(
    node: ast.expr, span: tuple[int, int], offset: Callable[[int, int], int]
) -> Iterator[tuple[str, int, int, str, str]]:
    """Kind, where what changes is searched for, its pattern and what stands there instead."""

    def end(each: ast.expr) -> int:
        return offset(each.end_lineno or 0, each.end_col_offset or 0)

    match node:
        case ast.Constant(value=bool()):
            return
        case ast.Constant(value=int(value)):
            yield "number", *span, ".+", str(value + 1)
        case ast.Constant(value=float(value)) if not 0.0 < value < GUARD:
            yield "number", *span, ".+", repr(value * 1.5 or 1.0)
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in COMPARED:
            between = end(left), offset(right.lineno, right.col_offset)
            new = TURNED if type(op) in TURNED and _measured(left, right) else COMPARED
            yield "comparison", *between, "[<>=!]=?", new[type(op)]
        case ast.BinOp(left=left, op=op, right=right) if type(op) in REPLACED:
            between = end(left), offset(right.lineno, right.col_offset)
            yield "arithmetic", *between, r"[-+*/]", REPLACED[type(op)]
        case ast.Call(func=ast.Name(id=name) | ast.Attribute(attr=name) as callee) if name in NAMES:
            yield "choice", end(callee) - len(name), end(callee), name, NAMES[name]
        case ast.Subscript(slice=ast.Constant(value=0) as at):
            yield "choice", end(at) - 1, end(at), "0", "-1"


def _measured(*sides: ast.expr) -> bool:
    """Whether one of the sides has a number that is not whole, or a constant of ours that is none,
    or asks a clock.

    What is compared with it was measured and stands nowhere but by luck at the boundary.
    """
    parts = [each for side in sides for each in ast.walk(side)]
    names = {each.id for each in parts if isinstance(each, ast.Name)}
    return bool(names & {*_fractions(), "time"}) or any(map(_fraction, parts))


def _fraction(node: ast.AST | None) -> bool:
    match node:
        case ast.Constant(value=float(value)):
            return value % 1 != 0
        case ast.Call(func=ast.Attribute(attr="cos" | "sin" | "sqrt")):
            return True
        case ast.BinOp(left=left, right=right):
            return isinstance(node.op, ast.Div) or _fraction(left) or _fraction(right)
        case ast.Call(func=ast.Name(id="float"), args=[value]):
            return _fraction(value)
    return False


@cache
def _fractions() -> frozenset[str]:
    """Names of the constants of the package that are numbers which are not whole."""
    trees = [ast.parse(path.read_text("utf-8")) for path in ROOT.joinpath("usdrigui").rglob("*.py")]
    return frozenset(
        target.id
        for tree in trees
        for line in tree.body
        if isinstance(line, ast.Assign) and _fraction(line.value)
        for target in line.targets
        if isinstance(target, ast.Name)
    )


def _expressions(
    tree: ast.AST, around: ast.AST | None = None, function: str = ""
) -> Iterator[tuple[ast.expr, ast.AST, str]]:
    """Expressions that decide something, each before those inside it.

    With each comes what identifies it (itself, or the expression around a mere number) and the name
    of its function or class.
    """
    for name, value in ast.iter_fields(tree):
        if name in ("annotation", "returns", "decorator_list"):
            continue
        for node in value if isinstance(value, list) else [value]:
            if not isinstance(node, ast.AST) or isinstance(
                node, ast.JoinedStr | ast.Raise | ast.Assert
            ):
                continue
            inside = around
            if isinstance(node, ast.stmt):
                inside = None if hasattr(node, "body") else node
            if isinstance(node, ast.expr):
                bare = isinstance(node, ast.Constant | ast.UnaryOp)
                inside = around if bare and around else node
                yield node, inside, function
            if isinstance(node, ast.FunctionDef | ast.ClassDef):
                yield from _expressions(node, None, f"{function}.{node.name}".lstrip("."))
            else:
                yield from _expressions(node, inside, function)


def drawn(rooms: Sequence[str], count: int, seed: int) -> list[Mutant]:
    """`count` of the rooms' mutants, of every kind alike.

    The seed and its place give a mutant its turn, so that code which changes elsewhere draws the
    same mutants again.
    """
    by_kind: dict[str, list[Mutant]] = {}
    for room in rooms:
        place = ROOT / "usdrigui" / room
        for path in [place] if place.suffix else sorted(place.rglob("*.py")):
            for each in mutants(path):
                by_kind.setdefault(each.kind, []).append(each)
    turns = [
        sorted(alike, key=lambda each: hashlib.sha256(f"{seed} {each.place}".encode()).digest())
        for _, alike in sorted(by_kind.items())
    ]
    return [turns[at % len(turns)][at // len(turns)] for at in range(count)]


# --- tests ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Reached:
    """Places that passing tests reach, and the processor seconds that each test took."""

    tests_at: dict[str, set[str]]
    on_import: set[str]
    seconds: dict[str, float]

    @staticmethod
    def read(files: Sequence[Path]) -> Reached:
        """What runners wrote (mutants_seen.py), one file each."""
        reached = Reached({}, set(), {})
        for file in files:
            test, places = "", set[str]()
            for line in file.read_text(encoding="utf-8").splitlines():
                mark, _, rest = line.partition(" ")
                if mark == "S" and not test:
                    reached.on_import.add(rest)
                elif mark == "S":
                    places.add(rest)
                elif mark == "T":
                    test, places = rest, set()
                else:
                    reached.seconds[test] = float(rest)
                    for place in places:
                        reached.tests_at.setdefault(place, set()).add(test)
        return reached

    def by(self, mutant: Mutant, seconds: float) -> list[str]:
        """Tests that reach the mutant, those of its file first, then the laws, the quick before the
        slow.

        What importing reaches is judged by the tests that reach a function of the file which names
        it; where none does, by those that reach any.
        """
        tests = self.tests_at.get(mutant.place, set())
        if mutant.place not in self.tests_at:
            functions = _functions_naming(mutant)
            tests = set().union(*(self.tests_at.get(each, set()) for each in functions))
        near = Path(mutant.path).stem

        def rank(test: str) -> tuple[bool, bool, float, str]:
            file = Path(test.partition("::")[0])
            return near not in file.stem, "laws" not in file.parts, self.seconds[test], test

        chosen, total = [], 0.0
        for test in sorted(tests, key=rank):
            if not chosen or total + self.seconds[test] <= seconds:
                chosen.append(test)
                total += self.seconds[test]
        return chosen


def _functions(path: str) -> list[tuple[str, ast.FunctionDef]]:
    tree = ast.parse((ROOT / path).read_text(encoding="utf-8"))
    found = [each for each in ast.walk(tree) if isinstance(each, ast.FunctionDef)]
    return [(f"{path}:{each.name}", each) for each in found]


def _functions_naming(mutant: Mutant) -> list[str]:
    """Places of the functions of its file that name what its statement assigns, or of all."""
    functions = _functions(mutant.path)
    assigned = set()
    for node in ast.parse((ROOT / mutant.path).read_text(encoding="utf-8")).body:
        if node.lineno <= mutant.line <= (node.end_lineno or 0) and isinstance(
            node, ast.Assign | ast.AnnAssign
        ):
            assigned = {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
    naming = [
        place
        for place, function in functions
        if any(isinstance(each, ast.Name) and each.id in assigned for each in ast.walk(function))
    ]
    return naming or [place for place, _ in functions]


def marked(path: str, mutants: Sequence[Mutant]) -> str:
    """The text of a file that reports when a mutant's expression or a function is reached."""
    text = (ROOT / path).read_text(encoding="utf-8")
    lines = text.splitlines(keepends=True)
    starts = [sum(map(len, lines[:at])) for at in range(len(lines))]
    added: list[tuple[int, int, str]] = []
    for place, function in _functions(path):
        first = function.body[1 if ast.get_docstring(function) and function.body[1:] else 0]
        line = min([first.lineno, *(each.lineno for each in getattr(first, "decorator_list", ()))])
        if line > function.body[0].lineno or line > function.lineno:
            indent = " " * first.col_offset
            added.append((starts[line - 1], 0, f"{indent}_place_seen({place!r})\n"))
    for start, end in {each.span for each in mutants}:
        places = [each.place for each in mutants if each.span == (start, end)]
        pair = [(start, -end, f"(_place_seen(*{places!r}) or ("), (end, -start, "))")]
        if _parses(_with(text, pair)):
            added += pair
    first = next(node.lineno for node in ast.parse(text).body if not _leads(node))
    added.append((starts[first - 1], 0, "from usdrigui._seen import seen as _place_seen\n"))
    return _with(text, added)


def _leads(node: ast.stmt) -> bool:
    """Whether it is a docstring or an import from the future, which nothing else goes before."""
    is_text = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return is_text or (isinstance(node, ast.ImportFrom) and node.module == "__future__")


def _with(text: str, added: Sequence[tuple[int, int, str]]) -> str:
    for at, _, new in sorted(added, reverse=True):
        text = text[:at] + new + text[at:]
    return text


def _parses(text: str) -> bool:
    try:
        ast.parse(text)
    except SyntaxError:
        return False
    return True


def record(copy: Path, mutants: Sequence[Mutant], tests: Sequence[str], file: Path) -> None:
    """Write what the tests reach of the mutants, run in the copy, which is as before after it."""
    plugin = copy / "usdrigui" / "_seen.py"
    shutil.copy2(Path(__file__).with_name("mutants_seen.py"), plugin)
    before = {each.path: (copy / each.path).read_text(encoding="utf-8") for each in mutants}
    for path in before:
        of_file = [each for each in mutants if each.path == path]
        (copy / path).write_text(marked(path, of_file), encoding="utf-8")
    file.unlink(missing_ok=True)
    places = sorted(
        {each.place for each in mutants} | {at for path in before for at, _ in _functions(path)}
    )
    file.with_suffix(".places").write_text("\n".join(places), encoding="utf-8")
    file.with_suffix(".bytes").write_bytes(bytes(len(places)))
    environment = {"MUTANTS_SEEN": str(file.resolve())}
    done = _pytest(copy, ["-p", "usdrigui._seen", *tests], environment, None)
    print(done.stdout.strip().splitlines()[-1], flush=True)
    for path, text in before.items():
        (copy / path).write_text(text, encoding="utf-8")
    plugin.unlink()


def _pytest(
    copy: Path, arguments: Sequence[str], environment: dict[str, str], seconds: int | None
) -> subprocess.CompletedProcess[str]:
    def limited() -> None:
        if seconds is not None:
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))

    options = ["-n", "0", "--suite", "quick", "-p", "no:cacheprovider", "-p", "no:randomly"]
    return subprocess.run(
        [sys.executable, "-m", "pytest", *options, *arguments],
        cwd=copy,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **environment, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(copy)},
        preexec_fn=limited,
    )


def failing(copy: Path, tests: Sequence[str], seconds: float) -> str:
    """The first test that fails in the copy, `time` if they take too long, or nothing."""
    done = _pytest(copy, ["-x", *tests], {}, max(1, int(seconds)))
    if done.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return "time"
    if done.returncode == 0:
        return ""
    named = re.search(r"^(?:FAILED|ERROR) (?:at \w+: )?(.+?)(?: - .*)?$", done.stdout, re.MULTILINE)
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


def judged(copy: Path, mutant: Mutant, reached: Reached, seconds: float) -> str:
    """What kills the mutant; nothing where it survives."""
    tests = reached.by(mutant, seconds)
    if not tests:
        return ""
    allowed = 30.0 + 5.0 * sum(reached.seconds[each] for each in tests)
    target = copy / mutant.path
    sound = target.read_text(encoding="utf-8")
    target.write_text(mutant.applied(sound), encoding="utf-8")
    try:
        by = failing(copy, tests, allowed)
    finally:
        target.write_text(sound, encoding="utf-8")
    again = [by] if "::" in by else tests
    if by and by != "time" and failing(copy, again, allowed):
        raise SystemExit(f"{by}: so without a mutant: {' '.join(again)}")
    return by


def main() -> int:
    """Judge the mutants that were drawn; exit 1 if fewer than `--least` of them are killed."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--first", type=int, default=0, help="pass over so many of those drawn")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--within", nargs="+", choices=ROOMS, default=ROOMS)
    parser.add_argument("--record", nargs="+", default=RECORDED, metavar="TESTS")
    parser.add_argument("--only-record", type=Path, metavar="FILE")
    parser.add_argument("--reached", nargs="+", type=Path, metavar="FILE")
    parser.add_argument("--seconds", type=float, default=60.0)
    parser.add_argument("--least", type=float, default=0.9)
    parser.add_argument("--json", type=Path)
    asked = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as place:
        copy = _copied(Path(place, "copy"))
        chosen = drawn(asked.within, asked.first + asked.count, asked.seed)[asked.first :]
        if asked.only_record or not asked.reached:
            file = asked.only_record or Path(place, "reached")
            record(copy, chosen, asked.record, file)
            if asked.only_record:
                return 0
            asked.reached = [file]
        reached = Reached.read(asked.reached)
        for mutant in chosen:
            by = judged(copy, mutant, reached, asked.seconds)
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
