"""What changed between two layouts of a character, control by control, with reasons where known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np

from usdrigui.errors import counted, listed
from usdrigui.layout.reuse.renaming import with_names
from usdrigui.layout.shares import NOTHING
from usdrigui.model import SURE, Anchor, Element, Layout
from usdrigui.model.levels import inner_names, outer_first

ChangeKind = Literal["added", "removed", "renamed", "regrouped", "to the face", "board", "moved"]
_KINDS: tuple[ChangeKind, ...] = get_args(ChangeKind)
"""In the order in which changes are told."""

_RESHAPED = 0.02
"""Share of its peak by which a motion that was made anew differs at least."""


@dataclass(frozen=True, slots=True)
class Change:
    """One control that is not what or where it was."""

    control: str
    kind: ChangeKind
    """``regrouped`` when it shares its element with others than before, wherever that is."""
    element: str
    """Its element now; before, when it was removed."""
    distance: float
    """How far its handle is from where it was, in handle widths of the earlier layout; nan unless
    it was on the face before and is now."""
    before: str
    """``MESH_PATH#POINT``, ``board`` or empty."""
    after: str
    why: tuple[str, ...]
    """Clauses, without full stops; of what came, went or has another name they may be none."""
    was: str = ""
    """The name of the control before, where that was another."""


@dataclass(frozen=True, slots=True)
class Difference:
    """All changes between two layouts of one character, by kind and then by name."""

    root: str
    changes: tuple[Change, ...]
    shared: int
    """Controls that both layouts have, however many handles each has."""

    @property
    def changed(self) -> int:
        """How many of these are not what or where they were."""
        return len({change.control for change in self.displaced})

    @property
    def displaced(self) -> tuple[Change, ...]:
        """Changes of controls that both have."""
        return tuple(
            change for change in self.changes if change.kind not in ("added", "removed", "renamed")
        )

    @property
    def renamed(self) -> int:
        """How many controls have another name now, whether or not they moved."""
        return len({change.was for change in self.changes if change.was})


@dataclass(frozen=True, slots=True)
class _Pair:
    """A control in its elements of two layouts, the earlier one with the names of the later."""

    control: str
    layouts: tuple[Layout, Layout]
    elements: tuple[Element, Element]

    @property
    def anchors(self) -> tuple[Anchor, Anchor]:
        """Where it was and where it is."""
        return self.elements[0].anchor, self.elements[1].anchor

    @property
    def partners(self) -> tuple[frozenset[str], frozenset[str]]:
        """The controls with which it shared its element, and those with which it shares it."""
        return self.elements[0].controls, self.elements[1].controls

    @property
    def handles(self) -> tuple[int, int]:
        """How many elements of the first level it has: two, where it is doubled across the
        middle."""
        one, other = (_handles(layout.elements, self.control) for layout in self.layouts)
        return one, other

    @property
    def distance(self) -> float:
        """In handle widths of the earlier layout, to three digits, as layers hold single precision;
        nan unless it was on the face and is."""
        one, other = self.anchors
        if one.on_board or other.on_board:
            return float(np.nan)
        width = self.layouts[0].frame.handle_width
        apart = float(np.linalg.norm(one.position - other.position))
        return round(apart / width if width > 0.0 else apart, 3)


def difference(before: Layout, after: Layout) -> Difference:
    """Compare two layouts of one character, in the same units.

    Which control of the one is which of the other is what `after` has on record of `before`, else
    their names tell.  The places of elements on the board are not compared.
    """
    recorded = [each for each in after.matches if each.before in before.controls]
    sure = {each.before: each.after for each in recorded if each.confidence >= SURE}
    may_be = {each.before: f"may be {each.after} ({each.sure})" for each in recorded}
    then = with_names(before, sure)
    old, new = (_by_control(layout) for layout in (then, after))
    was = {now: earlier for earlier, now in sure.items()}
    changes = [
        _alone(name, "added", new[name, 0]) for name in sorted(after.controls - then.controls)
    ]
    for name in sorted(then.controls - after.controls):
        gone = _alone(name, "removed", old[name, 0])
        changes.append(replace(gone, why=(may_be[name],) if name in may_be else ()))
    for key in sorted(old.keys() & new.keys()):
        pair = _Pair(key[0], (then, after), (old[key], new[key]))
        kind = _kind(pair) or ("renamed" if key[0] in was else None)
        if kind is not None:
            why = () if kind == "renamed" else tuple(_reasons(pair, kind))
            changes.append(_change(pair, kind, why, was.get(key[0], "")))
    changes.sort(key=lambda change: _KINDS.index(change.kind))
    found = tuple(_with_cause(change, changes, (then, after)) for change in changes)
    return Difference(after.root, found, len(then.controls & after.controls))


