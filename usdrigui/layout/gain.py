"""What the elements that left their earlier places gain by it, apart from the price of leaving."""

from __future__ import annotations

import numpy as np

from usdrigui.layout.elements import names_of_copies
from usdrigui.layout.problem import Choice, inner_context, leaving_costs
from usdrigui.layout.review import cost_given_others
from usdrigui.layout.terms import Context
from usdrigui.model import Floats, Group, Indices, LayoutProblem


def gains_of_leaving(
    context: Context, groups: tuple[Group, ...], problem: LayoutProblem, choices: tuple[Choice, ...], labels: Indices
) -> dict[str, float]:
    """By element: cost at its earlier place less cost where it is, all others standing where they stand now.

    Elements that stay, that had no place on the face, or that can no longer stand there are left out.
    """
    found: dict[str, float] = {}
    for index, choice in enumerate(choices):
        part = groups[choice.group].part
        stay, leave = leaving_costs(inner_context(context) if part else context, choice)
        label, earlier = int(labels[index]), int(np.argmin(stay)) if len(stay) else -1
        if leave <= 0.0 or earlier < 0 or label == earlier or np.ptp(stay) == 0.0:
            continue
        plain: Floats = cost_given_others(problem, labels, index) - stay
        now = problem.variables[index].beside - leave if label < 0 else plain[label]
        if np.isfinite(plain[earlier]):
            gain = float(plain[earlier] - now)
            found |= dict.fromkeys(names_of_copies(context, groups[choice.group], choice), gain)
    return found
