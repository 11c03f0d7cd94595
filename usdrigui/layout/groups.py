"""Which controls share one element (paper sections 3.2 and 4.2, multi-parameter grouping)."""

from __future__ import annotations

from usdrigui.layout.terms import Context
from usdrigui.model import Candidates, CandidateSet, Group

_FAMILIES = ("global", "hidden", "composite")


def find_groups(context: Context, candidates: Candidates) -> tuple[Group, ...]:
    """One group per element, in the order of the controls; every control with candidates is in one.

    Of two elements that mirror each other only the one of the character's left stands for both, the
    other's controls are its `mirror`.
    """
    sets = {context.trajectories.motions[each.motion].control: each for each in candidates.sets}
    done: set[int] = set()
    groups = []
    for control in sorted(sets):
        if control in done:
            continue
        twin = int(context.symmetry.twins[control])
        paired = context.settings.symmetry.fold and twin in sets and twin != control
        done |= {control, twin} if paired else {control}
        groups.append(_single(context, sets[control], control, (twin,) if paired else ()))
    return tuple(groups)


def _single(context: Context, candidate_set: CandidateSet, control: int, mirror: tuple[int, ...]) -> Group:
    flags = (candidate_set.globally, candidate_set.hidden, candidate_set.composite)
    family = next((name for name, flag in zip(_FAMILIES, flags, strict=True) if flag), "")
    return Group(
        name=context.rig.controls[control].name,
        kind="slider",
        controls=(control,),
        opposed=(),
        mirror=mirror,
        reason=candidate_set.reason,
        beside=bool(family),
        family=family,
        images=(mirror,) if mirror else (),
    )
