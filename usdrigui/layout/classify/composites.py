"""Controls that repeat what others do, and which controls they repeat (beyond the paper).

Rigs keep visemes, emotions, both-sided copies and flattened in-betweens beside the atomic controls
from which they were sculpted.  On the face they would only crowd the atoms.  Which controls are
atoms is decided for all at once (`basis`), at costs for what a rigger would keep:

* a control with the name of an atomic action, and most of all one without which no face can be
  animated, is one;
* a copy for both sides of two that are there and what a family is made of are not if others
  explain them;
* of controls whose names mean nothing, those of one side are atoms unless they repeat one, and
  local ones rather than wide ones: what people sculpt from others is of both sides.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from usdrigui.character import Floats, Indices
from usdrigui.conventions import Meaning
from usdrigui.errors import listed
from usdrigui.layout.classify.basis import Explanation, best_sum, choose_basis
from usdrigui.layout.classify.families import Family, find_families
from usdrigui.layout.face import Face
from usdrigui.layout.motion.similarity import Similarity
from usdrigui.model import Classification


def composites(face: Face, similarity: Similarity, coverage: Floats) -> dict[int, Classification]:
    """The motions that repeat others, or are with their family off the face; both twins of a pair
    or neither.

    `coverage` (motions,) is the share of the face that each moves.
    """
    names = face.names
    meaning = [face.meanings[motion.control] for motion in face.trajectories.motions]
    twins = face.twins
    lost = [left.control for left in face.rig.left_off]
    families = find_families(names, meaning, similarity.cosine, lost)
    basis = choose_basis(similarity.cosine, _costs(meaning, coverage, families, twins), twins)
    found = {}
    for i, explained in basis.explanations.items():
        amounts = _amounts(i, explained, similarity.norm)
        words = f"does what {listed([names[part] for part, _ in amounts])} do together"
        if len(amounts) == 1:
            words = f"does the same as {names[amounts[0][0]]}, {amounts[0][1]:.0%} as far"
        found[i] = Classification("composite", words, explained_by=amounts)
    off_face = [i for family in families if family.reason for i in family.members]
    shown = basis.atoms & ~np.isin(np.arange(len(names)), off_face)
    for family in families:
        for i in family.members:
            found.pop(i, None)
            if family.reason:
                amounts = _amounts(i, best_sum(i, shown, similarity.cosine), similarity.norm)
                found[i] = Classification(family.kind, family.reason, explained_by=amounts)
    return {i: why for i, why in sorted(found.items()) if twins[i] < 0 or int(twins[i]) in found}


def _costs(
    meanings: Sequence[Meaning | None], coverage: Floats, families: Sequence[Family], twins: Indices
) -> Floats:
    """(m,) what it costs that each is an atom, of which only the order counts: members of a family
    first, then copies for both sides, then what has no name, the widest first; 0 for one of one
    side without a name, and negative for an action, which are to be one in any case."""
    sides: dict[str, set[str]] = {}
    for meaning in meanings:
        if meaning is not None:
            sides.setdefault(meaning.action.name, set()).add(meaning.side)
    in_family = {i for family in families for i in family.members}
    costs = 1.0 + coverage
    for i, meaning in enumerate(meanings):
        if i in in_family:
            costs[i] += 2.0
        elif meaning is None:
            if twins[i] not in (-1, i):
                costs[i] = 0.0
        else:
            action = meaning.action
            of_one_place = meaning.side or meaning.middle or action.is_central
            if not of_one_place and {"left", "right"} <= sides[action.name]:
                costs[i] += 1.0
            else:
                costs[i] = -action.importance
    return np.round(costs, 6)


def _amounts(index: int, explained: Explanation, norm: Floats) -> tuple[tuple[int, float], ...]:
    """The motions of an explanation of motion `index`, and how far each goes, in shares of its own
    range."""
    amounts = explained.weights * norm[index] / norm[explained.parts]
    return tuple(zip(explained.parts.tolist(), np.round(amounts, 6).tolist(), strict=True))
