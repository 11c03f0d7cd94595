"""Controls that repeat what others do, and which controls they repeat (beyond the paper).

Rigs keep visemes, emotions, both-sided copies and flattened in-betweens beside the atomic controls
from which they were sculpted.  On the face they would only crowd the atoms.  Which controls are
atoms is decided for all at once (`basis`), at costs for what a rigger would keep:

* a control with the name of an atomic action, and most of all one without which no face can be
  animated, is one;
* a copy for both sides of two that are there, a step of another (``smile_50``) and what a family
  is made of are not if others explain them;
* of controls whose names mean nothing, local ones with a twin are rather atoms than wide ones
  without.

A *spread* remains: a symmetric control without a telling name that moves distant parts of the face
as atoms there do is an emotion, even if it has a shape of its own.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from usdrigui.character import Flags, Floats, Indices
from usdrigui.conventions import Meaning
from usdrigui.layout.classify.basis import Basis, Explanation, best_sum, choose_basis
from usdrigui.layout.classify.families import Family, find_families
from usdrigui.layout.face import Face
from usdrigui.layout.motion.coverage import notable_points
from usdrigui.layout.motion.similarity import (
    DisplacementFields,
    Similarity,
    inner_products,
    sparse_rows,
)
from usdrigui.layout.names import is_step_of, spelling_style
from usdrigui.model import BaseSurface, Category, Motion

_NAMED = 3
"""Parts of a mixture that its explanation names."""
_STEP = 0.75
"""Cosine from which a control repeats the one of which its name calls it a step: a flattened
in-between lies off the straight line."""
_FAMILY_COST = 3.0
_BOTH_SIDES_COST = 2.0
_TWIN_DISCOUNT = 0.2
"""Costs of being an atom, in units of the cost of a control whose name means nothing."""
_STYLE_COST = 1e-4
"""Where a rig has the same controls under names of two conventions, those of one stay: less than
any other difference of costs."""
_LOCAL_COSINE = 0.6
_LOCAL_AMOUNT = 0.25
"""A control contains another when, where that one acts, it goes the same way by this share of
it."""
_APART = 0.3
"""Vertical distance of two atoms, in face sizes, from which they are distant parts of the face."""
_FAR_PAIRS = 2
"""Pairs of distant atoms that a spread contains."""


@dataclass(frozen=True)
class Composite:
    """Why a control is off the face, for others that have the same motion."""

    category: Category
    kind: Literal["repetition", "mixture", "spread", "family"]
    parts: tuple[int, ...] = ()
    """Indices of the motions that are to be named, the strongest first."""
    amount: float = 1.0
    """Of a repetition: how far it goes, as a share of the other."""
    family_reason: str = ""
    explained_by: tuple[tuple[int, float], ...] = ()
    """Motions of which it is the sum, and how far each of them goes, the strongest first."""


def explanation(composite: Composite, names: Sequence[str]) -> str:
    """Why a control is a composite, in words; `names` are those of the motions."""
    parts = [names[part] for part in composite.parts]
    if composite.kind == "family":
        return composite.family_reason
    if composite.kind == "repetition":
        return f"does the same as {parts[0]}, {composite.amount:.0%} as far"
    if composite.kind == "mixture":
        return f"does what {_listed(parts)} do together"
    return f"moves distant parts of the face at once, as {_listed(parts)} do"


def composites(face: Face, similarity: Similarity, coverage: Floats) -> dict[int, Composite]:
    """The motions that repeat others, or are with their family off the face; both twins of a pair
    or neither.

    `coverage` (motions,) is the share of the face that each moves.
    """
    motions = face.trajectories.motions
    names = [face.control_name(motion.control) for motion in motions]
    meaning = [face.meanings[motion.control] for motion in motions]
    twins = _twins(motions, face.symmetry.twins)
    families = find_families(names, meaning, similarity.cosine, coverage)
    basis = choose_basis(
        similarity.cosine,
        _costs(names, meaning, twins, coverage, families),
        twins,
        _steps(names, similarity.cosine),
    )
    found = {
        i: _composite(i, basis, similarity.norm) for i in np.flatnonzero(~basis.atoms).tolist()
    }
    off_face = [i for family in families if not family.on_face for i in family.members]
    shown = basis.atoms & ~np.isin(np.arange(len(names)), off_face)
    spread = _Spreads(face, similarity)
    for i in np.flatnonzero(basis.atoms & (twins == np.arange(len(names)))).tolist():
        if meaning[i] is None and (pair := spread.distant_pair(i, basis.atoms)):
            found[i] = Composite("composite", "spread", pair)
    for family in families:
        for i in family.members:
            found.pop(i, None)
            if not family.on_face:
                amounts = _amounts(i, best_sum(i, shown, similarity.cosine), similarity.norm)
                found[i] = Composite(
                    family.kind, "family", family_reason=family.reason, explained_by=amounts
                )
    return {i: why for i, why in sorted(found.items()) if twins[i] < 0 or int(twins[i]) in found}


def _costs(
    names: Sequence[str],
    meaning: Sequence[Meaning | None],
    twins: Indices,
    coverage: Floats,
    families: Sequence[Family],
) -> Floats:
    """(m,) cost of being an atom; negative for one that is to be one in any case."""
    sides: dict[str, set[str]] = {}
    for each in meaning:
        if each is not None:
            sides.setdefault(each.action.name, set()).add(each.side)
    in_family = {i for family in families for i in family.members}
    ranks = _ranks_of_styles(names, meaning)
    costs = 1.0 + coverage - _TWIN_DISCOUNT * (twins != np.arange(len(names))) * (twins >= 0)
    for i, each in enumerate(meaning):
        if i in in_family:
            costs[i] += _FAMILY_COST
        elif (
            each is not None
            and not (each.side or each.middle or each.action.is_central or each.action.is_core)
            and {"left", "right"} <= sides[each.action.name]
        ):
            costs[i] += _BOTH_SIDES_COST
        elif each is not None:
            costs[i] = _STYLE_COST * ranks[i] - each.action.importance
    return np.asarray(np.round(costs, 6))


def _ranks_of_styles(names: Sequence[str], meaning: Sequence[Meaning | None]) -> tuple[int, ...]:
    """(m,) of the style in which a name is written: 0 for the one that names most actions."""
    styles = [spelling_style(name) for name in names]
    acts: dict[tuple[str, bool, bool], set[tuple[str, str]]] = {style: set() for style in styles}
    for style, each in zip(styles, meaning, strict=True):
        if each is not None:
            acts[style].add((each.action.name, each.side))
    order = sorted(acts, key=lambda style: -len(acts[style]))
    return tuple(order.index(style) for style in styles)


def _steps(names: Sequence[str], cosine: Floats) -> list[tuple[int, int]]:
    """(step, whole) of the controls whose names call one a step of the other."""
    return [
        (i, j)
        for i, name in enumerate(names)
        for j, other in enumerate(names)
        if i != j and cosine[i, j] > _STEP and is_step_of(name, other)
    ]


def _twins(motions: tuple[Motion, ...], twins: Indices) -> Indices:
    """(m,) the mirror motion of each, itself, or -1."""
    index = {motion.control: i for i, motion in enumerate(motions)}
    found = [index.get(int(twins[motion.control]), -1) for motion in motions]
    return np.array(found, dtype=np.int64)


def _composite(index: int, basis: Basis, norm: Floats) -> Composite:
    """What a motion that is no atom repeats; `norm` (m,) of the motions."""
    explained = basis.explanations[index]
    parts = tuple(explained.parts[:_NAMED].tolist()) if explained is not None else ()
    amounts = _amounts(index, explained, norm)
    if len(parts) == 1:
        return Composite(
            "composite",
            "repetition",
            parts,
            float(norm[index] / norm[parts[0]]),
            explained_by=amounts,
        )
    return Composite("composite", "mixture", parts, explained_by=amounts)


def _amounts(
    index: int, explained: Explanation | None, norm: Floats
) -> tuple[tuple[int, float], ...]:
    """The motions of an explanation of motion `index`, and how far each goes, in shares of its own
    range."""
    if explained is None:
        return ()
    amounts = explained.weights * norm[index] / norm[explained.parts]
    return tuple(zip(explained.parts.tolist(), np.round(amounts, 6).tolist(), strict=True))


class _Spreads:
    """What marks a control that moves distant parts of the face at once."""

    def __init__(self, face: Face, similarity: Similarity) -> None:
        trajectories = face.trajectories
        regions = notable_points(trajectories.motions, len(trajectories.surface.points))
        self.size = regions @ trajectories.surface.areas
        self.cosine = similarity.cosine
        self.contains = _contained(similarity.fields, regions[:, similarity.fields.places])
        self.far = _distant(trajectories.surface, similarity, face.rig.skel_root.up)

    def distant_pair(self, index: int, atoms: Flags) -> tuple[int, ...]:
        """Two distant atoms as which the motion moves the face at once; empty where it does not."""
        rest = [i for i in np.flatnonzero(atoms).tolist() if i != index]
        inside = [i for i in rest if self.contains[index, i] and self.size[i] < self.size[index]]
        pairs = [(a, b) for a in inside for b in inside if a < b and self.far[a, b]]
        if len(pairs) < _FAR_PAIRS:
            return ()
        return max(pairs, key=lambda pair: round(float(self.cosine[index, pair].sum()), 9))


def _contained(fields: DisplacementFields, regions: Flags) -> Flags:
    """(motions, motions) whether the first does notably the same as the second where that one
    acts."""
    acting = fields.vectors * regions[:, :, None]
    along = fields.products(acting).T
    own = np.diagonal(along)
    squared = np.einsum("cmi,cmi->cm", fields.vectors, fields.vectors) * fields.weights.astype(
        np.float32
    )
    inside = inner_products(sparse_rows(squared), sparse_rows(regions.astype(np.float32)))
    local = np.sqrt(np.maximum(inside * own, 0.0))
    return np.asarray((along > _LOCAL_COSINE * local) & (along > _LOCAL_AMOUNT * own))


def _distant(surface: BaseSurface, similarity: Similarity, up: Floats) -> Flags:
    """(motions, motions) whether two controls act on distant parts of the face and share no
    place."""
    fields = similarity.fields
    weight = np.linalg.norm(fields.vectors, axis=2) * fields.weights
    heights = surface.points[fields.places] @ up
    middle = weight @ heights / np.maximum(weight.sum(axis=1), 1e-300)
    apart = np.abs(middle[:, None] - middle[None, :]) > _APART * surface.face_size
    return np.asarray(apart & (similarity.shared < 0.05))


def _listed(names: Sequence[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else names[0]
