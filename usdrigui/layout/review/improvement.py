"""By how much elements that left their earlier places improve the cost, apart from the penalty of
leaving."""

from __future__ import annotations

import numpy as np

from usdrigui.layout.element.elements import names_of_copies
from usdrigui.layout.face import Face
from usdrigui.layout.place.problem import PlacementProblem, penalties_of_leaving
from usdrigui.layout.reuse.requests import Requests
from usdrigui.layout.review.review import cost_given_others
from usdrigui.model import Floats, Indices


def improvements(
    face: Face, requests: Requests, placement: PlacementProblem, labels: Indices
) -> dict[str, float]:
    """By element: cost at its earlier place less cost where it is, all others standing where they
    stand now.

    Elements that stay, that had no place on the face, or that can no longer stand there are left
    out.
    """
    found: dict[str, float] = {}
    problem = placement.problem
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
