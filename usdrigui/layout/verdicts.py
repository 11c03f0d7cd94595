"""Which controls do not belong on the face, and why (paper sections 3.3 and 4.2)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from usdrigui.layout.composites import composites
from usdrigui.layout.precedent import stood_on_face
from usdrigui.layout.reach import covering, shares_of_face
from usdrigui.layout.vanishing import vanishing
from usdrigui.model import Motion

if TYPE_CHECKING:
    from usdrigui.layout.terms import Context

_UNMOVED_SHARE = 0.1
"""Paper section 4.2: a control is global when fewer points than this share move less than its mean."""


@dataclass(frozen=True)
class Verdict:
    """Whether a control belongs beside the face, under which heading, and why."""

    family: str = ""
    """Empty for a control that is to stand on the face."""
    reason: str = ""
    share: float = 0.0
    """Of the visible face that it moves notably."""


def verdicts(context: Context) -> tuple[Verdict, ...]:
    """One per motion.

    Whether one is global does not depend on which others the configuration excludes: those still count for
    what the face is.
    """
    trajectories = context.trajectories
    seen = np.where(context.views.anywhere, context.areas, 0.0)
    every = (*trajectories.motions, *trajectories.excluded)
    covered, shares = covering(every, seen), shares_of_face(every, seen)
    gone, repeated = vanishing(context), composites(context)
    found = []
    for index, motion in enumerate(trajectories.motions):
        family, reason = _verdict(context, motion, float(covered[index]), bool(gone[index]), repeated.get(index, ""))
        found.append(Verdict(family, reason, float(shares[index])))
    return tuple(found)


def _verdict(context: Context, motion: Motion, covered: float, gone: bool, repeats: str) -> tuple[str, str]:
    """Heading and reason, both empty for a control that is to stand on the face."""
    settings, said = context.settings.candidates, context.said[motion.control]
    if said.place in ("face", "proxy") or said.anchor:
        return "", ""
    if settings.beside_global:
        if gone:
            return "global", "makes parts of the character disappear"
        if covered > settings.global_coverage or _moves_everything(context, motion):
            return "global", "moves the face as a whole"
    if settings.beside_hidden and _visible_share(context, motion) < settings.hidden_share:
        return "hidden", "moves only what no view shows"
    # Who stands on the face already is not sent away because somebody else came.
    if settings.beside_composite and repeats and not stood_on_face(context.precedent, (motion.control,)):
        return "composite", repeats
    if said.place == "beside":
        return "requested", "placed beside the face by the configuration"
    return "", ""


def _visible_share(context: Context, motion: Motion) -> float:
    """Share of what the control moves, area times distance, that some view sees."""
    weight = context.areas[motion.points] * motion.arc_length
    total = float(weight.sum())
    seen = context.views.anywhere[motion.points]
    return float(weight[seen].sum()) / total if total > 0.0 else float(seen.mean())


def _moves_everything(context: Context, motion: Motion) -> bool:
    """The paper's own criterion for a global control."""
    count = len(context.trajectories.base)
    still = motion.arc_length < 0.999 * motion.arc_length.mean()
    return bool(count - len(motion.points) + still.sum() < _UNMOVED_SHARE * count)
