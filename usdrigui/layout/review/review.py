"""How good a layout is, and whether it still fits its rig: for layers from any tool, or from any
hand.

`review` compares a `Layout` with the rig as it is today and rates every element by the objective
that would place it (paper section 1: layouts also validate manual design choices).
"""

from __future__ import annotations

from collections.abc import Sequence

from usdrigui.character import Record
from usdrigui.errors import Issue, issue
from usdrigui.layout.measured import Measured
from usdrigui.layout.review.layout_faults import crowded, hidden, stale, unplaced
from usdrigui.layout.review.layout_problem import as_problem, board_cost, sound_elements
from usdrigui.layout.review.legibility import legibility_of
from usdrigui.layout.review.posing_time import PosingTimes, posing_times
from usdrigui.layout.review.rating import ElementReview, ratings
from usdrigui.layout.shares import HARDLY_ANY
from usdrigui.model import Candidates, Layout, Legibility
from usdrigui.overlap import total_cost


class Review(Record):
    """What `review` found."""

    issues: tuple[Issue, ...]
    elements: tuple[ElementReview, ...]
    cost: float
    """Objective of the elements on the face at their places; inf if two handles are too near."""
    legibility: Legibility
    posing: PosingTimes
    """Of the first part that has any."""


def review(
    known: Measured, candidates: Candidates, layout: Layout, whole: Layout | None = None
) -> Review:
    """Rate `layout` on the rig that was measured; faults come first, and what is faulty is not
    rated.  `whole` where it is not the layout of all of the character."""
    face, whole = known.face, whole or layout
    width = layout.frame.handle_width or face.handle_width
    faults = [
        *stale(face.rig, face.trajectories, (layout, whole), known.settings.read),
        *unplaced(face, layout, frozenset(whole.listed)),
        *crowded(layout.elements, width),
    ]
    sound = sound_elements(face, layout.elements)
    pinned = {element.name for element in layout.elements if "anchor" in element.pinned}
    issues = [*faults, *hidden(face, tuple(each for each in sound if each.name not in pinned))]
    answered = as_problem(known, candidates, layout.elements, sound)
    rated = ratings(face, layout.elements, answered)
    issues += [
        issue(
            "LAYOUT_BETTER_PLACE",
            each.element,
            f"would save {each.gain:.2f} at {each.better}",
        )
        for each in rated
        # The typical control's displacement is worth 1.
        if each.gain > HARDLY_ANY and each.element not in pinned
    ]
    read = legibility_of(face, layout.elements)
    issues += [issue("LAYOUT_UNCLEAR", name, why) for name, why in read.unclear]
    cost = total_cost(answered[0], answered[2]) + board_cost(known, candidates, layout.elements)
    listed = len(whole.controls)
    times = posing_times(face, layout.elements, width, listed) if read.elements else {}
    return Review(tuple(issues), rated, cost, read, times)


def joined(parts: Sequence[Review]) -> Review:
    """What was found of all parts of a character."""
    return Review(
        tuple(dict.fromkeys(found for each in parts for found in each.issues)),
        tuple(element for each in parts for element in each.elements),
        sum(each.cost for each in parts),
        sum((each.legibility for each in parts), Legibility(0, ())),
        next((each.posing for each in parts if each.posing), {}),
    )
