"""Composites: controls that repeat what others do (visemes, emotions, flattened in-betweens).

Rigs keep them beside the atomic controls they were sculpted from.  On the face they would only crowd
the atoms, so they go to the board.  They are recognised by what they share with the others:

* a *repetition* runs parallel to a stronger control everywhere; where the name hints at a step of it
  (``smile_50`` beside ``smile``), roughly parallel is enough, since in-betweens are made to lie off the line;
* a *mixture* is a sum of several smaller controls with non-negative weights;
* a *spread* is symmetric and moves distant parts of the face as distant atoms do (an emotion moves the
  brows as the brow's control does, and the mouth as the mouth's does).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.optimize import nnls
from scipy.sparse import csr_array

from usdrigui.layout.motion.coverage import notable_points
from usdrigui.layout.motion.similarity import DisplacementFields, Similarity
from usdrigui.layout.names import is_step_of
from usdrigui.model import Flags, Floats, Rig, Symmetry, Trajectories
from usdrigui.ties import rounded

_PARALLEL = 0.98
"""Cosine of two motions from which one repeats the other."""
_STEP = 0.75
"""The same where the name calls one a step of the other: a flattened in-between lies off the straight line."""
_EXPLAINED = 0.85
"""Share of a motion's energy that a mixture of others must explain."""
_PARTS = 1.8
"""Effective number of parts from which a mixture is one, and not one control with some noise."""
_NAMED = 0.1
"""Share of the weight of the strongest part from which a part of a mixture is named."""
_LOCAL_COSINE = 0.6
_LOCAL_AMOUNT = 0.25
"""A control contains another when, where that one acts, it goes the same way by this share of it."""
_APART = 0.3
"""Vertical distance of two atoms, in face sizes, from which they are distant parts of the face."""
_FAR_PAIRS = 2
"""Pairs of distant atoms that a spread contains."""


@dataclass(frozen=True)
class Composite:
    """Which others a control repeats."""

    kind: Literal["repetition", "mixture", "spread"]
    parts: tuple[int, ...]
    """Indices of the motions that are to be named, the strongest first."""
    amount: float = 1.0
    """Of a repetition: how far it goes, as a share of the other."""


def explanation(composite: Composite, names: Sequence[str]) -> str:
    """Why a control is a composite, in words; `names` are those of the motions."""
    parts = [names[part] for part in composite.parts]
    if composite.kind == "repetition":
        return f"does the same as {parts[0]}, {composite.amount:.0%} as far"
    if composite.kind == "mixture":
        return f"does what {_listed(parts)} do together"
    return f"moves distant parts of the face at once, as {_listed(parts)} do"


def composites(
    rig: Rig, trajectories: Trajectories, symmetry: Symmetry, similarity: Similarity
) -> dict[int, Composite]:
    """The motions that are composites, by index; both twins of a pair or neither."""
    shares = _Shares(rig, trajectories, similarity)
    found: dict[int, Composite] = {}
    for index in shares.largest_first:
        rest = [i for i in range(len(trajectories.motions)) if i != index and i not in found]
        both_sides = symmetry.twins[trajectories.motions[index].control] == trajectories.motions[index].control
        composite = shares.repetition(index, rest) or shares.mixture(index, rest)
        if composite is None and both_sides:
            composite = shares.spread(index, rest)
        if composite is not None:
            found[index] = composite
    return _with_twins(found, trajectories, symmetry)


def _with_twins(found: dict[int, Composite], trajectories: Trajectories, symmetry: Symmetry) -> dict[int, Composite]:
    """Only those whose twin was found too."""
    index = {motion.control: i for i, motion in enumerate(trajectories.motions)}
    kept = {}
    for i, composite in found.items():
        twin = int(symmetry.twins[trajectories.motions[i].control])
        if twin < 0 or index.get(twin, i) in found:
            kept[i] = composite
    return kept


