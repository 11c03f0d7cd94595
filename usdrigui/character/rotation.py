"""Rotations of 3-space for row vectors (``p @ R``): vectors, matrices and quaternions.

numpy only, and nothing of the package: this very file is part of the Blender extension.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]


def rotations(vectors: ArrayLike) -> Floats:
    """Rotation matrices (..., 3, 3) for row vectors (``p @ R``) of rotation vectors (..., 3) in
    radians."""
    v = np.asarray(vectors, dtype=np.float64)
    angle = np.linalg.norm(v, axis=-1)[..., None, None]
    x, y, z = np.moveaxis(v, -1, 0)
    zero = np.zeros_like(x)
    cross = np.stack([zero, z, -y, -z, zero, x, y, -x, zero], axis=-1).reshape(*v.shape[:-1], 3, 3)
    first, second = np.sinc(angle / np.pi), 0.5 * np.sinc(angle / (2.0 * np.pi)) ** 2
    return np.asarray(np.eye(3) + first * cross + second * (cross @ cross))


def rotation_vectors(frames: ArrayLike) -> Floats:
    """Rotation vectors (..., 3) in radians, at most pi long, of rotation matrices (..., 3, 3) for
    row vectors."""
    matrices = np.asarray(frames, dtype=np.float64)
    q = quaternions(matrices.reshape(-1, 3, 3))
    q[q[:, 0] < 0.0] *= -1.0
    sine = np.linalg.norm(q[:, 1:], axis=1, keepdims=True)
    angle = 2.0 * np.arctan2(sine, q[:, :1])
    length = np.where(sine > 0.0, sine, 1.0)
    return np.asarray(np.where(sine > 0.0, angle / length, 2.0) * q[:, 1:]).reshape(
        *matrices.shape[:-2], 3
    )


def rotation_part(local: Floats) -> Floats:
    """Rotation part (..., 3, 3) of local transforms (..., 4, 4), for row vectors.

    For a transform made of scales, rotation and translation it is that rotation; in general the
    orthogonal factor R of the polar decomposition ``M = S R``, made of positive determinant.
    """
    matrices = local[..., :3, :3]
    length = np.linalg.norm(matrices, axis=-1, keepdims=True)
    rows = matrices / np.where(length > 0.0, length, 1.0)
    gram = rows @ np.swapaxes(rows, -1, -2)
    skewed = (np.abs(gram - np.eye(3)) > 1e-4).any(axis=(-1, -2))
    # Two steps of the Newton-Schulz iteration take rows that are orthogonal to 1e-4 to machine
    # precision.
    for _ in range(2):
        rows = 0.5 * (3.0 * rows - rows @ np.swapaxes(rows, -1, -2) @ rows)
    if skewed.any():
        u, _, vt = np.linalg.svd(matrices[skewed])
        rows[skewed] = u @ vt
    volume = (rows[..., 0, :] * np.cross(rows[..., 1, :], rows[..., 2, :])).sum(axis=-1)
    return rows * np.where(volume < 0.0, -1.0, 1.0)[..., None, None]


def quaternions(frames: Floats) -> Floats:
    """Unit quaternions (j, 4), real part first, of rotation matrices (j, 3, 3) for row vectors."""
    m = np.swapaxes(frames, -1, -2)
    trace = np.trace(m, axis1=1, axis2=2)
    diagonal = np.stack([trace, m[:, 0, 0], m[:, 1, 1], m[:, 2, 2]], axis=1)
    # The matrix q q^T, of which the row with the largest diagonal entry gives the stablest
    # quaternion.
    outer = np.empty((len(m), 4, 4))
    outer[:, 0, 0] = 1.0 + trace
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        outer[:, i + 1, i + 1] = 1.0 + 2.0 * m[:, i, i] - trace
        outer[:, 0, i + 1] = outer[:, i + 1, 0] = m[:, k, j] - m[:, j, k]
        outer[:, j + 1, k + 1] = outer[:, k + 1, j + 1] = m[:, j, k] + m[:, k, j]
    best = outer[np.arange(len(m)), diagonal.argmax(axis=1)]
    return np.asarray(best / np.linalg.norm(best, axis=1, keepdims=True))


def quaternion_product(a: Floats, b: Floats) -> Floats:
    """Hamilton product of quaternions (..., 4)."""
    scalar = a[..., :1] * b[..., :1] - (a[..., 1:] * b[..., 1:]).sum(axis=-1, keepdims=True)
    vector = a[..., :1] * b[..., 1:] + b[..., :1] * a[..., 1:] + np.cross(a[..., 1:], b[..., 1:])
    return np.concatenate([scalar, vector], axis=-1)