def _by_control(layout: Layout) -> dict[tuple[str, int], Element]:
    """By control and by how many elements before this one hold it too: of doubled ones the left one
    comes first."""
    found: dict[tuple[str, int], Element] = {}
    normal = layout.frame.plane.normal
    from_left = sorted(layout.elements, key=lambda each: -float(each.anchor.position @ normal))
    for element in outer_first(from_left):
        for member in element.members:
            count = 0
            while (member.control, count) in found:
                count += 1
            found[member.control, count] = element
    return found


def _alone(control: str, kind: Literal["added", "removed"], element: Element) -> Change:
    place, added = element.anchor.place, kind == "added"
    places = ("", place) if added else (place, "")
    why = (element.reason,) if added and element.reason else ()
    return Change(control, kind, element.name, np.nan, *places, why)


def _change(pair: _Pair, kind: ChangeKind, why: tuple[str, ...], was: str) -> Change:
    places = pair.anchors[0].place, pair.anchors[1].place
    return Change(pair.control, kind, pair.elements[1].name, pair.distance, *places, why, was)


def _kind(pair: _Pair) -> ChangeKind | None:
    then, now = (layout.controls for layout in pair.layouts)
    (one, other), partners = pair.anchors, pair.partners
    # A partner that is gone or new is not a regrouping of those who stay.
    if partners[0] & now != partners[1] & then:
        return "regrouped"
    if one.on_board != other.on_board:
        return "board" if other.on_board else "to the face"
    if other.on_board:
        return None
    if pair.handles[0] != pair.handles[1]:
        return "moved"
    if one.mesh == other.mesh and one.topology_hash == other.topology_hash:
        return None if one.point == other.point else "moved"
    return "moved" if pair.distance > NOTHING else None


def _reasons(pair: _Pair, kind: ChangeKind) -> Iterator[str]:
    (one, other), (before, now) = pair.anchors, pair.partners
    was, element = pair.elements[0].pinned, pair.elements[1]
    pinned = element.pinned
    if joined := sorted(now - before):
        yield f"shares its element with {', '.join(joined)}"
    if left := sorted(before - now):
        yield f"no longer shares its element with {', '.join(left)}"
    change = one.mesh_change(other.topology_hash, other.point_count)
    if change and one.mesh == other.mesh and not one.on_board:
        yield change
    decided = "anchor" in pinned
    if kind != "to the face" and not (one.on_board or decided):
        yield from _crowd(pair)
    if kind == "board" and element.reason:
        yield element.reason
    same_mesh = one.topology_hash == other.topology_hash
    if decided and ("anchor" not in was or (same_mesh and one.place != other.place)):
        yield "its anchor, or its twin's, was decided by a person"
    if "place" in pinned and "place" not in was:
        yield "on the face or on the board was decided by a person"
    if "anchor" in set(was) - set(pinned):
        yield "its anchor is no longer the one that a person had decided"
    if pair.handles[0] != pair.handles[1]:
        yield f"has {counted(pair.handles[1], 'handle')} now, {pair.handles[0]} before"
    then, today = (
        next(m for m in each.members if m.control == pair.control) for each in pair.elements
    )
    ranges = [f"{m.values[0]:.4g} to {m.values[-1]:.4g}" for m in (then, today)]
    if ranges[0] != ranges[1]:
        yield f"its range is {ranges[1]} now, {ranges[0]} before"
    elif abs(today.peak - then.peak) > _RESHAPED * then.peak > 0.0:
        yield f"it moves its farthest point {today.peak / then.peak:.2f} times as far as before"


def _with_cause(change: Change, every: Sequence[Change], layouts: tuple[Layout, Layout]) -> Change:
    """The change with the reason from what else differs, where its own circumstances tell none."""
    if change.why or change.kind in ("added", "removed", "renamed"):
        return change
    one, other = (dict(layout.proof.weights) for layout in layouts)
    settings = sorted(name for name in one.keys() & other.keys() if one[name] != other[name])
    if settings:
        return replace(change, why=(f"made with other settings: {listed(settings)}",))
    others = sorted({each.control for each in every if each.control != change.control})
    if others:
        return replace(change, why=(f"makes room, as {listed(others)} changed",))
    return replace(change, why=("no reason recorded: made with another motion or version",))


def _handles(elements: tuple[Element, ...], control: str) -> int:
    inner = inner_names(elements)
    return sum(control in element.controls for element in elements if element.name not in inner)


def _crowd(pair: _Pair) -> Iterator[str]:
    """Whose handle is now nearer to the old place than two handles may be."""
    (_, after), (then, now) = pair.layouts, pair.elements
    for element in after.elements:
        if element is now or element.anchor.on_board:
            continue
        apart = float(np.linalg.norm(element.anchor.position - then.anchor.position))
        others = pair.partners[0].isdisjoint(element.controls)
        if others and apart < after.frame.handle_width * (1.0 - NOTHING):
            decided = ", whose anchor was decided by a person" * ("anchor" in element.pinned)
            yield f"its place is taken by {element.name}{decided}"
