"""The account of a run: what became of every control, at what cost, proven how well, in what time.

`Report` is what `usdrigui.process` returns; `run_documents` writes it as JSON.  Timings alone
differ between identical runs.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from usdrigui.character import Floats, Record, Rig
from usdrigui.errors import Issue
from usdrigui.model import Assignment, Layout, Legibility
from usdrigui.model.levels import outer_first

Outcome = Literal["written", "unchanged", "dry run", "in memory"]
Place = Literal["face", "board", "left off"]


@dataclass(frozen=True, slots=True)
class ControlRow:
    """What became of one control."""

    control: str
    kind: str
    place: Place
    element: str
    """Name of the element that carries it; empty when left off."""
    twin: str
    displacement_kept: float
    """Arc length at the anchor over the control's peak; nan where it is not on the face."""
    reason: str
    """Why it is not on the face, or why it shares an element."""
    explained_by: Mapping[str, float] = field(default_factory=dict)
    """Controls that do together what it does, and how far each goes; empty for one that explains
    itself."""
    part: str = ""
    """The part of the character to which its element belongs; empty where there are none."""

    @property
    def stands(self) -> str:
        """Where a reader finds it: its part, the board, or nowhere."""
        return self.part or self.place if self.place == "face" else self.place


class PartRow(Record):
    """One part of a character and the proof of its layout."""

    name: str
    controls: tuple[str, ...]
    on_it: int
    """How many of them are on the part; the others are on the board."""
    handle_width: float
    view: Floats
    """(3,) unit direction from the part to the viewer."""
    assignment: Assignment


class CharacterReport(Record):
    """One SkelRoot."""

    root: str
    rig: Rig
    layout: Layout
    assignment: Assignment
    rows: tuple[ControlRow, ...]
    """One per control of the source, in its order; the left-off ones last."""
    issues: tuple[Issue, ...]
    """Findings about the rig and its controls."""
    difference: Any = None
    """`usdrigui.layout.review.difference.Difference` from the previous layout, where one was
    given."""
    added: frozenset[str] = frozenset()
    """Names of the elements that this run placed: all, but for those in the layer of
    `--base`."""
    matchings: Mapping[str, Any] = field(default_factory=dict)
    """`usdrigui.layout.reuse.identity.Matching` by the layout that was given: ``fixed``,
    ``previous``, ``like``."""
    parts: tuple[PartRow, ...] = ()
    """In the order in which they were laid out; `assignment` holds their sums."""
    legibility: Legibility = field(default=Legibility(0, ()))
    """Of the parts whose elements are measured as they are seen: a head's and a standing body."""

    def count(self, place: Place) -> int:
        """Number of controls at a place."""
        return sum(row.place == place for row in self.rows)

    def __repr__(self) -> str:
        return (
            f"<CharacterReport {self.root}: {len(self.rows)} controls, {len(self.layout.elements)}"
            " elements>"
        )

    @property
    def kept(self) -> float:
        """Mean share of their peak displacement that the controls on the face keep; nan if there
        are none."""
        on_face = [row.displacement_kept for row in self.rows if row.place == "face"]
        shares = [kept for kept in on_face if math.isfinite(kept)]
        return sum(shares) / len(shares) if shares else math.nan


@dataclass(frozen=True, slots=True)
class SourceRow:
    """One file that composed the asset."""

    path: str
    """Relative to the asset's folder, with forward slashes."""
    sha256: str
    """Hex digest of what was read."""


class Report(Record):
    """One run of `usdrigui.process`."""

    asset: str
    """As given."""
    output: str
    """Path of the layer, as given or derived; empty in a dry run."""
    outcome: Outcome
    characters: tuple[CharacterReport, ...]
    issues: tuple[Issue, ...]
    seconds: tuple[tuple[str, float], ...]
    """Wall-clock seconds per stage, in order."""
    settings: Mapping[str, Any] = field(default_factory=dict)
    sources: tuple[SourceRow, ...] = ()
    """The asset first."""
    layer: Any = None
    """`pxr.Sdf.Layer` with the layout of a stage that was laid out in memory; None where a file
    was."""

    def __repr__(self) -> str:
        counts = (
            f"{each.root}: {each.count('face')} of {len(each.rows)} controls on the face"
            for each in self.characters
        )
        where = f" {self.output}" if self.output else ""
        return f"<Report {self.outcome}{where}: {'; '.join(counts)}; {len(self.issues)} issues>"


def rows_of(
    rig: Rig,
    layout: Layout,
    twins: Mapping[str, str],
    explained_by: Mapping[str, Mapping[str, float]],
) -> tuple[ControlRow, ...]:
    """Account for every control: `twins` and `explained_by`, the controls that do together what one
    does, are by control name."""
    carried = {
        member.control: (element, member.arc_length / (member.peak or member.arc_length))
        for element in reversed(outer_first(layout.elements))  # the first level counts
        for member in element.members
    }
    reasons = {left.control: left.reason for left in (*rig.left_off, *layout.left_off)}
    rows = []
    for control in rig.controls:
        place: Place = "left off"
        element_name, part, kept, reason = "", "", math.nan, reasons.pop(control.name, "")
        if control.name in carried:
            element, share = carried[control.name]
            place = "board" if element.anchor.on_board else "face"
            element_name, part, reason = element.name, element.part, element.reason
            kept = share if place == "face" else kept
        twin = twins.get(control.name, "")
        others = explained_by.get(control.name, {})
        rows.append(
            ControlRow(
                control.name, control.kind, place, element_name, twin, kept, reason, others, part
            )
        )
    rows += [
        ControlRow(name, "", "left off", "", "", math.nan, reason)
        for name, reason in reasons.items()
    ]
    return tuple(rows)