class _Shares:
    """What every motion shares with every other: inner products over the whole face and over their regions."""

    def __init__(self, rig: Rig, trajectories: Trajectories, similarity: Similarity) -> None:
        self.names = [rig.controls[motion.control].name for motion in trajectories.motions]
        self.norm, self.cosine = similarity.norm, similarity.cosine
        regions = notable_points(trajectories.motions, len(trajectories.base))
        self.size = regions @ trajectories.areas
        rough = np.round(self.size / max(float(self.size.max(initial=0.0)), 1e-300), 6)
        self.largest_first = sorted(range(len(rough)), key=lambda i: (-rough[i], self.names[i]))
        self.contains = _contained(similarity.fields, regions[:, similarity.fields.places])
        self.far = _distant(trajectories, similarity, rig.up)

    def repetition(self, index: int, rest: list[int]) -> Composite | None:
        for other in rest:
            least = _STEP if is_step_of(self.names[index], self.names[other]) else _PARALLEL
            if self.cosine[index, other] > least and self._stronger(other, index):
                return Composite("repetition", (other,), float(self.norm[index] / self.norm[other]))
        return None

    def mixture(self, index: int, rest: list[int]) -> Composite | None:
        parts = self._parts(index, rest)
        if not parts:
            return None
        table, target = self.cosine[np.ix_(parts, parts)], self.cosine[parts, index]
        # The least-squares problem of the fields themselves, by way of their products.
        root = np.linalg.cholesky(table + 1e-4 * np.eye(len(parts)))
        try:
            weights, _ = nnls(root.T, np.linalg.solve(root, target))
        except RuntimeError:  # Too many steps: it mixes no few others.
            return None
        explained = float(2.0 * weights @ target - weights @ table @ weights)
        effective = float(np.square(weights).sum() ** 2 / max(float((weights**4).sum()), 1e-300))
        if explained < _EXPLAINED or effective < _PARTS:
            return None
        named = weights > _NAMED * weights.max()
        strongest = [parts[i] for i in np.argsort(-rounded(weights), kind="stable")[:3] if named[i]]
        return Composite("mixture", tuple(strongest))

    def _parts(self, index: int, rest: list[int]) -> list[int]:
        """What a control may be a mixture of: smaller controls that do some of the same, none of them the control once
        more, and none that repeats an earlier one.  Copies would share a weight and count as many parts."""
        others = np.array(rest, dtype=np.int64)
        alike = self.cosine[index, others]
        some = others[(self.size[others] <= self.size[index]) & (alike > 0.05) & (alike <= _PARALLEL)]
        repeats = np.tril(self.cosine[np.ix_(some, some)] > _PARALLEL, -1).any(axis=1)
        return [int(i) for i in some[~repeats]]

    def spread(self, index: int, rest: list[int]) -> Composite | None:
        inside = [i for i in rest if self.contains[index, i] and self.size[i] < self.size[index]]
        pairs = [(a, b) for a in inside for b in inside if a < b and self.far[a, b]]
        if len(pairs) < _FAR_PAIRS:
            return None
        return Composite("spread", max(pairs, key=lambda pair: round(float(self.cosine[index, pair].sum()), 9)))

    def _stronger(self, a: int, b: int) -> bool:
        if abs(self.norm[a] - self.norm[b]) <= 1e-6 * self.norm[a]:
            return self.names[a] < self.names[b]
        return bool(self.norm[a] > self.norm[b])


def _contained(fields: DisplacementFields, regions: Flags) -> Flags:
    """(motions, motions) whether the first does notably the same as the second where that one acts."""
    acting = fields.vectors * regions[:, :, None]
    along = fields.products(acting).T
    own = np.diagonal(along)
    squared = np.einsum("cmi,cmi->cm", fields.vectors, fields.vectors) * fields.weights.astype(np.float32)
    inside = np.asarray((csr_array(squared) @ csr_array(regions.astype(np.float32)).T).toarray(), dtype=np.float64)
    local = np.sqrt(np.maximum(inside * own, 0.0))
    return np.asarray((along > _LOCAL_COSINE * local) & (along > _LOCAL_AMOUNT * own) & (own > 0.0))


def _distant(trajectories: Trajectories, similarity: Similarity, up: Floats) -> Flags:
    """(motions, motions) whether two controls act on distant parts of the face and share no place."""
    fields = similarity.fields
    weight = np.linalg.norm(fields.vectors, axis=2) * fields.weights
    heights = trajectories.base[fields.places] @ up
    middle = weight @ heights / np.maximum(weight.sum(axis=1), 1e-300)
    apart = np.abs(middle[:, None] - middle[None, :]) > _APART * trajectories.face_size
    return np.asarray(apart & (similarity.shared < 0.05))


def _listed(names: list[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else names[0]
