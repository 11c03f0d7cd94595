"""What changed between two layouts of a character, control by control, with reasons where known.

`difference` compares two `Layout` records alone, from any tool.  `cost_savings` takes the solved
problem: how much cost each element saves by leaving its earlier place.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.errors import listed
from usdrigui.layout.element.elements import names_of_copies
from usdrigui.layout.measured import Measured
from usdrigui.layout.place.problem import PlacementProblem, penalties_of_leaving
from usdrigui.layout.reuse.identity import Matching, match_layouts
from usdrigui.layout.reuse.renaming import with_names
from usdrigui.layout.review.rating import cost_given_others
from usdrigui.model import Element, Layout
from usdrigui.model.levels import inner_names, outer_first

ChangeKind = Literal["added", "removed", "renamed", "moved", "to the face", "board", "regrouped"]

_STILL = 1e-3
"""Handles nearer to where they were than this many handle widths have not moved."""


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
    def renamed(self) -> tuple[Change, ...]:
        """Changes of controls that have another name now, whether or not they moved."""
        return tuple(change for change in self.changes if change.was)


@dataclass(frozen=True, slots=True)
class _Membership:
    """A control in its element."""

    control: str
    element: Element

    @property
    def partners(self) -> frozenset[str]:
        return self.element.manipulator.controls


def difference(
    before: Layout,
    after: Layout,
    improvements: Mapping[str, float] | None = None,
    matching: Matching | None = None,
) -> Difference:
    """Compare two layouts of one character.

    `improvements` is what each element of `after` saves by its move, in the units
    of the objective, as far as known; `matching` maps the controls of the one to those of the
    other, and is worked out from the layouts where it is not given.  The places of elements on the
    board are not compared.
    """
    matching = matching or match_layouts(before, after)
    names = matching.renamed
    then = with_names(before, names)
    old = _memberships(then.elements, then.frame.plane.normal)
    new = _memberships(after.elements, after.frame.plane.normal)
    was = {now: earlier for earlier, now in names.items()}
    changes = [
        *(_added(new[name, 0]) for name in sorted(after.controls - then.controls)),
        *(_removed(old[name, 0], matching) for name in sorted(then.controls - after.controls)),
        *(
            _renamed(then, after, old[key], new[key], was, improvements)
            for key in sorted(old.keys() & new.keys())
        ),
    ]
    found = [change for change in changes if change is not None]
    kinds: tuple[ChangeKind, ...] = (
        "added",
        "removed",
        "renamed",
        "regrouped",
        "to the face",
        "board",
        "moved",
    )
    found.sort(key=lambda change: kinds.index(change.kind))
    return Difference(after.character.root, tuple(found), len(then.controls & after.controls))


def _memberships(
    elements: tuple[Element, ...], plane_normal: Floats
) -> dict[tuple[str, int], _Membership]:
    """By control and by how many elements before this one hold it too: of doubled ones the left one
    comes first."""
    memberships: dict[tuple[str, int], _Membership] = {}
    from_left = sorted(elements, key=lambda each: -float(each.anchor.position @ plane_normal))
    for element in outer_first(from_left):
        for member in element.manipulator.members:
            count = 0
            while (member.control, count) in memberships:
                count += 1
            memberships[member.control, count] = _Membership(member.control, element)
    return memberships


def _added(held: _Membership) -> Change:
    why = (held.element.placement.reason,) if held.element.placement.reason else ()
    return Change(
        held.control, "added", held.element.name, np.nan, "", held.element.anchor.place, why
    )


def _removed(held: _Membership, matching: Matching) -> Change:
    may_be = {each.before: f"may be {each.after} ({each.sure})" for each in matching.unsure}
    why = (may_be[held.control],) if held.control in may_be else ()
    return Change(
        held.control, "removed", held.element.name, np.nan, held.element.anchor.place, "", why
    )


def _renamed(
    before: Layout,
    after: Layout,
    old: _Membership,
    new: _Membership,
    was: Mapping[str, str],
    improvements: Mapping[str, float] | None,
) -> Change | None:
    """What changed of a control that both have; its name, if nothing else."""
    change = _compared(before, after, old, new, improvements or {})
    earlier = was.get(new.control, "")
    if change is None and earlier:
        where = old.element.anchor.place, new.element.anchor.place
        return Change(
            new.control,
            "renamed",
            new.element.name,
            _distance(before.frame.handle_width, old, new),
            *where,
            (),
            earlier,
        )
    return change and replace(change, was=earlier)


def _compared(
    before: Layout,
    after: Layout,
    old: _Membership,
    new: _Membership,
    improvements: Mapping[str, float],
) -> Change | None:
    kind = _kind(before, after, old, new)
    if kind is None:
        return None
    distance = _distance(before.frame.handle_width, old, new)
    why = tuple(_reasons(before, after, old, new, kind, improvements))
    why = why or (_unexplained(before, after),)
    return Change(
        new.control,
        kind,
        new.element.name,
        distance,
        old.element.anchor.place,
        new.element.anchor.place,
        why,
    )


def _kind(before: Layout, after: Layout, old: _Membership, new: _Membership) -> ChangeKind | None:
    then, now = before.controls, after.controls
    one, other = old.element.anchor, new.element.anchor
    # A partner that is gone or new is not a regrouping of those who stay.
    if old.partners & now != new.partners & then:
        return "regrouped"
    if one.on_board != other.on_board:
        return "board" if other.on_board else "to the face"
    if other.on_board:
        return None
    if _handles(before.elements, old.control) != _handles(after.elements, new.control):
        return "moved"
    if _same_mesh(old, new):
        return None if one.point == other.point else "moved"
    return "moved" if _distance(before.frame.handle_width, old, new) > _STILL else None


def _same_mesh(old: _Membership, new: _Membership) -> bool:
    one, other = old.element.anchor, new.element.anchor
    return one.mesh == other.mesh and one.topology_hash == other.topology_hash


def _distance(handle_width: float, old: _Membership, new: _Membership) -> float:
    one, other = old.element.anchor, new.element.anchor
    if one.on_board or other.on_board:
        return float(np.nan)
    apart = float(np.linalg.norm(one.position - other.position))
    return apart / handle_width if handle_width > 0.0 else apart


def _reasons(
    before: Layout,
    after: Layout,
    old: _Membership,
    new: _Membership,
    kind: ChangeKind,
    improvements: Mapping[str, float],
) -> Iterator[str]:
    one, other = old.element.anchor, new.element.anchor
    was, now = old.element.placement, new.element.placement
    joined, left = sorted(new.partners - old.partners), sorted(old.partners - new.partners)
    if joined:
        yield f"shares its element with {', '.join(joined)}"
    if left:
        yield f"no longer shares its element with {', '.join(left)}"
    change = one.mesh_change(other.topology_hash, other.point_count)
    if not one.on_board and one.mesh == other.mesh and change:
        yield change
    decided = "anchor" in now.pinned
    if kind in ("moved", "board", "regrouped") and not (one.on_board or decided):
        yield from _crowd(after.elements, after.frame.handle_width, old, new)
    if kind == "board" and now.reason:
        yield now.reason
    newly = decided and "anchor" not in was.pinned
    if newly or (decided and one.topology_hash == other.topology_hash and one.place != other.place):
        yield "its anchor, or its twin's, was decided by a person"
    if "anchor" in set(was.pinned) - set(now.pinned):
        yield "its anchor is no longer the one that a person had decided"
    handles = [_handles(layout.elements, new.control) for layout in (before, after)]
    if handles[0] != handles[1]:
        yield f"has {handles[1]} handle{'s' * (handles[1] != 1)} now, {handles[0]} before"
    if new.element.name in improvements:
        yield f"saves {improvements[new.element.name]:.2f}"


def _unexplained(before: Layout, after: Layout) -> str:
    """The reason, from the layouts, of a change that none of its own circumstances explains."""
    weights = sorted({name for name, _ in set(before.proof.weights) ^ set(after.proof.weights)})
    if weights:
        return f"made with other settings: {listed(weights)}"
    then, now = before.frame.handle_width, after.frame.handle_width
    wider = now / then if then > 0.0 else 1.0
    if abs(wider - 1.0) > _STILL:
        return f"handles are {wider:.2f} times as wide"
    return "no reason recorded: made with another motion, configuration or version"


def _handles(elements: tuple[Element, ...], control: str) -> int:
    """How many elements of the first level a control has: two, where it is doubled across the
    middle."""
    inner = inner_names(elements)
    return sum(
        control in element.manipulator.controls for element in elements if element.name not in inner
    )


def _crowd(
    elements: tuple[Element, ...], handle_width: float, old: _Membership, new: _Membership
) -> Iterator[str]:
    """Whose handle is now nearer to the old place than two handles may be."""
    for element in elements:
        if (
            element is new.element
            or element.anchor.on_board
            or old.partners & element.manipulator.controls
        ):
            continue
        apart = float(np.linalg.norm(element.anchor.position - old.element.anchor.position))
        if apart < handle_width * (1.0 - _STILL):
            decided = ", whose anchor was decided by a person" * (
                "anchor" in element.placement.pinned
            )
            yield f"its place is taken by {element.name}{decided}"


def cost_savings(known: Measured, placement: PlacementProblem, labels: Indices) -> dict[str, float]:
    """By element: cost at its earlier place less cost where it is, all others being where they
    are now.

    Elements that stay, that had no place on the face, or that can no longer be there are left
    out.
    """
    found: dict[str, float] = {}
    problem, face, requests = placement.problem, known.face, known.requests
    for index, choice in enumerate(placement.choices):
        group = placement.groups[choice.group]
        stay, leave = penalties_of_leaving(
            face, requests.of_axes() if group.part else requests, choice
        )
        label, earlier = int(labels[index]), int(np.argmin(stay)) if len(stay) else -1
        if leave <= 0.0 or earlier < 0 or label == earlier or np.ptp(stay) == 0.0:
            continue
        plain: Floats = cost_given_others(problem, labels, index) - stay
        now = problem.variables[index].off_face_cost - leave if label < 0 else plain[label]
        if np.isfinite(plain[earlier]):
            improvement = float(plain[earlier] - now)
            found |= dict.fromkeys(names_of_copies(face.rig, group, choice), improvement)
    return found
