"""How alike the motions of controls are: in where they act, and in which way they go there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from usdrigui.layout.fields import Fields
from usdrigui.model import Floats, Record


@dataclass(frozen=True, eq=False)
class Affinity(Record):
    """Comparisons of all motions with each other; symmetric matrices (motions, motions)."""

    norm: Floats
    """(motions,) root of the weighted squared displacement: how much a control moves."""
    cosine: Floats
    """Cosine of the motions as vectors over the whole surface: 1 parallel, -1 opposite."""
    shared: Floats
    """Cosine of the displacement lengths, in [0, 1]: 1 where both act on the same region alike."""

    @property
    def direction(self) -> Floats:
        """Displacement-weighted cosine of the directions where both act; 0 where they share nothing."""
        ratio = np.divide(self.cosine, self.shared, out=np.zeros_like(self.cosine), where=self.shared > 1e-6)
        return np.asarray(ratio, dtype=np.float64)


def affinity(fields: Fields) -> Affinity:
    """`Affinity` of the motions in `fields`."""
    product = fields.products()
    norm = np.sqrt(np.maximum(np.diagonal(product), 1e-300))
    lengths = np.linalg.norm(fields.vectors, axis=2)
    weighted = csr_array(lengths * fields.weights.astype(np.float32))
    both = np.asarray((csr_array(lengths) @ weighted.T).toarray(), dtype=np.float64)
    scale = np.outer(norm, norm)
    return Affinity(norm, product / scale, both / scale)
