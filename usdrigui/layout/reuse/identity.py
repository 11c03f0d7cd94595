"""Which control is which: the controls of two rigs, or of a layout and a rig, matched one to one.

Names change their spelling, meshes their topology, and shapes are sculpted again; seldom does all
that change at once. Every pair of controls is weighed by their names and by their motions
to the face, in logarithms of odds; the assignment of greatest total is taken, and what it would
lose without a pair is how sure that pair is.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import linear_sum_assignment

from usdrigui.character import Floats, Rig
from usdrigui.conventions import spellings
from usdrigui.errors import Issue, issue
from usdrigui.layout.reuse.motion_evidence import at_anchors, kinds, over_faces
from usdrigui.layout.reuse.name_evidence import CHANCE, name_evidence, same_meaning
from usdrigui.model import SURE, Layout, Match, Trajectories
from usdrigui.model.levels import outer_first
from usdrigui.ties import rounded


@dataclass(frozen=True, slots=True)
class Matching:
    """What is matched, and what is left on either side."""

    matches: tuple[Match, ...] = ()
    """In the order of the controls before."""
    left_before: tuple[str, ...] = ()
    left_after: tuple[str, ...] = ()

    @property
    def names(self) -> dict[str, str]:
        """The name after by the name before, of the matches that are sure."""
        return {each.before: each.after for each in self.matches if each.confidence >= SURE}

    @property
    def renamed(self) -> dict[str, str]:
        """The same, of controls that have another name now."""
        return {before: after for before, after in self.names.items() if before != after}

    @property
    def unsure(self) -> tuple[Match, ...]:
        """Matches that are reported and not acted upon."""
        return tuple(each for each in self.matches if each.confidence < SURE)


def match_rigs(
    before: tuple[Rig, Trajectories],
    after: tuple[Rig, Trajectories],
    chosen: Mapping[str, str] | None = None,
) -> Matching:
    """The controls of two characters, whatever their names, topology, size and place in the world.

    `chosen`: names after by names before that somebody has decided; an empty one has no
    counterpart.
    """
    chosen = chosen or {}
    names = before[0].control_names, after[0].control_names
    decided = tuple(Match(a, b, 1.0, "configuration") for a, b in chosen.items() if b)
    one = [name for name in names[0] if name not in chosen]
    other = [name for name in names[1] if name not in chosen.values()]
    named = name_evidence(one, other)
    found = _matched(one, other, named)
    rows = [before[0].control_indices[name] for name in one]
    columns = [after[0].control_indices[name] for name in other]
    compared = kinds(before, after)
    # Matches are landmarks of the map between the faces, which outvotes wrong ones, and the map
    # shapes the matches, until it is one that was there.
    known: list[dict[str, str]] = []
    while (landmarks := {m.before: m.after for m in (*decided, *found.matches)}) not in known:
        known.append(landmarks)
        found = _matched(one, other, named + over_faces(compared, landmarks)[np.ix_(rows, columns)])
    dropped = tuple(name for name in chosen if not chosen[name])
    return _joined(names[0], decided, replace(found, left_before=(*found.left_before, *dropped)))


def match_layout(layout: Layout, rig: Rig, trajectories: Trajectories) -> Matching:
    """The controls of an earlier layout of a character and those of the character today.

    A control that keeps its name is the same control, unless the name is a mere number.
    """
    members = (member for each in outer_first(layout.elements) for member in each.members)
    before = list(dict.fromkeys(member.control for member in members))
    kept, left, new = _kept(before, rig.control_names)
    if not left:
        return Matching(kept, (), tuple(new))
    evidence = name_evidence(left, new) + at_anchors(layout.elements, left, rig, trajectories, new)
    return _joined(before, kept, _matched(left, new, evidence))


def matching_issues(which: str, found: Matching) -> Iterator[Issue]:
    """Controls of an earlier layout of the character that have another name now, or may have;
    `which` it is."""
    if which == "like":
        return  # two characters owe each other no names
    for each in found.matches:
        if each.before != each.after:
            code, verb = (
                ("CONTROL_RENAMED", "is")
                if each.confidence >= SURE
                else ("CONTROL_UNSURE", "may be")
            )
            message = (
                f"of the {which} layout {verb} {each.after} now (by {each.reason}, {each.sure})"
            )
            yield issue(code, each.before, message)


def names_draft(found: Matching) -> str:
    """The matching as ``[like.names]`` of a configuration: what is sure as it is, the rest as
    comments to decide on."""
    lines = ["[like.names]"]
    for each in found.matches:
        if each.before != each.after:
            mark = "" if each.confidence >= SURE else "# "
            pair = f"{_quoted(each.before)} = {_quoted(each.after)}"
            lines.append(f"{mark}{pair}  # {each.reason}, {each.sure}")
    lines += [f'# {_quoted(name)} = ""  # no counterpart found' for name in found.left_before]
    if found.left_after:
        lines.append("# of this character without a counterpart:")
        lines += [f"#   {_quoted(name)}" for name in found.left_after]
    return "\n".join(lines) + "\n"


def _quoted(name: str) -> str:
    return json.dumps(name, ensure_ascii=True)


def _kept(
    before: Sequence[str], after: Sequence[str]
) -> tuple[tuple[Match, ...], list[str], list[str]]:
    """The controls that keep their names, and what is left on either side."""
    spelt = dict(zip(before, spellings(before), strict=True))
    same = {name for name in before if name in set(after) and not spelt[name].is_number}
    kept = tuple(Match(name, name, 1.0, "name") for name in before if name in same)
    return (
        kept,
        [name for name in before if name not in same],
        [name for name in after if name not in same],
    )


def _joined(before: Sequence[str], kept: tuple[Match, ...], found: Matching) -> Matching:
    order = {name: number for number, name in enumerate(before)}
    matches = sorted((*kept, *found.matches), key=lambda each: order[each.before])
    return Matching(tuple(matches), found.left_before, found.left_after)


# --- the assignment -------------------------------------------------------------------------------


def _matched(before: Sequence[str], after: Sequence[str], evidence: Floats) -> Matching:
    """The assignment of greatest evidence (before, after); a pair below what chance may give is
    none."""
    odds = evidence - CHANCE
    excess = np.maximum(rounded(odds) * np.abs(odds).max(initial=0.0), 0.0)
    pairs = _assigned(excess)
    spelt_as, means = (spellings(before), spellings(after)), same_meaning(before, after)
    matches = []
    for i, j, confidence in pairs:
        reason = (
            "name"
            if before[i] == after[j]
            else "spelling"
            if spelt_as[0][i] == spelt_as[1][j]
            else "meaning"
            if means[i, j]
            else "motion"
        )
        matches.append(Match(before[i], after[j], confidence, reason))
    rows, columns = {i for i, _, _ in pairs}, {j for _, j, _ in pairs}
    left = tuple(name for i, name in enumerate(before) if i not in rows)
    return Matching(
        tuple(matches), left, tuple(name for j, name in enumerate(after) if j not in columns)
    )


def _assigned(evidence: Floats) -> list[tuple[int, int, float]]:
    """Rows and columns of the assignment of greatest total, and how sure each pair is: the logistic
    of what the total would lose without it."""
    rows, columns = linear_sum_assignment(-evidence)
    total = evidence[rows, columns].sum()
    return [
        (i, j, _confidence(evidence, i, j, total))
        for i, j in zip(rows.tolist(), columns.tolist(), strict=True)
        if evidence[i, j] > 0.0
    ]


def _confidence(evidence: Floats, row: int, column: int, total: float) -> float:
    """How sure a pair is, to three digits.

    The best assignment without the pair, less what it gives to its row and its column, is one of
    the rest: a bound below what is lost, which often is enough.
    """
    without = evidence.copy()
    without[row, column] = 0.0
    least = evidence[row, column] - without[row].max() - without[:, column].max()
    if _logistic(least) == 1.0:
        return 1.0
    i, j = linear_sum_assignment(-without)
    return _logistic(total - without[i, j].sum())


def _logistic(odds: float) -> float:
    return round(float(1.0 / (1.0 + np.exp(-odds))), 3)
