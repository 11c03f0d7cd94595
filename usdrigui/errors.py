"""Every way in which usdrigui refuses or complains, by stable code.

The code's entry in the catalogue (codes.toml) has its severity and the repair of the cause.
Library code raises `RigUIError` (via `refuse`) for what stops the run and collects `Issue` records
(via `issue`) for what does not.  Only `usdrigui.cli` turns either into output or an exit code.
"""

from __future__ import annotations

import tomllib
import traceback
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from difflib import get_close_matches
from enum import IntEnum
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Literal

_SLIP = 0.85
"""Likeness (difflib) from which a name is another with a slip of a letter."""


NO_LAYOUT = ("LAYOUT_MISSING", "LAYOUT_OFF")
"""What a stage without a layout is refused for by all that need one."""

Severity = Literal["info", "warning", "error"]


class Exit(IntEnum):
    """Process exit codes of every command."""

    OK = 0
    """Written or unchanged; warnings allowed."""
    REFUSED = 1
    """The asset was refused, or `--strict` met a warning."""
    USAGE = 2
    """Wrong command line or configuration."""
    FILE = 3
    """A file could not be read or written."""
    LIMIT = 4
    """A time or memory limit was hit before there was a usable result."""
    BUG = 5
    """A bug of usdrigui."""


@dataclass(frozen=True, slots=True)
class Code:
    """Catalogue entry of one issue code."""

    severity: Severity
    meaning: str
    """One sentence, without the facts of the case."""
    repair: str
    """What the user can do about it."""
    exit: Exit
    """Exit code when the issue ends the run."""
    covers: Sequence[str] = ()
    """Codes of what follows from it on the same character: told with it, not by themselves."""


@cache
def catalogue() -> Mapping[str, Code]:
    """Every issue code with what is known of it, in the order of codes.toml."""
    entries = tomllib.loads((files(__package__) / "codes.toml").read_text("utf-8"))
    return {code: Code(**entry | {"exit": Exit[entry["exit"]]}) for code, entry in entries.items()}


@dataclass(frozen=True, slots=True)
class Issue:
    """One finding about an asset, a configuration or a layout."""

    code: str
    severity: Severity
    path: str
    """USD prim path, or the file or settings key when there is no prim; may be empty."""
    message: str
    repair: str
    character: str = ""
    """SkelRoot that it is about, with the variants looked at; empty for what is about a file or a
    whole stage."""

    @property
    def where(self) -> str:
        """`path` behind the character that it belongs to, unless it lies below that anyway."""
        if not self.character or f"{self.path}/".startswith(f"{self.character}/"):
            return self.path
        return f"{self.character} {self.path}".rstrip()


class RigUIError(Exception):
    """The run cannot go on; carries one `Issue` and the exit code it calls for, and what else is
    wrong of the kind."""

    def __init__(self, found: Issue, exit_code: Exit, others: tuple[Issue, ...] = ()) -> None:
        super().__init__(f"{found.code} {found.path}: {found.message}")
        self.issue = found
        self.exit_code = exit_code
        self.others = others

    @property
    def issues(self) -> tuple[Issue, ...]:
        """All that is wrong."""
        return (self.issue, *self.others)


class Faults:
    """Errors that are reported all at once: who mends a configuration wants to mend all of it."""

    def __init__(self) -> None:
        self._found: list[RigUIError] = []

    @contextmanager
    def collected(self) -> Iterator[None]:
        """Keep the error that the block raises."""
        try:
            yield
        except RigUIError as error:
            self._found.append(error)

    def add(self, issues: Iterable[Issue]) -> None:
        """Keep errors that were collected elsewhere."""
        self._found += [RigUIError(each, catalogue()[each.code].exit) for each in issues]

    @property
    def issues(self) -> tuple[Issue, ...]:
        """All that was collected, each once."""
        return tuple(dict.fromkeys(each for error in self._found for each in error.issues))

    def raise_all(self) -> None:
        """Raise the first error with the issues of the others, if there is any."""
        if self._found:
            raise RigUIError(self.issues[0], self._found[0].exit_code, self.issues[1:])


