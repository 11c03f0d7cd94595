"""The layouts of all parts of a character as one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from usdrigui.errors import Issue
from usdrigui.layout.element.elements import proof_of
from usdrigui.layout.parts.joint_regions import OF_SIDES
from usdrigui.model import Assignment, Layout, LayoutPart, main_part
from usdrigui.pipeline.records import LaidPart, ProblemInputs


def joined(laid: Sequence[LaidPart]) -> Layout:
    """The layouts of all parts as one.  A character in one part has none by name, but hands alone:
    each has its own view."""
    layouts = {each.inputs.part: each.layout for each in laid}
    main = layouts[main_part(list(layouts))]
    if len(laid) == 1 and not {*layouts} & {*OF_SIDES}:
        return main
    whole = joined_assignment([each.assignment for each in laid], list(layouts))
    parts = [
        LayoutPart(
            name,
            each.frame.handle_width,
            each.frame.view,
            each.proof.status,
            each.proof.cost,
            each.proof.bound,
        )
        for name, each in layouts.items()
    ]
    return replace(
        main,
        elements=tuple(element for each in layouts.values() for element in each.elements),
        left_off=tuple(dict.fromkeys(left for each in layouts.values() for left in each.left_off)),
        frame=replace(main.frame, parts=tuple(parts)),
        proof=proof_of(whole, main.proof.weights),
    )


def joined_assignment(assignments: Sequence[Assignment], names: Sequence[str]) -> Assignment:
    """The solutions of all parts, whose `names` are given, as one: costs and bounds are sums.

    How the whole ended is told by the first part that is open, else by the first that took a
    solver.
    """
    if len(assignments) == 1:
        return assignments[0]
    return replace(
        max(assignments, key=lambda each: (each.status != "optimal", each.method != "bounds")),
        labels=np.concatenate([each.labels for each in assignments]),
        cost=sum(each.cost for each in assignments),
        bound=sum(each.bound for each in assignments),
        penalty=sum(each.penalty for each in assignments),
        above_unary_bound=sum(each.above_unary_bound for each in assignments),
        steps=tuple(
            replace(step, name=f"{name}: {step.name}")
            for name, each in zip(names, assignments, strict=True)
            for step in each.steps
        ),
    )


def issues_of(laid: Sequence[ProblemInputs]) -> tuple[Issue, ...]:
    """Findings about a rig and its controls, each once."""
    return tuple(dict.fromkeys(found for inputs in laid for found in inputs.issues))