def issue(code: str, path: object, message: str, character: str = "") -> Issue:
    """Record a finding; `code` must be in the catalogue, and the text of `path` is its path."""
    entry = catalogue()[code]
    return Issue(code, entry.severity, str(path), message, entry.repair, character)


def of_character(character: str, found: Iterable[Issue]) -> tuple[Issue, ...]:
    """The findings as those of one character; one that has a character keeps it."""
    return tuple(each if each.character else replace(each, character=character) for each in found)


def refuse(code: str, path: object, message: str) -> RigUIError:
    """Build (not raise) the error for a finding that ends the run: ``raise refuse(...)``; `path` as
    in `issue`."""
    entry = catalogue()[code]
    return RigUIError(Issue(code, "error", str(path), message, entry.repair), entry.exit)


def raised_at(error: BaseException) -> str:
    """File and line where an error of ours was raised, in brackets; empty where nobody knows."""
    called = traceback.extract_tb(error.__traceback__)[-1:]
    return "".join(f" ({Path(each.filename).name}:{each.lineno})" for each in called)


def sentences(found: Issue) -> str:
    """What was found and what can be done about it, as two sentences."""
    said = found.message.removesuffix(".")
    return f"{said}{'' if said.endswith('?') else '.'} {found.repair}"


def by_cause(found: Iterable[Issue]) -> tuple[Issue, ...]:
    """One issue for each cause, in the order given: the paths of those of one character, code and
    message are one issue, and what another one of the character covers is left out."""
    found = tuple(found)
    covered = {(each.character, code) for each in found for code in catalogue()[each.code].covers}
    causes: dict[tuple[str, str, str], list[Issue]] = {}
    for each in found:
        if (each.character, each.code) not in covered:
            causes.setdefault((each.character, each.code, each.message), []).append(each)
    return tuple(
        replace(same[0], path=listed([each.path for each in same])) for same in causes.values()
    )


def listed(names: Sequence[str]) -> str:
    """At most three names or paths and the number of others: ``a and b``, ``a, b, c and 2
    more``."""
    shown = [*names[:3], *([f"{len(names) - 3} more"] if len(names) > 3 else [])]
    return ", ".join(shown[:-1]) + " and " * (len(shown) > 1) + "".join(shown[-1:])


def counted(number: int, noun: str) -> str:
    """``1 control``, ``2 controls``."""
    return f"{number} {noun}{'s' * (number != 1)}"


def meant(name: str, known: Iterable[str]) -> str:
    """A clause for a message about an unknown name: ``; did you mean 'smile_L'?``, empty where
    nothing is like it.

    A slip of a letter comes first, then the same name in another spelling or one that means the
    same, then one with nearly the same letters.  A slip does not turn left into right.
    """
    from usdrigui.conventions import same_name
    from usdrigui.conventions.sides import side_of

    folded = {each.lower(): each for each in known}
    same_side = [each for each, spelling in folded.items() if side_of(spelling) == side_of(name)]
    slip = next(iter(get_close_matches(name.lower(), same_side, n=1, cutoff=_SLIP)), "")
    near = get_close_matches(name.lower(), folded, n=1)
    like = slip or same_name(name, tuple(folded.values())) or next(iter(near), "")
    return f"; did you mean {folded.get(like, like)!r}?" if like else ""


def check_known(
    name: str, known: Collection[str], where: str, lacking: str = "there is no control"
) -> None:
    """Raise CONFIG_UNKNOWN_CONTROL for a name that is not `known`, with the one that may be meant;
    `lacking` says who has no control of it."""
    if name not in known:
        raise refuse("CONFIG_UNKNOWN_CONTROL", where, f"{lacking} {name!r}{meant(name, known)}")


def visible(text: str) -> str:
    """Text that comes from a file as a terminal may show it: what would steer the terminal is spelt
    out."""
    return "".join(
        each if each.isprintable() else each.encode("unicode_escape").decode() for each in text
    )
